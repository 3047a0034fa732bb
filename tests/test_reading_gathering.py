"""What trees become when nothing is known of their kind or something fails in them, and labels at the end of pieces."""

import pytest
from lark import Token, Tree

from algebroproj_sym.reading.documents.pending import without_label
from algebroproj_sym.reading.lexing.pieces import UnreadableError, pieces_of
from algebroproj_sym.reading.parsing.gathering import _Gathering, transformed

LEAF = Token("SYMBOL", "x")


def test_a_tree_of_which_nothing_is_known_stays_one_with_what_is_made_of_its_parts():
    inner = Tree("group", [LEAF])
    made = transformed(_Gathering(), Tree("unheard", [inner, LEAF]))
    assert isinstance(made, Tree)
    assert (made.data, made.children) == ("unheard", [LEAF, LEAF])


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (ValueError("of value\nand more"), "of value"),
        (TypeError("of type"), "of type"),
        (ZeroDivisionError(), "ZeroDivisionError"),
        (AttributeError("none"), "none"),
        (OverflowError("too large"), "too large"),
        (RecursionError("too deep"), "too deep"),
    ],
)
def test_whatever_fails_in_a_tree_cannot_be_read(error, said):
    class Failing(_Gathering):
        def symbol(self, *parts):
            raise error

    with pytest.raises(UnreadableError, match=f"^{said}$") as raised:
        transformed(Failing(), Tree("group", [Tree("symbol", [LEAF])]))
    assert raised.value.__cause__ is error


def test_what_cannot_be_read_keeps_its_place():
    told = UnreadableError("there", 7)

    class Failing(_Gathering):
        def symbol(self, *parts):
            raise told

    with pytest.raises(UnreadableError) as raised:
        transformed(Failing(), Tree("symbol", [LEAF]))
    assert raised.value is told


@pytest.mark.parametrize(
    ("latex", "left"),
    [
        (r"a = b \label{eq:one}", "a=b"),
        (r"a = b\label {eq:one} ", "a=b"),
        (r"{a} = b \label{eq:{one}}", "{a}=b"),
        (r"\label{eq:one}", ""),
        (r"a = {b}", "a={b}"),
        (r"a = \hat{b}", r"a=\hat{b}"),
        (r"\label{eq:one} a = b", r"\label{eq:one}a=b"),
        (r"{b}", "{b}"),
        ("", ""),
    ],
)
def test_a_label_at_the_end_is_taken_off(latex, left):
    found = "".join(piece.text for piece in without_label(pieces_of(latex)))
    assert "".join(found.split()) == left
