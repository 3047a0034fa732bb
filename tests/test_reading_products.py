r"""Products over an index, and values with a condition such as p(y|x)."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def read(latex):
    return read_document(document_of(latex), seconds=5)


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \prod_{i=1}^n c x_i = c \prod_{i=1}^n x_i \]",
        r"\[ \prod_{i=1}^n c_i = c_i^n \]",
        r"\[ \prod_{i=1}^n (x_i + c) = c^n + \prod_{i=1}^n x_i \]",
        r"\[ \prod_{i=0}^n c e^{x_i} = c^n e^{\sum_{i=0}^n x_i} \]",
        r"\[ \prod_{i=1}^n e^{x_i} = e^{\prod_{i=1}^n x_i} \]",
        r"\[ \prod_i c e^{x_i} = c^n e^{\sum_i x_i} \]",
        r"\[ w - i = c. \] \[ \prod_{i=1}^n w = w^n \]",
        r"\[ n = i + 1. \] \[ \prod_{i=1}^n c = c^n \]",
        r"\[ \sqrt{\prod_{i=1}^n x_i^2} = \prod_{i=1}^n x_i \]",
        r"\[ \prod_{i=1}^n \sqrt{x_i^2} = \prod_{i=1}^n x_i \]",
        r"\[ \prod_{i=1}^n x_i \prod_{i=1}^n y_i = \prod_{i=1}^n (x_i + y_i) \]",
        r"\[ \ln \prod_i x_i = \prod_i \ln x_i \]",
        r"\[ \ln \sum_i x_i = \sum_i \ln x_i \]",
        r"\[ \ln \left( a + \prod_i x_i \right) = \ln a + \sum_i \ln x_i \]",
        r"\[ \ln \prod_i x_i + y = \sum_i (\ln x_i + y) \]",
        r"\[ \ln \prod_i x_i = \sum_j \ln x_j \]",
        r"\[ \log_2 \prod_i x_i = \sum_i \ln x_i \]",
        r"\[ \ln \prod_{i=1}^n x_i = \sum_{i=0}^n \ln x_i \]",
        r"\[ \ln \prod_{i=1}^n x_i = n \ln x_i \]",
        r"\[ \log \prod_i e^{x_i} = \sum_i x_i + 1 \]",
        r"\[ \log_{10} \prod_i \exp(x_i) = \sum_i x_i \]",
        r"\[ f(m) := p(y|m) \] \[ \frac{df}{dm} = 0 \]",
        r"\[ f(m) := \log p(y|m) \] \[ f'(m) = 0 \]",
        r"\[ f := m p(y|m) \] \[ \frac{\partial f}{\partial m} = p(y|m) \]",
        r"\[ g := p(y|m) \] \[ \frac{\partial}{\partial m} (g + m) = 1 \]",
        r"\[ E := p(y|t) x \] \[ 2 \dot E = 2 p(y|t) \dot x \]",
        r"\[ \log p(y|m) = \log p + \log (y|m) \]",
        r"\[ \log p(y|m) = \log p(m|y) \]",
        r"\[ \ln n! = n! \ln n \] \[ \ln n! + \ln n = 2 (\ln n)! \]",
    ],
)
def test_what_is_no_product_of_that_kind_is_left_open(latex):
    assert read(latex)[-1].verdict not in ("follows", "contradicts")


def test_a_factorial_and_a_condition_belong_to_the_argument_of_a_function():
    (found,) = read(r"\[ L = \ln x! - \log p(y|m) + \ln \mathrm{Pr}(X = 1) + \sin 2 x \]")
    assert found.read == "L = log(factorial(x)) - log(p_y_m) + log(Pr_X_1) + sin(2*x)"
