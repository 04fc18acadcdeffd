"""What is true of a claim, by its values at assignments, in the sense of the page of meanings."""

import random

from mpmath import mpf

import matrices
import series
from assignment import Sampler, compared, equal
from frame import Context, Frame
from matrices import rows, shape
from series import Mistake, NoValue, Series, Unknown, constant, is_zero
from syntax import comparison

BEYOND = 6
FOUND = mpf(10) ** -170


class Finding:
    """What a claim is at one assignment: `true`, `false`, `none` (no values) or `unknown`; why."""

    def __init__(self, what, why=""):
        self.what, self.why = what, why


class Oracle:
    """Evaluates the claims of one document."""

    def __init__(self, document, seed):
        self.document, self.random = document, random.Random(seed)
        self.sampler = Sampler(document, self.random)
        self.evaluator = self.sampler.evaluator

    def satisfiable(self):
        """Whether assignments that satisfy everything were found."""
        return len(self.evaluator.companions) >= 3

    def sides(self, claim, assignment, asked=None):
        """The values of both sides; an exception where one has none."""
        context = Context(assignment)
        self.evaluator.asked = asked
        try:
            left = self.evaluator.value(claim.left, context)
            return left, self.evaluator.value(claim.right, context)
        finally:
            self.evaluator.asked = None

    def judge(self, claim, assignment, asked=None):
        """What a claim that is no approximation is at an assignment."""
        try:
            left, right = self.sides(claim, assignment, asked)
            return verdict(left, claim.sign, right)
        except NoValue as reason:
            return Finding("none", str(reason))
        except (Unknown, Mistake) as reason:
            return Finding("unknown", str(reason))

    def expansion(self, claim, assignment, beyond=BEYOND):
        """For each degree whether the terms of both sides agree there, for an approximation."""
        variables = tuple((self.evaluator.variable(small), None) for small in claim.small)
        if any(variable is None for variable, _ in variables):
            raise Mistake("small is what is no variable")
        order = claim.order + beyond
        inner = Context(assignment).within(Frame.of("truncate", variables, order))
        left, right = (self.evaluator.value(side, inner) for side in (claim.left, claim.right))
        if shape(left) != shape(right):
            raise Mistake("shapes do not fit")
        pairs = [pair for lines in zip(rows(left), rows(right)) for pair in zip(*lines)]
        return [all(equal(*(term(side, n) for side in pair)) for pair in pairs) for n in range(order + 1)]

    def difference(self, claim, assignment, degree):
        """The term of one degree in the difference of both sides, of numbers."""
        variables = tuple((self.evaluator.variable(small), None) for small in claim.small)
        inner = Context(assignment).within(Frame.of("truncate", variables, degree))
        left, right = (self.evaluator.scalar(side, inner) for side in (claim.left, claim.right))
        return term(left, degree) - term(right, degree)

    def conditions(self, texts):
        """Conditions as they stand in a report."""
        return [comparison(text) for text in texts]

    def satisfied(self, conditions, assignment):
        """Whether an assignment satisfies all of them."""
        context = Context(assignment)
        return all(self.sampler.holds(condition, context) for condition in conditions)

    def satisfied_without(self, conditions, assignment, small):
        """The same where all small quantities vanish."""
        variables = tuple((self.evaluator.variable(part), None) for part in small)
        context = Context(assignment).within(Frame.of("truncate", variables, 0))
        return all(self.sampler.holds(condition, context) for condition in conditions)

    def assignments(self, claim, conditions, count):
        """Assignments in every manner, then some at which something vanishes, and beside them."""
        found = self.sampler.pooled(count)
        yield from found
        for assignment in found[: max(2, count // 3)]:
            yield from self.edges(claim, conditions, assignment)

    def edges(self, claim, conditions, assignment):
        """Assignments at which something that is asked for vanishes, and some beside them."""
        asked = []
        self.judge(claim, assignment, asked)
        sought = [(part, frames) for _, part, frames in asked]
        sought += [(side, ()) for condition in conditions for side in (condition[0],)]
        variables = [v for v in assignment.values if self.document.variables[v[1]].kind != "complex"]
        if not sought or not variables:
            return
        for _ in range(2):
            part, frames = self.random.choice(sought)
            variable = self.random.choice(variables)
            value = self.zero(part, frames, assignment, variable)
            if value is None:
                continue
            value = mpf(0) if abs(value) < series.NOTHING else value
            for shift in (0, mpf(10) ** -9, -(mpf(10) ** -9)):
                near = assignment.changed(variable, value + shift)
                if self.sampler.satisfies(near):
                    yield near

    def zero(self, part, frames, assignment, variable):
        """A value of a variable at which an expression vanishes, by secants."""
        def at(value):
            context = Context(assignment.changed(variable, value)).nested(frames)
            return series.real(constant(self.evaluator.scalar(part, context)), "a zero")
        try:
            x, y = assignment.variable(variable), assignment.variable(variable) + mpf("0.17")
            fx, fy = at(x), at(y)
            for _ in range(40):
                if abs(fy) < FOUND:
                    return y
                if is_zero(fy - fx):
                    return None
                x, y, fx = y, y - fy * (y - x) / (fy - fx), fy
                if abs(y) > 10 ** 12:
                    return None
                fy = at(y)
            return y if abs(fy) < FOUND else None
        except (NoValue, Unknown, Mistake, ZeroDivisionError):
            return None


def term(value, degree):
    """The term of one degree of an expansion."""
    if isinstance(value, Series):
        return constant(value.terms[degree])
    return value if degree == 0 else mpf(0)


def verdict(left, sign, right):
    """Whether two values are equal, or in the stated order."""
    left, right = plain(left), plain(right)
    if shape(left) != shape(right):
        raise Mistake("shapes do not fit")
    pairs = [pair for lines in zip(rows(left), rows(right)) for pair in zip(*lines)]
    if all(compared(a, sign, b) for a, b in pairs):
        return Finding("true")
    return Finding("false", "; ".join(f"{series.mp.nstr(a, 20)} {sign} {series.mp.nstr(b, 20)}" for a, b in pairs))


def plain(value):
    """A value without small quantities."""
    return matrices.entrywise(constant, value)
