"""Looks for wrong verdicts: `adversary.py --seed S --count N --command PATH`.

Random documents of many claims go through the tool; an oracle that shares no code with it judges
each verdict at many assignments. Printed are each wrong verdict with a small document, and a table."""

import argparse
import collections
import multiprocessing
import os
import random
import shutil
import sys
import time
import traceback

import documents
import matchings
import reader
from judgement import OPEN, WRONG, judged
from oracle import Oracle
from reduction import Reduction
from syntax import Unreadable
from tool import ABORTED, DONE, LATE, REFUSED, Tool

CLAIMS = 40


class Found:
    """What was found in one document."""

    def __init__(self):
        self.table, self.wrong, self.notes = collections.Counter(), [], collections.Counter()


class Session:
    """The tool under test and how it is tested."""

    def __init__(self, options):
        self.options = options
        self.complex_names = self.knows_complex_names()

    def knows_complex_names(self):
        """Whether the tool reads declarations of complex names."""
        tool = Tool(self.options.command)
        text = "# A\n\n```sextic\ncomplex λ : 1\nclaim (1): λ == λ\n```\n"
        try:
            return tool.audit(text).outcome == DONE
        finally:
            shutil.rmtree(tool.folder)

    def document(self, number):
        """Everything about the document of this number."""
        seed = f"{self.options.seed}:{number}"
        document = documents.drawn(random.Random(seed), CLAIMS, self.complex_names)
        tool, found = Tool(self.options.command), Found()
        try:
            self.audit(tool, document, found, seed)
        except Exception:  # One document must not end a run of hours; it counts as a failure.
            found.wrong.append(("the oracle failed", "", traceback.format_exc(limit=-4), seed, ()))
        finally:
            shutil.rmtree(tool.folder)
        return found

    def audit(self, tool, document, found, seed):
        """Runs a document, without the statements that are refused, and judges its verdicts."""
        claims = {claim.line: claim for claim in document.claims}
        lines = document.head + list(claims)
        while lines:
            run = tool.audit(document.text(lines), document.imports)
            if run.outcome == DONE and not any(0 <= line - 4 < len(lines) for line in run.lines):
                break
            lines = self.without(tool, document, lines, run, claims, found)
        if lines:
            self.judge(tool, document, lines, run, claims, found, seed)

    def without(self, tool, document, lines, run, claims, found):
        """The lines without those that were refused, that aborted the tool or took too long."""
        bad = sorted({line - 4 for line in run.lines if 0 <= line - 4 < len(lines)})
        if run.outcome == REFUSED:
            bad = bad[:1]
        if bad and run.outcome in (DONE, REFUSED):
            for place in bad:
                found.table[key(claims.get(lines[place]), "refused")] += 1
        else:
            bad = self.culprits(tool, document, lines, run, claims, bad)
            head = [line for line in lines if line not in claims]
            for place in bad:
                found.table[key(claims.get(lines[place]), run.outcome)] += 1
                found.wrong.append((run.outcome, lines[place], run.said[:500],
                                    document.text(head + [lines[place]]), document.imports))
        return [line for place, line in enumerate(lines) if place not in bad]

    def culprits(self, tool, document, lines, run, claims, bad):
        """The places of claims that by themselves abort the tool, or take too long."""
        if bad:
            return bad[:1]
        head = [line for line in lines if line not in claims]
        alone = [place for place, line in enumerate(lines) if line in claims
                 and tool.audit(document.text(head + [line]), document.imports).outcome == run.outcome]
        return alone or [len(lines) - 1]

    def judge(self, tool, document, lines, run, claims, found, seed):
        """Judges all verdicts of a run."""
        path = tool.write("document.md", document.text(lines))
        try:
            oracle = Oracle(reader.read(path), seed)
        except (Unreadable, IndexError, ValueError) as reason:
            found.notes[f"unreadable: {reason}"] += 1
            return
        if not oracle.satisfiable():
            found.notes["no assignment satisfies the document"] += 1
            return
        by_label = {claim.label: claim for claim in document.claims}
        for claim in oracle.document.claims:
            report = run.reports.get(claim.label)
            if report is None:
                found.table[key(by_label[claim.label], "refused")] += 1
                continue
            judgement = judged(oracle, claim, report, self.options.assignments)
            self.count(judgement, by_label[claim.label], report, found)
            if judgement.result == WRONG:
                self.report(tool, document, lines, by_label, claim, judgement, report, found)

        for report in tool.matchings() if oracle.document.matchings else []:
            claim = by_label[f"({report['id']})"]
            judgement = matchings.judged(oracle, report, self.options.assignments)
            self.count(judgement, claim, report, found)
            if judgement.result == WRONG:
                text = document.text([line for line in lines if line not in claims] + [claim.line])
                found.wrong.append(("wrong: matching", claim.line, judgement.why, text, document.imports))

    def count(self, judgement, claim, report, found):
        """Counts a judgement in the table."""
        if judgement.result == WRONG:
            found.table[key(claim, "wrong")] += 1
        elif judgement.verdict in ("skipped", "refused"):
            found.table[key(claim, "refused")] += 1
        elif judgement.verdict == "undecided":
            found.table[key(claim, f"undecided, {judgement.truth}")] += 1
            reason = str(report.get("reason"))
            if report.get("fault") or any(word in reason for word in ("disagree", "two routes", "mistake of sextic", "fault of sextic")):
                found.table[key(claim, "routes disagree")] += 1
                found.notes[f"routes disagree: {claim.line}"] += 1
        elif judgement.result == OPEN:
            found.table[key(claim, "open")] += 1
            found.notes[f"open: {judgement.verdict}: {judgement.why[:70]}"] += 1
        else:
            found.table[key(claim, "right")] += 1

    def report(self, tool, document, lines, by_label, claim, judgement, report, found):
        """Keeps a wrong verdict with a small document."""
        own = next(line for line in lines if line == by_label[claim.label].line)
        claims = {c.line for c in document.claims}
        reduction = Reduction(tool, document, claim.label, judgement.verdict, self.options.assignments)
        small = reduction.smallest([line for line in lines if line not in claims], own)
        found.wrong.append((f"wrong: {judgement.verdict}", own, f"{judgement.why[:600]}; conditions {report['conditions']}",
                            small, document.imports))


def key(claim, outcome):
    """A place in the table."""
    return (claim.form, claim.family, outcome) if claim is not None else ("declaration", "", outcome)


def shown(table, title, place):
    """A table of outcomes by form or by family."""
    rows = sorted({kind[place] for kind in table if kind[2] != "declaration"})
    columns = ["right", "undecided, true", "undecided, false", "undecided, without values", "undecided, unknown",
               "open", "refused", "routes disagree", "wrong", ABORTED, LATE]
    lines = [f"| {title} | claims | " + " | ".join(columns) + " |", "|---" * (len(columns) + 2) + "|"]
    for row in [*rows, "all"]:
        counts = [sum(n for kind, n in table.items() if kind[2] == column and row in (kind[place], "all")) for column in columns]
        lines.append(f"| {row} | {sum(counts) - counts[7]} | " + " | ".join(map(str, counts)) + " |")
    return "\n".join(lines)


def main():
    """Runs documents until as many claims as asked for are judged."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=1000, help="claims")
    parser.add_argument("--command", required=True, help="the path of sextic")
    parser.add_argument("--assignments", type=int, default=21, help="for each claim, besides those at edges")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="the number of the first document")
    parser.add_argument("--verbose", action="store_true", help="also prints what was left open")
    options = parser.parse_args()
    session, start = Session(options), time.time()
    numbers = range(options.first, options.first + -(-options.count // CLAIMS))
    table, notes, wrong = collections.Counter(), collections.Counter(), 0
    with multiprocessing.Pool(options.jobs) as pool:
        for number, found in zip(numbers, pool.imap(session.document, numbers)):
            table.update(found.table)
            notes.update(found.notes)
            for what, line, why, text, imports in found.wrong:
                wrong += 1
                print(f"\n{what} (document {number}): {line}\n{why}\n{text}", *(content for _, content in imports), flush=True)
    if options.verbose:
        print("\n".join(f"{n} {note}" for note, n in notes.most_common(60)))
    print(f"\n{shown(table, 'form', 0)}\n\n{shown(table, 'family', 1)}")
    print(f"\n{wrong} wrong, aborted or late; seed {options.seed}; {time.time() - start:.0f} s")
    return 1 if wrong else 0


if __name__ == "__main__":
    os.environ.setdefault("PYTHONDONTWRITEBYTECODE", "1")
    sys.exit(main())
