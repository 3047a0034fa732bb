"""Equations of vectors and matrices solved for a letter."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

_NORMAL = r"\[ (\mathbf{X}^T \mathbf{X}) \mathbf{b} = \mathbf{X}^T \mathbf{y} \] So "
_MOVED = r"\[ \mathbf{f} + \mathbf{M} \mathbf{a} - \mathbf{g} = \mathbf{C} \mathbf{a} + \mathbf{h} \] Hence "
_GAIN = r"\[ \mathbf{K} \mathbf{S} = \mathbf{P} \mathbf{H}^T \] Hence "


def last(latex: str):
    return read_document(document_of(latex))[-1]


@pytest.mark.parametrize(
    "latex",
    [
        _NORMAL + r"\[ \mathbf{b} = (\mathbf{X}^T \mathbf{X})^{-1} \mathbf{X}^T \mathbf{y} \]",
        _MOVED + r"\[ \mathbf{a} = (\mathbf{M} - \mathbf{C})^{-1} (\mathbf{g} + \mathbf{h} - \mathbf{f}) \]",
        _MOVED + r"\[ \mathbf{g} = \mathbf{f} - \mathbf{h} + (\mathbf{M} - \mathbf{C}) \mathbf{a} \]",
        _MOVED + r"\[ 2 \mathbf{h} = 2 (\mathbf{f} - \mathbf{g}) + 2 (\mathbf{M} - \mathbf{C}) \mathbf{a} \]",
        _GAIN + r"\[ \mathbf{K} = \mathbf{P} \mathbf{H}^T \mathbf{S}^{-1} \]",
        r"\[ \frac{\mathbf{A} (\mathbf{x} - \mathbf{c})}{2} = \mathbf{d} \] "
        r"Hence \[ \mathbf{x} = \mathbf{c} + 2 \mathbf{A}^{-1} \mathbf{d} \]",
        r"\[ \mathbf{u} + \mathbf{r} \times \mathbf{s} = m \mathbf{a} \] "
        r"Hence \[ \mathbf{u} = m \mathbf{a} - \mathbf{r} \times \mathbf{s} \]",
    ],
)
def test_an_equation_of_vectors_gives_each_letter_in_which_it_is_linear(latex):
    assert last(latex).verdict == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        _NORMAL + r"\[ \mathbf{b} = \mathbf{X}^T \mathbf{y} (\mathbf{X}^T \mathbf{X})^{-1} \]",
        _NORMAL + r"\[ \mathbf{b} = (\mathbf{X} \mathbf{X}^T)^{-1} \mathbf{X}^T \mathbf{y} \]",
        _MOVED + r"\[ \mathbf{a} = (\mathbf{M} + \mathbf{C})^{-1} (\mathbf{g} + \mathbf{h} - \mathbf{f}) \]",
        _MOVED + r"\[ \mathbf{a} = (\mathbf{M} - \mathbf{C})^{-1} (\mathbf{g} - \mathbf{h} - \mathbf{f}) \]",
        _MOVED + r"\[ \mathbf{g} = \mathbf{f} - \mathbf{h} + \mathbf{M} \mathbf{a} \]",
        _GAIN + r"\[ \mathbf{K} = \mathbf{S}^{-1} \mathbf{P} \mathbf{H}^T \]",
        _GAIN + r"\[ \mathbf{P} = \mathbf{K} \mathbf{S} \mathbf{H}^{-1} \]",
        r"\[ \mathbf{A} \mathbf{x} + \mathbf{y} = \mathbf{A} \mathbf{x} + \mathbf{z} \] "
        r"So \[ \mathbf{x} = \mathbf{w} \]",
        r"\[ \mathbf{A} \mathbf{x} + \mathbf{y} = \mathbf{A} \mathbf{x} + \mathbf{z} \] "
        r"So \[ \mathbf{x} = \mathbf{y} \]",
        r"\[ \mathbf{B} = -\mathbf{A} \] \[ \mathbf{A} \mathbf{x} + \mathbf{B} \mathbf{x} + \mathbf{w} = \mathbf{z} \] "
        r"So \[ \mathbf{x} = \mathbf{z} \]",
        r"\[ \mathbf{r} \times \mathbf{x} = \mathbf{y} \] So \[ \mathbf{x} = \mathbf{r}^{-1} \mathbf{y} \]",
        r"\[ [\mathbf{r}]_\times \mathbf{x} = \mathbf{y} \] So \[ \mathbf{x} = [\mathbf{r}]_\times^{-1} \mathbf{y} \]",
        r"\[ \mathbf{u} \mathbf{u}^T \mathbf{x} = \mathbf{y} \] So "
        r"\[ \mathbf{x} = (\mathbf{u} \mathbf{u}^T)^{-1} \mathbf{y} \]",
        r"\[ \mathbf{u}^T \mathbf{x} = c \] So \[ \mathbf{x} = \mathbf{u}^{-T} c \]",
        r"\[ \mathbf{A} \mathbf{x} = \lambda \mathbf{x} \] So \[ \mathbf{x} = \mathbf{0} \]",
        r"The matrix $A$ is singular. \[ A \mathbf{x} = \mathbf{b} \] So \[ \mathbf{x} = A^{-1} \mathbf{b} \]",
        r"Let $A \in \mathbb{R}^{m \times n}$. \[ A \mathbf{x} = \mathbf{b} \] So \[ \mathbf{x} = A^{-1} \mathbf{b} \]",
        r"For a wide matrix $\mathbf{A}$, \[ \mathbf{A} \mathbf{x} + \mathbf{c} = \mathbf{b} + \mathbf{d} \] "
        r"So \[ \mathbf{x} = \mathbf{A}^{-1} (\mathbf{b} + \mathbf{d} - \mathbf{c}) \]",
        r"If $\mathbf{c}$ is small, \[ \mathbf{A} \mathbf{x} = \mathbf{c} + \mathbf{x} \] Otherwise "
        r"\[ \mathbf{x} = (\mathbf{A} - \mathbf{I})^{-1} \mathbf{c} \]",
    ],
)
def test_no_factor_changes_its_side_and_nothing_singular_is_inverted(latex):
    assert last(latex).verdict not in ("follows", "contradicts")


def test_a_letter_is_said_once_not_to_be_zero():
    law = r"Snell's law is \[ n_1 \sin a_1 = n_2 \sin a_2. \] "
    angle = r"Thus the angle is \[ a_2 = \arcsin\left(\frac{n_1}{n_2} \sin a_1\right). \]"
    *_, last = read_document(document_of(law + angle))
    assert last.verdict == "follows"
    assert last.links[0].hypotheses[:2] == ("-pi/2 <= a_2 <= pi/2", "n_2 != 0")


def test_an_equation_is_solved_for_the_letter_that_is_asked_for():
    (link,) = last(
        r"The torque is \[ a \mathbf{w}^T \mathbf{r} + (c + d) s = -a p q + t. \] Hence "
        r"\[ s = \frac{t - a \mathbf{w}^T \mathbf{r} - a p q}{c + d}. \]"
    ).links
    assert link.hypotheses == ("c + d", "w is nx1", "r is nx1")


def test_no_equation_is_solved_for_the_identity():
    (link,) = last(
        r"Let $R$ be a rotation matrix. "
        r"\[ [\mathbf{w}]_\times^2 = \mathbf{w} \mathbf{w}^T - (\mathbf{w}^T \mathbf{w}) I \] Hence \[ R^T R = I \]"
    ).links
    assert link.rests_on == ()
    assert "I is the identity" in link.hypotheses
