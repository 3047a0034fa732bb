"""Partial derivatives by a letter that is summed, as that of a sum of squares by one of them."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

ENTROPY = r"\[ H = -\sum_i p_i \ln p_i - \lambda (\sum_i p_i - 1). \]"
COST = r"\[ J = \frac12 \sum_{i=1}^n (y_i - \sum_{j=1}^m x_{ij} b_j)^2. \]"
FORM = r"\[ V = \sum_{i=1}^n \sum_{j=1}^n w_i w_j C_{ij} - 2 \sum_{i=1}^n w_i c_i. \]"
NET = r"\[ Q = \frac12 \sum_i e_i^2, \] with \[ e_i = t_i - g_i q. \]"
SHARE = r"\[ s = \frac{\sum_i a_i x_i}{\sum_i x_i}. \]"
UNIT = r"\[ y_k = \sum_j u_{kj} h_j. \]"

NEAR = r"\[ d = \sum_i a (x_i - x)^2. \]"


def verdict(above, claim):
    return read_document(document_of(rf"We have {above} The derivative is \[ {claim}. \]"))[-1].verdict


@pytest.mark.parametrize(
    ("above", "claim"),
    [
        (ENTROPY, r"\frac{\partial H}{\partial p_i} = -\ln p_i - 1 - \lambda"),
        (ENTROPY, r"\frac{\partial H}{\partial p_k} = -\ln p_k - 1 - \lambda"),
        (COST, r"\frac{\partial J}{\partial b_k} = -\sum_{i=1}^n x_{ik} (y_i - \sum_{j=1}^m x_{ij} b_j)"),
        (COST, r"\frac{\partial J}{\partial y_k} = y_k - \sum_{j=1}^m x_{kj} b_j"),
        (FORM, r"\frac{\partial V}{\partial w_i} = \sum_{j=1}^n w_j C_{ij} + \sum_{j=1}^n w_j C_{ji} - 2 c_i"),
        (FORM, r"\frac{\partial V}{\partial w_k} = \sum_{j=1}^n w_j C_{kj} + \sum_{i=1}^n w_i C_{ik} - 2 c_k"),
        (NET, r"\frac{\partial Q}{\partial g_i} = -q e_i"),
        (SHARE, r"\frac{\partial s}{\partial x_k} = \frac{a_k - s}{\sum_i x_i}"),
        (UNIT, r"\frac{\partial y_k}{\partial u_{kj}} = h_j"),
        (NEAR, r"\frac{\partial d}{\partial x} = -2 \sum_i a (x_i - x)"),
    ],
)
def test_a_partial_derivative_by_a_summed_letter_follows(above, claim):
    assert verdict(above, claim) == "follows"


@pytest.mark.parametrize(
    ("above", "claim"),
    [
        (ENTROPY, r"\frac{\partial H}{\partial p_i} = -\sum_i \ln p_i - 1 - \lambda"),
        (ENTROPY, r"\frac{\partial H}{\partial p_k} = -\ln p_i - 1 - \lambda"),
        (ENTROPY, r"\frac{\partial H}{\partial p_0} = -\ln p_0 - 1 - \lambda"),
        (ENTROPY, r"\frac{d H}{d p_i} = -\ln p_i - 1 - \lambda"),
        (
            ENTROPY + r" and $\lambda = p_1 + p_2$, \[ \lambda = \sum_i p_i. \]",
            r"\frac{\partial H}{\partial p_i} = -\ln p_i - 1 - \lambda",
        ),
        (FORM, r"\frac{\partial V}{\partial w_k} = \sum_{j=1}^n w_j C_{kj} - 2 c_k"),
        (FORM, r"\frac{\partial V}{\partial w_k} = 2 \sum_{j=1}^n w_j C_{kj} - 2 c_k"),
        (NET, r"\frac{\partial Q}{\partial g_i} = -e_i"),
        (NET.replace("e_i^2", "e_j^2").replace(r"\sum_i", r"\sum_j"), r"\frac{\partial Q}{\partial g_k} = 0"),
        (r"\[ E = \sum_{i \neq 2} w_i x_i. \]", r"\frac{\partial E}{\partial w_k} = x_k"),
        (r"\[ E = \sum_{i=1}^n w_i w_{i+1}. \]", r"\frac{\partial E}{\partial w_k} = w_{k+1}"),
        (r"\[ E = \sum_{i=1}^n \sum_{j=1}^i w_j. \]", r"\frac{\partial E}{\partial w_k} = n"),
        (r"\[ E = \sum_{i=1}^n \sum_{j=1}^n w_{ij} x_j. \]", r"\frac{\partial E}{\partial w_{kj}} = n x_j"),
        (r"\[ c = 2 a_i. \] \[ E = \sum_i w_i c. \]", r"\frac{\partial E}{\partial w_k} = c"),
        (r"\[ E = \sum_i w_i f(w_i). \]", r"\frac{\partial E}{\partial w_k} = f(w_k)"),
        (UNIT, r"\frac{\partial y_k}{\partial u_{ij}} = h_j"),
        (r"\[ d = \sum_i a x_i + x. \]", r"\frac{\partial d}{\partial x} = 1"),
        (r"\[ e_i = t - w_i. \] \[ L = \sum_i w_i e_i. \]", r"\frac{\partial L}{\partial w_i} = e_i - w_i"),
        (r"\[ x_i = x + c_i. \]" + NEAR, r"\frac{\partial d}{\partial x} = -2 \sum_i a (x_i - x)"),
    ],
)
def test_nothing_follows_where_another_letter_may_be_summed(above, claim):
    assert verdict(above, claim) in ("independent", "not decided")
