# %% [markdown]
# # 11 Cameras K [R | t]
#
# Programs of computer vision give a camera as $\mathbf K [\mathbf R | \mathbf t]$: pixels of a point are $\mathbf K
# (\mathbf R \mathbf X + \mathbf t)$, up to a factor.  How does one come to the parameters of the papers, and back?
# Which rotations rectify a pair of images, and which is the best point for two rays that do not meet?

# %%
import sympy

from algebroproj_derivations.bridges.s10_relative_orientation import (
    EXAMPLE_TURN,
    C,
    base,
    image,
    left,
    right,
    turn,
)
from algebroproj_derivations.cameras import skew
from algebroproj_derivations.epipolar import corrected, rectify
from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.notation import mu0, mu1, mu2, mu3, u31, u32
from algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection import M_star
from algebroproj_derivations.fundamentals1996.s1_4_orthonormalized_systems import coordinates, frame, rotation
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    cross,
    diff,
    dot,
    inverse,
    over,
    rows,
    vector,
)

section = Section("bridges", "11", "Cameras K [R | t]")

# %% [markdown]
# ## What are the parameters of 1996?
#
# **Definition.**  A camera $\mathbf P$ has three rows, for $x$, $y$ and 1, and four columns, for $X$, $Y$, $Z$ and 1.
# The basic points $G_0, \dots, G_3$ are the rows of $\mathbf G$.  The third components of their images are the factors
# $\mu_j$; the images themselves are $\mathbf g_0, \mathbf g_1, \mathbf g_2$ and, in the affine system of these,
# $\mathbf u_3$.  (The papers put the 1 first.)

# %%
P = Matrix(3, 4, sympy.symbols("p:3:4"))
G = Matrix(4, 3, sympy.symbols("G:4:3"))
g = Matrix(3, 2, sympy.symbols("g:3:2"))
TO_FIRST = Matrix([[0, 0, 1], [1, 0, 0], [0, 1, 0]])
IN_SPACE = Matrix([[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0]])
"""They put the 1 of an image point first, and that of a point of space last."""

seen = [P * vector(*G.row(j), 1) for j in range(4)]
factors = [each[2] for each in seen]
images = [image(each) for each in seen]
u3 = coordinates(images[3], rows(*images[:3]))
of_core = given((mu0, mu1, mu2, mu3, u31, u32), (*factors, *u3))
core = M_star[:3, :]

# %% [markdown]
# **Result.**  In the affine systems of the basic points the camera is the core of 1996, without a factor.

# %%
section.identity(
    "11/camera",
    "the camera of its parameters of 1996",
    printed=TO_FIRST * P * IN_SPACE * frame(G),
    derived=(frame(rows(*images[:3])) * core).xreplace(of_core),
)

# %% [markdown]
# ## How do two cameras lie to each other?
#
# **Definition.**  $\mathbf X' = \mathbf R' \mathbf X + \mathbf t'$ and $\mathbf X'' = \mathbf R'' \mathbf X + \mathbf
# t''$ are a point in the systems of both images.
#
# **Result.**  $\mathbf X' = \mathbf R \mathbf X'' + \mathbf b$ with $\mathbf R = \mathbf R' \mathbf R''^T$ and
# $\mathbf b = \mathbf t' - \mathbf R \mathbf t''$.

# %%
turns = [Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in ("rp", "rpp")]
moves = [vector(*sympy.symbols(f"{name}:3")) for name in ("tp", "tpp")]
point = vector(*sympy.symbols("X Y Z"))
relative = turns[0] * turns[1].T
relative_base = moves[0] - relative * moves[1]

section.identity(
    "11/relative",
    "a point in the left system is that of the right system, turned and moved",
    printed=turns[0] * point + moves[0],
    derived=(relative * (turns[1] * point + moves[1]) + relative_base).xreplace(given(turns[1], rotation)),
)

# %% [markdown]
# ## What is the fundamental matrix?
#
# **Definition.**  Pixels are $\mathbf K \mathbf u$, up to a factor, with $\mathbf u = (x, y, 1)^T$.
#
# **Result.**  With $\mathbf F = \mathbf K''^{-T} \mathbf C^T \mathbf K'^{-1}$, pixels satisfy $\mathbf p''^T \mathbf F
# \mathbf p' = 0$ where $\mathbf u'^T \mathbf C \mathbf u'' = 0$.

# %%
K_left, K_right = (Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in ("kp", "kpp"))
fundamental = inverse(K_right).T * C.T * inverse(K_left)

section.identity(
    "11/F",
    "pixels satisfy the equation of the fundamental matrix",
    printed=dot(left, C * right),
    derived=dot(K_right * right, fundamental * (K_left * left)),
)

# %% [markdown]
# ## Which rotations rectify?
#
# **Definition.**  Both images are turned to the same axes.  The first one is along the base, the second one at right
# angles to it and to $\mathbf k$, the sum of both optical axes.
#
# **Result.**  The matrix of correlation of the turned images, $\mathbf R_1 \mathbf C \mathbf R_2^T$, is that of a base
# along the first axis: homologous points have the same $y$.

# %%
length_base, length_second = sympy.symbols("nb ns")
optical = vector(0, 0, 1) + turn.col(2)
across = cross(optical, base)
axis, second = over(1, length_base) * base, over(1, length_second) * across
rectifying = rows(axis, second, cross(axis, second))
unit_lengths = {
    "constraints": [
        length_base**2 - dot(base, base),
        length_second**2 - dot(across, across),
    ]
}

section.identity(
    "11/rectified#rotation",
    "the axes are orthonormal",
    printed=Matrix.eye(3),
    derived=rectifying * rectifying.T,
    **unit_lengths,
)
section.identity(
    "11/rectified",
    "the matrix of correlation of the turned images",
    printed=length_base * skew(vector(1, 0, 0)),
    derived=rectifying * skew(base) * rectifying.T,
    **unit_lengths,
)

# %% [markdown]
# **An example.**  A' and A'' are on the optical axes of both images, T' and T'' on their common third axis.

# %%
of_example = given(turn, Matrix(EXAMPLE_TURN)) | given(base, vector(1, sympy.Rational(1, 4), sympy.Rational(1, 2)))
base_of_example = base.xreplace(of_example)
third = cross(base, across).xreplace(of_example)
SpaceDrawing(
    "Both images turn about their centers, to axes along the base.",
    {
        "C'": vector(0, 0, 0),
        "C''": base_of_example,
        "A'": vector(0, 0, 1),
        "A''": base_of_example + turn.col(2).xreplace(of_example),
        "T'": third / 2,
        "T''": base_of_example + third / 2,
    },
    segments=[("C'", "C''"), ("C'", "A'"), ("C''", "A''"), ("C'", "T'"), ("C''", "T''")],
    axes=("X_1", "X_2", "X_3"),
)

# %% [markdown]
# ## Which pair is nearest?
#
# **Question.**  By how much must a pair move at least, to satisfy $\mathbf u'^T \mathbf C \mathbf u'' = 0$?  Sampson's
# answer is one of the first order.
#
# **Derivation.**  A least change $\mathbf d$ is along the gradient of the equation (Lagrange): $\mathbf d = -m\, \nabla
# f(\mathbf d)$.  The gradient is linear, and $\mathbf C_2$, the first two rows and columns of $\mathbf C$, has its
# slopes.

# %%
changes = [vector(*sympy.symbols(f"{name}:4")) for name in "dt"]
multiplier = sympy.Symbol("m")
C_2 = C[:2, :2]


def equation(by: Matrix) -> sympy.Expr:
    """Return the left side of the equation after a change of the coordinates of both points."""
    return dot(left + vector(by[0], by[1], 0), C * (right + vector(by[2], by[3], 0)))


def slopes(by: Matrix) -> Matrix:
    """Return the gradient after a change, by products with the matrix."""
    return vector(*(C * right)[:2], *(C.T * left)[:2]) + vector(*(C_2 * by[2:, :]), *(C_2.T * by[:2, :]))


section.identity(
    "11/gradient",
    "the gradient after a change",
    printed=slopes(changes[0]),
    derived=vector(*(diff(equation(changes[0]), each) for each in changes[0])),
)

# %% [markdown]
# **Result.**  Let another change $\mathbf t$ satisfy the equation, too, and let $\mathbf s = \mathbf t - \mathbf d$.
# Then $\mathbf t^2 = \mathbf d^2 + \mathbf s^2 + 2 m\, \mathbf s'^T \mathbf C_2 \mathbf s''$.
#
# **Meaning.**  The last two terms together are not negative if $|m| \sigma \le 1$, with the larger singular value
# $\sigma$ of $\mathbf C_2$.  So $\mathbf d$ is the least change of all, and no other place of rest matters.  Between
# $-1/\sigma$ and $1/\sigma$ the equation decreases with $m$.  Newton's method and bisection find its only root there.

# %%
other = changes[1] - changes[0]
section.identity(
    "11/nearest",
    "by how much another pair that satisfies the equation is farther away",
    printed=dot(other, other) + 2 * multiplier * dot(other[:2, :], C_2 * other[2:, :]),
    derived=dot(changes[1], changes[1]) - dot(changes[0], changes[0]),
    constraints=[
        equation(changes[0]),
        equation(changes[1]),
        *(changes[0] + multiplier * slopes(changes[0])),
    ],
)

# %% [markdown]
# ## Functions

# %%
s = [vector(*row) for row in Matrix(4, 3, sympy.symbols("s:4:3")).tolist()]
area = dot(s[1], cross(s[2], s[0])) * s[3][2]
section.kernel(
    "projection.from_camera",
    "Parameters of 1996 of a camera matrix: (mu1, mu2, mu3) for mu0 = 1, u3, and the images of three basic points.",
    arguments={"P": P, "G": G},
    describe={
        "P": "Camera matrix, up to a factor: x, y and 1 in the rows, X, Y, Z and 1 in the columns.",
        "G": "The four basic points, a row each; not in a plane.",
    },
    derived={
        "mu": vector(*(over(each, factors[0]) for each in factors[1:])),
        "u3": u3,
        "g": rows(*images[:3]),
    },
    form={
        "mu": vector(*(over(each[2], s[0][2]) for each in s[1:])),
        "u3": vector(
            over(dot(s[3], cross(s[2], s[0])) * s[1][2], area), over(dot(s[3], cross(s[0], s[1])) * s[2][2], area)
        ),
        "g": rows(*(image(each) for each in s[:3])),
    },
    where={symbol: value for names, each in zip(s, seen, strict=True) for symbol, value in given(names, each).items()},
    claims=["11/camera"],
    example={
        "P": (("1000", "0", "500", "250"), ("0", "1000", "400", "-500"), ("0", "0", "1", "4")),
        "G": (("0", "0", "0"), ("1", "0", "0.5"), ("0", "1", "0.25"), ("0.5", "0.5", "1")),
    },
)
mu = vector(mu1, mu2, mu3)
section.kernel(
    "projection.to_camera",
    "Camera matrix of its parameters of 1996 and of the basic points in image and space.",
    arguments={"mu": mu, "u3": vector(u31, u32), "g": g, "G": G},
    describe={
        "mu": "Projective parameters (mu1, mu2, mu3) for mu0 = 1; dimensionless.",
        "u3": "Image (u31, u32) of the fourth basic point in affine coordinates; dimensionless.",
        "g": "Images of three basic points, a row each.",
        "G": "The four basic points, a row each; not in a plane.",
    },
    derived=TO_FIRST.T * (frame(g) * core).xreplace({mu0: sympy.Integer(1)}) * inverse(frame(G)) * IN_SPACE.T,
    claims=["11/camera"],
    example={
        "mu": ("1.125", "1.0625", "1.25"),
        "u3": ("0.5", "0.25"),
        "g": (("62.5", "-125"), ("300", "50"), ("80", "140")),
        "G": (("0", "0", "0"), ("1", "0", "0.5"), ("0", "1", "0.25"), ("0.5", "0.5", "1")),
    },
)
ABOUT_EXTRINSIC = "{} of the {} image: X = R X0 + t, as OpenCV and COLMAP return {}."
section.kernel(
    "stereo.relative",
    "Rotation R and base b of two images, X' = R X'' + b, from their orientations R', t' and R'', t''.",
    arguments={"R_left": turns[0], "t_left": moves[0], "R_right": turns[1], "t_right": moves[1]},
    describe={
        f"{letter}_{side}": ABOUT_EXTRINSIC.format(word, side, "it")
        for side in ("left", "right")
        for letter, word in (("R", "Rotation"), ("t", "Translation"))
    },
    derived={"R": relative, "b": relative_base},
    claims=["11/relative"],
    example={
        "R_left": (("0.8", "0", "0.6"), ("0", "1", "0"), ("-0.6", "0", "0.8")),
        "t_left": ("1", "0.5", "0.25"),
        "R_right": (("0.96", "0", "-0.28"), ("0", "1", "0"), ("0.28", "0", "0.96")),
        "t_right": ("-1", "0.25", "0.5"),
    },
)
section.kernel(
    "stereo.fundamental_matrix",
    "Fundamental matrix F of pixels, p''^T F p' = 0, of a matrix of correlation and both matrices of calibration.",
    arguments={"C": C, "K_left": K_left, "K_right": K_right},
    describe={
        "C": "Matrix of correlation, u'^T C u'' = 0: the transposed essential matrix.",
        "K_left": "Matrix of calibration of the left image: pixels are K' u'.",
        "K_right": "Matrix of calibration of the right image.",
    },
    derived=fundamental,
    claims=["11/F"],
    example={
        "C": (("0", "-0.25", "0"), ("0.52", "0", "-0.89"), ("0", "1", "0")),
        "K_left": (("1000", "0", "500"), ("0", "1000", "400"), ("0", "0", "1")),
        "K_right": (("1200", "0", "600"), ("0", "1250", "500"), ("0", "0", "1")),
    },
)
section.driver("stereo.rectify", rectify)
section.driver("stereo.corrected", corrected)
