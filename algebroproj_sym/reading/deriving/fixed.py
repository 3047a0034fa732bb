r"""Partial derivatives by letters that do not stand in the formula of a function itself.

What stands there may have them.  Nothing says then which letters are fixed: such a derivative refutes nothing.
"""

import re

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.notation import (
    PARTIAL,
    bare,
    by_bare,
    change,
    derivatives_among,
    quotient,
    with_dot,
)
from algebroproj_sym.reading.defining.values import with_values
from algebroproj_sym.reading.defining.vocabulary import UNCOMPUTED
from algebroproj_sym.reading.deriving.asking import Asked
from algebroproj_sym.reading.deriving.chains import filled
from algebroproj_sym.reading.deriving.rates import ONE, ZERO, rate_of
from algebroproj_sym.reading.deriving.slopes import PLAIN, function_of
from algebroproj_sym.reading.deriving.totals import derived
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.factors import terms_of
from algebroproj_sym.reading.parsing.grammar import lone

_ERROR = re.compile(r"(?:e|v|\\eta|\\nu|\\(?:var)?epsilon)(?:_.*)?")
"""How the error of a model is called."""


def _function_of(asked: Asked) -> Definition | None:
    """Return what gives the function of a first partial derivative."""
    return function_of(asked)[0] if asked.is_partial and asked.derivative.is_first else None


def by_given(asked: Asked) -> Definition | None:
    """Return a partial derivative by a letter that something gives, as if nothing did: the others do not change.

    The letter stands in one formula, or in others that are put in, and not in both: it might be meant at fixed values
    of these.
    """
    given = _function_of(asked)
    vocabulary, variable = asked.vocabulary, asked.known.get(asked.below, "")
    if given is None or not variable or variable in vocabulary.letters_of(given.tree):
        return None
    own = {variable: ONE, "e": ZERO} if vocabulary.euler else {variable: ONE}
    try:
        rate, rates, letters = derived(given.tree, own, vocabulary)
    except UnreadableError:
        return None
    fixed = letters - rates.keys()
    twice = variable in given.symbols and len(rates) > len(own)
    if rate is None or variable not in letters or twice or asked.changes(fixed, variable):
        return None
    return asked.case(rate, given, sorted(fixed))


def at_observations(asked: Asked) -> Definition | None:
    """Return a partial derivative by a letter of a model, ``y = a x + e``, where y does not change.

    With the model put in, the formula does not have the letter, as ``(y - a x)^2`` then is ``e^2``.
    """
    given = _function_of(asked)
    if given is None:
        return None
    vocabulary = asked.vocabulary
    variable = by_bare(sorted(vocabulary.letters_of(given.tree) | {*given.parameters})).get(asked.below, "")
    modelled = [each for each in vocabulary.used_in(given.tree) if variable in vocabulary.letters_of(each.tree)]
    if not modelled or not all(any(map(_ERROR.fullmatch, map(lone, terms_of(each.tree)))) for each in modelled):
        return None
    put_in = filled(given.tree, {each.symbol: each.tree for each in modelled if not each.parameters})
    try:
        rate, whole = (rate_of(each, {variable: ONE}) for each in (given.tree, put_in))
        is_apart = whole is not None and with_values(vocabulary).value(whole) == 0
    except UNCOMPUTED:
        return None
    return asked.case(rate, given, [each.symbol for each in modelled]) if rate is not None and is_apart else None


def by_others(asked: Asked) -> Definition | None:
    """Return zero as a partial derivative by a letter on which nothing in the formula depends.

    The document derives other functions by it, or this one by its rate, which stands in the formula.
    """
    given = _function_of(asked)
    vocabulary, below = asked.vocabulary, asked.below
    letters = vocabulary.letters_of(given.tree) | {*given.parameters} if given is not None else frozenset[str]()
    if given is None or below in asked.known or below in map(bare, letters):
        return None
    derived = [each for each in derivatives_among(asked.occurring) if each.is_quotient and each.variable == below]
    others = [asked.known[each.function] for each in derived if each.function in asked.known]
    used = frozenset().union(*(vocabulary.letters_of(vocabulary.definitions[each].tree) for each in others))
    variable = by_bare(sorted(used - {*vocabulary.definitions})).get(below, "")
    is_apart = variable and not vocabulary.moves_with(letters, variable)
    if not is_apart and _has_rate_alone(asked, given):
        variable, is_apart = below, True
    changes = change(letters, variable, asked.occurring, PARTIAL)
    return asked.made(ZERO, given, sorted(letters)) if is_apart and not changes else None


def _has_rate_alone(asked: Asked, given: Definition) -> bool:
    r"""Whether a function has the rate of a letter, ``\dot x``, by which the document derives it, and not the letter.

    No other letter moves with it, also none of the other rates, and none is a term of its own, as a potential is.
    """
    vocabulary, below = asked.vocabulary, asked.below
    letters = vocabulary.letters_of(given.tree)
    rate = by_bare(sorted(letters)).get(with_dot(below), "")
    if not PLAIN.fullmatch(below) or quotient(PARTIAL, asked.derivative.function, rate) not in asked.names:
        return False
    moving = {other for other in asked.occurring if with_dot(other) in map(bare, letters)} - {below}
    trees = vocabulary.with_used(given.tree)
    alone = letters & {lone(term) for each in trees for term in terms_of(each)}
    return not (alone or vocabulary.moves_with(letters - {rate} | moving, below))
