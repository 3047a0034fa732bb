r"""What says of letters what they are, or in what range they lie, and what is a claim of them."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

PAIR = r"\[ p = m x + k y \] \[ q = k x + n y \] "
DEFINES = {
    "a group of letters": r"\[ g = (R, p), \quad R \in \mathrm{SO}(3), \quad p \in \mathbb{R}^3. \]",
    "a time": r"The rate is \[ a(t) = c t + b, \quad t \in [t_1, t_2]. \]",
    "a yield condition": r"The yield condition is \[ f(s, k) := s - 2 k \le 0. \]",
    "a margin": r"The margin is \[ m = a - b > 0. \]",
    "a letter that only stands in a value above": r"The ratio is \[ r = k f. \] The angle is given by "
    r"\[ \tan u = \frac{w}{h} = \frac{1}{2 f}. \]",
    "a rate that is put in": r"\[ x''(t) = a(t) \] With the substitution $v(t) = x'(t)$ this is "
    r"\[ v'(t) = a(t). \]",
    "a rate": r"\[ \frac{dx}{dt} = v \]",
    "rates": r"The motion is described by \[ \frac{d x}{d t} = v \] \[ \frac{d v}{d t} = a \] "
    r"\[ \frac{d \vec{r}_i}{dt} = \vec{u}_i. \]",
    "a name beside what is defined": r"Given $W = w^\wedge$, we define \[ W^\vee = \begin{bmatrix} 0 & -z & y \\ "
    r"z & 0 & -x \\ -y & x & 0 \end{bmatrix}^\vee := \begin{bmatrix} x \\ y \\ z \end{bmatrix}. \]",
    "a matrix that is not printed": PAIR + r"In matrix form \[ \begin{bmatrix} p \\ q \end{bmatrix} = "
    r"\mathbf{B} \begin{bmatrix} x \\ y \end{bmatrix} \] where $\mathbf{B}$ is a $2 \times 2$ matrix.",
}
STAYS_OPEN = {
    "a row instead of a column": PAIR + r"\[ \begin{bmatrix} p \\ q \end{bmatrix} = \begin{bmatrix} u & w "
    r"\end{bmatrix} \begin{bmatrix} m & k \\ k & n \end{bmatrix} \]",
    "a rate of letters that are tied": r"\[ x = a t^2 \] \[ v + b = c \] \[ \frac{dx}{dt} = v \]",
    "a rate that is said to follow": r"\[ y = a \] Hence \[ \frac{dx}{dt} = v. \]",
    "a rate in a case": r"It stays open if \[ \frac{dx}{dt} = v. \]",
    "a letter that grows by itself": r"\[ \frac{dv}{dt} = v \]",
    "a rate that is a number": r"\[ \frac{dx}{dt} = 0 \]",
    "a claim of what is given": r"\[ R = A B \] Hence \[ R \in \mathrm{SO}(3). \]",
    "a claim of what is given, without words": r"\[ R = A B \] \[ R \in \mathrm{SO}(3). \]",
    "a condition": r"\[ y = a t \] if \[ t \in [0, 1]. \]",
    "what is not so": r"It is not true that \[ t \in [0, 1]. \]",
    "a range alone": r"\[ a - b \le 0 \]",
    "letters that are given": r"\[ w = 2 b \] \[ h = 3 b \] \[ f = 5 b \] The angle is given by "
    r"\[ \tan u = \frac{w}{h} = \frac{1}{2 f}. \]",
    "letters that an equation ties": r"\[ w + h = 1 \] \[ f^2 + w = h \] The angle is given by "
    r"\[ \tan u = \frac{w}{h} = \frac{1}{2 f}. \]",
}


@pytest.mark.parametrize("name", DEFINES)
def test_an_equation_says_what_letters_are(name):
    verdicts = [each.verdict for each in read_document(document_of(DEFINES[name]))]
    assert verdicts == ["definition"] * len(verdicts)


@pytest.mark.parametrize("name", STAYS_OPEN)
def test_a_claim_or_a_condition_says_nothing_of_what_letters_are(name):
    last = read_document(document_of(STAYS_OPEN[name]))[-1]
    assert last.read is not None
    assert last.verdict not in ("definition", "follows")


def test_a_sign_that_is_not_judged_is_told():
    (only,) = read_document(document_of(r"The margin is \[ m = a - b > 0. \]"))
    assert [each.reason for each in only.links] == ["", "the sign > is read, but not judged"]
