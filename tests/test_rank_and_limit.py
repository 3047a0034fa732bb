"""The kinds rank and limit."""

import pytest
import sympy

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError, judge
from algebroproj_sym.expressions import Matrix, over, vector

a, b, c, eps = sympy.symbols("a b c eps")
both_engines = pytest.mark.parametrize("engine", ["flint", "sympy"])


def verdict(claim, engine="flint"):
    return judge(claim, engine).verdict


def section():
    return Section("demo", "1", "Demo")


@both_engines
def test_a_skew_symmetric_matrix_of_order_3_has_rank_2(engine):
    skew = Matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]])
    assert verdict(section().rank("1.1", "skew", printed=2, derived=skew, kernel=[vector(a, b, c)]), engine) == "proved"


def test_a_rank_that_is_too_small_is_refuted_by_a_point():
    judgement = judge(section().rank("1.1", "diagonal", printed=1, derived=Matrix([[a, 0], [0, b]])))
    assert judgement.verdict == "false"
    assert all(value != 0 for value in judgement.counterexample.values())


def test_a_rank_that_is_too_large_is_refuted_by_kernel_vectors():
    matrix = Matrix([[a, b], [2 * a, 2 * b]])
    claim = section().rank("1.1", "proportional rows", printed=2, derived=matrix, kernel=[vector(b, -a)])
    assert verdict(claim) == "false"


def test_without_enough_kernel_vectors_the_rank_stays_open():
    matrix = Matrix([[a, b], [2 * a, 2 * b]])
    assert verdict(section().rank("1.1", "proportional rows", printed=1, derived=matrix)) == "open"
    wrong = section().rank("1.2", "no kernel vector", printed=1, derived=matrix, kernel=[vector(a, b)])
    assert verdict(wrong) == "open"
    repeated = [vector(0, b, -a), vector(0, 2 * b, -2 * a)]
    three = Matrix([[0, a, b], [0, a, b], [0, a, b]])
    assert verdict(section().rank("1.3", "dependent vectors", printed=1, derived=three, kernel=repeated)) == "open"


def test_a_scalar_has_no_rank():
    with pytest.raises(DeclarationError):
        judge(section().rank("1.1", "t", printed=1, derived=a))


@both_engines
def test_limits_by_leading_coefficients(engine):
    expression = over(a * eps + b * eps**2, c * eps - eps**3)
    assert (
        verdict(section().limit("1.1", "quotient", printed=a / c, derived=expression, variable=eps), engine) == "proved"
    )
    vanishing = vector(eps * a, over(eps**2, eps))
    assert (
        verdict(section().limit("1.2", "zero", printed=vector(0, 0), derived=vanishing, variable=eps), engine)
        == "proved"
    )


def test_a_wrong_limit_is_refuted():
    claim = section().limit("1.1", "wrong", printed=b / c, derived=over(a + eps, c), variable=eps)
    assert verdict(claim) == "false"


def test_a_divergent_expression_has_no_limit():
    assert verdict(section().limit("1.1", "pole", printed=a, derived=over(a, eps), variable=eps)) == "false"


def test_the_hypotheses_of_a_limit_do_not_contain_its_variable():
    judgement = judge(section().limit("1.1", "quotient", printed=a / c, derived=over(a * eps, c * eps), variable=eps))
    assert judgement.hypotheses == (c,)


def test_a_limit_needs_its_variable():
    with pytest.raises(DeclarationError, match="variable"):
        judge(section().limit("1.1", "no variable", printed=a, derived=a))
