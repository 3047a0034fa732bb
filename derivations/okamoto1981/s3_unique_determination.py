# %% [markdown]
# # 3 Are the 22 parameters unique?
#
# The 22 equations are independent: near a solution there is no other.  The paper says more, that the parameters are
# determined uniquely.  Are they?  Seven pairs of image points leave a pencil of bilinear forms $\mathbf F + t\, \mathbf
# G$.  A condition of coplanarity is one whose determinant is zero: a cubic in $t$, with up to three real roots.  Each
# of them gives a stereo model, and five points take each model to the object.  This section builds an example with
# three roots, from integers.

# %%
import sympy

from algebroproj_derivations.cameras import minors_of_cameras
from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.inserting import inserted
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s2_1_algebraic_consideration import (
    A_left,
    A_right,
    control_points,
    coplanarity,
    drawn,
    x_left,
    x_right,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    Scalar,
    adjugate,
    columns,
    cross,
    determinant,
    diff,
    dot,
    inverse,
    over,
    solve,
    vector,
)

section = Section("okamoto1981", "3", "Unique determination, general case")

# %% [markdown]
# ## How many roots has the cubic?
#
# **Definition.**  In homogeneous parameters $s, t$ the determinant of $s\, \mathbf A + t\, \mathbf B$ is a cubic form,
# and no root is at infinity.

# %%
pencil_a, pencil_b = (Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in ("a", "b"))
s, t = sympy.symbols("s t")


def cubic_of(first: Matrix, second: Matrix) -> Matrix:
    """Return the coefficients of s^3, s^2 t, s t^2, t^3 in the determinant of a pencil."""
    mixed = [(adjugate(one) * other).trace() for one, other in ((first, second), (second, first))]
    return vector(determinant(first), *mixed, determinant(second))


section.identity(
    "3/beyond/cubic",
    "the determinant of a pencil by determinants and adjugates",
    printed=dot(cubic_of(pencil_a, pencil_b), vector(s**3, s**2 * t, s * t**2, t**3)),
    derived=determinant(s * pencil_a + t * pencil_b),
)

# %% [markdown]
# **The sign of the discriminant** tells the number of real roots.  Of three linear forms it is the square of the
# product of their three determinants: positive for three different roots, zero where two of them are equal.  Of a
# linear and a quadratic form it is the discriminant of the quadratic one, times a square: negative if that has no real
# root.

# %%
cubic = vector(*sympy.symbols("c:4"))


def discriminant_of(c: Matrix) -> Scalar:
    """Return the discriminant of a cubic form."""
    return (
        c[1] ** 2 * c[2] ** 2
        - 4 * c[0] * c[2] ** 3
        - 4 * c[1] ** 3 * c[3]
        - 27 * c[0] ** 2 * c[3] ** 2
        + 18 * c[0] * c[1] * c[2] * c[3]
    )


def coefficients_of_form(form: Scalar) -> Matrix:
    """Return the coefficients of s^3, s^2 t, s t^2, t^3."""
    polynomial = sympy.Poly(form, s, t)
    return vector(*(polynomial.coeff_monomial(s ** (3 - k) * t**k) for k in range(4)))


p, q, r = (vector(*sympy.symbols(f"{name}:2")) for name in "pqr")
quadratic = vector(*sympy.symbols("k:3"))


def form_of(linear: Matrix) -> Scalar:
    return dot(linear, vector(s, t))


def bracket(first: Matrix, second: Matrix) -> Scalar:
    return first[0] * second[1] - first[1] * second[0]


section.identity(
    "3/beyond/discriminant",
    "the discriminant of a cubic form with three roots",
    printed=(bracket(p, q) * bracket(q, r) * bracket(r, p)) ** 2,
    derived=discriminant_of(coefficients_of_form(form_of(p) * form_of(q) * form_of(r))),
)
section.identity(
    "3/beyond/discriminant#one-root",
    "the discriminant of a linear and a quadratic form",
    printed=(quadratic[1] ** 2 - 4 * quadratic[0] * quadratic[2])
    * dot(quadratic, vector(p[1] ** 2, -p[0] * p[1], p[0] ** 2)) ** 2,
    derived=discriminant_of(
        coefficients_of_form(form_of(p) * dot(quadratic, vector(s**2, s * t, t**2))),
    ),
)

# %% [markdown]
# **A double root is rational.**  If two roots are equal, the second derivatives have the same double root: the
# Hessian of a cubic form with the roots $p, p, q$ is a multiple of the square of $p$.

# %%


def hessian_of(c: Matrix) -> Matrix:
    """Return the coefficients of s^2, s t, t^2 in the Hessian of a cubic form, but for the factor -4."""
    return vector(c[1] ** 2 - 3 * c[0] * c[2], c[1] * c[2] - 9 * c[0] * c[3], c[2] ** 2 - 3 * c[1] * c[3])


any_form = dot(cubic, vector(s**3, s**2 * t, s * t**2, t**3))
section.identity(
    "3/beyond/hessian",
    "the Hessian of a cubic form",
    printed=-4 * dot(hessian_of(cubic), vector(s**2, s * t, t**2)),
    derived=determinant(Matrix([[diff(diff(any_form, u), v) for v in (s, t)] for u in (s, t)])),
)
section.identity(
    "3/beyond/hessian#double-root",
    "the Hessian of a cubic form with a double root",
    printed=bracket(p, q) ** 2 * form_of(p) ** 2,
    derived=dot(hessian_of(coefficients_of_form(form_of(p) ** 2 * form_of(q))), vector(s**2, s * t, t**2)),
)

# %% [markdown]
# ## Seven pairs that satisfy two conditions
#
# **Definition.**  Take two conditions of coplanarity $\mathbf F$ and $\mathbf G$, and seven left image points.  Either
# condition gives a line in the right image.  Where the two lines meet is the right image point.

# %%
F, G = Matrix([[-2, 0, 1], [1, -2, -2], [0, -4, -3]]), Matrix([[2, 2, 0], [-2, 0, 2], [1, 2, 1]])
left_points = [vector(*p, 1) for p in ((-3, -3), (3, 3), (1, 2), (-3, 0), (4, -1), (-1, 2), (1, -3))]
right_points = [cross(F.T * u, G.T * u) for u in left_points]
pairs = list(zip(left_points, right_points, strict=True))

# %% [markdown]
# All bilinear forms that vanish for the seven pairs are combinations of the two.

# %%
section.rank(
    "3/beyond/pencil",
    "seven pairs leave a pencil of bilinear forms",
    printed=7,
    derived=Matrix([[u[i] * v[j] for i in range(3) for j in range(3)] for u, v in pairs]),
    kernel=[vector(*F), vector(*G)],
)

# %% [markdown]
# **Which of them are conditions of coplanarity?**  $\det(\mathbf F + t\, \mathbf G)$ is zero for $t = 0$ and $t = 1$.
# The third root of the cubic is at infinity, and is $\mathbf G$ itself.

# %%
THIRD = sympy.Rational(1)
section.vanishing(
    "3/beyond/pencil#cubic",
    "two of the conditions of coplanarity in the pencil, beside the second of the given ones",
    printed=(t, t - THIRD),
    derived=determinant(F + t * G),
)
forms = (F, G, F + THIRD * G)

# %% [markdown]
# One left photograph, three conditions: each makes a pencil of lines of the right image points, through the image of
# another right center.  Under the third the sixth right point is the image of the left center, and has no line.

# %%
ImageDrawing(
    "The seven left image points, with the lines that the three conditions make of the right image points.",
    {
        title: (
            {f"{k}": vector(*u[:2, :]) for k, u in enumerate(left_points, 1)},
            [drawn(form * v) for v in right_points if any(form * v)],
        )
        for title, form in zip(("first", "second, G", "third, F + G"), (F, G, F + THIRD * G), strict=True)
    },
    axes=("x_c", "y_c"),
)

# %% [markdown]
# ## A model for each condition
#
# **Definition.**  Let the left photograph have the matrix $[\mathbf 1\; \mathbf 0]$, and the right one
# $[\,\mathbf a \times \mathbf F^T\; \mathbf a\,]$ with $\mathbf F \mathbf a = \mathbf 0$: then $\mathbf u_1^T \mathbf F
# \mathbf u_2 = 0$ for the images of every point.  A model point is $(\mathbf u_1, w)$.


# %%
def terms_of_depth(right: Matrix, u: Matrix, v: Matrix) -> tuple[Matrix, Matrix]:
    """Return two vectors of a model point: the first, and its depth times the second, have the sum zero."""
    return cross(v, right[:, :3] * u), cross(v, right[:, 3])


def depth_of(towards: Matrix, along: Matrix) -> Scalar:
    return over(-dot(towards, along), dot(along, along))


def model_of(form: Matrix, epipole: Matrix, pairs: list[tuple[Matrix, Matrix]]) -> tuple[Matrix, list[Matrix]]:
    """Return the matrix of the right photograph, and the model points of pairs."""
    right = columns(*(cross(epipole, form.T.col(j)) for j in range(3)), epipole)
    return right, [vector(*u, depth_of(*terms_of_depth(right, u, v))) for u, v in pairs]


canonical = columns(E3, vector(0, 0, 0))
epipole = vector(*sympy.symbols("e:3"))
any_rows = Matrix(3, 3, sympy.symbols("g:3:3"))
form_with_epipole = columns(*(cross(any_rows.row(k).T, epipole) for k in range(3))).T
section.up_to_scale(
    "3/beyond/model",
    "the condition of the photographs of a model",
    printed=form_with_epipole,
    derived=minors_of_cameras(canonical, model_of(form_with_epipole, epipole, [])[0]),
)

# %% [markdown]
# ## Photographs for each model
#
# The first five pairs are those of the control points.  The collineation that takes the five model points to them is
# a product of two matrices, each of which takes the five unit points to five points.


# %%
def from_unit_points(points: list[Matrix]) -> Matrix:
    """Return the matrix that takes the four unit points and (1, 1, 1, 1) to five homogeneous points."""
    four = columns(*points[:4])
    return four * Matrix.diag(*solve(four, points[4]))


any_points = [vector(*sympy.symbols(f"{name}:4")) for name in "ghkmn"]
section.identity(
    "3/beyond/collineation",
    "the matrix takes (1, 1, 1, 1) to the fifth point",
    printed=any_points[4],
    derived=from_unit_points(any_points) * vector(1, 1, 1, 1),
)


def photographs_of(form: Matrix) -> tuple[Matrix, Matrix]:
    right, model_points = model_of(form, cross(form.row(0).T, form.row(1).T), pairs[:5])
    to_object = from_unit_points([vector(*p, 1) for p in control_points])
    to_model = from_unit_points(model_points) * inverse(to_object)
    left, right = (coefficients_of(matrix * to_model).doit() for matrix in (canonical, right))
    return left, right


solutions = [photographs_of(form) for form in forms]


def measured(u: Matrix) -> Matrix:
    return vector(over(u[0], u[2]), over(u[1], u[2]))


def left_over(left: Matrix, right: Matrix) -> Matrix:
    """Return what the equations of seven pairs and five control points leave."""
    condition = inserted(coplanarity, (*A_left, *A_right), (*left, *right))
    conditions = [inserted(condition, (*x_left, *x_right), (*measured(u), *measured(v))) for u, v in pairs]
    of_control = [
        image(matrix_of(a), p) - measured(w)
        for p, pair in zip(control_points, pairs[:5], strict=True)
        for a, w in zip((left, right), pair, strict=True)
    ]
    return Matrix.vstack(vector(*conditions), *of_control)


# %% [markdown]
# **The result.**  Three pairs of photographs leave nothing of the equations: seven conditions (42), and twenty image
# coordinates of five object points, which say the same as (43).

# %%
section.identity(
    "3/beyond/three-solutions",
    "three pairs of photographs satisfy seven conditions of coplanarity and have the same images of five object points",
    printed=Matrix.zeros(27, 3),
    derived=columns(*(left_over(*solution) for solution in solutions)),
)

# %% [markdown]
# **Print.**  If the parameters were unique, the first two of these solutions would be equal.

# %%
section.identity(
    "3/unique",
    "seven pairs and five object points determine the parameters uniquely",
    printed=vector(*solutions[1][0], *solutions[1][1]),
    derived=vector(*solutions[0][0], *solutions[0][1]),
    expect="false",
    instead="3/beyond/three-solutions",
    note="Printed and derived are the 22 coefficients of two solutions for the same measurements, which would have to "
    "be equal.  The equations are independent, 3/twenty-two: near a solution there is no other.  An eighth pair "
    "decides between the three.",
    grade="results",
    follows="Up to three pairs of photographs satisfy all conditions. The example has three, with rational numbers, "
    "for the same measurements. An eighth pair of points decides. See docs/findings/uniqueness.md.",
)

# %% [markdown]
# **Meaning.**  Who adjusts seven pairs and five points may find any of three solutions: it depends on the
# approximations.  An eighth pair decides.
