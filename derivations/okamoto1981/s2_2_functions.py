# %% [markdown]
# # 2.2 Functions
#
# The model point and the similarity transformation as functions.

# %%
from itertools import chain

import sympy
from sympy import cos, sin

from algebroproj_derivations.inserting import given
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s2_1_algebraic_consideration import model
from algebroproj_derivations.okamoto1981.s2_2_geometrical_consideration import (
    B,
    Kappa,
    Omega,
    Phi,
    length1,
    length2,
    m,
    model_point_of_reduced,
    object_of_model,
    reconstructed,
    reduced_left,
    reduced_right,
)
from algebroproj_sym import Section
from algebroproj_sym.declaring import cos_sin
from algebroproj_sym.expressions import vector

section = Section("okamoto1981", "2.2", "General orientation problem, geometrical consideration: functions")

# %%
base_length = sympy.Symbol("base")
cosines_and_sines = {angle: sympy.symbols(f"c_{angle} s_{angle}") for angle in (Phi, Omega, Kappa)}
in_letters = given(
    (function(angle) for angle in cosines_and_sines for function in (cos, sin)), chain(*cosines_and_sines.values())
)
section.kernel(
    "collinearity.model_point",
    "Model point on the left ray, from reduced transformed picture coordinates.",
    arguments={"reduced_left": reduced_left, "reduced_right": reduced_right, "base": base_length},
    derived=model_point_of_reduced.xreplace({length1: sympy.Integer(1), length2: sympy.Integer(1), B: base_length}),
    form=reconstructed.xreplace({B: base_length}),
    claims=["36", "36#directions"],
    describe={
        "reduced_left": "Left picture point, (x, y, -c) turned into the model system; any unit of length.",
        "reduced_right": "Right picture point, (x, y, -c) turned into the model system; any unit of length.",
        "base": "Model base B, on the axis XM; unit of the model.",
    },
    example={
        "reduced_left": ("21.5", "-33.25", "-150.75"),
        "reduced_right": ("-28.25", "-34.5", "-153.5"),
        "base": "60.5",
    },
)
section.kernel(
    "collinearity.similarity",
    "Object point of a model point: rotation, scale and translation.",
    arguments={
        "X_model": model,
        "angles": vector(Phi, Omega, Kappa),
        "scale": sympy.Symbol("scale"),
        "translation": center,
    },
    through=[cos_sin(*values, angle) for angle, values in cosines_and_sines.items()],
    derived=object_of_model.xreplace({m: sympy.Symbol("scale"), **in_letters}),
    claims=["38"],
    describe={
        "X_model": "Model point (XM, YM, ZM); unit of the model.",
        "angles": "Rotations (Phi, Omega, K) about Y, X and Z; radians.",
        "scale": "Scale m of (38), object over model; dimensionless if both have the same unit.",
        "translation": "Object coordinates (Xo, Yo, Zo) of the origin of the model; unit of the object.",
    },
    example={
        "X_model": ("39.25", "-60.5", "-275.75"),
        "angles": ("0.125", "-0.0625", "0.75"),
        "scale": "1.25",
        "translation": ("512.5", "-107.25", "348.75"),
    },
)
