"""The pieces of a formula that are yet to come, and what stands before them."""

import re
from collections.abc import Iterable, Sequence

from algebroproj_sym.reading.lexing.commands import LETTERS, MATRIX, RELATIONS, SIGNS
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError, first_text, pieces_of, split_pieces

_ARRAY = re.compile(r"\\begin\{(?:array|matrix|aligned|split|gathered|cases)\}")
_LENGTH = re.compile(r"-?[\d.]+\s*(?:pt|mm|cm|in|ex|em|mu)")
_IN_BRACES = re.compile(
    r"\s*(?P<style>\\cal\s*)?(?P<name>(?:\\(?:d*dot|bar|hat|tilde|vec)\s*)?"
    r"(?:[a-zA-Z]|\\[a-zA-Z]+(?:\s*\{[a-zA-Z]+\})?))\s*\}(?=\s*[(_])|\s*\}(?=\s*[&=])"
)
"""What stands in braces for its looks alone, and their end."""
_NABLA = re.compile(r"\s*(?:\\(?:bm|boldsymbol|mathbf|vec)\s*(?:\{\s*\\nabla\s*\}|\\nabla)|(?:\\bf\s*)?\\nabla)\s*\}")
_FLAT = r"(?:[^{}&]|\{[^{}]*\})*"
_FRACTION = re.compile(
    rf"\s*(?:\\frac\s*\{{({_FLAT})\}}\s*\{{({_FLAT})\}}\s*|({_FLAT}?)\\over(?![a-z])({_FLAT}))\}}(?!\s*[_^])"
)
"""A fraction in braces, of which the first one stands before."""
_END = re.compile(MATRIX.pattern.replace("begin", "end"))
_SKIP = re.compile(r"\[\s*-?[\d.]*\s*(?:pt|mm|cm|in|ex|em|mu|\\[a-z]+)\s*\]")


def at(piece: Piece, text: str) -> list[Piece]:
    """Return the pieces of a text, all where a piece stood."""
    return [Piece(each.text, piece.place) for each in pieces_of(text)]


def renamed(piece: Piece, text: str) -> Piece:
    """Return another piece that stands where one stood."""
    return Piece(text, piece.place)


def braced(piece: Piece, inside: Sequence[Piece]) -> list[Piece]:
    """Return pieces in braces."""
    return [renamed(piece, "{"), *inside, renamed(piece, "}")]


class Pending(list[Piece]):
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

    def follows(self, *texts: str) -> bool:
        """Whether these pieces come next, without spaces."""
        return [each.text for each in self[: -len(texts) - 1 : -1]] == [*texts]

    def turn(self, text: str, into: str) -> None:
        """Write the next piece otherwise, if it is a certain one."""
        if self.next == text:
            self.append(renamed(self.pop(), into))

    def options(self) -> None:
        """Go over what stands in square brackets."""
        while self.next == "[":
            self.until("[", "]")

    def number(self) -> list[Piece]:
        """Take the digits that come next, and the point in them."""
        taken = list[Piece]()
        while self and (self[-1].text.isdigit() or (self[-1].text == "." and self[-2:-1] and self[-2].text.isdigit())):
            taken.append(self.pop())
        return taken

    def group(self) -> list[Piece]:
        """Take an argument: what stands in braces, without them, or the next piece."""
        if self.next != "{":
            return [self.pop()] if self else []
        return self.until("{", "}")[1:-1]

    def ket(self) -> list[Piece] | None:
        r"""Take what stands before the ``\rangle`` that closes next, if nothing opens, and no bar stands, before it."""
        for place in range(len(self) - 1, max(-1, len(self) - 40), -1):
            text = self[place].text
            if text == r"\rangle":
                inside = self[place + 1 :][::-1]
                del self[place:]
                return [each for each in inside if each.text != r"\right"]
            if text in ("|", r"\|", r"\langle", r"\vert", r"\rvert", r"\left", "&", r"\\") or text in RELATIONS:
                return None
        return None

    def name_in_braces(self) -> list[Piece] | None:
        r"""Take what braces hold: nothing before ``&`` or ``=``, a name before a bracket, a nabla, or a fraction."""
        text = "".join(each.text for each in self[-1:-40:-1])
        if match := _IN_BRACES.match(text):
            style, name = match["style"], match["name"] or ""
            found = rf"\mathcal{{{name}}}" if style else name
        elif match := _NABLA.match(text):
            found = r"\nabla "
        elif match := _FRACTION.match(text):
            above, below = (each for each in match.groups() if each is not None)
            found = rf"\frac{{{above}}}{{{below}}}"
        else:
            return None
        place, left = self[-1].place, len(match.group())
        while left:
            left -= len(self.pop().text)
        return at(Piece("", place), found)

    def brackets_in_braces(self) -> list[Piece] | None:
        r"""Take the end of braces that have nothing but a round bracket; None if they have something else."""
        depth, brackets, closed = 1, 0, False
        for place in range(len(self) - 1, -1, -1):
            text = self[place].text
            depth += (text == "{") - (text == "}")
            if depth == 0:
                if closed:
                    del self[place]
                return [] if closed else None
            if text.isspace() or text in (r"\left", r"\right"):
                continue
            if closed or not (brackets or text == "("):
                return None
            brackets += (text == "(") - (text == ")")
            closed = brackets == 0
        return None

    @property
    def is_sign(self) -> bool:
        """Whether a sign or a relation and a closing brace come next."""
        following = [each.text for each in self[-1:-6:-1] if not each.text.isspace()]
        return following[1:2] == ["}"] and (following[0] in SIGNS or following[0] in RELATIONS)

    @property
    def has_upright_word(self) -> bool:
        r"""Whether an upright word and the end of its group come next, as in ``{\rm range}``."""
        following = "".join(each.text for each in self[-1:-20:-1])
        return re.match(r"\s*\\rm\s*[A-Za-z]+\.?\s*\}", following) is not None

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

    def ends_entry(self, out: Sequence[Piece]) -> bool:
        """Whether an entry of a matrix ends here, or a side of an equation outside of matrices."""
        within = sum(bool(MATRIX.match(each.text)) - bool(_END.match(each.text)) for each in out)
        if not within:
            return self.next == "="
        return self.next in ("&", r"\\") or _END.match(self.next) is not None

    def until(self, opening: str, closing: str) -> list[Piece]:
        """Take all up to the partner of the piece that is next."""
        taken, depth = list[Piece](), 0
        while self:
            taken.append(self.pop())
            depth += (taken[-1].text == opening) - (taken[-1].text == closing)
            if depth == 0:
                return taken
        raise UnreadableError(f"{opening} is not closed", taken[0].place)

    def before(self, mark: str) -> list[Piece]:
        """Take what stands before a mark, and the mark, if it comes in the same group."""
        parts = split_pieces(self[::-1], (mark,), brackets=False)
        if len(parts) > 1:
            del self[-len(parts[0]) - 1 :]
        return parts[0] if len(parts) > 1 else []

    def close_group(self, piece: Piece) -> None:
        """Put a closing brace at the end of the group in which the next piece stands."""
        depth, place = 0, len(self)
        while place and depth >= 0:
            place -= 1
            depth += (self[place].text == "{") - (self[place].text == "}")
        self.insert(place + 1 if depth < 0 else 0, renamed(piece, "}"))

    def skip(self) -> None:
        r"""Go over the length behind ``\\``, as in ``\\[1ex]``, or the star."""
        if self.follows("*"):
            self.pop()
        if match := _SKIP.match("".join(each.text for each in self[-1:-20:-1])):
            del self[-len(pieces_of(match.group())) :]

    def length(self) -> str:
        r"""Take a length, as behind ``\hskip`` and ``\hspace``."""
        if self.next == "{":
            return "".join(each.text for each in self.group()).strip()
        if match := _LENGTH.match("".join(each.text for each in self[-1:-12:-1])):
            del self[-len(match.group()) :]
        return match.group() if match else ""

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
                        body = Pending(inside)
                        if "array" in opening:
                            body.group()
                        begin, end = renamed(left, r"\begin{cases}"), renamed(left, r"\end{cases}")
                        return [begin, *reversed(body), end, *behind]
        self[:] = kept
        return None


def is_raised(pieces: Sequence[Piece]) -> bool:
    """Whether a script begins last, perhaps with primes."""
    last = first_text(reversed(pieces))
    return last in ("^", "_", "{", "'", r"\prime", "")


def ends_value(pieces: Sequence[Piece]) -> bool:
    """Whether a letter, a number or a bracket comes last."""
    last = first_text(reversed(pieces))
    return last.isalnum() or last in (")", "]", "}") or last in LETTERS


def without_label(pieces: Sequence[Piece]) -> Sequence[Piece]:
    """Return pieces without a label at their end."""
    if first_text(reversed(pieces)) != "}":
        return pieces
    bare = [each for each in pieces if not each.text.isspace()]
    start = group_start(bare[:-1])
    return bare[: start - 2] if start is not None and start > 1 and bare[start - 2].text == r"\label" else pieces


def group_start(pieces: Sequence[Piece]) -> int | None:
    """Return where the group begins in which the next piece stands; None if it stands in none."""
    depth = 0
    for place in range(len(pieces) - 1, -1, -1):
        depth += (pieces[place].text == "}") - (pieces[place].text == "{")
        if depth < 0:
            return place + 1
    return None


def formulas_in(words: Sequence[Piece]) -> list[Piece]:
    """Return what stands between dollars, if nothing stands beside it."""
    parts = split_pieces(words, ("$",))
    alone = len(parts) > 1 and all(piece.text.isspace() for part in parts[::2] for piece in part)
    return [piece for part in parts[1::2] for piece in part] if alone else []
