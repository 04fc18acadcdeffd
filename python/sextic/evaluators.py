"""The evaluators that come with the program, as functions over NumPy arrays.

Each is a function of keyword arguments in SI units and radians, which are broadcast against each other; an angle
``alpha_g`` may be given in degrees as ``alpha_g_deg``, and a rate ``omega_n`` in hertz as ``f_n``. It gives a named
tuple of arrays. The values are bit for bit those of ``sextic evaluate``.

>>> from sextic import evaluators
>>> import numpy as np
>>> found = evaluators.small_quantities(m=3.5, r=0.0178, L_g=0.004, rho=1.2, D=0.0366, U=np.array([5.0, 10.0]), f_n=1)
>>> found.delta.shape
(2,)
>>> found.e.dtype
dtype('float64')
"""

from __future__ import annotations

import collections
import inspect
from typing import Any

import numpy as np

from . import _sextic
from ._arrays import Columns

__all__ = ["Evaluator"]


class Evaluator:
    """A function of named quantities over arrays.

    ``inputs`` and ``outputs`` say what each quantity is, and its unit. Call it with keyword arguments.
    """

    def __init__(self, own: _sextic.Evaluator) -> None:
        self._own = own
        self.inputs: dict[str, str] = dict(own.asked())
        self.outputs: dict[str, str] = dict(own.outputs())
        self._names = list(self.inputs)
        self._result = collections.namedtuple(own.name, self.outputs, rename=True)
        self.__name__ = self.__qualname__ = own.name
        self.__doc__ = _documentation(own)
        self.__signature__ = _signature(self._names)

    def __call__(self, *, bounds: bool = False, **quantities: Any) -> Any:
        """The outputs as a named tuple of float64 arrays, of the shape that all quantities have together.

        With ``bounds=True`` two of them: values, and how far rounding can have taken each from the exact result for
        these inputs; sines and cosines of angles count as inputs. The bound is infinite where nothing is known.

        A point at which a formula has no value gets ``nan`` or an infinity, as NumPy has it, and so does one with a
        quantity that is ``nan``. Where an array is masked, so are the results. The conditions of the derivation (see
        the documentation of each evaluator) are not looked at.
        """
        columns = Columns(self.__name__, self._names, quantities)
        values, errors = self._own.run(columns.columns, columns.size, bounds)
        found = self._result(*map(columns.shaped, values))
        return (found, self._result(*map(columns.shaped, errors))) if bounds else found

    def __repr__(self) -> str:
        return f"<evaluator {self.__name__}({', '.join(self._names)}) -> ({', '.join(self.outputs)})>"


def _documentation(own: _sextic.Evaluator) -> str:
    def listed(pairs: list[tuple[str, str]]) -> str:
        return "\n".join(f"- {name}: {text}" for name, text in pairs)

    head, _, rest = own.text.partition("\n\n")
    return (
        f"{head}\n\n# Arguments\n\nNumbers or arrays of any shapes that fit together.\n\n{listed(own.asked())}\n\n"
        f"# Returns\n\nA named tuple of arrays of the shape of all arguments together.\n\n{listed(own.outputs())}\n\n{rest}"
    )


def _signature(names: list[str]) -> inspect.Signature:
    kind = inspect.Parameter.KEYWORD_ONLY
    given = [inspect.Parameter(name, kind) for name in names]
    return inspect.Signature([*given, inspect.Parameter("bounds", kind, default=False, annotation=bool)])


def __getattr__(name: str) -> Evaluator:
    """The evaluator of this name; each is made when it is first asked for."""
    if name.startswith("__"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if name not in _sextic.shipped_evaluators():
        meant = _sextic.meant(name, _sextic.shipped_evaluators())
        raise AttributeError(f"there is no evaluator `{name}`: {meant}")
    own = globals()[name] = Evaluator(_sextic.shipped_evaluator(name))
    return own


def __dir__() -> list[str]:
    return sorted([*_sextic.shipped_evaluators(), *__all__])
