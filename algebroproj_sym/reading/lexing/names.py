"""Letters with their accents, primes, subscripts and powers: what is one name, and what is raised."""

import re
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

from lark import Token

from algebroproj_sym.reading.lexing.commands import (
    AXIS,
    BEFORE_LETTER,
    BINOMIALS,
    BOLD,
    CLOSING,
    DIFFERENTIALS,
    DROPPED,
    FRACTIONS,
    FUNCTIONS,
    GREEK,
    LETTERS,
    MARKS,
    NAMED,
    NO_LETTERS,
    OPENING,
    PART_OF_NAME,
    SIZE,
    STYLES,
    UPRIGHT,
    WITH_ARGUMENT,
)
from algebroproj_sym.reading.lexing.cursor import Cursor
from algebroproj_sym.reading.lexing.pieces import (
    Piece,
    UnreadableError,
    bare,
    contracts,
    outside_braces,
    pieces_of,
    says_more,
    split_pieces,
)


def bare_name(symbol: str) -> str:
    """Return a symbol without braces and spaces."""
    return re.sub(r"[{}\s]", "", symbol)


@cache
def split_symbol(symbol: str) -> tuple[str, int, str, str]:
    r"""Return letter, number of primes, subscript and superscript of a symbol; the whole if a script is missing.

    Examples
    --------
    >>> split_symbol(r"\mu_{j1}''^T")
    ('\\mu', 2, 'j1', 'T')
    """
    word = re.match(r"[a-zA-Z]*", symbol)[0]  # type: ignore[index]  # it always matches
    rest = symbol[len(word) :] if len(word) > 1 else symbol
    inner = Cursor(pieces_of(rest))
    try:
        letter = word if len(word) > 1 else take_letter(inner)
        return (letter, *take_scripts(inner))
    except UnreadableError:
        return symbol, 0, "", ""


def written(letter: str, primes: int, subscript: str, superscript: str) -> str:
    r"""Return the one way in which tables write a symbol.

    Examples
    --------
    >>> written("\\mu", 2, "31", "")
    "\\mu_{31}''"
    """
    below = f"_{{{subscript}}}" if len(subscript) > 1 else f"_{subscript}" if subscript else ""
    above = f"^{{{superscript}}}" if len(superscript) > 1 else f"^{superscript}" if superscript else ""
    return f"{letter}{below}{chr(39) * primes}{above}"


def is_behind(script: Sequence[str]) -> bool:
    r"""Whether a script above belongs to what stands before it, as in ``(AB){}^T``: a mark of matrices or a number."""
    inside = list(script[1 : [*script, "}"].index("}")]) if script[:1] == ["{"] else list(script[:1])
    return "".join(inside) in MARKS or inside[:1] == ["-"] or all(each.isdigit() for each in inside)


def at_symbol(cursor: Cursor) -> bool:
    """Whether a letter begins here."""
    text = cursor.text
    if text in UPRIGHT:
        return not function_at(cursor)
    return text.isalpha() or text in LETTERS or text in STYLES or text in BOLD or text == r"\partial"


def function_at(cursor: Cursor) -> str:
    """Return the name of the function that begins here; empty if none does."""
    text = cursor.text
    if text in UPRIGHT:
        rest = cursor.pieces[cursor.index + 1 : cursor.index + 14]
        inside = re.match(r"\s*\{([a-zA-Z0-9]+)\}", "".join(piece.text for piece in rest))
        named = inside and (inside[1] in FUNCTIONS or (text == r"\operatorname" and inside[1] in NAMED))
        return inside[1] if inside and named else ""
    if text in (r"\Re", r"\Im"):
        return text[1:] if cursor.functions is not None else ""
    return text[1:] if text.startswith("\\") and text[1:] in FUNCTIONS else ""


def take_letter(cursor: Cursor) -> str:
    """Return the letter, with its style and accents, as tables write it."""
    cursor.skip()
    text = BOLD.get(cursor.text, cursor.text)
    cursor.index += 1
    if text in STYLES or text in UPRIGHT or (cursor.text == "{" and _is_accent(text)):
        inside = bare(cursor.group())
        if text == r"\mathbf" and (accented := _ACCENTED.fullmatch(inside)):
            return rf"{accented[1]}{{\mathbf{accented[2]}}}"
        return inside if text in UPRIGHT else f"{text}{{{inside}}}"
    return text


_ACCENTED = re.compile(r"(\\(?:d*dot|tilde|bar|hat|overline|widehat|widetilde|check|breve))([a-zA-Z]|\\[a-zA-Z]+)")
r"""A letter with an accent: ``\mathbf{\hat s}`` is printed as ``\hat{\mathbf s}`` is."""


def _is_accent(text: str) -> bool:
    """Whether a command before a brace is an accent, though it may be one that nothing defines."""
    return text not in LETTERS and re.fullmatch(r"\\[a-zA-Z]+", text) is not None and text != r"\partial"


def take_scripts(cursor: Cursor) -> tuple[int, str, str]:
    """Return the primes, the subscript and the superscript that follow."""
    primes, below, above = 0, "", ""
    cursor.raised = []
    while True:
        here = cursor.index
        while cursor.text.isspace() or (cursor.text == "{" and cursor.peek(1) == "}" and _at_script(cursor)):
            cursor.index += 1 if cursor.text.isspace() else 2
        if cursor.text == "'":
            cursor.index += 1
            primes += 1
        elif cursor.text == "_":
            cursor.index += 1
            below += bare(cursor.group())
        elif cursor.text == "^" and not above:
            cursor.index += 1
            cursor.raised = cursor.group()
            inside = bare(cursor.raised).replace(r"\prime", "'")
            primes += inside.count("'")
            above = inside.replace("'", "")
        else:
            cursor.index = here
            return primes, below, above


def _at_script(cursor: Cursor) -> bool:
    rest = [piece.text for piece in cursor.pieces[cursor.index : cursor.index + 12] if not piece.text.isspace()]
    if rest[:2] != ["{", "}"] or len(rest) < 3 or rest[2] not in ("_", "^", "'"):
        return False
    return rest[2] != "^" or is_behind(rest[3:])


def read_symbol(cursor: Cursor) -> None:
    """Read a letter with its scripts."""
    start, command = cursor.place, cursor.text
    letter = take_letter(cursor)
    cursor.skip()
    if command.startswith(r"\operatorname") and (at_symbol(cursor) or cursor.text.isdigit() or function_at(cursor)):
        raise cursor.fail(f"the function {letter} is not known")
    read_scripted(cursor, letter, start)


def read_scripted(cursor: Cursor, letter: str, start: int) -> None:
    """Read the scripts behind a letter: what is part of its name, and what is a power."""
    differs = cursor.functions is not None and letter in DIFFERENTIALS and not cursor.known(letter)
    ahead = replace(cursor)
    while differs and letter == r"\Delta" and ahead.text in ("\\,", "\\!", " "):
        ahead.index += 1
    if differs and _at_factor(ahead):
        cursor.index = ahead.index
        _read_differential(cursor, letter, start)
        return
    primes, below, above = take_scripts(cursor)
    whole = written(letter, primes, below, above)
    bare = written(letter, primes, below, "")
    if not above or cursor.known(whole):
        emit_name(cursor, whole, start)
    elif re.fullmatch(r"\*(T|-1|\\top)", above):
        emit_name(cursor, written(letter, primes, below, "*"), start, raised=True)
        emit_power(cursor, above[1:], cursor.raised[1:])
    elif (
        PART_OF_NAME.fullmatch(above)
        or any(each.text == "," for each in cursor.raised)
        or is_axis(cursor, letter, above)
        or _is_label(cursor, above)
    ):
        emit_name(cursor, whole, start)
    elif cursor.functions is not None and _has_indices(cursor, letter, below, above):
        cursor.chose = "letters in superscripts may be indices"
        emit_name(cursor, whole, start)
    elif cursor.functions is not None and re.fullmatch("[2-9]", above) and says_more(bracket_ahead(cursor)):
        raised = cursor.raised
        emit_name(cursor, bare, start)
        emit_power(cursor, above, raised)
    elif cursor.functions is not None and _is_power_of_value(cursor, bare, above) and _is_called(cursor, bare):
        raised, inside = cursor.raised, bracket_ahead(cursor)
        argument = cursor.within(inside)
        argument.until_end()
        cursor.out += [Token("CALLEE", bare, start_pos=start), *argument.out]
        cursor.index += len(inside)
        emit_power(cursor, above, raised)
    elif above == "-1" and bare in (cursor.functions or ()) and cursor.peek() == "(":
        cursor.out.append(Token("CALLEE", whole, start_pos=start))
    else:
        emit_name(cursor, bare, start, raised=True)
        emit_power(cursor, above, _without_primes(cursor.raised))
    read_after(cursor)


def _is_power_of_value(cursor: Cursor, name: str, above: str) -> bool:
    r"""Whether what stands above a function is of its value, as in ``f^2(x)`` and, where R(q) stands, ``R^T(q)``.

    That a function has an inverse is another thing, but no function is called by a bold capital.
    """
    if re.fullmatch("[2-9]", above):
        return True
    of_matrix = MARKS.get(above.removeprefix("-")) == "T" or (above == "-1" and _BOLD_CAPITAL.fullmatch(name))
    return bool(of_matrix) and name in (cursor.functions or ()) and _at_lone_letters(cursor)


def _at_lone_letters(cursor: Cursor) -> bool:
    """Whether the bracket that follows has nothing but letters with commas between them, perhaps with frames."""
    parts = split_pieces(bracket_ahead(cursor)[1:-1], (",",))
    return all(_is_alone(cursor.within(part)) for part in parts)


def _is_alone(cursor: Cursor) -> bool:
    """Whether there is one letter, with scripts before and behind it."""
    cursor.skip()
    take_scripts(cursor)
    cursor.skip()
    if not at_symbol(cursor):
        return False
    take_letter(cursor)
    take_scripts(cursor)
    cursor.skip()
    return cursor.index == len(cursor.pieces)


_BOLD_CAPITAL = re.compile(r"\\mathbf\{[A-Z]\}(?:_.*)?")


def _is_called(cursor: Cursor, name: str) -> bool:
    """Whether the round bracket that comes next has the argument of a letter."""
    return cursor.peek() == "(" and (name in (cursor.functions or ()) or _at_argument(cursor))


def _without_primes(raised: Sequence[Piece]) -> list[Piece]:
    r"""Return an exponent without its primes, and without the ``^`` before them."""
    kept = list[Piece]()
    for piece in raised:
        if piece.text in ("'", r"\prime"):
            while kept and (kept[-1].text == "^" or kept[-1].text.isspace()):
                kept.pop()
        else:
            kept.append(piece)
    return kept


def _is_label(cursor: Cursor, above: str) -> bool:
    r"""Whether what stands above a letter is an upright capital, as in ``\varepsilon^\mathrm{V}``, and no mark."""
    upright = next((each.text for each in cursor.raised if not each.text.isspace()), "") in UPRIGHT
    return cursor.functions is not None and upright and re.fullmatch("[A-Z]", above) is not None and above not in MARKS


def is_axis(cursor: Cursor, letter: str, above: str) -> bool:
    r"""Whether what stands above a vector is an axis or a frame, as in ``\mathbf{e}^z``, and no power."""
    return cursor.functions is not None and letter.startswith(r"\mathbf{") and bool(re.fullmatch(AXIS, above))


def at_unknown_letter(cursor: Cursor) -> bool:
    """Whether a command of the document that nothing defines may be a letter: it takes no argument."""
    named = re.fullmatch(r"\\[a-zA-Z]+", cursor.text) is not None
    return named and cursor.text not in NO_LETTERS and cursor.peek(1) != "{"


def at_unknown_command(cursor: Cursor) -> bool:
    """Whether a command of the document that nothing defines takes arguments."""
    named = re.fullmatch(r"\\[a-zA-Z]+", cursor.text) is not None
    return named and cursor.text not in NO_LETTERS | _WITH_ARGUMENTS and cursor.peek(1) == "{"


_WITH_ARGUMENTS = FRACTIONS | BINOMIALS | BEFORE_LETTER | WITH_ARGUMENT | {r"\sqrt", *STYLES, *UPRIGHT, *BOLD}


def _has_indices(cursor: Cursor, letter: str, below: str, above: str) -> bool:
    r"""Whether what stands above a letter may be indices, as in ``T^{\mu\nu}`` and ``g_\mu^\nu``, and no power."""
    if letter in ("e", r"\mathrm{e}") or above in MARKS:
        return False
    unseen = UPRIGHT | {"{", "}"}
    letters = [each.text for each in cursor.raised if not (each.text.isspace() or each.text in unseen)]
    alone = all(each in GREEK or (len(each) == 1 and each.isalpha()) for each in letters)
    return alone and (len(letters) > 1 or {above, below} <= GREEK)


def _at_factor(cursor: Cursor) -> bool:
    here = cursor.text
    return _at_letter_in_braces(cursor) or (
        bool(here) and (here.isalpha() or here in LETTERS or here in STYLES or here in BOLD or here == r"\mathrm")
    )


def _at_letter_in_braces(cursor: Cursor) -> bool:
    r"""Whether a letter in braces comes next, perhaps with its scripts, as in ``\Delta{x_i}``."""
    if cursor.text != "{":
        return False
    ahead = replace(cursor)
    inner = cursor.within(ahead.group())
    if not (inner.text.isalpha() or inner.text in LETTERS or inner.text in STYLES or inner.text in BOLD):
        return False
    take_letter(inner)
    _, _, above = take_scripts(inner)
    return not above and inner.index == len(inner.pieces)


def _read_differential(cursor: Cursor, letter: str, start: int) -> None:
    inside = cursor.within(cursor.group()) if _at_letter_in_braces(cursor) else cursor
    inner = take_letter(inside)
    own, under, _ = take_scripts(inside) if inside is not cursor else (0, "", "")
    primes, below, above = take_scripts(cursor)
    primes, below = primes + own, under + below
    label = inner.startswith(r"\mathbf{") and re.fullmatch(r"\\?[a-z]+|[A-Z]", above) and above not in MARKS
    label = label or _has_indices(cursor, inner, below, above)
    is_named = bool(label) or PART_OF_NAME.fullmatch(above) is not None or _is_label(cursor, above)
    emit_name(cursor, f"{letter} {written(inner, primes, below, above if is_named else '')}", start)
    if above and not is_named:
        emit_power(cursor, above, cursor.raised)
    read_after(cursor)


_OF_DENSITIES = re.compile(r"[a-zPE](?![a-z])|\\math(?:bb|ds)|[VCP][a-z]|\\Pr")
"""How letters are written that are rather functions than factors."""


def emit_name(cursor: Cursor, whole: str, start: int, *, raised: bool = False) -> None:
    """Add the token of a letter, or of a function before its bracket, or a value with a condition, as in ``p(y|x)``."""
    inside = bracket_ahead(cursor) if cursor.functions is not None and not raised else []
    if inside and says_more(inside) and not (contracts(inside) and not _OF_DENSITIES.match(whole)):
        cursor.index += len(inside)
        cursor.chose = "a value with a condition, such as p(y|x), is read as a letter of its own"
        text = "".join(piece.text for piece in inside if not piece.text.isspace() and piece.text not in DROPPED)
        cursor.out.append(Token("SYMBOL", f"{whole} {text}", start_pos=start))
        return
    bracket = cursor.peek() if cursor.functions is not None and not (raised or _is_of_cross(cursor)) else ""
    index = _INDEX.fullmatch(_inside_of(cursor)) if bracket == "[" and whole in (cursor.functions or ()) else None
    of_chance = index and _EXPECTATION.fullmatch(whole) and _VARIABLE.fullmatch(index[0])
    if index and not (of_chance or OF_CHANCE.fullmatch(whole)):
        letter, primes, below, above = split_symbol(whole)
        cursor.index += len(bracket_ahead(cursor))
        indexed = written(letter, primes, f"{below},{index[0]}" if below else index[0], above)
        cursor.out.append(Token("SYMBOL", indexed, start_pos=start))
        return
    called = bracket == "[" and _ONE_INDEX.fullmatch(_inside_of(cursor)) is not None
    called = called or (bracket == "(" and _is_called(cursor, whole))
    called = called or (bracket in ("(", "[") and _FUNCTION.fullmatch(whole) is not None)
    named = _EXPECTATION.fullmatch(whole) is not None and (whole[:2] != "P_" or whole in (cursor.functions or ()))
    called = called or (bracket == "[" and named)
    cursor.out.append(Token("CALLEE" if called else "SYMBOL", whole, start_pos=start))


def _is_of_cross(cursor: Cursor) -> bool:
    r"""Whether the bracket that comes next is the matrix of a cross product, as in ``R [t]_\times``."""
    ahead = replace(cursor)
    ahead.index += len(bracket_ahead(ahead))
    return ahead.index > cursor.index and ahead.peek() in ("_", "^") and MARKS.get(take_scripts(ahead)[1]) == "hat"


def before_condition(symbol: str) -> str:
    r"""Return the letter of a value with a condition, as p of ``p(\mathbf{y}|x)``, and another symbol as it is."""
    return re.split(r" [(\[]", symbol, maxsplit=1)[0]


_FUNCTION = re.compile(r"(?:[a-zA-Z]{2,}|\\(?:Gamma|Delta|Pr)|\\math(?:bb|ds)\{[EPV]\})(?:_.*)?")
"""What is a function before a bracket, whatever stands in it."""
OFTEN_FUNCTION = re.compile(r"\\delta(?:_.*)?")
"""What is one as well, if it never stands alone."""
OF_CHANCE = re.compile(r"(?:\\math(?:bb|ds)\{[EPV]\}|[Vv]ar|[Cc]ov|\\Pr)(?:_.*)?")
"""What has no index in square brackets: it is a function of what is random."""
_EXPECTATION = re.compile(r"[EPV](?:_.*)?")
"""What is a function before a square bracket; a P with an index is one if it stands nowhere alone."""
_VARIABLE = re.compile(r"[A-Za-hu-z]")
"""What stands in the brackets of an expected value, and counts nothing."""


_ONE_INDEX = re.compile(r"[a-zA-Z]|0")
_INDEX = re.compile(r"[a-zA-Z](?:[+-](?:\d+|[a-zA-Z]))?|\d+")
"""What stands in square brackets behind a letter of which one value is ``x[n]`` or ``x[0]``: an index."""


def _inside_of(cursor: Cursor) -> str:
    """Return what stands in the bracket that comes next, without spaces."""
    return "".join(piece.text for piece in bracket_ahead(cursor)[1:-1] if not piece.text.isspace())


def bracket_ahead(cursor: Cursor) -> list[Piece]:
    """Return the pieces up to the end of the bracket that comes next; none if no bracket does."""
    if cursor.peek() not in ("(", "[", r"\{", r"\lbrace"):
        return []
    inside, depth = list[Piece](), 0
    for piece in cursor.pieces[cursor.index :]:
        inside.append(piece)
        depth += (piece.text in OPENING) - (piece.text in CLOSING)
        if depth == 0 and piece.text in CLOSING:
            return inside
    return []


def _at_argument(cursor: Cursor) -> bool:
    """Whether the bracket that follows has one letter alone, a zero, or several values: nobody writes x times zero."""
    inside = bracket_ahead(cursor)
    body = [piece for piece in inside if not piece.text.isspace() and piece.text not in DROPPED][1:-1]
    if any(piece.text in (",", ";") for piece in outside_braces(body)):
        return True
    if not body or any(piece.text in "+-*/()=|" for piece in body):
        return False
    if body[0].text == r"\Delta" and len(body) > 1 and _gives_a_value(cursor, len(inside)):
        body = body[1:]
    inner = Cursor(body, cursor.known)
    return (
        [piece.text for piece in body] == ["0"]
        or (len(body) == 1 and at_unknown_letter(inner))
        or (
            at_symbol(inner)
            and bool(take_letter(inner))
            and take_scripts(inner) is not None
            and inner.index == len(body)
        )
    )


def _gives_a_value(cursor: Cursor, length: int) -> bool:
    r"""Whether a bracket of so many pieces, behind the first letter, is all that stands before ``=``."""
    behind = (piece.text for piece in cursor.pieces[cursor.index + length :] if piece.text not in DROPPED)
    return not cursor.out and next((text for text in behind if not text.isspace()), "") in ("=", "&", ":=")


_OF_MATRIX = re.compile(r"\\mathbf\{|[A-Z](?:_.*)?$|[)\]]")
"""How the token before ``^{-T}``, the transposed inverse, begins: a bold letter, a capital, or a bracket."""


def emit_power(cursor: Cursor, above: str, raised: Sequence[Piece]) -> None:
    """Add what stands above a value: a mark of matrices, degrees or an exponent, as in ``e^t``."""
    if above in MARKS and not (above == "t" and cursor.out[-1] == "e"):
        cursor.emit("MARK", MARKS[above])
    elif above[:1] == "-" and MARKS.get(above[1:]) == "T" and _OF_MATRIX.match(cursor.out[-1]):
        cursor.emit("MARK", "T")
        cursor.emit("SUP", "^")
        for kind, text in (("OPEN", "{"), ("SIGN", "-"), ("NUMBER", "1"), ("CLOSE", "}")):
            cursor.emit(kind, text)
    elif above == r"\circ" and cursor.out[-1].type == "NUMBER":
        if cursor.peek() in UPRIGHT or cursor.peek() in ("C", "F"):
            raise cursor.fail("degrees of temperature are not read")
        degrees = cursor.out.pop()
        cursor.emit("OPEN", "{")
        cursor.out += [degrees, Token("SYMBOL", r"\pi", start_pos=degrees.start_pos)]
        cursor.emit("SLASH", "/")
        cursor.emit("NUMBER", "180")
        cursor.emit("CLOSE", "}")
    elif any(each.text == "," for each in raised) or above in ("+", "-", "**"):
        cursor.emit("MARK", f"_^{above}")
    elif above:
        cursor.emit("SUP", "^")
        cursor.inner(raised)


_THIN = (r"\,", r"\;", r"\:")


def _is_before_next(cursor: Cursor) -> bool:
    r"""Whether scripts behind a thin space belong to the letter behind them, as in ``R(q)\,^L a``."""
    ahead = replace(cursor)
    while ahead.text.isspace() or ahead.text in DROPPED:
        ahead.index += 1
    thin = any(piece.text in _THIN for piece in cursor.pieces[cursor.index : ahead.index])
    if cursor.functions is None or not thin or ahead.text == "'":
        return False
    if ahead.text == "^" and is_behind([piece.text for piece in ahead.pieces[ahead.index + 1 :]]):
        return False
    _, below, above = take_scripts(ahead)
    return all(_NAME.match(each) for each in (below, above) if each) and at_symbol(ahead)


_NAME = re.compile(r"[a-zA-Z]|\\math")
"""How the name of a frame begins."""


def read_after(cursor: Cursor) -> None:
    """Read what is attached to a value: powers, marks, the subscript of a bracket."""
    while cursor.peek() in ("^", "_", "'") and cursor.out[-1].type != "CALLEE" and not _is_before_next(cursor):
        cursor.skip()
        while cursor.text in DROPPED:
            cursor.index += 1
            cursor.skip()
        mark = cursor.text
        cursor.index += 1
        if mark == "'":
            cursor.emit("MARK", "_prime")
            continue
        raised = cursor.group()
        inside = bare(raised)
        if mark == "^":
            emit_power(cursor, inside, raised)
        elif MARKS.get(inside) == "hat":
            cursor.emit("MARK", "hat")
        elif not (SIZE.fullmatch(inside) or (cursor.out[-1].type == "NORM_CLOSE" and inside in ("2", "F"))):
            cursor.emit("MARK", f"_{inside}")
