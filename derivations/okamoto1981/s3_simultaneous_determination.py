# %% [markdown]
# # 3 Simultaneous determination of all orientation unknowns for the general case
#
# Section 2.2 went from the pictures to a model, and from the model to the object.  Can one go at once?  The rays are
# the same, now in the system of the object, and 22 parameters of two photographs are unknown together.

# %%
import sympy

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import given
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import exterior_angles, of_angles
from algebroproj_derivations.okamoto1981.s2_2_geometrical_consideration import (
    free_points,
    g1,
    g2,
    inner_left,
    inner_of,
    inner_right,
    of_reduced,
    ray_matrix,
    reduced_left,
    reduced_right,
    rho1,
    rho2,
    seven_ratios,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    Scalar,
    columns,
    cross,
    determinant,
    dot,
    linear_system,
    over,
    solve,
    vector,
)

section = Section("okamoto1981", "3", "Simultaneous determination of all orientation unknowns, general case")

# %% [markdown]
# ## What are the rays in the system of the object?
#
# **Definition.**  They start at the two centers.

# %%
center_left, center_right = vector(*sympy.symbols("Xo1 Yo1 Zo1")), vector(*sympy.symbols("Xo2 Yo2 Zo2"))
Xo1, Yo1, Zo1 = center_left
Xo2, Yo2, Zo2 = center_right
l1, m1, n1 = g1
l2, m2, n2 = g2
on_left_ray, on_right_ray = center_left + rho1 * g1, center_right + rho2 * g2


# %% [markdown]
# **Print.**

# %%
section.identity("39", "the left ray", where=given(point, on_left_ray), derived=vector(rho1, rho1, rho1))
section.identity("40", "the right ray", where=given(point, on_right_ray), derived=vector(rho2, rho2, rho2))

# %% [markdown]
# ## When do they meet?
#
# **Definition.**  Where $\rho_1 \mathbf g_1 - \rho_2 \mathbf g_2$ is the base from the left to the right center: three
# equations for two unknowns.

# %%
BX, BY, BZ = sympy.symbols("B_X B_Y B_Z")
base = vector(BX, BY, BZ)
of_centers = given(base, center_right - center_left)
meeting, base_vector = linear_system(list(on_left_ray - on_right_ray), (rho1, rho2))
section.vanishing("41", "condition of coplanarity", derived=determinant(columns(meeting, base_vector)))

# %% [markdown]
# **Print.**  The reduced coordinates, divided by their lengths, are the directions; the lengths drop out.

# %%
section.vanishing(
    "42",
    "condition of coplanarity in reduced transformed picture coordinates",
    derived=dot(base, cross(g1, g2)).xreplace(of_reduced),
)
section.identity(
    "42#base",
    "the base",
    derived=base_vector,
)

# %% [markdown]
# ## Where do they meet?
#
# **Definition.**  $\rho_1$ from the first two of the three equations.

# %%
rho = solve(meeting[:2, :], base_vector[:2, :])[0]
object_point = center_left + rho * g1
reduced_point = object_point.xreplace(of_reduced)
object_point

# %% [markdown]
# **Print.**

# %%
section.identity("43#rho", "factor of the left ray", where=of_centers, derived=rho)
section.identity("43#directions", "object point from direction cosines", where=of_centers, derived=object_point)
section.identity(
    "43", "object point from reduced transformed picture coordinates", where=of_centers, derived=reduced_point
)

# %% [markdown]
# ## Are there 22 equations?
#
# **Definition.**  As in section 2.2 the condition is a bilinear form of the measured points.  Its middle matrix takes a
# vector to the product with the base.  It is singular, and with it the form.

# %%
angles_left, angles_right = (tuple(sympy.symbols(f"t_phi{i} t_omega{i} t_kappa{i}")) for i in (1, 2))
left_rotation, right_rotation = of_angles(*angles_left), of_angles(*angles_right)
twenty_two = (*angles_left, *center_left, *inner_left, *angles_right, *center_right, *inner_right)
b1, b2, b3 = center_right - center_left
cross_with_base = Matrix([[0, b3, -b2], [-b3, 0, b1], [b2, -b1, 0]])
section.identity(
    "42/beyond/bilinear",
    "the condition as a bilinear form",
    printed=dot(reduced_left, cross_with_base * reduced_right),
    derived=dot(center_right - center_left, cross(reduced_left, reduced_right)),
)
section.identity(
    "42/beyond/determinant",
    "the middle matrix is singular, and with it the bilinear form",
    printed=0,
    derived=determinant(cross_with_base),
)

# %% [markdown]
# So seven ratios of its elements determine the eighth.  **Print:** they are independent.


# %%
def bilinear_of(left: Matrix, right: Matrix) -> Matrix:
    """Return the matrix of the bilinear form of (42), for the affine maps of two comparators."""
    return ray_matrix(left_rotation, left).T * cross_with_base * ray_matrix(right_rotation, right)


section.count(
    "42#seven",
    "the condition has seven independent parameters",
    derived=seven_ratios(bilinear_of(inner_of(inner_left), inner_of(inner_right))),
    variables=twenty_two,
)

# %% [markdown]
# **Do five object points do the rest?**  The seven pairs are those of five object points and of two further ones, whose
# coordinates are eliminated.  For a pair that satisfies (42) the four image coordinates of a given point say the same
# as (43).


# %%
def images_by(cameras: tuple[Matrix, Matrix], points: list[Matrix]) -> Matrix:
    return Matrix.vstack(*(image(matrix, p) for p in points for matrix in cameras))


tie_points = free_points(2)
control_points = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 2, 3))]
cameras = (
    camera(inner_of(inner_left), left_rotation.T, center_left),
    camera(inner_of(inner_right), right_rotation.T, center_right),
)
section.rank(
    "3/twenty-two",
    "seven conditions of coplanarity and five object points give 22 independent equations",
    derived=rates_of_equations(images_by(cameras, [*control_points, *tie_points]), twenty_two, tie_points),
)

# %% [markdown]
# **Meaning.**  Near a solution there is no other.  Elsewhere there can be two more (3/unique).

# %% [markdown]
# ## What does a control point give of which not all is known?
#
# **Definition.**  On a ray one known coordinate gives the others.  What is known is put into (39) and (40), and the
# unknown coordinates are eliminated.


# %%
def from_known(known: int, wanted: int, origin: Matrix, direction: Matrix) -> Scalar:
    """Return a coordinate of the point of a ray where another coordinate is known."""
    return origin[wanted] + over(direction[wanted], direction[known]) * (point[known] - origin[known])


def in_reduced(expression: Scalar) -> Scalar:
    return expression.xreplace(of_reduced)


# %% [markdown]
# **First type: all is known.**  From $Z$ follow $X$ and $Y$, in either photograph.

# %%
section.identity(
    "44#directions",
    "first type, left photograph, from direction cosines",
    derived=vector(*(from_known(2, k, center_left, g1) for k in (0, 1))),
)
section.identity(
    "44",
    "first type, left photograph",
    derived=vector(*(in_reduced(from_known(2, k, center_left, g1)) for k in (0, 1))),
)
section.identity(
    "45#directions",
    "first type, right photograph, from direction cosines",
    derived=vector(*(from_known(2, k, center_right, g2) for k in (0, 1))),
)
section.identity(
    "45",
    "first type, right photograph",
    where=of_centers,
    derived=vector(*(in_reduced(from_known(2, k, center_right, g2)) for k in (0, 1))),
)

# %% [markdown]
# The collinearity equations (3) say the same: the picture point, turned into the system of the object, has the
# direction from the center to the object point.

# %%
ray = of_angles(*exterior_angles).T * (point - center)
section.up_to_scale(
    "44#collinearity",
    "the collinearity equations say the same",
    printed=point - center,
    derived=of_angles(*exterior_angles) * vector(*(over(-c * component, ray[2]) for component in ray)),
)

# %% [markdown]
# **Second type: $X$ and $Y$ are known.**  The third equation says that both rays give the same $Z$; it is written with
# $Z - Z_{o1}$.

# %%
section.identity(
    "46#1",
    "second type, left photograph",
    derived=vector(from_known(1, 0, center_left, g1), in_reduced(from_known(1, 0, center_left, g1))),
)
section.identity(
    "46#2",
    "second type, right photograph",
    where=of_centers,
    derived=vector(from_known(1, 0, center_right, g2), in_reduced(from_known(1, 0, center_right, g2))),
)
section.identity(
    "46#3",
    "second type, both photographs: the two sides",
    where=of_centers,
    derived=vector(*(in_reduced(from_known(0, 2, o, g)) - Zo1 for o, g in ((center_left, g1), (center_right, g2)))),
)

# %% [markdown]
# **Third type: $Z$ is known.**  Both rays give the same $X$ and the same $Y$.

# %%
section.identity(
    "47",
    "third type, from direction cosines: the two sides of both equations",
    derived=Matrix(2, 2, lambda k, j: from_known(2, k, *((center_left, g1), (center_right, g2))[j])),
)
section.identity(
    "48",
    "third type: the two sides of both equations",
    where=of_centers,
    derived=Matrix(
        2,
        2,
        lambda k, j: in_reduced(from_known(2, k, *((center_left, g1), (center_right, g2))[j])) - center_left[k],
    ),
)

# %% [markdown]
# ## Is the condition of coplanarity one equation more?
#
# **No.**  The equations of each type contain it: multiplied by their denominators they are polynomials, and the
# determinant of base and directions, times divisors, lies in their ideal.  Modulo all but the last equation it is a
# multiple of the last one: the condition may stand for it, unless the projections of both rays into a coordinate plane
# are parallel.  Here $\mathbf u = \mathbf X - \mathbf X_{o1}$ and $\mathbf v = \mathbf u - \mathbf b$.

# %%
u = vector(*sympy.symbols("u1 u2 u3"))
v = u - base
left_by_z = [n1 * u[0] - l1 * u[2], n1 * u[1] - m1 * u[2]]
right_by_z = [n2 * v[0] - l2 * v[2], n2 * v[1] - m2 * v[2]]
same_z = l2 * n1 * u[0] - l1 * l2 * BZ - l1 * n2 * v[0]
same_x = l1 * n2 * u[2] - n1 * n2 * BX - n1 * l2 * v[2]
same_y = m1 * n2 * u[2] - n1 * n2 * BY - n1 * m2 * v[2]
coplanar = dot(base, cross(g1, g2))
types = (
    ("first", [*left_by_z, *right_by_z], n1 * n2, n1 * (l1 * n2 - n1 * l2)),
    ("second", [m1 * u[0] - l1 * u[1], m2 * v[0] - l2 * v[1], same_z], l1 * l2, m1 * l2 - l1 * m2),
    ("third", [same_x, same_y], n1 * n2, l1 * n2 - n1 * l2),
)
intersecting = given((*u, *base, *g1, *g2), (2, 4, 6, 1, 1, 1, 1, 2, 3, 1, 3, 5))
for name, polynomials, divisors, crossing in types:
    *others, last = polynomials
    section.identity(
        f"3/coplanarity#{name}",
        f"the equations of the {name} type contain the condition of coplanarity",
        printed=0,
        derived=divisors * coplanar,
        constraints=polynomials,
        witness=intersecting,
    )
    section.identity(
        f"3/coplanarity#{name}-equivalent",
        f"for the {name} type the condition stands for the last equation",
        printed=crossing * last,
        derived=divisors * coplanar,
        constraints=others,
        witness=intersecting,
    )

# %% [markdown]
# **The witness.**  That the equations can be satisfied is shown by two rays that meet:

# %%
SpaceDrawing(
    "Two rays that meet in P = (2, 4, 6), in the directions (1, 2, 3) and (1, 3, 5), from the centers (0, 0, 0) "
    "and (1, 1, 1).",
    {"C1": vector(0, 0, 0), "C2": base.subs(intersecting), "P": u.subs(intersecting)},
    segments=[("C1", "C2"), ("C1", "P"), ("C2", "P")],
    axes=("X", "Y", "Z"),
)
