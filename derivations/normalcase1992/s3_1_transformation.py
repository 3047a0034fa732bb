# %% [markdown]
# # 3.1 Transformation
#
# The rotations are known, and both images can be transformed to the normal case.  What is gained?  One fixed matrix
# correlates them: a check of the transformation, and the lines along which homologous points are searched.

# %%
import sympy
from sympy import Eq, MatrixSymbol

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.inserting import given
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, dot, over, vector

section = Section("normalcase1992", "3.1", "Transformation")

# %% [markdown]
# ## How are the transformed images correlated?
#
# **Definition.**  $\mathbf C_N$ has no rotations.  Divided by its element 32, which is 1, it is $\mathbf Z_N$.

# %%
C_normal = correlation(E3, E3, unit_base)
section.identity(
    "3.1/Z_N",
    "matrix of correlation of the normal case",
    derived=Matrix.hstack(C_normal, C_normal.applyfunc(lambda element: over(element, C_normal[2, 1]))),
)

# %% [markdown]
# **Test.**  The condition for the original images and that for the transformed ones differ by the factors of (1.1.4),
# $-p'_3 / c$ and $-p''_3 / c$.

# %%
xnp, ynp, xnpp, ynpp = sympy.symbols("xNp yNp xNpp yNpp")
normal_left, normal_right = image_vector(xnp, ynp), image_vector(xnpp, ynpp)
to_normal_left, to_normal_right = R_left * x_left, R_right * x_right
TRANSFORMED = given((xnp, ynp, xnpp, ynpp), (*image_of(to_normal_left), *image_of(to_normal_right)))
section.identity(
    "3.1/correlated",
    "the transformed images are correlated by it",
    printed=to_normal_left[2] * to_normal_right[2] * dot(normal_left, C_normal * normal_right),
    where=TRANSFORMED,
    derived=c**2 * dot(x_left, correlation(R_left, R_right, unit_base) * x_right),
)

# %% [markdown]
# **Must it be so?**  Eight points with equal ordinates allow no other matrix, but for a factor.

# %%
points = [sympy.symbols(f"xp_{n} xpp_{n} y_{n}") for n in range(1, 9)]
section.rank(
    "3.1/must-be",
    "eight transformed points allow no other result",
    derived=Matrix(
        [
            [p * q for p in image_vector(abscissa_left, ordinate) for q in image_vector(abscissa_right, ordinate)]
            for abscissa_left, abscissa_right, ordinate in points
        ]
    ),
    kernel=[vector(*C_normal)],
)

# %% [markdown]
# ## How does one get back?
#
# **Definition.**  The inverse of a rotation is its transpose, and the factor is that of (1.1.4), $-p_3 / c$.

# %%
xn, yn = sympy.symbols("xN yN")
normal = image_vector(xn, yn)
projector = R_rotation * x_vector
FROM_IMAGE = given((xn, yn), image_of(projector))
R, x_bold, normal_bold, tau = (
    MatrixSymbol("R", 3, 3),
    *(MatrixSymbol(name, 3, 1) for name in ("x", "xN")),
    sympy.Symbol("tau"),
)
section.identity(
    "3.1/inverse",
    "inverse transformation with its factor",
    constraints=[Eq(normal_bold, R * x_bold / tau)],
    properties={R: "rotation"},
    derived=x_bold,
)
i, j, k = (R_rotation.col(n) for n in range(3))
section.identity(
    "3.1.1",
    "coordinates in the original image",
    printed=vector(-c * over(dot(i, normal), dot(k, normal)), -c * over(dot(j, normal), dot(k, normal))),
    where=FROM_IMAGE,
    derived=vector(x, y),
)

# %% [markdown]
# ## Along which lines are homologous points searched?
#
# **Definition and print.**

# %%
h_left, h_right = C_normal * x_right, C_normal.T * x_left
section.identity(
    "3.1.2#h'",
    "epipolar line in the left image of the normal case",
    derived=Matrix.hstack(h_left, h_left),
)
section.identity("3.1.2", "equation of the epipolar line in the left image", derived=dot(h_left, x_left))
section.identity(
    "3.1.3#h''",
    "epipolar line in the right image of the normal case",
    derived=Matrix.hstack(h_right, h_right),
    note="The scan confuses the primes of the left image vector; the matrix is the transpose of C_N, applied to x'.",
)
section.identity(
    "3.1.3",
    "equation of the epipolar line in the right image",
    derived=dot(h_right, x_right),
)

# %% [markdown]
# **Meaning.**  Homologous points have equal ordinates.  The lines are parallel to the first axis: they contain its
# point at infinity.  For one ordinate both are the same line, and the image planes are one plane if the centers have
# the same third coordinate.
#
# Here the original left image has a tip, and its lines meet; those of the normal case are parallel.

# %%
TIP = turn_phi(sympy.Rational(24, 25), sympy.Rational(7, 25))
SPACE = {"1": vector(-2, -2, -4), "2": vector(2, 0, -4), "3": vector(0, 2, -4)}


def seen(turn: Matrix, base: Matrix) -> dict[str, Matrix]:
    return {name: image_of(turn.T * (place - base)).xreplace({c: 2}).doit() for name, place in SPACE.items()}


right_vectors = [vector(*point, -2) for point in seen(E3, unit_base).values()]
lines_of = of_rectangular(2).T
ImageDrawing(
    "Three points of the left image, on the lines that the right image gives.",
    {
        "original": (
            seen(TIP, 0 * unit_base),
            [lines_of * correlation(TIP, E3, unit_base) * right for right in right_vectors],
        ),
        "normal case": (seen(E3, 0 * unit_base), [lines_of * C_normal * right for right in right_vectors]),
    },
    axes=("x", "y"),
)

# %%
section.vanishing(
    "3.1/ordinates",
    "homologous points have equal ordinates",
    derived=dot(x_left, C_normal * x_right),
    nonzero=[c],
)
section.identity(
    "3.1/parallel",
    "the epipolar lines are parallel to the first axis",
    printed=vector(0, 0),
    derived=vector(dot(h_left, e1), dot(h_right, e1)),
)
section.identity(
    "3.1/one-plane",
    "homologous epipolar lines are images of one plane",
    printed=h_left.xreplace({ypp: y}),
    derived=-h_right.xreplace({yp: y}),
)
