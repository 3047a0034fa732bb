r"""Lines below letters say of which order a tensor is: ``\underline{a}`` of the second, a double one of the fourth.

They are read as bold letters, and as those of a blackboard.
"""

import re
from collections.abc import Iterator, Sequence

from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.lexing.commands import BOLD
from algebroproj_sym.reading.lexing.pieces import Piece

_LINE = r"\underline"
_OF_TENSORS = re.compile(r":|\\(?:colon|det|tr)(?![a-z])|\{tr\}|\^\{?-?(?:T|\\top)")
_BOLD = frozenset((*BOLD, r"\mathbf"))


def are_tensors(statements: Sequence[Statement]) -> bool:
    """Whether letters with a line below stand beside what matrices have, or have two, and none is bold as well."""
    texts = [[piece.text for piece in each.pieces if not piece.text.isspace()] for each in statements]
    lined = ["".join(each) for each in texts if _LINE in each]
    ordered = any(_OF_TENSORS.search(each) or f"{_LINE}{{{_LINE}" in each for each in lined)
    below, bold = ({letter for each in texts for letter in _styled(each, style)} for style in ({_LINE}, _BOLD))
    return ordered and below.isdisjoint(bold)


def _styled(texts: Sequence[str], styles: set[str] | frozenset[str]) -> Iterator[str]:
    """Yield the letters that stand right behind a command, or in its braces."""
    for place, text in enumerate(texts[:-2]):
        if text in styles:
            yield texts[place + 1 + (texts[place + 1] == "{")]


def in_bold(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    r"""Return pieces with bold letters for those with a line below.

    Examples
    --------
    >>> from algebroproj_sym.reading.lexing.pieces import pieces_of
    >>> "".join(each.text for each in in_bold(pieces_of(r"\underline{\underline{\mathbf D}} : \underline\sigma_e")))
    '\\mathbb{D} : \\mathbf\\sigma_e'
    """
    found: list[Piece] = []
    rest = [*pieces]
    while rest:
        piece = rest.pop(0)
        if piece.text != _LINE:
            found.append(piece)
            continue
        inside = _group(rest)
        if inside and inside[0].text == _LINE:
            letter = _group(inside[1:]) or inside[1:]
            letter = [each for each in letter if each.text not in _BOLD and not each.text.isspace()]
            letter = _group(letter) or letter
            del rest[: _length(rest)]
            found += [Piece(r"\mathbb", piece.place), Piece("{", piece.place), *letter, Piece("}", piece.place)]
        else:
            found.append(Piece(r"\mathbf", piece.place))
    return tuple(found)


def _length(pieces: Sequence[Piece]) -> int:
    """Return how many pieces the group has that comes next, with its braces; zero for none."""
    depth = 0
    for place, piece in enumerate(pieces):
        depth += (piece.text == "{") - (piece.text == "}")
        if depth == 0:
            return place + 1 if piece.text == "}" else 0
    return 0


def _group(pieces: Sequence[Piece]) -> list[Piece]:
    """Return what stands in the braces that come next."""
    return [*pieces[1 : max(1, _length(pieces) - 1)]]
