# %% [markdown]
# # 4 Numerical example: the tables, as printed
#
# Nothing is computed here, and nothing typed again but the left epipole: the digits are those of the quotes.

# %%
from pathlib import Path

from algebroproj_sym.declaring import quotations

quotes = quotations(Path(__file__).parent)


def matrix(claim: str, columns: int = 3, first: int = 0) -> tuple[tuple[str, ...], ...]:
    """A square matrix of the numbers in the quote of a claim, from the place of its first one."""
    numbers = quotes.numbers(claim)[first : first + columns**2]
    return tuple(numbers[i : i + columns] for i in range(0, columns**2, columns))


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
# c) and d): the matrix of correlation, epipoles (the first has a comma for the point), parameters and centers.

# %%
PRINTED_Z = matrix("4/c#z00")
PRINTED_EPIPOLES = {"left": ("1.64746", "-12.56421"), "right": quotes.decimals("4/c#right.u01")}
PRINTED_MU = {
    "left": tuple(quotes.decimals(f"4/d#left.mu{n}")[0] for n in (1, 2, 3)),
    "right": quotes.decimals("4/d#right.mu1")[1:],
}
PRINTED_CENTERS = {"left": quotes.decimals("4/d#left.y01"), "right": quotes.decimals("4/d#right.y01")}

# %% [markdown]
# e): the relative model $\bar{\mathbf y}$ and its transformation $\mathbf y$.

# %%
MODEL = quotes.rows("4/e", "ybar1", "ybar2", "ybar3")
TRANSFORMED = quotes.rows("4/e", "y1", "y2", "y3")
PRINTED_M = matrix("4/e#m00", 4)

# %% [markdown]
# f) and g): fourth points, parameters, direction of the base, matrices and coordinates.

# %%
NORMAL_FOURTH = {"left": quotes.decimals("4/f#left.uN31"), "right": quotes.decimals("4/f#right.uN31")}
NORMAL_MU = quotes.decimals("4/f#left.muN1")[1:]
W, FIRST_Z_N = quotes.decimals("4/f#w01")[:2], quotes.decimals("4/f#w01")[2]
FIRST_T = {"left": matrix("4/g#left.t00"), "right": matrix("4/g#right.t00")}
U_COLUMNS = ("left.u1", "left.u2", "right.u1", "right.u2")
FIRST_U = quotes.rows("4/g", *U_COLUMNS)
PRINTED_ZN_MATRIX = matrix("4/g#z00")

# %% [markdown]
# h): the model once more; the first points have eight decimals.

# %%
MODEL_AGAIN = MODEL | {name: quotes.decimals(f"4/h#{name}.ybar1")[:3] for name in ("1", "2", "4", "5")}

# %% [markdown]
# i): matrices, parameters and centers; the table with $u'_{N1}, u'_{N2}, u''_{N1}, u''_{N2}$, then $z_N$ (empty for
# the points 1, 4, 5), then $X'_1, X'_2, X''_1, X''_2, p$ in pixels.

# %%
PARAMETERS = quotes.decimals("4/i#left.muN1")
SECOND_Z_N = quotes.decimals("4/i#zN")[0]
SECOND_TAU = {"left": ("1", *quotes.decimals("4/i#left.tau1")), "right": quotes.decimals("4/i#right.tau1")}
SECOND_T = {"left": matrix("4/i#left.t00"), "right": matrix("4/i#right.t00")}
SECOND_MU = {"left": PARAMETERS[:3], "right": PARAMETERS[6:9]}
SECOND_CENTERS = {"left": PARAMETERS[3:6], "right": PARAMETERS[9:]}
SECOND_U = quotes.rows("4/i", *U_COLUMNS)
PAIR_Z_N = {name: number for name, (number,) in quotes.rows("4/i", "zN").items()}
PIXELS = quotes.rows("4/i", "left.X1", "left.X2", "right.X1", "right.X2", "p")
PRINTED_A = {"left": matrix("4/i#left.a00"), "right": matrix("4/i#left.a00", first=9)}
