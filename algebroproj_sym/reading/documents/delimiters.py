r"""Delimiters behind ``\left`` and ``\right``."""

from algebroproj_sym.reading.documents.pending import Pending, renamed
from algebroproj_sym.reading.lexing.commands import CLOSING, OPENING
from algebroproj_sym.reading.lexing.pieces import Piece

_BAR = {
    name: (rf"\l{kind}", rf"\r{kind}")
    for kind, names in (("vert", r"| \vert \lvert \rvert"), ("Vert", r"\| \Vert \lVert \rVert"))
    for name in names.split()
}


class Pairs:
    r"""The delimiters behind ``\left`` that have no partner yet.

    Bars are told apart.  A bracket that has no partner in its row may close one of a row before it; a lone one before a
    subscript says where a value is taken, as a bar does.  A brace behind rows says that they belong together.
    """

    def __init__(self) -> None:
        self._opened: list[tuple[int, str]] = []
        self._hanging = 0

    def open(self, out: list[Piece], waiting: Pending, piece: Piece) -> None:
        r"""Go over ``\left``."""
        self._opened.append((len(out) + 1, waiting.next))
        if waiting.next == ".":
            waiting.pop()
        else:
            out.append(piece)

    def close(self, out: list[Piece], waiting: Pending, piece: Piece) -> None:
        r"""Go over ``\right``, and over its delimiter if it is known by its partner."""
        start, opening = self._opened.pop() if self._opened else (len(out), "")
        closing = waiting.next
        if closing == ".":
            waiting.pop()
            self._hanging += opening in OPENING
            return
        bars = _BAR.get(opening, ())
        if bars and bars == _BAR.get(closing) and start < len(out) and out[start].text == opening:
            out[start - 1 : start + 1] = [renamed(out[start], bars[0])]
            out.append(renamed(waiting.pop(), bars[1]))
        elif opening == "." and closing in CLOSING and self._hanging:
            self._hanging -= 1
        elif opening == "." and closing in CLOSING:
            bracket, inside = waiting.pop(), [each.text for each in out[start - 1 :] if not each.text.isspace()]
            rows = closing == r"\}" and inside and inside[0].startswith(r"\begin{") and inside[-1].startswith(r"\end{")
            out += [] if rows else [renamed(bracket, "|" if waiting.next == "_" else closing)]
        else:
            out.append(piece)
