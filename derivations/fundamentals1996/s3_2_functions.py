# %% [markdown]
# # 3.2 Functions
#
# (3.2.7) gives $u'_{N32}$ for the choice $u'_{N31} = u'_{31}$, (3.2.8) the fourth point of the right image, (3.2.9) the
# factor $z_N$.  In $y_{00} y_{Aj} - y_{0j} y_{A0}$ the product $y_{0j} y_{Aj}$ cancels and is left out.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s3_2_normal_case import (
    center_left,
    center_right,
    coefficients,
    condition,
    left_fourth,
    y_a,
    ya1,
    ya2,
    ya3,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import over, vector

section = Section("fundamentals1996", "3.2", "The normal case: functions")

# %%
constant, first, second = coefficients(condition(y_a, center_left, left_fourth), left_fourth)
left_of_choice = vector(u31, -over(constant + first * u31, second))
CHOICE = dict(zip(left_fourth, left_of_choice, strict=True))
z_of_centers = over(
    -left_fourth[0] * center_left[1] * (y_a[0] * center_left[2] - center_left[0] * y_a[2]),
    left_fourth[1] * center_left[0] * (y_a[1] * center_left[2] - center_left[1] * y_a[2]),
)
right_of_left = vector(
    *(over(center_right[j] * center_left[2] * left_fourth[j], center_left[j] * center_right[2]) for j in (0, 1))
)
P01, P02, P03, A13, A23 = sympy.symbols("p01 p02 p03 a13 a23")
un32_left, numerator, quotient = sympy.symbols("uN32 numerator quotient")
yp01, yp02, yp03 = center_left
ypp01, ypp02, ypp03 = center_right
section.kernel(
    "normal_case.from_orientation",
    "Factor z_N and fourth image points of the normal case, with uN31 = u31 in the left image.",
    arguments={"y_a": y_a, "y0_left": center_left, "y0_right": center_right, "u3_left": fourth_image},
    describe={
        "y_a": "Point (yA1, yA2, yA3) of the epipolar axis other than the left center, in affine coordinates; "
        "dimensionless.",
        "y0_left": "Left center of projection in affine coordinates; dimensionless.",
        "y0_right": "Right center of projection in affine coordinates; dimensionless.",
        "u3_left": f"Left image: {ABOUT_U3}",
    },
    derived={
        "z_N": z_of_centers.xreplace(CHOICE),
        "u3_normal_left": left_of_choice,
        "u3_normal_right": right_of_left.xreplace(CHOICE),
    },
    form={
        "z_N": -u31 * yp03 * P02 * A13 / (numerator * A23),
        "u3_normal_left": vector(u31, un32_left),
        "u3_normal_right": vector(u31 * ypp01 * quotient / yp01, un32_left * ypp02 * quotient / yp02),
    },
    where={
        P01: (1 - yp02 - yp03) * ya1 - yp01 * (1 - ya2 - ya3),
        P02: (1 - yp01 - yp03) * ya2 - yp02 * (1 - ya1 - ya3),
        P03: (1 - yp01 - yp02) * ya3 - yp03 * (1 - ya1 - ya2),
        A13: ya1 * yp03 - yp01 * ya3,
        A23: ya2 * yp03 - yp02 * ya3,
        numerator: yp01 * P03 - yp03 * P01 * u31,
        un32_left: yp02 * numerator / (yp01 * yp03 * P02),
        quotient: yp03 / ypp03,
    },
    claims=["3.2.7", "3.2.8", "3.2.9"],
    example={
        "y_a": ("-0.9009221", "0.8325803", "3.7908794"),
        "y0_left": ("-0.8871075", "-0.2253355", "4.2692516"),
        "y0_right": ("-0.9009221", "0.8325803", "3.7908794"),
        "u3_left": ("0.2718578", "0.0577379"),
    },
)
