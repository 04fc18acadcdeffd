#!/usr/bin/env python3
"""Times the eigenvalues of systems of 4, 6 and 8 coordinates over 10,000 points, by NumPy and by `sextic sweep`.

    python3 -m venv peers && peers/bin/pip install numpy
    cargo build --release
    peers/bin/python benches/peers/systems.py [RUNS]

NumPy makes the state matrices from M, C and K and takes their eigenvalues with LAPACK, in one thread; only that is timed.
`sextic sweep` is timed as a whole process with one thread: it reads and audits a document, and gives eigenvalues with
certain bounds of their errors and a verdict that is proven, as CSV. The largest real parts are compared before
anything is timed.
"""

import csv
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

os.environ["OPENBLAS_NUM_THREADS"] = os.environ["OMP_NUM_THREADS"] = os.environ["RAYON_NUM_THREADS"] = "1"

import numpy as np  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
SIZES = (4, 6, 8)
SPEEDS, STIFFNESSES = np.linspace(0, 3, 100), np.linspace(0.5, 2, 100)


def matrices(size):
    """M, C_0, C_1 and K: lightly damped, with close frequencies, every entry a decimal of four digits."""
    draw = np.random.default_rng(size)
    mass = np.eye(size) + 0.1 * np.ones((size, size))
    damping = 0.02 * np.eye(size)
    wind = 0.01 * draw.normal(size=(size, size))
    stiffness = np.diag(draw.uniform(0.8, 1.2, size)) + 0.02 * np.ones((size, size))
    return [np.round(own, 4) for own in (mass, damping, wind, stiffness)]


def written(matrix):
    return "[" + "; ".join(", ".join(f"{entry:.4f}" for entry in row) for row in matrix) + "]"


def document(own):
    mass, damping, wind, stiffness = (written(matrix) for matrix in own)
    coordinates = ", ".join(f"q_{place}" for place in range(1, len(own[0]) + 1))
    return f"""# A system

```sextic
coordinate {coordinates} : m
parameter m : kg > 0
parameter c, U : kg/s
parameter k : N/m > 0
system (1) any: mass m*{mass} damping c*{damping} + U*{wind} stiffness k*{stiffness} in {coordinates}
claim (1): m == m
```
"""


def by_numpy(own):
    """The largest real part at every point, and the seconds that it took."""
    start = time.perf_counter()
    mass, damping, wind, stiffness = own
    size, points = len(mass), len(SPEEDS) * len(STIFFNESSES)
    speed, stiff = (grid.ravel()[:, None, None] for grid in np.meshgrid(SPEEDS, STIFFNESSES, indexing="ij"))
    state = np.zeros((points, 2 * size, 2 * size))
    state[:, :size, size:] = np.eye(size)
    state[:, size:, :size] = -np.linalg.solve(mass, stiff * stiffness)
    state[:, size:, size:] = -np.linalg.solve(mass, damping + speed * wind)
    largest = np.linalg.eigvals(state).real.max(axis=1)
    return largest, time.perf_counter() - start


def by_sextic(path, out):
    out.unlink(missing_ok=True)
    command = [TARGET / "release/sextic", "sweep", path, "--set", "m=1", "--set", "c=1", "--vary", "U=0:3:100",
               "--vary", "k=0.5:2:100", "--out", out]
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.perf_counter() - start


def compare(largest, out):
    with open(out) as file:
        rows = list(csv.DictReader(file))
    found = np.array([float(row["growth"]) for row in rows])
    assert len(found) == len(largest), (len(found), len(largest))
    assert np.abs(found - largest).max() < 1e-9, np.abs(found - largest).max()


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 9
    print(f"NumPy {np.__version__}, microseconds a point, medians of {runs} turns")
    print(f"{'coordinates':<14}{'NumPy':>10}{'sextic':>10}{'ratio':>10}")
    with tempfile.TemporaryDirectory() as folder:
        path, out = Path(folder) / "system.md", Path(folder) / "rows.csv"
        for size in SIZES:
            own = matrices(size)
            path.write_text(document(own))
            by_sextic(path, out)
            compare(by_numpy(own)[0], out)
            turns = [(by_numpy(own)[1], by_sextic(path, out)) for _ in range(runs)]
            points = len(SPEEDS) * len(STIFFNESSES) / 1e6
            peer, sextic = (statistics.median(turn[side] for turn in turns) / points for side in (0, 1))
            ratio = statistics.median(a / b for a, b in turns)
            print(f"{size:<14}{peer:>10.1f}{sextic:>10.1f}{ratio:>9.1f}x")


if __name__ == "__main__":
    main()
