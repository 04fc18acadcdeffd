"""The angle of a vector, which is a sum of declared angles where the vector points along one."""

from mpmath import mpf

import series
from frame import Frame, slope
from series import NoValue, add, constant, is_zero, multiply
from writing import own_names


class Directions:
    """The part of an evaluator that knows angles of vectors."""

    def declared_direction(self, arguments, context, x, y, frames):
        """The angle of a vector, with the declared angles found in general within these frames."""
        key = (*arguments, frames)
        if key not in self.directions:
            self.directions[key] = self.whole_combination(arguments, frames)
        combination = self.directions[key]
        outer = context
        while frames and outer.parent is not None:
            outer = outer.parent
        if combination is not None:
            angle = mpf(0)
            for variable, n in combination:
                angle = add(angle, multiply(mpf(n), self.look_up(variable, outer)))
            x0, y0, a0 = constant(x), constant(y), constant(angle)
            length = add(multiply(x0, series.cosine(a0)), multiply(y0, series.sine(a0)))
            if series.real(length, "the angle") > 0 and not is_zero(length):
                return angle
        return series.direction(x, y)

    def whole_combination(self, arguments, frames):
        """Which sum of declared angles the angle of a vector is up to half turns, in general."""
        found = []
        for name, declared in sorted(self.document.variables.items()):
            if declared.kind not in ("angle", "coordinate") or not self.occurs(name, arguments, frames):
                continue
            slopes = [self.turning(("v", name, 0), arguments, frames, companion) for companion in self.companions[:3]]
            slopes = [value for value in slopes if value is not None]
            if not slopes or any(abs(value - slopes[0]) > 1e-30 or abs(value - mp_round(value)) > 1e-30
                                 for value in slopes):
                return None
            if mp_round(slopes[0]):
                found.append((("v", name, 0), mp_round(slopes[0])))
        return found if found and self.is_direction(arguments, frames, found) else None

    def turning(self, variable, arguments, frames, companion):
        """The derivative of the angle of a vector by a declared angle."""
        first = companion.within(Frame.of("d", [(variable, None)]))
        inner = first.nested(frames)
        try:
            x, y = (self.scalar(argument, inner) for argument in arguments)
        except NoValue:
            return None
        (x, dx), (y, dy) = (parts(value, first.level) for value in (x, y))
        size = x * x + y * y
        return None if is_zero(size) else (x * dy - y * dx) / size

    def is_direction(self, arguments, frames, combination):
        """Whether a vector points along a sum of declared angles, or against it, in general."""
        compared = 0
        for companion in self.companions:
            try:
                x, y = (constant(self.scalar(argument, companion.nested(frames))) for argument in arguments)
            except NoValue:
                continue
            angle = sum(n * companion.base.variable(variable) for variable, n in combination)
            compared += 1
            if not is_zero(x * series.sine(angle) - y * series.cosine(angle)):
                return False
        return compared > 0

    def occurs(self, name, arguments, frames):
        """Whether a name occurs in expressions or in what replaces names within frames."""
        inside = list(arguments) + [e for frame in frames for e in frame.variables.values() if e is not None]
        inside += [e for frame in frames for _, e in frame.functions if e is not None]
        return any(name in self.names_in(part) for part in inside)

    def names_in(self, part):
        """All names in an expression, through definitions, too."""
        if part not in self.occurring:
            self.occurring[part] = set()
            found = set()
            for name in own_names(part):
                found.add(name)
                if name in self.document.definitions:
                    found |= self.names_in(self.document.definitions[name])
                if name in self.document.templates:
                    found |= self.names_in(self.document.templates[name][1])
                if name in self.document.substitutions:
                    for _, e in self.document.substitutions[name]:
                        found |= self.names_in(e)
                declared = self.document.variables.get(name)
                if declared is not None and declared.argument is not None:
                    found |= self.names_in(declared.argument)
            self.occurring[part] = found
        return self.occurring[part]


def parts(value, level):
    """The number in a value and that of its slope at a low level."""
    while series.level(value) > level:
        value = value.terms[0]
    return constant(value), constant(slope(value, level))


def mp_round(value):
    """The nearest whole number."""
    return int(series.mp.nint(value.real))
