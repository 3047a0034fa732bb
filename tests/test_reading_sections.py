r"""A letter is a number in a section where it stands below a line, and a vector or a matrix in another one.

A function of which another section states a differential equation is another one.
"""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

FILTER = r"""\section{Filter}
The gain is \[ K = P H^T (H P H^T + R)^{-1}. \]
The new covariance is \[ U = (I - K H) P (I - K H)^T + K R K^T. \]
With the gain this is \[ U = (I - K H) P. \]
"""
BEAM = r"""\section{Beam}
The deflection is \[ w(x) = \frac{q x}{24 E I} (L^3 - 2 L x^2 + x^3). \]
At the middle it is \[ w(L/2) = \frac{5 q L^4}{384 E I}. \]
The moment is \[ M(x) = -E I w''(x) = \frac{q x}{2} (L - x). \]
"""
MATRICES = r"\section{Maps} Let $A$ and $B$ be matrices. \[ C = A B \] "
VECTORS = r"\section{Vectors} Let $a$ and $b$ be vectors. \[ s = a + b \] "


def verdicts(latex):
    return [link.verdict for each in read_document(document_of(latex)) for link in each.links]


def test_what_a_letter_is_elsewhere_does_not_matter():
    of_filter = ["definition", "definition", "follows"]
    of_beam = ["definition", "follows", "definition", "follows"]
    assert verdicts(FILTER + BEAM) == of_filter + of_beam
    assert verdicts(BEAM + FILTER) == of_beam + of_filter
    again = r"\section{Again} Hence \[ (I - K H) P = P - K H P. \]"
    assert verdicts(FILTER + BEAM + again)[-1] == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        MATRICES + r"\section{Widths} The width is \[ w = \frac{1}{A}. \] Hence \[ C = B A. \]",
        r"\section{Widths} The width is \[ w = \frac{1}{A}. \] " + MATRICES + r"Hence \[ C = B A. \]",
        r"\section{Widths} \[ w = \frac{1}{A}, \qquad C = A B. \] \section{Maps} Let $A$ and $B$ be matrices. "
        r"By definition \[ C = B A. \]",
        MATRICES + r"\section{Widths} The width is \[ w = \frac{1}{A}. \] With the matrix $A$ it follows that "
        r"\[ A B = B A. \]",
        MATRICES + r"\section{Widths} \[ w = \frac{1}{\det A} \] Hence \[ A B = B A. \]",
        MATRICES + r"\section{Widths} \[ w = \frac{1}{|A|} \] Hence \[ A B = B A. \]",
        MATRICES + r"\section{Widths} \[ w = \frac{1}{A} \] \section{More} Hence \[ A B = B A. \]",
        MATRICES + r"\section{Widths} \[ w = \frac{1}{A} \] and \[ D = A^T B. \] Hence \[ A B = B A. \]",
        VECTORS + r"\section{Shadows} \[ p = \frac{a \cdot b}{b \cdot b} b \] Hence \[ p = a. \]",
        VECTORS + r"\section{Shadows} \[ p = \frac{a \cdot b}{b^2} b \] Hence \[ p = a. \]",
        VECTORS + r"\section{Shadows} \[ p = \frac{a \cdot b}{\|b\| \|b\|} b \] Hence \[ p = a. \]",
        VECTORS + r"\section{Shadows} \[ p = \frac{a^T b}{b^T b} b \] Hence \[ p = a. \]",
        VECTORS + r"\section{Shadows} \[ p = \frac{(a b)}{(b b)} b \] Hence \[ p = a. \]",
        VECTORS + r"\section{Planes} \[ c = \frac{1}{a} m \] and \[ a \cdot (p - c) = 0. \] Hence \[ p = c. \]",
        VECTORS + r"\section{Planes} \[ c = \frac{1}{a} m \] and \[ a \times (p - c) = 0. \] Hence \[ p = c. \]",
    ],
)
def test_what_does_not_hold_of_matrices_and_vectors_does_not_follow(latex):
    assert verdicts(latex)[-1] != "follows"


STONE = r"\section{Stones} A stone falls by \[ x(t) = \frac12 g t^2. \] "


def test_a_differential_equation_in_another_section_is_of_another_function():
    spring = (
        r"\section{Springs} \[ m \ddot x + k x = 0. \] The energy is \[ E = \frac12 m \dot x^2 + \frac12 k x^2. \] "
    )
    rate = r"Its rate is \[ \frac{dE}{dt} = m \dot x \ddot x + k x \dot x. \]"
    assert verdicts(STONE + spring + rate)[-1] == "follows"
    assert verdicts(STONE + r"Hence \[ \dot x = g t. \]")[-1] == "follows"
    assert verdicts(STONE + r"\section{Motion} Hence \[ \dot x = g t. \]")[-1] == "follows"
    assert verdicts(STONE + r"\section{Motion} \[ \ddot x + k x = 0 \] Hence \[ \dot x = g t. \]")[-1] != "follows"


RESIDUALS = r"\section{Fit} The residuals are \[ e = y - z, \] so \[ y = z + e. \] "


def test_e_is_eulers_number_in_a_section_of_its_own():
    charge = r"\section{Charge} It decays as \[ q(t) = q_0 e^{-t/T}. \] "
    charge += r"Hence the current is \[ \dot q = -\frac{q_0}{T} e^{-t/T}. \]"
    assert verdicts(RESIDUALS + charge)[-2:] == ["definition", "follows"]
    iterates = r"\section{Steps} \[ e^{k+1} = a e^k \] Hence \[ \frac{d}{dk} e^k = e^k. \]"
    assert verdicts(RESIDUALS + iterates)[-1] != "follows"
