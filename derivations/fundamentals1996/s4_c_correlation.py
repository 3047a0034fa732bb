# %% [markdown]
# # 4 Numerical example, c) to e)
#
# Correlation of the two pictures of item b), relative orientation, reconstruction of the model and its transformation
# to the object.  Every printed number is a claim of its own, compared with the one exact number that the chain gives
# *without rounding* from the object points and rotations of items a) and b).

# %%
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any

import sympy

from algebroproj_derivations.fundamentals1996.notation import center, fourth_image, mu
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import y0_of_mu
from algebroproj_derivations.fundamentals1996.s1_5_space_to_space import M_star as core
from algebroproj_derivations.fundamentals1996.s1_5_space_to_space import (
    factors,
    fifth_image,
    fifth_point,
    image,
    mu4,
    mu_of_fifth,
    point,
)
from algebroproj_derivations.fundamentals1996.s2_2_correlation import (
    D_printed,
    Z,
    determinant_of_correlation,
    epipole_left,
    epipole_right,
    printed_left,
    reduced,
    remaining,
    up1,
    up2,
    upp1,
    upp2,
)
from algebroproj_derivations.fundamentals1996.s2_4_relative_orientation import (
    axis_point,
    epipole,
    forms_of_point,
    image_coordinates,
    mu_left,
    mu_p,
    mu_pp,
    mu_right,
    u3_p,
    u3_pp,
)
from algebroproj_derivations.fundamentals1996.s4_a_coordinates import (
    BASIC,
    FULL_ROTATIONS,
    MATRICES,
    PICTURES,
    affine,
    exact,
    object_points,
    picture,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    at_point,
    columns,
    divided,
    homogeneous,
    linear_system,
    solve,
    vector,
)

section = Section("fundamentals1996", "4", "Numerical example")


def at(expressions: Matrix, *values: tuple[Iterable[sympy.Symbol], Iterable[sympy.Rational]]) -> Matrix:
    """Return the exact values of a matrix of expressions, given symbols and their values group by group."""
    pairs = (zip(symbols, numbers, strict=True) for symbols, numbers in values)
    return at_point(expressions, {symbol: value for group in pairs for symbol, value in group})


# %% [markdown]
# ## The tables, as printed

# %%
PRINTED_Z = (
    ("0.00000000", "-0.97340074", "-0.13114018"),
    ("1.00000000", "-0.02659926", "0.07973035"),
    ("0.13112327", "-0.08096187", "0.00001691"),
)
PRINTED_EPIPOLES = {"left": ("1.64746", "-12.56421"), "right": ("1.61706", "-12.00280")}
Y_A = exact("-1.0", "0.5", "3.5")
PRINTED_MU = {
    "left": ("0.6898293", "0.6898293", "0.6591033"),
    "right": ("0.7086797", "0.6897404", "0.6803561"),
}
PRINTED_CENTERS = {
    "left": ("-1.0679613", "-0.2268166", "4.1115155"),
    "right": ("-0.9762202", "0.7543148", "3.2860293"),
}

# %% [markdown]
# The relative model $\bar{\mathbf y}$ and its transformation $\mathbf y$.

# %%
MODEL = {
    "1": ("-0.0000000", "-0.0000000", "0.0000000"),
    "2": ("-0.0000000", "0.0000000", "1.0000000"),
    "3": ("0.6355543", "0.1373416", "0.1130328"),
    "4": ("1.0000000", "0.0000000", "0.0000000"),
    "5": ("-0.0000000", "1.0000000", "0.0000000"),
    "6": ("0.5455624", "0.7504735", "-0.5058402"),
    "7": ("0.7668908", "0.8542391", "-0.4772471"),
    "8": ("0.6366276", "0.5883781", "0.3465757"),
    "11": ("0.0034507", "0.0032510", "0.0271793"),
    "12": ("0.2876072", "0.0948949", "0.3835020"),
    "13": ("0.0108103", "0.5637081", "0.4309463"),
    "14": ("0.5183431", "0.6962739", "-0.1914705"),
    "15": ("0.4828822", "0.8371888", "0.0480258"),
    "16": ("0.7413441", "0.6342413", "0.0293453"),
}
TRANSFORMED = {
    "1": ("-0.0000000", "-0.0000000", "0.0000000"),
    "2": ("-0.0000000", "0.0000000", "1.0000000"),
    "3": ("0.5756072", "0.1487681", "0.1279697"),
    "4": ("1.0000000", "0.0000000", "0.0000000"),
    "5": ("-0.0000000", "1.0000000", "0.0000000"),
    "6": ("0.4912043", "0.8081410", "-0.5693249"),
    "7": ("0.7775096", "1.0358235", "-0.6048458"),
    "8": ("0.6654715", "0.7355879", "0.4528676"),
    "11": ("0.0024264", "0.0027341", "0.0238910"),
    "12": ("0.2367270", "0.0934168", "0.3945888"),
    "13": ("0.0088907", "0.5544832", "0.4430495"),
    "14": ("0.4805426", "0.7720203", "-0.2218940"),
    "15": ("0.4742924", "0.9834730", "0.0589669"),
    "16": ("0.7739665", "0.7919375", "0.0382975"),
}
PRINTED_M = (
    ("1.175435236", "-0.353003193", "-0.191800001", "-0.147350009"),
    ("0.000000000", "0.822432042", "0.000000000", "0.000000000"),
    ("0.000000000", "0.000000000", "0.983635234", "0.000000000"),
    ("0.000000000", "0.000000000", "0.000000000", "1.028085227"),
)

# %% [markdown]
# What does not follow would be a slip.  Items c) to e) have none; for those of the other items `exceptions` has the
# options of the claim.

# %%
Values = dict[str, sympy.Rational]
Exceptions = Mapping[str, Mapping[str, Any]]


def declare_cells(
    into: Section,
    number: str,
    title: str,
    cells: Mapping[str, str],
    values: Mapping[str, sympy.Rational],
    note: str = "",
    exceptions: Exceptions = MappingProxyType({}),
) -> None:
    """Declare printed numbers, part by part of one claim number, each beside its exact value."""
    for part, printed in cells.items():
        claim = f"{number}#{part}"
        options = {"note": note} | dict(exceptions.get(claim, {}))
        into.numeric(claim, f"{title}, {part}", printed=printed, derived=values[part], **options)


def named(prefix: str, numbers: Iterable[Any]) -> dict[str, Any]:
    return {f"{prefix}{index}": cell for index, cell in enumerate(numbers, start=1)}


def entries_of(prefix: str, matrix: Any) -> dict[str, Any]:
    rows = matrix.tolist() if isinstance(matrix, sympy.MatrixBase) else matrix
    return {f"{prefix}{i}{j}": cell for i, row in enumerate(rows) for j, cell in enumerate(row)}


# %% [markdown]
# ## The images
#
# Projected from the object points, with the unrounded rotations.  A second pair is projected with the rotation matrices
# as printed, to see what these can reproduce.

# %%
SIDES = ("left", "right")
Images = dict[str, dict[str, Matrix]]
Pair = dict[str, Matrix]


def numbers(printed: Iterable[Iterable[str]]) -> Matrix:
    return Matrix([[sympy.Rational(cell) for cell in row] for row in printed])


def projected(rotations: Pair) -> Images:
    pictures = {side: picture(rotations[side], center_name) for side, (_, center_name) in PICTURES.items()}
    return {side: {name: affine(points, BASIC[:3], name) for name in points} for side, points in pictures.items()}


full_u = projected(FULL_ROTATIONS)
rotation_u = projected({side: numbers(MATRICES[side]) for side in SIDES})

# %% [markdown]
# ## c. Correlation
#
# Points 1, 4, 5 are $G_0, G_1, G_2$; points 2, 3, 6, 7, 8 give the five equations (2.2.4) for the matrix (2.2.3).

# %%
FURTHER = ("2", "3", "6", "7", "8")


def correlation(images: Images) -> Matrix:
    """Return z11, z12, z20, z21, z22."""
    equations = Matrix.vstack(
        *(at(reduced, ((up1, up2, upp1, upp2), (*images["left"][name], *images["right"][name]))) for name in FURTHER)
    )
    return divided(solve(equations[:, :5], equations[:, 5]))


def correlation_matrix(elements: Matrix) -> Matrix:
    return at(Z, (remaining, elements))


def epipoles_of(elements: Matrix) -> Pair:
    return {
        "left": at(epipole_left, (remaining, elements)),
        "right": at(epipole_right, (remaining, elements)),
    }


def item_c(images: Images) -> Values:
    """Return the exact numbers of the item."""
    elements = correlation(images)
    points = epipoles_of(elements)
    return (
        entries_of("z", correlation_matrix(elements))
        | {"det": at(DETERMINANT, (remaining, elements))[0]}
        | named("left.u0", points["left"])
        | named("right.u0", points["right"])
    )


DETERMINANT = Matrix([[determinant_of_correlation]])
full_elements = correlation(full_u)
full_c = item_c(full_u)
FROM_OBJECT = (
    "The coordinates of item b) have seven decimals, the elements eight: they follow from the coordinates before "
    "rounding, projected from the object points with unrounded rotations."
)
declare_cells(section, "4/c", "matrix of correlation", entries_of("z", PRINTED_Z), full_c, FROM_OBJECT)

# %% [markdown]
# The determinant, and the epipoles (2.2.6) and (2.2.7).

# %%
declare_cells(
    section,
    "4/c",
    "determinant of the matrix of correlation",
    {"det": "0.0000000000"},
    full_c,
    "Zero without rounding, as the pictures are exactly homologous.  The elements with eight decimals leave 4e-9.",
)
full_epipoles = epipoles_of(full_elements)
for side in SIDES:
    declare_cells(
        section,
        "4/c",
        f"epipole in the {side} picture",
        named(f"{side}.u0", PRINTED_EPIPOLES[side]),
        full_c,
        exceptions={"4/c#left.u01": {"note": "Printed with a decimal comma."}},
    )
declare_cells(
    section,
    "4/c/beyond/as-printed",
    "where (2.2.6) as printed puts the epipole of the left picture",
    {"left.u01": "-1.64746", "left.u02": "12.56421"},
    named("left.u0", at(printed_left / D_printed, (remaining, full_elements))),
    "Not in the paper: its own numbers have the other signs, 4/c#left.u01 and 4/c#left.u02.",
)
Z_full = correlation_matrix(full_elements)
section.identity(
    "4/c/epipoles",
    "the epipoles solve the equations",
    printed=Matrix.zeros(3, 2),
    derived=columns(Z_full.T * homogeneous(full_epipoles["left"]), Z_full * homogeneous(full_epipoles["right"])),
    note="All three equations of each epipole, without rounding; (2.2.6) and (2.2.7) use two of them.",
)
section.identity(
    "4/c/beyond/centers",
    "the epipoles of the correlation are the images of the other centers",
    printed=columns(full_u["left"]["O2"], full_u["right"]["O1"]),
    derived=columns(full_epipoles["left"], full_epipoles["right"]),
    note="Not in the paper: the epipoles in the rows O'' and O' of item b) are the same points, there with seven "
    "decimals.",
)

# %% [markdown]
# What do the printed rotation matrices reproduce?  All elements of $\mathbf Z$ but one.

# %%
section.numeric(
    "4/c/beyond/printed-rotations",
    "the element z21 that follows from the printed rotation matrices",
    printed="-0.080961876",
    derived=correlation(rotation_u)[3],
    note="Not in the paper: rounded to eight decimals it is -0.08096188, not the printed -0.08096187.  The other "
    "elements, the determinant and the epipoles follow from the printed matrices as well, as do the numbers of the "
    "items d) to h) but for the matrix of item e), 4/e/beyond/printed-rotations, and one coordinate of item g), "
    "4/g/beyond/printed-rotations; three coordinates of item g) have their printed last digit with these matrices "
    "alone.  Item b) needs the unrounded rotations as well.",
)

# %% [markdown]
# ## d. Relative orientation
#
# $\mathbf y_A$ is any point: the choice fixes, with $\mu'_1 = \mu'_2$, the projective coordinates of the relative
# model.

# %%
section.definition("4/d/yA", "point assumed on the epipolar axis", printed=Y_A)
for side, prime in (("left", "'"), ("right", "''")):
    section.definition(f"4/d#{side}.mu0", f"normalization of the {side} bundle, mu{prime}0", printed=sympy.Integer(1))


def left_bundle(u0: Matrix, u3: Matrix) -> Matrix:
    return at(mu_left, (axis_point, Y_A), (epipole, u0), (fourth_image, u3))


def center_of(parameters: Matrix, u3: Matrix) -> Matrix:
    return at(y0_of_mu, (mu, parameters), (fourth_image, u3))


def right_bundle(left_center: Matrix, u0: Matrix, u3: Matrix) -> Matrix:
    return at(mu_right, (axis_point, Y_A), (center, left_center), (epipole, u0), (fourth_image, u3))


def fourth_points(images: Images) -> Pair:
    return {side: images[side]["2"] for side in SIDES}


def orientation(images: Images) -> tuple[Pair, Pair]:
    """Return the parameters and the centers of both bundles."""
    u0, u3 = epipoles_of(correlation(images)), fourth_points(images)
    left_mu = left_bundle(u0["left"], u3["left"])
    left_center = center_of(left_mu, u3["left"])
    right_mu = right_bundle(left_center, u0["right"], u3["right"])
    right_center = center_of(right_mu, u3["right"])
    return {"left": left_mu, "right": right_mu}, {"left": left_center, "right": right_center}


def item_d(images: Images) -> Values:
    """Return the exact numbers of the item."""
    parameters, centers = orientation(images)
    return {
        part: value
        for side in SIDES
        for part, value in (named(f"{side}.mu", parameters[side]) | named(f"{side}.y0", centers[side])).items()
    }


full_u3 = fourth_points(full_u)
full_mu, full_centers = orientation(full_u)
full_d = item_d(full_u)
for side in SIDES:
    declare_cells(
        section,
        "4/d",
        f"parameters of the {side} bundle",
        named(f"{side}.mu", PRINTED_MU[side]),
        full_d,
    )
    declare_cells(
        section,
        "4/d",
        f"center of projection of the {side} bundle",
        named(f"{side}.y0", PRINTED_CENTERS[side]),
        full_d,
    )

section.identity(
    "4/d/beyond/collinear",
    "both centers and the assumed point are on one line",
    printed=Matrix.zeros(3, 1),
    derived=(full_centers["left"] - Y_A).cross(full_centers["right"] - Y_A),
    note="Not in the paper: without rounding.",
)

# %% [markdown]
# The references of this item lead to section 3.2, the formulas are those of section 2.4.

# %%
section.reference(
    "4/d/ref-left",
    "parameters of the left bundle",
    printed="3.2.2",
    meant="2.3.2",
    note="(3.2.2) are epipolar lines of the normal case.  Meant is the solution of section 2.4, there numbered "
    "(2.3.2).",
)
section.reference(
    "4/d/ref-right",
    "first and second parameter of the right bundle",
    printed="3.2.3",
    meant="2.3.3",
    note="(3.2.3) is an epipolar line of the normal case.  Meant are the equations of section 2.4 that are numbered "
    "(2.3.3) there.",
    same_as="4/d/ref-left",
)
section.reference(
    "4/d/ref-mu3",
    "third parameter of the right bundle",
    printed="3.2.4",
    meant="2.4",
    note="(3.2.4) is the projection of y_A in the normal case.  The equations for mu''3 are a display of section 2.4 "
    "without a number.  The exchange of digits as in the other two references would lead to (2.3.4), the equations of "
    "a model point, which do not determine parameters.",
)

# %% [markdown]
# ## e. The relative model
#
# Four equations for a model point: the first three are solved, and the fourth is a check.

# %%
model_matrix, model_right_side = linear_system(forms_of_point, list(point))
model_equations = columns(model_matrix, model_right_side)


def equations_at(images: Images, name: str, parameters: Pair, u3: Pair) -> Matrix:
    return at(
        model_equations,
        (mu_p, parameters["left"]),
        (mu_pp, parameters["right"]),
        (u3_p, u3["left"]),
        (u3_pp, u3["right"]),
        (image_coordinates, (*images["left"][name], *images["right"][name])),
    )


def model_point(equations: Matrix) -> Matrix:
    return divided(solve(equations[:3, :3], equations[:3, 3]))


def model(images: Images, names: Iterable[str], parameters: Pair, u3: Pair) -> dict[str, Matrix]:
    return {name: model_point(equations_at(images, name, parameters, u3)) for name in names}


full_model = model(full_u, MODEL, full_mu, full_u3)
fourth_equation = [
    equations_at(full_u, name, full_mu, full_u3).row(3) * vector(*full_model[name], -1) for name in MODEL
]
section.identity(
    "4/e/beyond/fourth-equation",
    "the fourth equation of every point is satisfied",
    printed=Matrix.zeros(len(MODEL), 1),
    derived=Matrix.vstack(*fourth_equation),
    note="Not in the paper: without rounding the rays intersect.",
)

# %% [markdown]
# Basic points 1-4-5-2 stay, point 13 fixes the factors of the core (1.5.2).

# %%
FIFTH = "13"
object_affine = {name: affine(object_points, BASIC, name) for name in object_points}
core_parameters = mu_of_fifth.subs(mu4, 1)


def fitted(from_point: Matrix, to_point: Matrix) -> Matrix:
    return at(core_parameters, (fifth_point, from_point), (fifth_image, to_point))


def transformed(parameters: Matrix, model_coordinates: Matrix) -> Matrix:
    return at(image, (factors, parameters), (point, model_coordinates))


def item_e(images: Images) -> Values:
    """Return the exact numbers of the item."""
    points = model(images, MODEL, orientation(images)[0], fourth_points(images))
    parameters = fitted(points[FIFTH], object_affine[FIFTH])
    values = entries_of("m", at(core, (factors, parameters)))
    for name, model_coordinates in points.items():
        values |= named(f"{name}.ybar", model_coordinates)
        values |= named(f"{name}.y", transformed(parameters, model_coordinates))
    return values


full_e = item_e(full_u)
full_factors = fitted(full_model[FIFTH], object_affine[FIFTH])
for name, printed in MODEL.items():
    declare_cells(section, "4/e", f"point {name}, relative model", named(f"{name}.ybar", printed), full_e)
declare_cells(
    section,
    "4/e",
    "matrix of transformation to the object",
    entries_of("m", PRINTED_M),
    full_e,
    "(1.5.2) with mu_4 = 1.",
)
rotation_mu, _ = orientation(rotation_u)
rotation_model = model(rotation_u, [FIFTH], rotation_mu, fourth_points(rotation_u))
section.numeric(
    "4/e/beyond/printed-rotations",
    "the first element of the matrix that follows from the printed rotation matrices",
    printed="1.175435233",
    derived=fitted(rotation_model[FIFTH], object_affine[FIFTH])[0],
    note="Not in the paper: the printed 1.175435236 needs the unrounded rotations.  Five of the seven elements other "
    "than zero differ, by 2 to 5 units of the ninth decimal; the transformed model does not show it.",
)
for name, printed in TRANSFORMED.items():
    declare_cells(section, "4/e", f"point {name}, transformed to the object", named(f"{name}.y", printed), full_e)
section.identity(
    "4/e/comparison",
    "the transformed model is the initial one",
    printed=columns(*(object_affine[name] for name in MODEL)),
    derived=columns(*(transformed(full_factors, full_model[name]) for name in MODEL)),
    note="The comparison that the introduction of section 4 announces: all points, not only the five of the "
    "transformation, without rounding.",
)
section.identity(
    "4/e/beyond/centers",
    "the transformation takes the centers of the relative orientation to the initial ones",
    printed=columns(object_affine["O1"], object_affine["O2"]),
    derived=columns(*(transformed(full_factors, full_centers[side]) for side in SIDES)),
    note="Not in the paper; it restores the signs that item a) has lost in the first coordinate of both centers.",
)
