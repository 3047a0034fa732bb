r"""Texts as textbooks have them, with marks: ``@`` before a bold letter, and ``|>`` before an equation that follows."""

import re

_BEGINS = re.compile(r"\\\[|\\qquad")


def plain(text):
    """Return a text without its marks."""
    return re.sub(r"@(\\[a-z]+|\w)", r"\\mathbf{\1}", text.replace("|>", ""))


def follow(text):
    """Return of each equation whether it follows; those that wide spaces part in a display have its mark."""
    marks = re.findall(r"(\|>|)\\\[(.*?)\\\]", text, re.DOTALL)
    return [mark == "|>" for mark, inside in marks for _ in inside.split(r"\qquad")]


def with_misprint(text, printed, wrong):
    """Return a text with something misprinted that it has once, and the place of the equation in which it stands."""
    text = " ".join(text.split())
    assert text.count(printed) == 1
    return text.replace(printed, wrong), len(_BEGINS.findall(text[: text.index(printed)])) - 1
