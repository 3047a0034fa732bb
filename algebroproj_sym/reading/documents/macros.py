r"""Macros of a document: ``\newcommand``, ``\def`` and ``\DeclareMathOperator``, expanded within bounds."""

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from algebroproj_sym.reading.lexing.commands import MAX_PIECES
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, pieces_of

MAX_EXPANSIONS = 10_000

_COMMAND = re.compile(
    r"\\(?:(?:re)?newcommand|providecommand|DeclareRobustCommand)\*?\s*(?:\{\s*(\\[a-zA-Z]+)\s*\}|(\\[a-zA-Z]+))"
)
_COUNT = re.compile(r"\s*\[(\d)\]")
_DEFAULT = re.compile(r"\s*\[([^\[\]]*)\]")
_PAIRED = re.compile(r"\\DeclarePairedDelimiter\*?\s*\{?\s*(\\[a-zA-Z]+)\s*\}?\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
_DOCUMENT_COMMAND = re.compile(
    r"\\(?:New|Renew|Provide|Declare)DocumentCommand\s*\{?\s*(\\[a-zA-Z]+)\s*\}?\s*\{\s*(O\{[^{}]*\})?([m\s]*)\}\s*\{"
)
_DEFINITION = re.compile(r"(?:\\global\s*)?\\g?def\s*(\\[a-zA-Z]+)([^{}\\\n]*)(?=\{)")
_LET = re.compile(r"(?:\\global\s*)?\\let\s*(\\[a-zA-Z]+)\s*=?\s*(\\[a-zA-Z]+|[a-zA-Z])")
_GLOBAL = (r"\gdef", r"\global")
_ENVIRONMENT = re.compile(r"\\(?:re)?newenvironment\*?\s*\{([a-zA-Z]+\*?)\}")
_OPERATOR = re.compile(r"\\DeclareMathOperator\*?\s*\{\s*(\\[a-zA-Z]+)\s*\}")
_ALPHABET = re.compile(r"\\DeclareMathAlphabet\s*\{\s*(\\[a-zA-Z]+)\s*\}(?:\s*\{[^{}]*\}){2}\s*\{[a-z]?bx?\}")
_BOLD_ONES = re.compile(r"\\(?:mathbf|boldsymbol|bm|pmb)\s*(?:\{\s*)?[a-zA-Z]")
_FRAMES = (r"\ensuremath", r"\boxed", r"\mathrel", r"\mathopen", r"\mathclose")
"""Commands that change the looks of their argument only."""
_SLOPE, _PARTIAL = r"\frac{d#1}{d#2}", r"\frac{\partial#1}{\partial#2}"
_SLOPES, _PARTIALS = r"\frac{d^{#1}#2}{d#3^{#1}}", r"\frac{\partial^{#1}#2}{\partial#3^{#1}}"
_DERIVATIVES = frozenset((_SLOPE, _PARTIAL, _SLOPES, _PARTIALS))
"""With one argument they are operators on what stands behind them."""
_OF_PACKAGES = {
    r"\abs": (1, r"\left|#1\right|"),
    r"\norm": (1, r"\left\|#1\right\|"),
    r"\eval": (1, r"\left.#1\right|"),
    **dict.fromkeys((r"\dv", r"\od", r"\td", r"\deriv", r"\dod"), (2, _SLOPE)),
    **dict.fromkeys((r"\pdv", r"\pd", r"\pderiv", r"\diffp", r"\dpd"), (2, _PARTIAL)),
    **dict.fromkeys((r"\dv[", r"\od["), (3, _SLOPES)),
    **dict.fromkeys((r"\pdv[", r"\pd["), (3, _PARTIALS)),
    **dict.fromkeys((r"\dd", r"\dif"), (0, r"\mathrm{d}")),
    r"\cross": (0, r"\times"),
    r"\vdot": (0, r"\cdot"),
    r"\grad": (0, r"\nabla"),
    **dict.fromkeys((r"\curl", r"\rot"), (0, r"\nabla\times")),
    r"\divergence": (0, r"\nabla\cdot"),
    r"\laplacian": (0, r"\nabla^2"),
    **dict.fromkeys((r"\tcolon", r"\dcolon"), (0, ":")),
    **{rf"\{name}": (0, rf"\operatorname{{{name}}}") for name in ("tr", "Tr", "trace", "dev", "sym")},
    r"\order": (1, r"\mathcal{O}(#1)"),
    r"\vb*": (1, r"\mathbf{#1}"),
    **dict.fromkeys((r"\vu", r"\vu*"), (1, r"\hat{\mathbf{#1}}")),
    **{rf"\m{style}": (1, rf"\math{style}{{#1}}") for style in ("rm", "cal", "bb", "sf", "scr", "frak")},
    **dict.fromkeys((r"\cr", r"\tabularnewline"), (0, r"\\")),
    **{rf"\{name}": (1, rf"\begin{{{name}}}#1\end{{{name}}}") for name in ("matrix", "pmatrix", "cases")},
    **{rf"\begin{{{name}}}": (1, r"\begin{equation}#1\begin{cases}") for name in ("numcases", "subnumcases")},
    **dict.fromkeys((r"\end{numcases}", r"\end{subnumcases}"), (0, r"\end{cases}\end{equation}")),
    **{
        rf"\{mark}{{{name}}}": (0, rf"\{mark}{{eqnarray}}")
        for mark in ("begin", "end")
        for name in ("subeqnarray", "darray")
    },
    **{
        rf"\{name.title()}": (0, rf"\{name}")
        for name in ("dot", "ddot", "bar", "hat", "tilde", "vec", "check", "breve")
    },
    r"\half": (0, r"\frac{1}{2}"),
    r"\E": (0, r"\mathbb{E}"),
    **dict.fromkeys((r"\defeq", r"\eqdef", r"\defn"), (0, r"\coloneqq")),
    r"\ra": (0, r"\rightarrow"),
    r"\Ra": (0, r"\Rightarrow"),
    r"\num": (1, "#1"),
    **dict.fromkeys((r"\SI", r"\qty", r"\unit["), (2, r"#1\,\mathrm{#2}")),
    r"\si": (1, r"\mathrm{#1}"),
    r"\ang": (1, r"#1^\circ"),
    r"\qq": (1, r"\quad\text{#1}\quad"),
    r"\MoveEqLeft[": (1, ""),
    r"\qc": (0, r",\quad"),
    **{
        f"{name}{star}": (1, rf"\left{opening}#1\right{closing}")
        for names, opening, closing in (
            (r"\paren \parens \pqty \of \del", "(", ")"),
            (r"\brk \bbrack \bqty \sbr", "[", "]"),
            (r"\Bqty \set \Set \cbr", r"\{", r"\}"),
        )
        for name in names.split()
        for star in ("", "*")
    },
}
r"""Commands of packages that documents load, with how many arguments they take; with a bracket, if one comes first.

Some have other names in documents whose macros are elsewhere, as ``\pd``.
"""
_OF_DISPLAYS = (
    (r"\be", r"\ee", "equation"),
    (r"\beq", r"\eeq", "equation"),
    (r"\bea", r"\eea", "eqnarray"),
    (r"\beqa", r"\eeqa", "eqnarray"),
)
"""Commands that begin and end displays in documents whose macros are elsewhere."""
_OF_VECTORS = (r"\ve", r"\vc", r"\ma", r"\mb", r"\mtx")
"""Commands for bold letters in documents whose macros are elsewhere, if a letter follows them everywhere."""
_LETTER = re.compile(r"\s*\{?\s*(?:[a-zA-Z]|\\[a-zA-Z]+)")
_OF_NUMBERS = (r"\num", r"\SI", r"\qty")
_TENS = re.compile(r"([\d.]+)[eE]([-+]?\d+)")
_BOLD_BOX = re.compile(r"\\mbox\s*\{\s*\\boldmath\s*\$([^$]*)\$\s*\}")
_GROUPS = re.compile(
    r"(?P<opens>\\begin\s*\{[^{}]*\}|\\begingroup\b|\\bgroup\b|(?<!\\)\{)|\\end\s*\{[^{}]*\}|\\endgroup\b|\\egroup\b|(?<!\\)\}"
)
_PARAMETER = re.compile(r"#([1-9])")
_OPENING = re.compile(r"\s*\{")
_ENDS_COMMAND = re.compile(r"\\[a-zA-Z]+$")


@dataclass(frozen=True)
class Macro:
    """A macro: how many arguments it takes, the default of the first one if it is optional, and what it stands for.

    One that the document does not define is none unless a brace, or a bracket, comes next.
    """

    count: int
    default: str | None
    body: str
    is_guessed: bool = field(default=False, repr=False)
    marks: tuple[str, ...] = field(default=(), repr=False)
    r"""What stands before its arguments, and behind each, as ``<`` and ``>`` of ``\def\mean<#1>``."""


def macros_in(text: str) -> tuple[dict[str, Macro], list[tuple[int, int]]]:
    r"""Return the macros that a text defines, and where their definitions begin and end.

    A macro that is defined several times has its first meaning here; `redefinitions` has the others.

    Examples
    --------
    >>> macros_in(r"\newcommand{\half}[1]{\frac{#1}{2}}")[0]
    {'\\half': Macro(count=1, default=None, body='\\frac{#1}{2}')}
    """
    found = {name: Macro(1, None, "#1") for name in _FRAMES if name in text}
    known = {
        name: Macro(count, "" if name.endswith("[") else None, body, is_guessed=True)
        for name, (count, body) in _OF_PACKAGES.items()
        if name in text
    }
    known |= {f"{name}*": known[name] for name in (r"\abs", r"\norm") if name in known}
    for opens, closes, name in _OF_DISPLAYS:
        if all(re.search(rf"{re.escape(each)}(?![a-zA-Z])", text) for each in (opens, closes)):
            known |= {opens: Macro(0, None, rf"\begin{{{name}}}"), closes: Macro(0, None, rf"\end{{{name}}}")}
    spans: list[tuple[int, int]] = []
    for name in _OF_VECTORS:
        places = [each.end() for each in re.finditer(rf"{re.escape(name)}(?![a-zA-Z])", text)]
        if places and all(_LETTER.match(text, each) for each in places):
            known[name] = Macro(1, None, r"\mathbf{#1}")
    if len(bold := {*_ALPHABET.findall(text)}) == 1 and not _BOLD_ONES.search(text):
        known |= dict.fromkeys(bold, Macro(1, None, r"\mathbf{#1}"))
    for match in _PAIRED.finditer(text):
        found |= dict.fromkeys((match[1], f"{match[1]}*"), Macro(1, None, rf"\left{match[2]} #1\right{match[3]} "))
        spans.append(match.span())
    for name, begin, end, meaning in _given(text):
        found.setdefault(name, meaning)
        spans.append((begin, end))
    return {**known, **found}, spans


def redefinitions(text: str) -> list[tuple[int, str, Macro]]:
    """Return the definitions of macros that have several, in order: place, name and meaning."""
    made = list[tuple[int, str, Macro]]()
    before: dict[str, Macro] = {}
    for name, begin, end, meaning in sorted((*_given(text), *_copied(text)), key=lambda each: each[1]):
        if text.startswith(r"\provide", begin) and name in before:
            continue
        made.append((begin, name, before.get(meaning.body, meaning) if meaning.is_guessed else meaning))
        is_local = not text.startswith(_GLOBAL, begin)
        if is_local and name in before and (group := _end_of_group(text, end)) is not None:
            made.append((group, name, before[name]))
        else:
            before[name] = made[-1][2]
    times = Counter(name for _, name, _ in made)
    return sorted((each for each in made if times[each[1]] > 1), key=lambda each: each[0])


def _given(text: str) -> Iterator[tuple[str, int, int, Macro]]:
    """Yield name, the place where a definition begins, where it ends, and what it says."""
    for name, macro, begin, start in _begun(text):
        if (end := _closing(text, start)) is not None:
            body = text[start:end] if begin >= 0 else rf"\operatorname{{{text[start:end]}}}"
            yield name, abs(begin), end + 1, replace(macro, body=body)


def _copied(text: str) -> Iterator[tuple[str, int, int, Macro]]:
    r"""Yield likewise what ``\let`` gives: the meaning that another macro has there."""
    for each in _LET.finditer(text):
        yield each[1], *each.span(), Macro(0, None, each[2], is_guessed=True)


def _begun(text: str) -> Iterator[tuple[str, Macro, int, int]]:
    """Yield names and macros without a body, the place of the definition, negative for an operator, and of the body."""
    for match in _COMMAND.finditer(text):
        place, count, default = _parameters(text, match.end())
        if body := _OPENING.match(text, place):
            yield match[1] or match[2], Macro(count, default, ""), match.start(), body.end()
    for match in _DEFINITION.finditer(text):
        marks = (*map(str.strip, re.split(r"#\d", match[2])),)
        if all(len(each) < 2 for each in marks):
            macro = Macro(len(marks) - 1, None, "", marks=marks if any(marks) else ())
            yield match[1], macro, match.start(), match.end() + 1
    for match in _DOCUMENT_COMMAND.finditer(text):
        default = match[2][2:-1] if match[2] else None
        macro = Macro(match[3].count("m") + (default is not None), default, "")
        yield match[1], macro, match.start(), match.end()
    for match in _ENVIRONMENT.finditer(text):
        place, count, default = _parameters(text, match.end())
        for mark, many in (("begin", count), ("end", 0)):
            if (body := _OPENING.match(text, place)) and (end := _closing(text, body.end())):
                macro = Macro(many, default if many else None, "")
                yield rf"\{mark}{{{match[1]}}}", macro, match.start(), body.end()
                place = end + 1
    for match in _OPERATOR.finditer(text):
        if body := _OPENING.match(text, match.end()):
            yield match[1], Macro(0, None, ""), -match.start() or -1, body.end()


def _parameters(text: str, place: int) -> tuple[int, int, str | None]:
    """Return where the parameters end that a definition has behind its name, how many there are, and the default."""
    counted = _COUNT.match(text, place)
    if counted is None:
        return place, 0, None
    given = _DEFAULT.match(text, counted.end())
    return (given or counted).end(), int(counted[1]), given[1] if given else None


def filled_in(macro: Macro, text: str, place: int) -> tuple[str, int] | None:
    """Return what a macro stands for that is called before a place of a text, and where its arguments end."""
    if macro.marks:
        return None
    arguments = list[str]()
    for number in range(macro.count):
        if number == 0 and macro.default is not None:
            given = _DEFAULT.match(text, place)
            arguments.append(given[1] if given else macro.default)
            place = given.end() if given else place
            continue
        opening = _OPENING.match(text, place)
        end = _closing(text, opening.end()) if opening else None
        if opening is None or end is None:
            return None
        arguments.append(text[opening.end() : end])
        place = end + 1
    return _PARAMETER.sub(lambda found: _put_in(found, arguments), macro.body.replace("\n", " ")), place


def _closing(text: str, start: int) -> int | None:
    depth = 1
    for place in range(start, min(len(text), start + MAX_PIECES)):
        if text[place - 1] != "\\":
            depth += (text[place] == "{") - (text[place] == "}")
        if depth == 0:
            return place
    return None


def _end_of_group(text: str, start: int) -> int | None:
    r"""Return where the group ends in which a place stands: by a brace, ``\endgroup`` or the end of an environment."""
    depth = 1
    for mark in _GROUPS.finditer(text, start, start + MAX_PIECES):
        depth += 1 if mark["opens"] else -1
        if depth == 0:
            return mark.start()
    return None


def expanded(pieces: Sequence[Piece], macros: Mapping[str, Macro]) -> list[Piece]:
    """Return the pieces with every macro expanded; what a macro stands for has the place where it is used.

    It raises `UnreadableError` if there are more expansions, or pieces, than there may be: a macro that expands itself
    has no end.
    """
    out: list[Piece] = []
    waiting = [*_with_matrices(pieces)][::-1]
    expansions = 0
    while waiting:
        piece = waiting.pop()
        following = _next(waiting)
        macro = macros.get(f"{piece.text}[" if following == "[" else "") or macros.get(piece.text)
        if macro is None:
            out.append(piece)
            continue
        if macro.is_guessed and macro.count and macro.default is None and following != "{":
            out += [piece] if piece.text != r"\qty" else []
            continue
        expansions += 1
        body = _BOLD_BOX.sub(r"\\mathbf{\1}", _filled(macro, piece, waiting))
        body = _TENS.sub(r"\1\\cdot 10^{\2}", body) if piece.text in _OF_NUMBERS else body
        waiting += [Piece(each.text, piece.place) for each in reversed(pieces_of(body))]
        if expansions > MAX_EXPANSIONS or len(waiting) + len(out) > MAX_PIECES:
            raise UnreadableError(f"the macro {piece.text} expands without end", piece.place)
    return out


def _with_matrices(pieces: Sequence[Piece]) -> Iterator[Piece]:
    r"""Yield pieces in which ``\mqty(a & b)`` is a matrix."""
    closings: list[tuple[int, str]] = []
    depth = 0
    for place, piece in enumerate(pieces):
        text = piece.text
        if place and pieces[place - 1].text == r"\mqty" and text in _QUANTITIES:
            name = _QUANTITIES[text]
            closings.append((depth, name))
            yield Piece(rf"\begin{{{name}}}", piece.place)
        elif closings and text in ")]}" and depth == closings[-1][0] + 1:
            yield Piece(rf"\end{{{closings.pop()[1]}}}", piece.place)
        elif text != r"\mqty":
            yield piece
        depth += (text in "([{") - (text in ")]}")


_QUANTITIES = {"(": "pmatrix", "[": "bmatrix", "{": "matrix"}


def _filled(macro: Macro, call: Piece, waiting: list[Piece]) -> str:
    arguments = list[str]()
    if any(macro.marks[:1]):
        _until(macro.marks[0], call, waiting)
    for number in range(macro.count):
        while waiting and waiting[-1].text.isspace():
            waiting.pop()
        if any(macro.marks[number + 1 : number + 2]):
            arguments.append(_until(macro.marks[number + 1], call, waiting))
        elif macro.is_guessed and macro.body in _DERIVATIVES and number == macro.count - 1 and _next(waiting) != "{":
            arguments.insert(-1, "")
        elif number == 0 and macro.default is not None:
            arguments.append(_optional(waiting, macro.default))
        else:
            arguments.append(_argument(call, waiting))
    return _PARAMETER.sub(lambda found: _put_in(found, arguments), macro.body)


def _until(mark: str, call: Piece, waiting: list[Piece]) -> str:
    """Take what stands before a mark that ends an argument, and the mark."""
    taken, depth = "", 0
    while waiting:
        piece = waiting.pop()
        if piece.text == mark and depth == 0:
            return taken
        depth += (piece.text == "{") - (piece.text == "}")
        taken += piece.text
    raise UnreadableError(f"the macro {call.text} expects {mark} behind its argument", call.place)


def _next(waiting: Sequence[Piece]) -> str:
    return waiting[-1].text if waiting else ""


def _put_in(found: re.Match[str], arguments: Sequence[str]) -> str:
    """Return what stands for a parameter: no letter of it goes on with the command before it."""
    argument = arguments[int(found[1]) - 1] if int(found[1]) <= len(arguments) else ""
    return (
        f" {argument}" if argument[:1].isalpha() and _ENDS_COMMAND.search(found.string, 0, found.start()) else argument
    )


def _optional(waiting: list[Piece], default: str) -> str:
    if not waiting or waiting[-1].text != "[":
        return default
    taken = ""
    waiting.pop()
    while waiting and (piece := waiting.pop()).text != "]":
        taken += piece.text
    return taken


def _argument(call: Piece, waiting: list[Piece]) -> str:
    if not waiting:
        raise UnreadableError(f"the macro {call.text} expects an argument, got the end", call.place)
    first = waiting.pop()
    if first.text != "{":
        return f"{first.text} "
    taken, depth = "", 1
    while waiting:
        piece = waiting.pop()
        depth += (piece.text == "{") - (piece.text == "}")
        if depth == 0:
            return taken
        taken += piece.text
    raise UnreadableError("a brace is not closed", first.place)
