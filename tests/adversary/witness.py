"""A point of a report read back as an assignment: values, sines and cosines, functions at arguments."""

import re

from mpmath import mp, mpc, mpf

import series
from assignment import MANNERS, Assignment
from frame import Context
from writing import exact
from series import Mistake, NoValue, Unknown, constant
from syntax import Unreadable, expression

CLOSE = mpf(10) ** -9
NEVER, EQUAL, CONFIRMED = "no assignment", "equal sides", "confirmed"


class Point:
    """What is shown of an assignment."""

    def __init__(self, oracle, shown):
        self.oracle, self.document = oracle, oracle.document
        self.values, self.functions, self.turns, self.unread, self.near = {}, [], [], [], []
        for name, text in shown.items():
            try:
                self.read(expression(name), value(text), name)
            except (Unreadable, Mistake, ValueError, IndexError):
                self.unread.append(name)

    def read(self, part, number, name):
        """One line of it."""
        if part.kind == "call" and part.parts[0] in ("sin", "cos"):
            self.turns.append((part.parts[0], self.form(part.parts[1]), number))
            return
        variable = self.oracle.evaluator.variable(part)
        if variable is None:
            self.unread.append(name)
        elif variable[0] == "f" and "." in name:
            self.near.append((variable[1], variable[2], of(variable[3]), number))
        elif variable[0] == "f":
            self.functions.append((variable, number))
        else:
            self.values[variable] = number

    def form(self, part, factor=1, found=None):
        """A sum of angles as their coefficients."""
        found = {} if found is None else found
        kind = part.kind
        if kind in ("add", "subtract"):
            self.form(part.parts[0], factor, found)
            self.form(part.parts[1], factor if kind == "add" else -factor, found)
        elif kind == "negate":
            self.form(part.parts[0], -factor, found)
        elif kind == "multiply":
            self.form(part.parts[1], factor * int(exact(part.parts[0])), found)
        else:
            variable = self.oracle.evaluator.variable(part)
            if variable is None or variable[0] == "f":
                raise Mistake("not a sum of angles")
            found[variable] = found.get(variable, 0) + factor
        return found

    def assignment(self, manner):
        """An assignment with this point; what is not shown is drawn. Nothing if the point is none."""
        sampler, random = self.oracle.sampler, self.oracle.random
        found = Assignment(dict(self.values), lambda: sampler.real(manner, 0))
        found.draw_variable = lambda variable: sampler.value(variable, manner, 0, found)
        found.near = self.near
        shown = set(self.values)
        for form, measure in self.measures():
            free = [variable for variable in form if variable not in shown]
            if not free:
                continue
            pivot = min(free, key=lambda variable: abs(form[variable]))
            rest = sum(n * found.variable(variable) for variable, n in form.items() if variable != pivot)
            shown.update(form)
            turns = random.choice([0, 0, 0, 1, -1, 2, -2, 3, -3, random.randint(-9, 9)])
            found.values[pivot] = (measure - rest + 2 * mp.pi * turns) / form[pivot]
        if not self.agrees(found):
            return None
        try:
            self.give_functions(found)
        except (NoValue, Unknown, Mistake):
            return None
        for name, declared in self.document.variables.items():
            if declared.kind != "function":
                found.variable(("v", name, 0))
        return found

    def measures(self):
        """The forms whose sine and cosine are shown, with an angle that has them."""
        forms = {}
        for which, form, number in self.turns:
            forms.setdefault(tuple(sorted(form.items())), {})[which] = number
        found = []
        for form, shown in sorted(forms.items(), key=lambda item: len(item[0])):
            sine, cosine = shown.get("sin"), shown.get("cos")
            if sine is None:
                sine = mp.sqrt(max(0, 1 - cosine ** 2)) * self.oracle.random.choice([1, -1])
            if cosine is None:
                cosine = mp.sqrt(max(0, 1 - sine ** 2)) * self.oracle.random.choice([1, -1])
            found.append((dict(form), mp.atan2(sine, cosine)))
        return found

    def agrees(self, found):
        """Whether the sines and cosines of an assignment are those that are shown."""
        for which, form, number in self.turns:
            measure = sum(n * found.variable(variable) for variable, n in form.items())
            if abs((mp.sin if which == "sin" else mp.cos)(measure) - number) > CLOSE:
                return False
        return True

    def give_functions(self, found):
        """Gives functions their values at the arguments as they are at an assignment."""
        context = Context(found)
        for (_, name, order, argument), number in self.functions:
            place = series.real(constant(self.oracle.evaluator.scalar(argument, context)), "a function")
            key = (name, order, int(mp.nint(place * mpf(10) ** 50)))
            if abs(found.functions.get(key, number) - number) > CLOSE:
                raise NoValue("a function with two values at one place")
            found.functions[key] = number

    def check(self, differs, tries=60):
        """Whether an assignment with this point satisfies everything, and its sides differ."""
        best = NEVER
        for number in range(tries):
            found = self.assignment(MANNERS[number % len(MANNERS)])
            if found is None or not self.satisfied(found):
                continue
            result = differs(found)
            if result == CONFIRMED:
                return CONFIRMED
            best = result if best == NEVER or result == EQUAL else best
        return best

    def satisfied(self, found):
        """Whether everything is satisfied, perhaps after what is not shown is drawn again."""
        sampler = self.oracle.sampler
        if sampler.satisfies(found):
            return True
        hidden = [variable for variable in found.values if variable not in self.values
                  and not any(variable in form for _, form, _ in self.turns)]
        for _ in range(30 if hidden else 0):
            variable = self.oracle.random.choice(hidden)
            old, before = found.values[variable], sampler.broken(found)
            found.values[variable] = sampler.value(variable, self.oracle.random.choice(MANNERS), 0, found)
            after = sampler.broken(found)
            if after == 0:
                return True
            if after > before:
                found.values[variable] = old
        return False


def value(text):
    """A number as it is shown: exact, a decimal, or the middle of an enclosure."""
    text = text.replace("…", "").strip().lstrip("≈").strip()
    bounds = re.fullmatch(r"\[(.*),(.*)\]|(.*)\.\.(.*)", text)
    if bounds:
        low, high = [part for part in bounds.groups() if part is not None]
        return (value(low) + value(high)) / 2
    text = re.split(r"±", text)[0]
    scientific = re.fullmatch(r"\s*([-+]?\d+(?:\.\d+)?)[eE]([-+]?\d+)\s*", text)
    if scientific:
        return mpf(scientific.group(1)) * mpf(10) ** int(scientific.group(2))
    return of(expression(text))


def of(part):
    """The value of an expression of numbers and roots, of −1 too."""
    kind, parts = part.kind, part.parts
    if kind == "number":
        return mpf(parts[0].numerator) / parts[0].denominator
    if kind == "negate":
        return -of(parts[0])
    if kind == "name" and parts[0] in ("i", "I"):
        return mpc(0, 1)
    if kind == "call" and parts[0] == "sqrt":
        inner = series.tidy(of(parts[1]))
        return mpc(0, mp.sqrt(-inner)) if inner < 0 else mp.sqrt(inner)
    if kind in ("add", "subtract", "multiply", "divide", "power"):
        a, b = (of(inner) for inner in parts)
        return {"add": lambda: a + b, "subtract": lambda: a - b, "multiply": lambda: a * b,
                "divide": lambda: a / b, "power": lambda: mp.power(a, b)}[kind]()
    raise ValueError("not a number")
