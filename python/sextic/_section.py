"""Sections with a table of force coefficients."""

from __future__ import annotations

import csv
import io
import os
import warnings
from typing import Any

import numpy as np

from . import _sextic
from .errors import InputError

__all__ = ["Section"]

#: Columns that hold words; all others hold numbers.
_WORDS = {"verdict", "balance", "within_errors"}


class Section:
    """A section in the wind, as a case file says it, with its table of coefficients."""

    def __init__(self, own: _sextic.Section, file: str, table: str) -> None:
        self._own, self._file, self._table = own, file, table

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> "Section":
        """The section of a case file, as ``sextic stability`` takes it; its table is read beside it."""
        case = _sextic.Section(os.fspath(path), _text(path))
        table = os.path.join(os.path.dirname(os.fspath(path)), case.coefficients)
        return cls(case, table, _text(table))

    @classmethod
    def from_table(cls, path: str | os.PathLike[str], table: Any) -> "Section":
        """The section of a case file with a pandas data frame in place of its table.

        The columns of the frame have the names that a table may have: ``alpha_deg``, ``C_D``, ``C_L``, ``C_M``.
        """
        if not hasattr(table, "to_csv"):
            raise InputError(f"a table is a data frame of pandas, not {type(table).__name__}", "pandas.DataFrame(…)")
        return cls(_sextic.Section(os.fspath(path), _text(path)), "the data frame", table.to_csv(index=False))

    def with_(self, **quantities: float) -> "Section":
        """The same section with other quantities, by their names in a case file: ``U=12``, ``alpha_g_deg=30``."""
        return Section(self._own.set([(name, float(own)) for name, own in quantities.items()]), self._file, self._table)

    def stability(self) -> dict[str, np.ndarray]:
        """What every method says at each angle of the case: arrays of one length by name.

        The names are the columns of ``sextic stability --format csv``: ``alpha_deg``; ``s3d_exact``, ``s3d_companion``,
        ``s3d_closed`` and ``s3d_uniform``, nan where a method does not apply; ``verdict``, proven; ``mode`` and
        ``frequency_hz`` of the mode with the least damping; and so on. ``pandas.DataFrame`` takes it as it is.

        What is odd about the case or its table is told as a warning.
        """
        text, remarks = self._own.stability(self._file, self._table)
        for remark in remarks:
            warnings.warn(remark, stacklevel=2)
        heading, *rows = csv.reader(io.StringIO(text))
        return {name: _column(name, [row[place] for row in rows]) for place, name in enumerate(heading)}


def _column(name: str, cells: list[str]) -> np.ndarray:
    if name in _WORDS:
        return np.array(cells, dtype=np.str_)
    return np.array([float(cell) if cell else np.nan for cell in cells], dtype=np.float64)


def _text(path: str | os.PathLike[str]) -> str:
    """The text of a file in UTF-8, or of a table that another program wrote in Latin-1."""
    try:
        with open(path, "rb") as file:
            data = file.read()
    except OSError as error:
        raise InputError(f"`{os.fspath(path)}` cannot be read: {error.strerror}", "name a case file") from error
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")
