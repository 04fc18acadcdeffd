"""Verdicts that are known to be wrong, and some that are right: the oracle must tell them apart."""

import sys

import matchings
import reader
from judgement import RIGHT, WRONG, judged
from oracle import Oracle

REAL = "parameter a, b, c, s, x, y : 1\nimaginary i\n"
ANGLES = "angle α, β\ncoordinate θ : rad\nparameter k : 1 > 0\n"
FUNCTION = REAL + ANGLES + "function F at a : 1\nfunction C at α : 1\n"
KNOWN = [
    # A condition is lost where a real name becomes complex.
    (WRONG, REAL, "claim (1): ((1/(x^2 + 9)) at (x = i*y))*(9 - y^2) == 1", "holds", []),
    (RIGHT, REAL, "claim (1): ((1/(x^2 + 9)) at (x = i*y))*(9 - y^2) == 1", "holds where", ["y**2 - 9 != 0"]),
    (WRONG, REAL, "claim (1): (sqrt((x^2 + 10^10)^2) at (x = i*y)) == 10^10 - y^2", "holds", []),
    (WRONG, REAL, "claim (1): angle(x, i)^2 >= 0", "holds where", ["x**2 - 1 > 0"]),
    (WRONG, FUNCTION, "claim (1): (F(x) at (x = i*y)) == F(i*y)", "holds", []),
    (WRONG, REAL, "claim (1): (x^2 at (x = y + i)) >= 0", "holds", []),
    (RIGHT, "complex λ : 1\n", "claim (1): (λ + 1)/(λ + 1) == 1", "holds where", ["lamda + 1 != 0"]),
    (WRONG, "complex λ : 1\n", "claim (1): sqrt(λ)^2 == λ", "holds where", ["lamda != 0"]),
    # Conditions are lost by cancellation, a factor 0, an expansion, a derivative.
    (WRONG, REAL, "claim (1): 0*(a/b) == 0", "holds", []),
    (WRONG, REAL, "claim (1): (a^2 - b^2)/(a - b) == a + b", "holds", []),
    (RIGHT, REAL, "claim (1): (a^2 - b^2)/(a - b) == a + b", "holds where", ["a - b != 0"]),
    (WRONG, REAL, "claim (1): truncate(x/(y + x), [x], 1) == x/y", "holds", []),
    (WRONG, REAL, "claim (1): d(x/y, x) == 1/y", "holds where", ["x != 0"]),
    (WRONG, ANGLES, "claim (1): tan(α)*cot(α) == 1", "holds where", ["cos(alpha) != 0"]),
    (RIGHT, REAL, "claim (1): [a, b]*kernel([a, b]) == 0", "holds where", ["a != 0"]),
    (WRONG, REAL, "claim (1): [a, b]*kernel([a, b]) == 0", "holds", []),
    (RIGHT, REAL, "claim (1): (a at (b = 1/c)) == a", "holds", []),
    # Signs are those of reals, and of roots.
    (WRONG, REAL, "claim (1): sqrt(x^2) == x", "holds", []),
    (RIGHT, REAL + "assume x > 0\n", "claim (1): sqrt(x^2) == x", "holds", []),
    (WRONG, ANGLES, "claim (1): angle(k*cos(α), -k*sin(α)) == α", "holds", []),
    (RIGHT, ANGLES, "claim (1): angle(k*cos(2*α + β), k*sin(2*α + β)) == 2*α + β", "holds", []),
    (WRONG, REAL + ANGLES, "claim (1): angle(x*cos(α), x*sin(α)) == α", "holds where", ["x != 0"]),
    # Points that no assignment has.
    (WRONG, ANGLES + "assume 0 < α\nassume α < 1/3\n", "claim (1): cos(α) > sin(α)", "refuted", {"cos(alpha)": "-3/5", "sin(alpha)": "4/5"}),
    (WRONG, ANGLES, "claim (1): sin(θ)^2 <= θ^2", "refuted", {"theta": "1/2", "sin(theta)": "4/5", "cos(theta)": "3/5"}),
    (RIGHT, ANGLES, "claim (1): cos(α) > sin(α)", "refuted", {"cos(alpha)": "-3/5", "sin(alpha)": "4/5"}),
    (WRONG, REAL + "assume a < b\n", "claim (1): a^2 < b^2", "refuted", {"a": "2", "b": "1"}),
    (RIGHT, REAL + "assume a < b\n", "claim (1): a^2 < b^2", "refuted", {"a": "-2", "b": "1"}),
    (WRONG, FUNCTION, "claim (1): F(b)*F(b + c - c) + 1 > F(b)", "refuted", {"b": "2", "F(2)": "-3", "F(b)": "3"}),
    (RIGHT, FUNCTION, "claim (1): F(2*b) == 2*F(b)", "refuted", {"b": "1", "F(2*b)": "3", "F(b)": "2"}),
    # Coincidences at points: arguments, degrees, directions.
    (WRONG, FUNCTION, "claim (1): (F(b) at (F = s))*F(b) + 1 > F(b)", "refuted", {"b": "-1"}),
    (RIGHT, FUNCTION, "claim (1): (F(b) at (F = s)) == F(b)", "holds", []),
    (WRONG, FUNCTION, "claim (1): (F(b) at (F = s)) == s", "holds", []),
    (RIGHT, FUNCTION, "claim (1): (d(F, a) at (F' = 2)) == 2", "holds", []),
    (WRONG, REAL, "claim (1): s*hurwitz((a - b)*x^2 + s*x + c, x, 1) + 1 > s", "refuted", {"s": "-2"}),
    (RIGHT, REAL, "claim (1): hurwitz((a - b)*x^2 + s*x + c, x, 1) == s", "holds", []),
    (WRONG, FUNCTION, "claim (1): C(sqrt(3)*(sqrt(3)*α))*C(3*α) + 1 > C(3*α)", "refuted", {"C(-6)": "3", "C(3*alpha)": "-3", "alpha": "-2"}),
    (WRONG, FUNCTION, "claim (1): C(angle(k, k)) - C(angle(1, 1)) <= 1", "refuted", {"k": "1", "C(direction 0)": "3", "C(direction 1)": "-3"}),
    # Orders.
    (WRONG, ANGLES, "approximate (1): sqrt(1 + sin(2*α)) ≈ cos(α) + sin(α) to order 1 in α", "approximate", []),
    (RIGHT, ANGLES, "approximate (1): sin(θ) ≈ θ to order 2 in θ", "approximate", []),
    (WRONG, ANGLES, "approximate (1): sin(θ) ≈ θ to order 3 in θ", "approximate", []),
    (WRONG, REAL, "approximate (1): x/(y + x) ≈ x/y to order 1 in x", "approximate", []),
    (RIGHT, REAL, "approximate (1): 1/(1 - x) ≈ 1 + 2*x to order 1 in x", "refuted", {"x": "3"}),
    (WRONG, REAL, "approximate (1): 1/(1 - x) ≈ 1 + x to order 1 in x", "refuted", {"x": "3"}),
    # Units and shapes.
    (WRONG, REAL + "parameter L : m\n", "claim (1): L == L^2/(x*L)", "ill-formed", []),
    (RIGHT, REAL + "parameter L : m\n", "claim (1): L == L^2", "ill-formed", []),
    (WRONG, REAL + "parameter L : m\n", "claim (1): L == L^2", "refuted", {"L": "3"}),
    (WRONG, REAL, "claim (1): [a; b] == [a; b]", "ill-formed", []),
]
MATCHED = [
    (WRONG, "match (1) m: x + s with x + sin(α)*a in x unknown a at 1", "s/sin(alpha)", "sin(alpha)"),
    (RIGHT, "match (1) m: x + sin(α)*s with x + sin(α)*a in x unknown a at 1", "s", "sin(alpha)"),
    (WRONG, "match (1) m: x + s with x + (b - sqrt(k))*a in x unknown a at 1", "s/(b - sqrt(k))", "b - sqrt(k)"),
    (WRONG, "match (1) m: x + s with x + b*a in x unknown a at 1", "s/c", "c"),
]


def found(head, line, verdict, shown):
    """What the oracle says of a verdict."""
    oracle = Oracle(reader.read_text(f"```sextic\n{head}{line}\n```\n"), 1)
    report = {"verdict": verdict, "conditions": [] if isinstance(shown, dict) else shown,
              "witness": {"point": shown} if isinstance(shown, dict) else None}
    return judged(oracle, oracle.document.claims[0], report, 42)


def found_of_matching(line, solution, factor):
    """What the oracle says of a matching whose solution is said to stay finite."""
    oracle = Oracle(reader.read_text(f"```sextic\n{REAL}{ANGLES}{line}\n```\n"), 1)
    report = {"name": "m", "unknowns": ["a"], "solution": {"a": solution},
              "singularities": [{"factor": factor, "finite": True}]}
    return matchings.judged(oracle, report, 21)


def main():
    """Prints every verdict of which the oracle says something else than what is known."""
    mistakes = 0
    for expected, head, line, verdict, shown in KNOWN:
        result = found(head, line, verdict, shown)
        if result.result != expected:
            mistakes += 1
            print(f"{line}: {verdict} {shown} is {expected}, but the oracle says {result.result}: {result.why}")
    for expected, line, solution, factor in MATCHED:
        result = found_of_matching(line, solution, factor)
        if result.result != expected:
            mistakes += 1
            print(f"{line}: {solution} is {expected}, but the oracle says {result.result}: {result.why}")
    print(f"{len(KNOWN) + len(MATCHED)} known verdicts, {mistakes} misjudged")
    return 1 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
