r"""Derivatives of a letter that an equation ties: ``M = E - e \sin E`` gives ``\frac{dE}{de}``.

The document must have the derivative of the letter by each other letter that may change: it is a function of these.
"""

from __future__ import annotations

from collections.abc import Callable

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import stands_within
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.chains import slope_of
from algebroproj_sym.reading.deriving.rates import ONE
from algebroproj_sym.reading.parsing.grammar import Formula

HasRate = Callable[[str, str], bool]


def implicit(
    sign: str, function: str, variable: str, vocabulary: Vocabulary, has_rate: HasRate
) -> tuple[Formula, tuple[str, ...], Definition] | None:
    r"""Return the derivative of a letter that nothing gives, from the one definition that ties it to others.

    A total derivative has none where several definitions have the letter.

    Parameters
    ----------
    sign : str
        How the derivative begins: ``d`` or ``\partial``.
    function, variable : str
        The letter, and the one by which the derivative is taken.
    vocabulary : Vocabulary
        The definitions.
    has_rate : callable
        Whether the document has a derivative of a letter by another one.

    Returns
    -------
    tuple
        The derivative, the letters that do not change, and the definition from which it is; None if there is none.
    """
    known = [each for each in vocabulary.definitions.values() if function in vocabulary.letters_of(each.tree)]
    tying = [each for each in known if _ties(each, function, variable, vocabulary, has_rate)]
    if function in vocabulary.definitions or len(tying) != 1 or (sign == "d" and len(known) > 1):
        return None
    (given,) = tying
    fixed = tuple(sorted((vocabulary.letters_of(given.tree) | {given.symbol}) - {function, variable}))
    below = slope_of(given.tree, function)
    if variable == given.symbol:
        return Tree("fraction", [ONE, below]), fixed, given
    above: Formula = Tree("sum", [Token("SIGN", "-"), slope_of(given.tree, variable)])
    return Tree("fraction", [above, below]), fixed, given


def _ties(given: Definition, function: str, variable: str, vocabulary: Vocabulary, has_rate: HasRate) -> bool:
    """Whether a definition makes a letter a function of all others in it, which change by themselves."""
    letters = vocabulary.letters_of(given.tree)
    fixed = (letters | {given.symbol}) - {function, variable}
    told = vocabulary.dependence.equated.get(given.symbol, frozenset()) <= {*given.symbols}
    usable = given.usable and told and not given.parameters and given.role == "definition"
    if not usable or variable not in letters | {given.symbol} or stands_within(variable, letters):
        return False
    constant = vocabulary.dependence.constant
    free = all(each in constant or has_rate(function, each) for each in fixed)
    if not free or any(has_rate(each, variable) or has_rate(variable, each) for each in fixed):
        return False
    others = fixed - {given.symbol} - constant
    return not any(vocabulary.moves_with(others, each) for each in (variable, function))
