# %% [markdown]
# # 1.1 Condition of intersection and projective transformation
#
# A point of the model lies on a ray of each image.  Seen from the same center, the normal case is an image as well, one
# that is not rotated.  How are two images of one bundle of rays related?  By a projective transformation, which this
# section derives.

# %%
import sympy
from sympy import BlockMatrix, Eq, Identity, ImmutableMatrix, MatrixSymbol

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.inserting import given, inserted
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import dot, over, vector
from algebroproj_sym.expressions.letters import Dot

section = Section("normalcase1992", "1.1", "Condition of intersection and projective transformation")

# %% [markdown]
# ## What is measured?
#
# **Definition.**  An image point is a vector with the third component $-c$.  A rotation takes it to the model space; it
# is given by a quaternion of any length where it has to be orthogonal.

# %%
lam, lam_p, lam_pp, lam_n, tau = sympy.symbols("lam lam_p lam_pp lam_n tau")
X = vector(*sympy.symbols("X1:4"))
X0 = vector(*sympy.symbols("X01 X02 X03"))
X0_left, X0_right = (vector(*sympy.symbols(f"X01{primes} X02{primes} X03{primes}")) for primes in ("p", "pp"))

section.definition("1.1/x", "vector of image coordinates")
section.definition("1.1/p", "projector in the model space")
section.identity(
    "1.1/E",
    "rotations are orthogonal",
    derived=R_rotation.T * R_rotation,
)

# %% [markdown]
# ## Where is the point?
#
# **Definition.**  Each image puts the point on a ray, $\mathbf X = \mathbf X_0 + \lambda \mathbf R \mathbf x$.  Both
# together are the condition of intersection.

# %%
section.definition(
    "1.1.1",
    "condition of intersection: the point on a ray of each image",
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

# %% [markdown]
# **Solved for the image**, as rotations are orthogonal:

# %%
R, X_bold, X0_bold, x_bold = (MatrixSymbol(*of) for of in (("R", 3, 3), ("X", 3, 1), ("X0", 3, 1), ("x", 3, 1)))
section.identity(
    "1.1.2",
    "projection of a point",
    constraints=[Eq(X_bold, X0_bold + lam * R * x_bold)],
    properties={R: "rotation"},
    derived=R.T * (X_bold - X0_bold),
)

# %% [markdown]
# ## What does the normal case see?
#
# **Definition.**  The image of the same bundle with $\mathbf R = \mathbf E$ and the same principal distance: third
# component $-c$.

# %%
ray = X - X0
normal_coordinates = image_of(ray)
normal_factor = over(-ray[2], c)
xn, yn = sympy.symbols("xN yN")
x_normal = image_vector(xn, yn)
section.identity(
    "1.1.3",
    "projection of the normal case",
    where={lam_n: normal_factor, xn: normal_coordinates[0], yn: normal_coordinates[1]},
    derived=E3 * (X - X0),
)

# %% [markdown]
# **A point of the original bundle**, put in: the projector is the vector of the normal case but for a factor $\tau$.

# %%
point = X0 + lam * R_any * x_vector
projector = R_any * x_vector
IN_NORMAL_CASE = given((xn, yn), image_of(E3 * (point - X0)))
IN_NORMAL_CASE |= {lam_n: over((X0 - point)[2], c)}
IN_NORMAL_CASE |= {tau: over(IN_NORMAL_CASE[lam_n], lam)}

normal_bold = MatrixSymbol("xN", 3, 1)
INSERTED = [Eq(X_bold, X0_bold + lam * R * x_bold), Eq(normal_bold, Identity(3) * (X_bold - X0_bold) / lam_n)]
section.identity(
    "1.1/insertion",
    "a point of the original bundle in the normal case",
    constraints=INSERTED,
    derived=BlockMatrix([[lam_n * normal_bold, lam_n * normal_bold]]),
)
section.identity(
    "1.1.4",
    "projective transformation to the normal case",
    constraints=[*INSERTED, Eq(lam_n, tau * lam)],
    derived=R * x_bold,
)

# %% [markdown]
# **Print.**  Without the factor: quotients with the third component.  The rows of $\mathbf R$ are $\mathbf e_1, \mathbf
# e_2, \mathbf e_3$.

# %%
i1, j1, k1, i2, j2, k2, i3, j3, k3 = R_any
section.identity(
    "1.1/quotients",
    "the quotients that eliminate the factor",
    where=IN_NORMAL_CASE,
    derived=vector(over(projector[0], projector[2]), over(projector[1], projector[2])),
)
denominator = i3 * x + j3 * y - k3 * c
section.identity(
    "1.1.5#x",
    "x coordinate of the normal case",
    derived=vector(xn, xn).xreplace(IN_NORMAL_CASE),
)
section.identity(
    "1.1.5#y",
    "y coordinate of the normal case",
    derived=vector(yn, yn).xreplace(IN_NORMAL_CASE),
)

# %% [markdown]
# **Eight numbers.**  Divided by the last number of the denominator, $-k_3 c$, this is the form of Haggren and Niini.

# %%
a = sympy.symbols("a1:9")
section.identity(
    "1.1/last-number",
    "the last number of the denominator can be made 1",
    printed=vector(
        (a[0] * x + a[1] * y + a[2]) / (a[6] * x + a[7] * y + 1),
        (a[3] * x + a[4] * y + a[5]) / (a[6] * x + a[7] * y + 1),
    ),
    where=given(
        a,
        (
            *(over(entry, k3) for entry in (i1, j1, -k1 * c, i2, j2, -k2 * c)),
            over(-i3, k3 * c),
            over(-j3, k3 * c),
        ),
    ),
    derived=vector(IN_NORMAL_CASE[xn], IN_NORMAL_CASE[yn]),
)

# %% [markdown]
# **An example.**  A square grid in an image with a tip whose sine is $7/25$, and the same points in the normal case.

# %%
TIP = given(R_any, turn_phi(sympy.Rational(24, 25), sympy.Rational(7, 25)))
to_normal_case = vector(xn, yn).xreplace(IN_NORMAL_CASE).xreplace(TIP)
GRID = {f"{i}{j}": vector(i - 1, j - 1) for i in range(3) for j in range(3)}
ImageDrawing(
    "A grid of nine points in the original image and in the normal case, for c = 2.  The squares become trapezoids.",
    {
        "original image": (GRID, []),
        "normal case": ({name: inserted(to_normal_case, (x, y, c), (*p, 2)).doit() for name, p in GRID.items()}, []),
    },
    axes=("x", "y"),
)

# %% [markdown]
# ## What is the factor?
#
# **Derivation.**  Rotations keep lengths.

# %%
rotated = R_rotation * x_vector
AFTER_ROTATION = given((xn, yn), image_of(rotated)) | {tau: over(-rotated[2], c)}
length_n, length = dot(x_normal, x_normal), dot(x_vector, x_vector)
section.identity(
    "1.1/tau",
    "square of the factor",
    constraints=[Eq(normal_bold, R * x_bold / tau)],
    properties={R: "rotation"},
    derived=ImmutableMatrix([[Dot(x_bold, x_bold)] * 3]),
)
section.identity("1.1/length", "length of the projector", derived=vector(dot(rotated, rotated), length))

# %% [markdown]
# **Print.**  So the factor is the ratio of two distances, in squares.  The root is positive, while $\tau$ has the sign
# of $-p_3$: the equation holds for points in front of both image planes.  Half a turn about the first axis keeps both
# distances, and makes $\tau = -1$.

# %%
section.identity(
    "1.1.6",
    "the factor as the ratio of two distances",
    printed=over(length, length_n),
    where=AFTER_ROTATION,
    derived=(over(-rotated[2], c)) ** 2,
)
half_turn = rotation(*map(sympy.Integer, (0, 1, 0, 0))).doit()
section.identity(
    "1.1/beyond/sign",
    "the factor is negative for a point behind the plane of the normal case",
    printed=-1,
    derived=over(-(half_turn * x_vector)[2], c),
)
