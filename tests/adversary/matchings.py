"""What the oracle says of a matching: whether its solution is right, and finite where that is said."""

from mpmath import mpf

import series
from frame import Context
from judgement import OPEN, RIGHT, WRONG, Judgement
from assignment import equal
from matrices import rows
from series import Mistake, NoValue, Unknown, constant, is_zero
from syntax import Unreadable, expression, node

STEPS = tuple(mpf(10) ** -n for n in (8, 12, 16, 20))


def judged(oracle, report, count):
    """The judgement of one matching of a report."""
    name = report["name"]
    try:
        solution = [expression(report["solution"][unknown]) for unknown in report["unknowns"]]
        found = solved(oracle, name, solution, count)
        factors = [expression(singularity["factor"]) for singularity in report["singularities"]]
        for factor, singularity in zip(factors, report["singularities"]):
            if found.result == RIGHT and singularity["finite"]:
                found = finite(oracle, name, factor, [other for other in factors if other != factor], count)
        return found
    except (Unreadable, Mistake, KeyError) as reason:
        return Judgement("matching", OPEN, f"unreadable: {reason}")


def values(oracle, name, assignment):
    """The unknowns at an assignment, by the oracle."""
    return [constant(line[0]) for line in rows(oracle.evaluator.value(node("solutions", name), Context(assignment)))]


def solved(oracle, name, solution, count):
    """Whether the solution is that of the equations, at every assignment at which both have values."""
    seen = 0
    for assignment in oracle.sampler.pooled(count):
        try:
            own = values(oracle, name, assignment)
            shown = [constant(oracle.evaluator.scalar(part, Context(assignment))) for part in solution]
            seen += 1
            if not all(equal(one, other) for one, other in zip(own, shown)):
                return Judgement("matching", WRONG, f"another solution at {assignment.shown()}")
        except (NoValue, Unknown):
            continue
    return Judgement("matching", RIGHT if seen else OPEN, "" if seen else "never solved")


def finite(oracle, name, factor, others, count):
    """Whether the solution stays finite beside the places at which a factor vanishes, and no other one does."""
    for assignment in oracle.sampler.pooled(count):
        for variable in list(assignment.values):
            place = oracle.zero(factor, (), assignment, variable)
            there = None if place is None else assignment.changed(variable, place)
            if there is None or not oracle.sampler.satisfies(there) or any(vanishes(oracle, other, there) for other in others):
                continue
            if grows(oracle, name, assignment, variable, place):
                return Judgement("matching", WRONG, f"not finite where {factor} vanishes: {variable[1]} = "
                                 f"{series.mp.nstr(place, 12)} at {assignment.shown()}")
    return Judgement("matching", RIGHT)


def vanishes(oracle, factor, assignment):
    """Whether a factor is 0, or has no value, at an assignment."""
    try:
        return is_zero(constant(oracle.evaluator.scalar(factor, Context(assignment))))
    except (NoValue, Unknown):
        return True


def grows(oracle, name, assignment, variable, place):
    """Whether a solution grows on the way to a place."""
    for side in (1, -1):
        sizes = []
        for step in STEPS:
            near = assignment.changed(variable, place + side * step)
            if not oracle.sampler.satisfies(near):
                break
            try:
                sizes.append(max(abs(value) for value in values(oracle, name, near)))
            except (NoValue, Unknown, Mistake):
                break
        if len(sizes) == len(STEPS) and all(b > 30 * a for a, b in zip(sizes, sizes[1:])):
            return True
    return False
