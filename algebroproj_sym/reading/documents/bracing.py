r"""Braces that mean nothing: round nothing, as in ``\Delta{}t``, and round a name, a sign, a word or a label."""

import re
from collections.abc import Sequence

from algebroproj_sym.reading.documents.page import Page
from algebroproj_sym.reading.documents.pending import braced, ends_value, renamed, without_label
from algebroproj_sym.reading.lexing.commands import LETTERS, RELATIONS
from algebroproj_sym.reading.lexing.pieces import Piece, first_text

_ENDS = frozenset((*RELATIONS, r"\left", r"\,", r"\;", r"\quad", r"\qquad", r"\\", r"\cdot", r"\times"))
"""Commands behind which braces hold no argument."""
_LABEL = re.compile(r"\\label\s*\{[^{}]*\}\s*")


def needless_braces(page: Page, piece: Piece) -> bool:
    r"""Leave out braces round nothing before a mark of alignment, and round a name before a bracket: ``{N}(t)``.

    So are those round a bracket behind a name, as in ``f{\left(t\right)}``, and round a fraction or a nabla.
    """
    before = first_text(reversed(without_label(page.out)))
    argument = (
        before in ("^", "_", "]")
        or (before == "}" and not _ends_script(page.out))
        or (before.startswith("\\") and before not in _ENDS)
    )
    if argument or (inside := page.waiting.name_in_braces()) is None:
        behind = not argument and (before[-1:].isalpha() or before == "}")
        return behind and page.waiting.brackets_in_braces() is not None
    page.waiting.put(inside)
    return True


def end_of_command(page: Page, _: Piece) -> bool:
    r"""Leave out braces round nothing that only end a command, as in ``\Delta{}t``; scripts may be of the braces."""
    if not (page.out and page.out[-1].text in LETTERS and page.waiting.next == "}"):
        return False
    if any(page.waiting.follows("}", script) for script in ("^", "_")):
        return False
    page.waiting.pop()
    return True


def _ends_script(out: Sequence[Piece]) -> bool:
    """Whether pieces end with a script in braces: no argument comes behind it."""
    depth = 0
    for place in range(len(out) - 1, -1, -1):
        depth += (out[place].text == "}") - (out[place].text == "{")
        if not depth and out[place].text == "{":
            return first_text(reversed(out[:place])) in ("^", "_")
    return False


def label(page: Page, piece: Piece) -> bool:
    """Take a label out of braces that hold nothing else."""
    if page.waiting.next != r"\label":
        return False
    page.waiting.put([piece])
    inside = page.waiting.group()
    alone = _LABEL.fullmatch("".join(each.text for each in inside)) is not None
    page.waiting.put(inside if alone else [*inside, renamed(piece, "}")])
    return alone


def brace(page: Page, piece: Piece) -> bool:
    r"""Take a sign in braces out of them, and ``{\rm word}`` for an upright word."""
    if page.waiting.is_sign and ends_value(page.out):
        page.waiting.put([piece])
        page.out.extend(page.waiting.group())
        return True
    if not page.waiting.has_upright_word:
        return False
    page.waiting.put([piece])
    word = [each for each in page.waiting.group() if each.text.isalpha()]
    page.waiting.put([renamed(piece, r"\mathrm"), *braced(piece, word)])
    return True
