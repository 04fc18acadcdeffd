"""Random expressions in the block language, as text, over the names of one random document."""


def braced(text):
    """A text in brackets where it is more than a name or a number."""
    plain = text.replace("_", "").replace("'", "")
    return text if plain.isalnum() else f"({text})"


class Polynomial:
    """A polynomial with whole coefficients in names, which can be written in several ways."""

    def __init__(self, terms):
        self.terms = {powers: c for powers, c in terms.items() if c}

    @staticmethod
    def drawn(random, names, terms=3, degree=3):
        """A random one in these names."""
        found = {}
        for _ in range(random.randint(1, terms)):
            powers = [0] * len(names)
            for _ in range(random.randint(0, degree)):
                powers[random.randrange(len(names))] += 1
            key = tuple((name, n) for name, n in zip(names, powers) if n)
            found[key] = found.get(key, 0) + random.choice([1, 1, 2, 3, -1, -2, 5])
        return Polynomial(found)

    def times(self, other):
        """The product."""
        found = {}
        for one, c in self.terms.items():
            for two, e in other.terms.items():
                powers = dict(one)
                for name, n in two:
                    powers[name] = powers.get(name, 0) + n
                key = tuple(sorted(powers.items()))
                found[key] = found.get(key, 0) + c * e
        return Polynomial(found)

    def plus(self, other, factor=1):
        """The sum."""
        found = {}
        for terms, sign in ((self.terms, 1), (other.terms, factor)):
            for key, c in terms.items():
                key = tuple(sorted(key))
                found[key] = found.get(key, 0) + sign * c
        return Polynomial(found)

    def derivative(self, name):
        """The derivative by a name."""
        found = {}
        for key, c in self.terms.items():
            powers = dict(key)
            n = powers.pop(name, 0)
            if n:
                if n > 1:
                    powers[name] = n - 1
                rest = tuple(sorted(powers.items()))
                found[rest] = found.get(rest, 0) + c * n
        return Polynomial(found)

    def text(self, random=None, values=None):
        """The polynomial in some order of its terms, with texts in place of names."""
        values = values or {}
        terms = list(self.terms.items())
        if random:
            random.shuffle(terms)
        written = []
        for powers, c in terms:
            factors = [braced(values.get(name, name)) + (f"^{n}" if n > 1 else "") for name, n in powers]
            if random:
                random.shuffle(factors)
            if abs(c) != 1 or not factors:
                factors.insert(0, str(abs(c)))
            written.append(("-" if c < 0 else "+", "*".join(factors)))
        if not written:
            return "0"
        first = ("-" if written[0][0] == "-" else "") + written[0][1]
        return first + "".join(f" {sign} {text}" for sign, text in written[1:])


class Writer:
    """Draws expressions over the names of a document."""

    def __init__(self, random, names):
        self.random, self.names = random, names

    def choice(self, *options):
        """One of some."""
        return self.random.choice(options)

    def chance(self, share):
        """True in a share of all cases."""
        return self.random.random() < share

    def of(self, kind):
        """A name of a kind."""
        return self.random.choice(self.names[kind])

    def free(self):
        """A parameter without a sign."""
        return self.of("free")

    def two(self, kind="free"):
        """Two different names of a kind."""
        return self.random.sample(self.names[kind], 2)

    def polynomial(self, names=None, terms=3, degree=3):
        """A polynomial in names."""
        names = names or self.random.sample(self.names["free"] + self.names["positive"], 3)
        return Polynomial.drawn(self.random, names, terms, degree)

    def angle(self):
        """A sum of angles with whole coefficients."""
        one = self.of("angle")
        form = self.random.randrange(7)
        if form < 3:
            return one
        if form == 3:
            return f"{self.choice(2, 3)}*{one}"
        other = self.of("angle")
        if other == one:
            return f"2*{one}"
        return f"{one} {self.choice('+', '-')} {self.choice('', '2*')}{other}"

    def positive(self, depth=1):
        """An expression that is above 0 by its signs."""
        form = self.random.randrange(6 if depth else 2)
        if form < 2:
            return self.of("positive")
        if form == 2:
            return f"{self.of('positive')}*{braced(self.positive(depth - 1))}"
        if form == 3:
            return f"{braced(self.real(depth - 1))}^2 + {self.choice('1', '2', self.of('positive'))}"
        if form == 4:
            return f"{self.of('positive')}/{braced(self.positive(depth - 1))}"
        return f"{self.of('positive')} + {braced(self.positive(depth - 1))}"

    def real(self, depth=2):
        """An expression that is real wherever it has a value."""
        if depth <= 0:
            return self.atom()
        random = self.random.random()
        if random < 0.45:
            return self.algebraic(depth)
        if random < 0.6:
            return self.trigonometric(depth)
        if random < 0.75:
            return self.called(depth)
        return self.operated(depth)

    def atom(self):
        """A name or a number."""
        form = self.random.randrange(12)
        if form < 6:
            return self.free()
        if form < 8:
            return self.of("positive")
        if form == 8:
            return self.choice("1", "2", "3", "1/2", "0.25")
        if form == 9:
            return self.of("coordinate")
        if form == 10:
            return self.of("defined")
        if self.names["complex"] and self.chance(0.15):
            return self.of("complex")
        return self.of("function")

    def algebraic(self, depth):
        """A sum, a product, a quotient or a power."""
        one, other = braced(self.real(depth - 1)), braced(self.real(depth - 1))
        form = self.random.randrange(9)
        if form < 3:
            return f"{one} {self.choice('+', '-')} {other}"
        if form < 6:
            return f"{one}*{other}"
        if form == 6:
            return f"{one}/{other}"
        if form == 7:
            return f"{one}^{self.choice(2, 3, -1, -2)}"
        return self.polynomial().text(self.random)

    def trigonometric(self, depth):
        """Something with sines."""
        form = self.random.randrange(6)
        angle = self.angle()
        if form < 4:
            return f"{self.choice('sin', 'cos', 'sin', 'cos', 'tan', 'cot')}({angle})"
        if form == 4:
            return f"{self.choice('sin', 'cos')}({angle})*{braced(self.real(depth - 1))}"
        return f"{angle} + {braced(self.real(depth - 1))}"

    def argument(self, depth):
        """An argument of a function, near to those that others take."""
        one = self.free()
        return self.choice(one, one, f"-{one}", f"2*{one}", f"{one} + {self.free()}", "0", "1", f"{one} + 1",
                           self.angle(), braced(self.real(depth - 1)))

    def called(self, depth):
        """A function at an argument, a root, an angle of a vector, a template."""
        form = self.random.randrange(8)
        if form < 4:
            name = self.of("function").rstrip("'")
            return f"{name}{self.choice('', '', chr(39))}({self.argument(depth)})"
        if form < 6:
            return f"sqrt({self.positive(depth - 1)})"
        if form == 6:
            return f"{self.of('template')}({self.real(depth - 1)})"
        return f"angle({self.positive(0)}, {self.real(depth - 1)})"

    def replacement(self, depth, imaginary=False):
        """A replacement, as a target and a text."""
        form = self.random.randrange(10)
        if form < 6:
            name = self.free()
            if imaginary:
                return name, self.choice(f"i*{self.free()}", f"i*{self.of('positive')}",
                                         f"{self.free()} + i*{self.free()}", "i")
            return name, self.choice(self.free(), "0", "1", f"-{self.free()}", f"{self.free()} + 1",
                                     self.real(depth - 1))
        if form == 6:
            return self.of("positive"), self.choice(self.of("positive"), "1", "2", f"{self.of('positive')} + 1")
        if form == 7:
            return self.of("angle"), self.choice("0", f"2*{self.of('angle')}", self.of("angle"))
        if form == 8:
            return self.of("function"), self.choice("0", self.free(), self.real(depth - 1))
        return self.of("coordinate"), self.choice("0", self.free(), "1")

    def replacements(self, depth, imaginary=False):
        """One or two replacements of different names."""
        found = dict(self.replacement(depth, imaginary) for _ in range(self.choice(1, 1, 2)))
        return "(" + ", ".join(f"{name} = {text}" for name, text in found.items()) + ")"

    def operated(self, depth):
        """Something replaced, differentiated, expanded, or an entry of a matrix."""
        inner, form = braced(self.real(depth - 1)), self.random.randrange(9)
        if form < 3:
            return f"{inner} at {self.replacements(depth)}"
        if form == 3:
            return f"{inner} at {self.of('substitution')}"
        if form < 6:
            return f"d({inner}, {self.variable()})"
        if form == 6:
            return f"dt({inner})"
        if form == 7:
            return f"truncate({inner}, [{self.free()}], {self.choice(0, 1, 2)})"
        return f"det([{inner}, {self.atom()}; {self.atom()}, {self.atom()}])"

    def variable(self):
        """What can be differentiated by."""
        return self.choice(self.free(), self.free(), self.free(), self.of("positive"), self.of("angle"),
                           self.of("function"), self.of("coordinate"))

    def matrix(self, n=2, entries=None):
        """A square matrix of simple entries."""
        draw = entries or (lambda: self.choice(self.atom(), self.free(), "0", "1", "-1",
                                               f"{self.free()} - {self.free()}"))
        return [[draw() for _ in range(n)] for _ in range(n)]


def written_matrix(lines):
    """Rows as text."""
    return "[" + "; ".join(", ".join(line) for line in lines) + "]"
