r"""Formulas in few notations: what only looks otherwise becomes what the lexer reads.

``\overset{(3)}{=}`` is ``=``, ``\underbrace{a}_{b}`` is ``a``, ``\mbox{$a$}`` is ``a``, an array between ``\left\{``
and ``\right.`` is a distinction of cases, and ``α`` is ``\alpha``.
"""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from algebroproj_sym.reading.documents.boxes import CONNECTIVES, read_box
from algebroproj_sym.reading.documents.delimiters import Pairs
from algebroproj_sym.reading.documents.grouping import grouped
from algebroproj_sym.reading.documents.pending import (
    Pending,
    at,
    braced,
    ends_value,
    formulas_in,
    group_start,
    is_raised,
    renamed,
    without_label,
)
from algebroproj_sym.reading.documents.slopes import slope_ahead
from algebroproj_sym.reading.documents.systems import as_rows
from algebroproj_sym.reading.documents.unicode import SIGNS_OF_UNICODE, accented
from algebroproj_sym.reading.lexing.commands import BIG, BOXES, CLOSING, LETTERS, MAX_PIECES, RELATIONS, SIGNS, UPRIGHT
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, first_text, has_relation, is_closed, pieces_of

_ENDS = frozenset((*RELATIONS, r"\left", r"\,", r"\;", r"\quad", r"\qquad", r"\\", r"\cdot", r"\times"))
"""Commands behind which braces hold no argument."""
_OVER = frozenset((r"\overset", r"\stackrel", r"\underset"))
_BRACES = frozenset((r"\underbrace", r"\overbrace", r"\underbracket", r"\overbracket"))
_NEGATED = {"=": r"\ne", r"\in": r"\notin", r"\equiv": r"\ne"}
_INFIX = {r"\over": r"\frac", r"\choose": r"\binom"}
_OTHERWISE = {r"\nicefrac": r"\frac", r"\sfrac": r"\frac", r"\xfrac": r"\frac", r"\space": "\\ ", r"\nobreakspace": "~"}
_OTHERWISE |= {
    r"\enskip": r"\;",
    r"\enspace": r"\;",
    r"\thinspace": r"\,",
    r"\>": r"\:",
    r"\pmod": r"\bmod",
    r"\mod": r"\bmod",
}
_OTHERWISE |= dict.fromkeys((r"\begin{dcases}", r"\begin{dcases*}", r"\begin{cases*}"), r"\begin{cases}")
_OTHERWISE |= dict.fromkeys((r"\end{dcases}", r"\end{dcases*}", r"\end{cases*}"), r"\end{cases}")
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
_JUSTIFIES = re.compile(
    r"|.*(?:def|triangle|Delta|\(|ref\b).*|\d+|(?:\\(?:text|mathrm|rm)\b\W*)?(?!law|iid|lim|dist)[A-Za-z][a-z]{2}[^\\]*",
    re.DOTALL,
)
"""What stands above = where it is an equality: a citation, a word, a sign of definitions; and no letter or limit."""
_LIMITS = re.compile(
    r"\b(?:mod|modulo|wrong|no|not|never|only|false|if|when|approx\w*|almost|roughly|small|large|w\.?p|a\.?s|in)\b",
    re.IGNORECASE,
)
"""Words above or below = by which it is none, or holds in a case."""
_EXTREMUM = re.compile(
    r"\\(?:operatorname\*?|mathrm|text|mathop)\{\\?arg(?:\\[,;! ])?\s*\\?(?:min|max)\}|\\arg\s*\\(?:min|max)"
)
"""The place of a least or a greatest value, as it is written."""
_LONE = re.compile(r"[a-zA-Z]|\\math[a-z]+\s*\{?\s*[a-zA-Z]\s*\}?")
"""A letter, perhaps in a style."""
_WITH_POWERS = r"\sin", r"\cos", r"\tan", r"\cot", r"\sec", r"\csc", r"\sinh", r"\cosh", r"\tanh", r"\log", r"\ln"
_UNSEEN = frozenset((r"\index", r"\phantom", r"\hphantom", r"\vphantom", r"\noalign"))
_SIZES = frozenset(
    rf"\{name}"
    for name in (
        "tiny",
        "scriptsize",
        "footnotesize",
        "small",
        "normalsize",
        "large",
        "Large",
        "centering",
        "MoveEqLeft",
        "IEEEnonumber",
    )
)
"""Commands that change the looks of all behind them."""
_ACCENTS_ABOVE = {
    r"\circ": r"\mathring",
    ".": r"\dot",
    r"\cdot": r"\dot",
    r"\sim": r"\tilde",
    r"\frown": r"\overline",
    r"\leftrightarrow": r"\overline",
    r"\rightharpoonup": r"\vec",
}
"""What is an accent where it is written above a letter."""
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


@dataclass(frozen=True)
class _Page:
    """The pieces that are tidied, those that are yet to come, and the delimiters that have no partner yet."""

    out: list[Piece]
    waiting: Pending
    pairs: Pairs


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
    page = _Page([], Pending(signs), Pairs())
    while page.waiting:
        piece = page.waiting.pop()
        if piece.text in _SIDES and page.waiting.next in _DELIMITERS:
            piece = renamed(piece, _SIDES[piece.text])
        if not any(step(page, piece) for step in _STEPS.get(piece.text, ())):
            page.out.append(piece)
        if len(page.out) + len(page.waiting) > MAX_PIECES:
            raise UnreadableError(f"expected a formula of at most {MAX_PIECES} pieces, got more", piece.place)
    return as_rows(page.out)


def _left(page: _Page, piece: Piece) -> bool:
    page.waiting.turn("<", r"\langle")
    if (cases := page.waiting.cases(piece)) is not None:
        page.waiting.put(cases)
    else:
        page.pairs.open(page.out, page.waiting, piece)
    return True


def _right(page: _Page, piece: Piece) -> bool:
    page.waiting.turn(">", r"\rangle")
    page.pairs.close(page.out, page.waiting, piece)
    return True


def _without(arguments: int) -> Callable[[_Page, Piece], bool]:
    """Return a step that leaves a command out, with its arguments."""

    def step(page: _Page, piece: Piece) -> bool:
        for _ in range(arguments):
            page.waiting.group()
        return True

    return step


def _rule(page: _Page, piece: Piece) -> bool:
    """Leave a line out, which is often of no width and makes room."""
    page.waiting.options()
    return _without(2)(page, piece)


def _framed(arguments: int, braces: bool = True) -> Callable[[_Page, Piece], bool]:
    """Return a step that keeps the last argument of a command, perhaps a formula in words, and none before it."""

    def step(page: _Page, piece: Piece) -> bool:
        for _ in range(arguments):
            page.waiting.group()
        inside = page.waiting.group()
        inside = formulas_in(inside) or inside
        page.waiting.put(braced(piece, inside) if braces else inside)
        return True

    return step


def _power_in_brackets(page: _Page, piece: Piece) -> bool:
    r"""Write ``\sin[2](x)`` as it is printed: a package of physics has the power of a function in square brackets."""
    behind = "".join(each.text for each in page.waiting[-1:-12:-1])
    if (power := re.match(r"\s*\[\s*(-?\d)\s*\]\s*(?=\()", behind)) is None:
        return False
    del page.waiting[-len(pieces_of(power.group())) :]
    page.out.extend(at(piece, f"{piece.text}^{{{power[1]}}}"))
    return True


def _boxed(page: _Page, piece: Piece) -> bool:
    page.waiting.options()
    inside = page.waiting.group()
    page.waiting.put(formulas_in(inside) or inside)
    return True


def _written(text: str) -> Callable[[_Page, Piece], bool]:
    """Return a step that writes a command otherwise."""

    def step(page: _Page, piece: Piece) -> bool:
        page.out.extend(at(piece, text))
        return True

    return step


def _braced_below(page: _Page, piece: Piece) -> bool:
    inside = page.waiting.group()
    if page.waiting.next in ("_", "^"):
        page.waiting.group()
        page.waiting.group()
    bare = has_relation(inside) or not is_closed(inside)
    page.waiting.put(inside if bare else braced(piece, formulas_in(inside) or inside))
    return True


def _binary(page: _Page, piece: Piece) -> bool:
    if found := page.waiting.next == "{":
        page.waiting.put(page.waiting.group())
    return found


def _colon(page: _Page, piece: Piece) -> bool:
    return page.waiting.next == ":"


def _name(page: _Page, piece: Piece) -> bool:
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


def _percent(page: _Page, piece: Piece) -> bool:
    r"""Read a percentage behind a number, and leave a lone sign in brackets out: a unit."""
    if found := ends_value(page.out):
        page.out.extend(at(piece, r"\cdot\frac{1}{100}"))
    elif found := first_text(reversed(page.out)) == "(" and page.waiting.next == ")":
        page.waiting.pop()
        while page.out.pop().text != "(":
            pass
    return found


def _lone_part(page: _Page, piece: Piece) -> bool:
    r"""Read ``\Re`` without an argument as a letter, such as the number of Reynolds."""
    if found := page.waiting.next in _NO_ARGUMENTS:
        page.out.extend(at(piece, rf"\mathrm{{{piece.text[1:]}}}"))
    return found


_NO_ARGUMENTS = frozenset(("", "_", "^", "}", ")", "]", ",", ".", ";", "&", r"\\", r"\right", *RELATIONS, *SIGNS))
"""What comes behind a letter, and begins no argument."""


def _floor_of_cross(page: _Page, piece: Piece) -> bool:
    if found := page.waiting.is_cross:
        page.out.append(renamed(piece, "("))
    return found


def _postfix(page: _Page, piece: Piece) -> bool:
    raised = is_raised(page.out)
    if not (raised or ends_value(page.out)) or page.waiting.next == "{":
        return False
    mark = braced(piece, at(piece, _POSTFIX[piece.text]))
    page.out.extend(mark if raised else [renamed(piece, "^"), *mark])
    return True


def _triangle(page: _Page, piece: Piece) -> bool:
    if found := not page.waiting.has_corners:
        page.out.append(renamed(piece, r"\Delta"))
    return found


def _prime(page: _Page, piece: Piece) -> bool:
    if found := not is_raised(page.out):
        page.out.append(renamed(piece, "'"))
    return found


def _cross(page: _Page, piece: Piece) -> bool:
    closing = [] if is_raised(page.out) else page.waiting.closing()
    page.waiting.put([*closing, renamed(piece, "_"), *braced(piece, [piece])] if closing else [])
    return bool(closing)


def _needless_braces(page: _Page, piece: Piece) -> bool:
    r"""Leave out braces round nothing before a mark of alignment, and round a name before a bracket: ``{N}(t)``."""
    before = first_text(reversed(without_label(page.out)))
    argument = (
        before in ("^", "_", "]")
        or (before == "}" and not _ends_script(page.out))
        or (before.startswith("\\") and before not in _ENDS)
    )
    if argument or (inside := page.waiting.name_in_braces()) is None:
        return False
    page.waiting.put(inside)
    return True


def _end_of_command(page: _Page, _: Piece) -> bool:
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


def _label(page: _Page, piece: Piece) -> bool:
    """Take a label out of braces that hold nothing else."""
    if page.waiting.next != r"\label":
        return False
    page.waiting.put([piece])
    inside = page.waiting.group()
    alone = _LABEL.fullmatch("".join(each.text for each in inside)) is not None
    page.waiting.put(inside if alone else [*inside, renamed(piece, "}")])
    return alone


_LABEL = re.compile(r"\\label\s*\{[^{}]*\}\s*")


def _brace(page: _Page, piece: Piece) -> bool:
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


def _box(page: _Page, piece: Piece) -> bool:
    if found := page.waiting.next == "{":
        read_box(page.out, page.waiting, piece)
    return found


def _upright(page: _Page, piece: Piece) -> bool:
    if page.waiting.next != "{":
        return False
    inside = page.waiting.group()
    words = re.sub(r"\\[:, ;]", " ", "".join(each.text for each in inside)).strip()
    command = r"\text" if CONNECTIVES.fullmatch(words) else piece.text
    page.out.extend([renamed(piece, command), *braced(piece, inside)])
    return True


def _over(page: _Page, piece: Piece) -> bool:
    over, base = page.waiting.group(), page.waiting.group()
    relation = "".join(each.text for each in base).strip()
    above = "".join(each.text for each in over if each.text not in _SIZES).strip()
    if _EXTREMUM.fullmatch(relation):
        base = at(piece, r"\argmin" if "min" in relation else r"\argmax")
        relation = base[0].text
    if piece.text == r"\underset" and relation in BIG:
        page.waiting.put([*base, renamed(piece, "_"), *braced(piece, over)])
        return True
    if piece.text == r"\underset" and above.startswith(r"\text") and base[:1] and base[0].text in _BRACES:
        page.waiting.put(braced(piece, base))
        return True
    extreme = re.search(r"\{(?:arg)?(?:min|max|lim|inf|sup)", relation)
    if piece.text == r"\underset" and base[:1] and base[0].text in UPRIGHT and not extreme:
        page.waiting.put([*base, renamed(piece, "_"), *braced(piece, over)])
        return True
    if above in _ACCENTS_ABOVE:
        page.waiting.put([renamed(piece, _ACCENTS_ABOVE[above]), *braced(piece, base)])
        return True
    if relation == "=" and (_LIMITS.search(above) or not _JUSTIFIES.fullmatch(above)):
        relation = r"\equiv" if above == "!" else r"\questeq"
    defines = relation == "=" and re.search(r"def|triangle", above)
    if piece.text != r"\underset" and (relation in LETTERS or _LONE.fullmatch(relation)):
        page.waiting.put(
            [*base, renamed(piece, "^"), *braced(piece, [renamed(piece, "("), *over, renamed(piece, ")")])]
        )
        return True
    plain = [piece, *braced(piece, over), *braced(piece, base)]
    page.out.extend(at(piece, ":=" if defines else relation) if relation in RELATIONS else plain)
    return True


def _built(page: _Page, piece: Piece) -> bool:
    r"""Read ``\buildrel a \over =`` as what stands above a relation."""
    above = page.waiting.before(r"\over")
    page.waiting.put([renamed(piece, r"\overset"), *braced(piece, above)] if above else [])
    return bool(above)


def _infix(page: _Page, piece: Piece) -> bool:
    start = group_start(page.out)
    if start is not None:
        page.out[start:] = [
            renamed(piece, _INFIX[piece.text]),
            *braced(piece, page.out[start:]),
            renamed(piece, "{"),
        ]
        page.waiting.close_group(piece)
    return start is not None


def _room(page: _Page, piece: Piece) -> bool:
    length = page.waiting.length()
    page.out.extend([] if length.startswith("-") else [renamed(piece, r"\quad")])
    return True


def _unequal(page: _Page, piece: Piece) -> bool:
    if found := bool(page.out) and page.out[-1].text.isspace() and page.waiting.follows("="):
        page.waiting.pop()
        page.out.append(renamed(piece, r"\ne"))
    return found


def _not(page: _Page, piece: Piece) -> bool:
    r"""Write ``\not\in`` and ``\not=`` as one relation."""
    if (relation := _NEGATED.get(page.waiting.next)) is not None:
        page.waiting.turn(page.waiting.next, relation)
    return relation is not None


def _prime_behind_nothing(page: _Page, piece: Piece) -> bool:
    if [each.text for each in page.out[-2:]] == ["{", "}"]:
        raise UnreadableError("a prime without a letter before it may belong to a whole sum", piece.place)
    return False


def _slope(page: _Page, piece: Piece) -> bool:
    page.out.extend(at(piece, found := slope_ahead(page.waiting)))
    return found != ""


def _scientific(page: _Page, piece: Piece) -> bool:
    if _is_scientific(page.out, page.waiting):
        raise UnreadableError("a letter between digits may be part of a number such as 1e3", piece.place)
    return False


def _between_numbers(page: _Page, piece: Piece) -> bool:
    if page.out and page.out[-1].text.isdigit() and _is_other_number(page.waiting):
        raise UnreadableError("numbers side by side may be a list", piece.place)
    return False


def _stop(page: _Page, piece: Piece) -> bool:
    r"""Leave a full stop out at the end of a matrix, and behind a bracket or a matrix at the end of braces."""
    closed = first_text(reversed(page.out))
    is_closed = closed in CLOSING or closed.startswith(r"\end{")
    return page.waiting.next.startswith(r"\end{") or (is_closed and page.waiting.next == "}")


def _ket(page: _Page, piece: Piece) -> bool:
    r"""Read ``|u\rangle`` as a letter with an accent, and what stands behind ``\langle u`` as it is."""
    angles = [each.text for each in page.out if each.text in (r"\langle", r"\rangle")]
    inside = None if angles[-1:] == [r"\langle"] else page.waiting.ket()
    if inside is None:
        return False
    page.out.extend([renamed(piece, r"\ket"), *braced(piece, inside)])
    return True


def _number_with_sign(page: _Page, piece: Piece) -> bool:
    r"""Put a number with a sign behind another sign in brackets, as in ``10 \times -1``."""
    before = first_text(reversed(page.out))
    if before not in (r"\times", r"\cdot", "-", "+") or not page.waiting.next.isdigit():
        return False
    number = page.waiting.number()
    page.out.extend([renamed(piece, "("), piece, *number, renamed(piece, ")")])
    return True


def _ellipsis(page: _Page, piece: Piece) -> bool:
    """Read three dots as an ellipsis, and two between values as one in a list: ``1..N``."""
    dots = 1 + page.waiting.follows(".") + page.waiting.follows(".", ".")
    del page.waiting[len(page.waiting) - dots + 1 :]
    listed = dots == 2 and ends_value(page.out)
    page.out.extend(at(piece, r",\ldots," if listed else r"\ldots") if dots > 1 else [])
    return dots > 1


def _row(page: _Page, piece: Piece) -> bool:
    page.out.append(piece)
    page.waiting.skip()
    return True


def _steps() -> dict[str, tuple[Callable[[_Page, Piece], bool], ...]]:
    """Return the steps of each command, in the order in which they are tried."""
    found: dict[str, tuple[Callable[[_Page, Piece], bool], ...]] = {}
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


_TABLE: tuple[tuple[Iterable[str], Callable[[_Page, Piece], bool]], ...] = (
    ((r"\left",), _left),
    ((r"\right",), _right),
    (_UNSEEN, _without(1)),
    (_SIZES, _without(0)),
    ((r"\_",), _name),
    ((r"\!", r"\_"), _without(0)),
    ((r"\color",), _without(1)),
    ((r"\rule",), _rule),
    (_WITH_POWERS, _power_in_brackets),
    ((r"\lefteqn",), _framed(0, braces=False)),
    ((r"\resizebox",), _framed(2, braces=False)),
    ((r"\scalebox",), _framed(1, braces=False)),
    ((r"\textcolor", r"\colorbox", r"\raisebox"), _framed(1)),
    ((r"\makebox", r"\framebox"), _boxed),
    ((r"\smash", r"\mathclap", r"\fbox"), _framed(0)),
    (_BRACES, _braced_below),
    ((r"\mathbin",), _binary),
    ((r"\mathop",), _colon),
    ((r"\%",), _percent),
    ((r"\Re", r"\Im"), _lone_part),
    ((r"\lfloor",), _floor_of_cross),
    *(((name,), _written(text)) for name, text in (_OTHERWISE | _ROUNDED).items()),
    (_POSTFIX, _postfix),
    (_TRIANGLES, _triangle),
    ((r"\prime",), _prime),
    ((r"\times",), _cross),
    (("|", r"\vert", r"\lvert"), _ket),
    (("{",), _end_of_command),
    (("{",), _needless_braces),
    (("{",), _brace),
    (("{",), _label),
    (BOXES, _box),
    ((r"\mathrm",), _upright),
    ((r"\buildrel",), _built),
    (_OVER, _over),
    (_INFIX, _infix),
    (_ROOM, _room),
    (("!",), _unequal),
    ((r"\not",), _not),
    (("'",), _prime_behind_nothing),
    ((r"\partial",), _slope),
    (("e",), _scientific),
    ((r"\,", r"\;", "\\ "), _between_numbers),
    ((".",), _ellipsis),
    ((".",), _stop),
    (("-",), _number_with_sign),
    ((r"\\",), _row),
)
_STEPS: Mapping[str, tuple[Callable[[_Page, Piece], bool], ...]] = _steps()
