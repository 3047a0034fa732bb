"""A single change by which an equation would follow is named, in whatever way it would; its verdict remains."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")

SQUARES = r"\[ S = \sum_{i=1}^n (y_i - a - b x_i)^2 \] Its derivative is "
STEPS = r"\[ x_{k+1} = x_k + c \] Hence "
TIED = r"\[ n a + b s = t \] \[ a s + b q = p \] Hence "
FIELD = r"""The letters $\mathbf{x}$ and $\mathbf{c}$ are vectors.
\[ f = (\mathbf x - \mathbf c)^T (\mathbf x - \mathbf c) \] """
IMAGINARY = r"The imaginary unit is $i$, with $i^2 = -1$. "


def last(latex):
    return read_document(document_of(latex), seconds=10)[-1]


@pytest.mark.parametrize(
    ("latex", "suggestion"),
    [
        (r"\[ \cos x \cos y = \frac12 (\cos(x + y) - \cos(x - y)) \]", "+"),
        (r"\[ (a + b)^2 = a^2 - 2 a b + b^2 \]", "+"),
        (r"\[ d = a - b + c \] \[ d - a + b + c = 0 \]", "- c"),
        (SQUARES + r"\[ \frac{\partial S}{\partial a} = -3 \sum_{i=1}^n (y_i - a - b x_i) \]", "2 instead of 3"),
        (r"\[ \sum_{i=1}^n (x_i + c) = \sum_{i=1}^n x_i - n c \]", "+"),
        (STEPS + r"\[ x_{k+2} = x_k + 3 c \]", "2 instead of 3"),
        (STEPS + r"\[ x_{k+2} = x_k - 2 c \]", "2*c"),
        (FIELD + r"\[ \nabla_{\mathbf x} f = 2 (\mathbf x + \mathbf c) \]", "- "),
        (IMAGINARY + r"\[ (1 + i)^2 = 3 i \]", "2 instead of 3"),
        (
            r"\[ \frac{\partial f_1}{\partial x_1} \frac{\partial x_1}{\partial x_1} "
            r"= \frac{\partial f_2}{\partial x_1} \]",
            "partialf_1_partialx_1 instead of partialf_2_partialx_1",
        ),
        (
            r"\[ \mathbf K \mathbf S = \mathbf P \] Hence \[ \mathbf x^T \mathbf K \mathbf S = \mathbf x \mathbf P \]",
            "x.T",
        ),
        (
            r"\[ \mathbf r = \mathbf y - \mathbf A \mathbf x \] Hence \[ \mathbf r^T \mathbf r = \mathbf y^T \mathbf y "
            r"- 2 \mathbf y^T \mathbf A \mathbf x + \mathbf x^T \mathbf A \mathbf A \mathbf x \]",
            "A.T instead of A",
        ),
    ],
)
def test_a_misprint_is_told_in_each_way_in_which_an_equation_may_follow(latex, suggestion):
    found = last(latex)
    assert found.verdict in ("independent", "not decided", "definition")
    assert suggestion in found.links[-1].suggestion


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ x + 1 = 1 - x \]",
        r"\[ a + b = a - b \]",
        r"\[ 3 x = 2 x \]",
        r"\[ x_1 y = x_2 y \]",
        r"\[ x^2 - 3 x + 2 = 0 \]",
        r"\[ F = m a \] \[ F = -k x \]",
        r"\[ \frac{x_1}{y_1} = \frac{x_2}{y_2} \]",
        r"\[ S = \sum_{i=1}^n x_i \] \[ \sum_{i=1}^n y_i = 2 c \]",
        STEPS + r"\[ x_{k+2} = y_k + c d. \]",
        TIED + r"\[ b (q + s) = p - t. \]",
    ],
)
def test_nothing_is_suggested_for_what_no_change_makes_follow(latex):
    assert not any(link.suggestion for link in last(latex).links)


def test_what_gives_its_letter_and_is_not_said_to_follow_has_no_suggestion():
    found = last(STEPS.replace("Hence", "The state is") + r"\[ x_{k+2} = x_k + 3 c \]")
    assert (found.verdict, found.links[0].suggestion) == ("definition", "")


def test_a_suggestion_refutes_nothing():
    found = last(STEPS + r"\[ x_{k+2} = x_k - 2 c \]")
    assert found.verdict == "definition"
    assert found.links[0].suggestion


def test_a_factor_that_makes_a_number_a_vector_is_named():
    column = r"\begin{bmatrix} %s \\ %s \end{bmatrix}"
    above = rf"\[ \mathbf x = {column % ('a', 'b')} \] \[ s = a^2 + b^2 \] Hence "
    found = last(above + rf"\[ \mathbf x^T \mathbf x = s {column % (1, 1)} \]")
    assert (found.verdict, found.links[0].suggestion) == ("not decided", "s instead of s*[[1], [1]]")


def test_a_misprint_in_an_equation_of_fields_is_named():
    latex = (
        r"The source is \[ q = \nabla \cdot \mathbf{v}. \] For all fields \[ \nabla \cdot (\mathbf{a} \times "
        r"\mathbf{b}) = \mathbf{b} \cdot (\nabla \times \mathbf{a}) + \mathbf{a} \cdot (\nabla \times \mathbf{b}). \]"
    )
    (link,) = read_document(document_of(latex))[-1].links
    assert link.suggestion == "b*curl(a) - a*curl(b) instead of b*curl(a) + a*curl(b)"
