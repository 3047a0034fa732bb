r"""Products over an index, their logarithms and the derivatives of these; integrals that are taken term by term."""

import pytest

from algebroproj_sym.reading import Reading, document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")

NORMAL = r"We have \[ L = \prod_{i=1}^n \frac{1}{\sqrt{2\pi s^2}} e^{-\frac{(x_i - m)^2}{2 s^2}} \] Hence "


def last(latex: str) -> Reading:
    return read_document(document_of(latex))[-1]


@pytest.mark.parametrize(
    "latex",
    [
        NORMAL + r"\[ \ln L = -\frac n2 \ln(2\pi s^2) - \frac{1}{2 s^2} \sum_{i=1}^n (x_i - m)^2 \]",
        NORMAL + r"\[ L = (2\pi s^2)^{-n/2} e^{-\frac{1}{2 s^2} \sum_{i=1}^n (x_i - m)^2} \]",
        NORMAL + r"\[ \frac{\partial \ln L}{\partial m} = \frac{1}{s^2} \sum_{i=1}^n (x_i - m) \]",
        r"\[ L = \prod_{i=1}^n \lambda e^{-\lambda t_i} \] Hence \[ L = \lambda^n e^{-\lambda \sum_{i=1}^n t_i} \]",
        r"We have \[ L = \prod_{i=0}^n c p_i \] Hence \[ L = c^{n+1} \prod_{i=0}^n p_i \]",
        r"We have \[ P = \prod_{i=1}^n p_i q_i \] Hence \[ \ln P = \sum_{i=1}^n \ln p_i + \sum_{i=1}^n \ln q_i \]",
        r"We have \[ P = \prod_{i=1}^n \frac{p_i}{q_i} \] Hence \[ \ln P = \sum_{i=1}^n (\ln p_i - \ln q_i) \]",
        r"\[ \ln L = a - \frac{1}{2} \sum_{i=1}^n (x_i - m)^2 \] Hence "
        r"\[ \frac{\partial \ln L}{\partial m} = \sum_{i=1}^n (x_i - m) \]",
        r"\[ I = \int_\Omega (2 f + g) v \, dV \] Hence \[ I = 2 \int_\Omega f v \, dV + \int_\Omega g v \, dV \]",
    ],
)
def test_products_and_integrals_are_taken_apart(latex):
    assert last(latex).verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        NORMAL + r"\[ \ln L = -n \ln(2\pi s^2) - \frac{1}{2 s^2} \sum_{i=1}^n (x_i - m)^2 \]",
        NORMAL + r"\[ \frac{\partial \ln L}{\partial m} = \frac{1}{s} \sum_{i=1}^n (x_i - m) \]",
        NORMAL + r"\[ \frac{\partial L}{\partial m} = \frac{1}{s^2} \sum_{i=1}^n (x_i - m) \]",
        r"We have \[ L = \prod_{i=1}^n (a_i + b_i) \] Hence \[ L = \prod_{i=1}^n a_i + \prod_{i=1}^n b_i \]",
        r"We have \[ L = \prod_{i=1}^n c p_i \] Hence \[ L = c \prod_{i=1}^n p_i \]",
        r"We have \[ L = \prod_{i=0}^n c p_i \] Hence \[ L = c^n \prod_{i=0}^n p_i \]",
        r"We have \[ c = a_i b_i \] \[ P = \prod_{i=1}^n c \] Hence \[ P = c^n \]",
        r"We have \[ P = \prod_{i=1}^n p_i \] Hence \[ \ln P = \sum_{i=0}^n \ln p_i \]",
        r"\[ \ln L = a - \frac{1}{2} \sum_{i=1}^n (x_i - m)^2 \] where \[ a = m^2 \] Hence "
        r"\[ \frac{\partial \ln L}{\partial m} = \sum_{i=1}^n (x_i - m) \]",
        r"We have \[ W = \int_0^L F \, dx \] Hence \[ W = F \int_0^L dx \]",
        r"\[ I = \int_\Omega f g \, dV \] Hence \[ I = \int_\Omega f \, dV \int_\Omega g \, dV \]",
        r"\[ I = \int_0^1 (f + g) \, dx \] Hence \[ I = \int_0^1 f \, dx + \int_0^2 g \, dx \]",
    ],
)
def test_nothing_else_is_taken_out_of_products_and_integrals(latex):
    assert last(latex).verdict != "follows"


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (r"\[ \cos a = \frac{\cos b}{\sqrt{1 - \sin^2 c}} \] Hence \[ \cos^2 b = \cos^2 a (1 - \sin^2 c) \]", True),
        (r"\[ \cos a = \frac{\cos b}{\sqrt{1 - \sin^2 c}} \] Hence \[ \cos^2 b = \cos^2 a (1 + \sin^2 c) \]", False),
        (r"\[ u T = k a^{3/2} \] Hence \[ u^2 T^2 = k^2 a^3 \]", True),
        (r"\[ u T = k a^{3/2} \] Hence \[ u^2 T^2 = k^2 a^2 \]", False),
        (r"\[ u s = \sqrt[3]{V} \] Hence \[ u^2 s^2 = V \]", False),
    ],
)
def test_roots_stand_in_equations_under_which_something_holds(latex, follows):
    assert (last(latex).verdict == "follows") is follows


RATIO = r"The answer is \[ c = a + \frac{1 - a}{p} \] Hence \[ c = u + v \] "


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (RATIO + r"where $u = a (1 - 1/p)$ is the share (of all) at the wall and $v = 1/p$ is its price.", True),
        (RATIO + r"With $u = a (1 - 1/p)$ and $v = 1/p,$ these are equal to those for the shares in (2).", True),
        (RATIO + r"where $u = a (1 + 1/p)$ is the share and $v = 1/p$ is its price.", False),
        (RATIO + r"where $u = a (1 - 1/p)$ is the share of the old firm and $v = 1/p$ is its price.", False),
        (RATIO + r"where $u = a (1 - 1/p)$ is not the share, and $v = 1/p$ is its price.", False),
    ],
)
def test_a_clause_behind_says_what_letters_are(latex, follows):
    readings = read_document(document_of(latex))
    assert (readings[-1].verdict == "follows") is follows


BRACKET = r"We have \[ d = \langle u|u \rangle + \langle v|v \rangle - 2 \langle u|v \rangle \] Hence "
PAIRS = (
    r"We have \[ s = \sum_{i=1}^C "
    r"\left[ \langle u^i|v^i \rangle + 2 c \sum_{j<i} (a_j + \langle u^i|v^j \rangle) \right] \] "
)
ROWS = r"\sum_{i=1}^C \langle u^i|v^i \rangle + 2 c \sum_{i=1}^C \sum_{j<i} "


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (BRACKET + r"\[ d - \langle v|v \rangle = \langle u|u \rangle - 2 \langle u|v \rangle \]", True),
        (BRACKET + r"\[ d - \langle v|v \rangle = \langle u|u \rangle - 2 \langle v|u \rangle \]", False),
        (BRACKET + r"\[ d = 0 \]", False),
        (PAIRS + rf"Hence \[ s = {ROWS} a_j + 2 c \sum_{{i=1}}^C \sum_{{j<i}} \langle u^i|v^j \rangle \]", True),
        (PAIRS + rf"Hence \[ s = {ROWS} a_j + 2 c \sum_{{i=1}}^C \sum_{{j<i}} \langle u^j|v^i \rangle \]", False),
        (PAIRS + rf"Hence \[ s = {ROWS} (a_i + \langle u^i|v^j \rangle) \]", False),
        (r"Let $f(u) = \langle u|v \rangle$. Then \[ f(w) = \langle u|v \rangle \]", False),
    ],
)
def test_what_stands_on_both_sides_of_a_bar_in_angles_is_a_letter(latex, follows):
    assert (last(latex).verdict == "follows") is follows


def test_an_angle_at_which_something_happens_is_not_given():
    words = r"It avoids the discontinuity at $\theta = 0$ and $\theta = \pi$. "
    readings = read_document(document_of(words + r"The signal is \[ y = a \cos\theta \] Hence \[ y = -a \]"))
    assert readings[-1].verdict == "independent"


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (r"Let $f(x) = k (x - x_0)$. Then \[ f(a) = k (a - x_0) \]", True),
        (r"Let $x$ be a vector and $f(x) = x_1 + k$. Then \[ f(a) = x_1 + k \]", False),
        (r"Let $x_0 = x - 1$ and $f(x) = k (x - x_0)$. Then \[ f(a) = k (a - x_0) \]", False),
    ],
)
def test_a_fixed_value_of_a_number_is_no_part_of_it(latex, follows):
    assert (last(latex).verdict == "follows") is follows


KEPLER = r"The anomalies have \[ M = E - e \sin E \] "
BY_ECCENTRICITY = r"\[ \frac{dE}{de} = \frac{\sin E}{1 - e \cos E} \]"
BY_ANOMALY = r"\[ \frac{dE}{dM} = \frac{1}{1 - e \cos E} \] "


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (KEPLER + BY_ANOMALY + BY_ECCENTRICITY, True),
        (KEPLER + r"For constant $e$ we have " + BY_ANOMALY, True),
        (r"It is \[ u = q^3 + a q \] with constant $a$. Hence \[ \frac{dq}{du} = \frac{1}{3 q^2 + a} \]", True),
        (KEPLER + BY_ECCENTRICITY, False),
        (KEPLER + BY_ANOMALY, False),
        (KEPLER + BY_ANOMALY + r"\[ \frac{dM}{de} = c \] " + BY_ECCENTRICITY, False),
        (KEPLER + BY_ECCENTRICITY + r"\[ \frac{dM}{de} = c \] " + BY_ANOMALY, False),
        (KEPLER + r"It also has \[ M = c e \] " + BY_ANOMALY + BY_ECCENTRICITY, False),
        (KEPLER + BY_ANOMALY + r"\[ r = 1 - e \cos E \] " + BY_ECCENTRICITY, False),
        (KEPLER + BY_ANOMALY + BY_ECCENTRICITY.replace(r"\frac{\sin", r"-\frac{\sin"), False),
        (KEPLER + BY_ANOMALY + BY_ECCENTRICITY.replace(r"1 - e", "1 + e"), False),
        (
            r"We have \[ c - q = 1. \] It is \[ u = c q \] with \[ \frac{du}{dc} = k \] \[ \frac{dq}{du} = \frac1c \]",
            False,
        ),
        (r"It is \[ u = q^3 + a q \] Hence \[ \frac{dq}{du} = \frac{1}{3 q^2 + a} \]", False),
    ],
)
def test_a_letter_that_an_equation_ties_has_a_derivative_by_all_others(latex, follows):
    assert (last(latex).verdict == "follows") is follows


def test_a_wrong_index_within_a_value_with_a_condition_is_named():
    given = r"We have \[ q = \ln p(z \mid d_j) - \ln p(z \mid a) + \ln p(d_j \mid a) \] Hence "
    wrong = last(given + r"\[ q - \ln p(d_j \mid a) = \ln p(z \mid d_i) - \ln p(z \mid a) \]")
    assert wrong.links[0].suggestion == "p_zmidd_j instead of p_zmidd_i"


def test_words_that_find_something_deny_nothing():
    words = r"To find the response, we use \[ q = a + b \] Hence \[ q - b = a \]"
    assert last(words).verdict == "follows"
    assert last(words.replace("response", "error")).verdict != "follows"


@pytest.mark.parametrize("number", [r"\mathbb{I}_{x \in A}", r"\mathbb{I}(x \in A)", r"\mathbb{P}(x \mid A)"])
def test_a_number_of_what_happens_is_no_matrix(number):
    assert last(rf"We have \[ q = \frac{{{number}}}{{m}} \] Hence \[ m q = {number} \]").verdict == "follows"


PARTITION = r"""The partition function is \[ Z = \sum_{i=1}^N e^{-\beta E_i} \] and the probabilities are
\[ p_i = \frac1Z e^{-\beta E_i}. \] The mean energy is \[ U = \sum_{i=1}^N E_i p_i. \] Hence
\[ U = -\frac1Z \frac{\partial Z}{\partial \beta} \] and \[ U = -\frac{\partial}{\partial\beta} \ln Z. \] With the
entropy \[ S = -\sum_{i=1}^N p_i \ln p_i \] we have \[ S = \beta U + \ln Z. \]"""
NORMALIZED = r"""We have \[ \sum_{i=1}^N p_i = 1 \] and \[ p_i = e^{-1-\lambda} e^{-\mu i}. \] Hence
\[ \sum_{i=1}^N e^{-1-\lambda} e^{-\mu i} = 1 \] and \[ e^{-1-\lambda} = \frac{1}{\sum_{i=1}^N e^{-\mu i}}. \] Therefore
\[ p_i = \frac{e^{-\mu i}}{\sum_{i=1}^N e^{-\mu i}}. \]"""


@pytest.mark.parametrize(
    ("latex", "following"),
    [
        (PARTITION, [3, 4, 6]),
        (PARTITION.replace(r"= -\frac1Z \frac", r"= \frac1Z \frac"), [4, 6]),
        (
            PARTITION.replace("-\\frac{\\partial}{\\partial\\beta} \\ln", "\\frac{\\partial}{\\partial\\beta} \\ln"),
            [3, 6],
        ),
        (PARTITION.replace(r"\beta U + \ln Z", r"\beta U - \ln Z"), [3, 4]),
        (NORMALIZED, [2, 4]),
        (NORMALIZED.partition("Therefore")[0], [2, 3]),
        (r"\[ p_i = 2 i \] \[ p_i = c + i \] Hence \[ \sum_{i=1}^N c = N c. \]", []),
        (NORMALIZED.replace(r"= \frac{1}{\sum_{i=1}^N e", r"= \frac{1}{\sum_{i=1}^N -e"), [2]),
        (r"We have \[ a e^{-\lambda} = 1. \] Hence \[ a^2 = e^{2\lambda}. \]", [1]),
        (r"We have \[ a e^{-\lambda} = 1. \] Hence \[ a e^{\mu-\lambda} = e^\mu. \]", [1]),
        (r"We have \[ a e^{-\lambda} = 1. \] Hence \[ a^2 = e^\lambda. \]", []),
        (r"We have \[ a e^{-\lambda} = 1. \] Hence \[ a = e^{-\lambda}. \]", []),
        (r"We have \[ c = p_i - i. \] Hence \[ \sum_{i=1}^N c = N c. \]", []),
        (r"We have \[ \sum_{i=1}^N p_i = 1 \] and \[ p_i = e^{-\mu i}. \] Hence \[ N e^{-\mu i} = 1. \]", []),
    ],
)
def test_probabilities_are_normalized_and_their_partition_function_is_derived(latex, following):
    found = [each.verdict for each in read_document(document_of(latex))]
    assert [place for place, each in enumerate(found) if each == "follows"] == following
