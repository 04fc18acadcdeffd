"""Coefficients and degrees of expressions that are polynomials in a variable."""

from fractions import Fraction
from math import comb

from mpmath import mpf

import series
from frame import Frame
from series import NoValue, Unknown, is_zero, multiply, total
from syntax import number

SHIFTS = tuple(number(Fraction(n, 10 ** 8)) for n in (83712519, -61803397, 127323954))


class Polynomials:
    """The part of an evaluator that knows polynomials."""

    def coefficients(self, polynomial, variable, context):
        """All coefficients, by an expansion about some place; it must have a value at its own."""
        self.value(polynomial, context)
        for shift in SHIFTS:
            try:
                return self.coefficients_about(shift, polynomial, self.variable(variable), context)
            except NoValue:
                continue
        raise Unknown("a polynomial without values at other places")

    def coefficients_about(self, shift, polynomial, variable, context):
        """The same about this place."""
        about = self.value(shift, context)
        for order in (6, 14, 30):
            inner = context.within(Frame.of("shift", [(variable, shift)], order))
            terms = self.scalar(polynomial, inner)
            terms = terms.terms if series.level(terms) == inner.level else [terms] + [mpf(0)] * order
            if all(series.is_null(term) for term in terms[order - 1:]):
                return [total(multiply(terms[k], comb(k, n) * (-about) ** (k - n)) for k in range(n, order + 1))
                        for n in range(order + 1)] + [mpf(0)] * 64
        raise Unknown("not a polynomial, or one of a high degree")

    def degree(self, polynomial, variable, context):
        """The degree of a polynomial in general, as a function of the variables that it is."""
        key = (polynomial, variable)
        if key not in self.degrees:
            found = []
            for companion in self.companions[:3]:
                try:
                    terms = self.coefficients(polynomial, variable, companion)
                except NoValue:
                    continue
                found.append(max((n for n, term in enumerate(terms) if not is_zero(term)), default=-1))
            self.degrees[key] = max(found, default=-1)
        if self.degrees[key] < 0:
            raise Unknown("the degree of a polynomial that is 0")
        return self.degrees[key]
