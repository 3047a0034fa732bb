"""Words in boxes: remarks, names, formulas, or words that act on the formula beside them."""

import re
from collections.abc import Sequence

from algebroproj_sym.reading.documents.pending import Pending, braced, ends_value, formulas_in, group_start, renamed
from algebroproj_sym.reading.lexing.commands import BOLD, FUNCTIONS, LETTERS, OPERATORS, STYLES
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, first_text, is_closed, pieces_of

CONNECTIVES = re.compile(r"(?:if|for|and|or|where|when|with|otherwise|else|on|at|as|then|subject to|s\.t\.)\W*")
"""Words that join formulas."""
_WORD = re.compile(r"[A-Za-z]+")
_WORDS = re.compile(r"([A-Za-z]{2,})")
_COMPOSED = re.compile(r"[A-Za-z][A-Za-z -]+")
"""What is the name of a map where it is composed with another one."""
_BOLD = re.compile(r"\\boldmath\s*(?:\{\s*\$([^$]+)\$\s*\}|\$([^$]+)\$)")
_ACTS_BEFORE = re.compile(
    r"\W*(?:(?:the|an?|its|their|one|minus|plus|not|square|cube) )*"
    r"(?:\w+ of(?: (?:the|an?|all))?|twice|thrice|double|half|triple|not|negative|minus|plus)\W*",
    re.IGNORECASE,
)
"""Words that act on a letter behind them, where a value begins."""
_ACTS_BEHIND = re.compile(
    r"\W*(?i:squared|cubed|doubled|halved)\b.*|"
    r"[\s(\[]*(?:(?i:minus|plus|times|mod(?:ulo)?|of|percent|(?:divided|multiplied) by|xor)|AND|OR|NAND|NOR)"
    r"\b.*",
    re.DOTALL,
)
"""Words that act on a value before them."""
_OPENS = re.compile(r"\\left|\\!|\\[bB]igg?l?|[(\[]|\\\{|\\lbrace")
"""What begins a bracket."""
_ROOM_OF_OPERATORS = frozenset((r"\;", r"\:", "\\ ", "~"))
_LETTERS_AND_STYLES = frozenset((*LETTERS, *STYLES, *BOLD))


def read_box(out: list[Piece], waiting: Pending, piece: Piece) -> None:
    """Go over a box: what it holds goes to what has been read, or to what is yet to come."""
    inside = waiting.group()
    name = "".join(each.text for each in inside)
    if (_ACTS_BEHIND if ends_value(out) else _ACTS_BEFORE).fullmatch(name) and not _is_in_script(out):
        raise UnreadableError(f"the words {name.strip()!r} act on the formula beside them", piece.place)
    if not is_closed(inside) and "$" not in name:
        waiting.put([each for part in _WORDS.split(name) for each in _named(piece, part)])
        return
    if bold := _BOLD.fullmatch(name.strip()):
        waiting.put([renamed(piece, r"\boldsymbol"), *braced(piece, pieces_of(bold[1] or bold[2], piece.place))])
        return
    composed = _COMPOSED.fullmatch(name) and not CONNECTIVES.fullmatch(name)
    if composed and r"\circ" in (waiting.next, first_text(reversed(out))):
        waiting.put(_named(piece, re.sub(r"[^A-Za-z]", "", name)))
        return
    called = (_is_name(name) or name in FUNCTIONS) and _OPENS.fullmatch(waiting.next)
    named = (name in FUNCTIONS and waiting.next == "^") or name.strip() == "d"
    acts = _acts(name, waiting.next) or (_is_letter(name) and _ends_factor(out))
    if called or named or (_is_name(name) and waiting.next in ("_", "^")) or acts:
        word = [each for each in inside if not each.text.isspace()]
        waiting.put([renamed(piece, r"\mathrm"), *braced(piece, word)])
    elif not name.strip(" .,;:"):
        out += inside
    elif formulas := formulas_in(inside):
        waiting.put(braced(piece, formulas))
    else:
        out += [renamed(piece, r"\text"), *braced(piece, inside)]


def _named(piece: Piece, words: str) -> list[Piece]:
    """Return a part of a box as a formula: several letters are a name."""
    inside = [renamed(piece, each.text) for each in pieces_of(words)]
    return [renamed(piece, r"\mathrm"), *braced(piece, inside)] if _WORD.fullmatch(words) else inside


def _is_name(words: str) -> bool:
    """Whether words are one word, and none that joins formulas."""
    return _WORD.fullmatch(words) is not None and not CONNECTIVES.fullmatch(words.lower())


def _is_letter(words: str) -> bool:
    return len(words) == 1 and words.isalpha()


def _ends_factor(out: Sequence[Piece]) -> bool:
    """Whether a value ends that is no number, behind which a letter may be a unit."""
    before = [each.text for each in out if not each.text.isspace()][-1:]
    return ends_value(out) and not before[0].isdigit()


def _is_in_script(out: Sequence[Piece]) -> bool:
    """Whether the next piece stands in a subscript or above a letter, where words are names."""
    before = [each for each in out if not each.text.isspace()]
    while before and before[-1].text not in ("_", "^"):
        start = group_start(before)
        if start is None:
            return False
        before = before[: start - 1]
    return bool(before)


def _acts(words: str, following: str) -> bool:
    r"""Whether words are an operator on what comes behind them, as in ``\text{Var}\,x``, and no remark before it."""
    known = words.strip() in FUNCTIONS or words.strip() in OPERATORS
    named = known or _is_letter(words) or (_is_name(words) and words[0].isupper())
    begins = following in ("\\,", "{") or following.isalpha() or following in _LETTERS_AND_STYLES
    return (named and begins) or (known and following in _ROOM_OF_OPERATORS)
