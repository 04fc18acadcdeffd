"""Where the tests find documents, and the command beside which the package must say the same."""

import json
import os
import subprocess
from pathlib import Path

import pytest

import sextic

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def at_the_root(monkeypatch):
    """Documents and cases are named from the folder of the project."""
    monkeypatch.chdir(ROOT)


@pytest.fixture(scope="session")
def command():
    """Runs the command, and reads what it writes as JSON or as text."""
    path = os.environ["SEXTIC"]

    def run(*arguments, is_json=True):
        done = subprocess.run([path, *arguments], cwd=ROOT, capture_output=True, text=True, env={"NO_COLOR": "1"})
        run.error = done.stderr
        return json.loads(done.stdout) if is_json and done.stdout else done.stdout

    return run


@pytest.fixture(scope="session")
def paper():
    """The document about the paper, audited once."""
    return sextic.audit(str(ROOT / "derivations/he-macdonald-2017.md"))


@pytest.fixture(scope="session")
def audits(paper):
    """All documents that come with the program, audited once."""
    others = [sextic.audit(str(ROOT / path)) for path in sextic.documents()[1:]]
    return [paper, *others]
