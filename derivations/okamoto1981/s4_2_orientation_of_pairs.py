# %% [markdown]
# # 4.2 Usual case: orientation problem of a stereoscopic pair
#
# Nine parameters for either photograph.  The paper holds that the condition of coplanarity determines six of the 18,
# and that model and object differ by a correspondence of 12 parameters.  The condition determines seven, as in the
# general case, and 11 are left.

# %%
import sympy

from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import d
from algebroproj_derivations.okamoto1981.s1_2_space_correspondence import (
    To,
    all_planes,
    axis_of_picture,
    camera_of_planes,
    cos_mu,
    forms,
    four_of_object,
    ordinary,
    other_planes,
    picture_parameters,
    sin_mu,
    six_of_object,
    spatial_center,
    t_mu,
)
from algebroproj_derivations.okamoto1981.s1_2_space_correspondence import d as d_of_space
from algebroproj_derivations.okamoto1981.s1_2_space_correspondence import measured as measured_in_space
from algebroproj_derivations.okamoto1981.s2_2_geometrical_consideration import (
    about,
    angles_left,
    angles_right,
    coplanarity_of,
    free_points,
    images_in_model,
    inner_of,
    left_rotation,
    movements,
    rates,
    ratios_to_first,
    reduced,
    reduced_condition,
    reduced_left,
    reduced_right,
    right_rotation,
    rotation_matrix,
    segment_of_model,
    segment_of_object,
    seven_ratios,
    similarities,
    squared_distances,
    unit_base,
)
from algebroproj_derivations.okamoto1981.s4_1_usual_case import conditions, xh, yh
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, Scalar, columns, determinant, diff, dot, over, vector

section = Section("okamoto1981", "4.2", "Usual case, orientation problem of a stereoscopic pair")

# %% [markdown]
# ## Coplanarity

# %%
X1, Y1, Z1 = reduced_left
X2, Y2, Z2 = reduced_right
section.identity(
    "51",
    "condition of coplanarity",
    printed=Y1 * Z2 - Y2 * Z1,
    derived=reduced_condition,
    note="The same as (35).",
)

# %% [markdown]
# The coordinates are those of (33), with the unit matrix for the inclinations and the principal point for the center.

# %%
for number, side, rotations, index, damage in (
    (
        "52",
        "left",
        about(ABOUT_Y, "1") * about(ABOUT_Z, "1"),
        "1",
        "Read as the three components on the left, where the scan repeats the first one.",
    ),
    (
        "53",
        "right",
        about(ABOUT_Y, "2") * about(ABOUT_X, "2") * about(ABOUT_Z, "2"),
        "2",
        "Read as x_c2 without a bar; the scan has bars on it and on the letters M.",
    ),
):
    xci, yci, xhi, yhi, ci = sympy.symbols(f"xc{index} yc{index} xH{index} yH{index} c{index}")
    usual = dict(zip((*d, *rotation_matrix), (*E3, *rotations), strict=True))
    indexed = {xc: xci, yc: yci, xco: xhi, yco: yhi, c: ci}
    section.identity(
        number,
        f"reduced transformed coordinates of the {side} picture",
        printed=rotations * vector(xci - xhi, yci - yhi, -ci),
        derived=reduced.xreplace(usual).xreplace(indexed),
        note=damage,
    )

# %% [markdown]
# ## What the condition determines
#
# Eleven parameters enter: five angles, and $x_H, y_H, c$ of either picture.

# %%
inner_left, inner_right = sympy.symbols("xH1 yH1 c1"), sympy.symbols("xH2 yH2 c2")
eleven = (*angles_left, *angles_right, *inner_left, *inner_right)
seven_of_eleven = seven_ratios(coplanarity_of(inner_of(inner_left), inner_of(inner_right)))
section.count(
    "4.2/six",
    "the condition has six independent parameters",
    printed=6,
    derived=seven_of_eleven,
    variables=eleven,
    expect="false",
    instead="4.2/beyond/seven",
    note="Read as the number of independent functions of the parameters in the condition, as in 2.2/seven, where the "
    "same count gives the seven of the paper.  The conclusion 18 - 12 = 6 of the paper fails because the "
    "correspondence of model and object has 11 parameters, 4.2/beyond/eleven.",
    grade="results",
    follows="The condition has {4.2/beyond/seven} independent parameters. Six pairs of points leave one of them "
    "open. See docs/findings/okamotos-counts.md.",
)
section.count(
    "4.2/beyond/seven",
    "the condition has seven independent parameters in the usual case as well",
    printed=7,
    derived=seven_of_eleven,
    variables=eleven,
    note="Not in the paper: seven ratios of the elements of the bilinear form are independent, and by "
    "35/beyond/determinant the eighth follows from them.  Every fundamental matrix near such a pair is that of two "
    "cameras of nine parameters.",
)
common = sympy.symbols("xH yH c")
section.count(
    "4.2/beyond/common-camera",
    "with a common interior orientation the condition has seven independent parameters as well",
    printed=7,
    derived=seven_ratios(coplanarity_of(inner_of(common), inner_of(common))),
    variables=(*angles_left, *angles_right, *common),
    note="Not in the paper, which reports that Koelbl calculated one element of interior orientation and the five of "
    "exterior orientation: with three unknown elements that both pictures share, the condition determines two more "
    "than these five.",
)
section.count(
    "4.2/metric",
    "with given interior orientation the condition determines the five exterior elements",
    printed=5,
    derived=seven_of_eleven,
    variables=(*angles_left, *angles_right),
    note="The interior orientation of both pictures is constant.",
)

# %% [markdown]
# ## The correspondence of the paper
#
# The paper derives its 12 parameters from a central projection in four dimensions whose picture is parallel to the
# comparator.

# %%
zc, zh = sympy.symbols("zc zH")
zco = spatial_center[2]
printed_quotients = vector(*(-c * forms[i] / forms[3] for i in range(3)))
fictitious = measured_in_space.xreplace(dict(zip(d_of_space, Matrix.eye(4), strict=True))) - spatial_center
in_comparator = dict(zip((xc, yc, zc), spatial_center + printed_quotients, strict=True))
section.identity(
    "54",
    "measured coordinates in the space of the comparator",
    printed=vector(xc - xco, yc - yco, zc - xco),
    where=in_comparator,
    derived=fictitious,
    expect="misprint",
    corrected=vector(xc - xco, yc - yco, zc - zco),
    note="The left side of the third equation must be zc - zco.  The numerators, of which the scan damages the third, "
    "are those of (10).  The scan alone cannot tell a slip of the scan from one of the print.",
)
section.identity(
    "55",
    "measured coordinates, referred to the principal point",
    printed=vector(xc - xh, yc - yh, zc - zh),
    where=in_comparator | {xh: xco, yh: yco, zh: zco},
    derived=fictitious,
    note="The principal point is the image of the projection center, as in 4.1/principal-point.",
)

# %% [markdown]
# As in section 1.2 the number of independent parameters depends on which planes the four angles turn.

# %%
twelve = (*four_of_object, *picture_parameters)
coefficients_of_twelve = coefficients_of(camera_of_planes(other_planes, four_of_object))
section.count(
    "55#twelve",
    "twelve independent parameters",
    printed=12,
    derived=coefficients_of_twelve,
    variables=twelve,
    note="Favourable reading, with the planes of 1.2/independent.  With the rotations of (2) there are eleven, and "
    "with a general rotation thirteen: 55/beyond/ordinary-rotations, 55/beyond/rotations-of-space.  Of the 81 ways to "
    "turn a plane without the named axis 18 give twelve at a rational point.",
)
PLACES = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
images_of_four = [image(camera_of_planes(other_planes, four_of_object), p) for p in PLACES]
section.count(
    "55#four-points",
    "four points determine the correspondence",
    printed=12,
    derived=Matrix.vstack(*images_of_four),
    variables=twelve,
    note="Favourable reading, that of 55#twelve: the twelve coordinates are independent functions of the parameters.  "
    "Three points have nine coordinates only.",
)
turn = {t_mu: sin_mu * angle_rate(t_mu), c: c * cos_mu, To: To * cos_mu, zco: c * sin_mu}
turn |= dict(zip(center, -To * sin_mu * axis_of_picture, strict=True))
section.count(
    "55/beyond/ordinary-rotations",
    "with the rotations of (2) eleven of twelve parameters are independent",
    printed=11,
    derived=camera_of_planes(ordinary, four_of_object).applyfunc(lambda entry: over(entry, sin_mu)),
    variables=twelve,
    kernel=[vector(*(turn.get(parameter, 0) for parameter in twelve))],
    note="Not in the paper: phi, omega, kappa as in (2) and mu turning Z towards T, as in "
    "1.2/beyond/ordinary-rotations.  Counted are the entries of the matrix of projection, divided by sin(mu).",
)
section.count(
    "55/beyond/rotations-of-space",
    "with general rotations thirteen coefficients are independent",
    printed=13,
    derived=coefficients_of(camera_of_planes(all_planes, six_of_object))[2:, :],
    variables=(*six_of_object, *picture_parameters),
    note="Not in the paper: six angles, fourteen parameters; the coefficients without A1 and A2 are independent.",
)

# %% [markdown]
# Whatever the rotations, (54) has this property: displacements $\mathbf w$ of the object that keep the denominator are
# mapped similarly, for $\mathbf E$ is orthogonal.  They are parallel to the plane that is mapped to infinity.

# %%
w = vector(*sympy.symbols("w1 w2 w3"))
form, change = vector(*sympy.symbols("f1:5")), vector(*sympy.symbols("t1:5"))
displacement = vector(
    *(-c * (over(form[i] + change[i], form[3] + change[3]) - over(form[i], form[3])) for i in range(3))
)
section.identity(
    "54/beyond/similar-plane",
    "planes parallel to the vanishing plane are mapped similarly",
    printed=c**2 * dot(w, w) / form[3] ** 2,
    derived=dot(displacement, displacement),
    constraints=[change[3], dot(change, change) - dot(w, w)],
    witness=dict(zip((*change, *w), (3, 4, 0, 0, 5, 0, 0), strict=True)),
    note="Not in the paper.  With f for the four forms of (54) and t for their changes, which are (w, 0) turned; two "
    "conditions that a general collineation does not satisfy.",
)

# %% [markdown]
# ## Model and object
#
# Two pairs of photographs with the same condition of coplanarity differ by a collineation $\mathbf H$ of space, and
# both pairs must satisfy the conditions of 4.1/beyond/conditions.  For $\mathbf H = \mathbf 1 + \varepsilon \mathbf G$
# these are four linear equations for the sixteen elements of $\mathbf G$, one of which is the scale.

# %%
q = Matrix(3, 3, sympy.symbols("q1:4(1:4)"))
generators = [Matrix(4, 4, lambda i, j, k=k: int((i, j) == divmod(k, 4))) for k in range(16)]


def rates_of_conditions(matrix: Matrix) -> list[list[Scalar]]:
    """Return the rates of the two conditions of a camera under each of the infinitesimal collineations."""
    at_camera = dict(zip(q, matrix[:, :3], strict=True))
    gradients = [vector(*(diff(condition, entry).xreplace(at_camera) for entry in q)) for condition in conditions(q)]
    changes = [vector(*(matrix * generator)[:, :3]) for generator in generators]
    return [[dot(gradient, change) for change in changes] for gradient in gradients]


left_camera = camera(inner_of(inner_left), left_rotation.T, vector(0, 0, 0))
right_camera = camera(inner_of(inner_right), right_rotation.T, unit_base)
rates_of_four = Matrix([*rates_of_conditions(left_camera), *rates_of_conditions(right_camera)])
section.rank(
    "4.2/beyond/four-conditions",
    "the four equations are independent",
    printed=4,
    derived=rates_of_four,
    note="Not in the paper: sixteen elements, one of them the scale, less four are eleven.",
)
at_instance = {symbol: sympy.Rational(k * k % 23 + 2, k % 7 + 3) for k, symbol in enumerate(eleven)}
allowed = left_kernel(rates_of_four.xreplace(at_instance).doit().T).T
scale_of_matrix = vector(*(int(k % 5 == 0) for k in range(16)))
remaining_movements = (allowed - scale_of_matrix * allowed[15, :])[:15, :]
section.rank(
    "4.2/twelve",
    "model and object differ by a correspondence of twelve parameters",
    printed=12,
    derived=remaining_movements,
    kernel=[vector(*entry) for entry in remaining_movements.nullspace()],
    expect="false",
    instead="4.2/beyond/eleven",
    note="The columns are the infinitesimal collineations that satisfy the four equations, for one pair with rational "
    "numbers.  By 4.2/beyond/four-conditions there are as many in general.",
    grade="results",
    follows="There are {4.2/beyond/eleven} parameters. The four control points of the paper give one equation more "
    "than is needed. See docs/findings/okamotos-counts.md.",
)
section.rank(
    "4.2/beyond/eleven",
    "model and object differ by a correspondence of eleven parameters",
    printed=11,
    derived=remaining_movements,
    kernel=[vector(*entry) for entry in remaining_movements.nullspace()],
    note="Not in the paper: 15 - 4 = 11, and 18 = 7 + 11.  Seven of the eleven are a similarity.",
)

# %% [markdown]
# Nor is the correspondence of the form (54).  Here are two pairs of cameras of nine parameters, the model pair and the
# object pair, the same but for the collineation $\mathbf H$ from model to object.

# %%
A_inner, v = Matrix([[2, 0, 1], [0, 2, 0], [0, 0, 1]]), vector(1, 1, 1)
H = columns(A_inner, vector(0, 0, 0)).col_join(Matrix([[*v, 1]]))
left_of_object = columns(E3, vector(0, 0, 0))
right_of_object = Matrix([[6, sympy.Rational(15, 2), -3, -9], [-6, -12, -15, 18], [2, 1, 2, 0]])
pairs = [left_of_object, right_of_object, left_of_object * H, right_of_object * H]
section.identity(
    "4.2/beyond/example",
    "two pairs of cameras of nine parameters that differ by a collineation",
    printed=Matrix.zeros(8, 1),
    derived=vector(*(condition for matrix in pairs for condition in conditions(matrix))),
    note="Not in the paper: the conditions of 4.1/beyond/conditions for all four cameras.",
)
section.identity(
    "4.2/beyond/example#regular",
    "the collineation is regular, and the right center is not the left one",
    printed=vector(4, -243),
    derived=vector(determinant(H), determinant(right_of_object[:, :3])),
    note="Not in the paper.  Where the second determinant is not zero, the last column, which is not zero, is that of "
    "a center other than the origin.",
)
first, second = vector(1, -1, 0), vector(1, 1, -2)
first_image, second_image = A_inner * first, A_inner * second
distortion = vector(
    dot(first_image, second_image),
    dot(first_image, first_image) * dot(second, second) - dot(second_image, second_image) * dot(first, first),
)
section.identity(
    "4.2/correspondence",
    "model and object correspond in the form (54)",
    printed=vector(0, 0),
    derived=distortion,
    expect="false",
    instead="4.2/beyond/eleven",
    note="Derived is what 54/beyond/similar-plane makes zero: two perpendicular displacements parallel to the "
    "vanishing plane of H would be mapped to perpendicular ones at one scale.  No rotation of the space of four "
    "dimensions gives this correspondence.",
    grade="results",
    follows="No rotation of a space of four dimensions gives the correspondence of model and object. See "
    "docs/findings/okamotos-counts.md.",
)

# %% [markdown]
# ## Similarity
#
# Four points have six segments, and their similarity five equations.

# %%
section.definition(
    "4.2/scale",
    "the similarity condition of one line segment",
    printed=segment_of_model / segment_of_object,
)

four = free_points(4)
coordinates_of_four = tuple(coordinate for p in four for coordinate in p)
section.count(
    "4.2/six-segments",
    "four points have six independent line segments",
    printed=6,
    derived=vector(*squared_distances(four)),
    variables=coordinates_of_four,
    kernel=[rates(four, movement) for movement in movements],
)
section.count(
    "4.2/five",
    "the similarity of four points has five independent equations",
    printed=5,
    derived=ratios_to_first(squared_distances(four)),
    variables=coordinates_of_four,
    kernel=[rates(four, similarity) for similarity in similarities],
)

# %% [markdown]
# As in 2.2/fifteen: image coordinates and ratios of segments as functions of the 11 parameters and of model points.


# %%
def equations_of(pairs_of_images: int, similarity_equations: int) -> Matrix:
    """Return the rates of the equations by the eleven; the first four points are the control points."""
    points = free_points(pairs_of_images)
    ratios = ratios_to_first(squared_distances(points[:4]))[:similarity_equations, :]
    images = images_in_model(points, inner_of(inner_left), inner_of(inner_right))
    return rates_of_equations(Matrix.vstack(images, ratios), eleven, points)


for number, title, of_coplanarity, of_similarity, note in (
    (
        "4.2/eleven",
        "six conditions of coplanarity and five of similarity are eleven independent equations",
        6,
        5,
        "Local, as 2.1/twenty-two.  They are not all that could be set up: 4.2/beyond/seven-and-four.",
    ),
    (
        "4.2/beyond/seven-and-four",
        "seven conditions of coplanarity and four of similarity determine the eleven parameters as well",
        7,
        4,
        "Not in the paper.",
    ),
    (
        "4.2/beyond/seven-and-five",
        "with seven conditions of coplanarity the fifth of similarity is a check",
        7,
        5,
        "Not in the paper: twelve equations, of which eleven are independent.",
    ),
):
    section.rank(number, title, printed=11, derived=equations_of(of_coplanarity, of_similarity), note=note)
