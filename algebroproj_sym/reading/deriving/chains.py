r"""Derivatives by the chain rule, as ``\frac{\partial L}{\partial w}`` where y gives L, and w gives y."""

from collections.abc import Mapping

from lark import Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import stands_within
from algebroproj_sym.reading.defining.notation import change, derivatives_among, with_dot
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.deriving.asking import Asked, slope_of
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in


def chained(asked: Asked) -> Definition | None:
    r"""Return a derivative of what a letter stands for, through the letters that give it.

    A partial derivative by a letter that stands in the formula itself, and in what another letter of it stands for, may
    mean two things: there is none.  By x it leaves ``\dot x`` as it is, if the document has one by ``\dot x`` as well.
    """
    derivative, vocabulary = asked.derivative, asked.vocabulary
    given = asked.given(derivative.function if derivative.is_quotient else asked.above)
    if not (asked.is_partial or asked.is_first) or given is None or given.parameters or given.role == "case":
        return None
    variables = [asked.names.get(each, "") for each in (derivative.letters if asked.is_partial else [asked.below])]
    trees = [tree for each in variables if (tree := _through(each, given, asked)) is not None]
    if len(trees) < len(variables):
        return None
    kept = [] if asked.is_partial else sorted(vocabulary.letters_of(trees[0]) - {*variables})
    return asked.case(slope_of(letter_of(given.symbol), *variables), given, kept)


def _through(variable: str, given: Definition, asked: Asked) -> Formula | None:
    """Return a formula with the letters put in through which it has another one; None if what else is there changes."""
    vocabulary = asked.vocabulary
    used = {each.symbol: each for each in vocabulary.used_in(given.tree)}
    through = _having(variable, used)
    direct, via = variable in given.symbols, through.intersection(given.symbols)
    if not via or variable in used or (direct and asked.is_partial):
        return None
    if any(used[each].parameters or used[each].role == "case" for each in through):
        return None
    tree = filled(given.tree, {each: used[each].tree for each in through})
    others = frozenset(symbols_in(tree)) - {variable}
    others |= frozenset().union(*(vocabulary.behind(each) for each in others if each in used))
    rate = with_dot(variable)
    if asked.is_partial and any(each.variable == rate for each in derivatives_among(asked.occurring)):
        others -= {asked.names.get(rate, ""), *used}
    if variable in others or vocabulary.moves_with(others, variable) or stands_within(variable, others):
        return None
    others = vocabulary.letters_of(given.tree) - {variable}
    return None if change(others, variable, asked.occurring, asked.sign) else tree


def _having(variable: str, used: Mapping[str, Definition]) -> frozenset[str]:
    """Return the letters, without the variable, in whose values the variable stands."""
    found = set[str]()
    while more := {
        each.symbol
        for each in used.values()
        if each.symbol not in found | {variable} and ({variable} | found) & {*each.symbols}
    }:
        found |= more
    return frozenset(found)


def filled(tree: Formula, values: Mapping[str, Formula]) -> Formula:
    """Return a formula with what letters stand for in their place."""
    if tree.data == "symbol" and (value := values.get(str(tree.children[0]))) is not None:
        return Tree("group", [filled(value, values)])
    return Tree(tree.data, [filled(each, values) if isinstance(each, Tree) else each for each in tree.children])
