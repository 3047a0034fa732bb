"""Columns of which a document names the components, beside printed matrices."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

FORM = r"\[ x_1^2 + 2 x_1 x_2 + 5 x_2^2 + 4 x_2 x_3 + x_3^2 = x^T "
GRAM = r"\begin{pmatrix} 1 & 1 & 0 \\ 1 & 5 & 2 \\ 0 & 2 & 1 \end{pmatrix} x \]"


def last(latex):
    return read_document(document_of(latex), seconds=5)[-1]


def test_a_form_is_that_of_the_components():
    found = last(FORM + GRAM)
    assert found.verdict == "follows"
    assert found.links[0].rests_on == ("x_1 to x_3 as the components of x",)


@pytest.mark.parametrize(
    "latex",
    [
        FORM + GRAM.replace("5", "6"),
        r"\[ x = a + b \] " + FORM + GRAM,
        FORM.replace("x_3^2", "x_3^2 + 0 x_4") + GRAM,
        FORM + GRAM.replace("x", "y"),
    ],
)
def test_it_is_not_where_the_components_or_the_letter_are_others(latex):
    assert last(latex).verdict not in ("follows", "contradicts")
