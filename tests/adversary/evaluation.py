"""Values of expressions under an assignment, in the sense of the page of meanings.

An expression is a function of variables. `at`, `d`, `dt`, `truncate` and `coefficient` each put a
frame around what they act on, which replaces some variables, or adds a small quantity to them. A
name is looked up from the innermost frame outwards, and from the last one in the assignment."""

from fractions import Fraction
from math import comb

from mpmath import mpf

import matrices
import series
from matrices import entrywise, matrix, rows, shape
from series import (Mistake, NoValue, Series, Unknown, add, compose, constant, is_zero, multiply, negate,
                    subtract, total)
from syntax import Node, node, number

COMPANIONS = 6
SHIFTS = tuple(number(Fraction(n, 10 ** 8)) for n in (83712519, -61803397, 127323954))


class Frame:
    """Which variables are replaced, and how: by an expression (`at`), by themselves and a small
    quantity (`d`, `dt`), by themselves times one (`truncate`), by a number and one (`shift`)."""

    known = {}

    def __init__(self, kind, replaced, order):
        self.kind, self.order = kind, order
        self.variables = {v: e for v, e in replaced if v[0] != "f"}
        self.functions = [(v, e) for v, e in replaced if v[0] == "f"]

    @staticmethod
    def of(kind, replaced=(), order=1):
        """The one frame of this kind; `replaced` pairs variables with expressions."""
        key = (kind, tuple(replaced), order)
        if key not in Frame.known:
            Frame.known[key] = Frame(kind, tuple(replaced), order)
        return Frame.known[key]


class Context:
    """Frames over an assignment, with the values that were found in it."""

    def __init__(self, base, frames=(), parent=None):
        self.base, self.frames, self.parent = base, frames, parent
        self.level, self.values, self.looked, self.children = len(frames), {}, {}, {}

    def within(self, frame):
        """The context with one more frame inside."""
        if frame not in self.children:
            self.children[frame] = Context(self.base, (*self.frames, frame), self)
        return self.children[frame]

    def nested(self, frames):
        """The context with more frames inside."""
        found = self
        for frame in frames:
            found = found.within(frame)
        return found


class Evaluator:
    """Evaluates the expressions of one document."""

    def __init__(self, document, companions):
        self.document, self.companions = document, [Context(base) for base in companions]
        self.same, self.directions, self.occurring, self.degrees = {}, {}, {}, {}
        self.asked = None

    def value(self, part, context):
        """The value of an expression; an exception where it has none."""
        found = context.values.get(part)
        if found is None:
            try:
                found = (self.evaluate(part, context), None)
            except (NoValue, Unknown, Mistake) as reason:
                found = (None, reason)
            except (OverflowError, RecursionError, MemoryError) as reason:
                found = (None, Unknown(f"too large: {reason}"))
            context.values[part] = found
        if found[1] is not None:
            raise found[1]
        return found[0]

    def scalar(self, part, context):
        """The value of an expression that is no matrix."""
        found = self.value(part, context)
        if isinstance(found, matrices.Matrix):
            raise Mistake("a number is wanted")
        return found

    def evaluate(self, part, context):
        """The value by the kind of expression."""
        return getattr(self, "value_of_" + part.kind.replace(" ", "_"))(part, context)

    def value_of_number(self, part, _):
        """An exact number."""
        value = part.parts[0]
        return mpf(value.numerator) / value.denominator

    def value_of_add(self, part, context):
        """A sum."""
        return entrywise(add, self.value(part.parts[0], context), self.value(part.parts[1], context))

    def value_of_subtract(self, part, context):
        """A difference."""
        return entrywise(subtract, self.value(part.parts[0], context), self.value(part.parts[1], context))

    def value_of_multiply(self, part, context):
        """A product."""
        return matrices.product(self.value(part.parts[0], context), self.value(part.parts[1], context))

    def value_of_divide(self, part, context):
        """A quotient."""
        over, under = self.value(part.parts[0], context), self.scalar(part.parts[1], context)
        self.ask("nonzero", part.parts[1], context, under)
        return matrices.quotient(over, under)

    def value_of_negate(self, part, context):
        """A negative."""
        return entrywise(negate, self.value(part.parts[0], context))

    def value_of_power(self, part, context):
        """A power with a whole or half exponent."""
        base, exponent = self.value(part.parts[0], context), exact(part.parts[1])
        if isinstance(base, matrices.Matrix):
            return matrices.power(base, int(exponent))
        if exponent.denominator == 2:
            self.ask("positive", part.parts[0], context, base)
            return series.power(series.root(base), exponent.numerator)
        if exponent < 0:
            self.ask("nonzero", part.parts[0], context, base)
        return series.power(base, int(exponent))

    def value_of_matrix(self, part, context):
        """A matrix, row by row."""
        return matrices.blocks([[self.value(entry, context) for entry in row.parts] for row in part.parts[0]])

    def value_of_entry(self, part, context):
        """An entry of a matrix, or of a row or column."""
        found = rows(self.value(part.parts[0], context))
        places = [int(exact(place)) - 1 for place in part.parts[1:]]
        if len(places) == 1:
            flat = found[0] if len(found) == 1 else [line[0] for line in found]
            if len(found) > 1 and len(found[0]) > 1:
                raise Mistake("two indices are wanted")
            found, places = [flat], [0, places[0]]
        if not (0 <= places[0] < len(found) and 0 <= places[1] < len(found[0])):
            raise Mistake("no such entry")
        return found[places[0]][places[1]]

    def value_of_name(self, part, context):
        """A definition, a variable, or the imaginary unit."""
        name, dots, primes = part.parts
        if name in self.document.definitions and not dots and not primes:
            return self.value(self.document.definitions[name], context)
        if name == self.document.imaginary:
            return series.mpc(0, 1)
        variable = self.variable(part)
        if variable is None:
            if dots:
                return self.value(rated(name, dots), context)
            raise Mistake(f"{name} is not declared")
        if variable[0] == "f":
            return self.function(variable[1], variable[2], variable[3], context)
        return self.look_up(variable, context)

    def value_of_applied(self, part, context):
        """A template, or a function at an argument."""
        name, primes, *arguments = part.parts
        if name in self.document.templates and not primes:
            names, body = self.document.templates[name]
            return self.value(written(body, dict(zip(names, arguments))), context)
        symbol = self.function_symbol(name, primes)
        if symbol is None or len(arguments) != 1:
            raise Mistake(f"{name} is no function")
        return self.function(*symbol, arguments[0], context)

    def value_of_at(self, part, context):
        """An expression after replacements."""
        replaced = []
        for target, expression in part.parts[1]:
            variable = self.variable(target)
            if variable is None:
                raise Mistake("only variables are replaced")
            replaced.append((variable, expression))
        return self.value(part.parts[0], context.within(Frame.of("at", replaced)))

    def value_of_at_named(self, part, context):
        """An expression after the replacements of a name, or with the solution of a matching."""
        inner, name = part.parts
        if name in self.document.substitutions:
            return self.value(node("at", inner, self.document.substitutions[name]), context)
        matching = self.document.matchings.get(name)
        if matching is None:
            raise Mistake(f"{name} is no substitution")
        replaced = [(("v", unknown, 0), node("solution", name, place))
                    for place, unknown in enumerate(matching.unknowns)]
        return self.value(inner, context.within(Frame.of("at", replaced)))

    def value_of_solution(self, part, context):
        """One of the unknowns of a matching, by its first equations."""
        name, place = part.parts
        return rows(self.value(node("solutions", name), context))[place][0]

    def value_of_solutions(self, part, context):
        """The unknowns of a matching, whose equations are linear in them."""
        matching = self.document.matchings[part.parts[0]]
        if not matching.simple:
            raise Unknown("a matching that neglects")
        unknowns = [("v", unknown, 0) for unknown in matching.unknowns]
        still = context.within(Frame.of("at", [(unknown, number(0)) for unknown in unknowns]))
        difference = node("subtract", matching.exact, matching.assumed)
        lines, right = [], []
        for power in matching.powers[:len(unknowns)]:
            equation = node("call", "coefficient", difference, matching.variable, number(power))
            right.append([negate(self.scalar(equation, still))])
            lines.append([slope(self.scalar(equation, still.within(Frame.of("d", [(u, None)]))),
                                still.level + 1) for u in unknowns])
        return matrices.solve(matrix(lines), matrix(right))

    def value_of_call(self, part, context):
        """A built-in function."""
        name, *arguments = part.parts
        return getattr(self, "call_" + name)(arguments, context)

    def call_sin(self, arguments, context):
        """A sine."""
        return series.sine(self.scalar(arguments[0], context))

    def call_cos(self, arguments, context):
        """A cosine."""
        return series.cosine(self.scalar(arguments[0], context))

    def call_tan(self, arguments, context):
        """A tangent."""
        angle = self.scalar(arguments[0], context)
        self.ask("nonzero", node("call", "cos", arguments[0]), context, series.cosine(angle))
        return series.divide(series.sine(angle), series.cosine(angle))

    def call_cot(self, arguments, context):
        """A cotangent."""
        angle = self.scalar(arguments[0], context)
        self.ask("nonzero", node("call", "sin", arguments[0]), context, series.sine(angle))
        return series.divide(series.cosine(angle), series.sine(angle))

    def call_sqrt(self, arguments, context):
        """A root."""
        value = self.scalar(arguments[0], context)
        self.ask("positive", arguments[0], context, value)
        return series.root(value)

    def call_angle(self, arguments, context):
        """The angle of a vector: a sum of declared angles where it is one, else in −π < β ≤ π."""
        x, y = (self.scalar(argument, context) for argument in arguments)
        found = self.declared_direction(arguments, context, x, y, ())
        if any(frame.kind == "at" for frame in context.frames):
            other = self.declared_direction(arguments, context, x, y, context.frames)
            if not is_zero(constant(subtract(found, other))):
                raise Unknown("the direction of a vector that is replaced")
        return found

    def call_dt(self, arguments, context):
        """The time derivative."""
        inner = context.within(Frame.of("dt"))
        return entrywise(lambda entry: slope(entry, inner.level), self.value(arguments[0], inner))

    def call_d(self, arguments, context):
        """Partial derivatives."""
        lines = []
        for part in self.vector(arguments[1]):
            variable = self.variable(part)
            if variable is None:
                raise Mistake("a derivative by what is no variable")
            inner = context.within(Frame.of("d", [(variable, None)]))
            found = self.value(arguments[0], inner)
            lines.append([slope(entry, inner.level) for line in rows(found) for entry in line])
        if len(lines) == 1 and shape(found)[0] == 1:
            return matrix(lines)
        return matrices.transpose(matrix(lines))

    def call_truncate(self, arguments, context):
        """The Taylor polynomial."""
        variables = [(self.variable(part), None) for part in self.vector(arguments[1])]
        if any(variable is None for variable, _ in variables):
            raise Mistake("an expansion in what is no variable")
        inner = context.within(Frame.of("truncate", variables, int(exact(arguments[2]))))
        found = self.value(arguments[0], inner)
        return entrywise(lambda entry: total(entry.terms) if series.level(entry) == inner.level else entry,
                         found)

    def call_coefficient(self, arguments, context):
        """A coefficient of a polynomial."""
        return self.coefficients(arguments[0], arguments[1], context)[int(exact(arguments[2]))]

    def call_hurwitz(self, arguments, context):
        """A determinant of Hurwitz, for the degree that the polynomial has in general."""
        n, degree = int(exact(arguments[2])), self.degree(arguments[0], arguments[1], context)
        terms = self.coefficients(arguments[0], arguments[1], context)
        if not 1 <= n <= degree:
            raise Unknown("more than all determinants of Hurwitz")
        places = [[degree + i - 2 * j for j in range(1, n + 1)] for i in range(1, n + 1)]
        return matrices.determinant(matrix([[terms[k] if 0 <= k <= degree else mpf(0) for k in line]
                                            for line in places]))

    def call_kernel(self, arguments, context):
        """The null space, by the pivots that there are in general."""
        found = self.value(arguments[0], context)
        places = []
        for companion in self.companions[:3]:
            try:
                general = matrices.pivots(self.value(arguments[0], companion))
            except NoValue:
                continue
            places = max(places, general, key=len)
        for place in places:
            self.ask("nonzero", node("entry", arguments[0], number(1), number(place + 1)), context, None)
        return matrices.kernel(found, places)

    def call_det(self, arguments, context):
        """A determinant."""
        return matrices.determinant(self.value(arguments[0], context))

    def call_adjugate(self, arguments, context):
        """An adjugate."""
        return matrices.adjugate(self.value(arguments[0], context))

    def call_inverse(self, arguments, context):
        """An inverse."""
        found = self.value(arguments[0], context)
        self.ask("nonzero", node("call", "det", arguments[0]), context, None)
        return matrices.inverse(found)

    def call_solve(self, arguments, context):
        """The solution of a linear system."""
        self.ask("nonzero", node("call", "det", arguments[0]), context, None)
        return matrices.solve(self.value(arguments[0], context), self.value(arguments[1], context))

    def call_trace(self, arguments, context):
        """A trace."""
        return matrices.trace(self.value(arguments[0], context))

    def call_transpose(self, arguments, context):
        """A transpose."""
        return matrices.transpose(self.value(arguments[0], context))

    def call_diagonal(self, arguments, context):
        """A diagonal matrix."""
        entries = [self.scalar(argument, context) for argument in arguments]
        return matrix([[entry if i == j else mpf(0) for j in range(len(entries))]
                       for i, entry in enumerate(entries)])

    def call_identity(self, arguments, _):
        """An identity."""
        return matrices.identity(int(exact(arguments[0])))

    def call_zero(self, arguments, _):
        """A matrix of zeros."""
        lines, columns = (int(exact(argument)) for argument in arguments)
        return matrix([[mpf(0)] * columns for _ in range(lines)])

    def call_row(self, arguments, context):
        """A row."""
        found = self.value(arguments[0], context)
        return matrices.submatrix(found, [int(exact(arguments[1])) - 1], range(shape(found)[1]))

    def call_column(self, arguments, context):
        """A column."""
        found = self.value(arguments[0], context)
        return matrices.submatrix(found, range(shape(found)[0]), [int(exact(arguments[1])) - 1])

    def call_submatrix(self, arguments, context):
        """Some rows and columns."""
        places = [[int(exact(part)) - 1 for part in self.vector(argument)] for argument in arguments[1:]]
        return matrices.submatrix(self.value(arguments[0], context), *places)

    def vector(self, part):
        """The entries of a written vector, or the one that a name or number is."""
        while part.kind == "name" and part.parts[0] in self.document.definitions:
            part = self.document.definitions[part.parts[0]]
        if part.kind != "matrix":
            return [part]
        return [entry for row in part.parts[0] for entry in row.parts]

    def ask(self, kind, part, context, value):
        """Notes what must not be 0, or be positive, so that its edges can be sought."""
        if self.asked is not None and context.base is not None:
            self.asked.append((kind, part, context.frames))

    # Variables and functions

    def function_symbol(self, name, primes):
        """The function and the order of derivative that a name means; `d2C` is C''."""
        declared = self.document.variables.get(name)
        if declared is not None:
            return (name, primes) if declared.kind == "function" else None
        if name[:1] == "d":
            digits = name[1:2] if name[1:2].isdigit() else ""
            rest = name[1 + len(digits):]
            declared = self.document.variables.get(rest)
            if declared is not None and declared.kind == "function":
                return rest, primes + int(digits or 1)
        return None

    def variable(self, part):
        """The variable that a part of an expression names, or nothing."""
        if part.kind == "call" and part.parts[0] == "dt":
            inner = self.variable(part.parts[1])
            return ("v", inner[1], inner[2] + 1) if inner and inner[0] == "v" else None
        if part.kind == "applied":
            symbol = self.function_symbol(part.parts[0], part.parts[1])
            return ("f", *symbol, part.parts[2]) if symbol else None
        if part.kind != "name":
            return None
        name, dots, primes = part.parts
        name = self.document.spellings.get(name, name)
        symbol = self.function_symbol(name, primes)
        if symbol and not dots:
            return ("f", *symbol, self.document.variables[symbol[0]].argument)
        declared = self.document.variables.get(name)
        if declared is None or primes or (dots and declared.kind != "coordinate"):
            return None
        return ("v", name, dots)

    def look_up(self, variable, context):
        """The value of a variable that is no function."""
        found = context.looked.get(variable)
        if found is None:
            found = context.looked[variable] = self.find(variable, context)
        return found

    def find(self, variable, context):
        """The value of a variable by the innermost frame."""
        if context.parent is None:
            return context.base.variable(variable)
        frame = context.frames[-1]
        if frame.kind == "dt":
            return self.moving(variable, context)
        if variable not in frame.variables:
            return self.look_up(variable, context.parent)
        if frame.kind == "at":
            return self.scalar(frame.variables[variable], context.parent)
        if frame.kind == "shift":
            shift = self.scalar(frame.variables[variable], context.parent)
            return Series(context.level, [shift, mpf(1)] + [mpf(0)] * (frame.order - 1))
        return perturbed(self.look_up(variable, context.parent), frame, context.level)

    def moving(self, variable, context):
        """A coordinate and its rate, a little later."""
        value = self.look_up(variable, context.parent)
        if self.document.variables[variable[1]].kind != "coordinate":
            return value
        return Series(context.level, [value, self.look_up(("v", variable[1], variable[2] + 1), context.parent)])

    def function(self, name, order, argument, context):
        """The value of a derivative of a declared function at an argument."""
        return self.resolve(name, order, argument, context, context, self.scalar(argument, context))

    def resolve(self, name, order, argument, inner, context, value):
        """The same by the frame of a context, for an argument with this value there."""
        if context.parent is None:
            return context.base.function(name, order, series.real(value, "a function"))
        series.must_be_smooth(value, "a function")
        frame = context.frames[-1]
        for (_, target, derivative, place), expression in frame.functions:
            if (target, derivative) == (name, order) and self.is_same(argument, inner.frames[context.level:], place):
                if frame.kind == "at":
                    return self.scalar(expression, context.parent)
                below = self.descend(name, order, argument, inner, context, value)
                return perturbed(below, frame, context.level)
        return self.descend(name, order, argument, inner, context, value)

    def descend(self, name, order, argument, inner, context, value):
        """The same by the frames further out, expanded in the small quantity of this one."""
        if series.level(value) != context.level:
            return self.resolve(name, order, argument, inner, context.parent, value)
        return compose(lambda n, c: self.resolve(name, order + n, argument, inner, context.parent, c), value)

    def is_same(self, argument, frames, place):
        """Whether two arguments are equal under every assignment at which both have values."""
        key = (argument, frames, place)
        if key not in self.same:
            self.same[key] = self.compare(argument, frames, place)
        return self.same[key]

    def compare(self, argument, frames, place):
        """The same by the companions, which are assignments in general."""
        compared = 0
        for companion in self.companions:
            try:
                one = constant(self.scalar(argument, companion.nested(frames)))
                other = constant(self.scalar(place, companion))
            except NoValue:
                continue
            compared += 1
            if not is_zero(one - other):
                return False
        if compared < 3:
            raise Unknown("arguments that could not be compared")
        return True

    # Directions and polynomials

    def declared_direction(self, arguments, context, x, y, frames):
        """The angle of a vector, with the declared angles found in general within these frames."""
        key = (*arguments, frames)
        if key not in self.directions:
            self.directions[key] = self.whole_combination(arguments, frames)
        combination = self.directions[key]
        outer = context
        while frames and outer.parent is not None:
            outer = outer.parent
        if combination is not None:
            angle = mpf(0)
            for variable, n in combination:
                angle = add(angle, multiply(mpf(n), self.look_up(variable, outer)))
            x0, y0, a0 = constant(x), constant(y), constant(angle)
            length = add(multiply(x0, series.cosine(a0)), multiply(y0, series.sine(a0)))
            if series.real(length, "the angle") > 0 and not is_zero(length):
                return angle
        return series.direction(x, y)

    def whole_combination(self, arguments, frames):
        """Which sum of declared angles the angle of a vector is up to half turns, in general."""
        found = []
        for name, declared in sorted(self.document.variables.items()):
            if declared.kind not in ("angle", "coordinate") or not self.occurs(name, arguments, frames):
                continue
            slopes = [self.turning(("v", name, 0), arguments, frames, companion) for companion in self.companions[:3]]
            slopes = [value for value in slopes if value is not None]
            if not slopes or any(abs(value - slopes[0]) > 1e-30 or abs(value - mp_round(value)) > 1e-30
                                 for value in slopes):
                return None
            if mp_round(slopes[0]):
                found.append((("v", name, 0), mp_round(slopes[0])))
        return found if found and self.is_direction(arguments, frames, found) else None

    def turning(self, variable, arguments, frames, companion):
        """The derivative of the angle of a vector by a declared angle."""
        first = companion.within(Frame.of("d", [(variable, None)]))
        inner = first.nested(frames)
        try:
            x, y = (self.scalar(argument, inner) for argument in arguments)
        except NoValue:
            return None
        (x, dx), (y, dy) = (parts(value, first.level) for value in (x, y))
        size = x * x + y * y
        return None if is_zero(size) else (x * dy - y * dx) / size

    def is_direction(self, arguments, frames, combination):
        """Whether a vector points along a sum of declared angles, or against it, in general."""
        compared = 0
        for companion in self.companions:
            try:
                x, y = (constant(self.scalar(argument, companion.nested(frames))) for argument in arguments)
            except NoValue:
                continue
            angle = sum(n * companion.base.variable(variable) for variable, n in combination)
            compared += 1
            if not is_zero(x * series.sine(angle) - y * series.cosine(angle)):
                return False
        return compared > 0

    def occurs(self, name, arguments, frames):
        """Whether a name occurs in expressions or in what replaces names within frames."""
        inside = list(arguments) + [e for frame in frames for e in frame.variables.values() if e is not None]
        inside += [e for frame in frames for _, e in frame.functions if e is not None]
        return any(name in self.names_in(part) for part in inside)

    def names_in(self, part):
        """All names in an expression, through definitions, too."""
        if part not in self.occurring:
            self.occurring[part] = set()
            found = set()
            for name in own_names(part):
                found.add(name)
                if name in self.document.definitions:
                    found |= self.names_in(self.document.definitions[name])
                if name in self.document.templates:
                    found |= self.names_in(self.document.templates[name][1])
                if name in self.document.substitutions:
                    for _, e in self.document.substitutions[name]:
                        found |= self.names_in(e)
                declared = self.document.variables.get(name)
                if declared is not None and declared.argument is not None:
                    found |= self.names_in(declared.argument)
            self.occurring[part] = found
        return self.occurring[part]

    def coefficients(self, polynomial, variable, context):
        """All coefficients, by an expansion about some place; it must have a value at its own."""
        self.value(polynomial, context)
        for shift in SHIFTS:
            try:
                return self.coefficients_about(shift, polynomial, self.variable(variable), context)
            except NoValue:
                continue
        raise Unknown("a polynomial without values at other places")

    def coefficients_about(self, shift, polynomial, variable, context):
        """The same about this place."""
        about = self.value(shift, context)
        for order in (6, 14, 30):
            inner = context.within(Frame.of("shift", [(variable, shift)], order))
            terms = self.scalar(polynomial, inner)
            terms = terms.terms if series.level(terms) == inner.level else [terms] + [mpf(0)] * order
            if all(series.is_null(term) for term in terms[order - 1:]):
                return [total(multiply(terms[k], comb(k, n) * (-about) ** (k - n)) for k in range(n, order + 1))
                        for n in range(order + 1)] + [mpf(0)] * 64
        raise Unknown("not a polynomial, or one of a high degree")

    def degree(self, polynomial, variable, context):
        """The degree of a polynomial in general, as a function of the variables that it is."""
        key = (polynomial, variable)
        if key not in self.degrees:
            found = []
            for companion in self.companions[:3]:
                try:
                    terms = self.coefficients(polynomial, variable, companion)
                except NoValue:
                    continue
                found.append(max((n for n, term in enumerate(terms) if not is_zero(term)), default=-1))
            self.degrees[key] = max(found, default=-1)
        if self.degrees[key] < 0:
            raise Unknown("the degree of a polynomial that is 0")
        return self.degrees[key]


def perturbed(value, frame, level):
    """A variable with a small quantity added, or times one."""
    if frame.kind == "d":
        return Series(level, [value, mpf(1)])
    return Series(level, [mpf(0), value] + [mpf(0)] * (frame.order - 1) if frame.order else [mpf(0)])


def slope(value, level):
    """The coefficient of the small quantity."""
    return value.terms[1] if series.level(value) == level else mpf(0)


def parts(value, level):
    """The number in a value and that of its slope at a low level."""
    while series.level(value) > level:
        value = value.terms[0]
    return constant(value), constant(slope(value, level))


def mp_round(value):
    """The nearest whole number."""
    return int(series.mp.nint(value.real))


def rated(name, dots):
    """The time derivative of what is no variable."""
    found = node("name", name, 0, 0)
    for _ in range(dots):
        found = node("call", "dt", found)
    return found


def exact(part):
    """The exact number that an expression of numbers is."""
    kind = part.kind
    if kind == "number":
        return part.parts[0]
    if kind == "negate":
        return -exact(part.parts[0])
    if kind in ("add", "subtract", "multiply", "divide", "power"):
        a, b = (exact(inner) for inner in part.parts)
        return {"add": lambda: a + b, "subtract": lambda: a - b, "multiply": lambda: a * b,
                "divide": lambda: a / b, "power": lambda: a ** int(b)}[kind]()
    raise Mistake("an exact number is wanted")


def own_names(part, found=None):
    """The names that stand in an expression."""
    found = set() if found is None else found
    for inner in part.parts:
        if isinstance(inner, Node):
            own_names(inner, found)
        elif isinstance(inner, tuple):
            for pair in inner:
                for one in pair if isinstance(pair, tuple) else (pair,):
                    own_names(one, found)
        elif isinstance(inner, str) and part.kind in ("name", "applied", "at named", "solution"):
            found.add(inner)
    return found


def written(part, values):
    """An expression with expressions in place of names."""
    if not isinstance(part, Node):
        if isinstance(part, tuple):
            return tuple(written(inner, values) for inner in part)
        return part
    if part.kind == "name" and part.parts[0] in values:
        found = values[part.parts[0]]
        for _ in range(part.parts[1]):
            found = node("call", "dt", found)
        return found
    return node(part.kind, *(written(inner, values) for inner in part.parts))
