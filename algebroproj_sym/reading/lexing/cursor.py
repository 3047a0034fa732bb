"""Where reading stands in the pieces of a formula, and the tokens that it has made so far."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field

from lark import Token

from algebroproj_sym.reading.lexing.commands import BOLD, DROPPED, FRACTIONS, MAX_NESTING, STYLES, UPRIGHT, VALUE_ENDS
from algebroproj_sym.reading.lexing.pieces import Piece, UnreadableError


@dataclass
class Cursor:
    """Where reading stands."""

    pieces: list[Piece]
    """What is read."""
    known: Callable[[str], bool] = lambda name: False
    """Whether a symbol with a superscript is a name of its own."""
    functions: Collection[str] | None = None
    """The letters that are functions; None where letters before brackets are factors."""
    wide: bool = True
    """Whether the argument of a function goes on over letters that follow one another."""
    depth: int = 0
    """How deep the pieces are nested."""
    step: Callable[[Cursor], None] = lambda cursor: None
    """What reads the next piece."""
    index: int = 0
    """The place in the pieces."""
    chose: str = ""
    """What the reader had to choose."""
    out: list[Token] = field(default_factory=list)
    """What was read."""
    opened: list[str] = field(default_factory=list)
    """The brackets that are open."""
    raised: list[Piece] = field(default_factory=list)
    """The superscript that was read last."""

    def within(self, pieces: Sequence[Piece]) -> Cursor:
        """Return where reading of an argument begins.

        It raises `UnreadableError` if it is nested too deep.
        """
        if self.depth >= MAX_NESTING:
            raise self.fail(f"expected at most {MAX_NESTING} levels of nesting, got more")
        return Cursor(list(pieces), self.known, self.functions, self.wide, self.depth + 1, self.step)

    @property
    def text(self) -> str:
        """The piece that is next; empty at the end."""
        return self.pieces[self.index].text if self.index < len(self.pieces) else ""

    @property
    def place(self) -> int:
        """Where it stands in the source."""
        if not self.pieces:
            return 0
        return self.pieces[min(self.index, len(self.pieces) - 1)].place

    def peek(self, after: int = 0) -> str:
        """Return the next piece that is no space."""
        for piece in self.pieces[self.index + after :]:
            if not piece.text.isspace() and piece.text not in DROPPED - {r"\mathrm", "~"}:
                return piece.text
        return ""

    def skip(self) -> None:
        """Go over spaces."""
        while self.index < len(self.pieces) and self.text.isspace():
            self.index += 1

    def fail(self, message: str) -> UnreadableError:
        """Return the error that reading stops here."""
        return UnreadableError(message, self.place)

    def group(self) -> list[Piece]:
        """Return the pieces of an argument: those between braces, or the next one."""
        self.skip()
        if self.index >= len(self.pieces):
            raise self.fail("expected an argument, got the end")
        if self.text != "{":
            return self.single()
        start, depth = self.index, 0
        while self.index < len(self.pieces):
            depth += (self.text == "{") - (self.text == "}")
            if depth > MAX_NESTING:
                raise self.fail(f"expected at most {MAX_NESTING} levels of nesting, got more")
            self.index += 1
            if depth == 0:
                return self.pieces[start + 1 : self.index - 1]
        raise UnreadableError("a brace is not closed", self.pieces[start].place)

    def single(self) -> list[Piece]:
        """Return a piece, with the arguments that it takes."""
        start = self.index
        self.index += 1
        taken = self.pieces[start].text
        if taken in FRACTIONS:
            self.group()
            self.group()
        elif taken in STYLES or taken in UPRIGHT or taken in BOLD or taken == r"\sqrt":
            self.group()
        return self.pieces[start : self.index]

    def option(self) -> list[Piece] | None:
        """Return the pieces of an optional argument in square brackets."""
        self.skip()
        if self.text != "[":
            return None
        start = self.index
        while self.text != "]":
            self.index += 1
            if self.index >= len(self.pieces):
                raise UnreadableError("a bracket is not closed", self.pieces[start].place)
        self.index += 1
        return self.pieces[start + 1 : self.index - 1]

    def emit(self, kind: str, value: str = "") -> None:
        """Add a token."""
        self.out.append(Token(kind, value, start_pos=self.place))

    def inner(self, pieces: Sequence[Piece]) -> None:
        """Emit the tokens of an argument, in invisible brackets."""
        inside = self.within(pieces)
        inside.until_end()
        self.chose = self.chose or inside.chose
        self.emit("OPEN", "{")
        self.out += inside.out
        self.emit("CLOSE", "}")

    def until_end(self) -> None:
        """Read all pieces."""
        while self.index < len(self.pieces):
            self.step(self)
        if self.opened:
            raise self.fail(f"a bracket of the kind {self.opened[-1]} is not closed")
        self.out = _without_idle_separators(self.out)

    def ends_value(self) -> bool:
        """Whether what was read last ends a value."""
        return bool(self.out) and self.out[-1].type in VALUE_ENDS


def _without_idle_separators(tokens: list[Token]) -> list[Token]:
    """Drop separators beside an operator or a bracket: wide spaces that separate nothing."""
    kept: list[Token] = []
    for place, token in enumerate(tokens):
        following = tokens[place + 1].type if place + 1 < len(tokens) else "ROW"
        if token.type == "SEPARATOR" and token.value == " ":
            before = kept[-1].type if kept else "ROW"
            idle = before not in VALUE_ENDS or following in ("SIGN", "RELATION", "SLASH", "DOT", "CROSS", "AMP", "ROW")
            if idle or following in ("RP", "RS", "SEPARATOR"):
                continue
        kept.append(token)
    return kept
