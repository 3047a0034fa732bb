# %% [markdown]
# # 1.1 Condition of intersection and projective transformation
#
# A point of the model lies on a ray of each image.  Seen from the same center, the normal case is an image as well, one
# that is not rotated: two images of one bundle are related by a projective transformation.

# %%
import sympy

from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import dot, over, vector

section = Section("normalcase1992", "1.1", "Condition of intersection and projective transformation")

# %% [markdown]
# ## Quantities

# %%
lam, lam_p, lam_pp, lam_n, tau = sympy.symbols("lam lam_p lam_pp lam_n tau")
X = vector(*sympy.symbols("X1:4"))
X0 = vector(*sympy.symbols("X01 X02 X03"))
X0_left, X0_right = (vector(*sympy.symbols(f"X01{primes} X02{primes} X03{primes}")) for primes in ("p", "pp"))

section.definition("1.1/x", "vector of image coordinates", printed=x_vector)
section.definition("1.1/p", "projector in the model space", printed=R_any * x_vector)
section.identity(
    "1.1/E",
    "rotations are orthogonal",
    printed=E3,
    derived=R_rotation.T * R_rotation,
    note="For all rotations, given by quaternions of any length.",
)

# %% [markdown]
# ## Intersection and projection
#
# Each image puts the point on a ray, $\mathbf X = \mathbf X_0 + \lambda \mathbf R \mathbf x$.  Both together are the
# condition of intersection.

# %%
section.definition(
    "1.1.1",
    "condition of intersection: the point on a ray of each image",
    printed=columns(X0_left + lam_p * R_left * x_left, X0_right + lam_pp * R_right * x_right),
    note="The columns are the two members that are to be equal to X.",
)
section.identity(
    "1.1/b",
    "stereo base",
    printed=None,
    derived=lam_p * R_left * x_left - ((X0_left + lam_p * R_left * x_left) - X0_right),
    expect="illegible",
    corrected=X0_right - X0_left,
    note="The scan reads 'b = X0 - X0''; two primes are lost.  (1.2.1), lambda' p' = b + lambda'' p'', determines the "
    "order: derived is lambda' p' - lambda'' p'' with lambda'' p'' = X - X0'' and X from the left image.",
)

point = X0 + lam * R_rotation * x_vector
section.identity(
    "1.1.2",
    "projection of a point",
    printed=lam * x_vector,
    derived=R_rotation.T * (point - X0),
    note="Equivalent to (1.1.1) because rotations are orthogonal.",
)

# %% [markdown]
# ## The normal case
#
# The image of the same bundle with $\mathbf R = \mathbf E$ and the same principal distance: third component $-c$.

# %%
ray = X - X0
normal_coordinates = image_of(ray)
normal_factor = over(-ray[2], c)
xn, yn = sympy.symbols("xN yN")
x_normal = image_vector(xn, yn)
section.identity(
    "1.1.3",
    "projection of the normal case",
    printed=lam_n * x_normal,
    where={lam_n: normal_factor, xn: normal_coordinates[0], yn: normal_coordinates[1]},
    derived=E3 * (X - X0),
)

point = X0 + lam * R_any * x_vector
projector = R_any * x_vector
IN_NORMAL_CASE = dict(zip((xn, yn), image_of(E3 * (point - X0)), strict=True))
IN_NORMAL_CASE |= {lam_n: over((X0 - point)[2], c)}
IN_NORMAL_CASE |= {tau: over(IN_NORMAL_CASE[lam_n], lam)}

section.identity(
    "1.1/insertion",
    "a point of the original bundle in the normal case",
    printed=columns(E3 * (point - X0), lam * projector),
    derived=columns(*(lam_n * x_normal,) * 2).xreplace(IN_NORMAL_CASE),
)
section.identity(
    "1.1.4",
    "projective transformation to the normal case",
    printed=tau * x_normal,
    where=IN_NORMAL_CASE,
    derived=projector,
)

# %% [markdown]
# Without the factor: quotients with the third component.  The rows of $\mathbf R$ are $\mathbf e_1, \mathbf e_2,
# \mathbf e_3$.

# %%
i1, j1, k1, i2, j2, k2, i3, j3, k3 = R_any
row1, row2, row3 = (R_any.row(k).T for k in range(3))
section.identity(
    "1.1/quotients",
    "the quotients that eliminate the factor",
    printed=vector(-xn / c, -yn / c),
    where=IN_NORMAL_CASE,
    derived=vector(over(projector[0], projector[2]), over(projector[1], projector[2])),
)
denominator = i3 * x + j3 * y - k3 * c
for name, place, numerator, row in (
    ("x", 0, i1 * x + j1 * y - k1 * c, row1),
    ("y", 1, i2 * x + j2 * y - k2 * c, row2),
):
    section.identity(
        f"1.1.5#{name}",
        f"{name} coordinate of the normal case",
        printed=vector(-c * numerator / denominator, -c * dot(row, x_vector) / dot(row3, x_vector)),
        derived=vector(*(IN_NORMAL_CASE[(xn, yn)[place]],) * 2),
        note="Both members of the equation.",
    )
a = sympy.symbols("a1:9")
section.identity(
    "1.1/last-number",
    "the last number of the denominator can be made 1",
    printed=vector(
        (a[0] * x + a[1] * y + a[2]) / (a[6] * x + a[7] * y + 1),
        (a[3] * x + a[4] * y + a[5]) / (a[6] * x + a[7] * y + 1),
    ),
    where=dict(
        zip(
            a,
            (
                *(over(entry, k3) for entry in (i1, j1, -k1 * c, i2, j2, -k2 * c)),
                over(-i3, k3 * c),
                over(-j3, k3 * c),
            ),
            strict=True,
        )
    ),
    derived=vector(IN_NORMAL_CASE[xn], IN_NORMAL_CASE[yn]),
    note="The form of Haggren and Niini, as the text describes it; it needs k3 c to be a divisor.",
)

# %% [markdown]
# ## The factor
#
# Rotations keep lengths.

# %%
rotated = R_rotation * x_vector
AFTER_ROTATION = dict(zip((xn, yn), image_of(rotated), strict=True)) | {tau: over(-rotated[2], c)}
length_n, length = dot(x_normal, x_normal), dot(x_vector, x_vector)
section.identity(
    "1.1/tau",
    "square of the factor",
    printed=vector(tau**2 * length_n, dot(rotated, rotated)),
    where=AFTER_ROTATION,
    derived=vector(length, length),
    note="The first and second member; the third, with R^T R = E, is 1.1/E.",
)
section.identity(
    "1.1/length",
    "length of the projector",
    printed=vector(x**2 + y**2 + c**2, x**2 + y**2 + c**2),
    derived=vector(dot(rotated, rotated), length),
)
section.identity(
    "1.1.6",
    "the factor as the ratio of two distances",
    printed=over(length, length_n),
    where=AFTER_ROTATION,
    derived=(over(-rotated[2], c)) ** 2,
    note="Squares of both members.  The root is positive, while tau has the sign of -p3: the equation holds for "
    "points in front of both image planes, see 1.1/beyond/sign.",
)
half_turn = rotation(*map(sympy.Integer, (0, 1, 0, 0))).doit()
section.identity(
    "1.1/beyond/sign",
    "the factor is negative for a point behind the plane of the normal case",
    printed=-1,
    derived=over(-(half_turn * x_vector)[2], c),
    note="Not in the paper: half a turn about the first axis, where both distances are equal.  The ratio of distances "
    "gives +1 there.",
)
