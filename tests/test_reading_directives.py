"""Blocks of words in MyST are no code: what they say, define and write is read."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")


def verdicts(markdown):
    return [each.verdict for each in read_document(document_of(markdown, latex=False))]


NOTE = "```{admonition} Notation\n:class: note\n\nWe write $\\newcommand{\\work}{W_{12}}$ for the work.\n```\n\n"


def test_a_macro_of_a_block_of_words_is_known_behind_it():
    assert verdicts(NOTE + "$$ \\work = F s $$\n\nHence\n\n$$ 2 \\work = 2 F s $$\n") == ["definition", "follows"]


def test_a_formula_in_a_block_of_words_is_read():
    text = "```{note}\nThe sum is\n\n$$ s = a + b $$\n```\n\nHence\n\n$$ 2 s = 2 a + 2 b $$\n"
    assert verdicts(text) == ["definition", "follows"]


def test_a_block_of_code_behind_one_of_words_stays_code():
    text = NOTE + "```python\ns = '$$ a = b $$'\n```\n\n$$ c = a + b $$\n\n```{code-cell}\n$$ d = e $$\n```\n"
    assert verdicts(text) == ["definition"]
