# %% [markdown]
# # 9 Five pairs
#
# An essential matrix has five parameters: five pairs of points of calibrated images determine it, but not uniquely.
# How many matrices are there, how does one get base and rotation from them, and how does one know that one has all?

# %%
from itertools import combinations_with_replacement, permutations

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
four = vector(*quaternion)


def products_of(turned: Matrix, scale: Scalar) -> Matrix:
    """Return the products of a multiple of a rotation, which is `scale` times the rotation."""
    (a, b, c), (d, e, f), (g, h, i) = turned.tolist()
    return Matrix(
        [
            [scale + a + e + i, h - f, c - g, d - b],
            [h - f, scale + a - e - i, b + d, c + g],
            [c - g, b + d, scale - a + e - i, f + h],
            [d - b, c + g, f + h, scale - a - e + i],
        ]
    )


section.identity(
    "9/quaternion",
    "the products of the elements of the quaternion",
    printed=(four * four.T).applyfunc(lambda product: over(4 * product, dot(four, four))),
    derived=products_of(rotation, sympy.Integer(1)),
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
# Base and quaternion may be complex.  Then the equations of real pairs have a real part and an imaginary one: set
# $t = \mathrm i$.

# %%
complex_base, complex_four = Matrix(3, 2, sympy.symbols("b:3:2")), Matrix(4, 2, sympy.symbols("q:4:2"))
crossed, crossed_change = (skew(complex_base[:, k]) for k in range(2))
turn_first, turn_second = (scaled_rotation.xreplace(given(quaternion, complex_four[:, k])) for k in range(2))
turn_mixed = mixed_turn.xreplace(given((*quaternion, *four_changed), complex_four.T))
powers = (
    crossed * turn_first,
    crossed * turn_mixed + crossed_change * turn_first,
    crossed * turn_second + crossed_change * turn_mixed,
    crossed_change * turn_second,
)
real_part, imaginary_part = powers[0] - powers[2], powers[1] - powers[3]
t = sympy.Symbol("t")
section.identity(
    "9/parts",
    "base and quaternion with a factor t in their second parts",
    printed=sum((t**k * power for k, power in enumerate(powers)), start=Matrix.zeros(3, 3)),
    derived=skew(complex_base[:, 0] + t * complex_base[:, 1])
    * scaled_rotation.xreplace(given(quaternion, complex_four[:, 0] + t * complex_four[:, 1])),
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
# The coefficients of the cubic equations are linear in each of three matrices.

# %%
three = tuple(Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in "abc")


def terms_of(*matrices: Matrix) -> Matrix:
    """Return the coefficients of the product of three unknowns, by the matrices that they are factors of."""
    orders = list(permutations(matrices))
    volume = sum((triple(a[0, :].T, b[1, :].T, c[2, :].T) for a, b, c in orders), start=sympy.Integer(0))
    total = Matrix.zeros(3, 3)
    for a, b, c in (matrices[k:] + matrices[:k] for k in range(3)):
        both = a * b.T + b * a.T
        total += (2 * both - both.trace() * Matrix.eye(3)) * c
    return vector(volume, *total)


section.identity(
    "9/terms",
    "the cubic equations of a sum of three matrices",
    printed=sum(
        (
            sympy.Rational(len(set(permutations(places))), 6)
            * sympy.prod(unknowns[k] for k in places)
            * terms_of(*(three[k] for k in places))
            for places in combinations_with_replacement(range(3), 3)
        ),
        start=Matrix.zeros(10, 1),
    ),
    derived=cubics_of(sum((t * matrix for t, matrix in zip(unknowns, three, strict=True)), start=Matrix.zeros(3, 3))),
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

given_matrix = Matrix(3, 3, sympy.symbols("e:3:3"))
of_matrix = {"E": "Essential matrix, of any scale."}
given_gram = given_matrix * given_matrix.T
EXAMPLE_E = (("-0.5", "-2.5", "1"), ("-1.5", "-1", "-2"), ("1", "0.5", "-1.5"))
section.kernel(
    "minimal.base_products",
    "The products of the elements of the base of an essential matrix.",
    arguments={"E": given_matrix},
    describe=of_matrix,
    derived=given_gram.trace() / 2 * Matrix.eye(3) - given_gram,
    claims=["9/base"],
    example={"E": EXAMPLE_E},
)
section.kernel(
    "minimal.quaternion_products",
    "The products of the elements of the quaternion of an essential matrix and its base, up to a factor.",
    arguments={"E": given_matrix, "b": base},
    describe=of_matrix | {"b": "Base in the system of the left image, of the scale of E."},
    derived=products_of(adjugate(given_matrix).T - skew(base) * given_matrix, length2),
    claims=["9/rotation", "9/quaternion"],
    example={"E": EXAMPLE_E, "b": ("1", "-0.5", "2")},
)
section.kernel(
    "minimal.cubic_terms",
    "Coefficients of x y z in the determinant and 2 E E^T E - tr(E E^T) E, row by row, for E = x A + y B + z C.",
    arguments=dict(zip("ABC", three, strict=True)),
    describe=dict.fromkeys("ABC", "Any matrix."),
    derived=terms_of(*three),
    claims=["9/terms"],
    example={
        "A": (("2", "0", "-1"), ("-1", "0", "0"), ("-1", "0", "0")),
        "B": (("2", "0", "0"), ("0", "1", "0"), ("0", "0", "0")),
        "C": (("0", "1", "0"), ("0", "0", "0"), ("0", "0", "0")),
    },
)


# %% [markdown]
# The test of a solution takes a complex matrix, its derivatives, and what five pairs leave of their equations.

# %%
Parts = tuple[Matrix, Matrix]
both_parts = Matrix([*zip(real_part, imaginary_part, strict=True)])
change_base, change_four = Matrix(3, 2, sympy.symbols("p:3:2")), Matrix(4, 2, sympy.symbols("r:4:2"))
images_left, images_right = (Matrix(5, 2, sympy.symbols(f"{name}:5:2")) for name in "uv")


def product_of(first: Parts, second: Parts) -> Parts:
    """Return the product of two complex matrices."""
    return first[0] * second[0] - first[1] * second[1], first[0] * second[1] + first[1] * second[0]


def mixed(first: Matrix, second: Matrix) -> Matrix:
    return mixed_turn.xreplace(given((*quaternion, *four_changed), (*first, *second)))


def shortened(name: str, matrix: Matrix) -> tuple[Matrix, dict[sympy.Symbol, Scalar]]:
    """Return a matrix of abbreviations, and what they stand for."""
    symbols = Matrix(3, 3, sympy.symbols(f"{name}:3:3"))
    return symbols, given(symbols, matrix)


def left_by_pairs(matrices: Parts) -> Matrix:
    """Return what five pairs leave of the condition, in a column for each part."""
    rays = [(vector(*images_left[k, :], 1), vector(*images_right[k, :], 1)) for k in range(5)]
    return Matrix([[dot(u, matrix * v) for matrix in matrices] for u, v in rays])


turned, where_turned = zip(shortened("c", turn_first - turn_second), shortened("d", turn_mixed), strict=True)
found, where_found = zip(
    *(shortened(name, part) for name, part in zip("ef", product_of((crossed, crossed_change), turned), strict=True)),
    strict=True,
)
of_complex = {"b": "Base, real parts and imaginary ones; any unit.", "q": "Quaternion, real parts and imaginary ones."}
AT_COMPLEX = {
    "b": (("1", "0.5"), ("-0.5", "1"), ("2", "-1")),
    "q": (("3", "1"), ("1", "0"), ("-2", "0.5"), ("0.5", "-1")),
}
section.kernel(
    "minimal.conditions",
    "Essential matrix of a complex base and quaternion, and what five pairs leave of the condition u'^T E u'' = 0.",
    arguments={"b": complex_base, "q": complex_four, "x_left": images_left, "x_right": images_right},
    describe=of_complex
    | {
        "x_left": "Homogeneous points (x, y) of the left image, divided by the principal distance.",
        "x_right": "The same of the right image.",
    },
    derived={"E": both_parts, "rest": left_by_pairs((real_part, imaginary_part))},
    form={"E": Matrix([*zip(*found, strict=True)]), "rest": left_by_pairs(found)},
    where=where_turned[0] | where_turned[1] | where_found[0] | where_found[1],
    claims=["9/parts", "9/expansion"],
    example=AT_COMPLEX
    | {
        "x_left": (("0", "0"), ("0.5", "0.25"), ("-0.5", "0.5"), ("0.25", "-0.5"), ("-0.25", "-0.25")),
        "x_right": (("0.25", "0"), ("0.625", "0.25"), ("-0.25", "0.5"), ("0.375", "-0.5"), ("0.125", "-0.25")),
    },
)

(q_first, q_second), (r_first, r_second) = ([matrix[:, k] for k in range(2)] for matrix in (complex_four, change_four))
change_of_turn = (
    mixed(q_first, r_first) - mixed(q_second, r_second),
    mixed(q_first, r_second) + mixed(q_second, r_first),
)
moving, moved = (
    product_of(tuple(skew(matrix[:, k]) for k in range(2)), turns)
    for matrix, turns in ((change_base, turned), (complex_base, change_of_turn))
)
changes = [*zip(complex_base, change_base, strict=True), *zip(complex_four, change_four, strict=True)]
section.kernel(
    "minimal.differential",
    "Change of the essential matrix of a complex base and quaternion, to the first order.",
    arguments={"b": complex_base, "q": complex_four, "b_change": change_base, "q_change": change_four},
    describe=of_complex
    | {
        "b_change": "Change of the base.",
        "q_change": "Change of the quaternion.",
    },
    derived=both_parts.applyfunc(lambda entry: sum(change * sympy.diff(entry, symbol) for symbol, change in changes)),
    form=Matrix([*zip(*(first + second for first, second in zip(moving, moved, strict=True)), strict=True)]),
    where=where_turned[0] | where_turned[1],
    claims=["9/parts", "9/expansion#difference"],
    example=AT_COMPLEX
    | {
        "b_change": (("0", "1"), ("1", "-0.5"), ("0.5", "2")),
        "q_change": (("1", "-2"), ("0.5", "1"), ("0", "1"), ("1", "0.5")),
    },
)
section.driver("minimal.five_pairs", five_pairs)
