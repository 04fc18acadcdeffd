"""Expressions as they are written: exact numbers, names, arguments in place of names."""

from series import Mistake
from syntax import Node, node


def rated(name, dots):
    """The time derivative of what is no variable."""
    found = node("name", name, 0, 0)
    for _ in range(dots):
        found = node("call", "dt", found)
    return found


def exact(part):
    """The exact number that an expression of numbers is."""
    kind = part.kind
    if kind == "number":
        return part.parts[0]
    if kind == "negate":
        return -exact(part.parts[0])
    if kind in ("add", "subtract", "multiply", "divide", "power"):
        a, b = (exact(inner) for inner in part.parts)
        return {"add": lambda: a + b, "subtract": lambda: a - b, "multiply": lambda: a * b,
                "divide": lambda: a / b, "power": lambda: a ** int(b)}[kind]()
    raise Mistake("an exact number is wanted")


def own_names(part, found=None):
    """The names that stand in an expression."""
    found = set() if found is None else found
    for inner in part.parts:
        if isinstance(inner, Node):
            own_names(inner, found)
        elif isinstance(inner, tuple):
            for pair in inner:
                for one in pair if isinstance(pair, tuple) else (pair,):
                    own_names(one, found)
        elif isinstance(inner, str) and part.kind in ("name", "applied", "at named", "solution"):
            found.add(inner)
    return found


def written(part, values):
    """An expression with expressions in place of names."""
    if not isinstance(part, Node):
        if isinstance(part, tuple):
            return tuple(written(inner, values) for inner in part)
        return part
    if part.kind == "name" and part.parts[0] in values:
        found = values[part.parts[0]]
        for _ in range(part.parts[1]):
            found = node("call", "dt", found)
        return found
    return node(part.kind, *(written(inner, values) for inner in part.parts))
