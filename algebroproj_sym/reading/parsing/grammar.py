"""Formulas in LaTeX are parsed to trees.  The grammar is in ``latex.lark``."""

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files
from typing import Any, Self

from lark import Lark, Token, Tree
from lark.exceptions import UnexpectedInput, UnexpectedToken
from lark.lexer import Lexer

from algebroproj_sym.reading.lexing.commands import MAPS
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, outside_braces, pieces_of, split_pieces
from algebroproj_sym.reading.lexing.tokens import tokens_of

Formula = Tree[Token]
Sides = Sequence[Formula]

_ENDINGS = (".", ";", ",", r"\Rightarrow", r"\implies", r"\quad", r"\qquad", "\\ ", r"\,", r"\;", r"\:", r"\!", "~")
_SEEN = re.compile(
    "NUMBER|SYMBOL|OPAQUE|SHOWN|CALLEE|FUNCTION|BIG|MARK|SIGN|DOT|CROSS|CIRCLED|RELATION|BEGIN|CONDITION"
)


@dataclass(frozen=True)
class Parsed:
    """A formula."""

    sides: tuple[Formula, ...]
    """What the relations join."""
    relations: tuple[str, ...]
    """One less than the sides."""
    chose: str = ""
    """What LaTeX leaves open, and the reader chose; empty for nothing."""

    def without_set(self) -> Self:
        r"""Return the formula without the set to which its sides belong, as in ``q = a/b \in [0, 1]``."""
        is_member = len(self.relations) > 1 and self.relations[-1] == "∈"
        return replace(self, sides=self.sides[:-1], relations=self.relations[:-1]) if is_member else self


def parsed(
    latex: str | Sequence[Piece],
    known: Callable[[str], bool] = lambda name: False,
    functions: Collection[str] | None = None,
    wide_arguments: bool = True,
) -> Parsed:
    """Parse a formula: one expression, or several joined by relations.  The other arguments are as for `tokens_of`.

    It raises `UnreadableError` if the text is no formula of the grammar; it says where reading stopped.
    """
    pieces = _without_end(pieces_of(latex) if isinstance(latex, str) else list(latex))
    if functions is not None and (sides := split_pieces(pieces, MAPS))[1:] and _is_map(sides[0]):
        shown = [Tree("shown", [_shown(side)]) for side in sides if side]
        return Parsed(tuple(shown), ("→",) * (len(shown) - 1))
    tokens, chose = tokens_of(pieces, known, functions, wide_arguments)
    try:
        tree = _parser().parse([_terminal(token) for token in tokens])
    except UnexpectedInput as error:
        end = pieces[-1].place if pieces else None
        raise UnreadableError(*_explained(error, end)) from error
    children: list[Any] = tree.children
    trees = children[::2] if functions is None else map(_with_brackets_of_two, children[::2])
    return Parsed(tuple(trees), tuple(map(str, children[1::2])), chose)


def _with_brackets_of_two(tree: Formula) -> Formula:
    r"""Return a formula in which each ``\langle u | v \rangle`` is a letter, the same for the same text."""
    if tree.data == "inner":
        (items,) = trees_in(tree)
        signs = [str(each) for part in items.find_data("product") for each in part.children if isinstance(each, Token)]
        if len(items.children) == 1 and signs.count("|") + signs.count("mid") == 1:
            return Tree("symbol", [Token("SYMBOL", f"inner ({printed(items)})")])
    return Tree(tree.data, [_with_brackets_of_two(each) if isinstance(each, Tree) else each for each in tree.children])


def printed(tree: Formula) -> str:
    """Return a formula as text that no other one has."""
    inside = " ".join(printed(each) if isinstance(each, Tree) else str(each) for each in tree.children)
    return inside if tree.data in ("symbol", "opaque", "number", "items") else f"{tree.data} [{inside}]"


def _is_map(side: Sequence[Piece]) -> bool:
    r"""Whether a side is that of a map, such as ``f : A`` before an arrow to B: it is shown, and states nothing."""
    return any(piece.text in (":", r"\colon") for piece in outside_braces(side))


def _shown(pieces: Sequence[Piece]) -> Token:
    text = "".join(piece.text for piece in pieces).strip()
    return Token("SHOWN", text, start_pos=pieces[0].place)


def unaligned(pieces: Sequence[Piece]) -> list[Piece]:
    """Return the pieces without what aligns equations: ``&`` and line breaks outside matrices."""
    kept, environments = list[Piece](), 0
    for piece in pieces:
        environments += piece.text.startswith(r"\begin{") - piece.text.startswith(r"\end{")
        if environments or piece.text not in ("&", r"\\"):
            kept.append(piece)
    return kept


def _terminal(token: Token) -> Token:
    return token if _SEEN.fullmatch(token.type) else Token(f"_{token.type}", str(token), start_pos=token.start_pos)


def _without_end(pieces: list[Piece]) -> list[Piece]:
    """Return pieces without what ends a formula: spaces and stops, and a lone command behind a stop."""
    end = len(pieces)
    while end and (pieces[end - 1].text.isspace() or pieces[end - 1].text in _ENDINGS):
        end -= 1
    kept = pieces[:end]
    before = [piece.text for piece in kept[:-1] if not piece.text.isspace()]
    if before[-1:] == ["."] and re.fullmatch(r"\\[a-zA-Z]+", kept[-1].text):
        return _without_end(kept[:-1])
    return kept


def _explained(error: UnexpectedInput, end: int | None) -> tuple[str, int | None]:
    token = getattr(error, "token", None)
    if not isinstance(error, UnexpectedToken) or token is None or token.type == "$END":
        return "the formula ends too early", end
    shown = str(token) or token.type
    return f"expected a formula, got {shown!r}", token.start_pos


class _Given(Lexer):
    """Hands the tokens on as they are."""

    def __init__(self, settings: Any) -> None:
        pass

    def lex(self, lexer_state: Any, parser_state: Any = None) -> Iterator[Token]:
        return iter(lexer_state)


@cache
def _parser() -> Lark:
    grammar = (files("algebroproj_sym.reading.parsing") / "latex.lark").read_text(encoding="utf-8")
    return Lark(grammar, parser="lalr", lexer=_Given)


def regrouped(tree: Formula) -> Formula:
    """Return a tree with each slash before a product dividing by the first factor alone: a/b c as (a/b) c."""
    children = [regrouped(child) if isinstance(child, Tree) else child for child in tree.children]
    if tree.data == "quotient" and any(isinstance(part, Tree) and part.data == "run" for part in children[1:]):
        parts: list[Any] = [children[0]]
        for part in children[1:]:
            factors = part.children if isinstance(part, Tree) and part.data == "run" else [part]
            divided = Tree("quotient", [parts.pop() if len(parts) == 1 else Tree("run", parts), factors[0]])
            parts = [divided, *factors[1:]]
        return Tree("run", parts) if len(parts) > 1 else parts[0]
    return Tree(tree.data, children)


def with_divided_angles(tree: Formula) -> Formula:
    r"""Return a tree in which an angle is divided, and not its sine: ``\sin x/2`` as that of the half."""
    children: list[Any] = [with_divided_angles(child) if isinstance(child, Tree) else child for child in tree.children]
    if tree.data == "quotient" and len(children) == 2 and isinstance(above := children[0], Tree):
        *factors, wave = above.children if above.data == "run" else [above]
        if isinstance(wave, Tree) and wave.data in ("function", "raised_function") and wave.children[0] in _WAVES:
            *head, angle = wave.children
            if isinstance(angle, Tree) and (letter := without_brackets(angle)).data == "symbol":
                divided = Tree("items", [Tree("quotient", [letter, children[1]])])
                return Tree("run", [*factors, Tree(wave.data, [*head, divided])])
    return Tree(tree.data, children)


_WAVES = ("sin", "cos", "tan", "cot")

UNSEEN = ("group", "items")
"""What has unseen brackets round it, as an exponent in braces."""
IN_BRACKETS = (*UNSEEN, "bracket")
"""What has brackets, seen or unseen, round it."""
_OF_SYMBOLS = ("SYMBOL", "CALLEE", "OPAQUE")


def without_brackets(tree: Any, brackets: Collection[str] = IN_BRACKETS) -> Any:
    """Return what stands in the brackets round a whole formula."""
    while isinstance(tree, Tree) and tree.data in brackets and len(tree.children) == 1:
        (tree,) = tree.children
    return tree


def put_in(tree: Formula, values: Mapping[Formula, Formula]) -> Formula:
    """Return a formula with others for some of its parts."""
    if tree in values:
        return values[tree]
    return Tree(tree.data, [put_in(each, values) if isinstance(each, Tree) else each for each in tree.children])


def lone(tree: Any) -> str:
    """Return the symbol that a formula is; empty if it is more."""
    return str(tree.children[0]) if isinstance(tree, Tree) and tree.data == "symbol" else ""


def symbols_in(tree: Formula) -> list[str]:
    """Return the symbols of a tree, as tables write them, in their order."""
    found = dict[str, None]()
    waiting: list[Any] = [tree]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Tree):
            waiting += part.children[::-1]
        elif isinstance(part, Token) and part.type in _OF_SYMBOLS:
            found[str(part)] = None
    return list(found)


def tokens_in(tree: Formula, *kinds: str) -> list[str]:
    """Return the tokens of a formula as text, in their order; of some kinds, if these are given."""
    found = tree.scan_values(lambda each: not kinds or (isinstance(each, Token) and each.type in kinds))
    return [*map(str, found)]


def trees_in(tree: Formula) -> list[Formula]:
    """Return the formulas of which a formula is made, without signs and names."""
    return [each for each in tree.children if isinstance(each, Tree)]
