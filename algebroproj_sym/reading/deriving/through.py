r"""Derivatives of functions that nothing computes, through their arguments.

``z = f(y)`` and ``y = g(x)`` give ``dz/dx`` as the product of ``dz/dy`` and ``dy/dx``, whatever f and g are.  A total
derivative is the sum of such products.
"""

from collections.abc import Mapping

from lark import Token, Tree

from algebroproj_sym.reading.defining.dependence import letters_of_symbol
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.recognising import defined_by
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.parsing.grammar import Formula, trees_in, without_brackets

MOST_STEPS = 6


def through_arguments(
    sign: str, above: str, below: str, names: Mapping[str, str], vocabulary: Vocabulary, steps: int = MOST_STEPS
) -> tuple[Formula, tuple[str, ...]] | None:
    r"""Return a first derivative of a function through its arguments, and the places on which it rests.

    The sign is ``d`` or ``\partial``; the function above it, the letter below it and the symbols of the document go by
    their bare names.  There is none if a derivative that it takes does not stand in the document, or if a partial
    derivative is by an argument itself.  It goes through so many functions at most.
    """
    variable = names.get(below, below)
    found = _arguments_of(names.get(above, ""), vocabulary)
    if found is None or not steps or (variable in found[1] and (sign != "d" or len(found[1]) == 1)):
        return None
    heads, arguments, where = found
    hidden = {*heads}.union(*map(letters_of_symbol, heads))
    if variable not in arguments and vocabulary.moves_with(hidden, variable):
        return None
    bare = {symbol: each for each, symbol in names.items()}
    terms: list[Formula] = []
    places = [where]
    for each in arguments:
        slope = _slope(above, bare.get(each, each), names, alone=len(arguments) == 1)
        if slope is None:
            return None
        if each == variable:
            terms.append(slope)
            continue
        rate = _rate(sign, bare.get(each, each), below, names)
        if rate is None:
            inner = through_arguments(sign, bare.get(each, each), below, names, vocabulary, steps - 1)
            if inner is None:
                return None
            rate, more = inner
            places += more
        terms.append(Tree("run", [slope, Tree("group", [rate])]))
    signed: list[Formula | Token] = [part for term in terms for part in (Token("SIGN", "+"), term)]
    return (Tree("sum", signed) if len(terms) > 1 else terms[0]), tuple(places)


def _arguments_of(function: str, vocabulary: Vocabulary) -> tuple[tuple[str, ...], tuple[str, ...], str] | None:
    """Return the functions whose value a letter is, their arguments, and where it says so; None if it is no value."""
    definition = vocabulary.definitions.get(function)
    if definition is None:
        arguments = vocabulary.dependence.arguments.get(function, ())
        return (
            (
                (function,),
                arguments,
                f"{vocabulary.name(function)} as a function of {', '.join(map(vocabulary.name, arguments))} alone",
            )
            if arguments
            else None
        )
    tree = without_brackets(definition.tree)
    head, arguments = defined_by(tree)
    if not definition.usable or definition.role != "definition" or definition.parameters:
        return None
    if not arguments or head in vocabulary.definitions:
        return None
    return (head,), arguments, definition.where


def _slope(above: str, below: str, names: Mapping[str, str], *, alone: bool) -> Formula | None:
    """Return the derivative of a function by one of its arguments, as the document writes it."""
    signs = ("d", r"\partial") if alone else (r"\partial",)
    found = [symbol for sign in signs if (symbol := names.get(f"{sign}{above}/{sign}{below}"))]
    return letter_of(found[0]) if len(found) == 1 else None


def _rate(sign: str, above: str, below: str, names: Mapping[str, str]) -> Formula | None:
    """Return the derivative of an argument as the document writes it."""
    dotted = names.get(rf"\dot{above}") if (sign, below) == ("d", "t") else None
    found = names.get(f"{sign}{above}/{sign}{below}", dotted)
    return letter_of(found) if found else None


def nested(
    above: str, below: str, names: Mapping[str, str], vocabulary: Vocabulary
) -> tuple[Formula, tuple[str, ...]] | None:
    """Return the derivative of ``f(x) = c(b(a(x)))``, where a, b and c are letters as well, and where it is given."""
    definition = vocabulary.definitions.get(names.get(above, ""))
    if definition is None or not definition.usable or definition.parameters != (names.get(below, ""),):
        return None
    bare = {symbol: each for each, symbol in names.items()}
    path, tree = list[str](), without_brackets(definition.tree)
    while tree.data == "call" and len(items := trees_in(trees_in(tree)[0])) == 1:
        path.append(str(tree.children[0]))
        tree = without_brackets(items[0])
    if len(path) < 2 or defined_by(tree) != (definition.parameters[0], ()) or {*path} & {*vocabulary.definitions}:
        return None
    if vocabulary.moves_with(path, definition.parameters[0]) or len({*path}) < len(path):
        return None
    steps = zip(path, [*path[1:], definition.parameters[0]], strict=True)
    slopes = [_slope(bare.get(one, one), bare.get(other, other), names, alone=True) for one, other in steps]
    factors = [each for each in slopes if each is not None]
    return (Tree("run", [*factors]), (definition.where,)) if len(factors) == len(slopes) else None
