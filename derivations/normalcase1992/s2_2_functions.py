# %% [markdown]
# # 2.2 Functions
#
# # The five angles from the adjugate $\mathbf A$ of any multiple of $\mathbf C$, with $\cos\kappa'$, $\cos\varphi'$,
# $\cos\Omega''$ and $\cos\varphi''$ positive and $\kappa''$ anywhere.

# %%
import sympy

from algebroproj_derivations.inserting import given
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.declaring import arctan2, cos_sin, let
from algebroproj_sym.expressions import Matrix, adjugate, vector

section = Section("normalcase1992", "2.2", "Computation of the parameters: functions")

# %%
C_symbols = Matrix(3, 3, lambda row, column: sympy.Symbol(f"c{row + 1}{column + 1}"))
A_symbols = Matrix(3, 3, lambda row, column: sympy.Symbol(f"a{row + 1}{column + 1}"))
axis_left, axis_right = vector(*sympy.symbols("u1p u2p u3p")), vector(*sympy.symbols("u1pp u2pp u3pp"))
phi_left, kappa_left, tilt, phi_right, kappa_right = sympy.symbols("phip kappap omegapp phipp kappapp")
TIP, SWING, RIGHT_SWING = (sympy.symbols(f"c_{angle} s_{angle}") for angle in ("phip", "kappap", "kappapp"))
turned = turn_phi(*TIP) * turn_kappa(*SWING) * C_symbols


def named(symbols: Matrix, values: Matrix):
    return let(given(symbols, values))


def tip_of(axis: Matrix, cosine: sympy.Symbol, sine: sympy.Symbol) -> tuple[sympy.Expr, sympy.Expr]:
    """Return sine and cosine of the tip, times the length of the vector along the base."""
    return axis[2], axis[0] * cosine - axis[1] * sine


section.kernel(
    "metric.rotations_from_correlation",
    "Tip and swing of the left image, tilt, tip and swing of the right image from the matrix of correlation.",
    arguments={"C": C_symbols, "c": c},
    describe={
        "C": "Matrix of correlation R'^T B R'' of image vectors (x, y, -c), up to any factor.",
        "c": "Principal distance c of the image vectors to which C refers, in their unit.  The angles do not depend on "
        "it.",
    },
    through=[
        named(A_symbols, adjugate(C_symbols)),
        named(axis_left, A_symbols.T * A_symbols.col(0)),
        named(axis_right, A_symbols * axis_left),
        arctan2(kappa_left, -axis_left[1], axis_left[0]),
        cos_sin(*SWING, kappa_left),
        arctan2(phi_left, *tip_of(axis_left, *SWING)),
        cos_sin(*TIP, phi_left),
        arctan2(kappa_right, -axis_right[1], axis_right[0]),
        cos_sin(*RIGHT_SWING, kappa_right),
        arctan2(phi_right, *tip_of(axis_right, *RIGHT_SWING)),
        arctan2(tilt, turned[2, 2] * turned[1, 2], turned[1, 2] ** 2),
    ],
    derived={
        "phi_left": phi_left,
        "kappa_left": kappa_left,
        "omega_right": tilt,
        "phi_right": phi_right,
        "kappa_right": kappa_right,
    },
    claims=[
        "1.2/beyond/adjugate",
        "1.2/beyond/cofactors",
        "2.2/base#left",
        "2.2/base#right",
        "2.2/beyond/epipoles",
        "2.2/beyond/tilt",
        "2.2/beyond/opposite",
        "2.2/beyond/half-turn",
    ],
    example={
        "C": (("-0.004", "0.266", "0.011"), ("0.285", "0.017", "-0.995"), ("-0.007", "1", "0.013")),
        "c": "51.18",
    },
    normwise=True,
)
