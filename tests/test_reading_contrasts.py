"""What is said of one thing, case or speaker is not put into what is said of another."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

APART = [
    ("Classically,", "Relativistically,"),
    ("According to Newton,", "According to Einstein,"),
    ("Smith found that", "Jones found that"),
    ("In the absence of friction,", "With friction,"),
    ("At time $t_1$,", "At time $t_2$,"),
    ("In 2D,", "In 3D,"),
    ("Day 1:", "Day 2:"),
    ("Using the first definition,", "Using the second definition,"),
    ("Assume", "Now drop this assumption. Then"),
    ("Except at $x = 0$,", "At $x = 0$,"),
    ("Some points satisfy", "All points satisfy"),
    ("At leading order,", "To all orders,"),
    ("Asymptotically,", "For finite $n$,"),
    ("In vacuum,", "In matter,"),
    ("With the pinhole camera,", "With the fisheye camera,"),
    ("The left camera has", "The right camera has"),
    ("Among adults,", "Among children,"),
    ("Initially,", "At the end,"),
    ("Neglecting the noise,", "Including the noise,"),
    ("Only if $a > 0$,", "In any case,"),
    ("A fixed point satisfies", "Every point satisfies"),
    ("Suppose for contradiction that", "This is absurd. We have"),
]
SOUGHT = [
    ("The question is whether", "The answer is"),
    ("Let us see whether", "It turns out that"),
    ("There exists $a$ such that", "For all $a$,"),
    ("We look for points with", "All points have"),
    ("We want", "We have"),
    ("We minimise subject to", "It holds that"),
    ("Find $a$ such that", "Any $a$ satisfies"),
]
SAYS, IMPLIED = r"2 a b - 2 c d = 0", r"a b = c d"


def last(one, says, other, implied):
    text = rf"\documentclass{{x}}\begin{{document}}We study things. {one} \[ {says} \] {other} \[ {implied} \]"
    return read_document(document_of(text, latex=True), seconds=5)[-1].verdict


@pytest.mark.parametrize("stop", ["", "."])
@pytest.mark.parametrize(("one", "other"), [*APART, *SOUGHT])
def test_what_is_said_of_one_thing_does_not_serve_another(one, other, stop):
    assert last(one, SAYS + stop, other, IMPLIED + stop) != "follows"


@pytest.mark.parametrize(("one", "other"), APART)
def test_nor_does_what_a_letter_is_there(one, other):
    assert last(one, "q = 2 a b.", other, "q^2 = 4 a^2 b^2.") not in ("follows", "contradicts")


@pytest.mark.parametrize(("one", "other"), [*APART, ("We want", "We have")])
def test_nor_is_it_contradicted_there(one, other):
    assert last(one, "q = 2 a b.", other, "q = 3 a b.") != "contradicts"
    assert last(one, "q = 2 a b", other, "q = 3 a b") != "contradicts"


@pytest.mark.parametrize("one", [one for one, _ in APART if one.endswith((",", ":", "has", "found that"))])
def test_it_serves_the_same_thing_and_what_goes_on_from_it(one):
    assert last(one, SAYS + ".", one, IMPLIED) == "follows"
    assert last(one, SAYS + ".", "Hence", IMPLIED) == "follows"


@pytest.mark.parametrize(
    "words", [r"\noindent", r"\maketitle", r"\begin{abstract}", r"\bigskip\par", r"\textbf{", r"\item"]
)
def test_commands_before_a_sentence_hide_no_case(words):
    assert last(f"{words} In the first model,", SAYS, f"{words} In the second model,", IMPLIED) != "follows"


@pytest.mark.parametrize(
    "text",
    [
        r"The volume is \[ V = a b c \] Let $a = 2 b$. \[ V = 2 b^2 c \] \section{Others} We have \[ V = a^2 c / 2 \]",
        r"If $x$ is a root, \[ 3 x y - 3 z = 0 \] For any $x$, it holds that \[ x y = z \]",
        r"\[ A X B = C \] where $A, X, B, C \in \mathbb{R}^{n \times n}$ and $A$ is singular. "
        r"Hence \[ X = A^{-1} C B^{-1} \]",
    ],
)
def test_nothing_follows_from_a_case_that_is_over_or_by_an_inverse_that_does_not_exist(text):
    assert read_document(document_of(text, latex=True), seconds=5)[-1].verdict != "follows"


@pytest.mark.parametrize(
    ("words", "supposed"),
    [
        ("Hence", False),
        ("For the twin we get", True),
        ("The glacier of 1987 has", True),
        ("Solving for it, we find", False),
        ("This gives the second cross equation", False),
    ],
)
def test_what_an_equation_rests_on_must_be_true_there_where_a_word_is_new(words, supposed):
    text = f"The lens satisfies \\[ 2 a b - 2 c d = 0. \\]\n{words} \\[ a b = c d. \\]"
    found = read_document(document_of(text, latex=True), seconds=5)[-1]
    assert (found.verdict, found.supposes) == ("follows", supposed)
    assert any("line 1 is true here, where the word" in each for each in found.links[0].hypotheses) is supposed


@pytest.mark.parametrize(
    "words",
    [
        "Quantities are intervals, and we use interval arithmetic.",
        "Sums are those of single-precision hardware.",
        "The letters $a$ and $b$ do not commute.",
        "Here $x + y$ stands for the larger of both.",
    ],
)
def test_nothing_follows_in_a_section_on_another_arithmetic(words):
    text = rf"{words} We have \[ c = (a + b) - a. \] Hence \[ c = b. \]"
    assert read_document(document_of(text, latex=True), seconds=5)[-1].verdict == "not decided"
    plain = text.replace("Hence", r"\section{Numbers} We have \[ q = (a + b) - a. \] Hence").replace("c = b", "q = b")
    assert read_document(document_of(plain, latex=True), seconds=5)[-1].verdict == "follows"


def test_what_holds_somewhere_must_be_true_where_words_since_then_are_new():
    text = "For the left lens the focus is\n\\[ f = 2 p q. \\]\n%s has\n\\[ p = 3 r. \\]\nHence\n\\[ f = 6 r q. \\]"
    found = [read_document(document_of(text % each, latex=True), seconds=5)[-1] for each in ("The mirror", "It")]
    assert [(each.verdict, each.supposes) for each in found] == [("follows", True), ("follows", False)]


CHANGED = [
    (r"\section{One} We have", r"\section{Two} Part II swaps the two names. We have"),
    ("We have", "From here on the letters change places. We have"),
    ("The sum is", "In this section sums run from one. It is"),
    (r"\section{A myth} We have", r"\section{Facts} We have"),
    (r"One of the following holds: \begin{itemize} \item", r"\item We have $f = 2$. \end{itemize} Hence"),
    (r"Which is right? \begin{enumerate} \item", r"\end{enumerate} We obtain"),
    (r"\textbf{Exercise.} Suppose that", r"\textbf{Remark.} We have"),
    (r"The stress is\footnote{Only in the elastic range.}", "After the break we have"),
    ("The cost (without tax) is", "The cost (with tax) is"),
    ("In the epoch J2000 we have", "In the epoch B1950 we have"),
    ("After $a$ steps we have", "Then we increase $a$ by one. We have"),
]


@pytest.mark.parametrize(("says", "implied"), [(SAYS, IMPLIED), ("q = 2 a b", r"\frac q2 = a b")])
@pytest.mark.parametrize(("one", "other"), CHANGED)
def test_nothing_follows_where_letters_changed_or_nothing_was_asserted(one, other, says, implied):
    assert last(one, says + ".", other, implied) != "follows"


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("Two rods are given. The former has", "The latter has"),
        ("The monthly average has", "On this Tuesday we have"),
        ("We bet that it is", "We lost the bet. We have"),
        ("Our pump has", "Our neighbour has a pump as well. It has"),
        ("We have", r"Where the printer had \verb|-|s left, we have"),
        (r"\section{The old theory} We have", r"\section{The new theory} We have"),
        ("The day before has", "This has changed. We have"),
    ],
)
def test_it_must_be_true_where_a_sentence_between_has_a_new_word(one, other):
    text = rf"\documentclass{{x}}\begin{{document}}{one} \[ {SAYS}. \] {other} \[ {IMPLIED}. \]"
    found = read_document(document_of(text, latex=True), seconds=5)[-1]
    assert found.verdict != "follows" or found.supposes


@pytest.mark.parametrize("unit", [r"a b = c d \text{ dB}", r"a b = c d \text{ up to sign}"])
def test_words_in_a_formula_are_words_of_it(unit):
    text = f"We have \\[ {SAYS}. \\] Hence \\[ {unit}. \\]"
    found = read_document(document_of(text, latex=True), seconds=5)[-1]
    assert found.verdict != "follows" or found.supposes


def test_an_equality_with_a_dot_must_be_exact():
    found = read_document(document_of(r"\[ a \doteq b + c. \] Hence \[ a - b = c. \]", latex=True), seconds=5)[-1]
    assert (found.verdict, found.supposes) == ("follows", True)


@pytest.mark.parametrize(
    "between",
    ["This is the first equation. Hence", "Here $a$ is the width. We get", "We divide by the volume. So", r"So"],
)
def test_a_sentence_of_a_step_between_supposes_nothing(between):
    found = read_document(document_of(f"We have \\[ {SAYS}. \\] {between} \\[ {IMPLIED}. \\]", latex=True), seconds=5)[
        -1
    ]
    assert (found.verdict, found.supposes) == ("follows", False)


SETTINGS = [
    ("Steady:", "Unsteady: the load is"),
    ("Phase 1 (ascent):", "Phase 2 (descent): the load is"),
    ("Thin rods obey", "The load on a thick one is"),
    ("Drawing with replacement,", "Drawing without replacement, the load is"),
    ("Most springs have", "A spring carries"),
    ("Apart from the last one, each has", "The last one carries"),
    ("In the linear range", "In saturation the load is"),
    (r"\textbf{Rods.} The stiffness is", r"\textbf{Plates.} The load is"),
    (r"\emph{Rods:} the stiffness is", r"\emph{Plates:} the load is"),
    (r"\begin{description} \item[Rods]", r"\item[Plates] The load is"),
    (r"There are two options: \begin{itemize} \item", r"\item The load is"),
    ("(a) The stiffness of a rod is", "(b) The load on a plate is"),
    ("The stiffness is", "Another body carries"),
    ("True or false?", "The load is"),
    (r"It was measured.\footnote{In the first edition we had used", "} The load is"),
    ("Is it so that", "? The load is"),
]
"""How a sentence says of what alone it speaks, and one behind it that speaks of another thing."""


@pytest.mark.parametrize("lines", ["\n", " "])
@pytest.mark.parametrize(("one", "other"), SETTINGS)
def test_what_is_said_of_things_of_a_sort_or_in_an_item_is_supposed_of_others(one, other, lines):
    text = lines.join((one, r"\[ k = a b. \]", other, r"\[ q = k c. \]", "Hence", r"\[ q = a b c. \]"))
    found = read_document(document_of(text), seconds=5)[-1]
    assert found.supposes or found.verdict != "follows"


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("The stiffness is", "The load is"),
        ("By Hooke's law,", "Newton's second law gives"),
        (r"\textbf{Proof.} The stiffness is", "We have"),
        ("Let", "Then"),
        ("Similarly,", "Finally,"),
        (r"\begin{itemize} \item Rods have", "Hence they have"),
    ],
)
def test_what_goes_on_of_the_same_thing_supposes_nothing(one, other):
    text = "\n".join((one, r"\[ k = a b. \]", other, r"\[ q = k c. \]", "Hence", r"\[ q = a b c. \]"))
    found = read_document(document_of(text), seconds=5)[-1]
    assert found.verdict == "follows"
    assert not found.supposes
