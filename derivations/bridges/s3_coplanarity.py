# %% [markdown]
# # 3 Coplanarity
#
# Okamoto eliminates the object point from the four collinearity equations of two images: a determinant of four rows is
# zero.  Is this the equation of correlation $\mathbf u'^T \mathbf C \mathbf u'' = 0$ of 1996?  It is, and the factor
# can be given exactly.

# %%
import sympy

from algebroproj_derivations.bridges.s2_collinearity import okamoto
from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.s1_4_orthonormalized_systems import frame
from algebroproj_derivations.fundamentals1996.s2_1_spatial_intersection import (
    C,
    P_left,
    P_right,
    center_left,
    center_right,
    d,
    u_left,
    u_right,
)
from algebroproj_derivations.inserting import given, inserted
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, adjugate, columns, determinant, dot, linear_system, over, rows, vector

section = Section("bridges", "3", "Coplanarity")

# %% [markdown]
# ## Which determinant?
#
# **Definition.**  The equations $u_i\, \mathbf m_0^T \mathbf X = \mathbf m_i^T \mathbf X$ for $i = 1, 2$, of both
# images.  Okamoto's order of the unknowns is $X, Y, Z, 1$.

# %%
X, Y, Z = point = vector(*sympy.symbols("X Y Z"))


def four_equations(left: Matrix, right: Matrix) -> list[sympy.Expr]:
    """Return the four collinearity equations of a point, with the matrices (3 by 4) of two cameras."""
    images = ((u_left, left * vector(1, *point)), (u_right, right * vector(1, *point)))
    return [u[i] * image[0] - image[i] for u, image in images for i in (1, 2)]


def coplanarity_determinant(left: Matrix, right: Matrix) -> sympy.Expr:
    """Return Okamoto's determinant: the coefficients of X, Y, Z and the constant terms."""
    coefficients, right_side = linear_system(four_equations(left, right), tuple(point))
    return determinant(columns(coefficients, -right_side))


first, second = sympy.symbols("ap1:12"), sympy.symbols("app1:12")
xc1, yc1, xc2, yc2 = *u_left[1:, 0], *u_right[1:, 0]


def printed_row(coordinate: sympy.Symbol, a: tuple[sympy.Symbol, ...], k: int) -> list[sympy.Expr]:
    return [*(coordinate * a[8 + j] - a[k + j] for j in range(3)), coordinate - a[k + 3]]


section.identity(
    "3/determinant",
    "the determinant of the coplanarity, as Okamoto has it",
    printed=determinant(
        Matrix(
            [
                printed_row(xc1, first, 0),
                printed_row(yc1, first, 4),
                printed_row(xc2, second, 0),
                printed_row(yc2, second, 4),
            ]
        )
    ),
    derived=coplanarity_determinant(okamoto(first), okamoto(second)),
)

# %% [markdown]
# **An example.**  Four equations are four planes: two through the left center, which meet in the left ray, and two
# through the right one.  The determinant is zero if the two rays meet.  Here two cameras see the point $P$.  The
# second number is the determinant of the left ray and of the right ray to $Q$.

# %%
AHEAD = Matrix([[0, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0]])
BESIDE = Matrix([[0, 0, 0, 1], [-1, 1, 0, 0], [0, 0, 1, 0]])
P, Q, unit_of_base = vector(2, 1, 4), vector(2, 2, 4), vector(1, 0, 0)


def determinant_for(left_point: Matrix, right_point: Matrix) -> sympy.Expr:
    images = (camera * vector(1, *place) for camera, place in ((AHEAD, left_point), (BESIDE, right_point)))
    seen = [over(image[i], image[0]) for image in images for i in (1, 2)]
    return inserted(coplanarity_determinant(AHEAD, BESIDE), (xc1, yc1, xc2, yc2), seen).doit()


determinant_for(P, P), determinant_for(P, Q)

# %%
SpaceDrawing(
    "The plane of both centers and the point P.  The right ray to Q leaves this plane, and the left ray does not meet "
    "it.",
    {"C'": vector(0, 0, 0), "C''": unit_of_base, "P": P, "Q": Q},
    segments=[("C''", "Q")],
    triangles=[("C'", "C''", "P")],
    axes=("X", "Y", "Z"),
)

# %% [markdown]
# ## Which bilinear form?
#
# **Derivation.**  It is bilinear in $\mathbf u'$ and $\mathbf u''$; its coefficients are the determinants of two rows
# of each camera.  The sign comes from the order $X, Y, Z, 1$ against $1, X, Y, Z$.


# %%
def without_row(matrix: Matrix, row: int) -> Matrix:
    return rows(*(matrix.row(i).T for i in range(matrix.rows) if i != row))


def minors(left: Matrix, right: Matrix) -> Matrix:
    """Return the matrix of four-rowed minors: element (i, j) lacks row i of the left and row j of the right camera."""

    def minor(i: int, j: int) -> sympy.Expr:
        return (-1) ** (i + j) * determinant(without_row(left, i).col_join(without_row(right, j)))

    return Matrix(3, 3, minor)


M_left, M_right = (Matrix(3, 4, sympy.symbols(f"{name}:3:4")) for name in ("mp", "mpp"))
section.identity(
    "3/minors",
    "the determinant is bilinear in the images, with minors of the cameras for coefficients",
    printed=-dot(u_left, minors(M_left, M_right) * u_right),
    derived=coplanarity_determinant(M_left, M_right),
)

# %% [markdown]
# ## With which factor?
#
# **Definition.**  A camera of 1996 is $[-\mathbf P^* \mathbf y_0\;\; \mathbf P^*]$ but for a factor, and $\mathbf P$ is
# the inverse of $\mathbf P^*$.  To keep polynomials, the adjugate stands for $\mathbf P$:  $\mathbf P =
# \operatorname{adj} \mathbf P^* / \det \mathbf P^*$, and $\mathbf C$ is linear in both matrices.

# %%
Ps_left, Ps_right = (Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in ("psp", "pspp"))
at_cameras = given((*P_left, *P_right, *d), (*adjugate(Ps_left), *adjugate(Ps_right), *(center_right - center_left)))


def camera(projection: Matrix, center: Matrix) -> Matrix:
    return columns(-projection * center, projection)


# %% [markdown]
# **Result.**  The minors are $\det \mathbf P'^* \det \mathbf P''^* \mathbf C$.  Let $k'$ and $k''$ scale the cameras so
# that the constant of the denominator is 1, as Okamoto has it.  Then the factor is $-k'^2 k''^2 \det \mathbf P'^* \det
# \mathbf P''^*$, and not zero, for both matrices are regular.

# %%
section.identity(
    "3/factor",
    "the minors of two cameras are the matrix of correlation",
    printed=C.xreplace(at_cameras),
    derived=minors(camera(Ps_left, center_left), camera(Ps_right, center_right)),
)
k_left, k_right = sympy.symbols("kp kpp")
section.identity(
    "3/okamoto-factor",
    "the determinant of Okamoto and the equation of correlation",
    printed=-(k_left**2) * k_right**2 * dot(u_left, C.xreplace(at_cameras) * u_right),
    derived=coplanarity_determinant(k_left * camera(Ps_left, center_left), k_right * camera(Ps_right, center_right)),
)

# %% [markdown]
# **And in other frames?**  Affine frames of the images and of the object change the determinant by their own
# determinants.  Shown are the left image and one element; each has two rows of either camera.

# %%
frame_left = frame(Matrix(3, 2, sympy.symbols("gp:3:2")))
frame_space = frame(Matrix(4, 3, sympy.symbols("G:4:3")))
section.identity(
    "3/image-frame",
    "the minors with another frame of the left image",
    printed=determinant(frame_left) * minors(M_left, M_right),
    derived=frame_left.T * minors(frame_left * M_left, M_right),
)
section.identity(
    "3/object-frame",
    "the minors with another frame of the object",
    printed=determinant(frame_space) * minors(M_left, M_right)[0, 0],
    derived=minors(M_left * frame_space, M_right * frame_space)[0, 0],
)
