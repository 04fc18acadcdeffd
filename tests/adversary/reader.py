"""Documents of the block language, read by its description alone."""

import os
import re

from names import canonical
from syntax import Parser, Unreadable, node, number, tokens

KEYWORDS = {
    "import", "parameter", "complex", "angle", "coordinate", "function", "imaginary", "assume",
    "substitution", "claim", "refute", "approximate", "ill-formed", "eigenpair", "match",
    "evaluator", "domain",
}
ASSERTIONS = {"claim", "refute", "approximate", "ill-formed", "eigenpair"}


class Variable:
    """A declared name: its kind, its unit as an expression, and its sign."""

    def __init__(self, kind, name, unit, sign=None, argument=None):
        self.kind, self.name, self.unit, self.sign, self.argument = kind, name, unit, sign, argument


class Claim:
    """An assertion: what it expects, its sides, and of an approximation the order and in what."""

    def __init__(self, kind, label, line, text):
        self.kind, self.label, self.line, self.text = kind, label, line, text
        self.left = self.right = None
        self.sign, self.order, self.small = "==", None, ()


class Matching:
    """A matching: two polynomials, the unknowns and the powers that are compared."""

    def __init__(self, exact, assumed, variable, unknowns, powers, simple):
        self.exact, self.assumed, self.variable = exact, assumed, variable
        self.unknowns, self.powers, self.simple = unknowns, powers, simple


class Document:
    """All that a document and its imports declare, assume and define; its own claims."""

    def __init__(self):
        self.variables, self.definitions, self.templates = {}, {}, {}
        self.substitutions, self.matchings, self.spellings = {}, {}, {}
        self.assumptions, self.claims, self.imaginary = [], [], None
        self.statements = []

    def take_over(self, other):
        """The names and assumptions of an imported document."""
        for part in ("variables", "definitions", "templates", "substitutions", "matchings", "spellings"):
            getattr(self, part).update(getattr(other, part))
        self.assumptions += other.assumptions
        self.imaginary = self.imaginary or other.imaginary


def blocks(text):
    """The lines of all blocks fenced as `sextic`, with their numbers."""
    lines = re.split(r"\r\n|\r|\n", text)
    fence, found = None, []
    for number_, line in enumerate(lines, 1):
        match = re.match(r"(`{3,}|~{3,})\s*([^`]*)$", line)
        if fence is None and match:
            fence = (match.group(1), match.group(2).split()[:1] == ["sextic"])
        elif fence and match and match.group(1).startswith(fence[0]) and not match.group(2).strip():
            fence = None
        elif fence and fence[1]:
            found.append((number_, without_comment(line)))
    return found


def without_comment(line):
    """A line up to its `#`, which may stand within quotation marks."""
    quoted = False
    for place, letter in enumerate(line):
        quoted ^= letter == '"'
        if letter == "#" and not quoted:
            return line[:place]
    return line


def statements(text):
    """The statements of a document with the numbers of their first lines."""
    found, depth = [], 0
    for number_, line in blocks(text):
        if not line.strip():
            continue
        if found and (depth > 0 or line[0] in " \t"):
            found[-1][1] += "\n" + line
        else:
            found.append([number_, line])
        bare = re.sub(r'"[^"]*"', "", line)
        depth += sum(bare.count(c) for c in "([") - sum(bare.count(c) for c in ")]")
    return found


def read(path, known=()):
    """The document at a path."""
    with open(path, encoding="utf-8", newline="") as file:
        text = file.read()
    if os.path.abspath(path) in known:
        raise Unreadable("a document imports itself")
    return read_text(text, os.path.dirname(path), (*known, os.path.abspath(path)))


def read_text(text, folder=".", known=()):
    """The document that a text is."""
    document = Document()
    for line, statement in statements(text):
        Statement(document, folder, known).read(line, statement)
    return document


class Statement:
    """Reads one statement into a document."""

    def __init__(self, document, folder, known):
        self.document, self.folder, self.known = document, folder, known

    def read(self, line, text):
        """A statement by its keyword; without one it is a definition."""
        keyword = re.match(r"ill-formed\b|\w+", text)
        keyword = keyword.group() if keyword else ""
        rest = text[len(keyword):]
        if keyword not in KEYWORDS or re.match(r"\s*(\([\w\s,]*\)\s*|,[\w\s,]*)?:=", rest):
            self.definition(text)
        elif keyword == "import":
            path = os.path.join(self.folder, re.search(r'"([^"]*)"', rest).group(1))
            self.document.take_over(read(path, self.known))
        elif keyword in ASSERTIONS:
            self.assertion(keyword, line, rest)
        elif keyword not in ("evaluator", "domain"):
            getattr(self, {"complex": "parameter", "match": "matching"}.get(keyword, keyword))(
                Parser([token for token in tokens(rest if keyword != "match" else "")]), keyword, rest)

    def parameter(self, parser, keyword, _):
        """Real or complex constants."""
        self.declare(parser, keyword)

    def angle(self, parser, keyword, _):
        """Constant angles."""
        self.declare(parser, keyword)

    def coordinate(self, parser, keyword, _):
        """Functions of time."""
        self.declare(parser, keyword)

    def function(self, parser, keyword, _):
        """Functions known through their derivatives, with the argument of their bare names."""
        self.declare(parser, keyword)

    def declare(self, parser, keyword):
        """Names with a unit, a sign, an argument."""
        names = [self.declared(parser)]
        while parser.follows(","):
            names.append(self.declared(parser))
        argument = parser.sum() if keyword == "function" and parser.follows("at") else None
        unit = parser.product() if parser.follows(":") else number(1)
        sign = None
        if parser.peek() in ("<", "<=", ">", ">=", "!="):
            sign = parser.take()
            parser.take("0")
        for name in names:
            self.document.variables[name] = Variable(keyword, name, unit, sign, argument)

    def declared(self, parser):
        """A name, perhaps with an ASCII spelling."""
        name, _ = parser.name()
        if parser.follows("as"):
            self.document.spellings[canonical(parser.take())] = name
        return name

    def imaginary(self, parser, _, __):
        """The imaginary unit."""
        self.document.imaginary = parser.name()[0]

    def assume(self, parser, _, __):
        """An inequality that every assignment satisfies."""
        self.document.assumptions.append(parser.comparison())

    def substitution(self, parser, _, __):
        """Replacements under a name."""
        name, _ = parser.name()
        parser.take(":")
        self.document.substitutions[name] = parser.replacements(None)

    def definition(self, text):
        """Names for expressions, or one with arguments."""
        parser = Parser(tokens(text))
        if parser.peek(1) == "(":
            name, _ = parser.name()
            parser.take("(")
            arguments = [name for name, _ in parser.names()]
            parser.take(")")
            parser.take(":=")
            self.document.templates[name] = (arguments, parser.expression())
            return
        names = parser.names()
        parser.take(":=")
        for place, (name, _) in enumerate(names):
            if place:
                parser.take(",")
            self.document.definitions[name] = parser.expression()

    def assertion(self, keyword, line, rest):
        """A claim of any kind."""
        label, rest = labelled(rest)
        claim = Claim(keyword, label, line, rest.strip())
        self.document.claims.append(claim)
        parser = Parser(tokens(rest))
        if keyword == "eigenpair":
            return self.eigenpair(parser, claim)
        parser.take(":")
        claim.left, claim.sign, claim.right = parser.comparison()
        if parser.follows("to"):
            parser.take("order")
            claim.order = int(parser.take())
            parser.take("in")
            claim.small = tuple(parser.expression() for _ in range(1))
            while parser.follows(","):
                claim.small += (parser.expression(),)
        return None

    def eigenpair(self, parser, claim):
        """K·v = value·M·v."""
        parser.take("of")
        stiffness = parser.expression()
        parser.take(",")
        mass = parser.expression()
        parser.take(":")
        parser.take("value")
        value = parser.expression()
        parser.take("vector")
        vector = parser.expression()
        claim.left = node("multiply", stiffness, vector)
        claim.right = node("multiply", value, node("multiply", mass, vector))

    def matching(self, _, __, rest):
        """Two polynomials matched power by power."""
        _, rest = labelled(rest)
        parser = Parser(tokens(rest))
        name, _ = parser.name()
        parser.take(":")
        exact = parser.expression()
        parser.take("with")
        assumed = parser.expression()
        parser.take("in")
        variable = parser.postfix()
        parser.take("unknown")
        unknowns = [name for name, _ in parser.names()]
        parser.take("at")
        powers = [exponent(parser.expression(), variable)]
        while parser.follows(","):
            powers.append(exponent(parser.expression(), variable))
        simple = not parser.follows("neglect") or all(
            is_product(part, unknowns) for part in parser.list_before("small"))
        self.document.matchings[name] = Matching(exact, assumed, variable, unknowns, powers, simple)


def is_product(part, unknowns):
    """Whether an expression is a product of two unknowns or more, which linear equations lack."""
    if part.kind == "power":
        return part.parts[0].kind == "name" and part.parts[0].parts[0] in unknowns
    return part.kind == "multiply" and all(
        inner.kind == "name" and inner.parts[0] in unknowns or is_product(inner, unknowns)
        for inner in part.parts)


def labelled(rest):
    """A label in round or square brackets, and what follows it."""
    rest = rest.lstrip()
    close = {"(": ")", "[": "]"}.get(rest[:1])
    if close is None:
        raise Unreadable("a label is missing")
    end = rest.index(close)
    return rest[:end + 1], rest[end + 1:]


def exponent(power, variable):
    """The n of λⁿ."""
    if power is variable:
        return 1
    return 0 if power is number(1) else int(power.parts[1].parts[0])
