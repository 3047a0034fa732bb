# %% [markdown]
# # 8 In letters and angles
#
# The papers print most matrices as letters, and rotations by their angles.  Here some of their statements stand as
# they are printed.  What holds in letters holds for all entries at once.

# %%
import sympy
from sympy import Determinant, Eq, MatrixSymbol, Trace, cos, sin, tan

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
