"""Uses the emitted package: answers a line for each line of points, asked as scalars and as arrays."""

import dataclasses
import struct
import sys

import numpy as np
from evaluators import (
    DeterminantInputs,
    MatchInputs,
    QuadraticFormInputs,
    RodInputs,
    determinant,
    match_,
    quadratic_form,
    rod,
)

FUNCTIONS = {
    "determinant": (DeterminantInputs, determinant),
    "match": (MatchInputs, match_),
    "quadratic_form": (QuadraticFormInputs, quadratic_form),
    "rod": (RodInputs, rod),
}

np.seterr(all="ignore")
questions = [line.split() for line in sys.stdin]
points = {}
for name, *words in questions:
    values = [struct.unpack(">d", bytes.fromhex(word.zfill(16)))[0] for word in words]
    points.setdefault(name, []).append(values)

if "angles" in points:
    # Lists are as good as arrays.
    lengths, turns, others = map(list, zip(*points.pop("angles")))
    together = RodInputs.at_angles(L=lengths, theta_0=turns, beta=others)
    for place, turn in enumerate(turns):
        alone = RodInputs.at_angles(L=lengths[place], theta_0=turn, beta=others[place])
        words = []
        for field in dataclasses.fields(alone):
            value = getattr(alone, field.name)
            assert abs(value - getattr(together, field.name)[place]) < 4e-16
            words.append(struct.pack(">d", value).hex())
        print(*words)

for name, rows in points.items():
    inputs, function = FUNCTIONS[name]
    together = function(inputs(*np.array(rows).T))
    # Outputs of different inputs have one shape, and can be written to.
    columns = [getattr(together, field.name) for field in dataclasses.fields(together)]
    assert all(column.shape == (len(rows),) and column.flags.writeable for column in columns)
    # Broadcasting: the first input as a column.
    first, *others = np.array(rows[:4]).T
    grid = function(inputs(first[:, None], *others))
    for field in dataclasses.fields(grid):
        found = getattr(grid, field.name)
        assert found.shape == (4, 4)
    for place, row in enumerate(rows):
        alone = function(inputs(*row))
        answers = []
        for field, column in zip(dataclasses.fields(alone), columns):
            value = getattr(alone, field.name)
            assert np.ndim(value) == 0
            one, other = struct.pack(">d", value), struct.pack(">d", column[place])
            assert one == other or (np.isnan(value) and np.isnan(column[place]))
            answers.append(one.hex())
        print(*answers)
