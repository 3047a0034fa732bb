# %% [markdown]
# # 4.1 The usual case in close-range photogrammetry
#
# Usually the plane of the comparator is parallel to the picture.  Its axes are those of the picture, and the
# inclinations are gone.  What becomes of the eleven coefficients?

# %%
import sympy

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import given, inserted
from algebroproj_derivations.okamoto1981.notation import *
from algebroproj_derivations.okamoto1981.s1_1_general_collinearity import A_of_nine, d, e, in_comparator, nine
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, Scalar, cross, dot, vector

section = Section("okamoto1981", "4.1", "The usual case in close-range photogrammetry")

# %% [markdown]
# ## What is measured?
#
# **Definition.**  The picture point in the system of the comparator, with the unit matrix for the three rotations:
# parallel planes leave a rotation $\gamma$ about the common normal, which is zero as in 1.1/gamma.

# %%
measured = inserted(in_comparator, d, E3)[:2, :]
measured

# %% [markdown]
# **Print.**

# %%
xh, yh = sympy.symbols("xH yH")
section.identity(
    "49",
    "measured coordinates",
    derived=measured - comparator_center,
)

# %% [markdown]
# The principal point is where $x = y = 0$.  It is measured where the projection center is, and can stand for it.

# %%
of_principal_point = given((xh, yh), inserted(measured, (x, y), (0, 0)))
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

# %% [markdown]
# **An example.**  A picture at the principal distance 2, without rotations, and the ray of the point $P$.

# %%
C, P = vector(0, 0, 3), vector(2, 1, -1)
H, p = C - vector(0, 0, 2), C + (P - C) / 2
FRAME = {f"{k}": H + vector(x, y, 0) for k, (x, y) in enumerate(((-2, -2), (2, -2), (2, 2), (-2, 2)), 1)}
SpaceDrawing(
    "The picture 1234, its center of projection C and the principal point H at the foot of the perpendicular.  The "
    "comparator measures the point p in this plane, from an origin of its own, 1.",
    {"C": C, "H": H, "p": p, "P": P, **FRAME},
    segments=[("C", "H"), ("C", "P"), ("1", "2"), ("2", "3"), ("3", "4"), ("4", "1")],
    axes=("X", "Y", "Z"),
)

# %% [markdown]
# So a picture has nine parameters, all independent, as in section 1.1.

# %%
section.count(
    "4.1/nine",
    "a picture has nine parameters",
    derived=A_of_nine,
    variables=nine,
)

# %% [markdown]
# ## Which matrices belong to such cameras?
#
# Eleven coefficients, nine parameters: two conditions.  **Definition.**  Let $\mathbf q_i$ be the first three elements
# of row $i$ of the matrix of projection.  $\mathbf q_1 \times \mathbf q_3$ and $\mathbf q_2 \times \mathbf q_3$ are the
# directions of the image axes.  They are perpendicular, and of the same length.


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
    witness=given(e, E3),
)
