"""Letters that displays behind an equation explain, and equations that stand in several sections."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("decided_here")

_MOVES = r"\[ m a + (c + 2 k) v = 0. \] Hence "


def verdicts(latex: str) -> list[str]:
    return [each.verdict for each in read_document(document_of(latex))]


@pytest.mark.parametrize(
    "behind",
    [
        r"\[ M a + C v = 0, \] where \[ M = m \] and \[ C = c + 2 k. \]",
        r"\[ M a + C v = 0, \] where we define \begin{align} M &= m, \\ C &= c + 2 k. \end{align}",
        r"\begin{align} m a + C v &= 0, \\ 3 m a &= -3 C v \end{align} where \[ C = c + 2 k. \]",
        r"\[ m a + C v = 0 \] with \[ C = c + 2 k. \]",
    ],
)
def test_displays_right_behind_say_what_new_letters_are(behind):
    assert verdicts(_MOVES + behind)[1 : 1 + behind.count("v &= 0, \\\\") + 1] == ["follows"] * (
        1 + behind.count("v &= 0, \\\\")
    )


@pytest.mark.parametrize(
    "latex",
    [
        _MOVES + r"\[ m a - C v = 0, \] where \[ C = c + 2 k. \]",
        _MOVES + r"\[ m a + C v = 0, \] where for small speeds \[ C = c + 2 k. \]",
        _MOVES + r"\[ m a + C v = 0. \] In the other tank \[ C = c + 2 k. \]",
        _MOVES + r"\[ m a + C v = 0, \] where \[ C = c + 2 k \quad \text{if } v > 0. \]",
        _MOVES + r"\[ m a + C v = 0, \] where \[ C \approx c + 2 k. \]",
        r"\[ C h = q. \] " + _MOVES + r"\[ m a + C v = 0, \] where \[ C = c + 2 k. \]",
        r"\[ s = \sum_i a_i x_i. \] Hence \[ s = \sum_i b x_i, \] where \[ b = a_i. \]",
    ],
)
def test_no_other_display_says_it(latex):
    assert "follows" not in verdicts(latex)[1:3]


def test_an_equation_may_stand_in_several_sections():
    step = r"The step is \[ x_n + E y_n = a + z. \] "
    assert verdicts(r"\section{A} " + step + r"\section{B} " + step)[1] == "follows"


@pytest.mark.parametrize(
    "between",
    [
        r"This is wrong. \section{B}",
        r"\section{B} We now double $a$.",
        r"\section{B} Here $E$ denotes another number.",
        r"\section{B} We let \[ a = 2 b. \]",
        r"\section{B} If the lid is shut,",
        r"\section{B} A step is good if",
    ],
)
def test_it_does_not_follow_where_its_letters_or_its_case_are_others(between):
    step = r"the step is \[ x_n + E y_n = a + z. \] "
    assert verdicts(rf"\section{{A}} If the lid is open, {step} {between} {step}")[-1] != "follows"
    if "lid" not in between:
        assert verdicts(rf"\section{{A}} So {step} {between} {step}")[-1] != "follows"
