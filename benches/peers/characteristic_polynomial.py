#!/usr/bin/env python3
"""Times |λ²M + λC + K|, expanded, in other computer algebra systems.

    python3 -m venv peers && peers/bin/pip install python-flint symengine sympy
    peers/bin/python benches/peers/characteristic_polynomial.py [--no-sextic]

Runs every system that can be imported, then `cargo bench --bench characteristic_polynomial` for
sextic, and prints medians and their ratios to sextic. All of them expand along the rows and compute
every minor of the last rows once; entries are made beforehand and are not timed.
"""

import argparse
import re
import statistics
import subprocess
import time
from functools import cache
from pathlib import Path

SECTION = "m r Lg rho D U La ox oy ot zx zy zt CD CL CM dCD dCL dCM s0 c0 sf cf sp cp".split()
SIZES = range(2, 7)
SECONDS = 5.0  # spent on one measurement
MOST_RUNS = 100
MOST_EXPECTED = 60.0  # a larger size is left out where the last one suggests more seconds than this


def section(symbol):
    """Twice λ²M + λC + K of the paper's section, with all 25 parameters symbolic."""
    s = {name: symbol(name) for name in SECTION}
    m, r, Lg, rho, D, U, La, ox, oy, ot, zx, zy, zt, CD, CL, CM, dCD, dCL, dCM, s0, c0, sf, cf, sp, cp = (
        s[name] for name in SECTION
    )
    lam, zero = symbol("lam"), 0 * m
    mass = [[2 * m, zero, 2 * m * Lg * sf], [zero, 2 * m, 2 * m * Lg * cf],
            [2 * m * Lg * sf, 2 * m * Lg * cf, 2 * m * r**2]]
    stiffness = [2 * m * ox**2, 2 * m * oy**2, 2 * m * r**2 * ot**2]
    structural = [4 * m * ox * zx, 4 * m * oy * zy, 4 * m * r**2 * ot * zt]
    coefficients = [[2 * CD, 2 * CL, dCL + CD, CL - dCD, zero, zero],
                    [2 * CL, -2 * CD, CL - dCD, -dCL - CD, zero, zero],
                    [zero, zero, zero, zero, 2 * D * CM, D * dCM]]
    turns = [[c0**2, c0 * s0, La * sp * c0], [-c0 * s0, -(s0**2), -La * sp * s0],
             [s0**2, -c0 * s0, -La * cp * s0], [c0 * s0, -(c0**2), -La * cp * c0],
             [c0, s0, La * sp], [-s0, c0, La * cp]]

    def entry(i, j):
        damping = rho * D * U * sum((coefficients[i][k] * turns[k][j] for k in range(6)), zero)
        rigid = zero
        if i == j:
            damping, rigid = damping + structural[i], stiffness[i]
        return lam**2 * mass[i][j] + lam * damping + rigid

    return [[entry(i, j) for j in range(3)] for i in range(3)]


def symbolic(size, symbol):
    """λ²M + λC + K with a symbol in every entry."""
    lam = symbol("lam")
    return [[lam**2 * symbol(f"m{i}{j}") + lam * symbol(f"c{i}{j}") + symbol(f"k{i}{j}") for j in range(size)]
            for i in range(size)]


def determinant(matrix, product):
    size = len(matrix)

    @cache
    def minor(columns):
        row = matrix[size - len(columns)]
        if len(columns) == 1:
            return row[columns[0]]
        total = None
        for place, column in enumerate(columns):
            if row[column] == 0:
                continue
            term = product(row[column], minor(columns[:place] + columns[place + 1 :]))
            total = (term if place % 2 == 0 else -term) if total is None else (
                total + term if place % 2 == 0 else total - term)
        return 0 * row[0] if total is None else total

    return minor(tuple(range(size)))


def names_of(size):
    if size is None:
        return ["lam", *SECTION]
    return ["lam"] + [f"{letter}{i}{j}" for letter in "mck" for i in range(size) for j in range(size)]


def flint(size):
    from flint import Ordering, fmpz_mpoly_ctx

    names = names_of(size)
    symbols = dict(zip(names, fmpz_mpoly_ctx.get(names, Ordering.lex).gens()))
    return symbols.__getitem__, lambda a, b: a * b, len


def symengine(size):
    import symengine

    # A product of sums stays a product until it is expanded; sums of expanded ones are expanded.
    return symengine.Symbol, lambda a, b: symengine.expand(a * b), lambda d: len(d.args)


def sympy_ring(size):
    from sympy import ZZ
    from sympy.polys.rings import ring

    names = names_of(size)
    symbols = dict(zip(names, ring(names, ZZ)[1:]))
    return symbols.__getitem__, lambda a, b: a * b, len


def sympy_expressions(size):
    import sympy

    return sympy.Symbol, lambda a, b: sympy.expand(a * b), lambda d: len(sympy.Add.make_args(d))


SYSTEMS = {
    "FLINT (python-flint)": flint,
    "SymEngine": symengine,
    "SymPy, polynomial ring": sympy_ring,
    "SymPy, expressions": sympy_expressions,
}


def forget(system):
    """Empties the cache in which SymPy keeps what it has expanded before."""
    if system is sympy_expressions:
        import sympy

        sympy.core.cache.clear_cache()


def measure(system, size):
    """The median in seconds, and the number of terms."""
    symbol, product, count = system(size)
    matrix = section(symbol) if size is None else symbolic(size, symbol)
    if system in (symengine, sympy_expressions):
        matrix = [[product(entry, 1) for entry in row] for row in matrix]
    times, result = [], None
    while len(times) < MOST_RUNS and (not times or sum(times) < SECONDS):
        forget(system)
        start = time.perf_counter()
        result = determinant(matrix, product)
        times.append(time.perf_counter() - start)
    return statistics.median(times), count(result)


def sextic():
    """The medians in seconds that divan prints, by benchmark."""
    root = Path(__file__).resolve().parents[2]
    command = ["cargo", "bench", "--bench", "characteristic_polynomial"]
    lines = subprocess.run(command, cwd=root, check=True, stdout=subprocess.PIPE, text=True).stdout.split("\n")
    unit = {"ns": 1e-9, "µs": 1e-6, "ms": 1e-3, "s": 1.0}
    medians, group = {}, ""
    for line in lines:
        found = re.match(r"^([│ ]*)[├╰]─ (\S+)(.*)$", line)
        if not found:
            continue
        numbers = re.findall(r"([\d.]+) (ns|µs|ms|s)\b", found[3])
        if not numbers:
            group = found[2]
            continue
        name = (group, int(found[2])) if found[2].isdigit() else (found[2], None)
        value, scale = numbers[2]  # fastest, slowest, median, mean
        medians[name] = float(value) * unit[scale]
    return {None: medians[("section", None)]} | {size: medians[("symbolic", size)] for size in SIZES}


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--no-sextic", action="store_true", help="leave sextic out, and the ratios")
    reference = {} if arguments.parse_args().no_sextic else sextic()
    print(f"{'':24}{'section':>16}" + "".join(f"{f'{size} dof':>16}" for size in SIZES))
    rows = {"sextic": {key: (value, None) for key, value in reference.items()}} if reference else {}
    terms = {}
    for name, system in SYSTEMS.items():
        rows[name] = {}
        last = 0.0
        for size in [None, *SIZES]:
            if size is not None and last * 40 > MOST_EXPECTED:
                break
            try:
                median, terms[size] = measure(system, size)
            except ImportError:
                break
            rows[name][size] = (median, terms[size])
            last = 0.0 if size is None else median
    for name, cells in rows.items():
        line = f"{name:24}"
        for size in [None, *SIZES]:
            if size not in cells:
                line += f"{'–':>16}"
                continue
            median = cells[size][0]
            ratio = f" ({median / reference[size]:.1f}×)" if reference and name != "sextic" else ""
            line += f"{f'{median * 1e3:.3g} ms{ratio}':>16}"
        print(line)
    print(f"{'terms':24}" + "".join(f"{terms.get(size, '–'):>16}" for size in [None, *SIZES]))


if __name__ == "__main__":
    main()
