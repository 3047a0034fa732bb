# %% [markdown]
# # 8 In letters and angles
#
# The papers print most matrices as letters, and rotations by their angles.  Here some of their statements stand as
# they are printed.  What holds in letters holds for all entries at once.

# %%
import sympy
from sympy import BlockMatrix, Determinant, Eq, Identity, MatrixSymbol, Trace, ZeroMatrix, cos, sin, tan

from algebroproj_derivations.normalcase1992.notation import turn_kappa, turn_omega, turn_phi
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, over
from algebroproj_sym.expressions.letters import Skew

section = Section("bridges", "8", "In letters and angles")

# %% [markdown]
# ## The essential matrix
#
# $\mathbf E = [\mathbf t]_\times \mathbf R$.  The paper of 1992 has $\mathbf C = \mathbf R'^T \mathbf B \mathbf R''$,
# with $\mathbf B$ for the cross product with the base.  In the system of the left image the rotation of the right one
# is $\mathbf R''^T \mathbf R'$, and its base is $-\mathbf R''^T \mathbf b$.

# %%
E, R, Rp, Rpp = (MatrixSymbol(name, 3, 3) for name in ("E", "R", "Rp", "Rpp"))
t, b = (MatrixSymbol(name, 3, 1) for name in "tb")
essential = {"constraints": [Eq(E, Skew(t) * R)], "properties": {R: "rotation"}}

section.identity(
    "8/E",
    "the essential matrix is the transposed matrix of correlation of 1992",
    printed=(Rp.T * Skew(b) * Rpp).T,
    derived=Skew(-Rpp.T * b) * (Rpp.T * Rp),
    properties={Rp: "rotation", Rpp: "rotation"},
    note="(5/E) in letters.",
)
section.identity("8/epipole", "the base is the left null vector", printed=E.T * t, derived=0 * t, **essential)
section.identity(
    "8/cubic",
    "the cubic equations of the essential matrix",
    printed=2 * E * E.T * E,
    derived=Trace(E * E.T) * E,
    note="(5/trace) in letters.",
    **essential,
)
section.identity(
    "8/determinant", "the determinant vanishes", printed=Determinant(E), derived=sympy.Integer(0), **essential
)

# %% [markdown]
# ## Projection between cartesian systems
#
# (1.4.5) of 1996 is $\mu \mathbf v = \mathbf A_v \mathbf M \mathbf A_X^{-1} \mathbf X$.  The affine frame of the object
# points has the first one, $\mathbf g$, as its origin and differences of points as columns of $\mathbf B$.  With
# $\mathbf P = \mathbf A_v^{-1} \mathbf R^T \mathbf B$ the matrix of the image is
# $\mathbf M = (-\mathbf P \mathbf z, \mathbf P)$, where $\mathbf z$ is the center of projection in the affine frame.
# The left side must be the ray from that center, in the image system.

# %%
A_v, B, P = (MatrixSymbol(name, 3, 3) for name in ("A_v", "B", "P"))
g, z, x = (MatrixSymbol(name, 3, 1) for name in "gzx")
M, A_X, X = MatrixSymbol("M", 3, 4), MatrixSymbol("A_X", 4, 4), MatrixSymbol("X", 4, 1)

section.identity(
    "8/projection",
    "projection between cartesian systems",
    printed=A_v * M * A_X.I * X,
    derived=R.T * (x - (g + B * z)),
    constraints=[
        Eq(P, A_v.I * R.T * B),
        Eq(M, BlockMatrix([[-P * z, P]])),
        Eq(A_X, BlockMatrix([[Identity(1), ZeroMatrix(1, 3)], [g, B]])),
        Eq(X, BlockMatrix([[Identity(1)], [x]])),
    ],
    properties={R: "rotation"},
    note="(1.4.5) of 1996 in letters.  A_v may be any regular matrix.",
)

# %% [markdown]
# ## Angles
#
# (2.1.1) of 1992 with the angles themselves, and not a cosine and a sine for each.

# %%
omega, phi, kappa = sympy.symbols("omega phi kappa")
section.identity(
    "8/rotation",
    "matrix of orientation of the right image",
    printed=Matrix(
        [
            [cos(phi) * cos(kappa), -cos(phi) * sin(kappa), sin(phi)],
            [
                sin(omega) * sin(phi) * cos(kappa) + cos(omega) * sin(kappa),
                -sin(omega) * sin(phi) * sin(kappa) + cos(omega) * cos(kappa),
                -sin(omega) * cos(phi),
            ],
            [
                -cos(omega) * sin(phi) * cos(kappa) + sin(omega) * sin(kappa),
                cos(omega) * sin(phi) * sin(kappa) + sin(omega) * cos(kappa),
                cos(omega) * cos(phi),
            ],
        ]
    ),
    derived=turn_omega(cos(omega), sin(omega)) * turn_phi(cos(phi), sin(phi)) * turn_kappa(cos(kappa), sin(kappa)),
)

# %% [markdown]
# With the tangent of the half angle a rotation is rational.  (2.1/five) of 1992 counts with it.  It leaves out the half
# turn, where the tangent has a pole.

# %%
half = tan(phi / 2)
section.identity(
    "8/half-angle#cosine", "cosine by the half angle", printed=over(1 - half**2, 1 + half**2), derived=cos(phi)
)
section.identity("8/half-angle#sine", "sine by the half angle", printed=over(2 * half, 1 + half**2), derived=sin(phi))
