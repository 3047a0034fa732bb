"""Single changes of a form in letters: what slips in print where matrices are multiplied."""

from collections.abc import Iterator
from contextlib import suppress
from itertools import pairwise

from algebroproj_sym.expressions import TextForm
from algebroproj_sym.expressions.letters import LetterError, Term, factors_of, letters_text, made, number, parse_letters
from algebroproj_sym.proving.letters import shape_in_text


def changes_in_letters(printed: TextForm) -> Iterator[tuple[str, TextForm]]:
    """Yield the changes of a form: a sign, a transpose, a letter, a factor, the order of factors, a number.

    Examples
    --------
    >>> form = TextForm("A*B.T", (("A", "3x3"), ("B", "3x3")))
    >>> [str(changed) for _, changed in changes_in_letters(form)]
    ['-A*B.T', 'B.T*A', 'B.T', 'A', 'A.T*B.T', 'B*B.T', 'A*B', 'A*A.T']
    """
    shapes = {name: shape_in_text(name, text) for name, text in printed.letters or ()}
    term = parse_letters(printed.text, shapes)
    letters = sorted((part for part in factors_of(term) if part.kind in ("letter", "symbol")), key=letters_text)
    yield "sign of all", TextForm(letters_text(_negative(term)), printed.letters)
    for change, changed in _changes(term, letters):
        if changed.shape == term.shape and changed != term:
            yield change, TextForm(letters_text(changed), printed.letters)


def _changes(term: Term, letters: list[Term]) -> Iterator[tuple[str, Term]]:
    yield from _of_top(term, letters)
    for place, part in enumerate(term.parts):
        for change, changed in _changes(part, letters):
            if not term.kind == changed.kind == "transpose":
                with suppress(LetterError):
                    yield change, _with_part(term, place, changed)


def _of_top(term: Term, letters: list[Term]) -> Iterator[tuple[str, Term]]:
    shown, parts = letters_text(term), term.parts
    if term.kind == "number":
        yield f"number {shown}", number(term.value + 1)
    elif term.kind in ("letter", "symbol"):
        if term.shape[0] == term.shape[1] != 1:
            yield f"transpose of {shown}", made("transpose", term)
        alike = (other for other in letters if other != term and other.shape == term.shape)
        yield from ((f"{shown}: {letters_text(other)}", other) for other in alike)
    elif term.kind == "transpose":
        yield f"transpose of {letters_text(*parts)}", parts[0]
    elif term.kind == "sum":
        for place, part in enumerate(parts):
            yield f"sign of {letters_text(part)}", _with_part(term, place, _negative(part))
    elif term.kind == "product":
        for place, (first, second) in enumerate(pairwise(parts)):
            exchanged = (*parts[:place], second, first, *parts[place + 2 :])
            with suppress(LetterError):
                yield f"order at factor {place + 1}", made("product", *exchanged)
        for place in range(len(parts)):
            with suppress(LetterError):
                others = (*parts[:place], *parts[place + 1 :])
                yield f"factor {place + 1}: missing", others[0] if len(others) == 1 else made("product", *others)


def _with_part(term: Term, place: int, part: Term) -> Term:
    return made(term.kind, *term.parts[:place], part, *term.parts[place + 1 :], value=term.value)


def _negative(term: Term) -> Term:
    return made("product", number(-1), term)
