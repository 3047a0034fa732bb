r"""Formulas in few notations: what only looks otherwise becomes what the lexer reads.

``\overset{(3)}{=}`` is ``=``, ``\underbrace{a}_{b}`` is ``a``, ``\mbox{$a$}`` is ``a``, an array between ``\left\{``
and ``\right.`` is a distinction of cases, and ``α`` is ``\alpha``.
"""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence

from algebroproj_sym.reading.documents.boxes import CONNECTIVES, read_box
from algebroproj_sym.reading.documents.bracing import brace, end_of_command, label, needless_braces
from algebroproj_sym.reading.documents.delimiters import Pairs
from algebroproj_sym.reading.documents.grouping import grouped
from algebroproj_sym.reading.documents.page import Page
from algebroproj_sym.reading.documents.pending import (
    Pending,
    at,
    braced,
    ends_value,
    formulas_in,
    group_start,
    is_raised,
    renamed,
)
from algebroproj_sym.reading.documents.slopes import slope_ahead
from algebroproj_sym.reading.documents.stacking import BRACES, INFIX, OVER, SIZES, braced_below, built, infix, stacked
from algebroproj_sym.reading.documents.systems import as_rows
from algebroproj_sym.reading.documents.unicode import SIGNS_OF_UNICODE, accented
from algebroproj_sym.reading.lexing.commands import BOXES, CLOSING, MAX_PIECES, RELATIONS, SIGNS
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, first_text, pieces_of

_NEGATED = {"=": r"\ne", r"\in": r"\notin", r"\equiv": r"\ne"}
_OTHERWISE = {r"\nicefrac": r"\frac", r"\sfrac": r"\frac", r"\xfrac": r"\frac", r"\space": "\\ ", r"\nobreakspace": "~"}
_OTHERWISE |= {
    r"\enskip": r"\;",
    r"\enspace": r"\;",
    r"\thinspace": r"\,",
    r"\>": r"\:",
    r"\pmod": r"\bmod",
    r"\mod": r"\bmod",
    r"\intop": r"\int",
}
_OTHERWISE |= dict.fromkeys((r"\begin{dcases}", r"\begin{dcases*}", r"\begin{cases*}"), r"\begin{cases}")
_OTHERWISE |= dict.fromkeys((r"\end{dcases}", r"\end{dcases*}", r"\end{cases*}"), r"\end{cases}")
_OTHERWISE[r"\varDelta"] = r"\Delta"
_OTHERWISE |= dict.fromkeys((r"\triangledown", r"\bigtriangledown"), r"\nabla")
_POSTFIX = dict.fromkeys((r"\T", r"\tran", r"\trans", r"\transp", r"\transpose", r"\tp"), "T") | {r"\inv": "-1"}
"""What documents call the marks of matrices whose macros are elsewhere."""
_SIDES = {r"\l": r"\left", r"\r": r"\right", r"\mleft": r"\left", r"\mright": r"\right"}
_DELIMITERS = frozenset(("(", ")", "[", "]", r"\{", r"\}", "|", "."))
"""What makes a command that of a delimiter, where its macro is elsewhere."""
_TRIANGLES = frozenset((r"\triangle", r"\vartriangle", r"\bigtriangleup"))
"""What is a difference before a letter, and a triangle before its corners."""
_ROUNDED = {r"\lfloor": r"\operatorname{floor}(", r"\lceil": r"\operatorname{ceil}(", r"\rfloor": ")", r"\rceil": ")"}
_ROUNDED |= {r"\llbracket": r"\operatorname{jump}(", r"\rrbracket": ")"}
_WITH_POWERS = r"\sin", r"\cos", r"\tan", r"\cot", r"\sec", r"\csc", r"\sinh", r"\cosh", r"\tanh", r"\log", r"\ln"
_NABLAS = {"grad": r"\nabla ", "div": r"\nabla\cdot "} | dict.fromkeys(("curl", "rot"), r"\nabla\times ")
_NO_ARGUMENT = frozenset(("", "=", "+", "-", ")", "}", "_", "^", "&", ",", "."))
_UNSEEN = frozenset((r"\index", r"\phantom", r"\hphantom", r"\vphantom", r"\noalign"))
_BREAKS = frozenset(rf"\{name}" for name in ("displaybreak", "linebreak", "nolinebreak", "pagebreak", "nopagebreak"))
_NO_ROOM = re.compile(r"-|0*\.?0*[a-z]")
"""A length that is negative or zero."""
_ROOM = frozenset((r"\hskip", r"\kern", r"\mskip", r"\mkern", r"\hspace", r"\hspace*"))


_BEFORE_VALUES = frozenset(("", *RELATIONS, *SIGNS, "{", "(", "[", r"\left", r"\displaystyle"))
"""What stands before a value, and behind none."""


def _with_bars(pieces: Sequence[Piece]) -> Sequence[Piece]:
    r"""Return pieces with ``\|`` for signs of parallels, and ``|`` for ``\mid``, of which pairs enclose values."""
    for sign, bar in ((r"\parallel", r"\|"), (r"\mid", "|")):
        places = [place for place, each in enumerate(pieces) if each.text == sign]
        before = [first_text(reversed(pieces[:place])) for place in places[::2]]
        if len(places) % 2 == 0 and all(each in _BEFORE_VALUES for each in before):
            pieces = [renamed(each, bar) if place in places else each for place, each in enumerate(pieces)]
    return pieces


def _with_angles(pieces: Sequence[Piece]) -> Sequence[Piece]:
    r"""Return pieces with ``\langle`` for ``<`` where a value begins, as in ``<x> = a``, and what closes it."""
    found = [*pieces]
    for place, piece in enumerate(pieces):
        if piece.text == "<" and first_text(reversed(found[:place])) in _BEFORE_VALUES:
            texts = [each.text for each in pieces[place + 1 :]]
            end = next((i for i, text in enumerate(texts) if text in RELATIONS or text in ("&", r"\\")), 0)
            if end and texts[end] == ">" and texts[:end].count("{") == texts[:end].count("}"):
                found[place] = renamed(piece, r"\langle")
                found[place + 1 + end] = renamed(pieces[place + 1 + end], r"\rangle")
    return found


def tidied(pieces: Sequence[Piece]) -> list[Piece]:
    r"""Return the pieces of a formula in fewer notations, each where it stood.

    It raises `UnreadableError` if a brace is not closed, or there are more pieces than there may be.

    Examples
    --------
    >>> from algebroproj_sym.reading.lexing.pieces import pieces_of
    >>> text = r"f \overset{(1)}{=} \left\{\begin{array}{ll} \underbrace{α}_{b} & \mbox{if $a>0$} \end{array}\right."
    >>> "".join(piece.text for piece in tidied(pieces_of(text)))
    'f = \\begin{cases} {\\alpha} & \\text{if $a>0$}\\end{cases}'
    """
    signs = (
        each
        for piece in grouped(accented(_with_angles(_with_bars(pieces))))
        for each in (at(piece, SIGNS_OF_UNICODE[piece.text]) if piece.text in SIGNS_OF_UNICODE else (piece,))
    )
    page = Page([], Pending(signs), Pairs())
    while page.waiting:
        piece = page.waiting.pop()
        if piece.text in _SIDES and page.waiting.next in _DELIMITERS:
            piece = renamed(piece, _SIDES[piece.text])
        if not any(step(page, piece) for step in _STEPS.get(piece.text, ())):
            page.out.append(piece)
        if len(page.out) + len(page.waiting) > MAX_PIECES:
            raise UnreadableError(f"expected a formula of at most {MAX_PIECES} pieces, got more", piece.place)
    return as_rows(page.out)


def _left(page: Page, piece: Piece) -> bool:
    page.waiting.turn("<", r"\langle")
    if (cases := page.waiting.cases(piece)) is not None:
        page.waiting.put(cases)
    else:
        page.pairs.open(page.out, page.waiting, piece)
    return True


def _right(page: Page, piece: Piece) -> bool:
    page.waiting.turn(">", r"\rangle")
    page.pairs.close(page.out, page.waiting, piece)
    return True


def _without(arguments: int) -> Callable[[Page, Piece], bool]:
    """Return a step that leaves a command out, with its arguments."""

    def step(page: Page, piece: Piece) -> bool:
        for _ in range(arguments):
            page.waiting.group()
        return True

    return step


def _rule(page: Page, piece: Piece) -> bool:
    """Leave a line out, which is often of no width and makes room."""
    page.waiting.options()
    return _without(2)(page, piece)


def _break(page: Page, piece: Piece) -> bool:
    page.waiting.options()
    return True


def _framed(arguments: int, braces: bool = True) -> Callable[[Page, Piece], bool]:
    """Return a step that keeps the last argument of a command, perhaps a formula in words, and none before it."""

    def step(page: Page, piece: Piece) -> bool:
        for _ in range(arguments):
            page.waiting.group()
        inside = page.waiting.group()
        inside = formulas_in(inside) or inside
        page.waiting.put(braced(piece, inside) if braces else inside)
        return True

    return step


def _power_in_brackets(page: Page, piece: Piece) -> bool:
    r"""Write ``\sin[2](x)`` as it is printed: a package of physics has the power of a function in square brackets."""
    behind = "".join(each.text for each in page.waiting[-1:-12:-1])
    if (power := re.match(r"\s*\[\s*(-?\d)\s*\]\s*(?=\()", behind)) is None:
        return False
    del page.waiting[-len(pieces_of(power.group())) :]
    page.out.extend(at(piece, f"{piece.text}^{{{power[1]}}}"))
    return True


def _boxed(page: Page, piece: Piece) -> bool:
    page.waiting.options()
    inside = page.waiting.group()
    page.waiting.put(formulas_in(inside) or inside)
    return True


def _written(text: str) -> Callable[[Page, Piece], bool]:
    """Return a step that writes a command otherwise."""

    def step(page: Page, piece: Piece) -> bool:
        page.out.extend(at(piece, text))
        return True

    return step


def _binary(page: Page, piece: Piece) -> bool:
    if found := page.waiting.next == "{":
        page.waiting.put(page.waiting.group())
    return found


def _colon(page: Page, piece: Piece) -> bool:
    return page.waiting.next == ":"


def _name(page: Page, piece: Piece) -> bool:
    r"""Join letters with a line between them to a name, as in ``max\_speed``, where no command stands before them."""
    text = "".join(each.text for each in page.out[-MOST_OF_NAME:])
    behind = _OF_NAME.match("".join(each.text for each in page.waiting[: -MOST_OF_NAME - 1 : -1]))
    found = re.search(r"(?<![\\a-zA-Z{])[a-zA-Z][a-zA-Z0-9]*$", text)
    if found and behind:
        del page.out[len(page.out) - len(found[0]) :]
        for _ in pieces_of(behind[0]):
            page.waiting.pop()
        page.out.extend(at(piece, rf"\mathrm{{{found[0]}{behind[0].replace(chr(92) + '_', '')}}}"))
    return bool(found and behind)


_OF_NAME = re.compile(r"[a-zA-Z0-9]+(?:\\_[a-zA-Z0-9]+)*")
MOST_OF_NAME = 40
"""How many signs of a name stand on either side of a line."""


def _percent(page: Page, piece: Piece) -> bool:
    r"""Read a percentage behind a number, and leave a lone sign in brackets out: a unit."""
    if found := ends_value(page.out):
        page.out.extend(at(piece, r"\cdot\frac{1}{100}"))
    elif found := first_text(reversed(page.out)) == "(" and page.waiting.next == ")":
        page.waiting.pop()
        while page.out.pop().text != "(":
            pass
    return found


def _lone_part(page: Page, piece: Piece) -> bool:
    r"""Read ``\Re`` without an argument as a letter, such as the number of Reynolds."""
    if found := page.waiting.next in _NO_ARGUMENTS:
        page.out.extend(at(piece, rf"\mathrm{{{piece.text[1:]}}}"))
    return found


_NO_ARGUMENTS = frozenset(("", "_", "^", "}", ")", "]", ",", ".", ";", "&", r"\\", r"\right", *RELATIONS, *SIGNS))
"""What comes behind a letter, and begins no argument."""


def _floor_of_cross(page: Page, piece: Piece) -> bool:
    if found := page.waiting.is_cross:
        closing = max(place for place, each in enumerate(page.waiting) if each.text == r"\rfloor")
        page.waiting[closing] = renamed(page.waiting[closing], "]")
        page.out.append(renamed(piece, "["))
    return found


def _postfix(page: Page, piece: Piece) -> bool:
    raised = is_raised(page.out)
    if not (raised or ends_value(page.out)) or page.waiting.next == "{":
        return False
    mark = braced(piece, at(piece, _POSTFIX[piece.text]))
    page.out.extend(mark if raised else [renamed(piece, "^"), *mark])
    return True


def _triangle(page: Page, piece: Piece) -> bool:
    if found := not page.waiting.has_corners:
        page.out.append(renamed(piece, r"\Delta"))
    return found


def _sharp(page: Page, piece: Piece) -> bool:
    r"""Take a number sign above a letter for ``\sharp``: ``J^\#`` is a pseudo-inverse."""
    above = page.out[-1].text if page.out else ""
    if found := above == "^" or (above == "{" and len(page.out) > 1 and page.out[-2].text == "^"):
        page.out.append(renamed(piece, r"\sharp"))
    return found


def _prime(page: Page, piece: Piece) -> bool:
    if found := not is_raised(page.out):
        page.out.append(renamed(piece, "'"))
    return found


def _cross(page: Page, piece: Piece) -> bool:
    r"""Read ``[a\times]``, and ``a \times`` at the end of an entry or a side, as the matrix of a cross product."""
    if is_raised(page.out):
        return False
    if closing := page.waiting.closing():
        page.waiting.put([*_squared(page.out, closing), renamed(piece, "_"), *braced(piece, [piece])])
    elif found := ends_value(page.out) and page.waiting.ends_entry(page.out):
        page.out.extend([renamed(piece, "^"), *braced(piece, [renamed(piece, r"\wedge")])])
        return bool(found)
    return bool(closing)


def _squared(out: list[Piece], closing: list[Piece]) -> list[Piece]:
    """Write the round bracket that closes here as a square one: it is no argument of what stands before it."""
    if closing[-1].text != ")":
        return closing
    depth = 0
    for place in range(len(out) - 1, -1, -1):
        depth += (out[place].text == ")") - (out[place].text == "(")
        if depth < 0:
            out[place] = renamed(out[place], "[")
            return [*closing[:-1], renamed(closing[-1], "]")]
    return closing


def _box(page: Page, piece: Piece) -> bool:
    if found := page.waiting.next == "{":
        read_box(page.out, page.waiting, piece)
    return found


def _nabla(page: Page, piece: Piece, inside: Sequence[Piece]) -> bool:
    """Write the upright name of an operator of fields as a nabla; in a script, or before no argument, it is a name."""
    written = _NABLAS.get("".join(each.text for each in inside), "")
    start = group_start(page.out)
    before = page.out[-1:] if start is None else [*page.out[-1:], *page.out[max(0, start - 2) : start - 1]]
    is_name = page.waiting.next in _NO_ARGUMENT or any(each.text in ("_", "^") for each in before)
    if found := bool(written) and not is_name:
        page.out.extend(at(piece, written))
    return found


def _upright(page: Page, piece: Piece) -> bool:
    if page.waiting.next != "{":
        return False
    inside = page.waiting.group()
    if _nabla(page, piece, inside):
        return True
    words = re.sub(r"\\[:, ;]", " ", "".join(each.text for each in inside)).strip()
    command = r"\text" if CONNECTIVES.fullmatch(words) else piece.text
    page.out.extend([renamed(piece, command), *braced(piece, inside)])
    return True


def _letter_as_operator(page: Page, piece: Piece) -> bool:
    if page.waiting.next != "{":
        return False
    inside = page.waiting.group()
    if _nabla(page, piece, inside):
        return True
    is_letter = re.fullmatch(r"[a-zA-Z]\s*_.+", "".join(each.text for each in inside)) is not None
    page.waiting.extend([] if is_letter else [renamed(piece, "}")])
    page.waiting.extend(inside[::-1])
    page.out.extend([] if is_letter else [piece, renamed(piece, "{")])
    return True


def _room(page: Page, piece: Piece) -> bool:
    length = page.waiting.length()
    if not _NO_ROOM.match(length):
        page.out.append(renamed(piece, r"\quad"))
    elif page.waiting.next in ("^", "_"):
        page.out.extend(at(piece, "{}"))
    return True


def _unequal(page: Page, piece: Piece) -> bool:
    if found := bool(page.out) and page.out[-1].text.isspace() and page.waiting.follows("="):
        page.waiting.pop()
        page.out.append(renamed(piece, r"\ne"))
    return found


def _arrow(page: Page, piece: Piece) -> bool:
    """Write ``=>`` as the arrow that it is typed for."""
    if found := page.waiting.follows(">"):
        page.waiting.pop()
        page.out.append(renamed(piece, r"\Rightarrow"))
    return found


def _not(page: Page, piece: Piece) -> bool:
    r"""Write ``\not\in`` and ``\not=`` as one relation."""
    if (relation := _NEGATED.get(page.waiting.next)) is not None:
        page.waiting.turn(page.waiting.next, relation)
    return relation is not None


def _empty_script(page: Page, piece: Piece) -> bool:
    """Leave a script out in which nothing stands."""
    if found := page.waiting.follows("{", "}"):
        del page.waiting[-2:]
    return found


def _prime_behind_nothing(page: Page, piece: Piece) -> bool:
    if [each.text for each in page.out[-2:]] == ["{", "}"]:
        raise UnreadableError("a prime without a letter before it may belong to a whole sum", piece.place)
    return False


def _slope(page: Page, piece: Piece) -> bool:
    page.out.extend(at(piece, found := slope_ahead(page.waiting)))
    return found != ""


def _scientific(page: Page, piece: Piece) -> bool:
    if _is_scientific(page.out, page.waiting):
        raise UnreadableError("a letter between digits may be part of a number such as 1e3", piece.place)
    return False


def _between_numbers(page: Page, piece: Piece) -> bool:
    if page.out and page.out[-1].text.isdigit() and _is_other_number(page.waiting):
        raise UnreadableError("numbers side by side may be a list", piece.place)
    return False


def _stop(page: Page, piece: Piece) -> bool:
    r"""Leave a full stop out at the end of a matrix, and behind a bracket or a matrix at the end of braces."""
    closed = first_text(reversed(page.out))
    is_closed = closed in CLOSING or closed.startswith(r"\end{")
    return page.waiting.next.startswith(r"\end{") or (is_closed and page.waiting.next == "}")


def _ket(page: Page, piece: Piece) -> bool:
    r"""Read ``|u\rangle`` as a letter with an accent, and what stands behind ``\langle u`` as it is."""
    angles = [each.text for each in page.out if each.text in (r"\langle", r"\rangle")]
    inside = None if angles[-1:] == [r"\langle"] else page.waiting.ket()
    if inside is None:
        return False
    page.out.extend([renamed(piece, r"\ket"), *braced(piece, inside)])
    return True


def _number_with_sign(page: Page, piece: Piece) -> bool:
    r"""Put a number with a sign behind another sign in brackets, as in ``10 \times -1``."""
    before = first_text(reversed(page.out))
    if before not in (r"\times", r"\cdot", "-", "+") or not page.waiting.next.isdigit():
        return False
    number = page.waiting.number()
    page.out.extend([renamed(piece, "("), piece, *number, renamed(piece, ")")])
    return True


def _ellipsis(page: Page, piece: Piece) -> bool:
    """Read three dots as an ellipsis, and two between values as one in a list: ``1..N``."""
    dots = 1 + page.waiting.follows(".") + page.waiting.follows(".", ".")
    del page.waiting[len(page.waiting) - dots + 1 :]
    listed = dots == 2 and ends_value(page.out)
    page.out.extend(at(piece, r",\ldots," if listed else r"\ldots") if dots > 1 else [])
    return dots > 1


def _row(page: Page, piece: Piece) -> bool:
    page.out.append(piece)
    page.waiting.skip()
    return True


def _steps() -> dict[str, tuple[Callable[[Page, Piece], bool], ...]]:
    """Return the steps of each command, in the order in which they are tried."""
    found: dict[str, tuple[Callable[[Page, Piece], bool], ...]] = {}
    for names, step in _TABLE:
        for name in names:
            found[name] = (*found.get(name, ()), step)
    return found


def _is_scientific(out: Sequence[Piece], waiting: Sequence[Piece]) -> bool:
    """Whether digits stand right before and right behind a letter, as in 1e3 and 10e-3."""
    following = [each.text for each in waiting[-1:-3:-1]]
    following = following[1:] if following[:1] in (["-"], ["+"]) else following
    return bool(out) and out[-1].text.isdigit() and following[:1] != [] and following[0].isdigit()


def _is_other_number(waiting: Sequence[Piece]) -> bool:
    """Whether digits come next that are no group of three, as those of thousands are."""
    following = [each.text.isdigit() for each in waiting[-1:-5:-1]]
    return following[:1] == [True] and following[:3] != [True] * 3


_TABLE: tuple[tuple[Iterable[str], Callable[[Page, Piece], bool]], ...] = (
    ((r"\left",), _left),
    ((r"\right",), _right),
    (_UNSEEN, _without(1)),
    (SIZES, _without(0)),
    ((r"\_",), _name),
    ((r"\!", r"\_"), _without(0)),
    ((r"\color",), _without(1)),
    ((r"\setlength", r"\addtolength", r"\setcounter"), _without(2)),
    (_BREAKS, _break),
    ((r"\rule",), _rule),
    (_WITH_POWERS, _power_in_brackets),
    ((r"\lefteqn",), _framed(0, braces=False)),
    ((r"\resizebox",), _framed(2, braces=False)),
    ((r"\scalebox",), _framed(1, braces=False)),
    ((r"\textcolor", r"\colorbox", r"\raisebox"), _framed(1)),
    ((r"\makebox", r"\framebox"), _boxed),
    ((r"\smash", r"\mathclap", r"\mathllap", r"\mathrlap", r"\fbox", r"\mathsmaller", r"\mathlarger"), _framed(0)),
    (BRACES, braced_below),
    ((r"\mathbin",), _binary),
    ((r"\mathop",), _colon),
    ((r"\%",), _percent),
    ((r"\Re", r"\Im"), _lone_part),
    ((r"\lfloor",), _floor_of_cross),
    *(((name,), _written(text)) for name, text in (_OTHERWISE | _ROUNDED).items()),
    (_POSTFIX, _postfix),
    (_TRIANGLES, _triangle),
    ((r"\#",), _sharp),
    ((r"\prime",), _prime),
    ((r"\times",), _cross),
    (("|", r"\vert", r"\lvert"), _ket),
    (("{",), end_of_command),
    (("{",), needless_braces),
    (("{",), brace),
    (("{",), label),
    (BOXES, _box),
    ((r"\mathrm",), _upright),
    ((r"\operatorname",), _letter_as_operator),
    ((r"\buildrel",), built),
    (OVER, stacked),
    (INFIX, infix),
    (_ROOM, _room),
    (("!",), _unequal),
    (("=",), _arrow),
    ((r"\not",), _not),
    (("_", "^"), _empty_script),
    (("'",), _prime_behind_nothing),
    ((r"\partial",), _slope),
    (("e",), _scientific),
    ((r"\,", r"\;", "\\ "), _between_numbers),
    ((".",), _ellipsis),
    ((".",), _stop),
    (("-",), _number_with_sign),
    ((r"\\",), _row),
)
_STEPS: Mapping[str, tuple[Callable[[Page, Piece], bool], ...]] = _steps()
