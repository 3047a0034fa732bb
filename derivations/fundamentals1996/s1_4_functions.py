# %% [markdown]
# # 1.4 Functions
#
# Coordinates are differences first, then ratios of determinants that share their minors.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.s1_4_orthonormalized_systems import (
    EXAMPLE_IMAGE,
    G,
    X,
    coordinates,
    frame,
    g,
    v,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, cross, dot, over, vector

section = Section("fundamentals1996", "1.4", "Connection with orthonormalized systems: functions")

# %%
ABOUT_PLANE = "Image points G'0, G'1, G'2, a row each, in any affine coordinates; any unit."
ABOUT_SPACE = "Object points G0, G1, G2, G3, a row each, in any affine coordinates; any unit."


def differences(names: str, point: Matrix, origin: Matrix) -> dict[sympy.Symbol, sympy.Expr]:
    return dict(zip(sympy.symbols(names), point - origin, strict=True))


det = sympy.Symbol("det")
object_example = (
    ("292.50", "202.50", "120.00"),
    ("577.50", "2295.00", "91.50"),
    ("1537.50", "480.00", "772.50"),
    ("435.00", "900.00", "990.00"),
)

section.kernel(
    "affine.plane_frame",
    "Matrix A_v that takes affine image coordinates (1, u) to image coordinates (1, v).",
    arguments={"g": g},
    derived=frame(g),
    claims=["1.4.1#A_v", "1.4/v"],
    example={"g": EXAMPLE_IMAGE},
    describe={"g": ABOUT_PLANE},
)

g0, g1, g2 = (g.row(n).T for n in range(3))
d1, d2, c11, c12, c21, c22 = sympy.symbols("d1 d2 c11 c12 c21 c22")
section.kernel(
    "affine.plane_coordinates",
    "Affine image coordinates u of an image point, referred to three basic points.",
    arguments={"v": v, "g": g},
    derived=coordinates(v, g),
    claims=["1.4/plane-coordinates", "1.4/uncalibrated"],
    normwise=True,
    example={"v": ("0.0313810", "-0.2265744"), "g": EXAMPLE_IMAGE},
    describe={
        "v": "Coordinates of an image point, in the system of g; same unit.",
        "g": ABOUT_PLANE,
    },
    form=vector(over(d1 * c22 - d2 * c21, det), over(c11 * d2 - c12 * d1, det)),
    where=differences("d1 d2", v, g0)
    | differences("c11 c12", g1, g0)
    | differences("c21 c22", g2, g0)
    | {det: c11 * c22 - c12 * c21},
)
section.kernel(
    "affine.space_frame",
    "Matrix A_X that takes affine coordinates (1, y) to object coordinates (1, X).",
    arguments={"g": G},
    derived=frame(G),
    claims=["1.4.4", "1.4/A_X"],
    example={"g": object_example},
    describe={"g": ABOUT_SPACE},
)

G0, G1, G2, G3 = (G.row(n).T for n in range(4))
d = vector(*sympy.symbols("d1 d2 d3"))
a1, a2, a3 = (vector(*sympy.symbols(f"a{n}1 a{n}2 a{n}3")) for n in (1, 2, 3))
m, n = (vector(*sympy.symbols(names)) for names in ("m1 m2 m3", "n1 n2 n3"))
section.kernel(
    "affine.space_coordinates",
    "Affine coordinates y of an object point, referred to four basic points.",
    arguments={"x": X, "g": G},
    derived=coordinates(X, G),
    claims=["1.4.3"],
    normwise=True,
    example={"x": ("660.00", "1537.50", "312.00"), "g": object_example},
    describe={
        "x": "Coordinates of an object point, in the system of g; same unit.",
        "g": ABOUT_SPACE,
    },
    form=vector(over(dot(d, m), det), over(-dot(a3, n), det), over(dot(a2, n), det)),
    where=differences("d1 d2 d3", X, G0)
    | differences("a11 a12 a13", G1, G0)
    | differences("a21 a22 a23", G2, G0)
    | differences("a31 a32 a33", G3, G0)
    | dict(zip(m, cross(a2, a3), strict=True))
    | dict(zip(n, cross(d, a1), strict=True))
    | {det: dot(a1, m)},
)
