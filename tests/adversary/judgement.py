"""What the oracle says of each verdict of a report: right, wrong and why, or not known."""

from series import Mistake, NoValue, Unknown
from syntax import Unreadable
from units import Units
from witness import CONFIRMED, EQUAL, Point

RIGHT, WRONG, OPEN = "right", "wrong", "open"


class Judgement:
    """A verdict of the tool and what the oracle says of it."""

    def __init__(self, verdict, result, why="", truth=None):
        self.verdict, self.result, self.why, self.truth = verdict, result, why, truth


def judged(oracle, claim, report, count):
    """The judgement of one verdict, by as many assignments as are counted, and those at edges."""
    verdict = report["verdict"]
    try:
        if verdict == "skipped":
            return Judgement(verdict, OPEN)
        if verdict == "undecided":
            return Judgement(verdict, OPEN, truth=truth(oracle, claim, count // 2))
        if verdict == "ill-formed":
            return ill_formed(oracle, claim)
        wrong = fitting(oracle, claim)
        if wrong:
            return Judgement(verdict, WRONG, wrong)
        if verdict in ("holds", "holds where"):
            return holds(oracle, claim, report, count)
        if verdict == "refuted":
            return refuted(oracle, claim, report)
        if verdict == "approximate":
            return approximate(oracle, claim, report, count)
    except (Unreadable, Mistake) as reason:
        return Judgement(verdict, OPEN, f"unreadable: {reason}")
    except Unknown as reason:
        return Judgement(verdict, OPEN, f"unknown: {reason}")
    return Judgement(verdict, OPEN, "an unknown verdict")


def fitting(oracle, claim):
    """Why a claim should have been ill-formed, or nothing."""
    try:
        if not Units(oracle.evaluator).fit(claim):
            return "the units or shapes of the sides do not fit"
    except (Unknown, Mistake, KeyError, IndexError):
        pass
    return None


def ill_formed(oracle, claim):
    """Units or shapes must not fit; a side that is 0 fits all."""
    if Units(oracle.evaluator).fit(claim):
        return Judgement("ill-formed", WRONG, "the units and the shapes of the sides fit")
    return Judgement("ill-formed", RIGHT)


def holds(oracle, claim, report, count):
    """At every assignment with the conditions, both sides have values, in the stated order."""
    conditions = oracle.conditions(report["conditions"])
    seen, open_why = 0, ""
    for assignment in oracle.assignments(claim, conditions, count):
        if not oracle.satisfied(conditions, assignment):
            continue
        finding = oracle.judge(claim, assignment)
        if finding.what in ("false", "none"):
            why = f"{finding.what}: {finding.why} at {assignment.shown()}"
            return Judgement(report["verdict"], WRONG, why)
        seen += finding.what == "true"
        open_why = finding.why if finding.what == "unknown" else open_why
    if not seen:
        return Judgement(report["verdict"], OPEN, open_why or "no assignment satisfies the conditions")
    return Judgement(report["verdict"], RIGHT)


def refuted(oracle, claim, report):
    """The witness must be an assignment at which the sides differ."""
    witness = report.get("witness")
    if not witness:
        return Judgement("refuted", WRONG, "no witness is shown")
    point = Point(oracle, witness["point"])

    def differs(assignment):
        if claim.order is not None:
            return terms_differ(oracle, claim, assignment)
        finding = oracle.judge(claim, assignment)
        return {"false": CONFIRMED, "true": EQUAL}.get(finding.what, f"{finding.what}: {finding.why}")

    result = point.check(differs)
    if result == CONFIRMED:
        return Judgement("refuted", RIGHT)
    why = f"{result} at {witness['point']}"
    seems = truth(oracle, claim, 10)
    if point.unread and seems != "true" or result.startswith("unknown"):
        return Judgement("refuted", OPEN, f"{why}; not read: {point.unread}", seems)
    return Judgement("refuted", WRONG, why, seems)


def terms_differ(oracle, claim, assignment):
    """Whether two terms of a degree up to the order differ."""
    try:
        agree = oracle.expansion(claim, assignment, beyond=0)
    except NoValue as reason:
        return f"none: {reason}"
    except (Unknown, Mistake) as reason:
        return f"unknown: {reason}"
    return EQUAL if all(agree) else CONFIRMED


def approximate(oracle, claim, report, count):
    """The terms must agree up to the order, and some beyond must differ."""
    if claim.order is None:
        return Judgement("approximate", WRONG, "the claim is no approximation")
    conditions = oracle.conditions(report["conditions"])
    seen = differ = 0
    for assignment in oracle.assignments(claim, conditions, count):
        if not oracle.satisfied_without(conditions, assignment, claim.small):
            continue
        try:
            agree = oracle.expansion(claim, assignment, beyond=0 if differ else 6)
        except NoValue as reason:
            return Judgement("approximate", WRONG, f"no values: {reason} at {assignment.shown()}")
        except Unknown:
            continue
        seen += 1
        if not all(agree[:claim.order + 1]):
            return Judgement("approximate", WRONG, f"terms {agree} at {assignment.shown()}")
        differ += not all(agree)
    if not seen:
        return Judgement("approximate", OPEN, "no assignment satisfies the conditions")
    if not differ:
        return Judgement("approximate", WRONG, "no term beyond the order was found up to six more")
    return Judgement("approximate", RIGHT)


def truth(oracle, claim, count):
    """What a claim seems to be: true, false, without values, or not known."""
    seen = set()
    try:
        if fitting(oracle, claim):
            return "ill-formed"
        for assignment in oracle.assignments(claim, [], count):
            if claim.order is not None:
                seen.add(tried(oracle, claim, assignment))
            else:
                seen.add(oracle.judge(claim, assignment).what)
    except (Unknown, Mistake):
        return "unknown"
    if "false" in seen:
        return "false"
    return "true" if "true" in seen else "without values" if "none" in seen else "unknown"


def tried(oracle, claim, assignment):
    """Whether the terms of an approximation agree at an assignment."""
    try:
        return "true" if all(oracle.expansion(claim, assignment, beyond=0)) else "false"
    except NoValue:
        return "none"
    except (Unknown, Mistake):
        return "unknown"
