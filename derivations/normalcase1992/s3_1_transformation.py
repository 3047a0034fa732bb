# %% [markdown]
# # 3.1 Transformation
#
# The images of the normal case are correlated by one fixed matrix: a check of the transformation, and the lines along
# which homologous points are searched.

# %%
import sympy

from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, dot, over, vector

section = Section("normalcase1992", "3.1", "Transformation")

# %% [markdown]
# ## Correlation of the transformed images

# %%
C_normal = correlation(E3, E3, unit_base)
section.identity(
    "3.1/Z_N",
    "matrix of correlation of the normal case",
    printed=Matrix.hstack(*(Matrix([[0, 0, 0], [0, 0, -1], [0, 1, 0]]),) * 2),
    derived=Matrix.hstack(C_normal, C_normal.applyfunc(lambda element: over(element, C_normal[2, 1]))),
    note="C_N, and Z_N after division by its element 32, which is 1.",
)
xnp, ynp, xnpp, ynpp = sympy.symbols("xNp yNp xNpp yNpp")
normal_left, normal_right = image_vector(xnp, ynp), image_vector(xnpp, ynpp)
to_normal_left, to_normal_right = R_left * x_left, R_right * x_right
TRANSFORMED = dict(zip((xnp, ynp, xnpp, ynpp), (*image_of(to_normal_left), *image_of(to_normal_right)), strict=True))
section.identity(
    "3.1/correlated",
    "the transformed images are correlated by it",
    printed=to_normal_left[2] * to_normal_right[2] * dot(normal_left, C_normal * normal_right),
    where=TRANSFORMED,
    derived=c**2 * dot(x_left, correlation(R_left, R_right, unit_base) * x_right),
    note="The two conditions differ by the factors of (1.1.4), which are -p3'/c and -p3''/c.",
)
points = [sympy.symbols(f"xp_{n} xpp_{n} y_{n}") for n in range(1, 9)]
section.rank(
    "3.1/must-be",
    "eight transformed points allow no other result",
    printed=8,
    derived=Matrix(
        [
            [p * q for p in image_vector(abscissa_left, ordinate) for q in image_vector(abscissa_right, ordinate)]
            for abscissa_left, abscissa_right, ordinate in points
        ]
    ),
    kernel=[vector(*C_normal)],
    note="The coefficients of the nine elements of C for points with equal ordinates: one solution but for a factor.",
)

# %% [markdown]
# ## Inverse transformation

# %%
xn, yn = sympy.symbols("xN yN")
normal = image_vector(xn, yn)
projector = R_rotation * x_vector
FROM_IMAGE = dict(zip((xn, yn), image_of(projector), strict=True))
section.identity(
    "3.1/inverse",
    "inverse transformation with its factor",
    printed=over(-projector[2], c) * (R_rotation.T * normal),
    where=FROM_IMAGE,
    derived=x_vector,
    note="The factor tau is -p3/c.",
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
# ## Epipolar lines

# %%
h_left, h_right = C_normal * x_right, C_normal.T * x_left
section.identity(
    "3.1.2#h'",
    "epipolar line in the left image of the normal case",
    printed=Matrix.hstack(Matrix([[0, 0, 0], [0, 0, -1], [0, 1, 0]]) * x_right, vector(0, c, ypp)),
    derived=Matrix.hstack(h_left, h_left),
)
section.identity(
    "3.1.2",
    "equation of the epipolar line in the left image",
    printed=c * yp - c * ypp,
    derived=dot(h_left, x_left),
)
section.identity(
    "3.1.3#h''",
    "epipolar line in the right image of the normal case",
    printed=Matrix.hstack(Matrix([[0, 0, 0], [0, 0, 1], [0, -1, 0]]) * x_left, -vector(0, c, yp)),
    derived=Matrix.hstack(h_right, h_right),
    note="The scan confuses the primes of the left image vector; the matrix is the transpose of C_N, applied to x'.",
)
section.identity(
    "3.1.3",
    "equation of the epipolar line in the right image",
    printed=-c * ypp + c * yp,
    derived=dot(h_right, x_right),
)
section.vanishing(
    "3.1/ordinates",
    "homologous points have equal ordinates",
    printed=(yp - ypp,),
    derived=dot(x_left, C_normal * x_right),
    nonzero=[c],
)
section.identity(
    "3.1/parallel",
    "the epipolar lines are parallel to the first axis",
    printed=vector(0, 0),
    derived=vector(dot(h_left, e1), dot(h_right, e1)),
    note="They contain the point at infinity of that axis, whose image vector is (1, 0, 0).",
)
section.identity(
    "3.1/one-plane",
    "homologous epipolar lines are images of one plane",
    printed=h_left.xreplace({ypp: y}),
    derived=-h_right.xreplace({yp: y}),
    note="With the ordinate y of both: the same line in both image planes, which are one plane if the centers have "
    "the same third coordinate.",
)

# %% [markdown]
# ## Code

# %%
image_and_orientation = {"arguments": {"R": R_any, "x": vector(x, y), "c": c}}
EXAMPLE_R = (("0.96", "0", "-0.28"), ("0", "1", "0"), ("0.28", "0", "0.96"))
section.kernel(
    "metric.to_normal",
    "Normal case coordinates of an image point.",
    **image_and_orientation,
    describe={"R": ABOUT_R, "x": ABOUT_X, "c": ABOUT_C},
    derived=image_of(R_any * x_vector),
    claims=["1.1.4", "1.1.5#x", "1.1.5#y"],
    example={"R": EXAMPLE_R, "x": ("-10.62", "1.694"), "c": "51.18"},
    jacobian=True,
)
section.kernel(
    "metric.from_normal",
    "Image point of a point of the normal case.",
    **image_and_orientation,
    describe={"R": ABOUT_R, "x": "Image point (xN, yN) of the normal case, in the unit of c.", "c": ABOUT_C},
    derived=image_of(R_any.T * x_vector),
    claims=["3.1/inverse", "3.1.1"],
    example={"R": EXAMPLE_R, "x": ("-25.3", "1.75"), "c": "51.18"},
    jacobian=True,
)
