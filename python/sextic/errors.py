"""What is wrong with what was asked, in the words of the command."""

from __future__ import annotations

__all__ = ["DocumentError", "Error", "InputError"]


class Error(Exception):
    """The family of all exceptions of this package.

    ``message`` says what is wrong, and ``help`` what to do about it (it may be empty).
    """

    def __init__(self, message: str, help: str | None = None) -> None:
        super().__init__(message, help)
        self.message = message
        self.help = help or ""

    def __str__(self) -> str:
        return f"{self.message}\nHelp: {self.help}" if self.help else self.message


class InputError(Error, ValueError):
    """A name, an array, a number or a file that cannot be used."""


class DocumentError(Error):
    """A mistake in a document, with its place.

    ``path``, ``line`` and ``column`` (both from 1, the column in characters) are where, ``kind`` is its code, and
    ``shown`` the text of the command, with the line marked.
    """

    def __init__(
        self, message: str, help: str | None, path: str, line: int, column: int, kind: str, shown: str
    ) -> None:
        super().__init__(message, help)
        self.args = (message, help, path, line, column, kind, shown)
        self.path, self.line, self.column = path, line, column
        self.kind, self.shown = kind, shown

    def __str__(self) -> str:
        return self.shown.rstrip()
