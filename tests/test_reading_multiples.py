"""What is not computed is one letter: sums of its multiples are compared, and nothing else of it."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")


def last(latex: str) -> str:
    return read_document(document_of(latex))[-1].verdict


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ q = c a \star b + d. \] Hence \[ c a \star b = q - d. \]",
        r"\[ u = v - t \nabla h. \] \[ v = w + t g. \] Hence \[ u = w + t g - t \nabla h. \]",
        r"\[ \nabla h = \frac{w}{k}. \] Hence \[ w = k \nabla h. \]",
        r"\[ q + \partial_x H \partial_x h = 2 q. \] Hence \[ q = \partial_x H \partial_x h. \]",
        r"\[ (a, b) = (c, d) + t \mathbf{F}. \] Hence \[ t \mathbf{F} = (a, b) - (c, d). \]",
        r"\[ s = \frac{\mathbf{u} \star \mathbf{v}}{n}. \] \[ n = 2 m. \] Hence "
        r"\[ s = \frac{\mathbf{u} \star \mathbf{v}}{2 m}. \]",
    ],
)
def test_multiples_of_what_is_not_computed_are_added(latex):
    assert last(latex) == "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ q = a \star b. \] Hence \[ q = b \star a. \]",
        r"\[ q = a \oplus b. \] Hence \[ 2 q = (2 a) \oplus (2 b). \]",
        r"\[ q = \partial_x H \partial_x h. \] Hence \[ q = H \partial_x \partial_x h. \]",
        r"\[ q = h \nabla \star v. \] Hence \[ q = \nabla h \star v. \]",
        r"\[ (\mathbf{u} \cdot \nabla) h = q \star r. \] Hence \[ h (\mathbf{u} \cdot \nabla) = q \star r. \]",
        r"\[ f = \mathbf{A} \star \mathbf{x}. \] \[ g = \mathbf{x} \star \mathbf{A}. \] Hence \[ f = g. \]",
        r"\[ u = a \star b. \] \[ v = c \star d. \] Hence \[ u v - v u = 0. \]",
        r"\[ s = n a_i \star b. \] Hence \[ s = \sum_{i=1}^n a_i \star b. \]",
        r"\[ q = a \star b. \] \[ a = 3 c. \] Hence \[ q = 3 a \star b. \]",
        r"\[ f(x) = x \star c. \] Hence \[ f(2) = x \star c. \]",
        r"\[ x = \frac{1}{\nabla h}. \] Hence \[ x \nabla h = 2. \]",
        r"\[ x = c + \nabla h. \] Then $h$ is doubled. Hence \[ x = c + \nabla h. \]",
    ],
)
def test_nothing_else_is_done_with_it(latex):
    assert last(latex) != "follows"
