# %% [markdown]
# # 2.3 Functions
#
# # The row of one point; the right side is its parallax $\delta p$.

# %%
from algebroproj_derivations.drivers import adjust
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_derivations.normalcase1992.s2_3_adjustment import (
    IN_IMAGES,
    NAMES,
    coefficients_of_projectors,
    first_order,
    unknowns,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import diff, vector

section = Section("normalcase1992", "2.3", "Adjustment: functions")

# %%
coefficients_of_rotations = vector(*(-diff(first_order, unknown) for unknown in unknowns))
section.kernel(
    "metric.coplanarity_row",
    "Coefficients of the small rotations (dphi', dkappa', dOmega'', dphi'', dkappa'') in the equation of coplanarity.",
    arguments={
        "x_left": vector(xp, yp),
        "x_right": vector(xpp, ypp),
        "R_left": R_left,
        "R_right": R_right,
        "c": c,
    },
    describe={
        "x_left": "Left image point (x', y'), centered at the principal point, in the unit of c.",
        "x_right": "Homologous right image point (x'', y''), centered at the principal point, in the unit of c.",
        "R_left": ABOUT_R_LEFT,
        "R_right": ABOUT_R_RIGHT,
        "c": ABOUT_C + "  The coefficients, for rotations in radians, have the square of this unit.",
    },
    derived=coefficients_of_rotations,
    form=coefficients_of_projectors,
    where=IN_IMAGES,
    claims=[*(f"2.3/linear#{name}" for name in NAMES.values()), "2.3/beyond/finite"],
    example={
        "x_left": ("-10.62", "1.694"),
        "x_right": ("-1.851", "2.316"),
        "R_left": (("0.96", "0", "-0.28"), ("0", "1", "0"), ("0.28", "0", "0.96")),
        "R_right": (("0.96", "0", "0.28"), ("0", "1", "0"), ("-0.28", "0", "0.96")),
        "c": "51.18",
    },
)
section.driver("metric.adjust", adjust)
