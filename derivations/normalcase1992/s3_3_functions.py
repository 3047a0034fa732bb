# %% [markdown]
# # 3.3 Functions
#
# # Dispersions of the normal case coordinates, those of the left image, of the right image and between them.

# %%
from sympy import BlockMatrix, MatrixSymbol

from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_derivations.normalcase1992.s3_3_reconstruction import parallax, point
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, columns, diff, vector

section = Section("normalcase1992", "3.3", "Propagation of errors concerning reconstruction: functions")

# %%
S_left, S_right, S_mixed = (MatrixSymbol(name, 2, 2) for name in ("S_left", "S_right", "S_mixed"))
dispersion = BlockMatrix([[S_left, S_mixed], [S_mixed.T, S_right]])
jacobian = columns(*(diff(point, coordinate) for coordinate in (xp, yp, xpp, ypp)))
numerators = Matrix([[-xpp, 0, xp, 0], [-yp, parallax, yp, 0], [c, 0, -c, 0]])
section.kernel(
    "metric.model_covariance",
    "Dispersion of a model point from those of its homologous points of the normal case.",
    arguments={
        "x_left": vector(xp, yp),
        "x_right": vector(xpp, ypp),
        "c": c,
        "S_left": S_left,
        "S_right": S_right,
        "S_mixed": S_mixed,
    },
    describe={
        "x_left": "Left image point (x', y') of the normal case, in the unit of c.",
        "x_right": "Right image point (x'', y'') of the normal case, in the unit of c; y'' = y' is not used.",
        "c": ABOUT_C,
        "S_left": "Dispersion of (x', y'), in the square of the unit of c.",
        "S_right": "Dispersion of (x'', y''), in the square of the unit of c; only the variance of x'' is used.",
        "S_mixed": "Covariances of (x', y'), rows, with (x'', y''), columns, in the square of the unit of c; "
        "only those with x'' are used.",
    },
    properties={S_left: "symmetric", S_right: "symmetric"},
    derived=jacobian * dispersion * jacobian.T,
    form=numerators * dispersion * numerators.T / parallax**4,
    where={parallax: xp - xpp},
    claims=["3.3/S_M", "3.3.1", "3.3.2"],
    example={
        "x_left": ("12.5", "-3.25"),
        "x_right": ("-7.5", "-3.25"),
        "c": "50",
        "S_left": (("0.00004", "0.00001"), ("0.00001", "0.00003")),
        "S_right": (("0.00005", "0.00001"), ("0.00001", "0.00003")),
        "S_mixed": (("0.00001", "0"), ("0", "0.00001")),
    },
)
