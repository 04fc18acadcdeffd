"""Numbers of many digits, and truncated power series of them, of any depth.

A series of level n has coefficients that are numbers or series of lower levels. A value is the
number or the series; derivatives and Taylor polynomials are read off coefficients."""

from mpmath import mp, mpc, mpf

mp.dps = 250
NOTHING = mpf(10) ** -150
SOMETHING = mpf(10) ** -110
TOO_LARGE = mpf(10) ** 95


class NoValue(Exception):
    """The expression has no value under this assignment."""


class Unknown(Exception):
    """The oracle cannot tell, or the page of meanings leaves it open."""


class Mistake(Exception):
    """What no document may say."""


class Series:
    """c₀ + c₁ t + … up to the order of its level."""

    __slots__ = ("level", "terms")

    def __init__(self, level, terms):
        self.level, self.terms = level, terms

    def __repr__(self):
        return f"Series({self.level}, {self.terms})"


def level(value):
    """The level of a value; 0 for a number."""
    return value.level if isinstance(value, Series) else 0


def constant(value):
    """The number that is left where all small quantities vanish."""
    while isinstance(value, Series):
        value = value.terms[0]
    return value


def tidy(value):
    """A number without an imaginary part that is rounding."""
    if isinstance(value, mpc):
        size = abs(value.real) + abs(value.imag)
        if abs(value.imag) <= NOTHING * max(size, 1):
            return value.real
    return value


def is_zero(value):
    """Whether a number is 0; between 0 and what is surely not lies what is not known."""
    size = abs(value)
    if size < NOTHING:
        return True
    if size < SOMETHING:
        raise Unknown("a number too near to 0")
    return False


def is_null(value):
    """Whether a value and all its coefficients are 0."""
    if isinstance(value, Series):
        return all(is_null(term) for term in value.terms)
    return is_zero(value)


def real(value, what):
    """A number that must be real."""
    value = tidy(value)
    if isinstance(value, mpc):
        raise NoValue(f"{what} of what is not real")
    return value


def all_real(value):
    """Whether all coefficients are real."""
    if isinstance(value, Series):
        return all(all_real(term) for term in value.terms)
    return not isinstance(tidy(value), mpc)


def add(a, b):
    """The sum."""
    low, high = level(a), level(b)
    if low == high == 0:
        return tidy(a + b)
    if low > high:
        return Series(low, [add(a.terms[0], b)] + a.terms[1:])
    if low < high:
        return Series(high, [add(a, b.terms[0])] + b.terms[1:])
    return Series(low, [add(x, y) for x, y in zip(a.terms, b.terms)])


def negate(a):
    """The negative."""
    return Series(a.level, [negate(x) for x in a.terms]) if isinstance(a, Series) else -a


def subtract(a, b):
    """The difference."""
    return add(a, negate(b))


def multiply(a, b):
    """The product."""
    low, high = level(a), level(b)
    if low == high == 0:
        return tidy(a * b)
    if low > high:
        return Series(low, [multiply(x, b) for x in a.terms])
    if low < high:
        return Series(high, [multiply(a, y) for y in b.terms])
    return Series(low, [total(multiply(a.terms[i], b.terms[n - i]) for i in range(n + 1))
                        for n in range(len(a.terms))])


def total(values):
    """The sum of values, of which there is one at least."""
    values = iter(values)
    found = next(values)
    for value in values:
        found = add(found, value)
    return found


def invert(a):
    """1/a; a must not be 0 where all small quantities vanish."""
    if not isinstance(a, Series):
        if is_zero(a):
            raise NoValue("division by 0")
        return 1 / a
    first = invert(a.terms[0])
    found = [first]
    for n in range(1, len(a.terms)):
        rest = total(multiply(a.terms[i], found[n - i]) for i in range(1, n + 1))
        found.append(negate(multiply(first, rest)))
    return Series(a.level, found)


def divide(a, b):
    """The quotient."""
    return multiply(a, invert(b))


def power(a, n):
    """A power with a whole exponent."""
    if n < 0:
        return invert(power(a, -n))
    found = mpf(1)
    while n:
        if n & 1:
            found = multiply(found, a)
        a, n = multiply(a, a) if n > 1 else a, n >> 1
    return found


def compose(derivative, a):
    """f(a), where derivative(n, c) is the n-th derivative of f at c, a value of lower level."""
    if not isinstance(a, Series):
        return derivative(0, a)
    small = Series(a.level, [mpf(0)] + a.terms[1:])
    found, step, factorial = derivative(0, a.terms[0]), mpf(1), 1
    for n in range(1, len(a.terms)):
        step, factorial = multiply(step, small), factorial * n
        if is_null(step):
            break
        found = add(found, multiply(derivative(n, a.terms[0]), multiply(step, mpf(1) / factorial)))
    return found


def must_be_smooth(a, what):
    """A real argument whose small parts must be real, too: else the page leaves it open."""
    real(constant(a), what)
    if not all_real(a):
        raise Unknown(f"{what} about a real place in a direction that is not real")


def sine(a, shift=0):
    """sin a, or with a shift its derivatives."""
    must_be_smooth(a, "sine")

    def derivative(n, c):
        if isinstance(c, Series):
            return sine(c, shift + n)
        function = (mp.sin, mp.cos)[(shift + n) % 2]
        value = function(real(c, "sine"))
        return -value if (shift + n) % 4 in (2, 3) else value

    return compose(derivative, a)


def cosine(a):
    """cos a."""
    return sine(a, 1)


def root(a):
    """The root that is not negative."""
    must_be_smooth(a, "a root")
    if not isinstance(a, Series):
        a = real(a, "a root")
        if is_zero(a):
            return mpf(0)
        if a < 0:
            raise NoValue("the root of a negative number")
        return mp.sqrt(a)
    if is_zero(constant(a)):
        if is_null(a):
            raise Unknown("a root that may be 0 in all directions")
        raise NoValue("a root that is not smooth at 0")
    first = root(a.terms[0])
    half = invert(add(first, first))
    found = [first]
    for n in range(1, len(a.terms)):
        rest = a.terms[n]
        if n > 1:
            rest = subtract(rest, total(multiply(found[i], found[n - i]) for i in range(1, n)))
        found.append(multiply(rest, half))
    return Series(a.level, found)


def direction(x, y):
    """The number in −π < β ≤ π for the vector (x, y)."""
    for part in (x, y):
        must_be_smooth(part, "the angle")
    top = max(level(x), level(y))
    if top == 0:
        x, y = real(x, "the angle"), real(y, "the angle")
        if is_zero(x) and is_zero(y):
            raise NoValue("the angle of (0, 0)")
        if is_zero(y):
            return mpf(0) if x > 0 else +mp.pi
        return mp.atan2(y, x)
    if is_zero(constant(y)) and constant(x) < 0:
        raise Unknown("a derivative of the angle at half a turn")
    x0 = x.terms[0] if level(x) == top else x
    y0 = y.terms[0] if level(y) == top else y
    across = subtract(multiply(y, x0), multiply(x, y0))
    along = add(multiply(x, x0), multiply(y, y0))
    small = divide(across, along)
    if level(small) < top:
        return direction(x0, y0)
    square, step, found = multiply(small, small), small, direction(x0, y0)
    for n in range(0, len(small.terms)):
        found = add(found, multiply(step, mpf((-1) ** n) / (2 * n + 1)))
        step = multiply(step, square)
    return found
