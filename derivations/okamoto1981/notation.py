# %% [markdown]
# # Notation of the paper
#
# An object point $P(X, Y, Z)$ is projected from the center $(X_o, Y_o, Z_o)$ into the picture point $(x, y)$, the
# principal distance being $c$, and measured as $(x_c, y_c)$ in the system of the comparator, whose plane need not be
# parallel to the picture.  The sections of the paper have no numbers; here they are 1.1 and 1.2 (mathematical
# preparations), 2.1 and 2.2 (general orientation problem), 3 (simultaneous determination), 4.1 to 4.3 (usual case in
# close-range photogrammetry) and 5 (concluding remarks).

# %%
from collections.abc import Sequence
from fractions import Fraction

import sympy
from sympy.polys.matrices import DomainMatrix

from algebroproj_sym.expressions import Matrix, Scalar, columns, jacobian, over, vector

X, Y, Z = sympy.symbols("X Y Z")
Xo, Yo, Zo = sympy.symbols("Xo Yo Zo")
x, y, c = sympy.symbols("x y c")
xc, yc, xco, yco = sympy.symbols("xc yc xco yco")

point = vector(X, Y, Z)
center = vector(Xo, Yo, Zo)
comparator_center = vector(xco, yco)

E3 = Matrix.eye(3)

# %% [markdown]
# ## Rotations
#
# A rotation by an angle turns one coordinate axis towards another.  The matrices $\mathbf D_\phi$,
# $\mathbf D_\omega$, $\mathbf D_\kappa$ of the paper, written out in its equation (38), turn $Z$ towards $X$, $Y$
# towards $Z$ and $X$ towards $Y$: rotations about $Y$, $X$ and $Z$.


# %%
def plane_rotation(size: int, first: int, second: int, cosine: Scalar, sine: Scalar) -> Matrix:
    """Return the rotation that turns the axis `first` towards the axis `second`."""
    entries = {(first, first): cosine, (second, second): cosine, (first, second): -sine, (second, first): sine}
    return Matrix(size, size, lambda i, j: entries.get((i, j), sympy.Integer(i == j)))


ABOUT_Y, ABOUT_X, ABOUT_Z = (2, 0), (1, 2), (0, 1)


def rotation(*turns: tuple[tuple[int, int], Scalar, Scalar], size: int = 3) -> Matrix:
    """Return the product of plane rotations, each given by its plane, cosine and sine."""
    result = Matrix.eye(size)
    for (first, second), cosine, sine in turns:
        result *= plane_rotation(size, first, second, cosine, sine)
    return result


# %% [markdown]
# To count parameters, an angle is replaced by $t = \tan(\text{angle} / 2)$: the angle and $t$ are functions of each
# other, so that the number of independent functions is the same, and everything is rational.  An infinitesimal change
# of the angle changes $t$ by $(1 + t^2) / 2$.


# %%
def of_half_angle(t: Scalar) -> tuple[Scalar, Scalar]:
    """Return cosine and sine of an angle from the tangent of its half."""
    return over(1 - t**2, 1 + t**2), over(2 * t, 1 + t**2)


def angle_rate(t: Scalar) -> Scalar:
    """Return by how much t changes with the angle."""
    return (1 + t**2) / 2


# %% [markdown]
# ## Cameras
#
# The matrix of a projection is made of its orientation and of the affine map of the picture that the comparator sees:
# $x_c$ and $y_c$ are $-c$ times two rows of an orthogonal matrix, applied to the ray, plus $x_{co}$ and $y_{co}$.


# %%
def image(matrix: Matrix, object_point: Matrix) -> Matrix:
    """Return the inhomogeneous image of a point under a projection or a collineation."""
    *numerators, denominator = matrix * vector(*object_point, 1)
    return vector(*(over(numerator, denominator) for numerator in numerators))


def matrix_of(coefficients: Matrix) -> Matrix:
    """Return the matrix whose entries row by row are the coefficients and a final 1."""
    width = 4
    entries = [*coefficients, 1]
    return Matrix(len(entries) // width, width, entries)


def seen_by_comparator(d: Matrix, distance: Scalar, origin: Matrix) -> Matrix:
    """Return the affine map of a picture: rays in the system of the picture to homogeneous measured coordinates."""
    size = d.cols
    last = Matrix(1, size, lambda _, j: sympy.Integer(j == size - 1))
    return (-distance * d + origin * last).col_join(last)


def camera(inner: Matrix, orientation: Matrix, projection_center: Matrix) -> Matrix:
    """Return the matrix of projection."""
    return inner * orientation * columns(E3, -projection_center)


def coefficients_of(matrix: Matrix) -> Matrix:
    """Return the entries of a matrix row by row, divided by the last one, which is left out."""
    *entries, last = matrix
    reciprocal = over(1, last)
    return vector(*(entry * reciprocal for entry in entries))


# %% [markdown]
# Equations are counted where they hold.  Image coordinates are functions of the parameters and of unknown points; what
# they say without the points are as many combinations as there are functions more than coordinates of points, those
# that no movement of the points changes.  Their rates by the parameters, at one point with rational numbers, have a
# rank that is also the rank in general: near such a solution there is no other if it is the number of the parameters.


# %%
def rates_of_equations(
    functions: Matrix, parameters: Sequence[sympy.Symbol], unknown_points: Sequence[Matrix] = ()
) -> Matrix:
    """Return the rates by the parameters of the equations that are left when the unknown points are eliminated."""
    coordinates = [coordinate for unknown in unknown_points for coordinate in unknown]
    variables = (*parameters, *coordinates)
    at = {symbol: Fraction((5 * k * k + 3 * k + 2) % 17 + 1, 7 * k % 11 + 19) for k, symbol in enumerate(variables)}
    by_all = Matrix(jacobian(functions, at, variables))
    by_parameters, by_coordinates = by_all[:, : len(parameters)], by_all[:, len(parameters) :]
    return left_kernel(by_coordinates) * by_parameters if coordinates else by_parameters


def left_kernel(matrix: Matrix) -> Matrix:
    """Return independent rows, with whole numbers, that take a matrix of rational numbers to zero."""
    rows = DomainMatrix.from_Matrix(matrix.T).to_field().nullspace().to_Matrix()
    return Matrix.vstack(*(row * sympy.ilcm(*(entry.q for entry in row)) for row in map(rows.row, range(rows.rows))))


# %% [markdown]
# What the arguments of generated functions are.

# %%
ABOUT_A = (
    "Coefficients (A1, ..., A11) of the general collinearity equations; their units follow from those of the "
    "coordinates of object and image."
)
ABOUT_POINT = "Object point (X, Y, Z); any unit of length."
ABOUT_IMAGE = "Measured image point (xc, yc) in the system of the comparator; any unit of length."
