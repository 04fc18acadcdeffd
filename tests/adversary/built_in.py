"""The functions that the language knows."""

from mpmath import mpf

import matrices
import series
from frame import Frame, slope
from matrices import entrywise, matrix, rows, shape
from series import Mistake, NoValue, Unknown, constant, is_zero, subtract, total
from syntax import node, number
from writing import exact


class BuiltIn:
    """The part of an evaluator that knows the built-in functions."""

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
