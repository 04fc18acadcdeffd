"""What stands around an expression that is evaluated: replacements and small quantities."""

from mpmath import mpf

import series
from series import Series


class Frame:
    """Which variables are replaced, and how: by an expression (`at`), by themselves and a small
    quantity (`d`, `dt`), by themselves times one (`truncate`), by a number and one (`shift`)."""

    known = {}

    def __init__(self, kind, replaced, order):
        self.kind, self.order = kind, order
        self.variables = {v: e for v, e in replaced if v[0] != "f"}
        self.functions = [(v, e) for v, e in replaced if v[0] == "f"]

    @staticmethod
    def of(kind, replaced=(), order=1):
        """The one frame of this kind; `replaced` pairs variables with expressions."""
        key = (kind, tuple(replaced), order)
        if key not in Frame.known:
            Frame.known[key] = Frame(kind, tuple(replaced), order)
        return Frame.known[key]


class Context:
    """Frames over an assignment, with the values that were found in it."""

    def __init__(self, base, frames=(), parent=None):
        self.base, self.frames, self.parent = base, frames, parent
        self.level, self.values, self.looked, self.children = len(frames), {}, {}, {}

    def within(self, frame):
        """The context with one more frame inside."""
        if frame not in self.children:
            self.children[frame] = Context(self.base, (*self.frames, frame), self)
        return self.children[frame]

    def nested(self, frames):
        """The context with more frames inside."""
        found = self
        for frame in frames:
            found = found.within(frame)
        return found


def perturbed(value, frame, level):
    """A variable with a small quantity added, or times one."""
    if frame.kind == "d":
        return Series(level, [value, mpf(1)])
    return Series(level, [mpf(0), value] + [mpf(0)] * (frame.order - 1) if frame.order else [mpf(0)])


def slope(value, level):
    """The coefficient of the small quantity."""
    return value.terms[1] if series.level(value) == level else mpf(0)
