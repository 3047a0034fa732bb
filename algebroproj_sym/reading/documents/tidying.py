r"""Formulas in few notations: what only looks otherwise becomes what the lexer reads.

``\overset{(3)}{=}`` is ``=``, ``\underbrace{a}_{b}`` is ``a``, ``\mbox{$a$}`` is ``a``, an array between ``\left\{``
and ``\right.`` is a distinction of cases, and ``α`` is ``\alpha``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from algebroproj_sym.reading.lexing.commands import MAX_PIECES, RELATIONS
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, outside_environments, pieces_of, split_pieces

_BOXES = frozenset((r"\mbox", r"\hbox", r"\textnormal", r"\textup", r"\textsf", r"\text", r"\textrm"))
_OVER = frozenset((r"\overset", r"\stackrel", r"\underset"))
_BRACES = frozenset((r"\underbrace", r"\overbrace", r"\underbracket", r"\overbracket"))
_FRAMES = frozenset((*_BRACES, r"\smash", r"\mathclap", r"\textcolor", r"\colorbox"))
_INFIX = {r"\over": r"\frac", r"\choose": r"\binom"}
_ROOM = frozenset((r"\hskip", r"\kern", r"\mskip", r"\mkern", r"\hspace", r"\hspace*"))
_ARRAY = re.compile(r"\\begin\{(?:array|matrix|aligned|split|gathered|cases)\}")
_LENGTH = re.compile(r"-?[\d.]+\s*(?:pt|mm|cm|in|ex|em|mu)")
_CONNECTIVES = re.compile(r"(?:if|for|and|or|where|when|with|otherwise|else|on|at|as|then|subject to|s\.t\.)\W*")
_LETTERS = (
    "α#alpha β#beta γ#gamma δ#delta ε#varepsilon ζ#zeta η#eta θ#theta ι#iota κ#kappa λ#lambda μ#mu ν#nu ξ#xi π#pi "
    "ρ#rho σ#sigma τ#tau υ#upsilon φ#varphi ϕ#phi χ#chi ψ#psi ω#omega Γ#Gamma Δ#Delta Θ#Theta Λ#Lambda Ξ#Xi Π#Pi "
    "Σ#Sigma Φ#Phi Ψ#Psi Ω#Omega ϵ#epsilon ×#times ·#cdot ⋅#cdot ≤#le ≥#ge ≠#ne ±#pm ∓#mp ∂#partial ∇#nabla ∞#infty "
    "≈#approx ≡#equiv ∈#in →#to ⇒#Rightarrow ⇔#Leftrightarrow ∥#| ∑#sum ∫#int ∏#prod ℓ#ell ∝#propto"
)
_SIGNS = {sign: rf"\{name}" for sign, _, name in (pair.partition("#") for pair in _LETTERS.split())}
_SIGNS |= {"°": r"^\circ", "²": "^2", "³": "^3", "′": "'", "″": "''"}


def tidied(pieces: Sequence[Piece]) -> list[Piece]:
    r"""Return the pieces of a formula in fewer notations, each where it stood.

    Raises
    ------
    UnreadableError
        If a brace is not closed, or there are more pieces than there may be.

    Examples
    --------
    >>> text = r"f \overset{(1)}{=} \left\{\begin{array}{ll} \underbrace{α}_{b} & \mbox{if $a>0$} \end{array} \right."
    >>> "".join(piece.text for piece in tidied(pieces_of(text)))
    'f = \\begin{cases} {\\alpha} & \\text{if $a>0$} \\end{cases}'
    """
    out: list[Piece] = []
    waiting = _Waiting(
        each for piece in pieces for each in (_at(piece, _SIGNS[piece.text]) if piece.text in _SIGNS else (piece,))
    )
    while waiting:
        piece = waiting.pop()
        text = piece.text
        if text in (r"\left", r"\right"):
            if (cases := waiting.cases(piece) if text == r"\left" else None) is not None:
                waiting.put(cases)
            elif waiting.next == ".":
                waiting.group()
            else:
                out.append(piece)
        elif text in _BOXES and waiting.next == "{":
            inside = waiting.group()
            formulas = _formulas_in(inside)
            waiting.put(_braced(piece, formulas)) if formulas else out.extend(
                (_as(piece, r"\text"), *_braced(piece, inside))
            )
        elif text == r"\mathrm" and waiting.next == "{":
            inside = waiting.group()
            words = re.sub(r"\\[:, ;]", " ", "".join(each.text for each in inside)).strip()
            out += [_as(piece, r"\text" if _CONNECTIVES.fullmatch(words) else text), *_braced(piece, inside)]
        elif text in _OVER:
            over, base = waiting.group(), waiting.group()
            relation = "".join(each.text for each in base).strip()
            above = "".join(each.text for each in over).strip()
            if relation == "=" and above in ("!", "?"):
                relation = r"\equiv" if above == "!" else r"\questeq"
            defines = relation == "=" and re.search(r"def|triangle", above)
            plain = [piece, *_braced(piece, over), *_braced(piece, base)]
            out += _at(piece, ":=" if defines else relation) if relation in RELATIONS else plain
        elif text in _FRAMES:
            if text in (r"\textcolor", r"\colorbox"):
                waiting.group()
            inside = waiting.group()
            if text in _BRACES and waiting.next in ("_", "^"):
                waiting.group()
                waiting.group()
            waiting.put(_braced(piece, inside))
        elif text in _INFIX and (start := _group_start(out)) is not None:
            out[start:] = [_as(piece, _INFIX[text]), *_braced(piece, out[start:]), _as(piece, "{")]
            waiting.close_group(piece)
        elif text == r"\color":
            waiting.group()
        elif text in _ROOM:
            waiting.length()
            out.append(_as(piece, r"\quad"))
        elif text == "." and [each.text for each in waiting[-1:-3:-1]] == [".", "."]:
            del waiting[-2:]
            out.append(_as(piece, r"\ldots"))
        elif text != r"\_":
            out.append(piece)
        if len(out) + len(waiting) > MAX_PIECES:
            raise UnreadableError(f"expected a formula of at most {MAX_PIECES} pieces, got more", piece.place)
    return _system(out)


def _at(piece: Piece, text: str) -> list[Piece]:
    return [Piece(each.text, piece.place) for each in pieces_of(text)]


def _as(piece: Piece, text: str) -> Piece:
    return Piece(text, piece.place)


def _braced(piece: Piece, inside: Sequence[Piece]) -> list[Piece]:
    return [_as(piece, "{"), *inside, _as(piece, "}")]


class _Waiting(list[Piece]):
    """The pieces that are yet to come, the next one last."""

    def __init__(self, pieces: Iterable[Piece]) -> None:
        super().__init__(pieces)
        self.reverse()

    def put(self, pieces: Sequence[Piece]) -> None:
        """Put pieces before those that are to come."""
        self.extend(reversed(pieces))

    @property
    def next(self) -> str:
        """The next piece that is no space, after which the spaces before it are gone; empty at the end."""
        while self and self[-1].text.isspace():
            self.pop()
        return self[-1].text if self else ""

    def group(self) -> list[Piece]:
        """Take an argument: what stands in braces, without them, or the next piece."""
        if self.next != "{":
            return [self.pop()] if self else []
        return self.until("{", "}")[1:-1]

    def until(self, opening: str, closing: str) -> list[Piece]:
        """Take all up to the partner of the piece that is next."""
        taken, depth = list[Piece](), 0
        while self:
            taken.append(self.pop())
            depth += (taken[-1].text == opening) - (taken[-1].text == closing)
            if depth == 0:
                return taken
        raise UnreadableError(f"{opening} is not closed", taken[0].place)

    def close_group(self, piece: Piece) -> None:
        """Put a closing brace at the end of the group in which the next piece stands."""
        depth, place = 0, len(self)
        while place and depth >= 0:
            place -= 1
            depth += (self[place].text == "{") - (self[place].text == "}")
        self.insert(place + 1 if depth < 0 else 0, _as(piece, "}"))

    def length(self) -> None:
        r"""Go over a length, as behind ``\hskip`` and ``\hspace``."""
        if self.next == "{":
            self.group()
        elif match := _LENGTH.match("".join(each.text for each in self[-1:-12:-1])):
            del self[-len(match.group()) :]

    def cases(self, left: Piece) -> list[Piece] | None:
        r"""Take an array between ``\{`` and ``\right.`` as a distinction of cases; if there is none, take nothing."""
        kept = list(self)
        if self.next in (r"\{", r"\lbrace"):
            self.pop()
            if _ARRAY.fullmatch(opening := self.next):
                inside = self.until(opening, opening.replace("begin", "end"))[1:-1]
                if self.next == r"\right":
                    self.pop()
                    if self.next == ".":
                        self.pop()
                        body = _Waiting(inside)
                        if "array" in opening:
                            body.group()
                        begin, end = _as(left, r"\begin{cases}"), _as(left, r"\end{cases}")
                        return [begin, *reversed(body), end]
        self[:] = kept
        return None


def _group_start(pieces: Sequence[Piece]) -> int | None:
    """Return where the group begins in which the next piece stands; None if it stands in none."""
    depth = 0
    for place in range(len(pieces) - 1, -1, -1):
        depth += (pieces[place].text == "}") - (pieces[place].text == "{")
        if depth < 0:
            return place + 1
    return None


def _formulas_in(words: Sequence[Piece]) -> list[Piece]:
    """Return what stands between dollars, if nothing stands beside it."""
    parts = split_pieces(words, ("$",))
    alone = len(parts) > 1 and all(piece.text.isspace() for part in parts[::2] for piece in part)
    return [piece for part in parts[1::2] for piece in part] if alone else []


def _system(pieces: list[Piece]) -> list[Piece]:
    """Return a lone array, or a lone distinction of cases, whose rows are equations as these rows."""
    place = next((i for i, piece in enumerate(pieces) if _SYSTEM.fullmatch(piece.text)), len(pieces))
    rest = _Waiting(pieces[place:])
    if not (match := _SYSTEM.fullmatch(rest.next)) or not _says_nothing(pieces[:place]):
        return pieces
    opening = rest.next
    inside = rest.until(opening, opening.replace("begin", "end"))[1:-1]
    if not _says_nothing(rest[::-1]):
        return pieces
    if match[1] == "array":
        (body := _Waiting(inside)).group()
        inside = body[::-1]
    rows = split_pieces(inside, (r"\\",), brackets=False)
    columns = rows if match[1] == "array" else [split_pieces(row, ("&",))[0] for row in rows]
    equations = [any(piece.text in RELATIONS for piece in outside_environments(each)) for each in columns if each]
    alone = equations and (any if match[1] == "array" else all)(equations)
    return [*pieces[:place], *inside, *rest[::-1]] if alone else pieces


def _says_nothing(pieces: Sequence[Piece]) -> bool:
    """Whether there are but labels and stops."""
    text = re.sub(r"\\(?:label|tag\*?)\s*\{[^{}]*\}", "", "".join(piece.text for piece in pieces))
    return not text.strip(" \n\t.,;~")


_SYSTEM = re.compile(r"\\begin\{(cases|array)\}")
