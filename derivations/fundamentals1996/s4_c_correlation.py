# %% [markdown]
# # 4 Numerical example, c) to e)
#
# Does the whole chain work: correlation of the two pictures of item b), relative orientation, reconstruction of the
# model and its transformation to the object?  Every printed number is a claim of its own.  It is compared with the
# one exact number that the chain gives *without rounding* from the object points and rotations of items a) and b).
# The tables of the paper are in `printed_tables`.

# %%
from collections.abc import Iterable

import sympy

from algebroproj_derivations.figures import ImageDrawing, SpaceDrawing
from algebroproj_derivations.fundamentals1996.notation import center, fourth_image, mu
from algebroproj_derivations.fundamentals1996.printed_tables import MODEL
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
from algebroproj_derivations.fundamentals1996.tables import Values, at, declare_cells, entries_of, named
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    divided,
    homogeneous,
    linear_system,
    solve,
    vector,
)

section = Section("fundamentals1996", "4", "Numerical example")

# %%
Y_A = exact("-1.0", "0.5", "3.5")

# %% [markdown]
# ## The images
#
# They are projected from the object points with the unrounded rotations, and once more with the rotation matrices as
# printed.  What can these reproduce?

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
# **Method.**  Points 1, 4, 5 are $G_0, G_1, G_2$.  Points 2, 3, 6, 7, 8 give the five equations (2.2.4) for the matrix
# (2.2.3).

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

# %% [markdown]
# **Print.**  The coordinates of item b) have seven decimals, the elements eight.  They follow from the coordinates
# before rounding.

# %%
declare_cells(section, "4/c", "matrix of correlation", r"z\d\d", full_c)

# %% [markdown]
# The determinant is zero, as the pictures are exactly homologous; the elements with eight decimals leave 4e-9.  The
# epipoles (2.2.6) and (2.2.7) follow.

# %%
declare_cells(section, "4/c", "determinant of the matrix of correlation", "det", full_c)
full_epipoles = epipoles_of(full_elements)
for side in SIDES:
    declare_cells(
        section,
        "4/c",
        f"epipole in the {side} picture",
        rf"{side}\.u0\d",
        full_c,
        exceptions={"4/c#left.u01": {"note": "Printed with a decimal comma."}},
    )

# %% [markdown]
# The author's program did not use (2.2.6) as printed, which gives the other signs.

# %%
epipole_as_printed = at(printed_left / D_printed, (remaining, full_elements))
for part, printed, value in zip(("u01", "u02"), ("-1.64746", "12.56421"), epipole_as_printed, strict=True):
    section.numeric(
        f"4/c/beyond/as-printed#left.{part}",
        f"where (2.2.6) as printed puts the epipole of the left picture, left.{part}",
        printed=printed,
        derived=value,
    )

# %% [markdown]
# **Meaning.**  The epipoles solve all three equations, of which (2.2.6) and (2.2.7) use two.  And they are the images
# of the other centers, which item b) has in its rows $O''$ and $O'$.

# %%
Z_full = correlation_matrix(full_elements)
section.identity(
    "4/c/epipoles",
    "the epipoles solve the equations",
    derived=columns(Z_full.T * homogeneous(full_epipoles["left"]), Z_full * homogeneous(full_epipoles["right"])),
)
section.identity(
    "4/c/beyond/centers",
    "the epipoles of the correlation are the images of the other centers",
    printed=columns(full_u["left"]["O2"], full_u["right"]["O1"]),
    derived=columns(full_epipoles["left"], full_epipoles["right"]),
)

# %% [markdown]
# In the pictures themselves:

# %%
SHOWN = ("1", "4", "5", *FURTHER)
ImageDrawing(
    "The points of correlation in both pictures of the example, and the epipolar lines of each.  The epipoles, in "
    "which they meet, are far below.",
    {
        f"{side} picture": (
            {name: full_u[side][name] for name in SHOWN},
            [matrix * homogeneous(full_u[other][name]) for name in SHOWN],
        )
        for side, other, matrix in (("left", "right", Z_full), ("right", "left", Z_full.T))
    },
)

# %% [markdown]
# **What do the printed rotation matrices reproduce?**  All elements of $\mathbf Z$ but one, which would round to
# -0.08096188 and is printed as -0.08096187; the determinant and the epipoles; the numbers of the items d) to h) but for
# the matrix of item e) and one coordinate of item g).  Three coordinates of item g) have their printed last digit with
# these matrices alone.

# %%
section.numeric(
    "4/c/beyond/printed-rotations",
    "the element z21 that follows from the printed rotation matrices",
    printed="-0.080961876",
    derived=correlation(rotation_u)[3],
)

# %% [markdown]
# ## d. Relative orientation
#
# **Method.**  $\mathbf y_A$ is any point.  The choice fixes, with $\mu'_1 = \mu'_2$, the projective coordinates of the
# relative model.  Then (2.3.2) and (2.3.3) of section 2.4 give both bundles.

# %%
section.definition("4/d/yA", "point assumed on the epipolar axis")
for side, prime in (("left", "'"), ("right", "''")):
    section.definition(f"4/d#{side}.mu0", f"normalization of the {side} bundle, mu{prime}0")


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
        rf"{side}\.mu\d",
        full_d,
    )
    declare_cells(
        section,
        "4/d",
        f"center of projection of the {side} bundle",
        rf"{side}\.y0\d",
        full_d,
    )

# %% [markdown]
# Both centers and the assumed point are on one line.

# %%
section.identity(
    "4/d/beyond/collinear",
    "both centers and the assumed point are on one line",
    printed=Matrix.zeros(3, 1),
    derived=(full_centers["left"] - Y_A).cross(full_centers["right"] - Y_A),
)

# %% [markdown]
# The references of this item lead to section 3.2, the formulas are those of section 2.4.

# %%
section.reference(
    "4/d/ref-left",
    "parameters of the left bundle",
    meant="2.3.2",
    note="(3.2.2) are epipolar lines of the normal case.",
)
section.reference(
    "4/d/ref-right",
    "first and second parameter of the right bundle",
    meant="2.3.3",
    note="(3.2.3) is an epipolar line of the normal case.",
    same_as="4/d/ref-left",
)
section.reference(
    "4/d/ref-mu3",
    "third parameter of the right bundle",
    meant="2.4",
    note="Meant is a display of section 2.4 without a number.  (2.3.4), with the digits exchanged as in the other two "
    "references, are the equations of a model point, which do not determine parameters.",
)

# %% [markdown]
# ## e. The relative model
#
# **Method.**  There are four equations for a model point.  The first three are solved, and the fourth is a check:
# without rounding the rays intersect.

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
)

# %% [markdown]
# **To the object.**  The basic points 1, 4, 5, 2 stay.  Point 13 fixes the factors of the core (1.5.2), with $\mu_4 =
# 1$.

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
for name in MODEL:
    declare_cells(section, "4/e", f"point {name}, relative model", rf"{name}\.ybar\d", full_e)
declare_cells(
    section,
    "4/e",
    "matrix of transformation to the object",
    r"m\d\d",
    full_e,
)

# %% [markdown]
# The printed rotation matrices do not give this matrix.  Five of the seven elements other than zero differ, by 2 to 5
# units of the ninth decimal.  The transformed model does not show it.

# %%
rotation_mu, _ = orientation(rotation_u)
rotation_model = model(rotation_u, [FIFTH], rotation_mu, fourth_points(rotation_u))
section.numeric(
    "4/e/beyond/printed-rotations",
    "the first element of the matrix that follows from the printed rotation matrices",
    printed="1.175435233",
    derived=fitted(rotation_model[FIFTH], object_affine[FIFTH])[0],
)

# %% [markdown]
# **Is it the object?**  The introduction of section 4 announces this comparison.  All points agree without rounding,
# not only the five of the transformation.  So do the centers, which restores the signs that item a) has lost in the
# first coordinate of both.

# %%
for name in MODEL:
    declare_cells(section, "4/e", f"point {name}, transformed to the object", rf"{name}\.y\d", full_e)
section.identity(
    "4/e/comparison",
    "the transformed model is the initial one",
    printed=columns(*(object_affine[name] for name in MODEL)),
    derived=columns(*(transformed(full_factors, full_model[name]) for name in MODEL)),
)
section.identity(
    "4/e/beyond/centers",
    "the transformation takes the centers of the relative orientation to the initial ones",
    printed=columns(object_affine["O1"], object_affine["O2"]),
    derived=columns(*(transformed(full_factors, full_centers[side]) for side in SIDES)),
)

# %% [markdown]
# The relative model and the object have the basic points in common, and differ by a projectivity:

# %%
SEEN = ("3", "6", "7", "8", "13")
SpaceDrawing(
    "Five points of the example in the object, and the same points of the relative model, with a star.  The basic "
    "points agree.  Point 13 fixes the projectivity that moves the one to the other.",
    {name: object_affine[name] for name in SEEN}
    | {f"{name}*": full_model[name] for name in SEEN}
    | {f"G{j}": object_affine[name] for j, name in enumerate(BASIC)},
    segments=[(name, f"{name}*") for name in SEEN],
)
