"""Sums, integrals and values of functions that nothing computes are letters of their own."""

import pytest

from algebroproj_sym.reading import SymbolsFile, document_of, read_document

MEAN = r"Let $\bar x := \frac{1}{n} \sum_{i=1}^{n} x_i$. "

CASE = r"\[ c = k + 1 \quad \text{if } k > 2 \] "

FOLLOWING = [
    MEAN + r"Then \begin{equation} \sum_{i=1}^{n} (x_i - \bar x) = 0 \end{equation}",
    MEAN + r"Then \begin{equation} \sum_{i=1}^{n} (x_i - \bar x)^2 = \sum_{i=1}^{n} x_i^2 - n \bar x^2 \end{equation}",
    MEAN + r"Then \begin{equation} e^{a + \sum_{i=1}^{n} x_i} = e^a e^{n \bar x} \end{equation}",
    MEAN + r"Then \begin{equation} 2^{\sum_{i=1}^{n} x_i} = 2^{n \bar x} \end{equation}",
    r"\begin{equation} \sum_{i=1}^n \sum_{j=1}^m x_i y_j = \sum_{i=1}^n x_i \sum_{j=1}^m y_j \end{equation}",
    r"\[ \sum_{i=1}^n \sum_{j=1}^m (x_{ij} + c) = \sum_{i=1}^n \sum_{j=1}^m x_{ij} + n m c \]",
    r"\begin{equation} \left(e^{f(x)}\right)^2 = e^{2 f(x)} \end{equation}",
    r"Let $g(x) := x^2$ and $f(x) := a g(x)$. Then \begin{equation} f(3) = 9 a \end{equation}",
    CASE + r"Let $f(x) := c x$. Then \begin{equation} f(3) = 3 c \end{equation}",
    CASE + r"Let $f(x) := c x$. Then \begin{equation} f'(x) = c \end{equation}",
    r"\begin{equation} \frac{d}{dk} (c k) = c \end{equation}",
    r"Here $x$ is constant. Let $\dot z = v$ and $y := x z$. Then \[ \dot y - x v = 0 \]",
    r"\[ y_k = a + c x_k \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ c + d = 1 \] \[ y = k c + d \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ f(k) = c k + d \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ \sum_{k=1}^n k c = 1 \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ \sum_i (\sum_i x_i \mathbf{a}_i) y_i = (\sum_i x_i \mathbf{a}_i) \sum_i y_i \]",
    r"\[ \sum_{k=1}^{n_i} c_i = n_i c_i \]",
    r"\[ \sum_{k=0}^n c = n c + c \] \[ \sum_{k=0}^{n-1} c = n c \]",
    r"\[ \sum_{k=0}^n c = n c + c \]",
    r"Let $f(x) := a x$ and $g(x) := E(f(x))$. Then \[ g(2) = E(2 a) \]",
    r"The mean is $\bar x$. \[ \sum_i x_i y_i z_i u_i v_i w_i \bar x_i \bar y_i \bar z_i \bar u_i \bar v_i \bar w_i "
    r"\hat x_i \hat y_i \hat z_i a = a \sum_i x_i y_i z_i u_i v_i w_i \bar x_i \bar y_i \bar z_i \bar u_i \bar v_i "
    r"\bar w_i \hat x_i \hat y_i \hat z_i \]",
    r"\[ n - k = 2 \] \[ \sum_{k=1}^n c = n c \]",
]

NOT_FOLLOWING = [
    MEAN + r"Then \begin{equation} \sum_{i=1}^{n} (x_i - \bar x)^2 = \sum_{i=1}^{n} x_i^2 + n \bar x^2 \end{equation}",
    r"Let $f(n) := \sum_{i=1}^{n} c g_i$. Then \begin{equation} f(3) = f(5) \end{equation}",
    r"Let $f(n) := \sum_{i=1}^{n} c$. Then \begin{equation} f(3) = f(5) \end{equation}",
    r"Let $g := \sum_{i=1}^{n} g_i$ and $f(n) := 2 g$. Then \begin{equation} f(3) = f(5) \end{equation}",
    r"\begin{equation} \frac{d}{da} \sum_{i=1}^{n} e^{a x_i} = 0 \end{equation}",
    r"Let $s := \sum_{i=1}^{n} e^{a x_i}$. Then \begin{equation} \frac{ds}{da} = 0 \end{equation}",
    r"Let $s := \sum_{i=1}^{n} a_i^2$. Then \begin{equation} \frac{ds}{da_1} = 0 \end{equation}",
    r"\begin{equation} \sum_{i=1}^n \sum_{j=1}^n x_i y_j = n \sum_{i=1}^n x_i y_i \end{equation}",
    r"\begin{equation} \sum_{i=1}^n x_i y_i = \sum_{i=1}^n x_i \sum_{i=1}^n y_i \end{equation}",
    r"\begin{equation} \sum_{i=1}^n i c = n i c \end{equation}",
    r"\begin{equation} \sum_{i=0}^n c = n c \end{equation}",
    r"Let $n := 3$. Then \begin{equation} \sum_{i=1}^n c = 4 c \end{equation}",
    r"Let $i := 3$. Then \begin{equation} \sum_{i=1}^n i = 3 n \end{equation}",
    r"Let $x := 2$. Then \begin{equation} \int_0^1 x \, dx = \int_0^1 2 \, dx \end{equation}",
    r"Let $c := k + 1$. Then \begin{equation} \sum_{k=1}^n c = n c \end{equation}",
    r"Let $c = k + 1$ if $k > 2$. Then \begin{equation} \sum_{k=1}^n c = n c \end{equation}",
    r"\[ c = k + 1 \quad \text{if } k > 2 \] \begin{equation} \sum_{k=1}^n c = n c \end{equation}",
    r"\[ k + 1 =: c \quad \text{if } k > 2 \] \begin{equation} \sum_{k=1}^n c = n c \end{equation}",
    r"\[ c = d \] \[ d = b = k + 1 \text{ if } k > 2 \] \begin{equation} \sum_{k=1}^n c = n c \end{equation}",
    r"\begin{equation} \sum_{k=1}^n c = n c \end{equation} Here $c = k + 1$ if $k > 2$. \[ \sum_{k=1}^n c = n c \]",
    CASE + r"\[ f(k) := c k \] \begin{equation} f(3) = 3 c \end{equation}",
    CASE + r"Let $f(k) := g(k) c$ and $g(k) := 2 k$. Then \begin{equation} f(3) = 6 c \end{equation}",
    CASE + r"\begin{equation} \frac{d}{dk} (c k) = c \end{equation}",
    CASE + r"Let $f(k) := c k$. Then \begin{equation} \frac{df}{dk} = c \end{equation}",
    CASE + r"Let $f(k) := c k$. Then \begin{equation} f'(k) = c \end{equation}",
    r"\[ x = \cos t \text{ if } t > 0 \] Let $\dot z = v$ and $y := x z$. Then \[ \dot y - x v = 0 \]",
    r"\[ c - k = 1 \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ c - d = 0 \] \[ d = k + 1 \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ d - c = 1 \] \[ d + k = 2 \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ k = c - 1 \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ y = k = c \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ c^2 = k^2 \] \[ \sum_{k=1}^n c = n c \]",
    r"Let $a := 1$. \[ a = c - k \] \[ \sum_{k=1}^n c = n c \]",
    r"\[ \mathbf{c} - k \mathbf{a} = 0 \] \[ \sum_{k=1}^n b_k \mathbf{c} = \mathbf{c} \sum_{k=1}^n b_k \]",
    r"\[ \sum_i \sum_j \mathbf{a}_{ij} y_i = \sum_j \mathbf{a}_{ij} \sum_i y_i \]",
    r"\[ \sum_{k=1}^{n_k} c = n_k c \]",
    r"\[ \sum_{k=1}^{n-1} c = n c - c \]",
    r"Let $\mathbf{c} := k \mathbf{a}$. Then \[ \sum_{k=1}^n \mathbf{c} = \mathbf{c} \sum_{k=1}^n 1 \]",
    r"\begin{equation} \sum_{i=1}^n \int x_i \, dt = n \int x_i \, dt \end{equation}",
    r"\begin{equation} \sum_{i=1}^n f(i) = n f(i) \end{equation}",
    r"\begin{equation} \sum_{i=1}^n f_i(x) = n f_i(x) \end{equation}",
    r"\begin{equation} f(2)^3 = f(3)^3 \end{equation}",
]


pytestmark = pytest.mark.usefixtures("decided_here")


def verdicts(text):
    return [link.verdict for reading in read_document(document_of(text), seconds=5.0) for link in reading.links]


@pytest.mark.parametrize("text", FOLLOWING)
def test_what_holds_for_all_values_follows(text):
    assert verdicts(text)[-1] == "follows"


@pytest.mark.parametrize("text", NOT_FOLLOWING)
def test_what_depends_on_the_values_is_left_open(text):
    assert verdicts(text)[-1] in ("not decided", "independent", "not read")


def test_values_that_nothing_gives_contradict_nothing_even_in_an_identity():
    text = r"\begin{equation} e^{f(x)} = e^{g(x)} \end{equation}"
    (reading,) = read_document(document_of(text), SymbolsFile(identities=frozenset({"1"})), seconds=5.0)
    assert reading.links[0].verdict == "independent"


def test_a_letter_that_a_sum_gives_may_be_the_wrong_one() -> None:
    found = read_document(document_of(r"\[ w = \sum_{i=1}^M w_i \] \[ J = m (R^2 + h^2) \] \[ J = w (R^2 + h^2) \]"))[
        -1
    ]
    assert (found.verdict, found.links[-1].suggestion) == ("not decided", "m instead of w")


WEIGHTS = r"\[ w_i = \frac{p_i}{\sum_{j=1}^n p_j} \] Hence "


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (WEIGHTS + r"\[ \sum_{i=1}^n w_i = 1. \]", True),
        (WEIGHTS + r"\[ \sum_{i=1}^n w_i^2 = 1. \]", False),
        (WEIGHTS + r"\[ \sum_{i=1}^n p_i w_i = \sum_{k=1}^n p_k. \]", False),
        (WEIGHTS.replace("^n", "^m") + r"\[ \sum_{i=1}^n w_i = 1. \]", False),
        (WEIGHTS.replace("_{j=1}^n", "_j") + r"\[ \sum_i w_i = 1. \]", False),
        (r"\[ \bar x = \frac1n \sum_{j=1}^n x_j \] \[ \sum_{i=1}^n x_i \bar x = \frac1n (\sum_{k=1}^n x_k)^2 \]", True),
        (r"\[ s_i = \frac{e^{z_i}}{\sum_{j=1}^n e^{z_j}} \] \[ \sum_{k=1}^n s_k z_k = \sum_{i=1}^n s_i z_i \]", True),
        (r"\[ \sum_{i=1}^n a_{ij} x_i = \sum_{k=1}^n a_{kj} x_k \]", True),
        (r"\[ \sum_{i=1}^n a_{ij} x_i = \sum_{k=1}^n a_{jk} x_k \]", False),
        (r"\[ \sum_{i=1}^n a_{ij} x_i = \sum_{j=1}^n a_{ij} x_i \]", False),
        (r"\[ \sum_{i=1}^n a_{ij} x_i = \sum_{j=1}^n a_{jj} x_j \]", False),
        (r"\[ \sum_{i=1}^n x_i y_j = \sum_{j=1}^n x_j y_j \]", False),
        (r"\[ c - k = 1 \] \[ \sum_{i=1}^n c x_i = \sum_{k=1}^n c x_k \]", False),
        (r"\[ \sum_{i=1}^n x_i f(i) = \sum_{k=1}^n x_k f(i) \]", False),
        (r"\[ \sum_{i=1}^n i x_i = \sum_{k=1}^n k x_k \]", True),
        (r"\[ \sum_{i=1}^n i x_i = \sum_{k=1}^n i x_k \]", False),
    ],
)
def test_a_sum_with_printed_limits_is_the_same_for_every_index(latex, follows):
    assert (verdicts(latex)[-1] == "follows") == follows


@pytest.mark.parametrize(
    ("text", "hypothesis"),
    [
        (
            r"\[ S = \sum_{i=1}^n w_i \] \[ m = \frac{a}{S} \] Hence \[ m \sum_{j=1}^n w_j = a. \]",
            r"[\sum_{i=1}^{n}](w_i)",
        ),
        (r"\[ z = b \int_0^1 g(t) dt \] Hence \[ \frac{z}{\int_0^1 g(t) dt} = b. \]", r"[\int_{0}^{1}](d_t*g(t))"),
        (r"\[ q = \frac{\Phi(x)}{\Phi(y)} \] Hence \[ q \Phi(y) = \Phi(x). \]", "Phi(y)"),
    ],
)
def test_hypotheses_have_sums_and_values_of_functions_as_they_are_read(text, hypothesis):
    assert read_document(document_of(text))[-1].links[0].hypotheses == (hypothesis,)
