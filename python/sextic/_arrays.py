"""What callers give, as columns of one length."""

from __future__ import annotations

import math
from typing import Any, Mapping

import numpy as np

from . import _sextic
from .errors import InputError

#: Kinds of NumPy's types that are real numbers: signed, unsigned and floating.
_REAL = "iuf"


class Columns:
    """Quantities by name, which are broadcast against each other."""

    def __init__(self, owner: str, names: list[str], given: Mapping[str, Any]) -> None:
        values = _named(owner, names, given)
        # Nearly all of them are one number, which NumPy would be slow to look at.
        arrays = {name: _real(name, own) for name, own in values.items() if type(own) is not float}
        self.shape = _shape(owner, arrays) if arrays else ()
        self.mask = _mask(arrays.values())
        self.size = math.prod(self.shape)
        self.columns = [self._column(arrays[name]) if name in arrays else values[name] for name in names]

    def _column(self, array: np.ndarray) -> float | np.ndarray:
        """One number where it is the same everywhere, else one for each point: the array itself where its layout allows it."""
        if array.size == 1:
            return float(array.reshape(())[()])
        whole = np.broadcast_to(np.asarray(array), self.shape)
        return np.ascontiguousarray(whole).reshape(-1)

    def shaped(self, column: np.ndarray) -> Any:
        """Values of all points in the shape of what was given; one number where that has no dimension."""
        array = column.reshape(self.shape)
        if self.mask is not None:
            return np.ma.array(array, mask=np.broadcast_to(self.mask, self.shape))
        return array if self.shape else array[()]


def _named(owner: str, names: list[str], given: Mapping[str, Any]) -> dict[str, Any]:
    """The values by the names of the document: an angle may be given in degrees, and a rate in hertz."""
    values: dict[str, Any] = {}
    for name, value in given.items():
        own, factor = _renamed(name, names)
        if own not in names:
            raise InputError(f"{owner} has no quantity `{name}`", _sextic.meant(name, names))
        if own in values:
            raise InputError(f"`{own}` is given twice", "give it once")
        values[own] = value if factor is None else _real(name, value) * factor
    missing = [name for name in names if name not in values]
    if missing:
        raise InputError(f"{owner} needs {', '.join(missing)} too", f"{missing[0]}=…; help({owner}) says what they are")
    return values


def _renamed(name: str, names: list[str]) -> tuple[str, float | None]:
    """The name that is meant, and the factor to SI units, as in every command."""
    if name in names:
        return name, None
    if name.endswith("_deg") and name[: -len("_deg")] in names:
        return name[: -len("_deg")], np.pi / 180.0
    if name.startswith("f_") and f"omega_{name[2:]}" in names:
        return f"omega_{name[2:]}", 2.0 * np.pi
    return name, None


def _real(name: str, value: Any) -> np.ndarray:
    """An array of real numbers."""
    try:
        array = value if isinstance(value, np.ma.MaskedArray) else np.asarray(value)
    except ValueError as error:
        raise InputError(f"`{name}` is no array: {error}", "give a number or an array of numbers") from error
    if array.dtype.kind not in _REAL:
        raise InputError(
            f"`{name}` is an array of {array.dtype}, and quantities are real numbers",
            "convert it, say with numpy.asarray(…, dtype=float)",
        )
    return array.astype(np.float64, copy=False)


def _mask(arrays: Any) -> np.ndarray | None:
    """Where a value is masked; nothing where no array has a mask."""
    masks = [np.ma.getmaskarray(own) for own in arrays if isinstance(own, np.ma.MaskedArray)]
    mask = None
    for own in masks:
        mask = own if mask is None else np.logical_or(mask, own)
    return mask


def _shape(owner: str, arrays: Mapping[str, np.ndarray]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(*(own.shape for own in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {own.shape}" for name, own in arrays.items() if own.ndim)
        raise InputError(
            f"the shapes of what {owner} is given do not fit together: {shapes}",
            "arrays are broadcast as NumPy does it",
        ) from None
