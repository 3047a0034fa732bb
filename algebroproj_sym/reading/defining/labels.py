r"""What stands above a letter and is no power: a label, as in ``p^h``, and the number of a step, as in ``x^{k+1}``."""

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

from lark import Token, Tree

from algebroproj_sym.reading.lexing.commands import MARKS
from algebroproj_sym.reading.lexing.names import split_symbol, written
from algebroproj_sym.reading.parsing.grammar import (
    UNSEEN,
    Formula,
    Sides,
    lone,
    symbols_in,
    tokens_in,
    trees_in,
    without_brackets,
)

E = Tree("symbol", [Token("SYMBOL", "e")])


class _Raised(NamedTuple):
    """A letter, and what stands above it: another letter, and what is added to that one."""

    symbol: str
    counter: str
    step: str

    @property
    def letter(self) -> str:
        return split_symbol(self.symbol)[0]


def labels_in(equations: Sequence[Sides]) -> frozenset[str]:
    """Return the letters with a label that stands nowhere but above letters, and those with the number of a step.

    A capital above all entries of a printed column may stand below letters as well: it names a frame, or a point.
    So may the letters of factors side by side of which the lower one of each is the upper one of the next.
    """
    above: dict[str, set[str]] = {}
    elsewhere = set[str]()
    frames = {label for side in _every(equations) for label in (*_labels_of_columns(side), *_cancelling(side))}
    for is_lone, side in ((len(sides) == 1, side) for sides in equations for side in sides):
        for base, exponent in _powers_in([side]):
            if _is_letter(base) and (label := lone_letter(exponent)):
                above.setdefault(label, set()).add(lone(base))
        if not is_lone or lone_letter(side) not in frames:
            elsewhere |= {*_not_raised(side, frames)}
    alone = {_with_above(base, label) for label in above.keys() - elsewhere for base in above[label]}
    others = (
        _frames_with_numbers(equations),
        _above_vectors(equations),
        _at_the_start(equations, alone),
        _raised_in_brackets(equations),
    )
    return iterates_in(equations).union(alone, *others)


def _raised_in_brackets(equations: Sequence[Sides]) -> set[str]:
    r"""Return the letters with what stands above a letter that is raised to a power in brackets, as j in ``(s_i^j)^2``.

    Two letters or more have it, and it stands nowhere else but in scripts and below sums.
    """
    above = _written_above(equations)
    inside = [without_brackets(base) for base, _ in _powers_in(_every(equations)) if base.data == "bracket"]
    inner = [trees_in(each) for each in inside if each.data == "power"]
    raised = {_text_of(exponent) for base, exponent in inner if _is_letter(without_brackets(base))}
    labels = {each for each in raised if each == "0" or re.fullmatch("[a-z]", each)}
    labels -= {symbol for side in _every(equations) for symbol in _not_above(side)}
    labels -= {letter for _, exponent in above if len(exponent) > 1 for letter in exponent}
    several = {each for each in labels if len({base for base, exponent in above if exponent == each}) > 1}
    return {_with_above(base, exponent) for base, exponent in above if exponent in several}


def _powers_in(sides: Iterable[Formula]) -> list[list[Formula]]:
    """Return the bases of powers with their exponents."""
    return [trees_in(power) for side in sides for power in side.find_data("power") if len(trees_in(power)) == 2]


def _written_above(equations: Sequence[Sides]) -> list[tuple[str, str]]:
    """Return the letters that are raised, each with the text of what stands above it."""
    powers = _powers_in(_every(equations))
    return [(lone(base), _text_of(exponent)) for base, exponent in powers if _is_letter(base)]


def _is_letter(tree: Any) -> bool:
    return lone(tree) != "" and tree != E


def _text_of(tree: Any) -> str:
    return "".join(tokens_in(tree)) if isinstance(tree, Tree) else str(tree)


def _not_above(tree: Formula) -> Iterator[str]:
    """Yield the symbols of a formula that are no whole exponent."""
    if tree.data == "symbol":
        yield str(tree.children[0])
    is_raised = tree.data == "power" and isinstance(tree.children[1], Tree)
    is_raised = is_raised and _is_letter(without_brackets(trees_in(tree)[1]))
    kept = tree.children[:1] if is_raised else tree.children
    for child in kept:
        if isinstance(child, Tree):
            yield from _not_above(child)


def _at_the_start(equations: Sequence[Sides], labelled: Collection[str]) -> set[str]:
    r"""Return the letters with a 0 above them that have nothing else there but labels: no power is meant."""
    above = _written_above(equations)
    powers = {symbol for symbol, label in above if label != "0" and _with_above(symbol, label) not in labelled}
    return {_with_above(symbol, "0") for symbol, label in above if label == "0" and symbol not in powers}


def _frames_with_numbers(equations: Sequence[Sides]) -> set[str]:
    r"""Return the vectors and matrices with a number of a frame above them, as in ``\mathbf p^0 = R_1^0 \mathbf q^1``.

    No vector has a power, least of all 0 or 1.
    """
    raised = [(symbol, number) for symbol, number in _written_above(equations) if number.isdigit()]
    framed = {split_symbol(symbol)[0] for symbol, number in raised if number in ("0", "1")}
    small = {pair for pair in raised if _VECTOR.match(pair[0]) and split_symbol(pair[0])[0] in framed}
    turned = {pair for pair in raised if _MATRIX.match(pair[0]) and split_symbol(pair[0])[0] in framed}
    frames = {"0", "1"}.union(*({number, split_symbol(symbol)[2]} for symbol, number in turned))
    alike = bool(small) and {number for _, number in small} <= frames
    return {_with_above(symbol, number) for symbol, number in small | turned} if alike else set()


def _above_vectors(equations: Sequence[Sides]) -> set[str]:
    r"""Return the bold letters and the capitals with what stands above a vector, as D and SA: no vector has a power."""
    raised = _written_above(equations)
    labels = {label for symbol, label in raised if _VECTOR.match(symbol) and _LABEL.fullmatch(label)}
    return {
        _with_above(symbol, label)
        for symbol, label in raised
        if label in labels and (_BOLD.match(symbol) or (label.isupper() and _CAPITAL.match(symbol)))
    }


_LABEL = re.compile(r"[a-z]|\\[a-zA-Z]+|[A-Z]{1,3}")
_CAPITAL = re.compile(r"[A-Z](?:_|$)")
_ACCENTED = r"\\(?:d*dot|bar|hat|tilde|widehat|widetilde|overline)\{\\mathbf"
_BOLD = re.compile(rf"\\(?:mathbf|vec)\{{|{_ACCENTED}")
_VECTOR = re.compile(rf"\\(?:mathbf|vec)\{{(?:\\\w+\{{)*(?:[a-z]|\\[a-z]+)\}}|{_ACCENTED}(?:[a-z]|\\[a-z]+)\}}")
_MATRIX = re.compile(r"[A-Z]_|\\d*dot\{[A-Z]\}_")
"""A vector by its style, and a capital with a subscript."""


def iterates_in(equations: Sequence[Sides]) -> frozenset[str]:
    r"""Return the letters with the number of a step above them.

    One equation gives such a letter by what it was one step before: ``x^{k+1} = x^k - g``.  In an equation with one, a
    letter that stands nowhere without a number is counted by the same steps.  A ``t`` above a vector counts steps if
    ``t + 1`` stands above it in the same equation; else it is the sign of a transposed one.
    """
    given = {(each.letter, each.counter) for sides in equations for each in _given_by_steps(sides)}
    raised = [[each for side in sides for each in _raised_in(side)] for sides in equations]
    counted = {each[:2] for found in raised for each in found if (each.letter, each.counter) in given}
    without = {symbol for side in _every(equations) for symbol in _beside_steps(side)} if counted else set()
    size = -1
    while size < len(counted):
        size = len(counted)
        for found in raised:
            counters = {each.counter for each in found if each[:2] in counted}
            counted |= {each[:2] for each in found if each.counter in counters and each.symbol not in without}
    return frozenset(
        _with_above(each.symbol, each.counter + each.step) for found in raised for each in found if each[:2] in counted
    )


def _given_by_steps(sides: Sides) -> Iterator[_Raised]:
    left, *others = sides
    given, within = _raised(left), [each for side in others for each in _raised_in(side)]
    alone = {symbol for side in others for symbol in _beside_steps(side)}
    if given.step == "+1" and given[:2] in {each[:2] for each in within} and given.symbol not in alone:
        yield given
    times = [each for each in (*_raised_in(left), *within) if each.counter == "t" and r"\mathbf" in each.symbol]
    alone |= {*_beside_steps(left)}
    for each in times:
        if each.step and each.symbol not in alone and any(each[:2] == one[:2] and not one.step for one in times):
            yield each


def _every(equations: Sequence[Sides]) -> Iterator[Formula]:
    return (side for sides in equations for side in sides)


def without_above(symbol: str) -> str:
    """Return a symbol without what stands above it."""
    return _with_above(symbol, "")


def _with_above(symbol: str, label: str) -> str:
    letter, primes, below, _ = split_symbol(symbol)
    return written(letter, primes, below, label)


def _raised_in(tree: Formula) -> Iterator[_Raised]:
    found = (_raised(each) for each in tree.iter_subtrees() if each.data in ("power", "marked"))
    return (each for each in found if each.counter)


def _raised(tree: Any) -> _Raised:
    """Return a letter with what stands above it; empty for another formula."""
    base, exponent = tree.children if tree.data in ("power", "marked") else (tree, tree)
    exponent = without_brackets(exponent, UNSEEN)
    if not (isinstance(base, Tree) and base.data == "symbol" and base != E):
        return _Raised("", "", "")
    if not isinstance(exponent, Tree):
        return _Raised(str(base.children[0]), "t" if exponent == "T" else "", "")
    parts = exponent.children if exponent.data == "sum" else [exponent]
    counter = lone_letter(parts[0])
    step = "".join(str(each.children[0]) if isinstance(each, Tree) else str(each) for each in parts[1:])
    return _Raised(str(base.children[0]), counter if len(parts) in (1, 3) else "", step.replace(" ", ""))


def _beside_steps(tree: Formula) -> Iterator[str]:
    """Yield the symbols of a formula that have no number of a step above them."""
    if tree.data == "symbol":
        yield str(tree.children[0])
    elif not (tree.data in ("power", "marked") and _raised(tree).counter):
        for child in tree.children:
            if isinstance(child, Tree):
                yield from _beside_steps(child)


def lone_letter(tree: Any) -> str:
    """Return the Latin letter that an exponent is; empty if it is more or something else."""
    letter = lone(without_brackets(tree, UNSEEN))
    return letter if len(letter) == 1 and letter.isalpha() else ""


def _labels_of_columns(tree: Formula) -> Iterator[str]:
    r"""Yield the capitals that stand above all entries of a column, as C in ``(F^C, M^C)^T``."""
    for matrix in tree.find_data("matrix"):
        cells = [*matrix.find_data("cell")]
        labels = {_raised(cell.children[0]).counter for cell in cells if len(cell.children) == 1}
        if len(cells) > 1 and len(labels) == 1 and (label := labels.pop()).isupper() and label not in MARKS:
            yield label


def _cancelling(tree: Formula) -> Iterator[str]:
    r"""Yield what stands above and below factors of which the lower letter is the next upper one: ``R^a_b p^b``."""
    for run in tree.find_data("run"):
        for one, other in pairwise([_raised(each) for each in run.children if isinstance(each, Tree)]):
            below = [split_symbol(each.symbol)[2] for each in (one, other)]
            if one.counter and other.counter == below[0] and one.step == other.step == "" and one.counter != below[0]:
                yield from (each for each in (one.counter, *below) if len(each) == 1 and each.isalpha())


def _not_raised(tree: Any, frames: Collection[str]) -> Iterator[str]:
    """Yield the letters of a tree that are no whole exponent; of some, those that stand below no letter either."""
    if isinstance(tree, Token):
        found = re.findall(r"(?<![\\a-zA-Z])[a-zA-Z](?![a-zA-Z])", str(tree))
        below = tree.type == "SYMBOL" and "_" in tree
        yield from (each for each in found if not (below and each in frames and not tree.startswith(each)))
    elif tree.data == "power" and _raised(tree).counter and lone_letter(tree.children[1]):
        yield from _not_raised(tree.children[0], frames)
    else:
        for child in tree.children:
            yield from _not_raised(child, frames)


def has_gamma_integral(equations: Iterable[Sides]) -> bool:
    r"""Whether an equation says that a capital gamma is Euler's integral, ``\int_0^\infty t^{x-1} e^{-t} \, dt``.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> forms = (r"t^{x-1} e^{-t} dt", r"e^{-u} u^{x-1} du", r"t^{x} e^{-t} dt")
    >>> [has_gamma_integral([parsed(rf"\Gamma(x) = \int_0^\infty {each}").sides]) for each in forms]
    [True, True, False]
    """
    return any(map(_is_gamma_integral, equations))


def _is_gamma_integral(sides: Sides) -> bool:
    argument = _GAMMA.fullmatch(" ".join(tokens_in(sides[0])))
    if argument is None or len(sides) < 2 or sides[1].data != "big" or sides[1].children[0] != r"\int_{0}^{\infty}":
        return False
    factors = sorted(" ".join(tokens_in(each)) for body in trees_in(sides[1]) for each in trees_in(body))
    steps = {each[2:] for each in factors if each.startswith("d ")} or {*factors} - {"d"}
    return any(
        [each for each in factors if each not in ("d", step, f"d {step}")]
        == sorted((f"{step} {argument[1]} - 1", f"e - {step}"))
        for step in steps
    )


_GAMMA = re.compile(r"\\Gamma (\w|\\[a-z]+)")


def has_euler(sides: Iterable[Formula]) -> bool:
    """Whether e is Euler's number: the base of powers with letters, and nothing else; no side is a square of it."""
    every = [*sides]
    if any(side.data == "power" and side.children[0] == E and not symbols_in(trees_in(side)[1]) for side in every):
        return False
    letters = [token for side in every for token in tokens_in(side) if token == "e"]
    exponents = [exponent for base, exponent in _powers_in(every) if base == E]
    return len(exponents) == len(letters) and any(map(symbols_in, exponents))


def shows_euler(sides: Iterable[Formula]) -> bool:
    r"""Whether e is Euler's number in a section, whatever it is in others, as in ``e^{-t/T}``, unlike ``e^{k+1}``."""
    every = [*sides]
    raised = [without_brackets(exponent) for base, exponent in _powers_in(every) if base == E and symbols_in(exponent)]
    negative = (each.data == "sum" and len(each.children) == 2 for each in raised)
    return has_euler(every) and (any(negative) or any(each.data in ("run", "fraction", "quotient") for each in raised))
