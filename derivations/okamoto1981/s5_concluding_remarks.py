# %% [markdown]
# # 5 Concluding remarks
#
# The remarks repeat the numbers of the sections before.  They are judged again, from the same expressions; two are new,
# on triplets of photographs and on calibration.

# %%
from itertools import combinations

import sympy

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import A_of_eleven, eleven, of_angles
from algebroproj_derivations.okamoto1981.s1_2_space_correspondence import B, images_of_five
from algebroproj_derivations.okamoto1981.s2_1_algebraic_consideration import both, ratios
from algebroproj_derivations.okamoto1981.s2_2_geometrical_consideration import (
    angles_left,
    angles_right,
    equations_of_fifteen,
    fifteen,
    followed_by_similarities,
    free_points,
    inner_of,
    left_rotation,
    mapped_ratios,
    ratios_to_first,
    right_rotation,
    seven,
    squared_distances,
    unit_base,
)
from algebroproj_derivations.okamoto1981.s4_2_orientation_of_pairs import (
    common,
    distortion,
    equations_of,
    images_of_four,
    seven_of_eleven,
    twelve,
)
from algebroproj_derivations.okamoto1981.s4_2_orientation_of_pairs import eleven as eleven_of_pair
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, vector

section = Section("okamoto1981", "5", "Concluding remarks")

# %% [markdown]
# ## The general case
#
# Eleven elements of a photograph (1.1), seven parameters of a stereo model (2.1; the eighth ratio depends on the
# seven), fifteen of the correspondence, which five points determine (1.2), and $15 = 8 + 7$ (2.2).

# %%
section.count(
    "5/eleven",
    "a photograph has eleven independent orientation elements",
    derived=A_of_eleven,
    variables=eleven,
)
section.count(
    "5/seven",
    "the stereo model is constructed with seven independent parameters",
    derived=ratios[1:, :],
    variables=both,
)
section.count(
    "5/five-points",
    "five points determine the general correspondence",
    printed=15,
    derived=images_of_five,
    variables=B,
)
section.count(
    "5/divided",
    "the general correspondence is divided into the similarity condition and a similarity",
    printed=8,
    derived=mapped_ratios,
    variables=B,
    kernel=followed_by_similarities,
)

# %% [markdown]
# ## The usual case
#
# Six is seven, and the correspondence is not of the form (54): section 4.2.

# %%
section.count(
    "5/six",
    "in the usual case the condition of coplanarity has six independent elements",
    derived=seven_of_eleven,
    variables=eleven_of_pair,
    expect="false",
    instead="4.2/beyond/seven",
    note="The same as 4.2/six.",
    same_as="4.2/six",
)
section.identity(
    "5/correspondence",
    "in the usual case model and object correspond in the form (54)",
    printed=vector(0, 0),
    derived=distortion,
    expect="false",
    instead="4.2/beyond/eleven",
    note="The same as 4.2/correspondence.  That four points determine the correspondence is true of the one there is "
    "as well: 4.3/four-points.",
    same_as="4.2/correspondence",
)
section.count(
    "5/divided-usual",
    "the correspondence of twelve parameters is divided into the similarity condition and a similarity",
    printed=5,
    derived=ratios_to_first(squared_distances(images_of_four)),
    variables=twelve,
    note="Favourable reading, that of 55#twelve: 12 = 5 + 7.  The one that there is has 11 = 4 + 7 parameters, "
    "4.2/beyond/seven-and-four.",
)

# %% [markdown]
# ## Can three photographs calibrate their camera?
#
# **Definition.**  Three photographs of one camera.  Unknown are its three elements of interior orientation, five
# exterior elements of the second and six of the third photograph; the base to the second is the unit of length.
#
# **Derivation.**  Five points, of unknown coordinates, have $3 \cdot 10$ image coordinates.  Less 15 coordinates of
# points these are fifteen equations for the fourteen parameters, and their rates have full rank.

# %%
third_angles, third_center = sympy.symbols("t_phi3 t_omega3 t_kappa3"), vector(*sympy.symbols("Xo3 Yo3 Zo3"))
triplet = [
    camera(inner_of(common), turned.T, place)
    for turned, place in (
        (left_rotation, vector(0, 0, 0)),
        (right_rotation, unit_base),
        (of_angles(*third_angles), third_center),
    )
]
tie_points = free_points(5)
of_triplet = (*angles_left, *angles_right, *third_angles, *third_center, *common)
section.rank(
    "5/triplet",
    "a triplet determines its model and a common interior orientation",
    printed=len(of_triplet),
    derived=rates_of_equations(
        Matrix.vstack(*(image(matrix, p) for p in tie_points for matrix in triplet)), of_triplet, tie_points
    ),
)

# %% [markdown]
# ## Can distances alone calibrate?
#
# **Definition.**  The conditions of similarity know nothing of the object but ratios of distances.  **Print.**  With
# the conditions of coplanarity they determine all parameters of the model, the interior orientation among them: seven
# pairs, and the ratios of six distances of four points, or in the general case of nine distances of five points.


# %%
PLACES = {"1": vector(0, 0, 0), "2": vector(2, 0, 0), "3": vector(0, 2, 0), "4": vector(2, 2, 0), "5": vector(1, 1, 2)}
SpaceDrawing(
    "Five points have ten distances.  The first nine are used; the tenth, of 4 and 5, is left out, as in section 2.2.",
    PLACES,
    segments=list(combinations(PLACES, 2))[:9],
    axes=("X", "Y", "Z"),
)

# %%
section.rank(
    "5/calibration",
    "in the usual case distances alone determine the interior orientation",
    printed=len(eleven_of_pair),
    derived=equations_of(7, 5),
)
section.rank(
    "5/calibration#general",
    "in the general case distances alone determine the interior orientation",
    printed=len(fifteen),
    derived=rates_of_equations(equations_of_fifteen, fifteen, seven),
)

# %% [markdown]
# **Meaning.**  All these counts are local, as in 2.1/twenty-two.  An iteration that begins near the solution finds it.
