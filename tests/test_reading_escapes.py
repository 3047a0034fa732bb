r"""Markdown in which ``\_`` is a subscript, and ``\\\\`` the end of a row."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def last(text: str, *, latex: bool = False) -> tuple[str, str]:
    reading = read_document(document_of(text, latex=latex))[-1]
    return reading.verdict, reading.reason


@pytest.mark.parametrize(
    "text",
    [
        r"$$\mathbf{a}\_1 = \mathbf{R}\_{AB} \mathbf{b}$$ $$\mathbf{R}\_{AB} \mathbf{b} = \mathbf{a}\_1$$",
        r"$$q = q\_x^2 + q\_{yz}$$ $$q - q\_{yz} = q\_xq\_x$$",
        r"$$A = \begin{bmatrix} 1 & a \\\\ 0 & 1 \end{bmatrix}$$ "
        r"$$A A = \begin{bmatrix} 1 & 2a \\\\ 0 & 1 \end{bmatrix}$$",
        r"$$b = a^{\*} + c$$ $$a^\* = b - c$$",
    ],
)
def test_what_markdown_escapes_is_read_as_it_is_shown(text):
    assert last(text)[0] == "follows"


@pytest.mark.parametrize(
    "text",
    [
        r"$$a\_1 = b\_{12} + c$$ $$a\_2 = b\_{12} + c$$",
        r"$$A = \begin{bmatrix} a \\\\ b \end{bmatrix}$$ $$A = \begin{bmatrix} b \\\\ a \end{bmatrix}$$",
        r"$$q = q\_x q\_{y}$$ $$q = q x q y$$",
        r"$$b = a^\* + c$$ $$b = a + c$$",
    ],
)
def test_what_is_false_does_not_follow(text):
    assert last(text)[0] != "follows"


def test_an_underscore_of_a_name_is_none_of_a_subscript():
    assert last(r"$$v\_max = a$$")[0] != "follows"
    assert document_of(r"$$v\_max = a$$", latex=False).formulas[0].latex == r"v\_max = a"


def test_an_empty_row_stays_in_latex():
    text = r"\[ A = \begin{bmatrix} a \\\\ b \end{bmatrix} \] \[ 2 A = \begin{bmatrix} 2 a \\ 2 b \end{bmatrix} \]"
    assert last(text, latex=True)[0] != "follows"
    assert last(text.replace(r"\[", "$$").replace(r"\]", "$$"))[0] == "follows"


def test_places_stay():
    (display,) = document_of("a\n$$\n a\\_{1} \\\\\\\\ b\n$$", latex=False).formulas
    assert (display.pieces[-2].place, display.line) == (18, 2)
