"""Judges the verdicts on documents of one's own: `check.py --command PATH DOCUMENT…`."""

import argparse
import os
import sys

import matchings
import reader
from judgement import WRONG, judged
from oracle import Oracle
from tool import DONE, Tool


def main():
    """Prints the judgement of every verdict; the status is 1 if one is wrong."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--command", required=True)
    parser.add_argument("--assignments", type=int, default=42)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("documents", nargs="+")
    options = parser.parse_args()
    wrong = sum(check(path, options) for path in options.documents)
    print(f"{wrong} wrong")
    return 1 if wrong else 0


def check(path, options):
    """The number of wrong verdicts on one document."""
    with open(path, encoding="utf-8", newline="") as file:
        text = file.read()
    folder = os.path.dirname(os.path.abspath(path))
    tool = Tool(options.command)
    for other in os.listdir(folder):
        if other.endswith(".md") and os.path.isfile(os.path.join(folder, other)):
            with open(os.path.join(folder, other), encoding="utf-8", newline="") as file:
                tool.write(other, file.read())
    run = tool.audit(text, name=os.path.basename(path))
    print(f"{path}: {run.outcome}{' ' + run.said[:300] if run.outcome != DONE else ''}")
    oracle = Oracle(reader.read(path), options.seed)
    wrong = 0
    for claim in oracle.document.claims if run.outcome == DONE else []:
        if claim.label in run.reports:
            found = judged(oracle, claim, run.reports[claim.label], options.assignments)
            print(f"  {claim.label}: {found.verdict}: {found.result} {found.truth or ''} {found.why[:400]}")
            wrong += found.result == WRONG
    for report in tool.matchings(os.path.basename(path)) if oracle.document.matchings else []:
        found = matchings.judged(oracle, report, options.assignments)
        print(f"  {report['name']}: matching: {found.result} {found.why[:400]}")
        wrong += found.result == WRONG
    return wrong


if __name__ == "__main__":
    sys.exit(main())
