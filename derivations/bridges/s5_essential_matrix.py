# %% [markdown]
# # 5 The essential matrix
#
# For calibrated images the textbook has cameras $[\mathbf I\; \mathbf 0]$ and $[\mathbf R\; \mathbf t]$ in the system
# of the left image, and $\mathbf E = [\mathbf t]_\times \mathbf R$.  The paper of 1992 has
# $\mathbf C = \mathbf R'^T \mathbf B \mathbf R''$.  Are they the same, and what does calibration add?

# %%
import sympy
from sympy import Determinant, Eq, Identity, MatrixSymbol, Trace

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, vector
from algebroproj_sym.expressions.letters import Dot, Skew

section = Section("bridges", "5", "The essential matrix")

# %% [markdown]
# ## What are $\mathbf R$ and $\mathbf t$ in the parameters of 1992?
#
# **Definition.**  The left system has the axes $\mathbf R'$ and its origin in the left center: $\mathbf X = \mathbf R'
# \mathbf X'$.  In the right system the point is $\mathbf R''^T (\mathbf R' \mathbf X' - \mathbf b)$.

# %%
E, R, Rp, Rpp = (MatrixSymbol(name, 3, 3) for name in ("E", "R", "Rp", "Rpp"))
t, b, X = (MatrixSymbol(name, 3, 1) for name in "tbX")
of_both_images = {
    "constraints": [Eq(R, Rpp.T * Rp), Eq(t, -Rpp.T * b)],
    "properties": {Rp: "rotation", Rpp: "rotation"},
}

section.identity(
    "5/relative",
    "rotation and base of the right image in the system of the left one",
    printed=R * X + t,
    derived=Rpp.T * (Rp * X - b),
    **of_both_images,
)

# %% [markdown]
# **An example.**  A right image with a tip whose sine is $-7/25$: the axes of both systems at their centers.

# %%
TIPPED = Matrix([[24, 0, -7], [0, 25, 0], [7, 0, 24]]) / 25
EXAMPLE_BASE = vector(3, 0, 0)
SYSTEMS = (("'", vector(0, 0, 0), Matrix.eye(3)), ("''", EXAMPLE_BASE, TIPPED))
POINT = {"P": vector(sympy.Rational(3, 2), 1, -3)}
SpaceDrawing(
    "Both systems of axes i, j, k, the base between the centers and a point P.  R turns one system to the other; t is "
    "the base as the right image sees it.",
    {f"C{primes}": place for primes, place, _ in SYSTEMS}
    | {f"{name}{primes}": place + turn.col(n) for primes, place, turn in SYSTEMS for n, name in enumerate("ijk")}
    | POINT,
    segments=[("C'", "C''"), ("C'", "P"), ("C''", "P")]
    + [(f"C{primes}", f"{name}{primes}") for primes, _, _ in SYSTEMS for name in "ijk"],
    axes=("X_1", "X_2", "X_3"),
)

# %% [markdown]
# **Result.**  $\mathbf R = \mathbf R''^T \mathbf R'$ and $\mathbf t = -\mathbf R''^T \mathbf b$; $\mathbf E$ is
# $\mathbf C^T$ without a factor.

# %%
C_1992 = Rp.T * Skew(b) * Rpp
section.identity(
    "5/E",
    "the essential matrix is the transposed matrix of correlation",
    printed=Skew(t) * R,
    derived=C_1992.T,
    **of_both_images,
)

# %% [markdown]
# ## What does calibration add?
#
# **Result.**  Of its three singular values one is zero and two are equal, to the length of $\mathbf t$.  It satisfies
# nine cubic equations, $2 \mathbf E \mathbf E^T \mathbf E = \operatorname{tr}(\mathbf E \mathbf E^T)\, \mathbf E$.

# %%
essential = {"constraints": [Eq(E, Skew(t) * R)], "properties": {R: "rotation"}}
lam = sympy.Symbol("lam")

section.identity(
    "5/singular-values",
    "the characteristic polynomial of the squared singular values",
    printed=-lam * (lam - Dot(t, t)) ** 2,
    derived=Determinant(E * E.T - lam * Identity(3)),
    **essential,
)
section.identity("5/epipole", "the base is the left null vector", printed=0 * t, derived=E.T * t, **essential)
section.identity(
    "5/determinant", "the determinant vanishes", printed=sympy.Integer(0), derived=Determinant(E), **essential
)
section.identity(
    "5/trace",
    "the cubic equations of the essential matrix",
    printed=2 * E * E.T * E,
    derived=Trace(E * E.T) * E,
    **essential,
)

# %% [markdown]
# A general matrix of correlation does not satisfy them.  This one has rank 2, and the singular values 2, 1, 0.

# %%
general = Matrix([[0, 0, 0], [0, 0, -1], [0, 2, 0]])
section.identity(
    "5/trace#projective",
    "a matrix of correlation that is not essential",
    printed=Matrix([[0, 0, 0], [0, 0, 3], [0, 6, 0]]),
    derived=2 * general * general.T * general - (general * general.T).trace() * general,
)
