"""Systems of documents in numbers."""

from __future__ import annotations

import os
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from numbers import Integral, Rational, Real
from typing import Any

import numpy as np

from . import _sextic
from ._audit import Audit, read
from .errors import InputError

__all__ = ["Modes", "System"]


@dataclass(frozen=True)
class Modes:
    """The modes of a system for one set of values."""

    #: One of each pair of conjugates, in 1/s: the real part is the growth. Complex, of shape (modes,).
    eigenvalues: np.ndarray
    #: Rigorous bounds of their errors, in 1/s, of shape (modes,).
    errors: np.ndarray
    #: How the coordinates move with each, the largest 1; nan where no shape is certain. Complex, (modes, coordinates).
    shapes: np.ndarray
    coordinates: tuple[str, ...]
    #: ``stable``, ``unstable`` or ``undecided``, proven for the numbers as they were given.
    verdict: str
    reason: str
    #: Whether it diverges; None where that is not decided.
    diverges: bool | None


class System:
    """A system of a document: M q̈ + C q̇ + K q = 0.

    ``document`` is what :func:`sextic.audit` takes or gives; ``name`` is not needed where there is one system only.
    """

    def __init__(self, document: Audit | str | os.PathLike[str], name: str | None = None) -> None:
        self._own = _sextic.System(read(document), name)
        self.name: str = self._own.name
        #: The names of what must be given, and of the coordinates.
        self.inputs: tuple[str, ...] = tuple(self._own.names())
        self.coordinates: tuple[str, ...] = tuple(self._own.coordinates())

    def modes(self, **values: Any) -> Modes:
        """The eigenvalues with bounds of their errors, and the verdict, for numbers in SI units and radians.

        Whole numbers, ``Fraction``, ``Decimal`` and text such as ``"0.1"`` or ``"1/3"`` are taken as they are written; a
        float is the double that it is.
        """
        found = self._own.modes([(name, exact(name, value)) for name, value in values.items()])
        eigenvalues, errors, shapes, verdict, reason, diverges = found
        none = [complex(np.nan, np.nan)] * len(self.coordinates)
        return Modes(
            eigenvalues=np.array(eigenvalues, dtype=np.complex128),
            errors=np.array(errors, dtype=np.float64),
            shapes=np.array([none if own is None else own for own in shapes], dtype=np.complex128),
            coordinates=self.coordinates,
            verdict=verdict,
            reason=reason,
            diverges=diverges,
        )

    def __repr__(self) -> str:
        return f"<system {self.name} in {', '.join(self.coordinates)}: modes({', '.join(self.inputs)})>"


def exact(name: str, value: Any) -> str:
    """A number as text that means it exactly."""
    if isinstance(value, str):
        return value.strip()
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, bool) or not isinstance(value, (Integral, Rational, Decimal, Real)):
        raise InputError(f"`{name}` is no number: {value!r}", "give one number; arrays are for evaluators")
    number = value if isinstance(value, (Integral, Rational, Decimal)) else float(value)
    try:
        return str(Fraction(number))
    except (ValueError, OverflowError):
        raise InputError(f"`{name}` is {value}", "give a number") from None
