r"""What a reader may not assume: that a letter is real, that time stands still, what a sign means."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

MODULUS = r"\[ s = |u|^2 \] Hence \[ s = u^2 \]"
CHAIN = r" Hence \[ \dot V = \frac{\partial V}{\partial x} \dot x \]"
BETWEEN = (
    r"\[ s = \begin{pmatrix} p \\ 1 \end{pmatrix}^T m \begin{pmatrix} q \\ 1 \end{pmatrix} \] Hence "
    r"\[ s = \begin{pmatrix} q \\ 1 \end{pmatrix}^T m \begin{pmatrix} p \\ 1 \end{pmatrix} \]"
)
SOUTH = r" \[ D = s^2 \] Hence \[ \partial_s D = 2 s \]"
MISLEADING = {
    "a plain letter": MODULUS,
    "a velocity": r"Let $u$ be the velocity. " + MODULUS,
    "a norm": r"\[ s = \|u\|^2 \] Hence \[ s = u^2 \]",
    "a value of a function": r"\[ s = |\psi(x)|^2 \] Hence \[ s = \psi(x)^2 \]",
    "a Fourier transform": r"\[ P(\omega) = |F(\omega)|^2 \] Hence \[ P(\omega) = F(\omega)^2 \]",
    "a complex amplitude": r"The amplitude $A$ is complex. \[ P = |A|^2 \] Hence \[ P = A^2 \]",
    "the root": r"\[ s = \sqrt{u^2} \] Hence \[ s = |u| \]",
    "within a sum": r"\[ s = |u^2 + 1| \] Hence \[ s = |u|^2 + 1 \]",
    "a unit by its name": r"Let $z = x + i y$ with the imaginary unit $i$. \[ s = |z|^2 \] Hence \[ s = z^2 \]",
    "a function that changes": r"The function $V(x)$ is given. It also changes with time." + CHAIN,
    "a function of time as well": r"The function $V(x)$ depends explicitly on the time." + CHAIN,
    "what is switched off": r"The potential $V(x)$ is switched off slowly." + CHAIN,
    "what varies": r"The time-varying potential is $V(x)$." + CHAIN,
    "an argument that is not written": r"The function $V(x)$ has a second argument, the time." + CHAIN,
    "a small letter between a row and a column": BETWEEN,
    "a part of a boundary": r"The boundary of the domain in the south is written $\partial_s D$." + SOUTH,
    "another part": r"Here $\partial_s D$ is the southern part of the boundary of $D$." + SOUTH,
    "an urgent value": r"Here $!$ marks an urgent value. Hence \[ 3! = 6 \]",
    "a sinking rate": r"Here $\sin$ denotes the sinking rate as a function of the depth. Hence \[ \sin(0) = 0 \]",
    "a product of a distance": r"Here $dy$ and $dx$ are products. \[ y = x^2 \] Hence \[ \frac{dy}{dx} = 2 x \]",
    "a projection": r"Let $\pi$ be the projection, a number here. Hence \[ \sin\left(\frac{\pi}{2}\right) = 1 \]",
}
FOLLOWS = {
    "a real letter": r"Let $u$ be a real number. " + MODULUS,
    "of the real numbers": r"Let $u \in \mathbb{R}$. " + MODULUS,
    "of an interval": r"Let $u \in [-1, 1]$. " + MODULUS,
    "a letter that is compared": MODULUS.replace("Hence", r"\[ u < 1 \] Hence"),
    "a bold letter": MODULUS.replace("u", r"\mathbf{u}"),
    "the modulus stays as it is": r"\[ s = |u|^2 + u \] Hence \[ s - u = |u|^2 \]",
    "a product": r"\[ s = |a b| \] Hence \[ s = |a| |b| \]",
    "a difference": r"\[ s = |a - b| \] Hence \[ s = |b - a| \]",
    "the parts of a complex number": (
        r"Let $z = x + i y$ with the imaginary unit $i$. \[ s = |z|^2 \] Hence \[ s = x^2 + y^2 \]"
    ),
    "how it changes": r"The function $V(x)$ is given. It changes, at all times, by the chain rule." + CHAIN,
    "a number before a row": BETWEEN.replace("^T m", "^T").replace("s = ", "s = m "),
    "at the boundary": r"\[ u = s^2 \] At the boundary, hence \[ \partial_s u = 2 s \]",
    "the number": r"where $\pi$ is the ratio of a circle and its diameter. Hence \[ \cos\pi = -1 \]",
    "the logarithm": r"where $\ln$ denotes the natural logarithm \[ a = \ln b^2 + c \] Hence \[ a - c = \ln b^2 \]",
}


@pytest.mark.parametrize("latex", MISLEADING.values(), ids=MISLEADING)
def test_nothing_follows_from_what_is_assumed(latex: str) -> None:
    assert read_document(document_of(latex))[-1].verdict not in ("follows", "contradicts")


@pytest.mark.parametrize("latex", FOLLOWS.values(), ids=FOLLOWS)
def test_what_is_said_or_needs_no_assumption_follows(latex: str) -> None:
    assert read_document(document_of(latex))[-1].verdict == "follows"
