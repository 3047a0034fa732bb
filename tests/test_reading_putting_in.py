"""Equations that follow once what stands above is put in: by words such as *let*, in others, or at other indices."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

MATRICES = r"The matrices satisfy \[ A X B = C \] where $A, X, B, C \in \mathbb{R}^{n \times n}$. Hence "
PAIRS = r"The distances are \[ d_{ij} = x_i - x_j \] Hence "
SHARE = r"Let $q = m/(m + n) \in [0, 1]$, where $m$ is a mass. Then "
SLOPE = (
    r"The vectors $\mathbf z$, $\mathbf u$ and $\mathbf x$ satisfy "
    r"\[ -2 (\mathbf z - a \mathbf u - b \mathbf x)^T \mathbf x = 0 \] and "
    r"\[ a = \mathbf z^T \mathbf u - b \mathbf x^T \mathbf u \] Hence "
)
ANGLES = (
    r"The angles satisfy \begin{equation}\label{a} \cos a \cos b - \cos d \sin a \sin b = 0 \end{equation} and "
    r"\begin{equation}\label{b} d = \pi - c \end{equation} Substituting \eqref{b} into \eqref{a} gives "
)
TWICE = r"\section{One} All capitals are matrices. We have \[ P = A Q A^T + R \] \section{Two} With $L = A Q$, we have "
STEPS = r"Let $x = a/b$. Then \[ y = x + 1 \] \[ z = 2 y \] \[ u = c + d \] \[ v = c - d \] \[ w = u v \] Hence "
LABELS = r"The variance is \[ v_i^j = (r_i^j)^2 + (s_i^j)^2 \] Hence "
KNOWN = r"We have \[ \ln p(\mathbf d | z) = \ln p(z | \mathbf d) + \ln p(\mathbf d) - \ln p(z) \] Hence "

FOLLOWS = {
    "factors on both sides": MATRICES + r"\[ X = A^{-1} C B^{-1} \]",
    "a pair of indices in the other order": PAIRS + r"\[ d_{ij} = -d_{ji} \]",
    "what is given with its range": SHARE + r"\[ n = \left(\frac1q - 1\right) m \]",
    "a letter put into the equation above": SLOPE
    + r"\[ (\mathbf z - (\mathbf z^T \mathbf u - b \mathbf x^T \mathbf u) \mathbf u - b \mathbf x)^T \mathbf x = 0 \]",
    "an angle put into the equation above": ANGLES + r"\[ \cos a \cos b = -\cos c \sin a \sin b \]",
    "half an angle": r"We have \[ \sin f = \frac{2 \tan f/2}{1 + \tan^2 f/2} \]",
    "half a sine": r"We have \[ y = \sin x/2 \] hence \[ 2 y = \sin x \]",
    "the same matrix given once more": TWICE + r"\[ P = L A^T + R \]",
    "what rests on Let far above": STEPS + r"\[ z = 2 (a + b)/b \]",
    "labels that are raised in brackets": LABELS + r"\[ v_i^j - (s_i^j)^2 = (r_i^j)^2 \]",
    "a value with a condition on a vector": KNOWN
    + r"\[ \ln p(\mathbf d | z) + \ln p(z) = \ln p(z | \mathbf d) + \ln p(\mathbf d) \]",
}
MISLEADING = {
    "the inverses in the other order": MATRICES + r"\[ X = B^{-1} C A^{-1} \]",
    "both inverses on one side": MATRICES + r"\[ X = A^{-1} B^{-1} C \]",
    "two terms with factors on both sides": (
        r"The matrices satisfy \[ A X + X B = C \] where $A, X, B, C \in \mathbb{R}^{n \times n}$. "
        r"Hence \[ X = (A + B)^{-1} C \]"
    ),
    "a pair of indices without the sign": PAIRS + r"\[ d_{ij} = d_{ji} \]",
    "a pair of which the weights differ": (
        r"The weights are \[ c_{ij} = a_i + b_j \] and \[ c_{ji} = c \] Hence \[ c_{ij} = a_j + b_i \]"
    ),
    "another letter put into the equation above": SLOPE
    + r"\[ (\mathbf z - (\mathbf z^T \mathbf u + b \mathbf x^T \mathbf u) \mathbf u - b \mathbf x)^T \mathbf x = 0 \]",
    "an angle with the other sign": ANGLES + r"\[ \cos a \cos b = \cos c \sin a \sin b \]",
    "half an angle without a factor": r"We have \[ \sin f = \frac{\tan f/2}{1 + \tan^2 f/2} \]",
    "half of a double angle": r"We have \[ \sin 2x/2 = \sin x \]",
    "another matrix": TWICE + r"\[ P = L A^T - R \]",
    "factors turned": r"\section{One} All capitals are matrices. We have \[ P = A B + R \] "
    r"\section{Two} Thus \[ P = B A + R \]",
    "what rests on Let, with a number": STEPS + r"\[ z = 2 (a + b) \]",
    "powers of a power": r"With \[ f = (x^n)^2 \] and \[ g = (y^n)^2 \] we find \[ f g = (x y)^{n + 2} \]",
    "the slope of powers": (
        r"The sum is \[ f = (x^n)^2 + (y^n)^2 \] so its slope is \[ \frac{\partial f}{\partial x} = 0 \]"
    ),
    "a value with a term that is missing": KNOWN + r"\[ \ln p(\mathbf d | z) = \ln p(z | \mathbf d) - \ln p(z) \]",
}


@pytest.mark.parametrize("document", FOLLOWS.values(), ids=FOLLOWS)
def test_follows(document):
    assert read_document(document_of(document))[-1].verdict == "follows"


@pytest.mark.parametrize("document", MISLEADING.values(), ids=MISLEADING)
def test_does_not_follow(document):
    assert read_document(document_of(document))[-1].verdict != "follows"
