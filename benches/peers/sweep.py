#!/usr/bin/env python3
"""Times a map of S by Eqs. (21) to (23), 10⁶ rows to Parquet, by NumPy with pyarrow and by `sextic sweep`, in turns.

    python3 -m venv peers && peers/bin/pip install numpy pyarrow
    cargo build --release --features parquet
    peers/bin/python benches/peers/sweep.py [RUNS]

Whole processes: Python imports its packages, sextic reads a case and its table. Both write U, L_g and S; sextic also
the angle, and what speaks against the closed form in each row. The results are compared before anything is timed.
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CASE = ROOT / "derivations/cases/tuned.toml"
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
ROWS = 1_000_000

# The case at 30 degrees, by the formulas of its table.
SCRIPT = """
import sys
import numpy as np, pyarrow as pa, pyarrow.parquet as pq
m, r, D, rho, L_a, alpha_g, gamma_r = 3.5, 0.0178, 0.05, 1.25, 0.03, 0.0, 0.0
alpha_0, theta_0 = 0.0, np.deg2rad(30.0)
a = alpha_0 + theta_0
C_L, dC_L = np.sin(a) - 0.9*np.sin(3*a), np.cos(a) - 2.7*np.cos(3*a)
C_D, dC_D = 1.1 - 0.4*np.cos(2*a), 0.8*np.sin(2*a)
C_M, dC_M = 0.15*np.sin(2*a) - 0.05*np.sin(a), 0.3*np.cos(2*a) - 0.05*np.cos(a)
c, s, x, y = np.cos(alpha_0), np.sin(alpha_0), L_a*np.sin(a + gamma_r), L_a*np.cos(a + gamma_r)
left = np.array([[2*C_D, 2*C_L, dC_L + C_D, C_L - dC_D, 0, 0],
                 [2*C_L, -2*C_D, C_L - dC_D, -(dC_L + C_D), 0, 0],
                 [0, 0, 0, 0, 2*D*C_M, D*dC_M]])
right = np.array([[c*c, c*s, x*c], [-c*s, -s*s, -x*s], [s*s, -c*s, -y*s],
                  [c*s, -c*c, -y*c], [c, s, x], [-s, c, y]])
scale = np.diag([1, 1, 1/r])
S = scale @ left @ right @ scale
U, L_g = (v.ravel() for v in np.meshgrid(np.linspace(2, 40, 1000), np.linspace(0, 0.01, 1000), indexing="ij"))
p, q = np.sin(alpha_g + theta_0), np.cos(alpha_g + theta_0)
d_1 = -(S[0, 0]*p*p + S[1, 1]*q*q + (S[0, 1] + S[1, 0])*p*q + S[2, 2])
d_2 = (S[2, 1] + S[1, 2])*q + (S[0, 2] + S[2, 0])*p
w = rho*D*U/(8*m)
largest = np.maximum(np.maximum(w*(r/(r - L_g))*(d_1 + d_2), -2*w*(S[0, 0] + S[1, 1] + S[2, 2] + d_1)),
                     w*(r/(r + L_g))*(d_1 - d_2))
pq.write_table(pa.table({"U": U, "L_g": L_g, "s3d_closed": -4*m*largest/(rho*D*U)}), sys.argv[1])
"""


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 15
    with tempfile.TemporaryDirectory() as folder:
        files = {name: Path(folder) / f"{name}.parquet" for name in ("numpy", "sextic")}
        sweep = ["sweep", CASE, "--vary", "U=2:40:1000", "--vary", "L_g=0:0.01:1000", "--vary", "alpha_deg=30"]
        commands = {
            "numpy": [sys.executable, "-c", SCRIPT, files["numpy"]],
            "sextic": [TARGET / "release/sextic", *sweep, "--method", "closed", "--out", files["sextic"]],
        }
        times = {name: [] for name in commands}
        for run in range(runs + 1):
            for name, command in commands.items():
                files[name].unlink(missing_ok=True)
                start = time.perf_counter()
                subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
                # The first run of each is compared, and not counted.
                if run > 0:
                    times[name].append(time.perf_counter() - start)
            if run == 0:
                compare(files)
    for name, own in times.items():
        print(f"{name}: best {min(own) * 1e3:.0f} ms, median {statistics.median(own) * 1e3:.0f} ms of {runs}")
    ratios = [a / b for a, b in zip(times["numpy"], times["sextic"])]
    print(f"ratio of turns next to each other: median {statistics.median(ratios):.2f}")


def compare(files):
    """Both have the same rows; the table has six decimals."""
    import numpy as np
    import pyarrow.parquet as pq

    tables = {name: pq.read_table(file) for name, file in files.items()}
    for column, apart in (("U", 1e-9), ("L_g", 1e-9), ("s3d_closed", 1e-3)):
        one, other = (np.asarray(tables[name][column]) for name in ("numpy", "sextic"))
        assert len(one) == len(other) == ROWS, (len(one), len(other))
        assert np.abs(one - other).max() <= apart, (column, np.abs(one - other).max())


if __name__ == "__main__":
    main()
