"""Roots of any degree, both roots of a quadratic equation, and second derivatives by time."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

SPHERE = r"The volume is \[ V = \frac43 \pi r^3. \] Hence the radius is "
MONIC = r"We have \[ x^2 + 2 b x + c = 0. \] Hence "
SWINGS = r"The position is \[ x = A \cos(\omega t). \] Therefore "
LENGTH = r"Of vectors, \[ \mathbf{v} = s \mathbf{a}. \] Hence "
MEAN = r"The variance is \[ \sigma^2 = \mathbb{E}[(x - m)^2] \] where $m = \mathbb{E}[x]$ is the expected value. Hence "


def last_of(latex):
    return read_document(document_of(latex, latex=True))[-1]


@pytest.mark.parametrize(
    "latex",
    [
        MONIC + r"\[ x = -b \pm \sqrt{b^2 - c}. \]",
        r"The roots of \[ a x^2 + b x + c = 0 \] are \[ x = \frac{-b \pm \sqrt{b^2 - 4 a c}}{2 a}. \]",
        r"We have \[ \lambda^2 + \omega^2 - 2 \gamma \lambda = 0. \] So "
        r"\[ \lambda_{1,2} = \gamma \pm \sqrt{\gamma^2 - \omega^2}. \]",
        SPHERE + r"\[ r = \sqrt[3]{\frac{3 V}{4 \pi}}. \]",
        r"We have \[ T^2 = \frac{4 \pi^2}{G M} r^3. \] Hence \[ r = \left( \frac{G M T^2}{4 \pi^2} \right)^{1/3}. \]",
        r"We have \[ P = \sigma T^4. \] Hence the temperature is \[ T = \left( \frac{P}{\sigma} \right)^{1/4}. \]",
        SWINGS + r"\[ \ddot x = -\omega^2 x. \]",
        r"The position is \[ x(t) = A \cos(\omega t). \] Therefore \[ \frac{d^2 x}{dt^2} = -\omega^2 x. \]",
        MEAN + r"\[ \sigma^2 = \mathbb{E}[x^2] - m^2. \]",
        LENGTH + r"\[ \|\mathbf{v}\| = s \|\mathbf{a}\|. \]",
        LENGTH.replace("s ", "-2 ") + r"\[ \|\mathbf{v}\| = 2 \|\mathbf{a}\|. \]",
    ],
)
def test_it_follows(latex):
    assert last_of(latex).verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        MONIC + r"\[ x = b \pm \sqrt{b^2 - c}. \]",
        MONIC + r"\[ x = -b \pm \sqrt{b^2 + c}. \]",
        MONIC + r"\[ x = -b \pm \frac{\sqrt{b^2 - c}}{2}. \]",
        MONIC + r"\[ y = -b \pm \sqrt{b^2 - c}. \]",
        r"The roots of \[ a x^2 + b x + c = 0 \] are \[ x = \frac{-b \pm \sqrt{b^2 - 4 a c}}{a}. \]",
        SPHERE + r"\[ r = \sqrt[3]{\frac{4 V}{3 \pi}}. \]",
        SPHERE + r"\[ r = \sqrt{\frac{3 V}{4 \pi}}. \]",
        r"We have \[ P = \sigma T^4. \] Hence the temperature is \[ T = -\left( \frac{P}{\sigma} \right)^{1/4}. \]",
        r"We have \[ y = x^4. \] Hence \[ x = y^{1/4}. \]",
        SWINGS + r"\[ \ddot x = \omega^2 x. \]",
        SWINGS.replace("There", r"The amplitude falls, \[ \dot A = -k A. \] There") + r"\[ \ddot x = -\omega^2 x. \]",
        SWINGS.replace("There", r"Here \[ \omega = c t. \] There") + r"\[ \ddot x = -\omega^2 x. \]",
        MEAN + r"\[ \sigma^2 = \mathbb{E}[x^2] + m^2. \]",
        LENGTH + r"\[ \|\mathbf{v}\| = 2 s \|\mathbf{a}\|. \]",
        LENGTH.replace("s ", "-2 ") + r"\[ \|\mathbf{v}\| = -2 \|\mathbf{a}\|. \]",
        LENGTH.replace("s ", "2 ") + r"\[ \|\mathbf{v}\| = -2 \sqrt{\mathbf{a} \cdot \mathbf{a}}. \]",
        r"The matrices have \[ \mathbf{A} = \sqrt{2} \mathbf{C} \] and "
        r"\[ \mathbf{B} \mathbf{B} = 4 \mathbf{C} \mathbf{C}. \] Hence \[ \sqrt{2} \mathbf{A} = \mathbf{B}. \]",
        r"We have \[ a = 4. \] Hence \[ \sqrt a = -2. \]",
        r"We have \[ a = 4. \] Hence \[ \frac{\sqrt a}{-2} = 1. \]",
        r"We have \[ a = (1 + b^2)^2. \] Hence \[ \sqrt a = -1 - b^2. \]",
    ],
)
def test_it_does_not_follow(latex):
    assert last_of(latex).verdict != "follows"
