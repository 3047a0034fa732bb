"""What has an argument: fractions, roots, sums, integrals, derivatives and functions."""

import re
from collections.abc import Sequence
from dataclasses import replace

from lark import Token

from algebroproj_sym.reading.lexing.commands import (
    ARGUMENT,
    BARS,
    BIG,
    BOLD,
    CLOSING,
    CLOSING_BARS,
    DROPPED,
    FRACTIONS,
    MATRIX,
    OPENING,
    RELATIONS,
    SIGNS,
    UPRIGHT,
)
from algebroproj_sym.reading.lexing.cursor import Cursor
from algebroproj_sym.reading.lexing.names import (
    at_symbol,
    at_unknown_command,
    at_unknown_letter,
    bracket_ahead,
    function_at,
    read_after,
    take_letter,
    take_scripts,
    written,
)
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, bare, outside_braces, says_more

_SIGNS = (r"\partial", "d", r"\delta")
r"""How derivatives begin; ``\frac{\delta x}{\delta t}`` is a quotient of small numbers, unless of second order."""


def _derivative(above: str, below: str) -> str | None:
    r"""Return the text of a derivative, empty for d/dx before what it is of; None if a fraction is none.

    Examples
    --------
    >>> _derivative("dy", "dx"), _derivative("\\partial", "\\partialx"), _derivative("d", "2")
    ('dy/dx', '', None)
    """
    sign = next((each for each in _SIGNS if above.startswith(each) and below.startswith(each)), None)
    if sign == r"\delta" and above[len(sign) :] and not re.match(r"\^\{?[2-9]", above[len(sign) :]):
        return None
    if (
        sign is None
        or "/" in above + below
        or len(below) == len(sign)
        or not re.match(r"[A-Za-z\\(]", below[len(sign) :])
    ):
        return None
    rest = re.sub(r"^\^?\d*", "", above[len(sign) :])
    return f"{above}/{below}" if rest else ""


_UNSEEN = (r"\displaystyle", r"\,")


def _derivative_at(cursor: Cursor) -> str | None:
    """Return the text of the derivative that the next fraction is; None if it is none."""
    ahead = replace(cursor, index=cursor.index + 1)
    above, below = (bare([each for each in ahead.group() if each.text not in _UNSEEN]) for _ in range(2))
    is_plain = cursor.functions is None or (above.startswith("d") and cursor.known("d"))
    return None if is_plain else _derivative(above, below)


def read_fraction(cursor: Cursor) -> None:
    """Read a fraction, a derivative, or d/dx before what it is of."""
    start = cursor.place
    derivative = _derivative_at(cursor)
    cursor.index += 1
    above, below = cursor.group(), cursor.group()
    if derivative is None:
        cursor.out.append(Token("FRACTION", r"\frac", start_pos=start))
        cursor.inner(above)
        cursor.inner(below)
        read_after(cursor)
    elif derivative:
        cursor.out.append(Token("OPAQUE", derivative, start_pos=start))
        read_after(cursor)
    elif cursor.peek() in _ENDS_OF_VALUES or cursor.peek() in RELATIONS:
        cursor.out.append(Token("SHOWN", rf"\frac{{{bare(above)}}}{{{bare(below)}}}", start_pos=start))
        read_after(cursor)
    else:
        cursor.out.append(Token("BIG", f"{bare(above)}/{bare(below)}", start_pos=start))
        _read_body(cursor)


_ENDS_OF_VALUES = frozenset(("", "+", "-", ",", "&", r"\\", ")", "]", "}", r"\right", r"\rangle"))
"""What comes behind an operator of which nothing is taken."""


def read_binomial(cursor: Cursor) -> None:
    """Read a binomial coefficient, as a function of two numbers."""
    cursor.emit("FUNCTION", "binom")
    cursor.index += 1
    above, below = cursor.group(), cursor.group()
    cursor.emit("OPEN", "{")
    cursor.inner(above)
    cursor.emit("SEPARATOR", ",")
    cursor.inner(below)
    cursor.emit("CLOSE", "}")
    read_after(cursor)


def read_root(cursor: Cursor) -> None:
    """Read a root, with its degree."""
    cursor.emit("ROOT", r"\sqrt")
    cursor.index += 1
    degree = cursor.option()
    if degree is not None:
        cursor.emit("SUP", "^")
        cursor.inner(degree)
    cursor.inner(cursor.group())
    read_after(cursor)


def read_big(cursor: Cursor) -> None:
    """Read a sum, an integral or a limit, with what it is of."""
    start, name = cursor.place, cursor.text
    cursor.index += 1
    cursor.skip()
    while cursor.text in (r"\limits", r"\nolimits"):
        cursor.index += 1
        cursor.skip()
    _, below, above = take_scripts(cursor)
    limits = (f"_{{{below}}}" if below else "") + (f"^{{{above}}}" if above else "")
    cursor.out.append(Token("BIG", name + limits, start_pos=start))
    _read_body(cursor)


def read_underset(cursor: Cursor) -> None:
    r"""Read what is written over something, as ``\underset{x}{\text{min}}``: a minimum, a maximum or a limit."""
    start = cursor.place
    cursor.index += 1
    below, name = bare(cursor.group()), bare(cursor.group()).replace("\\", "")
    if not _EXTREME.fullmatch(name):
        raise UnreadableError(r"the command \underset is read only below a minimum, a maximum or a limit", start)
    cursor.out.append(Token("BIG", f"{name}_{{{below}}}", start_pos=start))
    _read_body(cursor)


_EXTREME = re.compile(r"(?:arg)?(?:min|max|lim|inf|sup)(?:imi[sz]e)?\.?")


def _read_body(cursor: Cursor) -> None:
    """Emit what a sum, an integral or a derivative is of: all to the next sign, relation or end."""
    while cursor.text.isspace() or cursor.text in (r"\,", r"\;", r"\!"):
        cursor.index += 1
    start, depth, within = cursor.index, 0, False
    while cursor.index < len(cursor.pieces):
        text = cursor.text
        if depth == 0 and text in BIG:
            cursor.index += 1
            take_scripts(cursor)
            cursor.skip()
            cursor.index += cursor.text in SIGNS
            continue
        if depth == 0 and not within and cursor.index > start and BARS.get(text) in cursor.opened:
            break
        within ^= depth == 0 and text in BARS
        if (
            not within
            and depth == 0
            and cursor.index > start
            and (text in SIGNS or text in RELATIONS or text in (",", "&", r"\\"))
        ):
            break
        deeper = text in OPENING or text == "{" or text.startswith(r"\begin{")
        depth += deeper - (text in CLOSING or text == "}" or text.startswith(r"\end{"))
        if depth < 0:
            break
        cursor.index += 1
    cursor.inner([piece for piece in cursor.pieces[start : cursor.index] if piece.text not in (r"\left", r"\right")])


_BEHIND_UNITS = frozenset(("", ".", ",", ")", "]", "&", r"\\", *RELATIONS))
"""What comes behind a second that is no secant."""


def read_function(cursor: Cursor) -> None:
    """Read a function with its exponent and its argument."""
    start, name = cursor.place, function_at(cursor)
    upright = cursor.text in UPRIGHT
    cursor.index += 1
    if upright:
        cursor.group()
    primes, below, _ = take_scripts(cursor)
    if primes:
        raise cursor.fail("a prime is read only after a letter")
    mark, raised = len(cursor.out), cursor.raised
    if name == "sec" and cursor.peek() in _BEHIND_UNITS and not (below or raised):
        cursor.out.append(Token("SYMBOL", r"\mathrm{s}", start_pos=start))
        return
    cursor.out.append(Token("FUNCTION", name + (f"_{below}" if below else ""), start_pos=start))
    opening = cursor.peek()
    begin = cursor.index
    _read_argument(cursor)
    if (opening in ("(", "[") or opening in CLOSING_BARS) and cursor.peek() == "^" and not raised:
        _choose_raised(cursor, begin, mark)
    inside = cursor.out[mark + 2 : -1]
    if len(inside) == 1 and cursor.known(f"\\{name}{inside[0]}"):
        cursor.out[mark:] = [Token("SYMBOL", f"\\{name}{inside[0]}", start_pos=start)]
        if raised:
            cursor.emit("SUP", "^")
            cursor.inner(raised)
    elif raised:
        cursor.out[mark + 1 : mark + 1] = _exponent(cursor, raised)
    read_after(cursor)


_VECTORS = {*BOLD, r"\mathbf", r"\vec", r"\hat", r"\overrightarrow"}
r"""How a vector begins, or a unit vector: no argument goes on over one, as in ``\cos\theta \mathbf{i}``."""


def _choose_raised(cursor: Cursor, begin: int, mark: int) -> None:
    r"""Choose what is raised in ``\ln(x)^2``: the value of the function, or its argument."""
    cursor.chose = ARGUMENT
    if not cursor.wide:
        while cursor.text != "^":
            cursor.index += 1
        take_scripts(cursor)
        del cursor.out[mark + 1 :]
        cursor.inner(cursor.pieces[begin : cursor.index])


def _exponent(cursor: Cursor, raised: Sequence[Piece]) -> list[Token]:
    """Return the tokens of an exponent."""
    inner = replace(cursor, pieces=[], index=0, out=[])
    inner.emit("SUP", "^")
    inner.inner(raised)
    return inner.out


def _read_argument(cursor: Cursor) -> None:
    """Emit the argument of a function: a bracket, or numbers and letters that follow one another."""
    while cursor.text.isspace() or cursor.text in DROPPED - {r"\mathrm"}:
        cursor.index += 1
    start = cursor.index
    if cursor.text in BIG:
        _read_body(cursor)
        return
    if cursor.text in ("(", "[", r"\{", "{") or cursor.text in CLOSING_BARS or MATRIX.match(cursor.text):
        cursor.inner(_take_bracket(cursor))
        return
    if cursor.functions is not None and (function_at(cursor) or at_unknown_command(cursor)):
        cursor.emit("OPEN", "{")
        cursor.step(cursor)
        cursor.emit("CLOSE", "}")
        return
    values, last = 0, ""
    while cursor.index < len(cursor.pieces):
        here = cursor.index
        if cursor.text.isspace():
            cursor.index += 1
            continue
        number = cursor.text.isdigit() or cursor.text == "."
        unknown = not values and cursor.functions is not None and at_unknown_letter(cursor)
        if not (number or unknown or cursor.text in FRACTIONS or cursor.text == r"\sqrt" or at_symbol(cursor)):
            if cursor.index > start and cursor.peek() in ("(", "["):
                cursor.chose = ARGUMENT
            break
        if values and (not cursor.wide or cursor.text in _VECTORS or _is_factor(cursor, last)):
            cursor.chose = ARGUMENT
            break
        if values:
            cursor.chose = ARGUMENT
        if number:
            cursor.index += 1
            take_scripts(cursor) if cursor.text == "^" else None
            _take_factorial(cursor)
            continue
        letter, last = "", cursor.text
        if cursor.text in FRACTIONS or cursor.text == r"\sqrt":
            cursor.single()
        else:
            letter = take_letter(cursor)
        _, below, _ = take_scripts(cursor)
        inside = bracket_ahead(cursor) if cursor.functions is not None else []
        if written(letter, 0, below, "") in (cursor.functions or ()) or _has_condition(letter, inside):
            cursor.index += len(inside)
        _take_factorial(cursor)
        values += 1
        if cursor.index == here:
            break
    if cursor.index == start:
        raise cursor.fail("expected the argument of a function")
    cursor.inner(cursor.pieces[start : cursor.index])


_ANGLES = frozenset(
    rf"\{name}" for name in ("theta", "phi", "varphi", "psi", "alpha", "beta", "gamma", "delta", "vartheta", "lambda")
)
_RATES = frozenset((r"\dot", r"\ddot"))


def _is_factor(cursor: Cursor, last: str) -> bool:
    r"""Whether what comes next is no part of an angle, as in ``\sin\theta K`` and ``\cos E \frac{dE}{dt}``."""
    if cursor.text in FRACTIONS:
        return _derivative_at(cursor) is not None
    return last in _ANGLES and (cursor.text in _RATES or (cursor.text.isalpha() and cursor.text.isupper()))


def _has_condition(letter: str, inside: Sequence[Piece]) -> bool:
    r"""Whether a bracket makes a letter a value with a condition, or of several letters, as in ``\log p(y|x)``."""
    if any(piece.text in (",", ";") for piece in outside_braces(inside)):
        return True
    is_name = re.fullmatch(r"[a-zA-Z]{2,}", letter) is not None
    return says_more(inside) and (is_name or any(piece.text in ("|", r"\mid", r"\vert") for piece in inside))


def _take_factorial(cursor: Cursor) -> None:
    if cursor.peek() == "!":
        while cursor.text != "!":
            cursor.index += 1
        cursor.index += 1
        if cursor.peek() == "!":
            raise cursor.fail("a double factorial is not read")


def _take_bracket(cursor: Cursor) -> list[Piece]:
    """Return the pieces of the bracket that begins here, without the bracket unless it is one of a value."""
    opening, start = cursor.text, cursor.index
    closing = {"(": ")", "[": "]", r"\{": r"\}", "{": "}", **CLOSING_BARS}.get(opening, opening)
    if MATRIX.match(opening):
        closing = opening.replace("begin", "end")
    depth = 0
    while cursor.index < len(cursor.pieces):
        text = cursor.text
        cursor.index += 1
        if text == closing and (opening != closing or depth):
            depth -= 1
        elif text == opening:
            depth += 1
        if depth == 0:
            kept = cursor.pieces[start : cursor.index]
            inside = kept if opening in CLOSING_BARS or MATRIX.match(opening) else kept[1:-1]
            return inside[:-1] if inside and inside[-1].text == r"\right" else inside
    raise UnreadableError("a bracket is not closed", cursor.pieces[start].place)
