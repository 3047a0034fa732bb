r"""Operators with what they are applied to are letters: ``\nabla \cdot u``, ``\frac{D p}{D t}``, and ``e^{A}``."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

_FLOW = (
    r"\[ \frac{D \rho}{D t} = -\rho \nabla \cdot \mathbf{u}, \qquad \frac{D p}{D t} = c^2 \frac{D \rho}{D t}. "
    r"\] Hence "
)


def last(latex: str) -> str:
    return read_document(document_of(latex))[-1].verdict


@pytest.mark.parametrize(
    "latex",
    [
        _FLOW + r"\[ \frac{D p}{D t} = -\rho c^2 \nabla \cdot \mathbf{u}. \]",
        r"\[ s = \frac{D (p - q)}{D t}. \] Hence \[ s + \frac{D q}{D t} = \frac{D p}{D t}. \]",
        r"\[ a + k \nabla^2 f = 0. \] Hence \[ \nabla^2 f = -\frac{a}{k}. \]",
        r"\[ \frac{\partial h}{\partial t} + \nabla \cdot (h \mathbf{u}) = w. \] Hence "
        r"\[ \frac{\partial h}{\partial t} = w - \nabla \cdot (h \mathbf{u}). \]",
    ],
)
def test_what_operators_give_is_computed_with(latex):
    assert last(latex) == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        _FLOW + r"\[ \frac{D p}{D t} = \rho c^2 \nabla \cdot \mathbf{u}. \]",
        r"\[ \frac{D \rho}{D t} = a. \] Hence \[ \frac{D (\rho e)}{D t} = e \frac{D \rho}{D t}. \]",
        r"\[ \frac{\partial \rho}{\partial t} + \nabla \cdot (\rho \mathbf{u}) = 0. \] Hence "
        r"\[ \frac{\partial \rho}{\partial t} + \rho \nabla \cdot \mathbf{u} = 0. \]",
        r"\[ q = \nabla \cdot \mathbf{u} p. \] Hence \[ q = p \nabla \cdot \mathbf{u}. \]",
        r"\[ \mathbf{a} = (\mathbf{u} \cdot \nabla) \mathbf{u}. \] Hence \[ \mathbf{a} = \mathbf{u} (\nabla "
        r"\cdot \mathbf{u}). \]",
        r"\[ g = \nabla^2 f. \] Then \[ \nabla^2 (f^2) = 2 f g. \]",
        r"\[ \mathbf{j} = \nabla \times \mathbf{B}. \] Then \[ \nabla \times (s \mathbf{B}) = s \mathbf{j}. \]",
        r"The diffusivity is $D$. \[ s = \frac{D x}{D t}. \] Hence \[ s + \frac{D a}{D b} = \frac{D (x + a)}{D "
        r"t}. \]",
    ],
)
def test_no_operator_acts_on_a_product_as_on_its_factor(latex):
    assert last(latex) != "follows"


def test_a_letter_that_is_another_one_has_another_derivative():
    latex = (
        "\n# Enthalpy\n\n"
        r"The enthalpy is $h$. Along the path \[ \frac{D h}{D t} = w. \]"
        "\n\n# Depth\n\n"
        r"Here $h$ is the depth of the lake. The surface moves by \[ v = \frac{D h}{D t} + c. \] Hence \[ v = w "
        r"+ c. \]"
    )
    assert last(latex) != "follows"


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (
            r"\[ \mathbf{Y} = e^{\mathbf{A} t} \mathbf{b}. \] Then \[ e^{-\mathbf{A} t} \mathbf{Y} = \mathbf{b}. \]",
            True,
        ),
        (r"\[ \exp(\mathbf{A} - \mathbf{B}) \exp(\mathbf{B} - \mathbf{A}) = \mathbf{I} \]", True),
        (
            r"\[ \mathbf{Y} = e^{\mathbf{A}} e^{\mathbf{B}}. \] Then \[ \mathbf{Y} = e^{\mathbf{A} + \mathbf{B}}. \]",
            False,
        ),
        (
            r"\[ \mathbf{Y} = \exp(-\mathbf{A}) \exp(\mathbf{B}). \] Then "
            r"\[ \exp(\mathbf{A}) \mathbf{Y} = \exp(-\mathbf{B}). \]",
            False,
        ),
        (
            r"\[ \mathbf{Y} = \exp(\mathbf{A}). \] The derivative of $\mathbf{Y}$ is "
            r"\[ \dot{\mathbf{Y}} = \exp(\mathbf{A}) \dot{\mathbf{A}}. \]",
            False,
        ),
        (r"\[ h = \exp(-k t^2). \] Then \[ \frac{d h}{d t} = -2 k t \exp(-k t^2). \]", True),
    ],
)
def test_the_exponential_of_a_matrix_is_a_letter_with_an_inverse(latex, follows):
    assert (last(latex) == "follows") is follows
