# %% [markdown]
# # 2.1 The rotational relative orientation
#
# Two images can be brought into relative orientation by rotations alone: the base stays where it is, $\mathbf b = (1,
# 0, 0)^T$.  The left image is moved by tip $\varphi'$ and swing $\kappa'$, the right one by tilt $\Omega''$, tip
# $\varphi''$ and swing $\kappa''$.  Are five rotations enough?

# %%
from itertools import product

import sympy

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import given, inserted
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, determinant, over, vector

section = Section("normalcase1992", "2.1", "The rotational relative orientation")

# %% [markdown]
# ## What are the matrices of orientation?
#
# **Definition.**  The product of the rotations about the three axes, $\Omega$ first in the row and last on the way from
# the image.

# %%
R_p = turn_phi(*PHI_LEFT) * turn_kappa(*KAPPA_LEFT)
R_pp = turn_omega(*OMEGA) * turn_phi(*PHI_RIGHT) * turn_kappa(*KAPPA_RIGHT)
R_pp

# %% [markdown]
# **Print.**  The left matrix is that of the right image without tilt.

# %%
section.identity(
    "2.1.1",
    "matrix of orientation of the right image",
    derived=R_pp,
)
section.identity(
    "2.1.2",
    "matrix of orientation of the left image",
    derived=R_p,
)
section.identity(
    "2.1/no-tilt",
    "the left matrix is that of the right image without tilt",
    printed=R_p,
    derived=inserted(R_pp, (Omegapp, phipp, kappapp), (0, phip, kappap)),
)

# %% [markdown]
# **Are they rotations?**  They are orthogonal with determinant 1.

# %%
section.identity("2.1/orthogonal#left", "the left matrix is orthogonal", printed=E3, derived=R_p.T * R_p)
section.identity("2.1/orthogonal#right", "the right matrix is orthogonal", printed=E3, derived=R_pp * R_pp.T)
section.identity(
    "2.1/beyond/determinants",
    "both matrices are rotations",
    printed=vector(1, 1),
    derived=vector(determinant(R_p), determinant(R_pp)),
)

# %% [markdown]
# **An example.**  All angles have the sine $7/25$, those of the left image with the opposite sign.

# %%
COSINE, SINE = sympy.Rational(24, 25), sympy.Rational(7, 25)
turned = {
    "'": R_p.xreplace(given((*PHI_LEFT, *KAPPA_LEFT), (COSINE, -SINE) * 2)),
    "''": R_pp.xreplace(given((*OMEGA, *PHI_RIGHT, *KAPPA_RIGHT), (COSINE, SINE) * 3)),
}
centers = {"'": vector(0, 0, 0), "''": 4 * unit_base}
CORNERS = {"1": vector(-1, -1, -2), "2": vector(1, -1, -2), "3": vector(1, 1, -2), "4": vector(-1, 1, -2)}
SIDES = (("1", "2"), ("2", "3"), ("3", "4"), ("4", "1"))
SpaceDrawing(
    "Both images are turned about their centers, and the base stays where it is.",
    {f"C{primes}": place for primes, place in centers.items()}
    | {n + primes: place + turned[primes] * p for primes, place in centers.items() for n, p in CORNERS.items()},
    segments=[("C'", "C''")]
    + [(first + primes, second + primes) for primes in centers for first, second in SIDES]
    + [(f"C{primes}", n + primes) for primes in centers for n in CORNERS],
    axes=("X_1", "X_2", "X_3"),
)

# %% [markdown]
# ## What is the matrix of correlation?
#
# **Definition.**  With this base $\mathbf B$ keeps one pair of opposite elements.

# %%
C = correlation(R_left, R_right, unit_base)
left, right = R_left, R_right
section.identity(
    "2.1.3",
    "matrix of correlation of rotational relative orientation",
    printed=Matrix(3, 3, lambda u, v: left[2, u] * right[1, v] - left[1, u] * right[2, v]),
    derived=C,
    note="Element by element, with i, j, k of the left image in the rows and of the right image in the columns.  The "
    "scan has lost all primes and shows a stray i3 in two rows; the letters and (1.2.4) determine which factor is "
    "primed once.",
)

# %% [markdown]
# First components do not occur: they may be replaced by others.

# %%
first_row = given((*left.row(0), *right.row(0)), sympy.symbols("f1:7"))
section.identity(
    "2.1/components",
    "only the second and third components occur",
    printed=C.xreplace(first_row),
    derived=C,
)

# %% [markdown]
# **In terms of the angles.**  The divisor of $\mathbf Z$ is $\cos\varphi'$ times $j''_2$.  It vanishes if the second
# axis of the right image is perpendicular to that of the model: for a swing of a right angle without tilt, for example.

# %%
section.identity(
    "2.1/beyond/angles",
    "matrix of correlation in terms of the angles",
    printed=Matrix(3, 3, lambda u, v: R_p[2, u] * R_pp[1, v] - R_p[1, u] * R_pp[2, v]),
    derived=correlation(R_p, R_pp, unit_base),
)
section.identity(
    "2.1/beyond/c32",
    "the element by which Z is divided",
    printed=cos(phip) * (cos(Omegapp) * cos(kappapp) - sin(Omegapp) * sin(phipp) * sin(kappapp)),
    derived=correlation(R_p, R_pp, unit_base)[2, 1],
)

# %% [markdown]
# ## Are five rotations enough?
#
# **Derivation.**  The ratios of the elements of $\mathbf C$ depend on five angles; are they independent?  With
# half-angle tangents the angles are rational, and the rank of the Jacobian matrix at one rational point decides.  Five
# of the eight elements of $\mathbf Z$ are independent.  The other three are the conditions that section 2.2 says are
# not observed.

# %%
tangents = sympy.symbols("t1:6")


def of_tangent(tangent: sympy.Symbol) -> tuple[sympy.Expr, sympy.Expr]:
    return over(1 - tangent**2, 1 + tangent**2), over(2 * tangent, 1 + tangent**2)


t1, t2, t3, t4, t5 = tangents
R_p_rational = turn_phi(*of_tangent(t1)) * turn_kappa(*of_tangent(t2))
R_pp_rational = turn_omega(*of_tangent(t3)) * turn_phi(*of_tangent(t4)) * turn_kappa(*of_tangent(t5))
C_rational = correlation(R_p_rational, R_pp_rational, unit_base)
section.count(
    "2.1/five",
    "the five angles represent the relative orientation",
    printed=5,
    derived=vector(
        *(over(C_rational[place], C_rational[2, 1]) for place in product(range(3), repeat=2) if place != (2, 1))
    ),
    variables=tangents,
)
