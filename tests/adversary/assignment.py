"""Assignments: a value for every declared name, drawn so that all assumptions are satisfied."""

from fractions import Fraction

from mpmath import mp, mpc, mpf

import series
from evaluation import Evaluator
from frame import Context
from series import Mistake, NoValue, Unknown, constant, is_zero

KEY = mpf(10) ** 50
CLOSE = mpf(10) ** -5
TRIES = 200
POOL = 63


class Assignment:
    """Values of variables and of functions at arguments; what was not given is drawn."""

    def __init__(self, values, draw, functions=None, draw_variable=None):
        self.values, self.draw, self.functions = values, draw, dict(functions or {})
        self.draw_variable, self.near = draw_variable, []

    def variable(self, variable):
        """The value of a parameter, an angle, a coordinate or one of its rates."""
        if variable not in self.values:
            self.values[variable] = self.draw_variable(variable)
        return self.values[variable]

    def function(self, name, order, argument):
        """The value of a derivative of a function at a number; the same for the same number."""
        key = (name, order, int(mp.nint(argument * KEY)))
        if key not in self.functions:
            self.functions[key] = self.shown_near(name, order, argument)
        return self.functions[key]

    def shown_near(self, name, order, argument):
        """The value that is shown of a function at a rounded argument, or a new one."""
        for other, derivative, place, value in self.near:
            if (other, derivative) == (name, order) and abs(place - argument) <= CLOSE * (1 + abs(place)):
                return value
        return self.draw()

    def changed(self, variable, value):
        """The assignment with another value of a variable, and the same functions."""
        found = Assignment({**self.values, variable: value}, self.draw, self.functions, self.draw_variable)
        return found

    def shown(self):
        """What a reader needs to repeat it."""
        names = [f"{v[1]}{'.' * v[2]} = {mp.nstr(x, 12)}" for v, x in sorted(self.values.items())]
        return ", ".join(names + [f"{n}{chr(39) * k}({mp.nstr(mpf(a) / KEY, 8)}) = {mp.nstr(x, 8)}"
                                  for (n, k, a), x in sorted(self.functions.items())])


class Sampler:
    """Draws assignments of a document."""

    def __init__(self, document, random):
        self.document, self.random = document, random
        self.evaluator = Evaluator(document, [])
        self.evaluator.companions = [Context(base) for base in self.companions(8)]
        self.pool = []

    def companions(self, count):
        """Assignments in general, with numbers that are tied by nothing."""
        found = []
        for number in range(count):
            assignment = self.assignment("general", sign=1 if number % 2 else -1)
            if assignment is not None:
                found.append(assignment)
        return found

    def pooled(self, count):
        """Some of the assignments that were drawn for the document, in every manner."""
        if not self.pool:
            drawn = (self.assignment(MANNERS[number % len(MANNERS)]) for number in range(POOL))
            self.pool = [assignment for assignment in drawn if assignment is not None] or [None]
        if self.pool == [None]:
            return []
        start = self.random.randrange(len(self.pool))
        return [self.pool[(start + number) % len(self.pool)] for number in range(min(count, len(self.pool)))]

    def assignment(self, manner, sign=0):
        """An assignment that satisfies everything, or nothing if none was found."""
        for attempt in range(TRIES):
            found = self.attempt(manner if attempt < TRIES // 2 else self.random.choice(MANNERS), sign)
            if self.satisfies(found):
                return found
            if attempt % 10 == 9 and self.repaired(found):
                return found
        return None

    def repaired(self, found):
        """Whether an assignment satisfies everything once a few of its values are drawn again."""
        for _ in range(20):
            variables = list(found.values)
            if not variables:
                return False
            variable = self.random.choice(variables)
            old, before = found.values[variable], self.broken(found)
            found.values[variable] = self.value(variable, self.random.choice(MANNERS), 0, found)
            after = self.broken(found)
            if after == 0:
                return True
            if after > before:
                found.values[variable] = old
        return False

    def attempt(self, manner, sign):
        """An assignment that may break an assumption."""
        found = Assignment({}, lambda: self.real(manner, 0))
        found.draw_variable = lambda variable: self.value(variable, manner, sign, found)
        names = list(self.document.variables)
        self.random.shuffle(names)
        for name in names:
            if self.document.variables[name].kind != "function":
                found.variable(("v", name, 0))
        return found

    def value(self, variable, manner, sign, found):
        """A value of a variable, of its declared kind and sign."""
        declared = self.document.variables[variable[1]]
        if declared.kind == "complex":
            return self.complex(manner)
        if declared.kind in ("angle", "coordinate") and manner in ("integers", "angles") and variable[2] == 0:
            return self.angle()
        if manner == "coincident" and found.values and self.random.random() < 0.5:
            other = self.random.choice(list(found.values.values()))
            value = series.tidy(other) * self.random.choice([1, 1, -1, 2])
            value = value.real if isinstance(value, mpc) else value
        else:
            value = self.real(manner, sign)
        if declared.sign in (">", ">=") and variable[2] == 0:
            value = abs(value)
        elif declared.sign in ("<", "<=") and variable[2] == 0:
            value = -abs(value)
        if declared.sign in (">", "<", "!=") and variable[2] == 0 and value == 0:
            value = mpf(1 if declared.sign != "<" else -1)
        return value

    def real(self, manner, sign):
        """A real number."""
        draw = self.random
        if manner == "integers":
            return mpf(draw.randint(-3, 3))
        if manner == "fractions":
            value = Fraction(draw.randint(-12, 12), draw.randint(1, 6))
            return mpf(value.numerator) / value.denominator
        if manner == "large":
            return mpf(draw.randint(-10 ** 9, 10 ** 9)) * draw.choice([1, 1, 10])
        if manner == "small":
            return mpf(draw.randint(-10 ** 6, 10 ** 6)) / 10 ** 8
        value = mpf(draw.getrandbits(300)) / 2 ** 300 * 3 + mpf(1) / 50
        if sign:
            return value if draw.random() < 0.5 + 0.35 * sign else -value
        return value if draw.random() < 0.6 else -value

    def complex(self, manner):
        """A complex number, which may be real or imaginary."""
        one, other = self.real(manner, 0), self.real(manner, 0)
        if manner == "general":
            return mpc(one, other)
        return series.tidy(self.random.choice([mpc(one, other), mpc(one, 0), mpc(0, other)]))

    def angle(self):
        """A simple angle, in which sines and cosines may vanish."""
        return +mp.pi * self.random.randint(-24, 24) / self.random.choice([2, 2, 4, 4, 6, 12])

    def satisfies(self, found):
        """Whether an assignment satisfies all signs and assumptions."""
        context = Context(found)
        return self.broken_signs(found) == 0 and all(
            self.holds(condition, context) for condition in self.document.assumptions)

    def broken(self, found):
        """How many signs and assumptions an assignment breaks."""
        context = Context(found)
        return self.broken_signs(found) + sum(
            not self.holds(condition, context) for condition in self.document.assumptions)

    def broken_signs(self, found):
        """How many declared signs an assignment breaks."""
        signed = ((name, declared.sign) for name, declared in self.document.variables.items()
                  if declared.sign and declared.kind != "function")
        return sum(not SIGNS[sign](found.variable(("v", name, 0))) for name, sign in signed)

    def holds(self, condition, context):
        """Whether both sides of a condition have values in the stated order."""
        left, sign, right = condition
        try:
            return compared(constant(self.evaluator.scalar(left, context)), sign,
                            constant(self.evaluator.scalar(right, context)))
        except (NoValue, Unknown, Mistake):
            return False


SIGNS = {
    ">": lambda value: value > series.NOTHING, ">=": lambda value: value > -series.NOTHING,
    "<": lambda value: value < -series.NOTHING, "<=": lambda value: value < series.NOTHING,
    "!=": lambda value: abs(value) > series.NOTHING,
}
MANNERS = ("general", "integers", "fractions", "coincident", "angles", "large", "small")


def compared(left, sign, right):
    """Whether two numbers are in an order; what is not real has none."""
    if sign in ("==", "!="):
        return equal(left, right) == (sign == "==")
    left, right = series.real(left, "an order"), series.real(right, "an order")
    if equal(left, right):
        return sign in ("<=", ">=")
    return left < right if sign in ("<", "<=") else left > right


def equal(left, right):
    """Whether two numbers are the same; what lies between is not known."""
    size = 1 + abs(left) + abs(right)
    if size > series.TOO_LARGE:
        raise Unknown("too large a number")
    return is_zero((left - right) / size)
