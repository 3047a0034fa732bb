"""What words say of a letter late, or in another section, where it is called something else."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def last_of(latex):
    return read_document(document_of(latex, latex=True), seconds=5)[-1]


@pytest.mark.parametrize(
    ("first", "second", "follows"),
    [
        ("The matrix $R$ is a rotation matrix.", "Here $R$ denotes the covariance of the noise.", False),
        ("The matrix $R$ is a rotation matrix.", "The measurement noise $R$ is large.", False),
        ("The matrix $R$ is an orthogonal matrix.", "Here $R$ is the set of residuals.", False),
        ("The matrix $R$ is a rotation matrix.", "Here $R$ is the attitude of the camera.", True),
        ("The matrix $R$ is a rotation matrix.", "The camera is at rest.", True),
    ],
)
def test_a_property_does_not_hold_where_another_section_calls_the_letter_something_else(first, second, follows):
    text = rf"\section{{A}} {first} \section{{B}} {second} \[ R^T R = I. \]"
    assert (last_of(text).verdict == "follows") is follows


@pytest.mark.parametrize(
    ("behind", "follows"),
    [
        ("The letters denote: $M$ mass matrix, $N$ damping matrix.", False),
        ("Letters: $M$ matrix, $N$ vector.", False),
        ("The letters denote: $M$ mass, $N$ damping.", True),
        ("We use $M$ rows of a matrix.", True),
    ],
)
def test_a_list_behind_equations_calls_letters_matrices(behind, follows):
    text = rf"\[ S = (M - N)(M + N) \] Hence \[ S = M^2 - N^2. \] {behind}"
    assert (last_of(text).verdict == "follows") is follows


@pytest.mark.parametrize(
    "words",
    [
        "In the next paragraphs the letter $h$ is used for the half of it instead.",
        "The letter $h$ is now used to denote an estimate.",
        "If we measure $h$ in metres,",
        "For the right camera we write again $h$ for the height.",
        "We use $h$ for the orthometric height.",
        "Surveyors prefer the orthometric height, which is also called $h$.",
        "With an abuse of notation we also denote the hour by $h$.",
        "In the second part, $h$ is the hour and no height.",
        "The same letter denotes its estimate in what follows.",
        "We keep the name for the noisy one.",
        "We now add noise to $h$ and keep its name.",
        "On the Moon $h$ keeps the value it had on Earth.",
        "Consider the roof, for which $h$ now stands.",
    ],
)
def test_a_letter_that_words_give_another_meaning_is_not_what_it_was(words):
    assert last_of(rf"The height is \[ h = a + b. \] {words} So \[ h - b = a. \]").verdict != "follows"


@pytest.mark.parametrize(
    "words",
    [
        "The letter $h$ is the height.",
        "We use $a$ and $b$ from above.",
        "It has the same name in all tables.",
        "We write it in full.",
        "We add the two equations.",
        "Its value is measured in metres.",
    ],
)
def test_words_that_rename_nothing_leave_a_letter_what_it_was(words):
    assert last_of(rf"The height is \[ h = a + b. \] {words} So \[ h - b = a. \]").verdict == "follows"


def test_what_words_right_behind_an_equation_call_its_letter_is_heard():
    text = r"\[ m = r V \] is the mass of the lens. The %s $m$ of the lens is given by \[ r V = m. \]"
    assert last_of(text % "magnification").verdict != "follows"
    assert last_of(text % "mass").verdict == "follows"


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("In Europe", "In America"),
        ("In the model of Smith", "In the model of Jones"),
        ("In the frame of the ship", "In the frame of the shore"),
        ("On Mars,", "On Earth,"),
        ("For the camera of Ada,", "For the camera of Bob,"),
    ],
)
def test_what_holds_with_one_thing_or_speaker_does_not_hold_with_another(one, other):
    text = r"%s the shift is \[ s = u + v. \] %s we have \[ s - u = v. \]"
    assert last_of(text % (one, other)).verdict != "follows"
    assert last_of(text % (one, one)).verdict == "follows"


@pytest.mark.parametrize(
    "other", ["In Section 3", "By the sum of both", "In terms of the angle", "In the course of this work"]
)
def test_places_of_a_text_are_no_places(other):
    text = r"In Europe the shift is \[ s = u + v. \] %s we have \[ s - u = v. \]"
    assert last_of(text % other).verdict == "follows"


@pytest.mark.parametrize(
    ("words", "follows"),
    [
        ("A prime denotes the derivative with respect to $u$.", False),
        ("In the rotated frame the functions carry a prime.", False),
        ("A prime marks the rotated frame.", False),
        ("A prime denotes the derivative with respect to $x$.", True),
        ("A prime denotes the derivative.", True),
    ],
)
def test_a_prime_is_a_derivative_by_the_argument_unless_words_say_otherwise(words, follows):
    text = rf"Let \[ f(x) = x^2. \] {words} Hence \[ f'(x) = 2 x. \]"
    assert (last_of(text).verdict == "follows") is follows


@pytest.mark.parametrize(
    ("words", "follows"), [("$x^2$ is the second coordinate of the point.", False), ("$x^2$ is the square.", True)]
)
def test_a_number_above_a_letter_is_no_power_where_it_numbers_coordinates(words, follows):
    text = rf"Here {words} Let \[ y = x^2. \] Hence \[ x^2 y = x^4. \]"
    assert (last_of(text).verdict == "follows") is follows


@pytest.mark.parametrize(
    ("words", "follows"),
    [
        (r"We approximate, increasing $a$. With $a = 10$, for example:", False),
        (r"For example, with $a = 10$ we find", False),
        (r"It depends on $a$, e.g. with $a = 10$ it is", False),
        (r"With $a = 10$ we find", True),
        (r"With $a = 10$ we find \[ w = 2a \] \section{Two} For all integers", False),
        (r"With $a = 10$ we find \[ w = 2a. \] Now", True),
    ],
)
def test_a_number_within_the_text_is_given_for_its_section_and_not_by_an_example(words, follows):
    text = rf"\section{{One}} {words} \[ z = a^2 + c. \] Hence \[ z - c = 100. \]"
    assert (last_of(text).verdict == "follows") is follows


@pytest.mark.parametrize(
    ("latex", "follows"),
    [
        (r"\[ n = 3 \] For any $n$ we find \[ n + 1 = 4. \]", False),
        (r"We have $n = 3$. For any $n$ we find \[ n + 1 = 4. \]", False),
        (r"\[ n - 3 = 0 \] For every integer $n$ we find \[ n + 1 = 4. \]", False),
        (r"\[ n = 3 \] For all $x$ we find \[ n x = 3 x. \]", True),
        (r"\[ f(x) = x + 1 \] For all $x$ we find \[ f(x) - x = 1. \]", True),
    ],
)
def test_a_letter_that_is_any_has_no_number(latex, follows):
    assert (last_of(latex).verdict == "follows") is follows
