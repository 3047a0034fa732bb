r"""Complex numbers in documents: the imaginary unit is known by its use, and functions have principal values."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

SPOKEN = r"These are complex numbers. We use \[ e^{i t} = \cos t + i \sin t. \] "
POINT = SPOKEN + r"\[ z = x + i y. \] "


def last(latex):
    return read_document(document_of(latex), seconds=5)[-1]


@pytest.mark.parametrize(
    "latex",
    [
        SPOKEN,
        SPOKEN + r"\[ e^{2 \pi i} = 1 \]",
        SPOKEN + r"\[ (a + i b)(a - i b) = a^2 + b^2 \]",
        SPOKEN + r"\[ \cos t = \frac{e^{it} + e^{-it}}{2} \]",
        SPOKEN + r"\[ e^{(a+ib)t} = e^{at} (\cos (bt) + i \sin (bt)) \]",
        SPOKEN + r"\[ |e^{it}| = 1 \]",
        SPOKEN
        + r"\[ \begin{pmatrix} e^{it} \\ i^2 \end{pmatrix} = \begin{pmatrix} \cos t + i \sin t \\ -1 \end{pmatrix} \]",
        POINT + r"\[ |z|^2 = x^2 + y^2 \]",
        POINT + r"\[ \frac1z = \frac{x - i y}{x^2 + y^2} \]",
        POINT + r"\[ e^z = e^x (\cos y + i \sin y) \]",
        r"Here $j = \sqrt{-1}$. \[ \frac{1}{j w c} = -\frac{j}{w c} \]",
        r"Here $i^2 = -1$. \[ (1 + i)^2 = 2 i \]",
        r"\[ e^{i t} e^{-i t} = 1 \]",
        r"Let $z$ be a complex number. \[ |z|^2 = |z^2| \]",
        r"Let $z \in \mathbb{C}$, where $i$ is the square root of $-1$. \[ e^{i z} = \cos z + i \sin z \]",
        r"\[ |e^x| = e^x \]",
    ],
)
def test_what_holds_of_complex_numbers_follows(latex):
    assert last(latex).verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        SPOKEN + r"\[ |e^{it}| = e^{it} \]",
        SPOKEN + r"\[ \ln e^{it} = i t \]",
        SPOKEN + r"\[ \ln e^{z + i t} = z + i t \]",
        SPOKEN + r"\[ \sqrt{e^{2it}} = e^{it} \]",
        SPOKEN + r"\[ (e^{it})^{a} = e^{i a t} \]",
        SPOKEN + r"\[ e^{2 \pi i a} = 1 \]",
        SPOKEN + r"\[ e^{\pi i} = 1 \]",
        SPOKEN + r"\[ \frac{1}{i} = i \]",
        SPOKEN + r"\[ i^2 = 1 \]",
        SPOKEN + r"\[ |a + i b| = a + b \]",
        SPOKEN + r"\[ |a + i b|^2 = a^2 - b^2 \]",
        SPOKEN + r"\[ \Re (a + i b) = a + b \]",
        SPOKEN + r"\[ i \sqrt{-1} \sqrt{-1} = i \]",
        POINT + r"\[ |z|^2 = z^2 \]",
        POINT + r"\[ \sqrt{z^2} = z \]",
        POINT + r"\[ \ln z^2 = 2 \ln z \]",
        POINT + r"\[ w = |z| \] \[ w^2 = z^2 \]",
        POINT + r"\[ \bar z = x - i y \] \[ |z| = \bar z \]",
        POINT + r"\[ u = 2 z. \] \[ |u| = u \]",
        SPOKEN + r"The complex number $z$ has \[ z e^{it} = c \] \[ |z|^2 = z^2 \]",
        SPOKEN + r"\[ x + i y = z. \] \[ |z|^2 = z^2 \]",
        SPOKEN + r"\[ \cos t = \Re w = e^{it} - i \sin t. \] \[ |w| = \sqrt{w^2} \] \[ \sqrt{z^2} = z \]",
        r"Let $z \in \mathbb{C}$. \[ |z|^2 = z^2 \]",
        r"Let $a, b \in \mathbb C$. \[ \sqrt{a} \sqrt{b} = \sqrt{a b} \]",
        r"\[ |e^{it}| = e^{it} \]",
        r"\[ \ln e^{it} = i t \]",
        r"\[ \sqrt{e^{2jt}} = e^{jt} \]",
        r"Let $a$ and $b$ be complex numbers. \[ \ln (a b) = \ln a + \ln b \]",
        r"The complex numbers $a$ and $b$ have \[ \sqrt{a} \sqrt{b} = \sqrt{a b} \]",
        r"Let $z$ be complex. \[ w := 2 z \] \[ |w| = w \]",
        r"Complex numbers: \[ \sum_{i=1}^n e^{i t} = n (\cos t + i \sin t) \]",
        r"Complex numbers $x_i$: \[ e^{i t} = \cos t + i \sin t \] \[ 2 x_i = x_1 \]",
        r"It is complex. The rate is $i = r + s$. \[ e^{i t} = \cos t + i \sin t \]",
        r"It is complex. The angle has $\cos i$. \[ e^{i t} = \cos t + i \sin t \]",
        r"The rate $i$ gives \[ c = e^{i t}. \] \[ c^2 = \cos (2t) + i \sin (2t) \]",
        r"Let $z \in \mathbb{C}$. The current is $i$. \[ e^{i z} = \cos z + i \sin z \]",
        r"Let $z$ be complex. \[ \sqrt{-z} = i \sqrt{z} \]",
        r"Let $z \in \mathbb{C}$. \[ \sqrt{z^2 - 1} = i \sqrt{1 - z^2} \]",
        r"Let $u$ and $v$ be complex. \[ u^2 + v^2 = 0 \] Hence \[ u = 2 v \]",
        SPOKEN + r"The current is $I$. \[ I = a + b. \] \[ I^2 = -1 \]",
    ],
)
def test_what_does_not_hold_of_complex_numbers_does_not_follow(latex):
    assert last(latex).verdict not in ("follows", "contradicts")


def test_the_reading_is_shown():
    (link,) = last(SPOKEN + r"\[ |e^{it}| = 1 \]").links
    assert link.hypotheses[:2] == ("i is the imaginary unit", "letters are real unless complex ones give them")


def test_a_huge_complex_number_is_no_sample():
    text = r"With the imaginary unit, $i^2 = -1$, \[ z = a + i b. \] \[ z = 15 \cdot 10^{307} (1 + i) e^{i a}. \]"
    assert [each.verdict for each in read_document(document_of(text))] == ["definition", "definition"]
