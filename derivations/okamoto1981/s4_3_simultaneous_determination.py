# %% [markdown]
# # 4.3 Simultaneous determination of all orientation unknowns for the usual case
#
# The procedure of section 3, with 18 parameters in place of 22.  How many points does it need now?

# %%
from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import A_of_nine, nine
from algebroproj_derivations.okamoto1981.s2_2_geometrical_consideration import (
    free_points,
    inner_of,
    seven_ratios,
)
from algebroproj_derivations.okamoto1981.s3_simultaneous_determination import (
    angles_left,
    angles_right,
    bilinear_of,
    center_left,
    center_right,
    images_by,
    left_rotation,
    right_rotation,
)
from algebroproj_derivations.okamoto1981.s4_2_orientation_of_pairs import inner_left, inner_right
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, floor, vector

section = Section("okamoto1981", "4.3", "Simultaneous determination of all orientation unknowns, usual case")

# %% [markdown]
# Each picture has nine parameters, as in section 4.1.

# %%
section.count(
    "4.3/nine",
    "a picture has nine independent parameters",
    derived=A_of_nine,
    variables=nine,
)

# %% [markdown]
# ## How many of 18 does the condition of coplanarity determine?
#
# **Definition.**  The condition is that of (42).  **Print.**  Six, as in section 4.2; and again it is seven.

# %%
eighteen = (*angles_left, *center_left, *inner_left, *angles_right, *center_right, *inner_right)
seven_of_eighteen = seven_ratios(bilinear_of(inner_of(inner_left), inner_of(inner_right)))
section.count(
    "4.3/six",
    "the condition of coplanarity has six independent elements",
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
)

# %% [markdown]
# ## How many control points are needed?
#
# Eleven parameters are left.  A point gives three equations, so that four are needed, as the paper says.  Their twelve
# equations are one more than needed.  Four are also enough: seven pairs, four of them of given points, determine all.

# %%
control_points = [vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
tie_points = free_points(3)
cameras = (
    camera(inner_of(inner_left), left_rotation.T, center_left),
    camera(inner_of(inner_right), right_rotation.T, center_right),
)
determined = rates_of_equations(images_by(cameras, [*control_points, *tie_points]), eighteen, tie_points)
section.rank(
    "4.3/beyond/four-points",
    "four points and three further pairs determine the eighteen parameters",
    printed=18,
    derived=determined,
)

# %%
CENTERS = {"C1": vector(0, 0, 4), "C2": vector(2, 0, 4)}
CONTROL = {f"G{k}": place for k, place in enumerate(control_points)}
TIES = {"1": vector(1, 1, 0), "2": vector(2, 1, 1), "3": vector(2, 0, 0)}
SpaceDrawing(
    "Two centers, four given points G and three further ones.  Every point is seen from both centers.",
    CENTERS | CONTROL | TIES,
    segments=[(center, name) for center in CENTERS for name in CONTROL | TIES],
    axes=("X", "Y", "Z"),
)

# %% [markdown]
# Three are not: with the condition of coplanarity, which is the same for however many pairs, and three further
# equations for each point, two parameters stay open.

# %%
of_three_points = Matrix.vstack(
    seven_of_eighteen, *(vector(*image(cameras[0], p), image(cameras[1], p)[0]) for p in control_points[:3])
)
section.count(
    "4.3/beyond/three-points",
    "three points leave two parameters open, however many pairs there are",
    printed=16,
    derived=of_three_points,
    variables=eighteen,
)

# %% [markdown]
# **Print.**  Four points.

# %%
section.identity(
    "4.3/four-points",
    "the number of points that are necessary",
    printed=4,
    derived=-floor(-sympy.Rational(len(eighteen) - len(seven_of_eighteen), 3)),
)
