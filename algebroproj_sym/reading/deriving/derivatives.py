r"""What derivatives of what is defined are, such as ``\dot V``, ``f'(x)`` and ``\frac{\partial f}{\partial x}``.

Each rule of calculus is a function of its own, and `RULES` lists them in the order in which they are tried.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.notation import PRIME, SIGNS, TOTAL, bare, derivative_in
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.asking import Asked
from algebroproj_sym.reading.deriving.chains import chained
from algebroproj_sym.reading.deriving.fixed import at_observations, by_given, by_others
from algebroproj_sym.reading.deriving.implicit import implicit, inverse
from algebroproj_sym.reading.deriving.jacobians import jacobian
from algebroproj_sym.reading.deriving.slopes import by_letters, of_itself, of_one_letter
from algebroproj_sym.reading.deriving.summed import summed
from algebroproj_sym.reading.deriving.through import through_arguments
from algebroproj_sym.reading.deriving.totals import as_dots, by_rates
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in

Rule = Callable[[Asked], Definition | None]
RULES: tuple[Rule, ...] = (
    of_itself,
    summed,  # where the index is in the range of its sum
    by_letters,  # where, for a total derivative, the other letters do not change
    of_one_letter,  # where the other letters do not change, and a dot is the derivative by this one
    at_observations,  # where what is observed does not change
    by_given,  # where the other letters do not change
    by_others,  # where no letter of the formula changes
    by_rates,  # where letters without a rate do not change
    as_dots,  # where a dot is the derivative by t
    jacobian,
    implicit,  # where the other letters do not change
    through_arguments,  # where functions have no other arguments
    chained,  # where, for a total derivative, the other letters do not change
    inverse,  # where the other letters do not change
)
"""The rules in the order in which they are tried, each with what it supposes and says."""


def derivatives_in(
    trees: Iterable[Formula], vocabulary: Vocabulary, occurring: frozenset[str], at_vectors: Sequence[Definition] = ()
) -> list[Definition]:
    """Return what the derivatives in some formulas are, as far as the functions have definitions.

    A letter changes with time if its derivative by time occurs in the document.  Of some functions it is known what
    they are at a vector.
    """
    found: dict[str, Definition] = {}
    trees = [*trees]
    waiting = [symbol for tree in trees for symbol in symbols_in(tree)]
    used = [each.tree for tree in trees for each in vocabulary.used_in(tree)]
    called = {str(call.children[0]) for tree in (*trees, *used) for call in tree.find_data("call")}
    seen = set[str]()
    while waiting:
        symbol = waiting.pop()
        if symbol in seen:
            continue
        seen.add(symbol)
        if symbol in vocabulary.definitions:
            waiting += vocabulary.definitions[symbol].symbols
        elif (derivative := derivative_in(symbol)) is not None and derivative.sign in SIGNS:
            made = derivative_of(Asked(symbol, derivative, vocabulary, occurring, at_vectors))
            if made is not None:
                found[symbol] = made if symbol in called else replace(made, parameters=())
                waiting += made.symbols
    return [*found.values()][::-1]


def derivative_of(asked: Asked) -> Definition | None:
    """Return what the first rule that says something says of a derivative; None if none does.

    A partial derivative is that of the formula, and its value is tied to nothing: an equation with the value, solved
    for another letter, does not say that this letter depends on others.
    """
    asked = _without_primes(asked)
    function = asked.known.get(asked.derivative.function)
    if asked.is_partial and function is not None:
        asked = replace(asked, vocabulary=asked.vocabulary.apart_from(function))
    return next((made for rule in RULES if (made := rule(asked)) is not None), None)


def _without_primes(asked: Asked) -> Asked:
    r"""Return a derivative of one with primes as a higher one: ``ds'/dr`` as ``d^2s/dr^2``.

    It must be a function of r, and the document must say that ``s'`` is ``ds/dr``: primes may be of other frames.
    """
    derivative = asked.derivative
    is_open = derivative.sign == TOTAL and derivative.function not in asked.known
    inner = derivative_in(derivative.function) if is_open else None
    if inner is None or inner.sign != PRIME:
        return asked
    given, letters = asked.given(inner.function), (derivative.variable,) * len(inner.letters)
    said = asked.vocabulary.behind(asked.names.get(derivative.function, ""))
    same = replace(derivative, function=inner.function, letters=letters)
    if given is None or [*map(bare, given.parameters)] != [derivative.variable] or same.text not in map(bare, said):
        return asked
    return replace(asked, derivative=replace(same, letters=letters + derivative.letters))
