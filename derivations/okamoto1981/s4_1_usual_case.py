# %% [markdown]
# # 4.1 The usual case in close-range photogrammetry
#
# The plane of the comparator is parallel to the picture: its axes are those of the picture, and the inclinations are
# gone.

# %%
import sympy

from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import A_of_nine, d, e, in_comparator, nine
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, Scalar, cross, dot, vector

section = Section("okamoto1981", "4.1", "The usual case in close-range photogrammetry")

# %% [markdown]
# ## Measured coordinates

# %%
parallel = dict(zip(d, E3, strict=True))
measured = in_comparator.xreplace(parallel)[:2, :]
xh, yh = sympy.symbols("xH yH")
section.identity(
    "49",
    "measured coordinates",
    derived=measured - comparator_center,
    note="With the unit matrix for the three rotations: parallel planes leave a rotation gamma about the "
    "common normal, which is zero as in 1.1/gamma.",
)
of_principal_point = dict(zip((xh, yh), measured.xreplace({x: sympy.Integer(0), y: sympy.Integer(0)}), strict=True))
section.identity(
    "4.1/principal-point",
    "the principal point is measured where the projection center is",
    printed=comparator_center,
    derived=vector(xh, yh).xreplace(of_principal_point),
)
section.identity(
    "50",
    "measured coordinates, referred to the principal point",
    derived=measured - vector(xh, yh).xreplace(of_principal_point),
)
section.count(
    "4.1/nine",
    "a picture has nine parameters",
    printed=9,
    derived=A_of_nine,
    variables=nine,
    note="All nine are independent, as in 1.1/nine.",
)

# %% [markdown]
# ## The matrices of such cameras
#
# With $\mathbf q_i$ for the first three elements of the rows of the matrix of projection, $\mathbf q_1 \times \mathbf
# q_3$ and $\mathbf q_2 \times \mathbf q_3$ are perpendicular and of the same length: eleven coefficients less two
# conditions.


# %%
def conditions(matrix: Matrix) -> list[Scalar]:
    """Return what vanishes for a camera of nine parameters."""
    q1, q2, q3 = (matrix[i, :3].T for i in range(3))
    first, second = cross(q1, q3), cross(q2, q3)
    return [dot(first, second), dot(first, first) - dot(second, second)]


inner = seen_by_comparator(Matrix.eye(3)[:2, :], c, comparator_center)
orthonormal = [dot(e.row(i).T, e.row(j).T) - int(i == j) for i in range(3) for j in range(i, 3)]
section.identity(
    "4.1/beyond/conditions",
    "two conditions of the matrix of projection",
    printed=vector(0, 0),
    derived=vector(*conditions(camera(inner, e, center))),
    constraints=orthonormal,
    witness=dict(zip(e, E3, strict=True)),
    note="Not in the paper.",
)
