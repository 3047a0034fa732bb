# %% [markdown]
# # 2.1 The rotational relative orientation
#
# The base stays where it is, $\mathbf b = (1, 0, 0)^T$.  The left image is moved by tip $\varphi'$ and swing $\kappa'$,
# the right one by tilt $\Omega''$, tip $\varphi''$ and swing $\kappa''$: five rotations.

# %%
from itertools import product

import sympy

from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.declaring import cos_sin
from algebroproj_sym.expressions import Matrix, determinant, over, vector

section = Section("normalcase1992", "2.1", "The rotational relative orientation")

# %% [markdown]
# ## Matrices of orientation
#
# The product of the rotations about the three axes, $\Omega$ first in the row and last on the way from the image.

# %%
R_p = turn_phi(*PHI_LEFT) * turn_kappa(*KAPPA_LEFT)
R_pp = turn_omega(*OMEGA) * turn_phi(*PHI_RIGHT) * turn_kappa(*KAPPA_RIGHT)

cw, sw, cf, sf, ck, sk = c_omega, s_omega, c_phipp, s_phipp, c_kappapp, s_kappapp
section.identity(
    "2.1.1",
    "matrix of orientation of the right image",
    printed=Matrix(
        [
            [cf * ck, -cf * sk, sf],
            [sw * sf * ck + cw * sk, -sw * sf * sk + cw * ck, -sw * cf],
            [-cw * sf * ck + sw * sk, cw * sf * sk + sw * ck, cw * cf],
        ]
    ),
    derived=R_pp,
)
cf, sf, ck, sk = c_phip, s_phip, c_kappap, s_kappap
section.identity(
    "2.1.2",
    "matrix of orientation of the left image",
    printed=Matrix([[cf * ck, -cf * sk, sf], [sk, ck, 0], [-sf * ck, sf * sk, cf]]),
    derived=R_p,
)
section.identity(
    "2.1/no-tilt",
    "the left matrix is that of the right image without tilt",
    printed=R_p,
    derived=R_pp.xreplace(
        {
            c_omega: sympy.Integer(1),
            s_omega: sympy.Integer(0),
            c_phipp: c_phip,
            s_phipp: s_phip,
            c_kappapp: c_kappap,
            s_kappapp: s_kappap,
        }
    ),
)
CIRCLES_LEFT = [on_circle(*PHI_LEFT), on_circle(*KAPPA_LEFT)]
CIRCLES_RIGHT = [on_circle(*angle) for angle in (OMEGA, PHI_RIGHT, KAPPA_RIGHT)]
PYTHAGOREAN = {
    symbol: value
    for angle in (PHI_LEFT, KAPPA_LEFT, OMEGA, PHI_RIGHT, KAPPA_RIGHT)
    for symbol, value in zip(angle, (sympy.Rational(4, 5), sympy.Rational(3, 5)), strict=True)
}
section.identity(
    "2.1/orthogonal#left",
    "the left matrix is orthogonal",
    printed=E3,
    derived=R_p.T * R_p,
    constraints=CIRCLES_LEFT,
    witness=PYTHAGOREAN,
)
section.identity(
    "2.1/orthogonal#right",
    "the right matrix is orthogonal",
    printed=E3,
    derived=R_pp * R_pp.T,
    constraints=CIRCLES_RIGHT,
    witness=PYTHAGOREAN,
)
section.identity(
    "2.1/beyond/determinants",
    "both matrices are rotations",
    printed=vector(1, 1),
    derived=vector(
        determinant(R_p), determinant(turn_omega(*OMEGA)) * determinant(turn_phi(*PHI_RIGHT) * turn_kappa(*KAPPA_RIGHT))
    ),
    constraints=CIRCLES_LEFT + CIRCLES_RIGHT,
    witness=PYTHAGOREAN,
    note="Not in the paper.",
)

# %% [markdown]
# ## Matrix of correlation
#
# With this base $\mathbf B$ keeps one pair of opposite elements.

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
first_row = dict(zip((*left.row(0), *right.row(0)), sympy.symbols("f1:7"), strict=True))
section.identity(
    "2.1/components",
    "only the second and third components occur",
    printed=C.xreplace(first_row),
    derived=C,
    note="The printed side has other first components.",
)
section.identity(
    "2.1/beyond/angles",
    "matrix of correlation in terms of the angles",
    printed=Matrix(3, 3, lambda u, v: R_p[2, u] * R_pp[1, v] - R_p[1, u] * R_pp[2, v]),
    derived=correlation(R_p, R_pp, unit_base),
    note="Not in the paper: (2.1.1) and (2.1.2) in (2.1.3).",
)
section.identity(
    "2.1/beyond/c32",
    "the element by which Z is divided",
    printed=c_phip * (c_omega * c_kappapp - s_omega * s_phipp * s_kappapp),
    derived=correlation(R_p, R_pp, unit_base)[2, 1],
    note="Not in the paper: cos phi' times j2''.  It vanishes if the second axis of the right image is perpendicular "
    "to that of the model, for example for a swing of a right angle without tilt.",
)

# %% [markdown]
# ## Five parameters
#
# The ratios of the elements of $\mathbf C$ depend on five angles; are they independent?  With half-angle tangents the
# angles are rational, and the rank of the Jacobian matrix at one rational point decides.

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
    note="The elements of Z as functions of the angles: five of the eight are independent, as section 1.1 says of the "
    "parameters.  The other three are the conditions that section 2.2 says are not observed.",
)

# %% [markdown]
# ## Code
#
# Cosine and sine of each angle are given; the rest is products.

# %%
phi, kappa, omega = sympy.symbols("phi kappa omega")
c_phi, s_phi, c_kappa, s_kappa, c_om, s_om = sympy.symbols("c_phi s_phi c_kappa s_kappa c_omega s_omega")
PHI_KAPPA = [cos_sin(c_phi, s_phi, phi), cos_sin(c_kappa, s_kappa, kappa)]
ABOUT_PHI = "Tip, in radians."
ABOUT_KAPPA = "Swing, in radians."
about_base = "Base b = X0'' - X0' in the model system, in any unit.  C has this unit."
orientations = {
    "arguments": {"R_left": R_left, "R_right": R_right},
    "describe": {"R_left": ABOUT_R_LEFT, "R_right": ABOUT_R_RIGHT},
}

section.kernel(
    "metric.rotation_left",
    "Matrix of orientation R' of the left image from tip and swing.",
    arguments={"phi": phi, "kappa": kappa},
    describe={"phi": ABOUT_PHI, "kappa": ABOUT_KAPPA},
    through=PHI_KAPPA,
    derived=turn_phi(c_phi, s_phi) * turn_kappa(c_kappa, s_kappa),
    claims=["2.1.2", "2.1/orthogonal#left"],
    example={"phi": "-0.26", "kappa": "-0.0075"},
)
section.kernel(
    "metric.rotation_right",
    "Matrix of orientation R'' of the right image from tilt, tip and swing.",
    arguments={"omega": omega, "phi": phi, "kappa": kappa},
    describe={"omega": "Tilt, in radians.", "phi": ABOUT_PHI, "kappa": ABOUT_KAPPA},
    through=[cos_sin(c_om, s_om, omega), *PHI_KAPPA],
    derived=turn_omega(c_om, s_om) * turn_phi(c_phi, s_phi) * turn_kappa(c_kappa, s_kappa),
    claims=["2.1.1", "2.1/orthogonal#right"],
    example={"omega": "-0.0135", "phi": "0.28", "kappa": "-0.003"},
)
section.kernel(
    "metric.correlation_matrix",
    "Matrix of correlation C = R'^T B R'' of two oriented images.",
    arguments={**orientations["arguments"], "b": b},
    describe={
        **orientations["describe"],
        "b": about_base + "  It is (1, 0, 0) for the rotational relative orientation.",
    },
    derived=correlation(R_left, R_right, b),
    claims=["1.2/B", "1.2.3", "1.2.4"],
    example={
        "R_left": (("0.96", "0", "-0.28"), ("0", "1", "0"), ("0.28", "0", "0.96")),
        "R_right": (("0.8", "0", "0.6"), ("0", "1", "0"), ("-0.6", "0", "0.8")),
        "b": ("1", "0", "0"),
    },
)
