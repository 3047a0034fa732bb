"""Linear algebra on matrices of rational expressions."""

import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from algebroproj_sym.expressions import (
    Matrix,
    adjugate,
    columns,
    cross,
    determinant,
    dot,
    homogeneous,
    inverse,
    linear_system,
    minors_of,
    over,
    rows,
    solve,
    vector,
)

x, y, z = sympy.symbols("x y z")
small = st.integers(-6, 6)


def matrices(size, entry=small):
    return st.lists(entry, min_size=size**2, max_size=size**2).map(lambda values: Matrix(size, size, values))


def vectors(size, entry=small):
    return st.lists(entry, min_size=size, max_size=size).map(lambda values: vector(*values))


squares = st.integers(1, 5).flatmap(matrices)
pairs = st.integers(1, 4).flatmap(lambda size: st.tuples(matrices(size), matrices(size)))
systems = st.integers(1, 4).flatmap(lambda size: st.tuples(matrices(size), vectors(size)))
polynomials = st.builds(lambda a, b, c, d: a + b * x + c * y + d * x * y, small, small, small, small)


@given(squares)
def test_the_determinant_is_berkowitz(matrix):
    assert determinant(matrix) == sympy.Matrix(matrix).det(method="berkowitz")


@given(matrices(3, polynomials))
def test_the_determinant_of_polynomials_is_berkowitz(matrix):
    assert sympy.expand(determinant(matrix) - sympy.Matrix(matrix).det(method="berkowitz")) == 0


@given(pairs)
def test_the_determinant_is_multiplicative(pair):
    a, b = pair
    assert determinant(a * b) == determinant(a) * determinant(b)


@given(squares)
def test_the_determinant_of_the_transpose_is_the_same(matrix):
    assert determinant(matrix.T) == determinant(matrix)


@given(matrices(4), st.permutations(range(4)))
def test_the_determinant_is_alternating(matrix, order):
    sign = sympy.combinatorics.Permutation(list(order)).signature()
    assert determinant(Matrix(4, 4, lambda i, j: matrix[order[i], j])) == sign * determinant(matrix)


def test_the_determinant_of_no_rows_is_one():
    assert determinant(Matrix(0, 0, [])) == 1


@pytest.mark.parametrize("shape", [(1, 2), (2, 1), (3, 2), (0, 1)])
def test_a_matrix_that_is_not_square_has_no_determinant(shape):
    with pytest.raises(ValueError, match="expected a square matrix, got shape"):
        determinant(Matrix.zeros(*shape))


@given(squares)
def test_the_adjugate_times_the_matrix_is_the_determinant(matrix):
    size = matrix.shape[0]
    scaled = sympy.eye(size) * sympy.Matrix(matrix).det(method="berkowitz")
    assert matrix * adjugate(matrix) == scaled
    assert adjugate(matrix) * matrix == scaled


@pytest.mark.parametrize("shape", [(2, 3), (3, 2)])
def test_a_matrix_that_is_not_square_has_no_adjugate_and_no_inverse(shape):
    with pytest.raises(ValueError, match="square"):
        adjugate(Matrix.ones(*shape))
    with pytest.raises(ValueError, match="square"):
        inverse(Matrix.ones(*shape))


@given(matrices(3, polynomials), st.fractions(-5, 5, max_denominator=5), st.fractions(-5, 5, max_denominator=5))
def test_the_inverse_times_the_matrix_is_the_unit_matrix_at_points(matrix, a, b):
    point = {x: sympy.Rational(a.numerator, a.denominator), y: sympy.Rational(b.numerator, b.denominator)}
    there = matrix.subs(point)
    assume(sympy.Matrix(there).det(method="berkowitz") != 0)
    inverted = inverse(matrix).subs(point).doit()
    assert there * inverted == sympy.eye(3)
    assert inverted * there == sympy.eye(3)


@given(matrices(3), small, small)
def test_the_inverse_of_a_singular_matrix_is_refused(matrix, a, b):
    dependent = columns(matrix[:, 0], matrix[:, 1], a * matrix[:, 0] + b * matrix[:, 1])
    with pytest.raises(ZeroDivisionError):
        inverse(dependent)


def test_the_inverse_divides_every_entry_by_the_determinant():
    inverted = inverse(Matrix([[x, 0], [0, x]]))
    assert {entry.args[1] for entry in inverted.atoms(over)} == {x**2}
    assert all(isinstance(entry, over) for entry in inverted)


@given(systems)
def test_the_solution_satisfies_the_system(system):
    matrix, right_side = system
    assume(sympy.Matrix(matrix).det(method="berkowitz") != 0)
    assert matrix * solve(matrix, right_side).doit() == right_side


@given(matrices(2, polynomials), vectors(2, polynomials))
@settings(max_examples=10)
def test_the_solution_satisfies_a_system_of_polynomials(matrix, right_side):
    assume(sympy.expand(sympy.Matrix(matrix).det(method="berkowitz")) != 0)
    residual = matrix * solve(matrix, right_side).doit() - right_side
    assert residual.applyfunc(sympy.cancel) == sympy.zeros(2, 1)


def test_a_singular_system_is_refused():
    with pytest.raises(ZeroDivisionError):
        solve(Matrix([[1, 2], [2, 4]]), vector(1, 2))


@pytest.mark.parametrize("count", [1, 3])
def test_a_right_side_of_another_size_is_refused(count):
    with pytest.raises(ValueError, match=f"right side of 2 entries, got {count}"):
        solve(Matrix([[1, 2], [3, 4]]), vector(*range(count)))


@given(matrices(3), vectors(3))
def test_a_linear_system_is_read_from_its_equations(matrix, right_side):
    unknowns = vector(x, y, z)
    assert linear_system(list(matrix * unknowns - right_side), [x, y, z]) == (matrix, right_side)


def test_coefficients_of_a_linear_system_may_hold_parameters_and_divisions():
    a, b = sympy.symbols("a b")
    matrix, right_side = linear_system([over(x, a) + b * y - over(a, b), (a + 1) * x - y], [x, y])
    assert matrix.doit() == Matrix([[1 / a, b], [a + 1, -1]])
    assert right_side.doit() == vector(a / b, 0)


@pytest.mark.parametrize("equation", [x * y, x**2 - 1, over(1, x), over(y, x + y), (x + 1) ** 3])
def test_equations_that_are_not_linear_are_refused(equation):
    with pytest.raises(ValueError, match="linear"):
        linear_system([equation, x - y], [x, y])


@given(vectors(3), vectors(3))
def test_the_cross_product_is_that_of_sympy(a, b):
    assert cross(a, b) == sympy.Matrix(a).cross(sympy.Matrix(b))


@given(vectors(3), vectors(3))
def test_the_cross_product_is_orthogonal_and_as_long_as_the_area(a, b):
    product = cross(a, b)
    assert dot(a, product) == dot(b, product) == 0
    assert dot(product, product) == dot(a, a) * dot(b, b) - dot(a, b) ** 2


@pytest.mark.parametrize("size", [2, 4])
def test_the_cross_product_needs_three_components(size):
    with pytest.raises(ValueError, match="3 components"):
        cross(vector(1, 2, 3), vector(*range(size)))


@given(st.integers(0, 5).flatmap(lambda size: st.tuples(vectors(size), vectors(size))))
def test_the_scalar_product_is_the_sum_of_products(pair):
    a, b = pair
    assert dot(a, b) == sum(int(p) * int(q) for p, q in zip(list(a), list(b), strict=True))


def test_the_scalar_product_needs_vectors_of_one_length():
    with pytest.raises(ValueError, match="zip"):
        dot(vector(1, 2), vector(1, 2, 3))


def test_vectors_columns_and_rows():
    assert vector(x, y).shape == (2, 1)
    assert columns(vector(x, y), vector(1, 2)) == Matrix([[x, 1], [y, 2]])
    assert rows(vector(x, y), vector(1, 2)) == Matrix([[x, y], [1, 2]])
    assert homogeneous(vector(x, y)) == vector(1, x, y)


@given(st.fractions(-5, 5, max_denominator=5))
def test_entries_may_be_exact_fractions(a):
    assert determinant(Matrix([[a, 1], [1, a]])) == a**2 - 1


@given(squares)
def test_a_matrix_equals_that_of_sympy_and_has_its_hash(matrix):
    other = sympy.ImmutableDenseMatrix(*matrix.shape, matrix.flat())
    assert matrix == other
    assert hash(matrix) == hash(other)


sparse = st.sampled_from([0, 0, 1, -2, x, x + y, over(x, y), 3 * z, sympy.Rational(2, 3)])
shapes = st.tuples(st.integers(0, 4), st.integers(0, 4), st.integers(0, 4))


def filled(draw, rows, columns, entry):
    return Matrix(rows, columns, draw(st.lists(entry, min_size=rows * columns, max_size=rows * columns)))


@given(st.data(), shapes)
def test_a_product_is_letter_by_letter_that_of_sympy(data, sizes):
    a, b, c = sizes
    left, right = filled(data.draw, a, b, sparse), filled(data.draw, b, c, sparse)
    product = left * right
    assert isinstance(product, Matrix)
    assert product == sympy.ImmutableDenseMatrix(a, b, left.flat()) * sympy.ImmutableDenseMatrix(b, c, right.flat())


@pytest.mark.parametrize("infinite", [sympy.zoo, sympy.nan, sympy.oo * x, x + sympy.zoo * y])
def test_zero_times_infinity_is_not_zero_in_a_product(infinite):
    left, right = Matrix([[0, x]]), Matrix([[infinite], [y]])
    assert left * right == Matrix([[sympy.nan]])
    reverse = right.T * left.T
    assert reverse == Matrix([[sympy.nan]])


affine = st.recursive(
    st.sampled_from([x, y, z, sympy.Integer(2), over(y, z), (y + z) ** 2, over(x, y + z), over(1, x)]),
    lambda part: st.tuples(part, part).flatmap(lambda pair: st.sampled_from([pair[0] + pair[1], pair[0] * pair[1]])),
    max_leaves=8,
)


@given(affine)
def test_coefficients_of_unknowns_are_letter_by_letter_derivatives(expression):
    derivative = sympy.diff(expression, x)
    assume(x not in derivative.free_symbols)
    matrix, _ = linear_system([expression], [x])
    assert matrix == Matrix([[derivative]])


@given(matrices(4, polynomials), st.sets(st.integers(0, 3), min_size=2, max_size=2), st.permutations(range(4)))
def test_minors_are_determinants_of_parts(matrix, rows, columns):
    chosen = tuple(sorted(rows)), tuple(columns[:2])
    part = sympy.Matrix(2, 2, lambda i, j: matrix[chosen[0][i], chosen[1][j]])
    assert sympy.expand(minors_of(matrix)(*chosen) - part.det(method="berkowitz")) == 0


@given(matrices(3))
def test_minors_of_numbers_are_those_of_symbols_with_these_values(matrix):
    symbols = Matrix(3, 3, sympy.symbols("a:3:3"))
    expanded = minors_of(symbols)((0, 2), (2, 1)).xreplace(dict(zip(symbols, matrix, strict=True)))
    assert minors_of(matrix)((0, 2), (2, 1)) == expanded


def test_a_zero_minor_does_not_hide_an_infinite_entry():
    assert determinant(Matrix([[sympy.zoo, x], [y, 0]])) is sympy.nan
    assert dot(vector(sympy.zoo, x), vector(0, y)) is sympy.nan


def test_only_square_systems_are_solved():
    with pytest.raises(ValueError, match="expected a square matrix"):
        solve(Matrix([[x, y]]), vector(z))


def test_columns_of_different_heights_are_refused():
    with pytest.raises(ValueError, match="expected parts of equal height"):
        columns(vector(x), vector(x, y))


@given(st.integers(1, 3), st.integers(1, 3), st.booleans())
def test_entries_are_listed_as_sympy_lists_them(height, width, symbolic):
    entries = sympy.symbols(f"a:{height * width}") if symbolic else range(height * width)
    ours, sympys = (kind(height, width, list(entries)) for kind in (Matrix, sympy.ImmutableDenseMatrix))
    assert [*ours] == [*sympys]
    assert ours.flat() == sympys.flat()
    assert ours.tolist() == sympys.tolist()
