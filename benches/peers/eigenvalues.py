#!/usr/bin/env python3
"""Times the eigenvalues of 3,600 state matrices, Eq. (16), by NumPy, and compares them with sextic's.

    python3 -m venv peers && peers/bin/pip install numpy
    peers/bin/python benches/peers/eigenvalues.py

The matrices have the size and the structure of those of `cargo bench --bench stability` and `--bench modes`,
which run in turns with NumPy; LAPACK takes them one by one from one array, in one thread.
"""

import os
import re
import statistics
import subprocess
import time
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np  # noqa: E402

MATRICES = 3600
RUNS = 40
LINES = {
    "stability": {
        "bare eigenvalues of the state matrix": "sextic, by nalgebra's Schur decomposition",
        "state matrix with bounds": "sextic, with certain bounds of their errors",
    },
    "modes": {
        "exact modes, avx2, fused": "sextic, exact modes in batches, AVX2",
        "exact modes, avx512, fused": "sextic, exact modes in batches, AVX-512",
    },
}


def state_matrices():
    """M, C and K as for lightly damped sections with close frequencies."""
    draw = np.random.default_rng(1)
    matrices = np.zeros((MATRICES, 6, 6))
    for matrix in matrices:
        e, phi = draw.uniform(0, 0.5), draw.uniform(0, 2 * np.pi)
        mass = np.eye(3)
        mass[2, :2] = mass[:2, 2] = e * np.sin(phi), e * np.cos(phi)
        stiffness = np.diag(draw.uniform(0.8, 1.2, 3) ** 2)
        damping = 0.01 * draw.normal(size=(3, 3)) + 0.01 * np.eye(3)
        matrix[:3, 3:] = np.eye(3)
        matrix[3:, :3] = -np.linalg.solve(mass, stiffness)
        matrix[3:, 3:] = -np.linalg.solve(mass, damping)
    return matrices


def numpy_times(matrices):
    times = []
    for _ in range(RUNS):
        start = time.perf_counter()
        np.linalg.eigvals(matrices)
        times.append((time.perf_counter() - start) / MATRICES * 1e9)
    return times


def sextic_times(bench):
    """Best and median nanoseconds a matrix that a benchmark prints, by its lines, of the first case."""
    root = Path(__file__).resolve().parents[2]
    command = ["cargo", "bench", "--bench", bench]
    text = subprocess.run(command, cwd=root, check=True, stdout=subprocess.PIPE, text=True).stdout
    found = {}
    for line in text.splitlines():
        match = re.match(r"\s+(.*?)\s+([\d.]+) ns\s+([\d.]+) ns", line)
        if match and match[1] in LINES[bench]:
            found.setdefault(match[1], (float(match[2]), float(match[3])))
    return found


def main():
    matrices = state_matrices()
    times = numpy_times(matrices)
    found = {}
    for bench, lines in LINES.items():
        sextic = sextic_times(bench)
        found.update({name: sextic[line] for line, name in lines.items() if line in sextic})
        times += numpy_times(matrices)
    best, median = min(times), statistics.median(times)
    print(f"{'nanoseconds a matrix':<52}{'best':>10}{'median':>10}{'ratio of best':>16}{'of medians':>12}")
    print(f"{'NumPy ' + np.__version__ + ', numpy.linalg.eigvals':<52}{best:>10.0f}{median:>10.0f}")
    for name, (own_best, own_median) in found.items():
        print(f"{name:<52}{own_best:>10.0f}{own_median:>10.0f}{best / own_best:>15.1f}x{median / own_median:>11.1f}x")


if __name__ == "__main__":
    main()
