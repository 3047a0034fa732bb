"""Sums of products of vectors: what does not depend on the index stands before and behind them, and their gradients."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

SQUARES = r"\[ f = \sum_i (y_i - \mathbf{a}_i^T \mathbf{x})^2 \] "
POINTS = r"\[ f = \sum_{i=1}^n \| \mathbf{q}_i - \mathbf{R} \mathbf{p}_i - \mathbf{t} \|^2 \] "
CENTRED = (
    r"\[ \bar{\mathbf{p}} = \frac{1}{n} \sum_{i=1}^n \mathbf{p}_i \] "
    r"\[ \mathbf{p}_i' = \mathbf{p}_i - \bar{\mathbf{p}} \] "
)
OUTER = r"\[ C = \sum_i \mathbf{a}_i \mathbf{a}_i^T \] "
MIXED = r"\[ f = \sum_i (\mathbf{a}_i^T \mathbf{x}) (\mathbf{b}_i^T \mathbf{y}) \] "
SPREAD = r"\[ \mathbf{S} = \sum_i w_i \mathbf{x}_i \mathbf{x}_i^T \] \[ \mathbf{x}_i = \mathbf{R} \mathbf{y}_i \] "


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (SQUARES + r"\[ \nabla_{\mathbf x} f = -2 \sum_i (y_i - \mathbf{a}_i^T \mathbf{x}) \mathbf{a}_i \]", True),
        (SQUARES + r"\[ \nabla_{\mathbf x} f = 2 \sum_i (y_i - \mathbf{a}_i^T \mathbf{x}) \mathbf{a}_i \]", False),
        (SQUARES + r"\[ \nabla_{\mathbf x} f = -2 \sum_i (y_i + \mathbf{a}_i^T \mathbf{x}) \mathbf{a}_i \]", False),
        (
            SQUARES + r"\[ f = \sum_i y_i^2 - 2 \sum_i y_i \mathbf{a}_i^T \mathbf{x} "
            r"+ \mathbf{x}^T \left( \sum_i \mathbf{a}_i \mathbf{a}_i^T \right) \mathbf{x} \]",
            True,
        ),
        (
            POINTS + r"\[ \frac{\partial f}{\partial \mathbf{t}} = "
            r"-2 \sum_{i=1}^n (\mathbf{q}_i - \mathbf{R} \mathbf{p}_i - \mathbf{t}) \] Setting the gradient to zero "
            r"gives \[ \mathbf{t} = \frac{1}{n} \sum_{i=1}^n \mathbf{q}_i "
            r"- \mathbf{R} \frac{1}{n} \sum_{i=1}^n \mathbf{p}_i \]",
            True,
        ),
        (CENTRED + r"\[ \sum_{i=1}^n \mathbf{p}_i' = \mathbf{0} \]", True),
        (CENTRED + r"\[ \sum_{i=0}^n \mathbf{p}_i' = \mathbf{0} \]", False),
        (OUTER + r"Hence \[ C^T = C \]", True),
        (OUTER.replace(r"\mathbf{a}_i^T", r"\mathbf{b}_i^T") + r"Hence \[ C^T = C \]", False),
        (MIXED + r"\[ f = \mathbf{x}^T \sum_i \mathbf{a}_i \mathbf{b}_i^T \mathbf{y} \]", True),
        (MIXED + r"\[ f = \mathbf{x}^T \sum_i \mathbf{b}_i \mathbf{a}_i^T \mathbf{y} \]", False),
        (
            SPREAD
            + r"\[ \mathbf{S} = \mathbf{R} \left( \sum_i w_i \mathbf{y}_i \mathbf{y}_i^T \right) \mathbf{R}^T \]",
            True,
        ),
        (
            SPREAD
            + r"\[ \mathbf{S} = \mathbf{R}^T \left( \sum_i w_i \mathbf{y}_i \mathbf{y}_i^T \right) \mathbf{R} \]",
            False,
        ),
        (
            r"\[ f = \sum_i \mathbf{x}^T \mathbf{A}_i \mathbf{y} \] "
            r"\[ f = \mathbf{x}^T \left( \sum_i \mathbf{A}_i \right) \mathbf{y} \]",
            True,
        ),
        (
            r"\[ f = \sum_i \mathbf{x}^T \mathbf{A}_i \mathbf{y} \] "
            r"\[ f = \mathbf{y}^T \left( \sum_i \mathbf{A}_i \right) \mathbf{x} \]",
            False,
        ),
        (
            r"\[ \mathbf{s} = \sum_i \mathbf{a}_i \mathbf{a}_i^T \mathbf{b}_i \] "
            r"\[ \mathbf{s} = \left( \sum_i \mathbf{a}_i \mathbf{a}_i^T \right) \sum_i \mathbf{b}_i \]",
            False,
        ),
        (r"\[ s = \sum_{i=0}^{n-1} \mathbf{c}^T \mathbf{d} \] \[ s = n \mathbf{c}^T \mathbf{d} \]", True),
        (r"\[ s = \sum_{i=1}^{n-1} \mathbf{c}^T \mathbf{d} \] \[ s = n \mathbf{c}^T \mathbf{d} \]", False),
        (r"\[ s = \sum_{i=1}^n \mathbf{c}_i^T \mathbf{d} \] \[ s = n \mathbf{c}_i^T \mathbf{d} \]", False),
    ],
)
def test_what_does_not_depend_on_the_index_stands_outside(latex, follows):
    assert (read_document(document_of(latex), seconds=5)[-1].verdict == "follows") is follows


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (r"\[ c - a_i = 0. \]", False),
        (r"\[ 2 c = a_i. \]", False),
        (r"\[ c + g = a_i. \]", False),
        (r"\[ c - a_i x_i = 0. \]", False),
        (r"\[ c - g = 0, \] and \[ g = a_i. \]", False),
        (r"\[ c - g = 0, \quad g - 2 a_i = 0. \]", False),
        (r"\[ a_i = c x_i. \]", True),
        (r"\[ c - g = 0. \]", True),
        (r"\[ y_i - a x_i - c = 0. \]", True),
        (r"\[ c x_i + g y_i = 0. \]", True),
    ],
)
def test_a_letter_that_an_equation_gives_by_one_with_the_index_does_not_stand_outside(latex, follows):
    words = r"The sum is \[ S = \sum_{i=1}^n c b_i. \] Hence \[ S = c \sum_{i=1}^n b_i. \]"
    assert (read_document(document_of(f"We have {latex} {words}"), seconds=5)[-1].verdict == "follows") is follows


def test_a_letter_hides_an_index_whatever_its_side():
    latex = r"\[ x_{k+1} = a x_k + u, \] with \[ u - c w_k = 0. \] It follows that \[ x_{k+2} - a x_{k+1} - u = 0. \]"
    assert read_document(document_of(latex), seconds=5)[-1].verdict != "follows"
