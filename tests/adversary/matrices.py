"""Matrices of values; a matrix with one entry is a number."""

from mpmath import mpf

from series import (Mistake, NoValue, Series, Unknown, add, constant, divide, invert, is_zero, multiply, negate, subtract,
                    total)


class Matrix:
    """Rows of values."""

    __slots__ = ("rows",)

    def __init__(self, rows):
        self.rows = rows


def rows(value):
    """The rows of a value."""
    return value.rows if isinstance(value, Matrix) else [[value]]


def matrix(found):
    """A value with these rows."""
    return found[0][0] if len(found) == 1 and len(found[0]) == 1 else Matrix(found)


def shape(value):
    """Rows and columns."""
    found = rows(value)
    return len(found), len(found[0])


def entrywise(function, *values):
    """A function of entries at one place."""
    if not any(isinstance(value, Matrix) for value in values):
        return function(*values)
    if len({shape(value) for value in values}) != 1:
        raise Mistake("shapes do not fit")
    return Matrix([[function(*entries) for entries in zip(*lines)]
                   for lines in zip(*(rows(value) for value in values))])


def product(a, b):
    """The product, of which a number may be a factor."""
    if not isinstance(a, Matrix):
        return entrywise(lambda x: multiply(a, x), b)
    if not isinstance(b, Matrix):
        return entrywise(lambda x: multiply(x, b), a)
    if shape(a)[1] != shape(b)[0]:
        raise Mistake("shapes do not fit")
    return matrix([[total(multiply(x, row[j]) for x, row in zip(line, b.rows))
                    for j in range(shape(b)[1])] for line in a.rows])


def quotient(a, b):
    """A value by a number."""
    if isinstance(b, Matrix):
        raise Mistake("division by a matrix")
    return product(a, invert(b))


def transpose(a):
    """Rows for columns."""
    return matrix([list(line) for line in zip(*rows(a))])


def identity(n):
    """Ones on the diagonal."""
    return matrix([[mpf(i == j) for j in range(n)] for i in range(n)])


def square(a):
    """The rows of a square matrix."""
    if shape(a)[0] != shape(a)[1]:
        raise Mistake("not square")
    return rows(a)


def minor(lines, i, j):
    """The rows without one row and one column."""
    return [line[:j] + line[j + 1:] for k, line in enumerate(lines) if k != i]


def determinant_of(lines):
    """The determinant of rows, along the first of them."""
    if not lines:
        return mpf(1)
    if len(lines) == 1:
        return lines[0][0]
    found = mpf(0)
    for j, entry in enumerate(lines[0]):
        term = multiply(entry, determinant_of(minor(lines, 0, j)))
        found = subtract(found, term) if j % 2 else add(found, term)
    return found


def determinant(a):
    """The determinant; of large matrices by elimination."""
    lines = square(a)
    if len(lines) <= 5:
        return determinant_of(lines)
    return eliminated([list(line) for line in lines], len(lines))


def eliminated(lines, n):
    """The determinant by elimination, with the largest pivots."""
    found = mpf(1)
    for k in range(n):
        best = max(range(k, n), key=lambda i: abs(constant(lines[i][k])))
        if is_zero(constant(lines[best][k])):
            if any(isinstance(x, Series) for line in lines for x in line):
                raise Unknown("a large singular matrix")
            return mpf(0)
        if best != k:
            lines[k], lines[best], found = lines[best], lines[k], negate(found)
        found = multiply(found, lines[k][k])
        for i in range(k + 1, n):
            factor = divide(lines[i][k], lines[k][k])
            lines[i] = [subtract(x, multiply(factor, y)) for x, y in zip(lines[i], lines[k])]
    return found


def adjugate(a):
    """The transposed matrix of signed minors."""
    lines = square(a)
    n = len(lines)
    cofactors = [[determinant_of(minor(lines, j, i)) for j in range(n)] for i in range(n)]
    return matrix([[negate(x) if (i + j) % 2 else x for j, x in enumerate(line)]
                   for i, line in enumerate(cofactors)])


def inverse(a):
    """The inverse; its determinant must not be 0."""
    found = determinant(a)
    if is_zero(constant(found)):
        raise NoValue("the inverse of a singular matrix")
    return product(adjugate(a), invert(found))


def solve(a, b):
    """x with a·x = b."""
    return product(inverse(a), b)


def power(a, n):
    """A power of a square matrix."""
    square(a)
    if n < 0:
        return power(inverse(a), -n)
    found = identity(shape(a)[0])
    for _ in range(n):
        found = product(found, a)
    return found


def trace(a):
    """The sum along the diagonal."""
    return total(line[i] for i, line in enumerate(square(a)))


def blocks(lines):
    """A matrix whose entries may be matrices, row by row."""
    found = []
    for line in lines:
        parts = [rows(part) for part in line]
        if len({len(part) for part in parts}) != 1:
            raise Mistake("shapes do not fit")
        found += [sum(pieces, []) for pieces in zip(*parts)]
    if len({len(line) for line in found}) != 1:
        raise Mistake("shapes do not fit")
    return matrix(found)


def pivots(a):
    """The places of the columns that do not depend on those before them, for numbers."""
    lines = [[constant(x) for x in line] for line in rows(a)]
    found = []
    for j in range(shape(a)[1]):
        left = lines[len(found):]
        if not left:
            break
        best = max(range(len(left)), key=lambda i: abs(left[i][j]))
        if is_zero(left[best][j]):
            continue
        left[0], left[best] = left[best], left[0]
        for i in range(1, len(left)):
            factor = left[i][j] / left[0][j]
            left[i] = [x - factor * y for x, y in zip(left[i], left[0])]
        lines[len(found):] = left
        found.append(j)
    return found


def kernel(a, places):
    """The null space, one column for each place that is no pivot."""
    count = shape(a)[1]
    free = [j for j in range(count) if j not in places]
    chosen = pivots(transpose(submatrix(a, range(shape(a)[0]), places))) if places else []
    if len(chosen) != len(places):
        raise NoValue("a pivot is 0")
    columns = []
    for place in free:
        column = [mpf(0)] * count
        column[place] = mpf(1)
        if places:
            right = [[negate(rows(a)[i][place])] for i in chosen]
            found = rows(solve(submatrix(a, chosen, places), matrix(right)))
            for position, entry in zip(places, found):
                column[position] = entry[0]
        columns.append(column)
    if not columns:
        raise Mistake("the kernel is 0")
    return transpose(matrix(columns))


def submatrix(a, lines, columns):
    """The entries at some rows and columns, counted from 0."""
    found = rows(a)
    if max(lines, default=0) >= len(found) or max(columns, default=0) >= len(found[0]):
        raise Mistake("no such place")
    return matrix([[found[i][j] for j in columns] for i in lines])
