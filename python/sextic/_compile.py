"""Evaluators of any document."""

from __future__ import annotations

import os
from typing import Any, Mapping

from ._audit import Audit, read
from .evaluators import Evaluator
from ._system import exact

__all__ = ["compile"]


def compile(
    document: Audit | str | os.PathLike[str], name: str, *, fix: Mapping[str, Any] | None = None
) -> Evaluator:
    """An evaluator of a document as a function over NumPy arrays.

    ``document`` is what :func:`sextic.audit` takes or gives, and must be as it expects. The quantities of ``fix`` get a
    number once and for all: whole numbers, fractions and text are taken as they are written, a float as the double that
    it is.

    >>> spring = '''# A spring
    ... ```sextic
    ... parameter m : kg > 0
    ... parameter k : N/m > 0
    ... evaluator (1) frequency: omega = sqrt(k/m)
    ... domain m = [1, 2], k = [1, 2]
    ... ```
    ... '''
    >>> compile(spring, "frequency")(m=[1.0, 4.0], k=16.0).omega
    array([4., 2.])
    >>> compile(spring, "frequency", fix={"m": 4})(k=16.0).omega
    np.float64(2.0)
    """
    numbers = [(own, exact(own, value)) for own, value in (fix or {}).items()]
    return Evaluator(read(document).compile(name, numbers))
