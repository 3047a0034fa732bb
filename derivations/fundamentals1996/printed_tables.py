# %% [markdown]
# # 4 Numerical example: the tables, as printed
#
# Nothing is computed here, and nothing typed again: the digits are those of the quotes.

# %%
from pathlib import Path

from algebroproj_sym.declaring import quotations

quotes = quotations(Path(__file__).parent)


def matrix(claim: str) -> tuple[tuple[str, ...], ...]:
    """A matrix of the numbers in the quote of a claim."""
    numbers = quotes.numbers(claim)
    return tuple(numbers[i : i + 3] for i in range(0, 9, 3))


# %% [markdown]
# a): the object points and both centers, O1 and O2, in cartesian and in affine coordinates.

# %%
CARTESIAN = quotes.rows("4/a", "X1", "X2", "X3")
AFFINE = quotes.rows("4/a", "y1", "y2", "y3")

# %% [markdown]
# b): the pictures, $x, y$ in decimeters, $u_1, u_2$; in the row of a center of projection the epipole, its image in the
# other picture.  Then the matrices of rotation.

# %%
LEFT = quotes.rows("4/b", "left.x", "left.y", "left.u1", "left.u2")
RIGHT = quotes.rows("4/b", "right.x", "right.y", "right.u1", "right.u2")
R_LEFT = matrix("4/b#left.R11")
R_RIGHT = matrix("4/b#right.R11")

# %% [markdown]
# What items e), g) and i) have of points: the relative model, $u'_{N1}, u'_{N2}, u''_{N1}, u''_{N2}$ of both normal
# cases, $z_N$ (empty for the points 1, 4, 5), and $X'_1, X'_2, X''_1, X''_2, p$ in pixels.

# %%
MODEL = quotes.rows("4/e", "ybar1", "ybar2", "ybar3")
FIRST_U, SECOND_U = (quotes.rows(item, "left.u1", "left.u2", "right.u1", "right.u2") for item in ("4/g", "4/i"))
PAIR_Z_N = quotes.rows("4/i", "zN")
PIXELS = quotes.rows("4/i", "left.X1", "left.X2", "right.X1", "right.X2", "p")
