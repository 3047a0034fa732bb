# %% [markdown]
# # Notation of the paper
#
# An image point has the vector $\mathbf x = (x, y, -c)^T$ with the principal distance $c$; the matrix of orientation
# $\mathbf R = [\mathbf i, \mathbf j, \mathbf k]$ turns it into the projector $\mathbf p = \mathbf R \mathbf x$ of the
# model space.  In the names of symbols `p` is one prime (left image) and `pp` two (right image).

# %%
import sympy
from sympy import cos, sin

from algebroproj_sym.expressions import Matrix, columns, cross, over, rows, vector

c = sympy.Symbol("c")
x, y, xp, yp, xpp, ypp = sympy.symbols("x y xp yp xpp ypp")
E3 = Matrix.eye(3)
e1, e2, e3 = (E3.col(k) for k in range(3))


def image_vector(abscissa: sympy.Expr, ordinate: sympy.Expr) -> Matrix:
    return vector(abscissa, ordinate, -c)


def of_rectangular(distance: sympy.Expr) -> Matrix:
    """Return the matrix that takes (1, x, y) to the image vector; its transpose takes lines the other way."""
    return Matrix([[0, 1, 0], [0, 0, 1], [-distance, 0, 0]])


x_vector, x_left, x_right = image_vector(x, y), image_vector(xp, yp), image_vector(xpp, ypp)


def image_of(direction: Matrix) -> Matrix:
    """Return the image coordinates (x, y) of a direction given in the system of the image."""
    return vector(*(-c * over(direction[k], direction[2]) for k in range(2)))


# %% [markdown]
# ## Orientation
#
# Some statements hold for any regular matrix, others only for rotations.  The first are proved with nine symbols, whose
# columns are $\mathbf i, \mathbf j, \mathbf k$; the others with all rotations, parametrised rationally by quaternions.


# %%
def orientation(primes: str) -> Matrix:
    return Matrix(3, 3, lambda row, column: sympy.Symbol(f"{'ijk'[column]}{row + 1}{primes}"))


def rotation(*quaternion: sympy.Symbol) -> Matrix:
    """Return the rotation of a quaternion of any length."""
    q0, axis = quaternion[0], vector(*quaternion[1:])
    square = axis.dot(axis)
    turned = columns(*((q0**2 - square) * e + 2 * axis.dot(e) * axis + 2 * q0 * cross(axis, e) for e in (e1, e2, e3)))
    return turned.applyfunc(lambda entry: over(entry, q0**2 + square))


R_any = orientation("")
R_left, R_right = orientation("p"), orientation("pp")
R_rotation = rotation(*sympy.symbols("q0:4"))

# %% [markdown]
# ## Base
#
# $\mathbf B$ is the matrix with $\mathbf p^T \mathbf B = (\mathbf p \times \mathbf b)^T$: its rows are the products of
# the axes and the base.  The base of rotational relative orientation is the unit vector of the first axis.

# %%
b = vector(*sympy.symbols("b1:4"))
unit_base = vector(1, 0, 0)


def matrix_of_base(base: Matrix) -> Matrix:
    return rows(*(cross(axis, base) for axis in (e1, e2, e3)))


def correlation(left: Matrix, right: Matrix, base: Matrix) -> Matrix:
    """Return C, the matrix of the condition that the projectors of both images and the base are coplanar."""
    return left.T * matrix_of_base(base) * right


# %% [markdown]
# ## Angles
#
# Tip and swing of the left image, tilt, tip and swing of the right one; of each its cosine and sine.

# %%
phip, kappap, Omegapp, phipp, kappapp = ANGLES = sympy.symbols("phip kappap Omegapp phipp kappapp")
PHI_LEFT, KAPPA_LEFT, OMEGA, PHI_RIGHT, KAPPA_RIGHT = ((cos(angle), sin(angle)) for angle in ANGLES)


def turn_omega(cosine: sympy.Expr, sine: sympy.Expr) -> Matrix:
    return Matrix([[1, 0, 0], [0, cosine, -sine], [0, sine, cosine]])


def turn_phi(cosine: sympy.Expr, sine: sympy.Expr) -> Matrix:
    return Matrix([[cosine, 0, sine], [0, 1, 0], [-sine, 0, cosine]])


def turn_kappa(cosine: sympy.Expr, sine: sympy.Expr) -> Matrix:
    return Matrix([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])


# %% [markdown]
# The small rotations of the adjustment, and the skew-symmetric matrix of the print.

# %%
domega, dphi, dkappa = sympy.symbols("domega dphi dkappa")


def small_rotation(omega: sympy.Expr, phi: sympy.Expr, kappa: sympy.Expr) -> Matrix:
    return Matrix([[0, -kappa, phi], [kappa, 0, -omega], [-phi, omega, 0]])


# %% [markdown]
# What the arguments of generated functions are.

# %%
ABOUT_C = "Principal distance, in the unit of the image coordinates."
ABOUT_R = "Matrix of orientation R = [i, j, k], a rotation from the image to the model system; dimensionless."
ABOUT_R_LEFT = "Matrix of orientation R' of the left image, a rotation; dimensionless."
ABOUT_R_RIGHT = "Matrix of orientation R'' of the right image, a rotation; dimensionless."
ABOUT_X = "Image point (x, y), centered at the principal point, in the unit of c."
