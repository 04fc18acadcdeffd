"""Random documents: declarations, assumptions and definitions, and many claims over them."""

from expressions import Writer, braced, written_matrix
from identities import FAMILIES

ASSUMPTIONS = (
    "0 < α", "α < 1/2", "a < b", "k < h", "x^2 < 4", "y > 1", "sin(β) > 0", "cos(θ) > 0", "F > 0", "x > y",
    "-1 < γ", "γ <= 1", "a^2 + b^2 > 1", "a - b > 0", "h < 1", "cos(α) > 0", "x*y > 0",
)
BASE = """# What others import

```sextic
parameter p, p_1 : 1
parameter l : 1 > 0
angle φ
assume p_1 < 2
P := p^2 + l
U(s) := s/p
substitution flat: p = 0
```
"""


class RandomDocument:
    """The lines of a document; the first are those that claims need."""

    def __init__(self, head, claims, imports):
        self.head, self.claims, self.imports = head, claims, imports

    def text(self, lines=None):
        """The document, or what is left of it."""
        lines = self.head + [claim.line for claim in self.claims] if lines is None else lines
        return "# A random document\n\n```sextic\n" + "\n".join(lines) + "\n```\n"


class RandomClaim:
    """One line of a document, its label, and what kind it is."""

    def __init__(self, line, label, family, form):
        self.line, self.label, self.family, self.form = line, label, family, form


def drawn(random, count, complex_names):
    """A random document of many claims."""
    names, head, imports = vocabulary(random, complex_names)
    writer = Writer(random, names)
    head += definitions(writer)
    if random.random() < 0.4:
        head += [f"assume {a}" for a in random.sample(ASSUMPTIONS, random.choice((1, 1, 2)))]
    claims = [claim(writer, number) for number in range(1, count + 1)]
    return RandomDocument(head, [c for c in claims if c is not None], imports)


def vocabulary(random, complex_names):
    """The names of a document by kind, and the lines that declare them."""
    names = {
        "free": ["a", "b", "c", "x", "y"], "positive": ["k", "h"], "angle": ["α", "β", "γ"],
        "turn": ["θ"], "coordinate": ["q", "θ", "r"], "complex": [], "template": [], "meaning": {},
        "defined": [], "substitution": [], "argument": {},
    }
    head, imports = [], []
    if random.random() < 0.25:
        head.append('import "base.md"')
        imports.append(("base.md", BASE))
        names["free"] += ["p"]
        names["positive"] += ["l"]
        names["angle"] += ["φ"]
        names["defined"] += ["P"]
        names["meaning"].update({"P": "p^2 + l", "U": "%/p", "flat": "p = 0"})
        names["template"] += ["U"]
        names["substitution"] += ["flat"]
    head += ["parameter a, b, c, x, y : 1", "parameter k, h : 1 > 0", "parameter n : 1 != 0", "parameter u_1, u_2 : 1",
             "parameter L, M_1 : m", "parameter t : s > 0", "angle α, β, γ", "coordinate q, r : 1",
             "coordinate θ : rad", "imaginary i"]
    names["argument"] = {"F": random.choice(["x", "x", "a", "x + y", "2*a"]),
                         "C": random.choice(["α", "α + β", "θ", "q"])}
    head += [f"function {name} at {place} : 1" for name, place in names["argument"].items()]
    names["function"] = ["F", "F", "C", "F'", "C'"]
    if complex_names:
        head.append("complex λ : 1")
        names["complex"] = ["λ"]
    return names, head, imports


def definitions(writer):
    """Definitions, a template and a substitution."""
    names, lines = writer.names, []
    names["defined"] = names["defined"] or ["k"]
    names["template"] = names["template"] or ["sqrt"]
    names["substitution"] = names["substitution"] or ["(x = y)"]
    names["meaning"].update({"k": "k", "sqrt": "sqrt(%)", "(x = y)": "x = y"})
    made = []
    for name in ("D", "E_1", "G"):
        meaning = writer.real(2)
        made.append(name)
        names["meaning"][name] = meaning
        lines.append(f"{name} := {meaning}")
    template = writer.choice("s/(s + x)", "s^2 - y", "sin(α)*s", "d(s^2*x, x)", "F(s)", "(s*x) at (x = y)")
    names["meaning"]["T"] = template.replace("sin", "SIN").replace("s", "%").replace("SIN", "sin")
    lines.append(f"T(s) := {template}")
    name, text = writer.replacement(1)
    lines.append(f"substitution rest: {name} = {text}")
    names["meaning"]["rest"] = f"{name} = {text}"
    names["defined"] = [n for n in names["defined"] if n != "k"] + made
    names["template"] = [n for n in names["template"] if n != "sqrt"] + ["T"]
    names["substitution"] = [n for n in names["substitution"] if n.isalpha()] + ["rest"]
    return lines


def claim(writer, number):
    """A claim of any kind."""
    random = writer.random.random()
    label = f"({number})"
    if random < 0.50:
        return equation(writer, label)
    if random < 0.76:
        return inequality(writer, label)
    if random < 0.88:
        return approximation(writer, label)
    if random < 0.92:
        return ill_formed(writer, label)
    if random < 0.95:
        return eigenpair(writer, label)
    if random < 0.97:
        return matching(writer, label, number)
    return unlike(writer, label)


def pair(writer):
    """An identity, perhaps with something done to both of its sides."""
    family = writer.choice(*FAMILIES)
    left, right = FAMILIES[family](writer)
    if writer.chance(0.4):
        left, right = wrapped(writer, left, right, family)
    if writer.chance(0.5):
        left, right = right, left
    return family, left, right


def wrapped(writer, left, right, family):
    """The same done to both sides."""
    if family == "matrices" or "zero(" in left + right or "identity(" in left + right:
        return left, right
    imaginary = writer.chance(0.25)
    last, u, v = writer.replacements(1, imaginary), braced(writer.real(1)), writer.variable()
    f = writer.of("function").rstrip("'")
    return writer.choice(
        (f"({left}) at {last}", f"({right}) at {last}"), (f"({left}) at {last}", f"({right}) at {last}"),
        (f"d({left}, {v})", f"d({right}, {v})"), (f"{f}({left})", f"{f}({right})"),
        (f"({left})*{u}", f"{u}*({right})"), (f"({left})/{u}", f"({right})/{u}"), (f"({left})/({right})", "1"),
        (f"({left}) - ({right})", "0"), (f"({left})^2", f"({right})^2"), (f"dt({left})", f"dt({right})"),
        (f"truncate({left}, [{writer.free()}], 1)", f"truncate({right}, [{writer.free()}], 1)"),
        (f"({left}) at ({v} = {writer.free()})", f"({right}) at ({v} = {writer.free()})"))


def changed(writer, text):
    """A text that means something else."""
    form = writer.random.randrange(5)
    if form == 0:
        return f"({text}) + {writer.choice('1', writer.free(), writer.of('positive'))}"
    if form == 1:
        return f"{writer.choice('2', '-1', writer.free())}*({text})"
    for old, new in writer.random.sample((("+", "-"), ("2", "3"), ("sin", "cos"), ("x", "y"), ("1", "2"), ("- ", "+ ")), 6):
        if old in text:
            return text.replace(old, new, 1)
    return f"({text})*{writer.free()}"


def equation(writer, label):
    """An equation: true, changed or random."""
    family, left, right = pair(writer)
    form = writer.random.random()
    if form > 0.75 and family != "matrices":
        right = changed(writer, right)
    elif form > 0.7:
        family, right = "random", writer.real(2)
        left = writer.real(2)
    keyword = "refute" if form > 0.7 else "claim"
    return RandomClaim(f"{keyword} {label}: {left} == {right}", label, family, "equation")


def inequality(writer, label):
    """An inequality by signs, by an identity, by what is assumed, or at random."""
    family, left, right = pair(writer)
    if family == "matrices":
        family, left, right = "rearranged", *FAMILIES["rearranged"](writer)
    p, k = braced(writer.positive()), writer.of("positive")
    u, a = braced(writer.real(2)), writer.angle()
    f, x = writer.of("function").rstrip("'"), writer.free()
    known = writer.choice(*ASSUMPTIONS)
    by_identity = (f"({left})*({right}) + 1 > {right}", f"({left} - ({right}))^2 <= 0", f"{left} <= {right}",
                   f"({left})^2 + ({right})^2 >= 0", f"{f}({left})*{f}({right}) + 1 > {f}({right})", f"{left} < {right}",
                   f"{f}({left}) - {f}({right}) <= 1", f"({left})^2 >= 0", f"{left} < ({right}) + 1")
    by_sign = (f"{u}^2 >= 0", f"{p} > 0", f"{p} + {u}^2 > 0", f"sin({a})^2 <= 1", f"{k}/{p} >= 0", f"-{p} < 0", f"sqrt({p}) > 0",
               f"1 + {u}^2 >= 1", f"sin({a}) <= 1", f"{x}^2 - 2*{x} + 1 >= 0", f"{x}^2 + {k} > {x}", f"sin(θ)^2 <= θ^2",
               f"{u}^2 at {writer.replacements(1, True)} >= 0", f"{p} > {k}", f"{u} > 0", f"{u} >= {braced(writer.real(1))}",
               f"angle({k}, {x}) <= 2*angle(0, 1)", f"{f}({x})^2 + 1 > 0", f"sqrt({x}^2) >= {x}",
               f"cos({a}) >= -1", f"{x}^4 + 1 > {x}^2", f"{k} + 1/{k} >= 2")
    form = writer.random.randrange(5)
    text = writer.choice(*by_identity) if form < 2 else writer.choice(*by_sign) if form < 4 else known
    family = family if form < 2 else "signs" if form < 4 else "assumed"
    keyword = writer.choice("claim", "claim", "refute")
    return RandomClaim(f"{keyword} {label}: {text}", label, family, "inequality")


def approximation(writer, label):
    """An approximation: a series cut off, too short or too long, or an identity."""
    x, y = writer.two()
    c, a, f = writer.of("positive"), writer.of("turn"), writer.of("function").rstrip("'")
    e, v, n = writer.angle(), braced(writer.real(1)), writer.choice(0, 1, 1, 2, 3)
    one = writer.of("angle")
    family, left, right = pair(writer)
    options = [
        (f"sin({a})", f"{a} - {a}^3/6", a), (f"1/(1 + {x})", f"1 - {x} + {x}^2", x), (f"sqrt({c} + {x})", f"sqrt({c})*(1 + {x}/(2*{c}))", x),
        (f"{f}({x})", f"{f}(0) + {x}*{f}'(0)", x), (f"({x} + {y})^2 + {v}", f"{y}^2 + 2*{x}*{y} + {v}", x),
        (f"cos({one})*{v}", f"(1 - {one}^2/2)*{v}", one), (f"1/({y} - {x})", f"1/{y} + {x}/{y}^2", x),
        (f"truncate({v}, [{x}], 1)", v, x), (f"{v} at ({x} = {y}*{x})", f"({v} at ({x} = 0)) + {x}*{y}*(d({v}, {x}) at ({x} = 0))", x),
        (f"tan({a})", f"{a} + {a}^3/3", a), (f"angle({c}, {x})", f"{x}/{c}", x), (f"angle(cos({e}), sin({e}) + {x}*0)", e, x),
        (f"{f}*{x} + {f}^2", f"{f}*{x}", f), (f"sqrt(1 - sin(2*{one}))", f"cos({one}) - sin({one})", one), (f"{x}*{y}/({c} + {x}*{y})", "0", f"{x}, {y}"),
        (f"dt(q^2)", "0", "q"), (f"{x}/{x} + {v}", f"1 + {v}", writer.choice(x, y)), (f"sqrt(({x} - {y})^2 + {c})", f"sqrt({y}^2 + {c})", x),
    ]
    if family != "matrices":
        options += [(left, right, writer.free()), (f"({left})*{x}", f"({right})*{x} + {x}^2", x)]
    left, right, small = writer.choice(*options)
    if writer.chance(0.2):
        right = changed(writer, right)
    return RandomClaim(f"approximate {label}: {left} ≈ {right} to order {n} in {small}", label, "expansions", "approximation")


def ill_formed(writer, label):
    """Sides whose units or shapes may not fit."""
    u = braced(writer.real(1))
    left, right = writer.choice(
        (f"L*{u}", f"t*{u}"), (f"L + M_1*{u}", "L^2/M_1"), (f"L^2 + M_1^2*{u}", f"L*{u}"), ("[L, 1]", "[L; 1]"),
        (f"sqrt(L^2*{u}^2 + M_1^2)", "L"), (f"L/t", "dt(q)*L"), ("L*dt(q)", f"M_1*{u}"), ("identity(2)", u), (f"d(L^2*{u}, L)", "L"),
        (f"d(L^2*{u}, L)", f"2*L^2*{u}"), ("coefficient(t*x^2, x, 2)", "L"), (f"0*{u}", "[L; L]" if writer.chance(0.2) else "0*L"))
    keyword = writer.choice("ill-formed", "claim")
    return RandomClaim(f"{keyword} {label}: {left} == {right}", label, "units", "ill-formed")


def eigenpair(writer, label):
    """An eigenpair of a symmetric matrix, or nearly one."""
    x, y = writer.free(), writer.choice(writer.free(), writer.of("positive"))
    value, vector = writer.choice((f"{x} + {y}", "[1; 1]"), (f"{x} - {y}", "[1; -1]"), (f"{x} - {y}", "[-1; 1]"), (f"{x}", "[1; 1]"), (f"{x} + {y}", f"[{writer.of('positive')}; 1]"))
    mass = writer.choice("identity(2)", "diagonal(1, 1)", written_matrix([["2", "0"], ["0", "2"]]))
    return RandomClaim(f"eigenpair {label} of [{x}, {y}; {y}, {x}], {mass}: value {value} vector {vector}", label, "eigenpairs", "equation")


def matching(writer, label, number):
    """A matching with one unknown or two, which may be singular, and what is singular may cancel."""
    z, x, y = writer.random.sample(writer.names["free"], 3)
    a, k = writer.angle(), writer.of("positive")
    factors = [f"sin({a})", f"({x} - {y})", x, f"sqrt({k})", f"({x} - sqrt({k}))", f"({x}^2 - {y}^2)", f"cos({a})^2", "1", f"({x}*{y} - {k})", k]
    one, other = writer.choice(*factors), writer.choice(*factors)
    right = writer.choice(k, y, f"{one}*{y}", f"{x} + {k}", f"{one}*{other}", "1", f"{one}^2", f"({x} - {y})*{k}")
    text = writer.choice(
        f"{z} + {right} with {z} + {one}*u_1 in {z} unknown u_1 at 1",
        f"{z}^2 + {right}*{z} + {x} with {z}^2 + ({one}*u_1 + {y}*u_2)*{z} + {other}*u_2 in {z} unknown u_1, u_2 at {z}, 1",
        f"{z}^2 + {right}*{z} + {k} with ({z} + {one}*u_1)*({z} + u_2) in {z} unknown u_1, u_2 at {z}, 1 neglect u_1*u_2"
        if writer.chance(0.1) else f"{right}*{z}^2 + {x} with {z}^2*({one}*u_1 - {other}*u_2) + {y}*u_2 in {z} unknown u_1, u_2 at {z}^2, 1")
    return RandomClaim(f"match {label} match_{number}: {text}", label, "matchings", "matching")


def unlike(writer, label):
    """Two random sides."""
    sign = writer.choice("==", "<", ">=")
    return RandomClaim(f"claim {label}: {writer.real(3)} {sign} {writer.real(2)}", label, "random", "equation" if sign == "==" else "inequality")
