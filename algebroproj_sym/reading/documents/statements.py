"""Displays as statements: rows and columns that align become equations, each with its number and its conditions."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from algebroproj_sym.reading.documents.displays import Display, Document, label_of, tag_of, without_number
from algebroproj_sym.reading.lexing.commands import CLOSING, MAPS, OPENING, RELATIONS, SIGNS
from algebroproj_sym.reading.lexing.pieces import (
    Piece,
    begins_with_relation,
    ends_with_relation,
    first_text,
    has_relation,
    latex_of,
    split_pieces,
)

_INNER = re.compile(
    r"\\(begin|end)\{(?:split|aligned|gathered|alignedat|multlined|subarray|(?:align|eqnarray|equation|gather|multline)\*?)\}"
)
_TAGGED = re.compile(r"\\(?:nonumber|notag|tag)(?![a-z])")
_WORDS = (r"\text", r"\mbox", r"\textrm", r"\textnormal", r"\intertext", r"\shortintertext")
_WIDE = (r"\quad", r"\qquad")
_OPENS = re.compile(r"\b(?:for|if|when|where|with|at|and|or|as|all|every|any)\s*$")
_BEGINS = re.compile(
    r"\b(?:if|when|for|cases?|unless|provided|suppos\w+|assum\w+|otherwise|else|not|never|neither)\b|\\forall",
    re.IGNORECASE,
)
"""Words before an equation that are a condition of it."""
_IF = re.compile(r"\b(?:if|when|for|unless)\s*$", re.IGNORECASE)
_LEADS_ON = re.compile(
    r"\s*and|\W*(?:and )?(?:so that|so|hence|thus|therefore|which gives|giving|yielding)\W*", re.IGNORECASE
)
"""Words between two equations that lead from one to the next, and are no condition of the first."""
_ELLIPSES = (r"\ldots", r"\dots", r"\cdots", "…")
_ARROWS = (
    r"\Rightarrow",
    r"\Longrightarrow",
    r"\implies",
    r"\therefore",
    r"\Leftrightarrow",
    r"\Longleftrightarrow",
    r"\iff",
)
_STEPS = (*_ARROWS, r"\rightarrow", r"\longrightarrow", r"\to", "→")
"""What leads from one equation to the next; thin arrows do so only between equations."""
_SPACES = (r"\;", r"\:", r"\,", r"\ ", "~", *_WIDE)
_IDLE = (r"\nonumber", r"\notag", r"\pause", r"\,", r"\;", r"\:", r"\!", "~", "\\ ", ".", ",", ";", "{", "}")


@dataclass(frozen=True)
class Statement:
    """One equation, or chain of equations, of a display."""

    display: Display
    """Where it stands."""
    number: str
    """Its number, or its label; empty for none."""
    label: str
    """Its label."""
    pieces: tuple[Piece, ...]
    """Its LaTeX; empty if it cannot be read."""
    latex: str
    """As it stands in the file, or as macros leave it."""
    condition: str = ""
    """The words that stand beside it, such as "for x > 0"."""
    reason: str = ""
    """Why it cannot be read."""
    implied: bool = False
    """Whether an arrow leads to it from the statement before it."""


def statements(document: Document) -> list[Statement]:
    """Return the statements of the displays of a document, in order, with the numbers that LaTeX gives them."""
    found: list[Statement] = []
    counter, last_group, letter = 0, 0, 0
    for display in document.formulas:
        if display.environment == "inline":
            continue
        known = len(found)
        for rows, parts in _equations(display):
            arrow = False
            number = tag_of("".join(rows), "" if display.numbered else display.after)
            for row in rows if display.numbered else ():
                if _TAGGED.search(row) is None:
                    if display.within != last_group or not display.within:
                        counter, letter = counter + 1, 0
                    last_group = display.within
                    letter += 1
                    own = f"{counter}{chr(96 + letter)}" if display.within and letter <= 26 else str(counter)
                    number = number or own
            label = label_of("".join(rows)) or label_of(display.latex)
            for pieces, condition in parts:
                if display.pieces and all(piece.text in _STEPS for piece in _without_idle(pieces)):
                    arrow = True
                    continue
                for place, part in enumerate(_implied(pieces)):
                    text = latex_of(part)
                    implied = place > 0 or arrow or (bool(pieces) and pieces[0].text in _STEPS)
                    arrow = False
                    if found and not place and _goes_on_behind(part, found[-1], display):
                        part = [*_last_side(found[-1].pieces), *part]
                    found.append(
                        Statement(display, number, label, tuple(part), text, condition, display.reason, implied)
                    )
        if len(found) == known and has_relation(display.pieces):
            lost = "no equation is found in it"
            found.append(Statement(display, "", label_of(display.latex), (), display.latex, reason=lost))
    return found


def _goes_on_behind(pieces: Sequence[Piece], before: Statement, display: Display) -> bool:
    """Whether a display begins with a relation, so that it goes on with the one before it, perhaps behind words."""
    first = _without_idle(pieces)[:1]
    goes_on = bool(before.pieces and not before.condition) and begins_with_relation(first)
    goes_on = goes_on and all(map(_lead_on, _FIRST_WORDS.findall(display.latex)))
    return goes_on and before.display.part == display.part and _OTHERWISE.search(display.before) is None


_OTHERWISE = re.compile(r"\b(?:not?|never|nor|rather|instead|unlike|different\w*|than|wrong\w*|but)\b", re.IGNORECASE)
"""Words between displays by which one is not equal to the other."""


def _last_side(pieces: Sequence[Piece]) -> list[Piece]:
    return split_pieces(pieces, tuple(RELATIONS))[-1]


def inline_statements(document: Document) -> list[Statement]:
    """Return the inline formulas as statements."""
    return [
        Statement(each, "", "", each.pieces, latex_of(each.pieces), "", each.reason)
        for each in document.formulas
        if each.environment == "inline"
    ]


Part = tuple[list[Piece], str]


def _equations(display: Display) -> Iterator[tuple[list[str], list[Part]]]:
    """Yield the LaTeX of the rows, and the statements, of each equation that has numbers of its own."""
    if not display.pieces:
        yield [display.latex], [([], "")]
        return
    pieces = _without_brackets(_flat(display.pieces))
    rows = [[*without_number(row)] for row in split_pieces(pieces, (r"\\",), brackets=False)]
    latex = [*_rows_of(display)]
    if display.environment in ("multline", "dmath"):
        rows = [[piece for row in rows for piece in row]]
    found: list[tuple[list[str], list[Part]]] = []
    for place, row in enumerate(rows):
        text = latex[place] if len(latex) == len(rows) else ""
        bare = _without_idle([piece for piece in row if piece.text != "&"])
        if bare and bare[0].text in _WORDS and found:
            row = _behind_words(row, bare)
            bare = _without_idle([piece for piece in row if piece.text != "&"])
        if not bare:
            continue
        if found and found[-1][1] and (_goes_on(found[-1][1][-1][0], row) or begins_with_relation(bare)):
            texts, (*before, (pieces, condition)) = found[-1]
            (more, words), *rest = [*_parts(_columns(row), continuing=True)] or [([], "")]
            found[-1] = ([*texts, text], [*before, ([*pieces, *more], condition or words), *rest])
        else:
            found.append(([text], [*_parts(_columns(row))]))
    if display.environment in ("equation", "display", "displaymath", "multline", "dmath", "math") and found:
        yield [display.latex], [part for _, parts in found for part in parts]
    else:
        yield from found


def _without_brackets(pieces: list[Piece]) -> list[Piece]:
    """Return an equation without the brackets, the braces, or the frame that a command draws, round the whole of it."""
    kept = [place for place, piece in enumerate(pieces) if not piece.text.isspace()]
    kept = kept[:-1] if kept and pieces[kept[-1]].text in (".", ",") else kept
    sizes = (r"\left", r"\right", r"\displaystyle")
    bare = [place for place in kept if pieces[place].text not in sizes]
    if [pieces[place].text == "{" for place in bare[:2]] == [False, True] and _FRAME.fullmatch(pieces[bare[0]].text):
        bare = bare[1:]
    depth = 0
    for place in bare:
        text = pieces[place].text
        depth += (text in OPENING or text == "{") - (text in CLOSING or text == "}")
        if depth <= 0 and place != bare[-1]:
            return pieces
    inside = [piece for piece in pieces[bare[0] + 1 : bare[-1]] if piece.text != r"\right"] if bare else []
    return inside if has_relation(inside) else pieces


_FRAME = re.compile(r"\\(?![hm]box)[a-zA-Z]*(?:box(?:ed)?|high(?:light|math)?|frame[a-z]*|hl)")
"""A command that draws a box round a whole equation, whoever defines it."""


def _implied(pieces: Sequence[Piece]) -> list[list[Piece]]:
    """Return the equations between arrows; all in one if an arrow leads from or to what is no equation."""
    for arrows in (_STEPS, _ARROWS):
        parts = [part for part in split_pieces(pieces, arrows) if _without_idle(part)]
        if parts and all(map(has_relation, parts)) and (arrows is _ARROWS or _are_equations(parts)):
            return parts
    return [list(pieces)]


def _are_equations(parts: Sequence[Sequence[Piece]]) -> bool:
    r"""Whether thin arrows lead from equation to equation, and not from value to value, as in ``n = 2 \to n = 1``.

    In ``b = 0 \to c = a`` the first one is a case.
    """
    texts = ["".join(piece.text for piece in part if not piece.text.isspace()) for part in parts]
    given = [text.partition("=")[0] for text in texts if re.fullmatch(r"[^=]*=\{?[\d.,/]+\}?", text)]
    case = len(texts) > 1 and re.fullmatch(r"\\?[a-zA-Z]+(?:_[^=]+)?=[\d.-]+", texts[0]) is not None
    return not case and all("=" in text and ":" not in text for text in texts) and len({*given}) == len(given)


def _rows_of(display: Display) -> Iterator[str]:
    """Yield the rows with their numbers and labels, which the statements leave out."""
    outer = [piece for piece in display.pieces if not _INNER.match(piece.text)]
    for row in split_pieces(outer, (r"\\",), brackets=False):
        yield "".join(piece.text for piece in row)


def _flat(pieces: Sequence[Piece]) -> list[Piece]:
    """Return the pieces without the environments that only align, and without those of the numbers."""
    kept: list[Piece] = []
    skipping = 0
    for place, piece in enumerate(pieces):
        if skipping:
            skipping += (piece.text == "{") - (piece.text == "}")
            if skipping == 1:
                skipping = 0
        elif _INNER.match(piece.text):
            skipping = int("alignedat" in piece.text and piece.text.startswith(r"\begin"))
        elif piece.text in (r"\tag", r"\tag*", r"\label"):
            skipping = int(place + 1 < len(pieces))
        else:
            kept.append(piece)
    return kept


def _behind_words(row: list[Piece], bare: Sequence[Piece]) -> list[Piece]:
    r"""Return a row without its first words if it goes on with a relation, as ``\text{or} &= a`` does."""
    end = _group_end(bare, 1)
    rest = _without_idle(bare[end:])
    begins = begins_with_relation(rest) and _lead_on(_text_of(bare[1:end]))
    return row[row.index(rest[0]) :] if begins else row


def _goes_on(before: Sequence[Piece], row: Sequence[Piece]) -> bool:
    """Whether a row goes on with the equation of the row before it."""
    is_open = _opened(before) > 0 > _opened(row) or _ends_with_sign(before)
    return is_open or ends_with_relation(_without_idle(before)) or not has_relation(row) or _begins_with_sign(row)


def _ends_with_sign(pieces: Sequence[Piece]) -> bool:
    r"""Whether a row ends with a sign that is no script, as that of ``x^-`` is."""
    texts = [each.text for each in _without_idle(pieces) if not each.text.isspace()]
    return texts[-1:] != [] and texts[-1] in SIGNS and texts[-2:-1] not in (["^"], ["_"])


def _opened(pieces: Sequence[Piece]) -> int:
    """Return how many brackets open and do not close, or below zero close and did not open."""
    return sum((piece.text in OPENING) - (piece.text in CLOSING) for piece in pieces)


def _begins_with_sign(row: Sequence[Piece]) -> bool:
    """Whether a row begins, behind a mark of alignment, with a sign and so goes on with a sum."""
    return len(row) > 1 and row[0].text == "&" and _without_idle(row[1:])[:1] != [] and row[1].text in ("+", "-")


def _columns(row: Sequence[Piece]) -> list[list[Piece]]:
    """Return the equations that stand side by side, between marks of alignment; empty cells make room."""
    every = split_pieces(row, ("&",), brackets=False)
    kept = [place for place, cell in enumerate(every) if not place or _without_idle(cell)]
    cells = [every[place] for place in kept]
    found: list[list[Piece]] = [[]]
    for place, cell in enumerate(cells):
        rest = [piece for each in cells[place : place + 2] for piece in each]
        beside = first_text(reversed(_without_idle(found[-1]))), first_text(cell)
        apart = place > 0 and kept[place] > kept[place - 1] + 1 and {*SIGNS}.isdisjoint(beside)
        begins = (apart or (place >= 2 and place % 2 == 0)) and has_relation(found[-1]) and has_relation(rest)
        begins = begins and not ends_with_relation(_without_idle(found[-1]))
        if begins and not begins_with_relation(_without_idle(rest)):
            found.append([])
        found[-1] += cell
    return found


def _parts(columns: Sequence[Sequence[Piece]], continuing: bool = False) -> Iterator[Part]:
    """Yield the statements of a row, each with the words beside it."""
    statements: list[tuple[list[Piece], list[str]]] = []
    begun: list[str] = []
    for column in columns:
        ranges, known = False, len(statements)
        label, parts = _labelled([*_separated(column)])
        for part, words in parts:
            part = _without_idle(part)
            if part and begun and not statements and _IF.search(begun[-1]):
                begun.append(_text_of(part))
                part = []
            if part and has_relation(part) and statements and _LEADS_ON.fullmatch(" ".join(statements[-1][1])):
                statements[-1][1].clear()
            bracketed = part and part[0].text == "(" and part[-1].text == ")" and has_relation(part)
            if part and statements and (bracketed or _OPENS.search(statements[-1][1][-1] if statements[-1][1] else "")):
                statements[-1][1].append("".join(piece.text for piece in part))
                part = []
            if _goes_through(part, statements):
                if len(statements) > 1:
                    last = "".join(piece.text for piece in statements.pop()[0])
                    statements[-1][1].extend([last, "".join(piece.text for piece in part)])
                ranges = True
                continue
            if (part and (has_relation(part) or (continuing and not statements)) and not ranges) or (
                part and not statements
            ):
                statements.append((list(part), begun))
                begun = []
            elif part:
                statements[-1][1].append("".join(piece.text for piece in part).strip())
            if words and statements:
                statements[-1][1].append(words)
            elif _BEGINS.search(words) or words.rstrip().endswith(":"):
                begun.append(words)
        for _, conditions in statements[known:] if label else ():
            conditions.insert(0, label)
    for pieces, conditions in statements:
        yield pieces, " ".join(conditions).strip()


def _labelled(parts: list[Part]) -> tuple[str, list[Part]]:
    r"""Return a name or a case that stands before an equation, as in ``H_0: \; a = b``, and what is behind it.

    An equation with a name may be a hypothesis: its name is a condition of it.
    """
    (first, words), *rest = parts
    colon = next((i for i, piece in enumerate(first) if piece.text == ":"), len(first))
    name, behind = first[:colon], first[colon + 1 :]
    is_spaced = bool(behind) and behind[0].text.isspace() and behind[1:2] != [] and behind[1].text in _SPACES
    is_spaced = is_spaced or (bool(behind) and behind[0].text in _SPACES)
    is_last = not _without_idle(behind) and any(has_relation(part) for part, _ in rest)
    if not _without_idle(name) or name[-1].text in (*_SPACES, "=") or colon == len(first):
        return "", parts
    if is_last:
        return _text_of(first), rest
    if is_spaced and has_relation(behind) and not any(piece.text in MAPS for piece in behind):
        return f"{_text_of(name)}:", [(behind, words), *rest]
    return "", parts


def _text_of(pieces: Sequence[Piece]) -> str:
    return "".join(piece.text for piece in pieces).strip()


def _goes_through(part: Sequence[Piece], statements: Sequence[tuple[list[Piece], list[str]]]) -> bool:
    """Whether an ellipsis or a number goes on with a range behind an equation, as in ``x_i = 0, i = 1, 2``."""
    if part and all(piece.text in _ELLIPSES or piece.text.isspace() for piece in part):
        return True
    number, last = ("".join(each.text for each in pieces) for pieces in (part, statements[-1][0] if statements else ()))
    is_number = re.fullmatch(r"\s*\d+\s*", number) is not None
    return is_number and len(statements) > 1 and re.fullmatch(r"\s*[a-zA-Z]\s*=\s*\d+\s*", last) is not None


def _separated(column: Sequence[Piece]) -> Iterator[tuple[list[Piece], str]]:
    """Yield what stands between commas and wide spaces, with the words that follow it."""
    part: list[Piece] = []
    depth, place = 0, 0
    while place < len(column):
        text = column[place].text
        depth += (text == "{" or text in OPENING or text.startswith(r"\begin{")) - (
            text == "}" or text in CLOSING or text.startswith(r"\end{")
        )
        if depth <= 0 and text == r"\forall":
            end = len(column) if _without_idle(part) else _end_of_quantifier(column, place)
            yield part, "".join(piece.text for piece in column[place:end])
            part, place = [], end
            continue
        if depth <= 0 and text in _WORDS and not _is_script(part):
            end = _group_end(column, place + 1)
            words = "".join(piece.text for piece in column[place + 1 : end]).strip(" {}~")
            if _is_unit(part, words, column[end:]):
                part += [Piece(r"\mathrm", column[place].place), *column[place + 1 : end]]
                place = end
                continue
            yield part, "".join(piece.text for piece in column[place + 1 : end]).strip(" {}")
            part, place = [], end
            continue
        if depth <= 0 and (text in (",", ";") or text in _WIDE) and not _is_between_digits(column, place):
            yield part, ""
            part = []
        else:
            part.append(column[place])
        place += 1
    yield part, ""


def _end_of_quantifier(column: Sequence[Piece], start: int) -> int:
    r"""Return the place behind the sign that ends ``\forall x \in S`` before an equation; its own end for none."""
    set_at = max((i for i, each in enumerate(column) if each.text == r"\in"), default=start)
    relation_at = max((i for i, each in enumerate(column) if each.text in RELATIONS), default=start)
    depth, before = 0, ""
    for place in range(start + 1, relation_at):
        text = column[place].text
        depth += (text in OPENING) - (text in CLOSING)
        ends = text == ":" or (text in (",", *_SPACES) and place > set_at)
        if ends and not depth and before not in ("", r"\in"):
            return place + 1
        if not text.isspace() and text not in (*_IDLE, *_WIDE):
            before = text
    return len(column)


def _is_between_digits(column: Sequence[Piece], place: int) -> bool:
    """Whether a comma stands between digits as in 1,000 and 2,5: it may be a point, and ends nothing."""
    return re.fullmatch(r"\d,\d", "".join(piece.text for piece in column[max(0, place - 1) : place + 2])) is not None


def _is_script(before: Sequence[Piece]) -> bool:
    r"""Whether words are a script, as in ``x^\text{min}``."""
    last = first_text(reversed(before))
    return last in ("^", "_")


def _names(words: str) -> bool:
    r"""Whether words before a relation name what is equal, as in ``\text{error} = a - b``, and do not lead to it."""
    found = re.fullmatch(r"[a-zA-Z][\w.]*(?:[ ~,:/()\[\]'-]+[\w.]*){0,8}", words.strip(" {}~"))
    return found is not None and not _lead_on(words)


def _lead_on(words: str) -> bool:
    r"""Whether words before a relation lead to it, as ``\text{or} = a`` and ``\text{(by symmetry)} = a`` do."""
    said = words.strip(" {}~&")
    return _LEADS.search(said) is not None or said.startswith("(") or re.search(r"\w", said) is None


_FIRST_WORDS = re.compile(r"(?:^|\\\\)[\s&]*\\(?:text\w*|mbox|hbox|mathrm|mathsf|mathtt)\s*\{([^{}]*)\}[\s&]*(?=[=<>])")
_LEADS = re.compile(
    r"\b(?:and|or|if|for|when|where|with|so|thus|hence|then|but|also|since|because|by|from|using|as|therefore|"
    r"that|i\.?e|is|are|gives?|yields?|equals?|we|have|get|be|let|again|finally|now|to|of course|otherwise|else)\b",
    re.IGNORECASE,
)


def _is_unit(before: Sequence[Piece], words: str, after: Sequence[Piece]) -> bool:
    r"""Whether words stand in a formula, as in ``3 \text{ m} + 4 \text{ m}``."""
    last = first_text(reversed(before))
    if last in ("+", "-", "/", r"\cdot", r"\times") or last in RELATIONS:
        return words not in _BETWEEN
    if re.search(r"\w", words) is None and set(words) & {*"-+*/–—−"}:
        return True
    following = next((piece.text for piece in after if not piece.text.isspace() and piece.text not in _IDLE[:-2]), "")
    if not _without_idle(before) and _CHANGES.fullmatch(words) and following not in _WIDE:
        return True
    if following in RELATIONS and not _without_idle(before) and _names(words):
        return True
    if following == "_" and re.fullmatch(r"[a-zA-Z]+(?:-[a-zA-Z]+)*", words):
        return True
    goes_on = following in ("+", "-", "/", r"\cdot", r"\times") or following in RELATIONS
    return goes_on and any(not piece.text.isspace() for piece in before) and words not in _BETWEEN


_CHANGES = re.compile(
    r"(?:the )?(?:new|old|total|half|twice|double|minus|negative|mean|average|max\w*|min|minimum|net|inverse|change|"
    r"rate|sum|square|root|left|right|true|false|not)(?: (?:of|in))?(?: the)?",
    re.IGNORECASE,
)
"""Words before a letter that make another one of it."""
_BETWEEN = frozenset(["and", "or", "if", "for", "when", "where", "with", "so", "thus", "hence", "then", "but"])


def _group_end(pieces: Sequence[Piece], start: int) -> int:
    depth = 0
    for place in range(start, len(pieces)):
        depth += (pieces[place].text == "{") - (pieces[place].text == "}")
        if depth == 0 and pieces[place].text == "}":
            return place + 1
    return len(pieces)


def _without_idle(pieces: Sequence[Piece]) -> list[Piece]:
    """Return the pieces without what says nothing at both ends."""
    begin, end = 0, len(pieces)
    idle = _IDLE[:-2]
    while begin < end and (pieces[begin].text.isspace() or pieces[begin].text in (*idle, *_WIDE)):
        begin += 1
    while end > begin and (pieces[end - 1].text.isspace() or pieces[end - 1].text in (*idle, *_WIDE)):
        end -= 1
    return list(pieces[begin:end])
