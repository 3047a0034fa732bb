# %% [markdown]
# # 2.4 Relative orientation: functions
#
# The formulas of the section as functions.

# %%
from itertools import product

import sympy

from algebroproj_derivations.cameras import PLACES, Ray, wedge
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import M_star
from algebroproj_derivations.fundamentals1996.s2_4_relative_orientation import (
    COMPLETED,
    D,
    axis_point,
    epipole,
    mu_left,
    mu_right,
    u00,
    u01,
    u02,
    ya0,
    ya1,
    ya2,
    ya3,
)
from algebroproj_sym import Section
from algebroproj_sym.declaring import let
from algebroproj_sym.expressions import Matrix, columns, determinant, over, vector

section = Section("fundamentals1996", "2.4", "Relative orientation: functions")

# %% [markdown]
# ## Forms
#
# In $y_{00} y_{Aj} - y_{0j} y_{A0}$ the product $y_{0j} y_{Aj}$ cancels and is left out.  The right bundle takes
# $\mu''_3$ from the second of its two equations.

# %%
N1, N2, P02, P03, P13, P23 = sympy.symbols("n1 n2 p02 p03 p13 p23")
ABOUT_AXIS = "Point (yA1, yA2, yA3) assumed on the epipolar axis, in affine coordinates; dimensionless."
of_image = {"epipole": epipole, "u3": fourth_image}
ABOUT_EPIPOLE = "Epipole (u01, u02) of the image, in affine coordinates; dimensionless."

section.kernel(
    "orientation.left_bundle",
    "Projective parameters of the left bundle, with mu1 = mu2.",
    arguments={"y_a": axis_point, **of_image},
    describe={"y_a": ABOUT_AXIS, "epipole": ABOUT_EPIPOLE, "u3": ABOUT_U3},
    derived=mu_left,
    form=vector(
        ya0 * (u01 * u32 - u02 * u31) / D,
        ya0 * (u01 * u32 - u02 * u31) / D,
        ya0 * (ya1 * u02 - ya2 * u01) / (ya3 * D),
    ),
    where={
        ya0: COMPLETED[ya0],
        N1: u01 * (1 - u32) - u31 * (1 - u02),
        N2: u02 * (1 - u31) - u32 * (1 - u01),
        D: ya2 * N1 - ya1 * N2,
    },
    claims=["2.4/2.3.2#mu2", "2.4/2.3.2#mu3"],
    example={
        "y_a": ("-1.0", "0.5", "3.5"),
        "epipole": ("1.6474603", "-12.5642098"),
        "u3": ("0.2718578", "0.0577379"),
    },
)
section.kernel(
    "orientation.right_bundle",
    "Projective parameters of the right bundle, from the axis and the left center.",
    arguments={"y_a": axis_point, "y0_left": center, **of_image},
    describe={
        "y_a": ABOUT_AXIS,
        "y0_left": "Left center of projection (y01, y02, y03) in affine coordinates; dimensionless.",
        "epipole": ABOUT_EPIPOLE,
        "u3": ABOUT_U3,
    },
    derived=mu_right,
    form=vector(P03 * u01 / (P13 * u00), P03 * u02 / (P23 * u00), P02 * u02 / (P23 * N2)),
    where={
        u00: COMPLETED[u00],
        N2: u02 * (1 - u31) - u32 * (1 - u01),
        P02: (1 - y01 - y03) * ya2 - y02 * (1 - ya1 - ya3),
        P03: (1 - y01 - y02) * ya3 - y03 * (1 - ya1 - ya2),
        P13: y01 * ya3 - y03 * ya1,
        P23: y02 * ya3 - y03 * ya2,
    },
    claims=["2.4/mu3#2", "2.4/mu1(yA)", "2.4/mu1(y0)", "2.4/mu2(yA)", "2.4/mu2(y0)", "2.4/beyond/right-bundle"],
    example={
        "y_a": ("-1.0", "0.5", "3.5"),
        "y0_left": ("-1.0679613", "-0.2268166", "4.1115155"),
        "epipole": ("1.6170618", "-12.0027987"),
        "u3": ("0.3094497", "-0.2327183"),
    },
)

# %% [markdown]
# ## Intersection of homologous rays
#
# The oriented bundles give the model.  (1.3.1) is linear in the object point: an image point gives two equations
# $u_i\,\mathbf m_0^T \mathbf y = \mathbf m_i^T \mathbf y$, two images give four equations
# $\mathbf A \mathbf y = \mathbf b$ for three coordinates.  The solution that treats all four alike minimises the sum of
# squares of what is left of them: $\mathbf A^T \mathbf A \mathbf y = \mathbf A^T \mathbf b$.  By the theorem of Cauchy
# and Binet it is the mean of the four solutions that omit one equation each, weighted with the squares of their
# determinants.

# %%
augmented = Matrix(4, 4, sympy.symbols("a:4:4"))
four_equations, right_sides = augmented[:, :3], augmented[:, 3]
minors_of_four = Matrix(4, 4, sympy.symbols("d:4:4"))
totals = sympy.symbols("s:4")
object_point = vector(y1, y2, y3)

squares = sympy.Add(*(total**2 for total in totals))
mean = vector(*(over(sympy.Add(*(totals[i] * minors_of_four[i, j] for i in range(4))), squares) for j in range(1, 4)))


def minor(row_omitted: int, unknown: int) -> sympy.Expr:
    """Return the determinant of three equations, the right side in place of an unknown; for 3, without it."""
    places = [3 if column == unknown else column for column in range(3)]
    return determinant(augmented.extract([row for row in range(4) if row != row_omitted], places))


MINORS = {minors_of_four[i, j + 1]: minor(i, j) for i, j in product(range(4), range(3))}
MINORS |= {total: minor(i, 3) for i, total in enumerate(totals)}
section.identity(
    "2.4/beyond/intersection",
    "the weighted mean satisfies the normal equations",
    printed=four_equations.T * (four_equations * mean - right_sides),
    where=MINORS,
    derived=vector(0, 0, 0),
)
section.identity(
    "2.4/beyond/intersection#exact",
    "four consistent equations have their common point as solution",
    printed=mean.xreplace(MINORS).xreplace(dict(zip(right_sides, four_equations * object_point, strict=True))),
    derived=object_point,
)

# %% [markdown]
# With $y_0 = 1 - y_1 - y_2 - y_3$ an equation is $b_0 y_0 + b_1 y_1 + b_2 y_2 + b_3 y_3 = 0$: its coefficients are
# $b_j - b_0$, its right side is $-b_0$.  The minors are then the barycentric coordinates of the point where three
# planes meet, and their sum.  Each has both planes of one image: the minors of these are the Plücker coordinates of its
# ray.

# %%
planes = Matrix(4, 4, sympy.symbols("b:4:4"))
AFFINE = {augmented[i, j]: planes[i, j + 1] - planes[i, 0] for i, j in product(range(4), range(3))}
AFFINE |= {augmented[i, 3]: -planes[i, 0] for i in range(4)}
LEFT_RAY, RIGHT_RAY = wedge(planes.row(0), planes.row(1)), wedge(planes.row(2), planes.row(3))
partner = {0: (1, RIGHT_RAY), 1: (0, RIGHT_RAY), 2: (3, LEFT_RAY), 3: (2, LEFT_RAY)}


def meeting_point(plane: Matrix, ray: Ray) -> list[sympy.Expr]:
    """Return the barycentric coordinates of the point where a ray meets a plane, not divided by their sum."""
    others = [sorted({*range(4)} - {k}) for k in range(4)]
    return [
        (-1) ** k * (plane[h] * ray[i, j] - plane[i] * ray[h, j] + plane[j] * ray[h, i])
        for k, (h, i, j) in enumerate(others)
    ]


def with_sum(point: list[sympy.Expr]) -> list[sympy.Expr]:
    return [*point[1:], sympy.Add(*point)]


section.identity(
    "2.4/beyond/intersection#rays",
    "the minors are the coordinates of points where a ray of one image meets a plane of the other",
    printed=Matrix([with_sum(meeting_point(planes.row(partner[i][0]), partner[i][1])) for i in range(4)]),
    derived=Matrix(4, 4, minor).xreplace(AFFINE),
)

# %% [markdown]
# In these coordinates a camera has the rows $\mathbf m_0 = (1, \mu_1, \mu_2, \mu_3)$, $\mathbf m_1 = (0, \mu_1, 0,
# \mu_3 u_{31})$ and $\mathbf m_2 = (0, 0, \mu_2, \mu_3 u_{32})$, without a difference.  A plane is
# $u_i \mathbf m_0 - \mathbf m_i$.  In the ray nearly everything cancels.  What remains is written down, so that small
# coordinates keep their digits beside the 1.


# %%
def image_symbols(primes: str) -> dict[str, Matrix]:
    names = {"u": f"u{primes}(1:3)", "mu": f"mu{primes}(1:4)", "u3": f"u{primes}3(1:3)"}
    return {key: vector(*sympy.symbols(name)) for key, name in names.items()}


def planes_of(image: dict[str, Matrix]) -> list[Matrix]:
    """Return the two equations of an image point in barycentric coordinates."""
    own = dict(zip((*mu, *fourth_image), (*image["mu"], *image["u3"]), strict=True))
    camera = M_star[:3, :].xreplace(own)
    m = columns(camera[:, 0], *(camera[:, j] + camera[:, 0] for j in range(1, 4)))
    return [image["u"][i] * m.row(0) - m.row(i + 1) for i in range(2)]


def factored_planes(image: dict[str, Matrix]) -> list[Matrix]:
    (first, second), weights, (u31, u32) = image["u"], image["mu"], image["u3"]
    return [
        vector(first, weights[0] * (first - 1), weights[1] * first, weights[2] * (first - u31)),
        vector(second, weights[0] * second, weights[1] * (second - 1), weights[2] * (second - u32)),
    ]


def factored_ray(image: dict[str, Matrix]) -> Ray:
    (first, second), (weight1, weight2, weight3), (u31, u32) = image["u"], image["mu"], image["u3"]
    turned = second * u31 - first * u32
    return {
        (0, 1): weight1 * second,
        (0, 2): -weight2 * first,
        (0, 3): weight3 * turned,
        (1, 2): weight1 * weight2 * (1 - first - second),
        (1, 3): weight1 * weight3 * (u32 - second + turned),
        (2, 3): weight2 * weight3 * (first - u31 + turned),
    }


image_left, image_right = image_symbols("p"), image_symbols("pp")
ray_left, ray_right = (dict(zip(PLACES, sympy.symbols(f"{name}(:6)"), strict=True)) for name in ("rp", "rpp"))
rays, factored_rays, points, factored_points = {}, {}, {}, {}
for image, ray, other, first in ((image_left, ray_left, ray_right, 0), (image_right, ray_right, ray_left, 2)):
    own_wedge, own_factored = wedge(*planes_of(image)), factored_ray(image)
    rays |= {symbol: own_wedge[place] for place, symbol in ray.items()}
    factored_rays |= {symbol: own_factored[place] for place, symbol in ray.items()}
    for i in range(2):
        names = minors_of_four.row(first + 1 - i)
        points |= dict(zip(names, meeting_point(planes_of(image)[i], other), strict=True))
        factored_points |= dict(zip(names, meeting_point(factored_planes(image)[i], other), strict=True))
sums = {total: sympy.Add(*minors_of_four.row(i)) for i, total in enumerate(totals)}
section.kernel(
    "orientation.intersect",
    "Object point of two homologous image points: least squares of the four equations of its images.",
    arguments={
        "u_left": image_left["u"],
        "u_right": image_right["u"],
        "mu_left": image_left["mu"],
        "u3_left": image_left["u3"],
        "mu_right": image_right["mu"],
        "u3_right": image_right["u3"],
    },
    describe={
        "u_left": "Left image point (u1', u2') in affine coordinates; dimensionless.",
        "u_right": "Right image point (u1'', u2'') in affine coordinates; dimensionless.",
        "mu_left": f"Left image: {ABOUT_MU}",
        "u3_left": f"Left image: {ABOUT_U3}",
        "mu_right": f"Right image: {ABOUT_MU}",
        "u3_right": f"Right image: {ABOUT_U3}",
    },
    through=[let(rays, form=factored_rays), let(points, form=factored_points), let(sums)],
    derived=mean,
    claims=["1.3.1", "2.4/beyond/intersection", "2.4/beyond/intersection#rays", "2.4/beyond/intersection#exact"],
    example={
        "u_left": ("0.625", "0.125"),
        "u_right": ("0.65", "0.1"),
        "mu_left": ("0.625", "0.75", "0.5"),
        "u3_left": ("0.25", "0.125"),
        "mu_right": ("0.75", "0.625", "0.875"),
        "u3_right": ("0.3125", "-0.25"),
    },
    normwise=True,
)
