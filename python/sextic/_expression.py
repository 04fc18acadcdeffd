"""Expressions as the command writes them for programs, and as SymPy has them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from .errors import InputError

if TYPE_CHECKING:
    import sympy

__all__ = ["Expression"]

#: A name; those of the outputs of an evaluator have a dot.
_WORD = re.compile(r"[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)?")


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
    """What a side is; a name means what the notation means by it, and nothing of SymPy's own."""
    if re.search(r"\b(at|where)\b|[\w)\]]\[", text):
        raise InputError(f"SymPy has no expression for `{text}`", "entries of matrices and places stay text")
    from sympy.parsing.sympy_parser import auto_number, parse_expr, rationalize

    names: dict[str, object] = {"Integer": sympy.Integer, "Rational": sympy.Rational, "Float": sympy.Float}
    text = _matrices(_WORD.sub(lambda found: _named(found, names, sympy), text))
    names["Matrix_"] = sympy.ImmutableMatrix
    try:
        return parse_expr(text, local_dict=names, global_dict={}, transformations=(rationalize, auto_number))
    except (SyntaxError, TypeError, NameError, AttributeError, ValueError) as error:
        raise InputError(f"SymPy has no expression for `{text}`", str(error)) from error


def _named(found: re.Match[str], names: dict[str, object], sympy) -> str:
    """A word under which Python finds what a name means: names of evaluators have a dot, and some are Python's."""
    name = found.group()
    is_call = found.string[found.end() : found.end() + 1] == "("
    known = {"sqrt": sympy.sqrt, "sin": sympy.sin, "cos": sympy.cos, "i": sympy.I}
    own = f"own_{name.replace('.', '_dot_')}"
    names[own] = known.get(name) or (sympy.Function(name) if is_call else sympy.Symbol(name))
    return own


def _matrices(text: str) -> str:
    """Matrices as Python has them: ``[a, b; c, d]`` is ``[[a, b], [c, d]]``."""
    found = re.search(r"\[([^\[\]]*)\]", text)
    while found:
        rows = "), (".join(row.strip() + "," for row in found.group(1).split(";"))
        text = f"{text[: found.start()]}Matrix_((({rows}),)){text[found.end() :]}"
        found = re.search(r"\[([^\[\]]*)\]", text)
    return text
