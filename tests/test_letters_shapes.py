"""What the parts of a statement in letters may be: prover and replay accept what NumPy can compute, and no more."""

import numpy as np
import pytest
from cases import for_each

from algebroproj_sym.expressions.letters.parsing import parse_letters
from algebroproj_sym.expressions.letters.terms import LetterError
from algebroproj_sym.replaying import Rejected
from algebroproj_sym.replaying.letters.reading import read


def column(matrix, size=None):
    assert matrix.shape[1] == 1
    assert size in (None, len(matrix))
    return matrix[:, 0]


def square(matrix):
    assert matrix.shape[0] == matrix.shape[1]
    return matrix


def product(left, right):
    return left * right if left.size == 1 or right.size == 1 else left @ right


def added(left, right):
    assert left.shape == right.shape
    return left + right


def stacked(*blocks):
    rows = [np.hstack(row) for row in blocks]
    assert all(len({block.shape[1] for block in column}) == 1 for column in zip(*blocks, strict=True))
    return np.vstack(rows)


COMPUTED = {
    "A + B": added,
    "A*B": product,
    "A.T*B": lambda a, b: product(a.T, b),
    "dot(A, B)": lambda a, b: added(column(a), column(b)) @ column(b),
    "outer(A, B)": lambda a, b: np.outer(column(a), column(b)),
    "cross(A, B)": lambda a, b: np.cross(column(a, 3), column(b, 3))[:, None],
    "kron(A, B)": np.kron,
    "block([A, B], [B, A])": lambda a, b: stacked([a, b], [b, a]),
    "block([A, A], [B, B])": lambda a, b: stacked([a, a], [b, b]),
    "block([A, B])": lambda a, b: stacked([a, b]),
    "block([A], [B])": lambda a, b: stacked([a], [b]),
    "trace(A)": lambda a, b: np.trace(square(a)),
    "det(A)": lambda a, b: np.linalg.det(square(a)),
    "adj(A)": lambda a, b: square(a),
    "A^2": lambda a, b: square(a) @ a,
    "norm(A)": lambda a, b: np.linalg.norm(column(a)),
    "diag(A)": lambda a, b: np.diag(column(a)),
    "vec(A)": lambda a, b: a.reshape(-1, 1, order="F"),
    "skew(A)": lambda a, b: np.outer(column(a, 3), column(a, 3)),
    "vee(A)": lambda a, b: column(a.reshape(3, 3)[:, :1], 3)[:, None] if a.shape == (3, 3) else column(a, -1),
    "qmul(A, B)": lambda a, b: added(column(a, 4), column(b, 4))[:, None],
    "rotation(A)": lambda a, b: np.outer(column(a, 4)[:3], a[:3]),
    "pure(A)": lambda a, b: np.append(column(a, 3), 0)[:, None],
    "imag(A)": lambda a, b: column(a, 4)[:3, None],
}
SHAPES = [(rows, columns) for rows in range(1, 5) for columns in range(1, 5)]


def shape_of(computed, *arrays):
    """The shape of what is computed, a matrix or a number; None if it cannot be."""
    try:
        found = np.shape(computed(*arrays))
    except (AssertionError, ValueError):
        return None
    return found or (1, 1)


@for_each("text", COMPUTED)
def test_parts_fit_together_exactly_where_numpy_can_compute_with_them(text):
    fits = 0
    for first in SHAPES:
        for second in SHAPES if "B" in text else [(1, 1)]:
            letters = {"A": first, "B": second}
            arrays = [np.arange(1.0, rows * columns + 1).reshape(rows, columns) for rows, columns in letters.values()]
            expected = shape_of(COMPUTED[text], *arrays)
            for reader, refused in ((read, Rejected), (parse_letters, LetterError)):
                if expected is None:
                    with pytest.raises(refused):
                        reader(text, letters)
                else:
                    assert reader(text, letters).shape == expected, letters
            fits += expected is not None
    assert fits
