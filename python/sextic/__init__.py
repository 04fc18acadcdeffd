"""Derives, audits and compiles closed-form stability criteria.

- :func:`audit` gives a verdict on every equation of a document;
- :mod:`evaluators` has the formulas that come with the program, as functions over NumPy arrays;
- :func:`compile` makes such a function of what any document derives;
- :class:`System` has the eigenvalues of a system that a document derives, with bounds of their errors;
- :class:`Section` says where a section with measured coefficients gallops.

Exceptions are :class:`Error` and its children, with the words of the command.
"""

from . import evaluators
from ._compile import compile
from ._sextic import __version__
from ._audit import Audit, Claim, audit, documents
from .errors import DocumentError, Error, InputError
from .evaluators import Evaluator
from ._expression import Expression
from ._section import Section
from ._system import Modes, System

__all__ = [
    "Audit",
    "Claim",
    "DocumentError",
    "Error",
    "Evaluator",
    "Expression",
    "InputError",
    "Modes",
    "Section",
    "System",
    "__version__",
    "audit",
    "compile",
    "documents",
    "evaluators",
]
