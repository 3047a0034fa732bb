r"""Derivatives of functions that nothing computes, through their arguments.

``z = f(y)`` and ``y = g(x)`` give ``dz/dx`` as the product of ``dz/dy`` and ``dy/dx``, whatever f and g are.  A total
derivative is the sum of such products.
"""

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import letters_of_symbol
from algebroproj_sym.reading.defining.notation import PARTIAL, TOTAL, bare, quotient, with_dot
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.recognising import defined_by
from algebroproj_sym.reading.deriving.asking import Asked
from algebroproj_sym.reading.parsing.grammar import Formula, trees_in, without_brackets

MOST_STEPS = 6
_Found = tuple[Formula, tuple[str, ...]]
"""A derivative, and the places on which it rests."""


def through_arguments(asked: Asked) -> Definition | None:
    """Return a first derivative through functions of functions, each of which the document derives."""
    if not asked.is_first:
        return None
    found = _through(asked, asked.above) or _nested(asked)
    given = asked.vocabulary.definitions.get(asked.names.get(asked.above, ""))
    if found is None:
        return None
    where, part = f"the chain rule, and {', '.join(found[1])}", given.part if given else 0
    return Definition(asked.symbol, (), found[0], where, part, True, role="case")


def _through(asked: Asked, above: str, steps: int = MOST_STEPS) -> _Found | None:
    r"""Return a first derivative of a letter through its arguments.

    There is none if a derivative that it takes does not stand in the document, or if a partial derivative is by an
    argument itself.  It goes through so many functions at most.
    """
    below, variable = asked.below, asked.names.get(asked.below, asked.below)
    found = _arguments_of(asked.names.get(above, ""), asked)
    if found is None or not steps or (variable in found[1] and (asked.is_partial or len(found[1]) == 1)):
        return None
    head, arguments, where = found
    if variable not in arguments and asked.vocabulary.moves_with({head, *letters_of_symbol(head)}, variable):
        return None
    terms, places = list[Formula](), [where]
    for each in arguments:
        slope = _slope(above, each, asked, alone=len(arguments) == 1)
        if slope is None:
            return None
        if each == variable:
            terms.append(slope)
            continue
        dots = with_dot(each) if (asked.sign, below) == (TOTAL, "t") else ""
        rate = asked.names.get(quotient(asked.sign, each, below), asked.names.get(dots))
        inner = _through(asked, bare(each), steps - 1) if rate is None else (letter_of(rate), ())
        if inner is None:
            return None
        places += inner[1]
        terms.append(Tree("run", [slope, Tree("group", [inner[0]])]))
    signed: list[Formula | Token] = [part for term in terms for part in (Token("SIGN", "+"), term)]
    return (Tree("sum", signed) if len(terms) > 1 else terms[0]), tuple(places)


def _arguments_of(function: str, asked: Asked) -> tuple[str, tuple[str, ...], str] | None:
    """Return the function whose value a letter is, its arguments, and where it says so; None if it is no value."""
    vocabulary = asked.vocabulary
    definition = vocabulary.definitions.get(function)
    if definition is None:
        arguments = vocabulary.dependence.arguments.get(function, ())
        where = f"{vocabulary.name(function)} as a function of {', '.join(map(vocabulary.name, arguments))} alone"
        return (function, arguments, where) if arguments else None
    head, arguments = defined_by(without_brackets(definition.tree))
    usable = definition.usable and definition.role == "definition" and not definition.parameters
    return (head, arguments, definition.where) if usable and arguments and head not in vocabulary.definitions else None


def _slope(above: str, below: str, asked: Asked, *, alone: bool) -> Formula | None:
    """Return the derivative of a function by one of its arguments, as the document writes it."""
    signs = (TOTAL, PARTIAL) if alone else (PARTIAL,)
    found = [symbol for sign in signs if (symbol := asked.names.get(quotient(sign, above, below)))]
    return letter_of(found[0]) if len(found) == 1 else None


def _nested(asked: Asked) -> _Found | None:
    """Return the derivative of ``f(x) = c(b(a(x)))``, where a, b and c are letters as well."""
    given, variable = asked.given(asked.above), asked.names.get(asked.below, "")
    if given is None or given.parameters != (variable,):
        return None
    path, tree = list[str](), without_brackets(given.tree)
    while tree.data == "call" and len(items := trees_in(trees_in(tree)[0])) == 1:
        path.append(str(tree.children[0]))
        tree = without_brackets(items[0])
    if len(path) < 2 or defined_by(tree) != (variable, ()) or {*path} & {*asked.vocabulary.definitions}:
        return None
    if asked.vocabulary.moves_with(path, variable) or len({*path}) < len(path):
        return None
    slopes = [_slope(one, other, asked, alone=True) for one, other in zip(path, [*path[1:], variable], strict=True)]
    factors = [each for each in slopes if each is not None]
    return (Tree("run", [*factors]), (given.where,)) if len(factors) == len(slopes) else None
