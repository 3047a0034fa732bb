# %% [markdown]
# # 3 Functions
#
# The determinant of a pencil, the discriminant of a cubic form, and the photographs of a condition as functions.
# Drivers find all roots with them.

# %%
import sympy

from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s3_unique_determination import (
    canonical,
    cubic,
    cubic_of,
    depth_of,
    discriminant_of,
    epipole,
    hessian_of,
    model_of,
    pencil_a,
    pencil_b,
    terms_of_depth,
)
from algebroproj_derivations.solvers import orientations, seven_pairs
from algebroproj_sym import Section
from algebroproj_sym.declaring import let, solution
from algebroproj_sym.expressions import Matrix, adjugate, vector

section = Section("okamoto1981", "3", "Unique determination, general case: functions")

# %% [markdown]
# ## Roots

# %%
section.kernel(
    "minimal.cubic",
    "Coefficients of s^3, s^2 t, s t^2, t^3 in the determinant of s A + t B.",
    arguments={"A": pencil_a, "B": pencil_b},
    describe={"A": "Any matrix.", "B": "Any matrix."},
    derived=cubic_of(pencil_a, pencil_b),
    claims=["3/beyond/cubic"],
    example={
        "A": (("-2", "0", "1"), ("1", "-2", "-2"), ("0", "-4", "-3")),
        "B": (("2", "2", "0"), ("-2", "0", "2"), ("1", "2", "1")),
    },
)
section.kernel(
    "minimal.discriminant",
    "Discriminant of a cubic form: positive for three real roots, negative for one, zero for a multiple one.",
    arguments={"c": cubic},
    describe={"c": "Coefficients of s^3, s^2 t, s t^2, t^3."},
    derived=discriminant_of(cubic),
    claims=["3/beyond/discriminant", "3/beyond/discriminant#one-root"],
    example={"c": ("1", "-2", "-5", "6")},
)

section.kernel(
    "minimal.hessian",
    "Coefficients of s^2, s t, t^2 in the Hessian of a cubic form, but for a factor: it has a double root of the form.",
    arguments={"c": cubic},
    describe={"c": "Coefficients of s^3, s^2 t, s t^2, t^3."},
    derived=hessian_of(cubic),
    claims=["3/beyond/hessian", "3/beyond/hessian#double-root"],
    example={"c": ("1", "-2", "-5", "6")},
)

# %% [markdown]
# ## Photographs
#
# A collineation takes the five control points to the five model points.  Choose coordinates in both spaces so that the
# five points are the unit points and $(1, 1, 1, 1)$.  Then its matrix is the unit matrix.  The scales of these
# coordinates are solutions of two linear systems.

# %%
F_given = Matrix(3, 3, sympy.symbols("f:3:3"))
image_left, image_right = vector(*sympy.symbols("xp yp")), vector(*sympy.symbols("xpp ypp"))
homologous = vector(*image_left, 1), vector(*image_right, 1)
right_of_model, _ = model_of(F_given, epipole, [])
of_depth = sympy.symbols("p:3"), sympy.symbols("q:3")
with_condition = {
    "F": "Matrix of the condition of coplanarity, u'^T F u'' = 0 for homologous points (x, y, 1), up to a factor.",
    "epipole": "Null vector of F, up to a factor: the right image of the left center.",
}
EXAMPLE_F = (("-2", "0", "1"), ("1", "-2", "-2"), ("0", "-4", "-3"))
EXAMPLE_EPIPOLE = ("2", "-3", "4")
section.kernel(
    "minimal.model_depth",
    "Fourth coordinate of a model point (x', y', 1, depth), whose left photograph is [1 0].",
    arguments={"F": F_given, "epipole": epipole, "x_left": image_left, "x_right": image_right},
    describe=with_condition
    | {
        "x_left": "Left image point (x', y'); any unit of length.",
        "x_right": "Homologous right image point (x'', y''); any unit of length.",
    },
    through=[
        let(dict(zip(symbols, values, strict=True)))
        for symbols, values in zip(of_depth, terms_of_depth(right_of_model, *homologous), strict=True)
    ],
    derived=depth_of(*map(Matrix, of_depth)),
    claims=["3/beyond/model"],
    example={"F": EXAMPLE_F, "epipole": EXAMPLE_EPIPOLE, "x_left": ("1", "2"), "x_right": ("2", "-0.75")},
)

five_from, five_to = (Matrix(5, 4, sympy.symbols(f"{name}(1:6)(:4)")) for name in ("X", "Y"))
of_from, of_to = (vector(*sympy.symbols(f"{name}:4")) for name in ("m", "n"))
from_columns, to_columns = five_from.T, five_to.T
scales = Matrix.diag(*(n / m for m, n in zip(of_from, of_to, strict=True)))
section.kernel(
    "minimal.collineation",
    "Matrix of the collineation of space that takes five points to five points, up to a factor.",
    arguments={"X": five_from, "Y": five_to},
    describe={
        "X": "Five homogeneous points, no four of them in a plane.",
        "Y": "The five points that they are taken to, no four of them in a plane.",
    },
    through=[
        solution(list(of_from), from_columns[:, :4], from_columns[:, 4]),
        solution(list(of_to), to_columns[:, :4], to_columns[:, 4]),
    ],
    derived=to_columns[:, :4] * scales * adjugate(from_columns[:, :4]),
    claims=["3/beyond/collineation"],
    example={
        "X": (
            ("0", "0", "0", "1"),
            ("1", "0", "0", "1"),
            ("0", "1", "0", "1"),
            ("0", "0", "1", "1"),
            ("1", "2", "3", "1"),
        ),
        "Y": (
            ("-3", "-3", "1", "2"),
            ("3", "3", "1", "1"),
            ("1", "2", "1", "-2"),
            ("-3", "0", "1", "1"),
            ("4", "-1", "1", "3"),
        ),
    },
    normwise=True,
)

H = Matrix(4, 4, sympy.symbols("h:4:4"))
section.kernel(
    "minimal.photographs",
    "Coefficients of both photographs that satisfy a condition of coplanarity, from the collineation of their model.",
    arguments={"F": F_given, "epipole": epipole, "H": H},
    describe=with_condition | {"H": "Matrix that takes homogeneous object points to model points, up to a factor."},
    derived={name: coefficients_of(matrix * H) for name, matrix in (("left", canonical), ("right", right_of_model))},
    claims=["3/beyond/model", "3/beyond/three-solutions"],
    example={
        "F": EXAMPLE_F,
        "epipole": EXAMPLE_EPIPOLE,
        "H": (("1", "0", "2", "1"), ("0", "1", "1", "-1"), ("1", "1", "1", "3"), ("2", "0", "0", "1")),
    },
)
section.driver("minimal.seven_pairs", seven_pairs)
section.driver("minimal.orientations", orientations)
