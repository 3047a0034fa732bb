"""What holds in a case, said before or behind an equation, serves no longer where another one is spoken of."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def last_of(latex):
    return read_document(document_of(latex, latex=True), seconds=5)[-1]


@pytest.mark.parametrize(
    ("before", "behind", "then"),
    [
        ("", "for even $n$.", "For odd $n$ it follows that"),
        ("", "provided that the valve is shut.", "We open the valve. Then"),
        ("", "as long as the valve is shut.", "We open the valve. Then"),
        ("", "only if the lid is on.", "Without the lid, we get"),
        ("As long as the film is loaded,", "", "After unloading the film, we get"),
        ("Provided that the film is loaded,", "", "After unloading the film, we get"),
        ("If the camera is calibrated, then", "", "Returning to the uncalibrated camera, we obtain"),
        ("When the shutter is open,", "", "The shutter is shut. Then"),
        ("With probability one half,", "", "Always, we have"),
        ("Usually", "", "In every experiment"),
        ("Were the Earth a sphere, then", "", "On the real Earth"),
        ("Had the Moon no mass, then", "", "The Moon has a mass, so"),
    ],
)
def test_what_holds_in_a_case_serves_no_longer_where_another_one_is_spoken_of(before, behind, then):
    assert last_of(rf"{before} \[ w = x + y \] {behind} {then} \[ w - x = y. \]").verdict != "follows"


@pytest.mark.parametrize(
    ("before", "behind", "then"),
    [
        ("", "for even $n$.", "Hence"),
        ("", "provided that the valve is shut.", "Therefore"),
        ("If the camera is calibrated, then", "", "Hence we obtain"),
        ("As long as the film is loaded,", "", "It follows that"),
        ("If we repeat this for the other side, we get", "", "The auxiliary letters are known. Hence"),
        ("", "for all the even steps.", "Hence"),
    ],
)
def test_a_case_goes_on_where_nothing_else_is_spoken_of(before, behind, then):
    assert last_of(rf"{before} \[ w = x + y \] {behind} {then} \[ w - x = y. \]").verdict == "follows"


@pytest.mark.parametrize(
    ("words", "special"),
    [(r"We see that $g = 2 c$.", False), (r"For $g = 2 c$,", True), (r"This is such that $g = 2 c$.", True)],
)
def test_that_is_no_at(words, special):
    latex = rf"{words} We have \[ u v = k w. \] \section{{Next}} It is \[ u = \frac{{k w}}{{v}} + r. \]"
    found = read_document(document_of(latex))[0].links[0].reason
    assert ("may limit it" in found) is special
