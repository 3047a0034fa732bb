"""Vectors by their components along unit vectors that are perpendicular to each other."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")

_MOTION = (
    r"The unit vectors are $\hat{i}$ and $\hat{j}$. \[ \vec{r} = x \hat{i} + y \hat{j} \] "
    r"\[ \vec{F} = p \hat{i} - m g \hat{j} \] "
)
_BASIS = (
    r"\[ \vec{a} = a_1 \hat{e}_1 + a_2 \hat{e}_2 + a_3 \hat{e}_3 \] "
    r"\[ \vec{b} = b_1 \hat{e}_1 + b_2 \hat{e}_2 + b_3 \hat{e}_3 \] "
)
_ORTHONORMAL = r"The basis $\hat{e}_1, \hat{e}_2, \hat{e}_3$ is orthonormal. " + _BASIS


def last(latex: str) -> str:
    return read_document(document_of(latex))[-1].verdict


@pytest.mark.parametrize(
    "latex",
    [
        _MOTION + r"\[ \vec{r} \cdot \vec{F} = p x - m g y \]",
        _MOTION + r"\[ |\vec{r}| = \sqrt{x^2 + y^2} \]",
        _MOTION + r"\[ \vec{F} = k \vec{r} \] \[ -m g = k y \]",
        _ORTHONORMAL + r"\[ \vec{a} \cdot \vec{b} = a_1 b_1 + a_2 b_2 + a_3 b_3 \]",
        _ORTHONORMAL + r"\[ \vec{a} \cdot \hat{e}_2 = a_2 \]",
        _ORTHONORMAL + r"\[ \vec{a} \times \hat{e}_3 = a_2 \hat{e}_1 - a_1 \hat{e}_2 \]",
        _ORTHONORMAL + r"\[ \vec{a} = \vec{b} \times \vec{c} \] \[ \vec{b} \cdot \vec{a} = \vec{b} \cdot "
        r"(\vec{b} \times \vec{c}) \]",
    ],
)
def test_what_holds_by_components_follows(latex):
    assert last(latex) == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        _MOTION + r"\[ \vec{r} \cdot \vec{F} = p x + m g y \]",
        _MOTION + r"\[ \vec{r} \cdot \vec{F} = p y - m g x \]",
        _MOTION + r"\[ \vec{F} = k \vec{r} \] \[ -m g = k x \]",
        _MOTION + r"\[ \vec{r} \times \vec{F} = (p y + m g x) \hat{k} \]",
        _BASIS + r"\[ \vec{a} \cdot \vec{b} = a_1 b_1 + a_2 b_2 + a_3 b_3 \]",
        "These are unit vectors. " + _BASIS + r"\[ \vec{a} \cdot \vec{b} = a_1 b_1 + a_2 b_2 + a_3 b_3 \]",
        "These unit vectors are not orthogonal. " + _BASIS + r"\[ \vec{a} \cdot \hat{e}_2 = a_2 \]",
        "The orthonormal basis of before is replaced by an oblique basis. "
        + _BASIS
        + r"\[ \vec{a} \cdot \hat{e}_2 = a_2 \]",
        _ORTHONORMAL + r"\[ \vec{a} \cdot \vec{b} = a_1 b_1 + a_2 b_2 \]",
        _ORTHONORMAL + r"\[ \vec{a} \times \hat{e}_3 = a_1 \hat{e}_2 - a_2 \hat{e}_1 \]",
        _ORTHONORMAL + r"\[ \hat{e}_1 = \cos(q) \hat{n}_1 + \sin(q) \hat{n}_2 \] \[ \hat{n}_1 \cdot \hat{e}_1 = 1 \]",
        r"The bases $\hat{e}$ and $\hat{n}$ of unit vectors are orthonormal. "
        r"\[ \vec{a} = a_1 \hat{e}_1 + a_2 \hat{e}_2 \] \[ \vec{b} = b_1 \hat{n}_1 + b_2 \hat{n}_2 \] "
        r"\[ \vec{a} \cdot \vec{b} = a_1 b_1 + a_2 b_2 \]",
        r"The estimates of i and j are $\hat{i}$ and $\hat{j}$. \[ s = \hat{i} + \hat{j} \] \[ s^2 = 2 \]",
        r"A unit vector is v. \[ s = \hat{i} + \hat{j} \] \[ s^2 = \hat{i}^2 + \hat{j}^2 \]",
    ],
)
def test_what_no_words_say_of_a_basis_is_not_taken_for_granted(latex):
    assert last(latex) != "follows"
