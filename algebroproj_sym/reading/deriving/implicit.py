r"""Derivatives of a letter that an equation ties: ``M = E - e \sin E`` gives ``\frac{dE}{dM}``, ``\frac{dE}{de}``."""

from lark import Token, Tree

from algebroproj_sym.expressions import free_symbols
from algebroproj_sym.proving.reduction import reduced
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import stands_within
from algebroproj_sym.reading.defining.notation import has_rate
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.vocabulary import UNCOMPUTED
from algebroproj_sym.reading.deriving.asking import Asked, slope_of
from algebroproj_sym.reading.deriving.rates import ONE
from algebroproj_sym.reading.parsing.grammar import Formula


def implicit(asked: Asked) -> Definition | None:
    r"""Return the derivative of a letter that nothing gives, from the one definition that ties it to others.

    The document must have the derivative of the letter by each other letter that may change: it is a function of these.
    A total derivative has none where several definitions have the letter.
    """
    vocabulary, function, variable = (
        asked.vocabulary,
        asked.names.get(asked.above, ""),
        asked.names.get(asked.below, ""),
    )
    if not asked.is_first or function in vocabulary.definitions:
        return None
    known = [each for each in vocabulary.definitions.values() if function in vocabulary.letters_of(each.tree)]
    tying = [each for each in known if _ties(each, function, variable, asked)]
    if len(tying) != 1 or (len(known) > 1 and not asked.is_partial):
        return None
    (given,) = tying
    fixed = sorted((vocabulary.letters_of(given.tree) | {given.symbol}) - {function, variable})
    if variable == given.symbol:
        return asked.case(Tree("fraction", [ONE, slope_of(given.tree, function)]), given, fixed)
    return asked.case(tied(given.tree, function, variable), given, fixed)


def tied(tree: Formula, function: str, variable: str) -> Formula:
    """Return the derivative of one letter by another of a formula whose value does not change."""
    above: Formula = Tree("sum", [Token("SIGN", "-"), slope_of(tree, variable)])
    return Tree("fraction", [above, slope_of(tree, function)])


def _ties(given: Definition, function: str, variable: str, asked: Asked) -> bool:
    """Whether a definition makes a letter a function of all others in it, which change by themselves."""
    vocabulary, letters = asked.vocabulary, asked.vocabulary.letters_of(given.tree)
    fixed = (letters | {given.symbol}) - {function, variable}
    told = vocabulary.dependence.equated.get(given.symbol, frozenset()) <= {*given.symbols}
    usable = given.usable and told and not given.parameters and given.role == "definition"
    if not usable or variable not in letters | {given.symbol} or stands_within(variable, letters):
        return False
    constant, occurring = vocabulary.dependence.constant, asked.occurring
    if not all(each in constant or has_rate(function, each, occurring) for each in fixed):
        return False
    if any(has_rate(each, variable, occurring) or has_rate(variable, each, occurring) for each in fixed):
        return False
    others = fixed - {given.symbol} - constant
    return not any(vocabulary.moves_with(others, each) for each in (variable, function))


def inverse(asked: Asked) -> Definition | None:
    """Return a partial derivative of a letter by one that it gives: one divided by that of the other one by it."""
    vocabulary, above = asked.vocabulary, asked.names.get(asked.above, "")
    given = vocabulary.definitions.get(asked.names.get(asked.below, ""))
    if given is None or given.parameters or above not in vocabulary.letters_of(given.tree):
        return None
    if not (asked.is_partial and asked.is_first) or above in vocabulary.definitions:
        return None
    try:
        value = reduced(vocabulary.value(letter_of(given.symbol)))
    except UNCOMPUTED:
        return None
    constant = {vocabulary.symbol_of(str(each)) for each in free_symbols(value)} - {above}
    one_over: Formula = Tree("fraction", [ONE, slope_of(letter_of(given.symbol), above)])
    return None if asked.changes(constant, above) else asked.case(one_over, given, sorted(constant))
