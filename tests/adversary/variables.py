"""Variables: names, rates, and the derivatives of declared functions at arguments."""

import series
from frame import perturbed
from mpmath import mpf
from series import NoValue, Series, Unknown, compose, constant, is_zero


class Variables:
    """The part of an evaluator that looks variables up, from the innermost frame outwards."""

    def function_symbol(self, name, primes):
        """The function and the order of derivative that a name means; `d2C` is C''."""
        declared = self.document.variables.get(name)
        if declared is not None:
            return (name, primes) if declared.kind == "function" else None
        if name[:1] == "d":
            digits = name[1:2] if name[1:2].isdigit() else ""
            rest = name[1 + len(digits):]
            declared = self.document.variables.get(rest)
            if declared is not None and declared.kind == "function":
                return rest, primes + int(digits or 1)
        return None

    def variable(self, part):
        """The variable that a part of an expression names, or nothing."""
        if part.kind == "call" and part.parts[0] == "dt":
            inner = self.variable(part.parts[1])
            return ("v", inner[1], inner[2] + 1) if inner and inner[0] == "v" else None
        if part.kind == "applied":
            symbol = self.function_symbol(part.parts[0], part.parts[1])
            return ("f", *symbol, part.parts[2]) if symbol else None
        if part.kind != "name":
            return None
        name, dots, primes = part.parts
        name = self.document.spellings.get(name, name)
        symbol = self.function_symbol(name, primes)
        if symbol and not dots:
            return ("f", *symbol, self.document.variables[symbol[0]].argument)
        declared = self.document.variables.get(name)
        if declared is None or primes or (dots and declared.kind != "coordinate"):
            return None
        return ("v", name, dots)

    def look_up(self, variable, context):
        """The value of a variable that is no function."""
        found = context.looked.get(variable)
        if found is None:
            found = context.looked[variable] = self.find(variable, context)
        return found

    def find(self, variable, context):
        """The value of a variable by the innermost frame."""
        if context.parent is None:
            return context.base.variable(variable)
        frame = context.frames[-1]
        if frame.kind == "dt":
            return self.moving(variable, context)
        if variable not in frame.variables:
            return self.look_up(variable, context.parent)
        if frame.kind == "at":
            return self.scalar(frame.variables[variable], context.parent)
        if frame.kind == "shift":
            shift = self.scalar(frame.variables[variable], context.parent)
            return Series(context.level, [shift, mpf(1)] + [mpf(0)] * (frame.order - 1))
        return perturbed(self.look_up(variable, context.parent), frame, context.level)

    def moving(self, variable, context):
        """A coordinate and its rate, a little later."""
        value = self.look_up(variable, context.parent)
        if self.document.variables[variable[1]].kind != "coordinate":
            return value
        return Series(context.level, [value, self.look_up(("v", variable[1], variable[2] + 1), context.parent)])

    def function(self, name, order, argument, context):
        """The value of a derivative of a declared function at an argument."""
        return self.resolve(name, order, argument, context, context, self.scalar(argument, context))

    def resolve(self, name, order, argument, inner, context, value):
        """The same by the frame of a context, for an argument with this value there."""
        if context.parent is None:
            return context.base.function(name, order, series.real(value, "a function"))
        series.must_be_smooth(value, "a function")
        frame = context.frames[-1]
        for (_, target, derivative, place), expression in frame.functions:
            if (target, derivative) == (name, order) and self.is_same(argument, inner.frames[context.level:], place):
                if frame.kind == "at":
                    return self.scalar(expression, context.parent)
                below = self.descend(name, order, argument, inner, context, value)
                return perturbed(below, frame, context.level)
        return self.descend(name, order, argument, inner, context, value)

    def descend(self, name, order, argument, inner, context, value):
        """The same by the frames further out, expanded in the small quantity of this one."""
        if series.level(value) != context.level:
            return self.resolve(name, order, argument, inner, context.parent, value)
        return compose(lambda n, c: self.resolve(name, order + n, argument, inner, context.parent, c), value)

    def is_same(self, argument, frames, place):
        """Whether two arguments are equal under every assignment at which both have values."""
        key = (argument, frames, place)
        if key not in self.same:
            self.same[key] = self.compare(argument, frames, place)
        return self.same[key]

    def compare(self, argument, frames, place):
        """The same by the companions, which are assignments in general."""
        compared = 0
        for companion in self.companions:
            try:
                one = constant(self.scalar(argument, companion.nested(frames)))
                other = constant(self.scalar(place, companion))
            except NoValue:
                continue
            compared += 1
            if not is_zero(one - other):
                return False
        if compared < 3:
            raise Unknown("arguments that could not be compared")
        return True
