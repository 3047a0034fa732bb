# %% [markdown]
# # 9 Five pairs
#
# An essential matrix has five parameters: five pairs of points of calibrated images determine it, but not uniquely.
# How many matrices are there, how does one get base and rotation from them, and how does one know that one has all?

# %%
from itertools import combinations_with_replacement

import sympy

from algebroproj_derivations.cameras import skew
from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.five_pairs import five_pairs
from algebroproj_derivations.fundamentals1996.s1_1_projection import quaternion
from algebroproj_derivations.fundamentals1996.s1_1_projection import rotation as scaled_rotation
from algebroproj_derivations.fundamentals1996.s1_4_orthonormalized_systems import rotation
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, Scalar, adjugate, cross, determinant, dot, over, vector

section = Section("bridges", "9", "Five pairs")

# %% [markdown]
# **An example.**  Each pair says that two rays meet: one equation for the direction of the base and the rotation, which
# have five parameters together.

# %%
CENTERS = {"C'": vector(0, 0, 0), "C''": vector(3, 0, 0)}
POINTS = {
    f"P{number}": vector(*place)
    for number, place in enumerate([(0, 1, -4), (1, -1, -3), (2, 1, -3), (3, -1, -4), (4, 1, -5)], start=1)
}
SpaceDrawing(
    "Five points and their rays to both centers.",
    CENTERS | POINTS,
    segments=[("C'", "C''"), *((center, point) for center in CENTERS for point in POINTS)],
    axes=("X_1", "X_2", "X_3"),
)

# %% [markdown]
# ## Base and rotation
#
# **Definition.**  $\mathbf E = [\mathbf b]_\times \mathbf R$ with the base $\mathbf b$ in the left system, and
# $\mathbf R$ from the right system to the left one: $\mathbf u'^T \mathbf E \mathbf u'' = 0$.
#
# **Result.**  The matrix tells the base but for its sign, and each of the two bases one rotation.

# %%
base = vector(*sympy.symbols("b:3"))
essential = skew(base) * rotation
gram = essential * essential.T
length2 = dot(base, base)

section.identity(
    "9/base",
    "the products of the elements of the base",
    printed=base * base.T,
    derived=gram.trace() / 2 * Matrix.eye(3) - gram,
)
section.identity(
    "9/rotation",
    "the rotation of an essential matrix and its base",
    printed=length2 * rotation,
    derived=adjugate(essential).T - skew(base) * essential,
)

# %% [markdown]
# The four products of an element of the quaternion with all, by the elements of the rotation: one column is enough.

# %%
q0, q1, q2, q3 = quaternion
((a, b, c), (d, e, f), (g, h, i)) = rotation.tolist()
products = Matrix(
    [
        [1 + a + e + i, h - f, c - g, d - b],
        [h - f, 1 + a - e - i, b + d, c + g],
        [c - g, b + d, 1 - a + e - i, f + h],
        [d - b, c + g, f + h, 1 - a - e + i],
    ]
)
four = vector(*quaternion)
section.identity(
    "9/quaternion",
    "the products of the elements of the quaternion",
    printed=(four * four.T).applyfunc(lambda product: over(4 * product, dot(four, four))),
    derived=products,
)

# %% [markdown]
# ## A neighbourhood of a solution
#
# Without the division by its length, the quaternion gives a multiple of the rotation, and the equation of a pair is a
# polynomial in base and quaternion.
#
# **Question.**  How far is this polynomial from a linear one?
#
# **Result.**  What is missing is a sum of three triple products, with the part of the rotation that is linear in the
# change of the quaternion, and with the rotation of that change itself.

# %%
four_changed, base_changed = vector(*sympy.symbols("p:4")), vector(*sympy.symbols("a:3"))
left, right = vector(*sympy.symbols("xp yp"), 1), vector(*sympy.symbols("xpp ypp"), 1)
changed = given(vector(*quaternion), four_changed)
together = given(vector(*quaternion), four + four_changed)
turn, turn_of_change, turn_of_sum = (
    scaled_rotation,
    scaled_rotation.xreplace(changed),
    scaled_rotation.xreplace(together),
)
mixed_turn = turn_of_sum - turn - turn_of_change


def triple(first: Matrix, second: Matrix, third: Matrix) -> Scalar:
    return dot(first, cross(second, third))


linear = triple(left, base_changed, turn * right) + triple(left, base, mixed_turn * right)
section.identity(
    "9/expansion",
    "the equation of a pair less its linear part",
    printed=triple(left, base_changed, mixed_turn * right)
    + triple(left, base, turn_of_change * right)
    + triple(left, base_changed, turn_of_change * right),
    derived=triple(left, base + base_changed, turn_of_sum * right) - triple(left, base, turn * right) - linear,
)
section.identity(
    "9/expansion#difference",
    "the part of the rotation that is linear in the change of the quaternion",
    printed=Matrix(
        3,
        3,
        lambda row, column: sum(
            p * sympy.diff(turn[row, column], q) for p, q in zip(four_changed, quaternion, strict=True)
        ),
    ),
    derived=mixed_turn,
)

# %% [markdown]
# ## How many are there?
#
# **Definition.**  Ten cubic equations: the determinant is zero, and 5/trace.  Without the division by its length, the
# quaternion may be complex.
#
# **Question.**  Five pairs leave sums of four matrices.  How many of them satisfy the cubic equations?
#
# **Derivation.**  Take three matrices.  The cubic equations of their sum, with the factors $x, y, z$, are linear in the
# ten products of degree three of $x, y, z$.  If these ten linear equations are independent, no sum satisfies all of
# them.  Add a fourth matrix, times $w$.  Then each product of degree three in $x, y, z$ is a combination of products
# with $w$, and so all polynomials are combinations of the ten products of degree two or less: there are ten solutions
# at most, each counted as often as it is one.
#
# **Result.**  Here are three such matrices.  So essential matrices have degree ten at most.

# %%


def cubics_of(matrix: Matrix) -> Matrix:
    square = matrix * matrix.T
    return vector(determinant(matrix), *(2 * square * matrix - square.trace() * matrix))


section.identity(
    "9/cubics",
    "the cubic equations of base and quaternion",
    printed=Matrix.zeros(10, 1),
    derived=cubics_of(skew(base) * scaled_rotation),
)

EXAMPLE = (
    Matrix([[2, 0, -1], [-1, 0, 0], [-1, 0, 0]]),
    Matrix([[2, 0, 0], [0, 1, 0], [0, 0, 0]]),
    Matrix([[0, 1, 0], [0, 0, 0], [0, 0, 0]]),
)
unknowns = sympy.symbols("x y z")
combined = sum((t * matrix for t, matrix in zip(unknowns, EXAMPLE, strict=True)), start=Matrix.zeros(3, 3))
cubic_products = [sympy.prod(each) for each in combinations_with_replacement(unknowns, 3)]
section.rank(
    "9/degree",
    "no sum of three matrices is essential",
    printed=10,
    derived=Matrix(
        [
            [sympy.Poly(cubic, *unknowns).coeff_monomial(each) for each in cubic_products]
            for cubic in cubics_of(combined)
        ]
    ),
)

# %% [markdown]
# **Meaning.**  Who has ten different solutions, real or complex, each the only one near it, has all.  The real ones
# among them are told by their conjugates.  This is how the function below knows that it has all.

# %%
section.kernel(
    "minimal.essential_matrix",
    "Matrix of correlation of two calibrated images, times the square of the length of the quaternion.",
    arguments={"b": base, "q": four},
    describe={
        "b": "Base in the system of the left image; any unit.",
        "q": "Quaternion of the rotation from the right system to the left one, real part first.",
    },
    derived=skew(base) * scaled_rotation,
    claims=["9/rotation", "9/expansion", "9/cubics"],
    example={"b": ("1", "-0.5", "2"), "q": ("3", "1", "-2", "0.5")},
)
section.driver("minimal.five_pairs", five_pairs)
