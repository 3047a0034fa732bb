"""What a document does not plainly assert contradicts nothing, and is named where something follows from it."""

import pytest
from cases import for_each

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

PLAIN = [
    "",
    "We have",
    "The width is",
    "The width is given by",
    "Let",
    "By definition, we have",
    "With",
    "Here the width is",
]
NOT_ASSERTED = [
    "Newton wrote", "We abandon", "Is it true that", "Perhaps", "The old definition was", "Nothing shows that",
    "Instead of",
    "The devil says", "The buggy code has", "True or false?", "In the mirrored system,", "Legend has it that",
    "Strike out",
    "The phantom width is", "The width in the losing design is", "No proof exists that",
    "Many beginners compute the width as",
    "My guess:", "A bold guess is", "We do not assume that", "Older texts have", "Should it be that", "Far from",
]  # fmt: skip
TAKEN_BACK = [
    "It is biased.", "Just kidding.", "The proof has a gap.", "So the textbook says.", "Now the rules were changed.",
    "Read minus for plus.", "End of quotation.", "Add a wall.", "No.", "In what follows $b$ points to the left.",
]  # fmt: skip
BESIDE = ["Here $a$ is the length of the box, and $b$ is that of its lid.", "We multiply by two.", "So it is."]
HENCE = ["Hence", "It follows that", "We have", "This gives"]


STATEMENTS = ["The gossip is", "The lie is", "The verdict is", "The theory of the critic is"]
"""What is no quantity, but a statement."""
TAILS = [", or so he thought", "for even boxes", "in the dream", ", and pigs fly", ", so he lied", "on Mondays"]
WITHIN = [
    "We set ${}$.", "Let ${}$.", "Here ${}$.", "Define ${}$.", "Put ${}$ and find the sum.", "The width is ${}$.",
    "Let ${}$, where $a$ is the length of the box.", "Let ${}$. Here $a$ is the length of the box.",
]  # fmt: skip
NOT_WITHIN = [
    "Nothing forces us to set ${}$.", "Is ${}$?", "The referee wants us to set ${}$.", "The idea is to set ${}$.",
    "The gossip is ${}$.", "The alleged width is ${}$.", "Note that the bogus width is ${}$.", "We could set ${}$.",
    "We set ${}$ in vain.", "We set ${}$ for a test.", "Let ${}$. This was a joke.", "Here ${}$ is what he says.",
    "Let ${}$ be the lie.", "Where ${}$, nothing grows.", "There is no world where ${}$.", "By ${}$ he meant nothing.",
    '"We set ${}$", he said.', "As Newton put it, ${}$.", "The width is ${}$ on Mondays.", "The width is ${}$?",
    "For instance, ${}$.", "It would be wrong to take ${}$.", "With ${}$ it would break.",
]  # fmt: skip


def last(before, between, after):
    text = f"{before}\n\\[ c = a + b. \\]\n{between}\n\\[ {after}. \\]"
    return read_document(document_of(text), seconds=5)[-1]


@for_each("lead", PLAIN)
def test_what_is_plainly_asserted_is_contradicted(lead):
    for words in HENCE:
        assert last(lead, words, "2 c = 2 a - 2 b").verdict == "contradicts", words
        assert last(lead, words, "2 c = 2 a + 2 b").links[0].hypotheses == (), words


@for_each("lead", NOT_ASSERTED)
def test_what_is_not_plainly_asserted_is_not(lead):
    for words in HENCE:
        assert last(lead, words, "2 c = 2 a - 2 b").verdict != "contradicts", words


def test_a_sign_of_definition_asserts():
    for lead, is_asserted in (("The image is larger by the factor", True), ("The old rule was", False)):
        text = f"{lead}\n\\[ c := a + b. \\]\nHence\n\\[ 2 c = 2 a - 2 b. \\]"
        assert (read_document(document_of(text), seconds=5)[-1].verdict == "contradicts") == is_asserted, lead


@for_each("words", TAKEN_BACK)
def test_nor_is_what_a_sentence_behind_it_may_take_back(words):
    assert last("The width is", f"{words} Hence", "2 c = 2 a - 2 b").verdict != "contradicts"


@for_each("lead", STATEMENTS)
def test_nor_is_the_content_of_a_statement(lead):
    for words in HENCE:
        assert last(lead, words, "2 c = 2 a - 2 b").verdict != "contradicts", words


@for_each("tail", TAILS)
def test_nor_is_what_its_own_sentence_goes_on_to_take_back(tail):
    text = f"The width is\n\\[ c = a + b \\]\n{tail}. Hence\n\\[ 2 c = 2 a - 2 b. \\]"
    assert read_document(document_of(text), seconds=5)[-1].verdict != "contradicts"


def within(words, between, after):
    text = f"{words.format('c = a + b')}\n{between}\n\\[ {after}. \\]"
    return read_document(document_of(text), seconds=5)[-1]


@for_each("words", WITHIN)
def test_what_the_text_plainly_asserts_is_contradicted(words):
    assert within(words, "Hence", "2 c = 2 a - 2 b").verdict == "contradicts"
    assert not within(words, "We have", "2 c = 2 a + 2 b").supposes


@for_each("words", NOT_WITHIN)
def test_what_the_text_does_not_plainly_assert_is_not(words):
    for between in ("Hence", "The height is\n\\[ h = a + 3 b. \\]\nHence"):
        assert within(words, between, "2 c = 2 a - 2 b").verdict != "contradicts", between


@for_each("words", [each for each in NOT_WITHIN if "gossip" not in each and "bogus" not in each])
def test_what_rests_on_it_in_a_sentence_of_its_own_names_it(words):
    found = within(words, "We have", "2 c = 2 a + 2 b")
    assert found.verdict != "follows" or found.supposes


@for_each("words", BESIDE)
def test_what_letters_are_and_steps_take_nothing_back(words):
    assert last("The width is", f"{words} Hence", "2 c = 2 a - 2 b").verdict == "contradicts"


@for_each("lead", [each for each in NOT_ASSERTED if "phantom" not in each and "losing" not in each])
def test_what_rests_on_it_without_a_word_names_it(lead):
    for words in ("We have", "Note that", "The formula is"):
        found = last(lead, words, "2 c = 2 a + 2 b")
        assert found.verdict != "follows" or found.supposes, words


def test_two_sides_of_a_figure_in_one_display_do_not_contradict_each_other():
    text = r"On the left and on the right we have \[ c = a + b, \qquad c = a - b. \]"
    assert "contradicts" not in [each.verdict for each in read_document(document_of(text), seconds=5)]
