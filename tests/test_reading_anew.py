r"""Letters that get another meaning, or that something is done to: what was said of them before serves no longer."""

import json
from pathlib import Path

import pytest

from algebroproj_sym.reading import document_at, document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def _last(text: str, *, latex: bool = True) -> str:
    return read_document(document_of(text, latex=latex), seconds=5)[-1].verdict


ANEW = [
    (r"\section{Floors}", r"The pressure is $p$."),
    (r"\chapter{Floors}", r"With the pressure $p$ we go on."),
    (r"\subsubsection{Floors}", r"A pressure $p$ presses on it."),
    (r"\appendix", r"In what follows $p$ is a pressure."),
    (r"\section{Pressure $p$}", ""),
    (r"\section{Floors}", r"with $p = 3.2$ the pressure,"),
    (r"\section{Floors}", r"Let $p = 3 h$ be the pressure."),
    (r"\section{Floors}", r"We denote the pressure by $p$."),
    (r"\section{Floors}", r"\begin{itemize}\item $A$ is the area,\item $p$ is the pressure.\end{itemize}"),
    (r"\section{Floors}", r"The letters: $A$: area, $p$: pressure."),
]


@pytest.mark.parametrize(("heading", "words"), ANEW)
def test_a_letter_that_another_section_calls_something_else_is_not_what_it_was(heading: str, words: str) -> None:
    before = rf"\section{{Bodies}} The momentum is \[ p = m v. \] {heading} {words} \[ F = A p \]"
    assert _last(rf"{before} Hence \[ F = A m v. \]") != "follows"
    assert _last(rf"{before.replace('pressure', 'momentum')} Hence \[ F - A p = 0. \]") == "follows"


@pytest.mark.parametrize(
    "words",
    [
        "The momentum is $p$.",
        "With the total momentum $p$ we go on.",
        "We know that",
        "The caller supplies a fixed $p$.",
        "We separate the components involving $p$.",
    ],
)
def test_a_letter_that_another_section_calls_the_same_is_what_it_was(words: str) -> None:
    before = rf"\section{{Bodies}} The momentum is \[ p = m v. \] \section{{Floors}} {words} \[ F = A p. \]"
    assert _last(rf"{before} Hence \[ F = A m v. \]") == "follows"


@pytest.mark.parametrize(
    "between",
    [
        "# Floors\n\nThe pressure is $p$.\n\n",
        "---\n\nWith the pressure $p$ we have\n\n",
        "# Pressure $p$\n\n",
        "# Floors\n\n| letter | meaning |\n|---|---|\n| $p$ | pressure |\n\n",
    ],
)
def test_a_section_of_markdown_may_give_a_letter_another_meaning(between: str) -> None:
    before = f"# Bodies\n\nThe momentum is\n\n$$ p = m v $$\n\n{between}$$ F = A p $$\n\nHence\n\n"
    assert _last(f"{before}$$ F = A m v $$\n", latex=False) != "follows"


def test_a_cell_of_a_notebook_may_give_a_letter_another_meaning(tmp_path: Path) -> None:
    cells = ["## Bodies\n$$ p = m v $$", "## Floors\nPressure is $p$.\n$$ F = A p $$\nThus\n$$ F = A m v $$"]
    book = {"cells": [{"cell_type": "markdown", "metadata": {}, "source": each} for each in cells], "nbformat": 4}
    path = tmp_path / "book.ipynb"
    path.write_text(json.dumps(book), encoding="utf-8")
    assert read_document(document_at(path), seconds=5)[-1].verdict != "follows"


def test_a_slide_may_give_a_letter_another_meaning() -> None:
    before = (
        r"\begin{frame}{Bodies} The momentum is \[ p = m v. \] \end{frame} \begin{frame}{Floors} The pressure is $p$."
    )
    assert _last(rf"{before} \[ F = A p \] Thus \[ F = A m v. \] \end{{frame}}") != "follows"


@pytest.mark.parametrize(
    ("words", "follows"),
    [
        ("Then $p$ is squared.", False),
        ("We now mirror $p$ at the wall.", False),
        ("We change the sign of $p$.", False),
        ("Replace $p$ by its mean.", False),
        ("One finally turns $p$ around.", False),
        ("In the second run $p$ is put to zero.", False),
        ("Add one to $p$.", False),
        ("The momentum $p$ jumps.", False),
        ("We write $p$ for the mean of $p$.", False),
        ("Here $p$ is given by the balance.", True),
        ("We know $p$ from the scale.", True),
        ("The momentum $p$ depends on the speed.", True),
        ("We measure $p$ with a scale.", True),
        ("The $p$ values are known.", True),
    ],
)
def test_a_letter_that_something_is_done_to_is_no_longer_what_it_was(words: str, follows: bool) -> None:
    found = _last(rf"\[ p = m v \] {words} \[ F = A p \] Hence \[ F = A m v. \]")
    assert (found == "follows") is follows


def test_what_an_equation_gives_may_be_changed_right_behind_it() -> None:
    assert _last(r"\[ p = m v \] is then rounded. Hence \[ 2 p = 2 m v. \]") != "follows"


@pytest.mark.parametrize(
    ("words", "follows"),
    [
        ("The step $h$ shrinks with each of them.", False),
        ("The step $h$ is quartered after each of them.", False),
        ("We halve $h$ after each of them.", False),
        ("The step $h$ is given.", True),
    ],
)
def test_a_letter_that_something_is_done_to_at_each_step_is_not_the_same_at_the_next(words: str, follows: bool) -> None:
    found = _last(rf"{words} \[ x_{{k+1}} = x_k + h \] Hence \[ x_{{k+2}} = x_k + 2 h. \]")
    assert (found == "follows") is follows


def test_the_same_value_printed_twice_is_no_other_value() -> None:
    value = r"J = m (\|x\|^2 I_{3 \times 3} - x x^T)"
    inertia = rf"In the frame of the body we define \[ {value.replace('=', ':=')} \] \section{{Frames}} "
    inertia += rf"A particle has \[ {value} \] "
    text = (
        inertia
        + r"In the frame of the body the radius is \[ K = 2 m. \] Hence \[ J = m \|x\|^2 I_{3 \times 3} - m x x^T. \]"
    )
    assert _last(text) == "follows"
