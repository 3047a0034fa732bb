# %% [markdown]
# # 2.1 Functions
#
# # Cosine and sine of each angle are given; the rest is products.

# %%
import sympy

from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_sym import Section
from algebroproj_sym.declaring import cos_sin

section = Section("normalcase1992", "2.1", "The rotational relative orientation: functions")

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
