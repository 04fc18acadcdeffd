"""Systems in numbers, against NumPy and the command."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import sextic

OSCILLATORS = """# Two oscillators
```sextic
parameter m : kg > 0
parameter c : N*s/m
parameter k, b : N/m > 0
coordinate x, y : m
M := [m, 0; 0, 2*m]
C := [c, 0; 0, c]
K := [k + b, -b; -b, k + b]
system (1) oscillators: mass M damping C stiffness K in x, y
domain m = [1, 2], c = [-1, 1], k = [1, 2], b = [1, 2]
```
"""


def test_eigenvalues_are_those_of_numpy():
    system = sextic.System(OSCILLATORS)
    assert (system.name, system.coordinates) == ("oscillators", ("x", "y"))
    found = system.modes(m=1, c=0.25, k=3, b=2)
    mass, damping = np.diag([1.0, 2.0]), np.diag([0.25, 0.25])
    stiffness = np.array([[5.0, -2.0], [-2.0, 5.0]])
    inverse = np.linalg.inv(mass)
    state = np.block([[np.zeros((2, 2)), np.eye(2)], [-inverse @ stiffness, -inverse @ damping]])
    expected = [own for own in np.linalg.eigvals(state) if own.imag > 0]
    order = lambda own: own.imag  # noqa: E731
    np.testing.assert_allclose(sorted(found.eigenvalues, key=order), sorted(expected, key=order), rtol=1e-12)
    assert found.verdict == "stable" and found.diverges is False
    assert (found.errors < 1e-12).all() and found.shapes.shape == (2, 2)
    for value, shape in zip(found.eigenvalues, found.shapes):
        residual = (value**2 * mass + value * damping + stiffness) @ shape
        np.testing.assert_allclose(residual, 0, atol=1e-10)


def test_verdicts_are_of_the_numbers_as_written():
    system = sextic.System(OSCILLATORS)
    for damping, verdict in [("-1e-30", "unstable"), (Decimal("1e-30"), "stable"), (0, "undecided")]:
        assert system.modes(m=Fraction(1, 3), c=damping, k="0.1", b=np.float64(2.0)).verdict == verdict


def test_the_command_says_the_same(command, tmp_path):
    path = tmp_path / "oscillators.md"
    path.write_text(OSCILLATORS, encoding="utf-8")
    settings = [word for own in ["m=1", "c=1/4", "k=3", "b=2"] for word in ("--set", own)]
    expected = command("modes", str(path), *settings, "--format", "json")
    found = sextic.System(str(path)).modes(m=1, c="1/4", k=3, b=2)
    assert [(own.real, own.imag) for own in found.eigenvalues] == [
        (own["re"], own["im"]) for own in expected["eigenvalues"]
    ]
    assert (found.verdict, found.reason) == (expected["verdict"], expected["reason"])


@pytest.mark.parametrize(
    "given, words",
    [
        (dict(m=1, c=0, k=1), "b has no value"),
        (dict(m=1, c=0, k=1, b=1, K=2), "did you mean `k`"),
        (dict(m=-1, c=0, k=1, b=1), "does not allow this value of m"),
        (dict(m=1, c=float("nan"), k=1, b=1), "`c` is nan"),
        (dict(m=1, c=[1, 2], k=1, b=1), "`c` is no number"),
        (dict(m=1, c=True, k=1, b=1), "`c` is no number"),
        (dict(m=1, c="1e9999", k=1, b=1), "no decimal number"),
    ],
)
def test_what_cannot_be_used_is_told(given, words):
    with pytest.raises(sextic.InputError, match=words):
        sextic.System(OSCILLATORS).modes(**given)


def test_unknown_systems_are_told():
    with pytest.raises(sextic.InputError, match="did you mean `oscillators`"):
        sextic.System(OSCILLATORS, "oscilators")
    with pytest.raises(sextic.InputError, match="has no system"):
        sextic.System("".join(line for line in OSCILLATORS.splitlines(True) if "system (1)" not in line))
