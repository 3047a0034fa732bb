# %% [markdown]
# # 8 Angles
#
# The papers print rotations by their angles.  Here some of their statements stand as they are printed.

# %%
import sympy
from sympy import cos, sin, tan

from algebroproj_derivations.normalcase1992.notation import turn_kappa, turn_omega, turn_phi
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, over

section = Section("bridges", "8", "Angles")

# %% [markdown]
# ## The matrix of orientation
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
