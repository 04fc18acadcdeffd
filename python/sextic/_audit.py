"""Verdicts on documents."""

from __future__ import annotations

import html
import json
import os
from collections import Counter
from dataclasses import dataclass
from typing import Any, Iterator, Mapping

from . import _sextic
from .errors import DocumentError, InputError
from ._expression import Expression

__all__ = ["Audit", "Claim", "audit", "documents"]


@dataclass(frozen=True)
class Claim:
    """An assertion of a document, and what became of it."""

    id: str
    #: As the document has it: ``(12, printed)``.
    label: str
    line: int
    description: str | None
    #: In ASCII names; ``statement.sympy()`` is it in SymPy.
    statement: Expression
    #: As a person reads it.
    text: str
    latex: str
    #: What the author expects: ``holds``, ``approximate``, ``refuted`` or ``ill-formed``.
    expected: str
    #: ``holds``, ``holds where``, ``approximate``, ``refuted``, ``ill-formed``, ``undecided`` or ``skipped``.
    verdict: str
    as_expected: bool
    #: What the steps needed.
    conditions: tuple[Expression, ...]
    #: What an approximation leaves out, in words, and its leading term.
    neglected: tuple[str, ...]
    residual: Expression | None
    #: Of a refutation, where the sides differ, and both sides there; numbers as text, exactly.
    point: Mapping[str, str] | None
    left: str | None
    right: str | None
    #: Why it is ill-formed, undecided or skipped.
    reason: str | None

    def __str__(self) -> str:
        return "\n    ".join([f"{self.verdict:<12} {self.label} {self.description or ''}".rstrip(), *self._notes()])

    def _notes(self) -> Iterator[str]:
        yield self.text
        if self.conditions:
            yield f"where {', '.join(self.conditions)}"
        if self.point is not None:
            values = ", ".join(f"{name} = {value}" for name, value in self.point.items())
            yield f"at {values}: left {self.left}, right {self.right}"
        if self.reason:
            yield f"because {self.reason}"


class Audit:
    """A document, and the verdict on each of its assertions."""

    def __init__(self, document: _sextic.Document) -> None:
        self._document = document
        found = json.loads(document.json())["documents"][0]
        self.path: str = found["path"]
        self.title: str | None = found["title"]
        #: Whether there is no mistake, and every verdict is the one that the author expects.
        self.as_expected: bool = found["as_expected"]
        #: The assertions, in order.
        self.claims: tuple[Claim, ...] = tuple(
            _claim(own, *written) for own, written in zip(found["claims"], document.statements())
        )
        #: What is wrong with the document and its imports; each costs a statement, and what builds on that.
        self.mistakes: tuple[DocumentError, ...] = tuple(document.mistakes())
        #: The names of what can be compiled, and of the systems.
        self.evaluators: tuple[str, ...] = tuple(document.evaluators())
        self.systems: tuple[str, ...] = tuple(document.systems())

    def __getitem__(self, id: str) -> Claim:
        """The claim of an id or a label: ``found["12-printed"]`` or ``found["(12, printed)"]``."""
        for claim in self.claims:
            if id in (claim.id, claim.label, claim.label.strip("()")):
                return claim
        known = [claim.id for claim in self.claims]
        raise InputError(f"no claim is called `{id}`", _sextic.meant(id, known))

    def __len__(self) -> int:
        return len(self.claims)

    def __iter__(self) -> Iterator[Claim]:
        return iter(self.claims)

    def __str__(self) -> str:
        """The text of the command."""
        return "\n".join([*map(str, self.mistakes), self._document.text(100).rstrip()])

    def __repr__(self) -> str:
        counts = Counter(claim.verdict for claim in self.claims)
        verdicts = ", ".join(f"{count} {verdict}" for verdict, count in counts.items()) or "no claim"
        mistakes = f"; {len(self.mistakes)} mistakes" if self.mistakes else ""
        expected = "as expected" if self.as_expected else "not as expected"
        return f"<Audit of {self.path}: {verdicts}{mistakes}; {expected}>"

    def _repr_html_(self) -> str:
        rows = "".join(_row(claim) for claim in self.claims)
        mistakes = "".join(f"<pre>{html.escape(str(own))}</pre>" for own in self.mistakes)
        return (
            f"<p>{html.escape(self.title or self.path)}</p>{mistakes}"
            f"<table><tr><th>verdict</th><th></th><th>statement</th></tr>{rows}</table>"
        )


def audit(document: str | os.PathLike[str]) -> Audit:
    """Derives every equation of a document again, and gives a verdict on each.

    ``document`` is the path of a Markdown document (what it imports is sought beside it), the path of one that comes
    with the program (see :func:`documents`), or the text of a document, which has more than one line.

    A mistake in a statement is no exception: it is among ``mistakes`` of what is returned, and all else is judged.

    >>> found = audit('''# A spring
    ... ```sextic
    ... parameter m : kg > 0
    ... parameter k : N/m > 0
    ... ω := sqrt(k/m)
    ... claim (1): m*ω^2 == k
    ... ```
    ... ''')
    >>> found["1"].verdict
    'holds'

    Raises :class:`sextic.DocumentError` where nothing of the document can be read, and :class:`sextic.InputError`
    where there is no such file.
    """
    return Audit(read(document))


def documents() -> list[str]:
    """The paths of the documents that come with the program.

    >>> documents()[0]
    'derivations/he-macdonald-2017.md'
    """
    return _sextic.shipped_documents()


def read(document: Audit | str | os.PathLike[str]) -> _sextic.Document:
    """A document that is audited, or was."""
    if isinstance(document, Audit):
        return document._document
    if isinstance(document, str) and "\n" in document:
        return _sextic.audit_text(document)
    path = os.fspath(document)
    if not isinstance(path, str):
        raise InputError("a path is text", "decode it with os.fsdecode")
    if path in documents() and not os.path.exists(path):
        return _sextic.audit_shipped(path)
    return _sextic.audit_file(path)


def _claim(own: dict[str, Any], text: str, latex: str) -> Claim:
    witness = own["witness"] or {}
    return Claim(
        id=own["id"],
        label=own["label"],
        line=own["line"],
        description=own["description"],
        statement=Expression(own["statement"]),
        text=text,
        latex=latex,
        expected=own["expected"],
        verdict=own["verdict"],
        as_expected=own["as_expected"],
        conditions=tuple(map(Expression, own["conditions"])),
        neglected=tuple(own["neglected"]),
        residual=Expression(own["residual"]) if own["residual"] else None,
        point=witness.get("point"),
        left=witness.get("left"),
        right=witness.get("right"),
        reason=own["reason"],
    )


def _row(claim: Claim) -> str:
    notes = "".join(f"<br>{html.escape(note)}" for note in list(claim._notes())[1:])
    name = html.escape(f"{claim.label} {claim.description or ''}")
    return f"<tr><td>{claim.verdict}</td><td>{name}</td><td>${html.escape(claim.latex)}$<small>{notes}</small></td></tr>"
