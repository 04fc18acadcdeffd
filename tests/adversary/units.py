"""Units and shapes of expressions, to tell whether the sides of a claim can be compared at all.

A unit is a tuple of exponents of kg, m, s, A and K; the number 0 as it is written, and products with it,
have nothing as their unit, which fits every one. Any other 0 has the unit of its expression."""

from fractions import Fraction

from writing import exact, written
from series import Mistake, Unknown

ONE = (Fraction(0),) * 5
BASE = {"kg": (1, 0, 0, 0, 0), "m": (0, 1, 0, 0, 0), "s": (0, 0, 1, 0, 0), "A": (0, 0, 0, 1, 0),
        "K": (0, 0, 0, 0, 1), "rad": (0, 0, 0, 0, 0), "Hz": (0, 0, -1, 0, 0), "N": (1, 1, -2, 0, 0),
        "Pa": (1, -1, -2, 0, 0), "J": (1, 2, -2, 0, 0), "W": (1, 2, -3, 0, 0), "C": (0, 0, 1, 1, 0),
        "V": (1, 2, -3, -1, 0), "F": (-1, -2, 4, 2, 0), "ohm": (1, 2, -3, -2, 0),
        "H": (1, 2, -2, -2, 0), "T": (1, 0, -2, -1, 0)}
SECOND = tuple(Fraction(x) for x in BASE["s"])


def written_unit(part):
    """The unit that an expression of units means."""
    if part.kind == "number":
        return ONE
    if part.kind == "name":
        return tuple(Fraction(x) for x in BASE[part.parts[0]])
    if part.kind == "power":
        return raised(written_unit(part.parts[0]), exact(part.parts[1]))
    a, b = (written_unit(inner) for inner in part.parts)
    return times(a, b if part.kind == "multiply" else raised(b, -1))


def times(a, b):
    """The unit of a product."""
    return None if a is None or b is None else tuple(x + y for x, y in zip(a, b))


def raised(a, n):
    """The unit of a power."""
    return None if a is None else tuple(x * n for x in a)


def same(a, b):
    """The unit of a sum."""
    if a is None or b is None:
        return b if a is None else a
    if a != b:
        raise Mistake("units do not fit")
    return a


def shape(a):
    """Rows and columns."""
    return len(a), len(a[0])


class Units:
    """The units of the entries of expressions, row by row."""

    def __init__(self, evaluator):
        self.evaluator, self.document, self.known = evaluator, evaluator.document, {}

    def of(self, part):
        """The units of an expression."""
        if part not in self.known:
            self.known[part] = self.find(part)
        return self.known[part]

    def one(self, part):
        """The unit of a number."""
        found = self.of(part)
        if shape(found) != (1, 1):
            raise Mistake("a number is wanted")
        return found[0][0]

    def find(self, part):
        """The units by the kind of expression."""
        kind, inner = part.kind, part.parts
        if kind == "number":
            return [[ONE if inner[0] else None]]
        if kind in ("add", "subtract"):
            return self.sum(self.of(inner[0]), self.of(inner[1]))
        if kind == "negate":
            return self.of(inner[0])
        if kind == "multiply":
            return product(self.of(inner[0]), self.of(inner[1]))
        if kind == "divide":
            return product(self.of(inner[0]), [[raised(self.one(inner[1]), -1)]])
        if kind == "power":
            return self.power(self.of(inner[0]), exact(inner[1]))
        if kind == "at":
            self.replaced(inner[1])
            return self.of(inner[0])
        if kind == "at named":
            return self.of(inner[0])
        if kind == "matrix":
            return self.blocks(inner[0])
        if kind == "entry":
            return self.entry(part)
        if kind == "name":
            return self.name(part)
        if kind == "applied":
            return self.applied(part)
        return self.call(inner[0], inner[1:])

    def replaced(self, pairs):
        """Replacements have the unit of what they replace, or are bare numbers in SI units."""
        for target, expression in pairs:
            try:
                exact(expression)
            except Mistake:
                same(self.one(target), self.one(expression))

    def sum(self, a, b):
        """The units of a sum."""
        if shape(a) != shape(b):
            raise Mistake("shapes do not fit")
        return [[same(x, y) for x, y in zip(*lines)] for lines in zip(a, b)]

    def power(self, base, n):
        """The units of a power."""
        if shape(base) == (1, 1):
            return [[raised(base[0][0], n)]] if n else [[ONE]]
        if any(unit not in (ONE, None) for line in base for unit in line):
            raise Unknown("the units of a power of a matrix")
        return [[ONE] * len(base) for _ in base]

    def blocks(self, lines):
        """The units of a matrix of matrices."""
        found = []
        for row in lines:
            pieces = [self.of(entry) for entry in row.parts]
            if len({len(piece) for piece in pieces}) != 1:
                raise Mistake("shapes do not fit")
            found += [sum(parts, []) for parts in zip(*pieces)]
        if len({len(line) for line in found}) != 1:
            raise Mistake("shapes do not fit")
        return found

    def entry(self, part):
        """The unit of an entry."""
        found, places = self.of(part.parts[0]), [int(exact(p)) - 1 for p in part.parts[1:]]
        if len(places) == 1:
            return [[sum(found, [])[places[0]]]]
        return [[found[places[0]][places[1]]]]

    def name(self, part):
        """The unit of a name."""
        name, dots, primes = part.parts
        if name in self.document.definitions and not primes:
            found = self.of(self.document.definitions[name])
        elif name == self.document.imaginary:
            found = [[ONE]]
        else:
            variable = self.evaluator.variable(part)
            if variable is None:
                raise Mistake(f"{name} is not declared")
            if variable[0] == "f":
                return [[self.function(variable)]]
            found = [[written_unit(self.document.variables[variable[1]].unit)]]
            dots = variable[2]
        return [[times(unit, raised(SECOND, -dots)) for unit in line] for line in found]

    def function(self, variable):
        """The unit of a derivative of a function."""
        declared = self.document.variables[variable[1]]
        argument = self.one(declared.argument)
        return times(written_unit(declared.unit), raised(argument or ONE, -variable[2]))

    def applied(self, part):
        """The unit of a template or of a function."""
        name, primes, *arguments = part.parts
        if name in self.document.templates:
            names, body = self.document.templates[name]
            return self.of(written(body, dict(zip(names, arguments))))
        variable = self.evaluator.variable(part)
        if variable is None:
            raise Mistake(f"{name} is not declared")
        same(self.one(arguments[0]), self.one(self.document.variables[variable[1]].argument))
        return [[self.function(variable)]]

    def call(self, name, arguments):
        """The units of a built-in function."""
        if name in ("sin", "cos", "tan", "cot", "angle"):
            same(self.one(arguments[0]), self.one(arguments[1]) if name == "angle" else ONE)
            return [[ONE]]
        if name == "identity":
            n = int(exact(arguments[0]))
            return [[ONE if i == j else None for j in range(n)] for i in range(n)]
        if name == "zero":
            return [[None] * int(exact(arguments[1])) for _ in range(int(exact(arguments[0])))]
        first = self.of(arguments[0])
        if name == "sqrt":
            return [[raised(first[0][0], Fraction(1, 2))]]
        if name == "dt":
            return product(first, [[raised(SECOND, -1)]])
        if name == "truncate":
            return first
        if name == "coefficient":
            return [[times(first[0][0], raised(self.one(arguments[1]), -exact(arguments[2])))]]
        return self.of_matrix(name, arguments, first)

    def of_matrix(self, name, arguments, first):
        """The units of what makes or takes matrices; of those without units where it is involved."""
        if name == "transpose":
            return [list(line) for line in zip(*first)]
        if name == "d":
            return self.derivative(first, [self.one(part) for part in self.evaluator.vector(arguments[1])])
        if name == "diagonal":
            entries = [self.one(argument) for argument in arguments]
            return [[u if i == j else None for j in range(len(entries))] for i, u in enumerate(entries)]
        if name == "row":
            return [first[int(exact(arguments[1])) - 1]]
        if name == "column":
            return [[line[int(exact(arguments[1])) - 1]] for line in first]
        if name == "trace":
            return [[total(first[i][i] for i in range(len(first)))]]
        if name in ("det", "adjugate", "inverse", "solve"):
            return self.by_minors(name, first, arguments[1:])
        if any(unit not in (ONE, None) for argument in arguments for line in self.of(argument) for unit in line):
            raise Unknown(f"the units of {name}")
        if name == "hurwitz":
            return [[ONE]]
        raise Unknown(f"the units of {name}")

    def by_minors(self, name, table, others):
        """The units of sums of products of entries."""
        if len(table) > 6 or len({len(line) for line in table} | {len(table)}) != 1:
            raise Unknown(f"the units of {name}")
        if name == "det":
            return [[determinant(table)]]
        found = adjugate(table)
        if name == "adjugate":
            return found
        if name == "solve":
            found = product(found, self.of(others[0]))
        below = raised(determinant(table), -1)
        return [[times(unit, below) for unit in line] for line in found]

    def derivative(self, first, by):
        """The units of partial derivatives."""
        entries = [unit for line in first for unit in line]
        lines = [[times(unit, raised(q, -1)) for q in by] for unit in entries]
        if len(by) == 1 and len(first) == 1:
            return [[line[0] for line in lines]]
        return lines

    def fit(self, claim):
        """Whether the sides of a claim can be compared."""
        try:
            left, right = self.of(claim.left), self.of(claim.right)
            if [[None]] in (left, right) and shape(left) != shape(right):
                raise Unknown("0 beside a matrix")
            self.sum(left, right)
        except Mistake:
            return False
        return True


def total(units):
    """The unit of a sum."""
    found = None
    for unit in units:
        found = same(found, unit)
    return found


def without(table, row, column):
    """A table without a row and a column."""
    return [line[:column] + line[column + 1:] for i, line in enumerate(table) if i != row]


def determinant(table):
    """The unit of a determinant: that of each of its products that has one."""
    if not table:
        return ONE
    terms = enumerate(table[0])
    return total(times(unit, determinant(without(table, 0, j))) for j, unit in terms if unit is not None)


def adjugate(table):
    """The units of an adjugate matrix."""
    places = range(len(table))
    return [[determinant(without(table, j, i)) for j in places] for i in places]


def product(a, b):
    """The units of a product."""
    if shape(a) == (1, 1):
        return [[times(a[0][0], unit) for unit in line] for line in b]
    if shape(b) == (1, 1):
        return [[times(unit, b[0][0]) for unit in line] for line in a]
    if shape(a)[1] != shape(b)[0]:
        raise Mistake("shapes do not fit")
    found = []
    for line in a:
        found.append([])
        for j in range(shape(b)[1]):
            unit = None
            for x, row in zip(line, b):
                unit = same(unit, times(x, row[j]))
            found[-1].append(unit)
    return found
