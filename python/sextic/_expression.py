"""Expressions as the command writes them for programs, and as SymPy has them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from .errors import InputError

if TYPE_CHECKING:
    import sympy

__all__ = ["Expression"]

_WORD = re.compile(r"[A-Za-z_]\w*")


class Expression(str):
    """An expression or a statement in ASCII names, with ``**`` for powers.

    It is the text that ``--format json`` has, so that it compares and prints as text does.

    >>> Expression("2*m*omega**2").sympy()
    2*m*omega**2
    """

    __slots__ = ()

    def sympy(self) -> "sympy.Basic":
        """The same in SymPy: names become symbols, ``dt(x)`` and other functions undefined functions.

        A statement with ``==`` becomes ``sympy.Eq``, which is not evaluated.

        >>> Expression("m*omega**2 == k").sympy()
        Eq(m*omega**2, k)
        """
        sympy = _sympy()
        left, sign, right = _parted(self)
        if not sign:
            return _parsed(self, sympy)
        relations = {"==": sympy.Eq, "!=": sympy.Ne, "<": sympy.Lt, "<=": sympy.Le, ">": sympy.Gt, ">=": sympy.Ge}
        return relations[sign](_parsed(left, sympy), _parsed(right, sympy), evaluate=False)


def _sympy():
    try:
        import sympy
    except ImportError as error:
        raise InputError("SymPy is not installed", "install it: pip install sympy") from error
    return sympy


def _parted(text: str) -> tuple[str, str, str]:
    """Both sides of a statement and the sign between them, which stands in no bracket."""
    found = re.search(r"(==|!=|<=|>=|<|>)", text)
    if found is None:
        return text, "", ""
    return text[: found.start()].strip(), found.group(), text[found.end() :].strip()


def _parsed(text: str, sympy):
    """What a side is; nothing of Python's own or SymPy's is found by a name but what the notation has."""
    names: dict[str, object] = {"Integer": sympy.Integer, "Rational": sympy.Rational, "Float": sympy.Float}
    known = {"sqrt": sympy.sqrt, "sin": sympy.sin, "cos": sympy.cos, "i": sympy.I}
    for found in _WORD.finditer(text):
        name = found.group()
        is_call = text[found.end() : found.end() + 1] == "("
        names[name] = known.get(name) or (sympy.Function(name) if is_call else sympy.Symbol(name))
    if "[" in text or re.search(r"\bat\b|\bwhere\b", text):
        raise InputError(
            f"SymPy has no expression for `{text}`", "matrices and places of expressions stay text"
        )
    from sympy.parsing.sympy_parser import auto_number, parse_expr, rationalize

    try:
        return parse_expr(text, local_dict=names, global_dict={}, transformations=(rationalize, auto_number))
    except (SyntaxError, TypeError, NameError, AttributeError, ValueError) as error:
        raise InputError(f"SymPy has no expression for `{text}`", str(error)) from error
