"""A wrong verdict with as little around it as shows it."""

import re

import reader
from judgement import WRONG, judged
from oracle import Oracle
from syntax import Unreadable
from tool import DONE

ATTEMPTS = 60


class Reduction:
    """Drops statements, then parts of the claim, as long as the same verdict stays wrong."""

    def __init__(self, tool, document, label, verdict, assignments):
        self.tool, self.document, self.label, self.verdict = tool, document, label, verdict
        self.assignments, self.left = assignments, ATTEMPTS

    def smallest(self, head, line):
        """The text of the small document."""
        for other in list(reversed(head)):
            rest = [kept for kept in head if kept is not other]
            if self.is_wrong(rest, line):
                head = rest
        return self.document.text(head + [self.simplest(head, line)])

    def simplest(self, head, line):
        """The claim with what stands in brackets made simple."""
        tried = set()
        while self.left > 0:
            shorter = next((text for text in simpler(line) if text not in tried and not tried.add(text)
                            and self.spend() and self.is_wrong(head, text)), None)
            if shorter is None:
                return line
            line = shorter
        return line

    def spend(self):
        """Whether another attempt is left."""
        self.left -= 1
        return self.left >= 0

    def is_wrong(self, head, line):
        """Whether the verdict on a claim is the same and wrong."""
        text = self.document.text(head + [line])
        run = self.tool.audit(text, self.document.imports)
        report = run.reports.get(self.label)
        if run.outcome != DONE or report is None or report["verdict"] != self.verdict:
            return False
        try:
            oracle = Oracle(reader.read(self.tool.write("document.md", text)), "reduced")
            claim = next(claim for claim in oracle.document.claims if claim.label == self.label)
            return oracle.satisfiable() and judged(oracle, claim, report, self.assignments).result == WRONG
        except (Unreadable, StopIteration):
            return False


def simpler(line):
    """Texts with a bracket and the name before it replaced by a name or a number, the longest first."""
    label_end = line.index(":") + 1 if ":" in line else 0
    found = []
    for place in range(label_end, len(line)):
        if line[place] == "(" and (end := closing(line, place)):
            start = place - len(re.search(r"[\w']*$", line[label_end:place]).group())
            if line[:start].rstrip().endswith(" at"):
                start = line[:start].rstrip().rindex(" at")
                found.append((end - start, line[:start] + line[end + 1:]))
                continue
            found += [(end - start, line[:start] + new + line[end + 1:]) for new in ("1", "x", "k")]
            found.append((0, line[:start] + line[place + 1:end] + line[end + 1:]))
    return [text for _, text in sorted(found, key=lambda item: -item[0])]


def closing(line, place):
    """The place of the bracket that closes one."""
    depth = 0
    for end in range(place, len(line)):
        depth += {"(": 1, ")": -1}.get(line[end], 0)
        if depth == 0:
            return end
    return None
