"""Expressions of the block language: tokens, trees that stand once each, and their parser."""

import re
import unicodedata
from fractions import Fraction

from names import DOTS, canonical, without_dots

TOKEN = re.compile(
    r"(?P<space>[ \t\n]+)|(?P<number>\d+(?:\.\d+)?)|(?P<text>\"[^\"]*\")"
    r"|(?P<name>[^\W\d_][" + "".join(DOTS) + r"]*[^\W⁰¹²³⁴-⁹]*)"
    r"|(?P<sign>:=|==|<=|>=|!=|\*\*|[-+*/^()\[\],;=<>:'|√·×≈≤≥≠−⁰¹²³⁴-⁹])"
)
SAME_SIGN = {"**": "^", "·": "*", "×": "*", "≈": "==", "≤": "<=", "≥": ">=", "≠": "!=", "−": "-"}
SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹"
COMPARISONS = ("==", "!=", "<", "<=", ">", ">=")
BUILT_IN = {
    "sin", "cos", "tan", "cot", "sqrt", "angle", "dt", "d", "det", "adjugate", "inverse", "trace",
    "transpose", "diagonal", "identity", "zero", "row", "column", "submatrix", "solve", "kernel",
    "coefficient", "hurwitz", "truncate",
}


class Unreadable(Exception):
    """What is not in the language."""


class Node:
    """A part of an expression: a kind and its parts. Equal expressions are the same object."""

    __slots__ = ("kind", "parts", "number")
    known = {}

    def __repr__(self):
        return f"{self.kind}{self.parts}"


def node(kind, *parts):
    """The one node of this kind with these parts."""
    key = (kind, *parts)
    found = Node.known.get(key)
    if found is None:
        found = Node()
        found.kind, found.parts, found.number = kind, parts, len(Node.known)
        Node.known[key] = found
    return found


def number(value):
    """A number as an expression."""
    return node("number", Fraction(value))


def tokens(text):
    """The tokens of a text as pairs of kind and text."""
    text = unicodedata.normalize("NFD", text)
    place, found = 0, []
    while place < len(text):
        match = TOKEN.match(text, place)
        if not match:
            raise Unreadable(f"no token at {text[place:place + 20]!r}")
        place = match.end()
        if match.lastgroup != "space":
            value = match.group()
            found.append((match.lastgroup, SAME_SIGN.get(value, value)))
    return found


class Parser:
    """A position in tokens, and the grammar of expressions, from loose to tight."""

    def __init__(self, found):
        self.tokens, self.place = found, 0

    def peek(self, ahead=0):
        """The text of a token, or nothing behind the last."""
        place = self.place + ahead
        return self.tokens[place][1] if place < len(self.tokens) else None

    def kind(self):
        """The kind of the next token."""
        return self.tokens[self.place][0] if self.place < len(self.tokens) else None

    def take(self, expected=None):
        """Goes on by a token, which must be what is expected."""
        found = self.peek()
        if found is None or (expected is not None and found != expected):
            raise Unreadable(f"{expected!r} expected, {found!r} found")
        self.place += 1
        return found

    def follows(self, text):
        """Goes on by a token if it is this one."""
        if self.peek() != text:
            return False
        self.place += 1
        return True

    def name(self):
        """A name with its dots."""
        if self.kind() != "name":
            raise Unreadable(f"a name expected, {self.peek()!r} found")
        name, dots = without_dots(self.take())
        return canonical(name), dots

    def names(self):
        """Names with commas between them."""
        found = [self.name()]
        while self.follows(","):
            found.append(self.name())
        return found

    def list(self, end):
        """Expressions with commas between them, up to the end."""
        found = []
        while not self.follows(end):
            found.append(self.expression())
            if self.peek() != end:
                self.take(",")
        return found

    def list_before(self, word):
        """Expressions with commas between them, up to a word or the end."""
        found = [self.expression()]
        while self.follows(","):
            found.append(self.expression())
        if self.peek() not in (word, None) and self.kind() != "text":
            raise Unreadable(f"{word} expected, {self.peek()!r} found")
        return found

    def comparison(self):
        """Two expressions with a sign of comparison between them."""
        left = self.expression()
        sign = self.take()
        if sign not in COMPARISONS:
            raise Unreadable(f"a comparison expected, {sign!r} found")
        return left, sign, self.expression()

    def expression(self):
        """A sum, perhaps with replacements behind it."""
        found = self.sum()
        while self.peek() == "at" and self.kind() == "name":
            self.take()
            found = self.replaced(found)
        return found

    def replaced(self, found):
        """What stands behind `at`: a name, or replacements in brackets."""
        if not self.follows("("):
            return node("at named", found, self.name()[0])
        return node("at", found, self.replacements(")"))

    def replacements(self, end):
        """`x = 1, y = 2` up to the end, as pairs of targets and expressions."""
        pairs = []
        while not (end is None and self.kind() in (None, "text")) and not (end and self.follows(end)):
            target = self.postfix()
            self.take("=")
            pairs.append((target, self.expression()))
            if self.peek() != end and self.kind() != "text":
                self.take(",")
        return tuple(pairs)

    def sum(self):
        """Terms."""
        found = self.product()
        while self.peek() in ("+", "-"):
            sign = self.take()
            found = node("add" if sign == "+" else "subtract", found, self.product())
        return found

    def product(self):
        """Factors."""
        found = self.signed()
        while self.peek() in ("*", "/"):
            sign = self.take()
            found = node("multiply" if sign == "*" else "divide", found, self.signed())
        return found

    def signed(self):
        """A factor with a minus before it, which is looser than a power."""
        if self.follows("-"):
            return node("negate", self.signed())
        if self.follows("+"):
            return self.signed()
        return self.power()

    def power(self):
        """A power, grouping to the right."""
        base = self.postfix()
        if self.follows("^"):
            exponent = node("negate", self.signed()) if self.follows("-") else self.power()
            return node("power", base, exponent)
        return base

    def postfix(self):
        """An operand with its primes, arguments, indices and superscripts."""
        found = self.operand()
        while True:
            if self.follows("["):
                found = node("entry", found, *self.list("]"))
            elif self.peek() and self.peek() in SUPERSCRIPTS:
                digits = ""
                while self.peek() and self.peek() in SUPERSCRIPTS:
                    digits += str(SUPERSCRIPTS.index(self.take()))
                found = node("power", found, number(int(digits)))
            else:
                return found

    def operand(self):
        """A number, a name, a call, brackets, a matrix, a determinant or a root."""
        if self.kind() == "number":
            return number(Fraction(self.take()))
        if self.kind() == "name":
            return self.named()
        sign = self.take()
        if sign == "(":
            found = self.expression()
            self.take(")")
            return found
        if sign == "[":
            return self.matrix()
        if sign == "|":
            found = self.expression()
            self.take("|")
            return node("call", "det", found)
        if sign == "√":
            return node("call", "sqrt", self.operand())
        raise Unreadable(f"an expression expected, {sign!r} found")

    def named(self):
        """A name, perhaps with dots, primes and arguments."""
        name, dots = self.name()
        primes = 0
        while self.follows("'"):
            primes += 1
        if self.follows("("):
            if name in BUILT_IN and not primes:
                return node("call", name, *self.list(")"))
            return node("applied", name, primes, *self.list(")"))
        return node("name", name, dots, primes)

    def matrix(self):
        """Rows with semicolons between them."""
        rows = [[self.expression()]]
        while not self.follows("]"):
            if self.follows(";"):
                rows.append([self.expression()])
            else:
                self.take(",")
                rows[-1].append(self.expression())
        return node("matrix", tuple(node("row", *row) for row in rows))


def expression(text):
    """The expression that a text is."""
    parser = Parser(tokens(text))
    found = parser.expression()
    if parser.peek() is not None:
        raise Unreadable(f"{parser.peek()!r} follows an expression")
    return found


def comparison(text):
    """The two sides of a condition and the sign between them."""
    parser = Parser(tokens(text))
    found = parser.comparison()
    if parser.peek() is not None:
        raise Unreadable(f"{parser.peek()!r} follows a comparison")
    return found
