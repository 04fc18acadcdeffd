"""Writes the tables of this directory. Made with SymPy 1.14.0.

A polynomial in x0, x1, x2 is a list of `coefficient:e0,e1,e2`, by decreasing
exponents, and `0` is zero. Fields are separated by `|`.
"""
import random
from sympy import Matrix, Poly, Rational, ZZ, gcd, symbols

X = symbols("x0 x1 x2")


def arbitrary(rng, terms, degree, size=9):
    data = {}
    for _ in range(terms):
        data[tuple(rng.randint(0, degree) for _ in X)] = rng.randint(-size, size)
    return Poly(data, *X, domain=ZZ)


def nonzero(rng, *size):
    while True:
        poly = arbitrary(rng, *size)
        if not poly.is_zero:
            return poly


def text(poly):
    terms = sorted(((e, c) for e, c in poly.terms() if c), reverse=True)
    if not terms:
        return "0"
    return " ".join(f"{c}:{','.join(map(str, e))}" for e, c in terms)


def positive(poly):
    return -poly if poly.LC() < 0 else poly


def lowest(n, d):
    ratio, p, q = n.cancel(d)
    p, q = p * Rational(ratio).p, q * Rational(ratio).q
    return (-p, -q) if q.LC() < 0 else (p, q)


def table(name, header, rows):
    with open(name, "w") as file:
        file.write(f"# {header}\n# Made by generate.py in this directory, with SymPy 1.14.0.\n")
        for row in rows:
            file.write(" | ".join(map(text, row)) + "\n")


def products(rng):
    for size in [9, 10**6, 10**18, 10**30]:
        for _ in range(8):
            a, b = arbitrary(rng, 7, 4, size), arbitrary(rng, 7, 4, size)
            yield a, b, a * b


def gcds(rng):
    for terms, degree in [(2, 1), (3, 2), (4, 2), (4, 3), (6, 2)]:
        for _ in range(12):
            a, b, c = (nonzero(rng, terms, degree) for _ in range(3))
            yield a * c, b * c, positive(Poly(gcd(a * c, b * c), *X, domain=ZZ))


def fractions(rng):
    for _ in range(40):
        a, b, c = (nonzero(rng, 3, 2) for _ in range(3))
        yield a * c, b * c, *lowest(a * c, b * c)


def sums(rng):
    for _ in range(40):
        a, c = arbitrary(rng, 3, 1), arbitrary(rng, 3, 1)
        b, d, e = (nonzero(rng, 2, 1) for _ in range(3))
        yield a, b * e, c, d * e, *lowest(a * d + c * b, b * d * e)


def square_free(rng):
    """The product of all factors of multiplicity 1, of multiplicity 2, ..."""
    for _ in range(40):
        a, b, c = (nonzero(rng, 3, 1) for _ in range(3))
        product = a * b**2 * c**3
        factors = dict((m, f) for f, m in product.sqf_list()[1])
        parts = []
        for m in range(1, max(factors, default=0) + 1):
            part = factors.get(m, Poly(1, *X, domain=ZZ))
            parts.append(positive(part.primitive()[1]))
        yield product, *parts


def determinants(rng):
    """The nine entries, row by row, some of them 0, and the determinant."""
    for size in [9, 10**9, 10**25]:
        for _ in range(8):
            entries = [arbitrary(rng, rng.randint(0, 3), 3, size) for _ in range(9)]
            expanded = Matrix(3, 3, [entry.as_expr() for entry in entries]).det(method="berkowitz").expand()
            yield *entries, Poly(expanded, *X, domain=ZZ)


rng = random.Random(20240229)
table("products.txt", "left | right | product", products(rng))
table("gcds.txt", "left | right | gcd", gcds(rng))
table("fractions.txt", "numerator | denominator | the same in lowest terms", fractions(rng))
table("sums.txt", "n | d | m | e | n/d + m/e in lowest terms", sums(rng))
table("square_free.txt", "polynomial | product of its simple factors | of its double ones | ...", square_free(rng))
table("determinants.txt", "nine entries, row by row | determinant", determinants(rng))
