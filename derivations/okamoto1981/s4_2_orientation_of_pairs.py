# %% [markdown]
# # 4.2 Usual case: orientation problem of a stereoscopic pair
#
# Who knows that the comparator is parallel to the picture knows two numbers of each photograph.  Nine parameters are
# left of eleven, 18 for a pair.  How many of them does the condition of coplanarity determine?  The paper says six, and
# twelve parameters between model and object.  The answer is seven and eleven.

# %%
import sympy
from sympy import Eq, MatrixSymbol

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import given, inserted
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
# ## What does the condition look like?
#
# **Definition.**  It is (35), and the coordinates are those of (33): with the unit matrix for the inclinations, and the
# principal point $(x_H, y_H)$ for the center.

# %%


def usual_picture(measured: Matrix, principal_point: Matrix, distance: Scalar) -> Matrix:
    """Return the picture point of a measured point where the comparator is parallel."""
    parallel = inserted(reduced, (*d, *rotation_matrix), (*E3, *E3)).doit()
    return inserted(parallel, (xc, yc, xco, yco, c), (*measured, *principal_point, distance))


# %% [markdown]
# **Print.**  The rotations are those of (27) and (28).  What is printed holds for any matrices in their place.

# %%
xc1, yc1, xc2, yc2, xh1, yh1, xh2, yh2, c1, c2 = sympy.symbols("xc1 yc1 xc2 yc2 xH1 yH1 xH2 yH2 c1 c2")
D_phi1, D_kappa1, D_phi2, D_omega2, D_kappa2 = (
    MatrixSymbol(f"D_{name}", 3, 3) for name in ("phi1", "kappa1", "phi2", "omega2", "kappa2")
)
x1_bold, x2_bold = MatrixSymbol("x1", 3, 1), MatrixSymbol("x2", 3, 1)
section.identity("51", "condition of coplanarity", derived=reduced_condition)
section.identity(
    "52",
    "reduced transformed coordinates of the left picture",
    derived=D_phi1 * D_kappa1 * x1_bold,
    constraints=[Eq(x1_bold, usual_picture(vector(xc1, yc1), vector(xh1, yh1), c1))],
)
section.identity(
    "53",
    "reduced transformed coordinates of the right picture",
    derived=D_phi2 * D_omega2 * D_kappa2 * x2_bold,
    constraints=[Eq(x2_bold, usual_picture(vector(xc2, yc2), vector(xh2, yh2), c2))],
)

# %% [markdown]
# ## How many parameters does it determine?
#
# **Definition.**  Eleven parameters enter: five angles, and $x_H, y_H, c$ of either picture.  What can be had from
# pairs of points are the ratios of the elements of the bilinear form.  Seven of them determine the eighth, as its
# determinant is zero (35/beyond/determinant).

# %%
inner_left, inner_right = sympy.symbols("xH1 yH1 c1"), sympy.symbols("xH2 yH2 c2")
eleven = (*angles_left, *angles_right, *inner_left, *inner_right)
seven_of_eleven = seven_ratios(coplanarity_of(inner_of(inner_left), inner_of(inner_right)))

# %% [markdown]
# **Print.**  The paper concludes: $18 - 12 = 6$.  But the seven ratios are independent functions of the eleven
# parameters.

# %%
section.count(
    "4.2/six",
    "the condition has six independent parameters",
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
)

# %% [markdown]
# **Meaning.**  Near such a pair every fundamental matrix is that of two cameras of nine parameters.  Nothing of the
# image points shows whether the comparator was inclined.

# %% [markdown]
# **And with less freedom?**  If both pictures have one interior orientation, unknown but the same, the condition still
# has seven parameters: the five of the exterior, and two more.  The paper reports that Kölbl calculated one element of
# interior orientation.  With a given interior orientation the five are left.

# %%
common = sympy.symbols("xH yH c")
section.count(
    "4.2/beyond/common-camera",
    "with a common interior orientation the condition has seven independent parameters as well",
    printed=7,
    derived=seven_ratios(coplanarity_of(inner_of(common), inner_of(common))),
    variables=(*angles_left, *angles_right, *common),
)
section.count(
    "4.2/metric",
    "with given interior orientation the condition determines the five exterior elements",
    derived=seven_of_eleven,
    variables=(*angles_left, *angles_right),
)

# %% [markdown]
# ## Where do the twelve parameters of the paper come from?
#
# **Definition.**  From section 1.2: a collineation of space as a central projection in four dimensions.  The paper now
# makes its picture parallel to the comparator.

# %%
zc, zh = sympy.symbols("zc zH")
zco = spatial_center[2]
printed_quotients = vector(*(-c * forms[i] / forms[3] for i in range(3)))
fictitious = inserted(measured_in_space, d_of_space, Matrix.eye(4)) - spatial_center
in_comparator = given((xc, yc, zc), spatial_center + printed_quotients)

# %% [markdown]
# **Print.**  The principal point is the image of the projection center, as in 4.1/principal-point.

# %%
section.identity(
    "54",
    "measured coordinates in the space of the comparator",
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
    where=in_comparator | {xh: xco, yh: yco, zh: zco},
    derived=fictitious,
)

# %% [markdown]
# **How many are independent?**  As in section 1.2 it depends on which planes the four angles turn.  There are planes
# for which the paper's number is right, and four points are then needed: three have nine coordinates only.

# %%
twelve = (*four_of_object, *picture_parameters)
coefficients_of_twelve = coefficients_of(camera_of_planes(other_planes, four_of_object))
section.count(
    "55#twelve",
    "twelve independent parameters",
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
    derived=Matrix.vstack(*images_of_four),
    variables=twelve,
    note="Favourable reading, that of 55#twelve: the twelve coordinates are independent functions of the parameters.",
)

# %% [markdown]
# With $\phi, \omega, \kappa$ as in (2), and $\mu$ turning $Z$ towards $T$, there are eleven: one change of the
# parameters changes nothing (counted are the elements of the matrix of projection, divided by $\sin \mu$).  With a
# general rotation, of six angles, there are thirteen.

# %%
turn = {t_mu: sin_mu * angle_rate(t_mu), c: c * cos_mu, To: To * cos_mu, zco: c * sin_mu}
turn |= given(center, -To * sin_mu * axis_of_picture)
section.count(
    "55/beyond/ordinary-rotations",
    "with the rotations of (2) eleven of twelve parameters are independent",
    printed=11,
    derived=camera_of_planes(ordinary, four_of_object).applyfunc(lambda entry: over(entry, sin_mu)),
    variables=twelve,
    kernel=[vector(*(turn.get(parameter, 0) for parameter in twelve))],
)
section.count(
    "55/beyond/rotations-of-space",
    "with general rotations thirteen coefficients are independent",
    printed=13,
    derived=coefficients_of(camera_of_planes(all_planes, six_of_object))[2:, :],
    variables=(*six_of_object, *picture_parameters),
)

# %% [markdown]
# ## What do all correspondences of the form (54) have in common?
#
# $\mathbf E$ is orthogonal.  Displace the object point without changing the denominator, that is, parallel to the plane
# that is mapped to infinity.  Then the image is displaced by the same length, times $c$ over the denominator: **planes
# parallel to the vanishing plane are mapped similarly**, whatever the rotations.  These are two conditions, which a
# general collineation does not satisfy.  Here $\mathbf f$ are the four forms of (54) and $\mathbf t$ their changes.

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
    witness=given((*change, *w), (3, 4, 0, 0, 5, 0, 0)),
)

# %% [markdown]
# ## How do model and object really differ?
#
# **Derivation.**  Two pairs of photographs with the same condition of coplanarity differ by a collineation $\mathbf H$
# of space (section 2.1).  All four photographs must be cameras of nine parameters: each satisfies the two conditions of
# section 4.1.  For $\mathbf H = \mathbf 1 + \varepsilon \mathbf G$ these are four linear equations for the sixteen
# elements of $\mathbf G$, one of which is the scale.

# %%
q = Matrix(3, 3, sympy.symbols("q1:4(1:4)"))
generators = [Matrix(4, 4, lambda i, j, k=k: int((i, j) == divmod(k, 4))) for k in range(16)]


def rates_of_conditions(matrix: Matrix) -> list[list[Scalar]]:
    """Return the rates of the two conditions of a camera under each of the infinitesimal collineations."""
    at_camera = given(q, matrix[:, :3])
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
)

# %% [markdown]
# Sixteen elements, less the scale, less four: eleven.  The same by counting the collineations that satisfy the four
# equations, for one pair with rational numbers: they are the columns of a matrix of rank 11.

# %%
at_instance = {symbol: sympy.Rational(k * k % 23 + 2, k % 7 + 3) for k, symbol in enumerate(eleven)}
allowed = left_kernel(rates_of_four.xreplace(at_instance).doit().T).T
scale_of_matrix = vector(*(int(k % 5 == 0) for k in range(16)))
remaining_movements = (allowed - scale_of_matrix * allowed[15, :])[:15, :]

# %% [markdown]
# **Print.**  The paper has twelve.

# %%
section.rank(
    "4.2/twelve",
    "model and object differ by a correspondence of twelve parameters",
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
)

# %% [markdown]
# **Meaning.**  $15 - 4 = 11$, and $18 = 7 + 11$.  Seven of the eleven are a similarity; ratios of distances must give
# the other four.

# %% [markdown]
# ## Is the correspondence at least of the form (54)?
#
# **No.**  Here are two pairs of cameras of nine parameters, one for the model and one for the object.  They are the
# same but for the collineation $\mathbf H$ from model to object, which is regular; the centers of a pair are different.

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
)
section.identity(
    "4.2/beyond/example#regular",
    "the collineation is regular, and the right center is not the left one",
    printed=vector(4, -243),
    derived=vector(determinant(H), determinant(right_of_object[:, :3])),
)

# %% [markdown]
# Two perpendicular displacements parallel to the vanishing plane are mapped to displacements that are not
# perpendicular.  The form (54) would keep the right angle.

# %%
first, second = vector(1, -1, 0), vector(1, 1, -2)
first_image, second_image = A_inner * first, A_inner * second
distortion = vector(
    dot(first_image, second_image),
    dot(first_image, first_image) * dot(second, second) - dot(second_image, second_image) * dot(first, first),
)
SpaceDrawing(
    "The displacements P and Q, at a right angle, and their images P' and Q', which enclose 120 degrees.",
    {"O": vector(0, 0, 0), "P": first, "Q": second, "P'": first_image, "Q'": second_image},
    triangles=[("O", "P", "Q"), ("O", "P'", "Q'")],
    axes=("X", "Y", "Z"),
)

# %%
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
# ## What do distances say?
#
# **Definition and print.**  As in section 2.2, for four points: six segments, all independent, and with an unknown
# scale five equations.

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
    derived=vector(*squared_distances(four)),
    variables=coordinates_of_four,
    kernel=[rates(four, movement) for movement in movements],
)
section.count(
    "4.2/five",
    "the similarity of four points has five independent equations",
    derived=ratios_to_first(squared_distances(four)),
    variables=coordinates_of_four,
    kernel=[rates(four, similarity) for similarity in similarities],
)

# %% [markdown]
# **Which equations determine the eleven parameters?**  As in section 2.2: image coordinates and ratios of segments, as
# functions of the parameters and of model points, which are eliminated.


# %%
def equations_of(pairs_of_images: int, similarity_equations: int) -> Matrix:
    """Return the rates of the equations by the eleven; the first four points are the control points."""
    points = free_points(pairs_of_images)
    ratios = ratios_to_first(squared_distances(points[:4]))[:similarity_equations, :]
    images = images_in_model(points, inner_of(inner_left), inner_of(inner_right))
    return rates_of_equations(Matrix.vstack(images, ratios), eleven, points)


# %% [markdown]
# **Print.**  Six conditions of coplanarity and five of similarity.  They are independent, and near a solution there is
# no other.

# %%
section.rank(
    "4.2/eleven",
    "six conditions of coplanarity and five of similarity are eleven independent equations",
    derived=equations_of(6, 5),
)

# %% [markdown]
# **But seven conditions can be set up.**  With them four ratios are enough, and the fifth is a check.

# %%
section.rank(
    "4.2/beyond/seven-and-four",
    "seven conditions of coplanarity and four of similarity determine the eleven parameters as well",
    printed=11,
    derived=equations_of(7, 4),
)
section.rank(
    "4.2/beyond/seven-and-five",
    "with seven conditions of coplanarity the fifth of similarity is a check",
    printed=11,
    derived=equations_of(7, 5),
)
