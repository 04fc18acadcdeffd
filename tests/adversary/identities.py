"""Pairs of expressions that are equal by construction, wherever they have values; and some that
only look so. Each function draws a pair; what is true of it is for the oracle to say."""

from expressions import braced, written_matrix


def rearranged(w):
    """Products and sums in another order."""
    u, v, t = (braced(w.real(2)) for _ in range(3))
    return w.choice(
        (f"({u} + {v})^2", f"{u}^2 + 2*{u}*{v} + {v}^2"),
        (f"({u} + {v})*({u} - {v})", f"{u}^2 - {v}^2"),
        (f"{u}*({v} + {t})", f"{t}*{u} + {v}*{u}"),
        (f"{u} - ({v} - {t})", f"{t} + {u} - {v}"),
        (f"({u} - {v})^3", f"{u}^3 - 3*{u}^2*{v} + 3*{u}*{v}^2 - {v}^3"))


def expanded(w):
    """A product of polynomials."""
    names = w.random.sample(w.names["free"] + w.names["positive"], 3)
    p, q = w.polynomial(names), w.polynomial(names)
    values = {} if w.chance(0.6) else {names[0]: w.real(1)}
    left = f"({p.text(w.random, values)})*({q.text(w.random, values)})"
    return left, p.times(q).text(w.random, values)


def cancelled(w):
    """Quotients."""
    u, v, t = (braced(w.real(w.choice(1, 2))) for _ in range(3))
    return w.choice(
        (f"({u}*{v})/{v}", u), (f"{u}/{u}", "1"), (f"1/(1/{u})", u), (f"{u}^-2*{u}^2", "1"),
        (f"({u}^2 - {v}^2)/({u} - {v})", f"{u} + {v}"), (f"{u}/{v} + {t}/{v}", f"({u} + {t})/{v}"),
        (f"{u}/{v} - {v}/{u}", f"({u}^2 - {v}^2)/({u}*{v})"), (f"({u}/{t})/({v}/{t})", f"{u}/{v}"),
        (f"0*{u}/{v}", "0"), (f"({u} - {u})/{v}", "0"))


def polynomial_quotient(w):
    """A product of polynomials by one of them."""
    names = w.random.sample(w.names["free"], 2)
    p, q = w.polynomial(names, 3, 2), w.polynomial(names, 2, 2)
    return f"({p.times(q).text(w.random)})/({q.text(w.random)})", p.text(w.random)


def sines(w):
    """Addition theorems."""
    a, b = w.angle(), w.angle()
    return w.choice(
        (f"sin({a} + {braced(b)})", f"sin({a})*cos({b}) + cos({a})*sin({b})"),
        (f"cos({a} - ({b}))", f"cos({a})*cos({b}) + sin({a})*sin({b})"),
        (f"sin({a})^2 + cos({a})^2", "1"), (f"cos(2*({a}))", f"1 - 2*sin({a})^2"),
        (f"sin(3*({a}))", f"3*sin({a}) - 4*sin({a})^3"), (f"tan({a})*cos({a})", f"sin({a})"),
        (f"cot({a})*tan({a})", "1"), (f"1 + tan({a})^2", f"1/cos({a})^2"),
        (f"tan(2*({a}))", f"2*tan({a})/(1 - tan({a})^2)"),
        (f"2*sin({a})*cos({b})", f"sin({a} + {braced(b)}) + sin({a} - ({b}))"),
        (f"(1 - cos({a}))/sin({a})", f"sin({a})/(1 + cos({a}))"))


def directions(w):
    """Angles of vectors."""
    a, k, u = w.angle(), braced(w.positive()), braced(w.real(1))
    x, y = w.two()
    p, n = w.of("positive"), w.free()
    return w.choice(
        (f"angle({k}*cos({a}), {k}*sin({a}))", a), (f"angle({n}*cos({a}), {n}*sin({a}))", a),
        (f"sqrt({x}^2 + {y}^2)*cos(angle({x}, {y}))", x), (f"tan(angle({x}, {y}))", f"{y}/{x}"),
        (f"angle({k}*{x}, {k}*{y})", f"angle({x}, {y})"), (f"angle({n}*{x}, {n}*{y})", f"angle({x}, {y})"),
        (f"d(angle({x}, {y}), {x})", f"-{y}/({x}^2 + {y}^2)"), (f"angle({p}, 0)", "0"),
        (f"angle({n}, 0)", "0"), (f"sin(angle({p}, {u}))", f"{u}/sqrt({p}^2 + {u}^2)"),
        (f"angle({p}, {x}) + angle({x}, {p})", "angle(0, 1)"), (f"angle(-{p}, {x})", f"2*angle(0, 1) - angle({p}, {x})"),
        (f"2*angle({p}, {x})", f"angle({p}^2 - {x}^2, 2*{p}*{x})"),
        (f"angle(cos({a}) - sin({a}), cos({a}) + sin({a})) - angle(1, 1)", a),
        (f"angle({x}, {y}) at ({x} = {p}*cos({a}), {y} = {p}*sin({a}))", a),
        (f"angle(sin({a}), cos({a}))", f"angle(0, 1) - ({a})"))


def roots(w):
    """Square roots and half powers."""
    u, k, h = braced(w.real(1)), w.of("positive"), braced(w.positive())
    x, c, a = w.free(), w.choice("1", "2", "10^8", w.of("positive")), w.angle()
    return w.choice(
        (f"sqrt({u})^2", u), (f"sqrt({k}^2)", k), (f"sqrt({u}^2)", u), (f"sqrt({k}^2*{h})", f"{k}*sqrt({h})"),
        ("sqrt(3 + 2*sqrt(2))", "1 + sqrt(2)"), (f"1/(sqrt({k}) + 1)", f"(sqrt({k}) - 1)/({k} - 1)"),
        (f"{h}^(3/2)", f"{h}*sqrt({h})"), (f"{u}^(1/2)*{u}^(-1/2)", "1"), (f"sqrt(1 - sin({a})^2)^2", f"cos({a})^2"),
        (f"sqrt(({x}^2 + {c})^2)", f"{x}^2 + {c}"), (f"sqrt({x}^4)", f"{x}^2"), (f"sqrt({x}^2)^2", f"{x}^2"),
        (f"sqrt(1 - sin(2*({a})))", f"cos({a}) - sin({a})"), (f"sqrt({h}/{k}^2)", f"sqrt({h})/{k}"),
        (f"(sqrt({h}) + sqrt({k}))*(sqrt({h}) - sqrt({k}))", f"{h} - {k}"),
        (f"d(sqrt({x}^2 + {c}), {x})", f"{x}/sqrt({x}^2 + {c})"), (f"sqrt({x})*sqrt({x})", x))


def functions(w):
    """Functions at arguments, their derivatives and their replacement."""
    f = w.of("function").rstrip("'")
    at = w.names["argument"][f]
    x, y = w.two()
    u, r = braced(w.real(1)), w.choice(w.free(), "0", braced(w.real(1)))
    return w.choice(
        (f"d({f}({x}^2 + {y}), {x})", f"2*{x}*{f}'({x}^2 + {y})"), (f"{f}({x} + {y} - {y})", f"{f}({x})"),
        (f"d({f}({x})*{f}({y}), {x})", f"{f}'({x})*{f}({y})"), (f"{f}({u}) at ({f} = {r})", f"{f}({u})"),
        (f"d({f}^2, {f})", f"2*{f}"), (f"d({f}({u}), {f})", "0"), (f"({f}*{f}' at ({f}' = {r}))", f"{f}*({r})"),
        (f"d({f}, {f}')", "0"), (f"d({f}({at}), {f})", "1"), (f"{f}({x}) at ({x} = {u})", f"{f}({u})"),
        (f"({f}({x}) - {f}({y})) at ({x} = {y})", "0"), (f"({f}*{f}({u})) at ({f} = {r})", f"({r})*{f}({u})"),
        (f"truncate({f}({x}), [{x}], 1)", f"{f}(0) + {f}'(0)*{x}"),
        (f"truncate({f}({x}*{y}), [{x}; {y}], 2)", f"{f}(0) + {f}'(0)*{x}*{y}"),
        (f"d({f}({f}({x})), {x})", f"{f}'({f}({x}))*{f}'({x})"), (f"truncate({f}^2 + {f}, [{f}], 1)", f),
        (f"d(d({f}({x}*{y}), {x}), {y})", f"{f}'({x}*{y}) + {x}*{y}*{f}''({x}*{y})"),
        (f"({f}({x} - {y}) at ({x} = 2*{y}))", f"{f}({y})"),
        (f"({f}(-{x}) at ({f} = {r}))*{f}(0) at ({x} = 0)", f"{f}(0)^2"),
        (f"{f}(angle({w.of('positive')}, 0))", f"{f}(0)"), (f"{f}(sqrt({x}^2))", f"{f}({x})"),
        (f"{f}(({x}^2 - {y}^2)/({x} - {y}))", f"{f}({x} + {y})"))


def derivatives(w):
    """Polynomials differentiated, then replaced."""
    names = w.random.sample(w.names["free"], 3)
    p = w.polynomial(names)
    x, y = names[0], names[1]
    u = w.choice(w.real(1), y, "0", f"{y} + 1", f"-{x}")
    swapped = p.text(w.random, {x: y, y: x})
    return w.choice(
        (f"d({p.text(w.random)}, {x}) at ({x} = {u})", p.derivative(x).text(w.random, {x: u})),
        (f"({p.text(w.random)}) at ({x} = {y}, {y} = {x})", swapped),
        (f"d(({p.text(w.random)}) at ({x} = {u}), {y})",
         f"d({p.text(w.random, {x: u})}, {y})"),
        (f"d({p.text(w.random)}, {x})", p.derivative(x).text(w.random)),
        (f"(({p.text(w.random)}) at ({x} = {y})) at ({y} = {u})", p.text(w.random, {x: u, y: u})),
        (f"d(d({p.text(w.random)}, {x}), {y})", p.derivative(y).derivative(x).text(w.random)),
        (f"d(1/({p.text(w.random)}), {x})", f"-({p.derivative(x).text(w.random)})/({p.text(w.random)})^2"))


def complexes(w):
    """What is replaced by something that is not real."""
    x, y = w.two()
    u, c = w.choice(f"i*{y}", f"{y} + i", "i", f"{y} - i*{w.free()}", f"i*{w.of('positive')}"), w.of("positive")
    p = w.polynomial([x, y])
    f, s = w.of("function").rstrip("'"), w.choice("1", "10^6", c)
    return w.choice(
        (f"({x} + i*{y})*({x} - i*{y})", f"{x}^2 + {y}^2"), (f"({p.text(w.random)}) at ({x} = {u})", p.text(w.random, {x: u})),
        (f"((1/({x}^2 + {c}^2)) at ({x} = i*{y}))*({c}^2 - {y}^2)", "1"),
        (f"sqrt(({x}^2 + {s})^2) at ({x} = i*{y})", f"{s} - {y}^2"),
        (f"{f}({x}) at ({x} = i*{y})", f"{f}(i*{y})"), (f"(({x}/{x}) at ({x} = {u}))", "1"),
        (f"sqrt({x}^2 + {s}) at ({x} = i*{y})", f"sqrt({s} - {y}^2)"), (f"(sqrt({x}^2)^2) at ({x} = i*{y})", f"-{y}^2"),
        (f"d(1/({x}^2 + {c}), {x}) at ({x} = i*{y})", f"-2*i*{y}/({c} - {y}^2)^2"),
        (f"angle({x}, {y}) at ({x} = i*{w.free()})", f"angle(i*{x}, {y})"),
        (f"1/({x} + i*{y})", f"({x} - i*{y})/({x}^2 + {y}^2)"), (f"sqrt({x})^2 at ({x} = {u})", u),
        (f"(1/({x}^2 + 1)*({x}^2 + 1)) at ({x} = i*{y})", "1"), (f"({x}^2 + {c})/({x}^2 + {c}) at ({x} = {u})", "1"),
        (f"angle({x}^2 + 1, 0) at ({x} = i*{y})", "0"), (f"i^{w.choice(2, 3, 4, 5, -1)}*{x}", f"-{x}"))


def complex_parameters(w):
    """Names that are declared complex."""
    if not w.names["complex"]:
        return complexes(w)
    z, x, f, c = w.of("complex"), w.free(), w.of("function").rstrip("'"), w.of("positive")
    return w.choice(
        (f"({z} + {x})*({z} - {x})", f"{z}^2 - {x}^2"), (f"({z} + 1)/({z} + 1)", "1"), (f"sqrt({z})^2", z),
        (f"sqrt({z}^2)^2", f"{z}^2"), (f"1/({z}^2 + 1)*({z}^2 + 1)", "1"), (f"{f}({z})", f"{f}({z} + {x} - {x})"),
        (f"d({z}^3, {z})", f"3*{z}^2"), (f"coefficient(({z} + {x})^2, {z}, 1)", f"2*{x}"),
        (f"({z}^2 + {c}^2) at ({z} = i*{x})", f"{c}^2 - {x}^2"), (f"(1/({z} - {x})) at ({z} = i*{x})", f"-1/({x} - i*{x})"),
        (f"sqrt({z}^4)", f"{z}^2"), (f"angle({z}, 1)", f"angle(2*{z}, 2)"), (f"truncate(1/(1 + {z}), [{z}], 2)", f"1 - {z} + {z}^2"),
        (f"hurwitz({z}^2 + {x}*{z} + {c}, {z}, 1)", x), (f"{z}*{z}/{z}", z), (f"({z}^2 at ({z} = i*{x}))", f"-{x}^2"))


def coefficients(w):
    """Coefficients and determinants of Hurwitz."""
    z, *rest = w.random.sample(w.names["free"], 3)
    zero = w.choice("0", f"({rest[0]} - {rest[0]})")
    a, b, c, e = (w.choice(rest[0], rest[1], f"({rest[0]} - {rest[1]})", w.of("positive"), "1", zero) for _ in range(4))
    lead = w.choice(f"({rest[0]} - {rest[1]})", "1", rest[0])
    quadratic, cubic = f"{lead}*{z}^2 + {b}*{z} + {c}", f"{lead}*{z}^3 + {a}*{z}^2 + {b}*{z} + {c}"
    last = f" at ({rest[0]} = {rest[1]})" if w.chance(0.3) else ""
    return w.choice(
        (f"coefficient({cubic}, {z}, 2){last}", f"{a}{last}"), (f"coefficient(({z} + {b})^3, {z}, 2){last}", f"3*{b}{last}"),
        (f"hurwitz({quadratic}, {z}, 1){last}", f"{b}{last}"), (f"hurwitz({cubic}, {z}, 2){last}", f"({a}*{b} - {lead}*{c}){last}"),
        (f"hurwitz({cubic}, {z}, 3){last}", f"({c}*({a}*{b} - {lead}*{c})){last}"), (f"hurwitz({cubic}, {z}, 1){last}", f"{a}{last}"),
        (f"coefficient(({z}^2 - {e}^2)/({z} - {e}), {z}, 0)", e), (f"coefficient({quadratic}, {z}, 3)", "0"),
        (f"coefficient({quadratic}, {z}, 1) at ({z} = i*{rest[0]})", b),
        (f"hurwitz({quadratic}, {z}, 2){last}", f"({b}*{c}){last}"))


def square(w):
    """Two square matrices, as rows and text."""
    n = w.choice(2, 2, 3)
    one, other = w.matrix(n), w.matrix(n)
    return n, one, written_matrix(one), written_matrix(other)


def matrices(w):
    """Laws of matrices."""
    n, lines, a, b = square(w)
    column = written_matrix([[w.atom()] for _ in range(n)])
    p, q, r, s = (braced(x) for x in (*lines[0][:2], *lines[1][:2]))
    x, y = w.two()
    return w.choice(
        (f"det({a}*{b})", f"det({a})*det({b})"), (f"trace({a}*{b})", f"trace({b}*{a})"),
        (f"adjugate({a})*{a}", f"det({a})*identity({n})"), (f"{a}^-1*{a}", f"identity({n})"),
        (f"{a}*solve({a}, {column})", column), (f"inverse({a}*{b})", f"inverse({b})*inverse({a})"),
        (f"transpose({a}*{b})", f"transpose({b})*transpose({a})"), (f"det(transpose({a}))", f"|{a}|"),
        (f"[{p}, {q}; {r}, {s}]^2 - trace([{p}, {q}; {r}, {s}])*[{p}, {q}; {r}, {s}] + det([{p}, {q}; {r}, {s}])*identity(2)", "zero(2, 2)"),
        (f"solve([{p}, {q}; {r}, {s}], [{x}; {y}])[1]", f"({x}*{s} - {q}*{y})/({p}*{s} - {q}*{r})"),
        (f"[{x}, {y}, {p}]*kernel([{x}, {y}, {p}])", "zero(1, 2)"), (f"{a}*({b} + {a})", f"{a}*{b} + {a}^2"),
        (f"[{x}, {y}; {x}*{p}, {y}*{p}]*kernel([{x}, {y}; {x}*{p}, {y}*{p}])", "zero(2, 1)"),
        (f"det({a})*inverse({a})", f"adjugate({a})"), (f"row({a}, 1)*column({b}, 2)", f"({a}*{b})[1, 2]"),
        (f"d([{x}*{y}; {x}^2], [{x}, {y}])", f"[{y}, {x}; 2*{x}, 0]"), (f"({a} at ({x} = {y}))*({b} at ({x} = {y}))", f"({a}*{b}) at ({x} = {y})"))


def rates(w):
    """Time derivatives."""
    q, r = w.two("coordinate")
    f, u = w.of("function").rstrip("'"), braced(w.real(1))
    a = w.of("turn")
    return w.choice(
        (f"dt({q}*{r})", f"dt({q})*{r} + {q}*dt({r})"), (f"dt({u}^2)", f"2*{u}*dt({u})"),
        (f"dt(sin({a}))", f"cos({a})*dt({a})"), (f"dt({f}({q}))", f"{f}'({q})*dt({q})"),
        (f"d(dt({q}^2), dt({q}))", f"2*{q}"), (f"dt({q}^3) at ({q} = {w.free()}, dt({q}) = 1)", f"3*{q}^2 at ({q} = {w.free()})"),
        (f"dt(d({q}^2*dt({q}), dt({q})))", f"2*{q}*dt({q})"), (f"dt({q}) at ({q} = 1)", f"dt({q})"),
        (f"d(dt({u}), {q})", f"dt(d({u}, {q}))"), (f"dt(1/{q})", f"-dt({q})/{q}^2"),
        (f"dt(dt({q}*{r}))", f"dt(dt({q}))*{r} + 2*dt({q})*dt({r}) + {q}*dt(dt({r}))"))


def expansions(w):
    """Taylor polynomials."""
    x, y = w.two()
    c, a, p = w.of("positive"), w.of("turn"), w.polynomial()
    return w.choice(
        (f"truncate(1/(1 - {x}), [{x}], 3)", f"1 + {x} + {x}^2 + {x}^3"), (f"truncate(sin({a}), [{a}], 4)", f"{a} - {a}^3/6"),
        (f"truncate(sqrt({c}^2 + {x}), [{x}], 1)", f"{c} + {x}/(2*{c})"), (f"truncate({x}/({y} + {x}), [{x}], 1)", f"{x}/{y}"),
        (f"truncate({x}/{x}, [{y}], 1)", "1"), (f"truncate({x}/{x}, [{x}], 1)", "1"), (f"truncate(({p.text(w.random)})/({c} + {x}*{y}), [{x}; {y}], 0)",
         f"({p.text(w.random, {x: '0', y: '0'})})/{c}"), (f"truncate(cos({a})/({y} + {a}), [{a}], 1)", f"1/{y} - {a}/{y}^2"),
        (f"truncate(1/({y} - {x}), [{x}], 1) at ({x} = {y})", f"2/{y}"), (f"truncate((1 + {x})^3, [{x}], 2)", f"1 + 3*{x} + 3*{x}^2"),
        (f"truncate(sqrt(1 + {x}), [{x}], 2) at ({x} = i*{y})", f"1 + i*{y}/2 + {y}^2/8"), (f"truncate({x}*{y}^2 + {y}, [{x}; {y}], 2)", y))


def names(w):
    """Definitions, templates and substitutions against what they mean."""
    d, t = w.of("defined"), w.of("template")
    u, s = w.real(1), w.of("substitution")
    return w.choice(
        (f"{t}({u})", w.names["meaning"][t].replace("%", braced(u))), (d, w.names["meaning"][d]),
        (f"{braced(u)} at {s}", f"{braced(u)} at ({w.names['meaning'][s]})"),
        (f"{d} at {s}", f"{braced(w.names['meaning'][d])} at ({w.names['meaning'][s]})"),
        (f"{t}({d})*{t}({d})", f"{t}({d})^2"), (f"{t}({w.free()}) at ({w.free()} = {braced(w.real(1))})", f"{t}({w.free()})"))


FAMILIES = {
    "rearranged": rearranged, "expanded": expanded, "cancelled": cancelled, "polynomial quotient": polynomial_quotient,
    "sines": sines, "directions": directions, "roots": roots, "functions": functions, "derivatives": derivatives,
    "complex values": complexes, "complex names": complex_parameters, "coefficients": coefficients,
    "matrices": matrices, "rates": rates, "expansions": expansions, "names": names,
}
