r"""Formulas in few notations: what only looks otherwise becomes what the lexer reads.

``\overset{(3)}{=}`` is ``=``, ``\underbrace{a}_{b}`` is ``a``, ``\mbox{$a$}`` is ``a``, an array between ``\left\{``
and ``\right.`` is a distinction of cases, and ``α`` is ``\alpha``.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence

from algebroproj_sym.reading.documents.grouping import grouped
from algebroproj_sym.reading.lexing.commands import (
    BIG,
    BOLD,
    CLOSING,
    FUNCTIONS,
    LETTERS,
    MAX_PIECES,
    OPENING,
    OPERATORS,
    RELATIONS,
    SIGNS,
    STYLES,
)
from algebroproj_sym.reading.lexing.pieces import (
    Piece,
    UnreadableError,
    begins_with_relation,
    ends_with_relation,
    has_relation,
    pieces_of,
    split_pieces,
)

_BOXES = frozenset((r"\mbox", r"\hbox", r"\textnormal", r"\textup", r"\textsf", r"\text", r"\textrm"))
_OVER = frozenset((r"\overset", r"\stackrel", r"\underset"))
_BRACES = frozenset((r"\underbrace", r"\overbrace", r"\underbracket", r"\overbracket"))
_FRAMES = frozenset((*_BRACES, r"\smash", r"\mathclap", r"\textcolor", r"\colorbox", r"\fbox", r"\raisebox"))
_INFIX = {r"\over": r"\frac", r"\choose": r"\binom"}
_OTHERWISE = {r"\nicefrac": r"\frac", r"\sfrac": r"\frac", r"\xfrac": r"\frac", r"\space": "\\ ", r"\nobreakspace": "~"}
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
_EXTREMUM = re.compile(
    r"\\(?:operatorname\*?|mathrm|text|mathop)\{\\?arg(?:\\[,;! ])?\s*\\?(?:min|max)\}|\\arg\s*\\(?:min|max)"
)
"""The place of a least or a greatest value, as it is written."""
_UNSEEN = frozenset((r"\phantom", r"\hphantom", r"\vphantom", r"\noalign"))
_SIZES = frozenset(
    rf"\{name}"
    for name in ("tiny", "scriptsize", "footnotesize", "small", "normalsize", "large", "Large", "IEEEnonumber")
)
"""Commands that change the looks of all behind them."""
_ACCENTS_ABOVE = {
    r"\circ": r"\mathring",
    r"\frown": r"\overline",
    r"\leftrightarrow": r"\overline",
    r"\rightharpoonup": r"\vec",
}
"""What is an accent where it is written above a letter."""
_BAR = {
    name: (rf"\l{kind}", rf"\r{kind}")
    for kind, names in (("vert", r"| \vert \lvert \rvert"), ("Vert", r"\| \Vert \lVert \rVert"))
    for name in names.split()
}
_ROOM = frozenset((r"\hskip", r"\kern", r"\mskip", r"\mkern", r"\hspace", r"\hspace*"))
_ARRAY = re.compile(r"\\begin\{(?:array|matrix|aligned|split|gathered|cases)\}")
_LENGTH = re.compile(r"-?[\d.]+\s*(?:pt|mm|cm|in|ex|em|mu)")
_SKIP = re.compile(r"\*?\[\s*-?[\d.]*\s*(?:pt|mm|cm|in|ex|em|mu|\\[a-z]+)\s*\]")
_CONNECTIVES = re.compile(r"(?:if|for|and|or|where|when|with|otherwise|else|on|at|as|then|subject to|s\.t\.)\W*")
_WORD = re.compile(r"[A-Za-z]+")
_ACTS_BEFORE = re.compile(
    r"\W*(?:(?:the|an?|its|their|one|minus|plus|not|square|cube) )*"
    r"(?:\w+ of(?: (?:the|an?|all))?|twice|thrice|double|half|triple|not|negative|minus|plus)\s*",
    re.IGNORECASE,
)
"""Words that act on a letter behind them, where a value begins."""
_ACTS_BEHIND = re.compile(
    r"\s*(?:(?i:minus|plus|times|mod(?:ulo)?|of|squared|cubed|percent|(?:divided|multiplied) by|xor)|AND|OR|NAND|NOR)"
    r"\b.*",
    re.DOTALL,
)
"""Words that act on a value before them."""
_OPENS = re.compile(r"\\left|\\!|\\[bB]igg?l?|[(\[]|\\\{|\\lbrace")
"""What begins a bracket."""
_ROOM_OF_OPERATORS = frozenset((r"\;", r"\:", "\\ ", "~"))
_LETTERS_AND_STYLES = frozenset((*LETTERS, *STYLES, *BOLD))
_LETTERS = (
    "α#alpha β#beta γ#gamma δ#delta ε#varepsilon ζ#zeta η#eta θ#theta ι#iota κ#kappa λ#lambda μ#mu ν#nu ξ#xi π#pi "
    "ρ#rho σ#sigma τ#tau υ#upsilon φ#varphi ϕ#phi χ#chi ψ#psi ω#omega Γ#Gamma Δ#Delta Θ#Theta Λ#Lambda Ξ#Xi Π#Pi "
    "Σ#Sigma Φ#Phi Ψ#Psi Ω#Omega ϵ#epsilon ×#times ·#cdot ⋅#cdot ≤#le ≥#ge ≠#ne ±#pm ∓#mp ∂#partial ∇#nabla ∞#infty "
    "≈#approx ≡#equiv ∈#in →#to ⇒#Rightarrow ⇔#Leftrightarrow ∥#| ∑#sum ∫#int ∏#prod ℓ#ell ∝#propto "
    "⋮#vdots ⋯#cdots …#ldots ∧#wedge ⊗#otimes ⊕#oplus ⊙#odot"
)
_SIGNS = {sign: rf"\{name}" for sign, _, name in (pair.partition("#") for pair in _LETTERS.split())}
_ACCENTS = {
    "\u0302": r"\hat",
    "\u0303": r"\tilde",
    "\u0304": r"\bar",
    "\u0305": r"\bar",
    "\u0307": r"\dot",
    "\u0308": r"\ddot",
    "\u030c": r"\check",
    "\u20d7": r"\vec",
}
"""The marks that Unicode writes above the letter before them."""
_SIGNS |= {"°": r"^\circ", "²": "^2", "³": "^3", "′": "'", "″": "''"}


def _accented(pieces: Iterable[Piece]) -> list[Piece]:
    """Return pieces in which a letter with a mark of Unicode above it is one with an accent."""
    found: list[Piece] = []
    for piece in pieces:
        letter, mark = piece.text[:-1], piece.text[-1]
        if (
            len(piece.text) == 1
            and len(parts := unicodedata.normalize("NFD", piece.text)) == 2
            and parts[1] in _ACCENTS
        ):
            letter, mark = parts[0], parts[1]
        if mark in _ACCENTS and (letter or found):
            base = [_as(piece, letter)] if letter else [found.pop()]
            found += [_as(piece, _ACCENTS[mark]), *_braced(piece, base)]
        else:
            found.append(piece)
    return found


def _with_norms(pieces: Sequence[Piece]) -> Sequence[Piece]:
    r"""Return pieces with ``\|`` for two signs of parallels of which the first one stands where a value begins."""
    places = [place for place, each in enumerate(pieces) if each.text == r"\parallel"]
    before = [each.text for each in pieces[: places[0]] if not each.text.isspace()][-1:] if len(places) == 2 else ["x"]
    if before and before[0] not in RELATIONS and before[0] not in SIGNS:
        return pieces
    return [_as(each, r"\|") if place in places else each for place, each in enumerate(pieces)]


def tidied(pieces: Sequence[Piece]) -> list[Piece]:
    r"""Return the pieces of a formula in fewer notations, each where it stood.

    Raises
    ------
    UnreadableError
        If a brace is not closed, or there are more pieces than there may be.

    Examples
    --------
    >>> text = r"f \overset{(1)}{=} \left\{\begin{array}{ll} \underbrace{α}_{b} & \mbox{if $a>0$} \end{array}\right."
    >>> "".join(piece.text for piece in tidied(pieces_of(text)))
    'f = \\begin{cases} {\\alpha} & \\text{if $a>0$}\\end{cases}'
    """
    out: list[Piece] = []
    pairs = _Pairs()
    waiting = _Waiting(
        each
        for piece in grouped(_accented(_with_norms(pieces)))
        for each in (_at(piece, _SIGNS[piece.text]) if piece.text in _SIGNS else (piece,))
    )
    while waiting:
        piece = waiting.pop()
        if piece.text in _SIDES and waiting.next in _DELIMITERS:
            piece = _as(piece, _SIDES[piece.text])
        text = piece.text
        if text in (r"\left", r"\right"):
            if (cases := waiting.cases(piece) if text == r"\left" else None) is not None:
                waiting.put(cases)
            else:
                pairs.open(out, waiting, piece) if text == r"\left" else pairs.close(out, waiting, piece)
        elif text in _UNSEEN:
            waiting.group()
        elif text in _SIZES:
            continue
        elif text in (r"\resizebox", r"\scalebox"):
            for _ in range(2 if text == r"\resizebox" else 1):
                waiting.group()
            inside = waiting.group()
            waiting.put(_formulas_in(inside) or inside)
        elif text == r"\mathbin" and waiting.next == "{":
            waiting.put(waiting.group())
        elif text == r"\!" or (text == r"\mathop" and waiting.next == ":"):
            continue
        elif text == r"\%" and _ends_value(out):
            out += _at(piece, r"\cdot\frac{1}{100}")
        elif text == r"\lfloor" and waiting.is_cross:
            out.append(_as(piece, "("))
        elif text in _OTHERWISE:
            out.append(_as(piece, _OTHERWISE[text]))
        elif text in _POSTFIX and (_is_raised(out) or _ends_value(out)) and waiting.next != "{":
            mark = _braced(piece, _at(piece, _POSTFIX[text]))
            out += mark if _is_raised(out) else [_as(piece, "^"), *mark]
        elif text in _TRIANGLES and not waiting.has_corners:
            out.append(_as(piece, r"\Delta"))
        elif text == r"\prime" and not _is_raised(out):
            out.append(_as(piece, "'"))
        elif text == r"\times" and not _is_raised(out) and (closing := waiting.closing()):
            waiting.put([*closing, _as(piece, "_"), *_braced(piece, [piece])])
        elif text in _ROUNDED:
            out += _at(piece, _ROUNDED[text])
        elif text == "{" and waiting.is_sign and _ends_value(out):
            waiting.put([piece])
            out += waiting.group()
        elif text == "{" and waiting.has_upright_word:
            waiting.put([piece])
            word = [each for each in waiting.group() if each.text.isalpha()]
            waiting.put([_as(piece, r"\mathrm"), *_braced(piece, word)])
        elif text in _BOXES and waiting.next == "{":
            inside = waiting.group()
            name = "".join(each.text for each in inside)
            if (_ACTS_BEHIND if _ends_value(out) else _ACTS_BEFORE).fullmatch(name) and not _is_in_script(out):
                raise UnreadableError(f"the words {name.strip()!r} act on what stands beside them", piece.place)
            called = (_is_name(name) or name in FUNCTIONS) and _OPENS.fullmatch(waiting.next)
            named = (name in FUNCTIONS and waiting.next == "^") or name == "d"
            acts = _acts(name, waiting.next) or (_is_letter(name) and _ends_factor(out))
            if called or named or (_WORD.fullmatch(name) and waiting.next == "_") or acts:
                word = [each for each in inside if not each.text.isspace()]
                waiting.put([_as(piece, r"\mathrm"), *_braced(piece, word)])
                continue
            if not name.strip(" .,;:"):
                out += inside
                continue
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
            if _EXTREMUM.fullmatch(relation):
                base = _at(piece, r"\argmin" if "min" in relation else r"\argmax")
                relation = base[0].text
            if text == r"\underset" and relation in BIG:
                waiting.put([*base, _as(piece, "_"), *_braced(piece, over)])
                continue
            if above in _ACCENTS_ABOVE:
                waiting.put([_as(piece, _ACCENTS_ABOVE[above]), *_braced(piece, base)])
                continue
            if relation == "=" and not _JUSTIFIES.fullmatch(above):
                relation = r"\equiv" if above == "!" else r"\questeq"
            defines = relation == "=" and re.search(r"def|triangle", above)
            plain = [piece, *_braced(piece, over), *_braced(piece, base)]
            out += _at(piece, ":=" if defines else relation) if relation in RELATIONS else plain
        elif text in _FRAMES:
            if text in (r"\textcolor", r"\colorbox", r"\raisebox"):
                waiting.group()
            inside = waiting.group()
            inside = _formulas_in(inside) or inside
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
        elif text == "!" and waiting and waiting[-1].text == "=" and out and out[-1].text.isspace():
            waiting.pop()
            out.append(_as(piece, r"\ne"))
        elif text == "'" and [each.text for each in out[-2:]] == ["{", "}"]:
            raise UnreadableError("a prime behind nothing may be that of a sum", piece.place)
        elif text == "e" and _is_scientific(out, waiting):
            raise UnreadableError("a letter between digits may be that of a number such as 1e3", piece.place)
        elif text in (r"\,", r"\;", r"\ ") and out and out[-1].text.isdigit() and _is_other_number(waiting):
            raise UnreadableError("numbers side by side may be a list", piece.place)
        elif text == "." and [each.text for each in waiting[-1:-3:-1]] == [".", "."]:
            del waiting[-2:]
            out.append(_as(piece, r"\ldots"))
        elif text != r"\_":
            out.append(piece)
            if text == r"\\":
                waiting.skip()
        if len(out) + len(waiting) > MAX_PIECES:
            raise UnreadableError(f"expected a formula of at most {MAX_PIECES} pieces, got more", piece.place)
    return _system(out)


def _is_name(words: str) -> bool:
    """Whether words are one word, and none that joins formulas."""
    return _WORD.fullmatch(words) is not None and not _CONNECTIVES.fullmatch(words.lower())


def _is_letter(words: str) -> bool:
    return len(words) == 1 and words.isalpha()


def _ends_factor(out: Sequence[Piece]) -> bool:
    """Whether a value ends that is no number, behind which a letter may be a unit."""
    before = [each.text for each in out if not each.text.isspace()][-1:]
    return _ends_value(out) and not before[0].isdigit()


def _is_in_script(out: Sequence[Piece]) -> bool:
    """Whether the next piece stands in a subscript or above a letter, where words are names."""
    before = [each for each in out if not each.text.isspace()]
    while before and before[-1].text not in ("_", "^"):
        start = _group_start(before)
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


def _is_scientific(out: Sequence[Piece], waiting: Sequence[Piece]) -> bool:
    """Whether digits stand right before and right behind a letter, as in 1e3 and 10e-3."""
    following = [each.text for each in waiting[-1:-3:-1]]
    following = following[1:] if following[:1] in (["-"], ["+"]) else following
    return bool(out) and out[-1].text.isdigit() and following[:1] != [] and following[0].isdigit()


def _is_other_number(waiting: Sequence[Piece]) -> bool:
    """Whether digits come next that are no group of three, as those of thousands are."""
    following = [each.text.isdigit() for each in waiting[-1:-5:-1]]
    return following[:1] == [True] and following[:3] != [True] * 3


class _Pairs:
    r"""The delimiters behind ``\left`` that have no partner yet.

    Bars are told apart.  A bracket that has no partner in its row may close one of a row before it; a lone one before a
    subscript says where a value is taken, as a bar does.
    """

    def __init__(self) -> None:
        self._opened: list[tuple[int, str]] = []
        self._hanging = 0

    def open(self, out: list[Piece], waiting: _Waiting, piece: Piece) -> None:
        r"""Go over ``\left``."""
        self._opened.append((len(out) + 1, waiting.next))
        if waiting.next == ".":
            waiting.pop()
        else:
            out.append(piece)

    def close(self, out: list[Piece], waiting: _Waiting, piece: Piece) -> None:
        r"""Go over ``\right``, and over its delimiter if it is known by its partner."""
        start, opening = self._opened.pop() if self._opened else (len(out), "")
        closing = waiting.next
        if closing == ".":
            waiting.pop()
            self._hanging += opening in OPENING
            return
        bars = _BAR.get(opening, ())
        if bars and bars == _BAR.get(closing) and start < len(out) and out[start].text == opening:
            out[start] = _as(out[start], bars[0])
            out.append(_as(waiting.pop(), bars[1]))
        elif opening == "." and closing in CLOSING and self._hanging:
            self._hanging -= 1
        elif opening == "." and closing in CLOSING:
            bracket = waiting.pop()
            out.append(_as(bracket, "|" if waiting.next == "_" else closing))
        else:
            out.append(piece)


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

    @property
    def is_sign(self) -> bool:
        """Whether a sign or a relation and a closing brace come next."""
        following = [each.text for each in self[-1:-6:-1] if not each.text.isspace()]
        return following[1:2] == ["}"] and (following[0] in SIGNS or following[0] in RELATIONS)

    @property
    def has_upright_word(self) -> bool:
        r"""Whether an upright word and the end of its group come next, as in ``{\rm range}``."""
        following = "".join(each.text for each in self[-1:-20:-1])
        return re.match(r"\s*\\rm\s*[A-Za-z]{2,}\s*\}", following) is not None

    @property
    def has_corners(self) -> bool:
        """Whether two capitals come next, as behind the sign of a triangle."""
        following = [each.text for each in self[-1:-8:-1] if not each.text.isspace()][:2]
        return len(following) == 2 and all(each.isalpha() and each.isupper() for each in following)

    @property
    def is_cross(self) -> bool:
        r"""Whether brackets of rounding hold the matrix of a cross product, as ``\lfloor a \times \rfloor``."""
        inside, _, behind = "".join(each.text for each in self[::-1] if not each.text.isspace()).partition(r"\rfloor")
        return inside.endswith(r"\times") or re.match(r"(?:\{\})?_\{?\\times", behind) is not None

    def closing(self) -> list[Piece]:
        r"""Take the bracket that closes next, with its ``\right``; if none does, take nothing."""
        following = [each.text for each in self[-1:-6:-1] if not each.text.isspace()]
        sized = following[:1] == [r"\right"]
        if following[sized : sized + 1] not in (["]"], [")"], [r"\rfloor"]):
            return []
        return [Piece(self.next, self.pop().place) for _ in range(1 + sized)]

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

    def skip(self) -> None:
        r"""Go over the length behind ``\\``, as in ``\\[1ex]``."""
        if match := _SKIP.match("".join(each.text for each in self[-1:-20:-1])):
            del self[-len(pieces_of(match.group())) :]

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
                behind = list[Piece]()
                while self and self[-1].text not in (r"\left", r"\right"):
                    behind.append(self.pop())
                if self.next == r"\right":
                    self.pop()
                    if self.next == ".":
                        self.pop()
                        body = _Waiting(inside)
                        if "array" in opening:
                            body.group()
                        begin, end = _as(left, r"\begin{cases}"), _as(left, r"\end{cases}")
                        return [begin, *reversed(body), end, *behind]
        self[:] = kept
        return None


def _is_raised(pieces: Sequence[Piece]) -> bool:
    """Whether a script begins last, perhaps with primes."""
    last = next((piece.text for piece in reversed(pieces) if not piece.text.isspace()), "")
    return last in ("^", "_", "{", "'", r"\prime", "")


def _ends_value(pieces: Sequence[Piece]) -> bool:
    """Whether a letter, a number or a bracket comes last."""
    last = next((piece.text for piece in reversed(pieces) if not piece.text.isspace()), "")
    return last.isalnum() or last in (")", "]", "}") or last in LETTERS


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
    behind = rest[::-1]
    goes_on = rest.next in (",", r"\quad", r"\qquad") and not any(each.text.startswith(r"\begin{") for each in behind)
    if not (goes_on or _says_nothing(behind)):
        return pieces
    if match[1] == "array":
        (body := _Waiting(inside)).group()
        inside = body[::-1]
    rows = [row for row in split_pieces(inside, (r"\\",), brackets=False) if not _says_nothing(row)]
    if match[1] == "matrix":
        cells = [cell for row in rows for cell in split_pieces(row, ("&",)) if not _says_nothing(cell)]
        left = {"".join(piece.text for piece in split_pieces(cell, ("=",))[0] if piece.text.strip()) for cell in cells}
        each_one = len(left) == len(cells) and all(
            any(x.text == "=" for x in cell) and _is_bare(cell) for cell in cells
        )
        parted = [_as(each, r"\\") if each.text == "&" else each for each in inside]
        return [*pieces[:place], *parted, *behind] if cells and each_one else pieces
    columns = rows if match[1] == "array" else map(_first_column, rows)
    equations = [*map(has_relation, columns)]
    alone = equations and (any if match[1] == "array" else all)(equations)
    end = [_as(behind[0], r"\\")] if goes_on else []
    told = [piece for row in rows for piece in (*_with_condition(row), _as(row[0], r"\\"))][:-1]
    return [*pieces[:place], *told, *end, *behind] if alone else pieces


def _first_column(row: Sequence[Piece]) -> list[Piece]:
    """Return what stands before the first mark of alignment; the whole row if a relation follows it."""
    first, *others = split_pieces(row, ("&",))
    return list(row) if others and begins_with_relation(others[0]) else first


def _with_condition(row: Sequence[Piece]) -> list[Piece]:
    """Return a row in which a relation in a column behind an equation is a condition of it, and no factor."""
    said, *others = split_pieces(row, ("&",))
    for cell in others:
        ends = has_relation(said) and not ends_with_relation(said)
        if ends and has_relation(cell) and not begins_with_relation(cell) and _is_bare(cell):
            said += [_as(cell[0], text) for text in (r"\quad", r"\text", "{", *"if", "}")]
        else:
            said.append(_as((*cell, *row)[0], "&"))
        said += cell
    return said


def _is_bare(cell: Sequence[Piece]) -> bool:
    """Whether there are no words in it."""
    return not any(each.text in _BOXES for each in cell)


def _says_nothing(pieces: Sequence[Piece]) -> bool:
    """Whether there are but labels and stops."""
    text = _SILENT.sub("", "".join(piece.text for piece in pieces))
    return not text.strip(" \n\t.,;~")


_SILENT = re.compile(r"\\(?:label|tag\*?|(?:begin|end)(?=\{(?:equation|split|aligned|align)\*?\}))\s*\{[^{}]*\}")
_SYSTEM = re.compile(r"\\begin\{(cases|array|matrix)\}")
