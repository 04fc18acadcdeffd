"""Values of expressions under an assignment, in the sense of the page of meanings.

An expression is a function of variables. `at`, `d`, `dt`, `truncate` and `coefficient` each put a
frame around what they act on, which replaces some variables, or adds a small quantity to them. A
name is looked up from the innermost frame outwards, and from the last one in the assignment."""

from mpmath import mpf

import matrices
import series
from built_in import BuiltIn
from directions import Directions
from frame import Context, Frame, slope
from matrices import entrywise, matrix, rows
from polynomials import Polynomials
from series import Mistake, NoValue, Unknown, add, negate, subtract
from syntax import node, number
from variables import Variables
from writing import exact, rated, written


class Evaluator(BuiltIn, Variables, Directions, Polynomials):
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
