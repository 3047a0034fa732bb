"""What a document denies: nothing follows where a letter is not zero, or a matrix invertible, that words say is not."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def last_of(latex):
    return read_document(document_of(latex, latex=True), seconds=5)[-1]


@pytest.mark.parametrize(
    "words",
    [
        "Let $A$ be singular.",
        "The matrix $A$ has a rank defect.",
        "The matrix $A$ is rank deficient.",
        "The matrix $A$ is not invertible.",
        r"Here $\det A = 0$.",
        "There is a null space of $A$.",
        "The singular matrix $A$ is given.",
    ],
)
@pytest.mark.parametrize("before", [True, False])
def test_nothing_follows_by_the_inverse_of_a_matrix_that_words_call_singular(words, before):
    plain = r"\[ A x = A y. \] Hence \[ x = y. \]"
    assert last_of(f"{words} {plain}" if before else f"{plain} {words}").verdict != "follows"


@pytest.mark.parametrize(
    "words",
    [
        "At the epipole $q = 0$.",
        "At the focus of the lens $q = 0$.",
        "Here $q$ vanishes.",
        "Let $q = 0$.",
        "$q$ is zero.",
    ],
)
def test_nothing_follows_where_a_letter_is_not_zero_that_is_zero_by_words(words):
    assert (
        last_of(rf"{words} The ratio is such that \[ p = q s. \] Hence \[ s = \frac{{p}}{{q}}. \]").verdict != "follows"
    )


@pytest.mark.parametrize(
    "words",
    [
        "If $q = 0$, nothing is seen.",
        "The letter $q$ is not zero.",
        "At $x = 0$ we stop.",
        "At the end $f(q) = 0$.",
        "$A$ is invertible unless $q = 0$.",
    ],
)
def test_what_is_zero_in_a_case_or_elsewhere_hides_no_consequence(words):
    assert (
        last_of(rf"{words} The ratio is such that \[ p = q s. \] Hence \[ s = \frac{{p}}{{q}}. \]").verdict == "follows"
    )


def test_what_holds_away_from_a_place_does_not_hold_there():
    plain = r"Away from the poles the rate is \[ w = \frac{v}{r}. \] %s this gives \[ w r = v. \]"
    assert last_of(plain % "At the poles").verdict != "follows"
    assert last_of(plain % "Away from the poles").verdict == "follows"
