r"""Power series of the exponential function, as ``\sum_{n=0}^\infty \frac{1}{n!} A^n``."""

import re

from lark import Token, Tree

from algebroproj_sym.reading.defining.dependence import index_of
from algebroproj_sym.reading.parsing.grammar import Formula, lone, symbols_in, tokens_in, trees_in, without_brackets

_FROM_ZERO = re.compile(r"\\sum_\{[^=]+=0\}\^\{?\+?\\infty\}?")


def with_exponentials(tree: Formula) -> Formula:
    r"""Return a formula in which a power series of the exponential function is this function.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed, printed
    >>> printed(with_exponentials(parsed(r"1 + \sum_{n=0}^\infty \frac{(a B)^n}{n!}").sides[0]))
    'sum [1 + function [exp run [a B]]]'
    """
    if tree.data == "big" and (argument := _argument_of(tree)) is not None:
        return Tree("function", [Token("FUNCTION", "exp"), Tree("items", [argument])])
    return Tree(tree.data, [with_exponentials(each) if isinstance(each, Tree) else each for each in tree.children])


def _argument_of(series: Formula) -> Formula | None:
    """Return of what a sum is the exponential function; None if it is of nothing."""
    head, index = str(series.children[0]), index_of(str(series.children[0]))
    body = without_brackets(trees_in(series)[0])
    factors = trees_in(body) if body.data in ("run", "product") else [body]
    quotients = [each for each in factors if each.data in ("fraction", "quotient") and len(trees_in(each)) == 2]
    if not index or not _FROM_ZERO.fullmatch(head) or len(quotients) != 1 or len(factors) > 2:
        return None
    above, below = map(without_brackets, trees_in(quotients[0]))
    others = [each for each in factors if each is not quotients[0]]
    if below.data != "factorial" or lone(without_brackets(trees_in(below)[0])) != index:
        return None
    if others and tokens_in(above) != ["1"]:
        return None
    power = others[0] if others else above
    base, exponent = trees_in(power) if power.data == "power" else (power, power)
    is_power = power.data == "power" and lone(without_brackets(exponent)) == index
    return without_brackets(base) if is_power and index not in symbols_in(base) else None
