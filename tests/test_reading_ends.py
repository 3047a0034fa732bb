"""Sums in another order, at another index, and with a few terms more at an end."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")

ESTIMATE = r"The estimate is \[ m_n = \frac1n \sum_{k=1}^{n} x_k. \] Hence "
BEFORE = r"\[ m = \sum_{k=1}^{n-1} e^{-(u_n - u_k)/\tau} = \sum_{k=1}^{n} e^{-(u_n - u_k)/\tau} "
SHAPES = r"The shape functions are \[ \phi_j = c_j + d_j x. \] "


def last_of(latex):
    return read_document(document_of(latex, latex=True))[-1].links[-1]


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \sum_{i=1}^n \sum_{j=1}^m a_{ij} x_j = \sum_{j=1}^m x_j \sum_{i=1}^n a_{ij}. \]",
        r"\[ \sum_{i=1}^n y_i \sum_{j=1}^m a_{ij} x_j = \sum_{j=1}^m x_j \sum_{i=1}^n a_{ij} y_i. \]",
        r"\[ \sum_i \sum_j a_i b_j = \left( \sum_j b_j \right) \sum_i a_i. \]",
        r"\[\sum_{k=1}^n \sum_{j=1}^n \sum_{i=1}^n a_{ijk} x_j = \sum_{j=1}^n x_j \sum_{k=1}^n \sum_{i=1}^n a_{ijk}\]",
        r"\[ \sum_{k=0}^{n-1} a_{k+1} = \sum_{k=1}^{n} a_k. \]",
        r"\[ \sum_{k=0}^{n-1} a_{k+1} b_k = \sum_{k=1}^{n} a_k b_{k-1}. \]",
        r"\[ \sum_{k=1}^{n} (a_k - a_{k-1}) = a_n - a_0. \]",
        r"\[ \sum_{k=1}^{n-1} x_k = \sum_{k=1}^n x_k - x_n. \]",
        r"\[ \sum_{k=0}^{n} x_k = x_0 + \sum_{k=1}^n x_k. \]",
        ESTIMATE + r"\[ n m_n = x_n + \sum_{k=1}^{n-1} x_k. \]",
        ESTIMATE + r"\[ m_n = \frac{n-1}{n} m_{n-1} + \frac{1}{n} x_n. \]",
        ESTIMATE + r"\[ m_{n+1} = \frac{n}{n+1} m_n + \frac{1}{n+1} x_{n+1}. \]",
        BEFORE + r"- 1. \]",
        r"\[ \sum_{k=0}^{\infty} a r^k = \sum_{k=1}^{\infty} a r^{k-1}. \]",
        r"\[ \sum_{k=0}^{\infty} b_k r^k = b_0 + \sum_{k=0}^{\infty} b_{k+1} r^{k+1}. \]",
        r"\[ \sum_{k=0}^{n-1} r^{k+1} = \sum_{k=1}^{n} r^k. \]",
        SHAPES + r"\[ v = \sum_{j=1}^2 a_j \phi_j. \] So \[ \sum_{j=1}^2 b_j v = v \sum_{j=1}^2 b_j. \]",
    ],
)
def test_a_sum_with_other_ends_follows(latex):
    assert last_of(latex).verdict == "follows"


@pytest.mark.parametrize(
    ("latex", "suggestion"),
    [
        (r"\[ \sum_{i=1}^n \sum_{j=1}^m a_{ij} x_j = \sum_{j=1}^m x_j \sum_{i=1}^m a_{ij}. \]", ""),
        (r"\[ \sum_{k=0}^{\infty} a r^k = \sum_{k=2}^{\infty} a r^{k-1}. \]", ""),
        (r"\[ \sum_{k=0}^{\infty} b_k r^k = b_1 + \sum_{k=1}^{\infty} b_k r^k. \]", "b_0 instead of b_1"),
        (r"\[ \sum_{k=0}^{\infty} b_k r^k = b_0 + \sum_{k=0}^{\infty} b_{k+1} r^k. \]", ""),
        (r"\[ \sum_{k=1}^{\infty} \frac{1}{k} = \sum_{k=0}^{\infty} \frac{1}{k}. \]", ""),
        (r"\[ \sum_{k=0}^{n-1} r^{n-k-1} = \sum_{k=1}^{n} r^{n-k-1}. \]", ""),
        (r"\[ \sum_{k=1}^{\infty} r^{2k-1} = \sum_{k=0}^{\infty} r^{2k}. \]", ""),
        (r"\[ \sum_{i=1}^n \sum_{j=1}^i a_{ij} x_j = \sum_{j=1}^i x_j \sum_{i=1}^n a_{ij}. \]", ""),
        (r"\[ \sum_{i=1}^n \sum_{j=1}^m a_{ij} x_j = \sum_{j=1}^m x_j \sum_{i=1}^n a_{ji}. \]", ""),
        (r"\[ \sum_{i=1}^n x_j \sum_{j=1}^m a_{ij} = \sum_{j=1}^m x_j \sum_{i=1}^n a_{ij}. \]", ""),
        (r"\[ \sum_{k=0}^{n-1} a_{k+1} = \sum_{k=1}^{n-1} a_k. \]", ""),
        (r"\[ \sum_{k=1}^{n} (a_k - a_{k-1}) = a_n - a_1. \]", ""),
        (r"\[ \sum_{k=1}^{n-1} x_k = \sum_{k=1}^n x_k - x_{n-1}. \]", "x_n instead of x_nminus1"),
        (r"\[ \sum_{k=0}^{n} x_k = x_1 + \sum_{k=1}^n x_k. \]", "x_0 instead of x_1"),
        (ESTIMATE + r"\[ m_n = \frac{n+1}{n} m_{n-1} + \frac{1}{n} x_n. \]", "n - 1 instead of n + 1"),
        (ESTIMATE + r"\[ m_{n+1} = \frac{n}{n+1} m_n + \frac{1}{n+1} x_n. \]", "x_nplus1 instead of x_n"),
        (BEFORE + r"+ 1. \]", ""),
        (r"Let $c = x_k$. \[ \sum_{k=1}^{n-1} c = \sum_{k=1}^n c - c. \]", ""),
        (SHAPES + r"Let $v = \phi_j$. So \[ \sum_{j=1}^2 b_j v = v \sum_{j=1}^2 b_j. \]", ""),
        (
            SHAPES
            + r"\[ v_k = \sum_{j=1}^2 a_j \phi_k. \] \[ u = v_k \] So \[ \sum_{k=1}^2 b_k u = u \sum_{k=1}^2 b_k. \]",
            "",
        ),
    ],
)
def test_a_wrong_one_does_not(latex, suggestion):
    found = last_of(latex)
    assert found.verdict not in ("follows", "contradicts")
    assert not suggestion or found.suggestion == suggestion
