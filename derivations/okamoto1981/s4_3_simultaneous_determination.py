# %% [markdown]
# # 4.3 Simultaneous determination of all orientation unknowns for the usual case
#
# The procedure of section 3, with three remarks on the numbers of parameters.

# %%
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import A_of_nine, nine
from algebroproj_derivations.okamoto1981.s2_2_geometrical_consideration import (
    free_points,
    inner_of,
    ray_matrix,
    seven_ratios,
)
from algebroproj_derivations.okamoto1981.s3_simultaneous_determination import (
    angles_left,
    angles_right,
    center_left,
    center_right,
    cross_with_base,
    left_rotation,
    right_rotation,
)
from algebroproj_derivations.okamoto1981.s4_2_orientation_of_pairs import inner_left, inner_right
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, floor, vector

section = Section("okamoto1981", "4.3", "Simultaneous determination of all orientation unknowns, usual case")

section.count(
    "4.3/nine",
    "a picture has nine independent parameters",
    printed=9,
    derived=A_of_nine,
    variables=nine,
)

# %% [markdown]
# The condition of coplanarity is that of (42), with 18 parameters.

# %%
eighteen = (*angles_left, *center_left, *inner_left, *angles_right, *center_right, *inner_right)
bilinear = (
    ray_matrix(left_rotation, inner_of(inner_left)).T
    * cross_with_base
    * ray_matrix(right_rotation, inner_of(inner_right))
)
seven_of_eighteen = seven_ratios(bilinear)
section.count(
    "4.3/six",
    "the condition of coplanarity has six independent elements",
    printed=6,
    derived=seven_of_eighteen,
    variables=eighteen,
    expect="false",
    instead="4.3/beyond/seven",
    note="The same as 4.2/six, with the parameters of both pictures in the object system.",
    same_as="4.2/six",
)
section.count(
    "4.3/beyond/seven",
    "the condition of coplanarity has seven independent elements",
    printed=7,
    derived=seven_of_eighteen,
    variables=eighteen,
    note="Not in the paper: seven ratios of the elements of the bilinear form are independent; by "
    "42/beyond/determinant the eighth follows from them.",
)

# %% [markdown]
# Eleven parameters are left.  Three points give nine equations, so that four are needed, as the paper says; their
# twelve equations are one more than needed.

# %%
control_points = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
tie_points = free_points(3)
camera_left = camera(inner_of(inner_left), left_rotation.T, center_left)
camera_right = camera(inner_of(inner_right), right_rotation.T, center_right)


def images(points: list[Matrix]) -> Matrix:
    return Matrix.vstack(*(image(matrix, p) for p in points for matrix in (camera_left, camera_right)))


determined = rates_of_equations(images([*control_points, *tie_points]), eighteen, tie_points)
of_three_points = Matrix.vstack(
    seven_of_eighteen, *(vector(*image(camera_left, p), image(camera_right, p)[0]) for p in control_points[:3])
)
section.rank(
    "4.3/beyond/four-points",
    "four points and three further pairs determine the eighteen parameters",
    printed=18,
    derived=determined,
    note="Not in the paper: seven pairs, four of them of given points.  Local, as 2.1/twenty-two.",
)
section.count(
    "4.3/beyond/three-points",
    "three points leave two parameters open, however many pairs there are",
    printed=16,
    derived=of_three_points,
    variables=eighteen,
    note="Not in the paper: the condition of coplanarity, which is the same for all pairs, and three further equations "
    "for each of three given points.",
)
section.identity(
    "4.3/four-points",
    "the number of points that are necessary",
    printed=4,
    derived=-floor(-sympy.Rational(len(eighteen) - len(seven_of_eighteen), 3)),
    note="Eleven parameters are left, and a point gives three equations.  Four are sufficient, 4.3/beyond/four-points, "
    "and three are not, 4.3/beyond/three-points.",
)
