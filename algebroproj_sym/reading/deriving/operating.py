r"""Operators that are worked out: ``\frac{d}{dx}`` with what stands behind it, and integrals between bounds."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from lark import Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import stands_within
from algebroproj_sym.reading.defining.notation import Derivative, bare, change, derivative_in
from algebroproj_sym.reading.defining.premises import extended, letter_of
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.asking import Asked, slope_of, unchanged
from algebroproj_sym.reading.deriving.chains import filled
from algebroproj_sym.reading.deriving.derivatives import derivative_of, derivatives_in
from algebroproj_sym.reading.deriving.integrating import integral_in, is_integral
from algebroproj_sym.reading.deriving.slopes import PLAIN
from algebroproj_sym.reading.deriving.totals import are_constant, by_rates
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in, trees_in, without_brackets


def is_worked_out(tree: Formula) -> bool:
    r"""Whether a formula is an integral, or ``\frac{d}{dx}`` with what stands behind it."""
    return is_integral(tree) or _operator(tree) is not None


def _operator(tree: Formula) -> Derivative | None:
    r"""Return the operator ``\frac{d}{dx}`` by a plain letter with which a formula begins; None for none."""
    found = derivative_in(str(tree.children[0])) if tree.data == "big" else None
    is_one = found is not None and found.is_quotient and not found.function and PLAIN.fullmatch(found.variable)
    return found if is_one else None


def computed(
    tree: Any, vocabulary: Vocabulary, occurring: frozenset[str], own: frozenset[str] = frozenset()
) -> tuple[Any, list[Definition]]:
    r"""Return a formula in which each ``\frac{d}{dx}`` and ``\int_a^b`` is a letter, and what these letters stand for.

    The letters beside x do not change.  A derivative stays as it is if the document speaks of one of another letter.
    The equation that is asked, with the symbols `own`, says of no letter that it changes with one of an integral.
    """
    if not isinstance(tree, Tree):
        return tree, []
    parts = [computed(each, vocabulary, occurring, own) for each in tree.children]
    found, made = Tree(tree.data, [each for each, _ in parts]), [each for _, more in parts for each in more]
    if is_integral(found):
        return _integrated(found, made, vocabulary, occurring, own)
    if (operator := _operator(tree)) is None:
        return found, made
    body = found.children[1]
    inside = without_brackets(body)
    given = derivatives_in((inside,), vocabulary, occurring) if inside.data == "opaque" else []
    formula = Definition(_BODY, (), body, vocabulary.text(body), -1, True)
    symbol, known = f"{tree.children[0]} {formula.where}", extended(vocabulary, [*given, formula])
    by_letter, by_body = (
        [Asked(symbol, replace(operator, function=each), known, occurring) for each in names]
        for names in (_letter_in(inside), (_BODY,))
    )
    rate = next(filter(None, (*map(derivative_of, by_letter), *map(by_rates, by_body))), None)
    if rate is None:
        given, rate = [], _by_one(by_body[0], body, vocabulary.letters_of(body) - {each.symbol for each in made})
    if rate is None:
        return found, made
    return letter_of(symbol), [*made, *given, replace(rate, tree=filled(rate.tree, {_BODY: body}))]


_BODY = r"\body"
"""The name of what stands behind an operator."""


def _by_one(asked: Asked, body: Formula, letters: frozenset[str]) -> Definition | None:
    """Return the derivative of a formula with some letters by one of them, where the others do not change."""
    vocabulary, variable = asked.vocabulary, asked.derivative.variable
    others = sorted(letters - {variable})
    inside = {variable, *others} & {str(each.children[0]) for each in body.find_data("call")}
    if asked.is_partial:
        hidden = any(variable in vocabulary.letters_of(each.tree) for each in vocabulary.used_in(body))
    else:
        hidden = vocabulary.moves_with(others, variable)
    changing = change(others, variable, asked.occurring) or stands_within(variable, letters)
    if variable not in letters or changing or inside or hidden:
        return None
    where = f"the derivative by {vocabulary.name(variable)}{unchanged(others, vocabulary)}"
    return Definition(asked.symbol, (), slope_of(body, *asked.derivative.letters), where, -1, True)


def _letter_in(body: Formula) -> Iterator[str]:
    """Yield the bare letter that a formula is, or of which it is the logarithm."""
    is_logarithm = body.data == "function" and body.children[0] in ("ln", "log")
    inside = without_brackets(trees_in(trees_in(body)[0])[0] if is_logarithm else body)
    if inside.data in ("symbol", "opaque"):
        yield (r"\ln" if is_logarithm else "") + bare(str(inside.children[0]))


def _integrated(
    tree: Formula, made: list[Definition], vocabulary: Vocabulary, occurring: frozenset[str], own: frozenset[str]
) -> tuple[Formula, list[Definition]]:
    """Return the letter of an integral, if it is computed, and what the letters in it and its own stand for."""
    inner, body = extended(vocabulary, made), tree.children[1]
    integrals = (each.tree for each in made if each.tree.data == "integral")
    bound = {symbol for each in integrals for part in trees_in(each)[-2:] for symbol in symbols_in(part)}
    letters = inner.letters_of(body) - bound if isinstance(body, Tree) else frozenset()
    ordered = [*symbols_in(body), *sorted(letters)] if isinstance(body, Tree) else []
    step = next((each for each in ordered if each.startswith("d ") and each in letters), "")
    variable = step[2:]
    plain = frozenset(each for each in letters if not each.startswith("d "))
    others = sorted(plain - {variable})
    calls = {str(each.children[0]) for each in tree.iter_subtrees() if each.data == "call"}
    moving = {variable, *others} & calls or any("/" in each for each in others)
    moving = moving or change(others, variable, occurring) or inner.moves_with(others, variable, own)
    is_open = others and variable not in letters and not are_constant(others, inner)
    if not step or moving or is_open or stands_within(variable, plain):
        return tree, made
    found = integral_in(tree, step, inner)
    if found is None:
        return tree, made
    return letter_of(found.symbol), [*made, replace(found, where=f"{found.where}{unchanged(others, vocabulary)}")]
