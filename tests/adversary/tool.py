"""The tool as a process: a document goes in, its report comes out, within limits."""

import json
import os
import re
import resource
import signal
import subprocess
import tempfile

# Of the processor: how much else the machine has to do must not count.
SECONDS, BYTES = 10, 1 << 30
PATIENCE = 20 * SECONDS
DONE, REFUSED, ABORTED, LATE = "done", "refused", "aborted", "late"


class Run:
    """How one audit went: its outcome, the reports of claims by label, and what was said."""

    def __init__(self, outcome, reports=None, said="", lines=()):
        self.outcome, self.reports, self.said, self.lines = outcome, reports or {}, said, lines


class Tool:
    """The command under test."""

    def __init__(self, command, folder=None):
        self.command = os.path.abspath(command)
        self.folder = folder or tempfile.mkdtemp(prefix="adversary-")
        self.refused = []

    def audit(self, text, imports=(), name="document.md"):
        """The run on a text, beside the documents that it imports."""
        for other, content in imports:
            self.write(other, content)
        path = self.write(name, text)
        try:
            done = subprocess.run(
                [self.command, "audit", "--format", "json", path], capture_output=True, timeout=PATIENCE,
                preexec_fn=limit, cwd=self.folder, env={**os.environ, "NO_COLOR": "1"}, check=False)
        except subprocess.TimeoutExpired:
            return Run(LATE)
        said = done.stderr.decode("utf-8", "replace")
        if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
            return Run(LATE)
        if done.returncode not in (0, 1, 2):
            return Run(ABORTED, said=said or f"status {done.returncode}")
        try:
            documents = json.loads(done.stdout)["documents"]
        except (ValueError, KeyError):
            return Run(ABORTED, said="no JSON: " + said)
        lines = [] if done.returncode != 2 else [int(line) for line in re.findall(rf"\[ [^\]\n]*?{re.escape(name)}:(\d+):\d+ \]", said)]
        found = [claim for document in documents for claim in document.get("claims", [])]
        if not documents or (not found and done.returncode == 2):
            return Run(ABORTED if "two routes" in said else REFUSED, said=said, lines=lines)
        return Run(DONE, {claim["label"]: claim for claim in found}, said, lines)

    def matchings(self, name="document.md"):
        """The matchings of the document that was audited last."""
        try:
            done = subprocess.run([self.command, "match", "--format", "json", os.path.join(self.folder, name)],
                                  capture_output=True, timeout=PATIENCE, preexec_fn=limit, check=False)
            return json.loads(done.stdout)["matchings"]
        except (subprocess.TimeoutExpired, ValueError, KeyError):
            return []

    def write(self, name, text):
        """A file in the folder of the runs."""
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        return path


def limit():
    """The memory and the time of the processor that the tool may take."""
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
