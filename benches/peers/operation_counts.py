#!/usr/bin/env python3
"""Counts the operations of the evaluators, and of what SymPy's cse makes of the same expressions.

    python3 -m venv peers && peers/bin/pip install sympy
    peers/bin/python benches/peers/operation_counts.py

Every expression is given to cse as the paper writes it and expanded, with and without
optimizations="basic". What comes out is counted as a compiler would have to do it without
-ffast-math: sums, products and quotients of two values, with powers by repeated squaring; changes of sign
are free here. Those of sextic are read from the checked-in files, where a change of sign counts as a sum.
"""

import re
from pathlib import Path

import sympy
from sympy import Add, Integer, Mul, Poly, Pow, Rational, cos, diag, expand, sin, symbols

ROOT = Path(__file__).resolve().parents[2]
EVALUATORS = ROOT / "codegen" / "evaluators" / "src"

m, r, Lg, rho, D, U, La, ox, oy, ot, zx, zy, zt = symbols("m r L_g rho D U L_a omega_x omega_y omega_t z_x z_y z_t")
CD, CL, CM, dCD, dCL, dCM, lam = symbols("C_D C_L C_M dC_D dC_L dC_M lambda")
# Cosines and sines of α_0, α_g + θ_0 and γ_r + θ_0 are inputs.
c0, s0, cg, sg, cr, sr = symbols("c_0 s_0 c_g s_g c_r s_r")


def characteristic_polynomial():
    """det(λ²M + λC + K)/det(M) by the power of λ: the determinant by the rule of Sarrus, not expanded."""
    mass = m * sympy.Matrix([[1, 0, Lg * sg], [0, 1, Lg * cg], [Lg * sg, Lg * cg, r**2]])
    stiffness = diag(m * ox**2, m * oy**2, m * r**2 * ot**2)
    structural = diag(2 * m * ox * zx, 2 * m * oy * zy, 2 * m * r**2 * ot * zt)
    coefficients = sympy.Matrix([[2 * CD, 2 * CL, dCL + CD, CL - dCD, 0, 0], [2 * CL, -2 * CD, CL - dCD, -dCL - CD, 0, 0],
                                 [0, 0, 0, 0, 2 * D * CM, D * dCM]])
    # Cosine and sine of the angle between the wind and the arm of the aerodynamic centre.
    cp, sp = c0 * cr - s0 * sr, c0 * sr + s0 * cr
    turns = sympy.Matrix([[c0**2, c0 * s0, La * sp * c0], [-c0 * s0, -(s0**2), -La * sp * s0],
                          [s0**2, -c0 * s0, -La * cp * s0], [c0 * s0, -(c0**2), -La * cp * c0],
                          [c0, s0, La * sp], [-s0, c0, La * cp]])
    damping = structural + rho * D * U / 2 * coefficients * turns
    return by_powers_of(lam, mass, damping, stiffness)


def by_powers_of(variable, mass, damping, stiffness):
    """The coefficients of the determinant, each a sum of products of entries, over det(M)."""
    names = {}

    def entry(letter, i, j, value):
        if value == 0:
            return Integer(0)
        symbol = sympy.Symbol(f"{letter}{i}{j}")
        names[symbol] = value
        return symbol

    pencil = sympy.Matrix(3, 3, lambda i, j: variable**2 * entry("M", i, j, mass[i, j])
                          + variable * entry("C", i, j, damping[i, j]) + entry("K", i, j, stiffness[i, j]))
    determinant = Poly(expand(pencil.det(method="berkowitz")), variable)
    below = determinant.coeff_monomial(variable**6).xreplace(names)
    return [determinant.coeff_monomial(variable**power).xreplace(names) / below for power in range(7)]


def closed_form():
    """Eqs. (21)-(23)."""
    Sxx, Sxy, Sxt, Syx, Syy, Syt, Stx, Sty, Stt = symbols("S_xx S_xy S_xt S_yx S_yy S_yt S_tx S_ty S_tt")
    d1 = -(Sxx * sg**2 + Syy * cg**2 + (Sxy + Syx) * sg * cg + Stt)
    d2 = (Sty + Syt) * cg + (Sxt + Stx) * sg
    return [rho * D * U / (8 * m) * (r / (r - Lg)) * (d1 + d2),
            -rho * D * U / (4 * m) * (Sxx + Syy + Stt + d1),
            rho * D * U / (8 * m) * (r / (r + Lg)) * (d1 - d2)]


def hurwitz_determinants():
    """The six leading minors of the Hurwitz matrix of a monic polynomial of order 6."""
    c = [*symbols("c_0:6"), Integer(1)]
    entry = lambda i, j: c[6 - (2 * (j + 1) - (i + 1))] if 0 <= 6 - (2 * (j + 1) - (i + 1)) <= 6 else Integer(0)
    matrix = sympy.Matrix(6, 6, entry)
    return [matrix[:size, :size].det(method="berkowitz") for size in range(1, 7)]


def powers(exponent):
    """How many products xⁿ takes by repeated squaring."""
    return exponent.bit_length() - 1 + bin(exponent).count("1") - 1


def count(expression):
    """Sums, products and quotients of an expression."""
    total = {"+": 0, "×": 0, "÷": 0, "√": 0}
    for part in sympy.preorder_traversal(expression):
        if isinstance(part, Add):
            total["+"] += len(part.args) - 1
        elif isinstance(part, Mul):
            above = [a for a in part.args if a != -1 and not is_below(a)]
            below = [a for a in part.args if is_below(a)]
            numbers = [a for a in above if isinstance(a, Rational)]
            total["×"] += max(len(above) - 1, 0) + max(len(below) - 1, 0)
            total["÷"] += bool(below)
            # −2 and 1/2 are one constant; 1/(8·m) is 0.125/m.
            assert len(numbers) <= 1
        elif isinstance(part, Pow):
            base, exponent = part.args
            assert exponent.is_Integer, part
            total["×"] += powers(abs(int(exponent)))
    return total


def is_below(factor):
    return isinstance(factor, Pow) and factor.args[1].is_negative


def lone_inverses(expression):
    """Inverses that stand in no product."""
    return 1 if is_below(expression) else sum(is_below(a) for a in expression.args if isinstance(expression, Add))


def after_cse(expressions, **options):
    shared, results = sympy.cse(expressions, **options)
    total = {"+": 0, "×": 0, "÷": 0, "√": 0}
    for expression in [value for _, value in shared] + results:
        for sign, number in count(expression).items():
            total[sign] += number
        total["÷"] += lone_inverses(expression)
    return total


def of_sextic(name):
    text = (EVALUATORS / f"{name}.rs").read_text()
    return re.search(r"(\d+ operations \(.*\))\.", text)[1]


def written(total):
    parts = ", ".join(f"{number} {sign}" for sign, number in total.items() if number)
    return f"{sum(total.values())} operations ({parts})"


def main():
    print(f"SymPy {sympy.__version__}")
    for make in (closed_form, characteristic_polynomial, hurwitz_determinants):
        expressions = make()
        print(f"\n{make.__name__}")
        print(f"  {'sextic':38}{of_sextic(make.__name__)}")
        forms = {"as it stands": expressions, "expanded": [expand(e) for e in expressions]}
        for form, listed in forms.items():
            for options in ({}, {"optimizations": "basic"}):
                name = f"cse, {form}" + (", basic" if options else "")
                print(f"  {name:38}{written(after_cse(listed, **options))}", flush=True)


if __name__ == "__main__":
    main()
