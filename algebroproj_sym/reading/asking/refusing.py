"""What is not asked: of a function with other arguments, of what hides an index, and outside a range."""

import re
from collections.abc import Callable, Collection, Iterator, Sequence
from functools import partial
from typing import Any

from lark import Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import captured_in
from algebroproj_sym.reading.defining.domains import is_outside
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.evaluating import evaluated
from algebroproj_sym.reading.parsing.factors import terms_of
from algebroproj_sym.reading.parsing.grammar import Formula, lone, symbols_in, tokens_in, trees_in, without_brackets

MOST_CALLS = 200
"""How many values of functions are looked at, to see whether they are taken in their range."""
_SAME_EVERYWHERE = re.compile(r"(?:\\math[a-z]+\{)?[fghFGH]\}?'*")
"""How functions are called that are the same ones of all letters, unlike p in p(x) and p(y)."""
_DENSITY = re.compile(r"(?:\\[a-z]+\{)*(?:[pqP]|\\pi|\\rho|\\(?:var)?phi|N)\}*")
"""How densities are called, which are other ones of other letters."""
_OF_AN_AXIS = re.compile(r"(?:\\[a-z]+\{)?[A-Z]\}?_\{?(?:[123xyz]|\\(?:mathrm|text)\{[xyz]\})\}?")


def _is_turn(definition: Definition) -> bool:
    """Whether a function is the printed rotation about an axis, by which it is called: of any angle the same one."""
    tree = without_brackets(definition.tree)
    turns = [each for each in tree.find_data("function") if each.children[0] in ("sin", "cos")]
    return (
        tree.data == "matrix"
        and _OF_AN_AXIS.fullmatch(definition.symbol) is not None
        and {*symbols_in(tree)} == {*definition.parameters}
        and len(tokens_in(tree, "SYMBOL")) == sum(len(tokens_in(each, "SYMBOL")) for each in turns) > 0
    )


def of_other_letters(vocabulary: Vocabulary, *trees: Formula) -> str:
    """Return a function that is taken at lone letters, all others than it was defined with; empty for none.

    At a letter that is given, as x at the time ``T = 2 v/g``, it is the same one, but for densities.
    """
    for definition, letters in taken_at_other_letters(vocabulary, *trees):
        if _is_density(definition) or not all(each in vocabulary.definitions for each in letters):
            return definition.symbol
    return ""


def taken_at_other_letters(vocabulary: Vocabulary, *trees: Formula) -> Iterator[tuple[Definition, list[str]]]:
    """Yield the functions that are taken at lone letters, all others than they were defined with, with these."""
    operators = vocabulary.kinds.averages.operators
    for call in (each for tree in trees for each in tree.find_data("call")):
        definition = vocabulary.definitions.get(str(call.children[0]))
        if definition is None or definition.part < 0 or _SAME_EVERYWHERE.fullmatch(definition.symbol):
            continue
        if definition.tree.data == "marked" or _is_turn(definition):
            continue
        if definition.symbol in operators or any(
            each.children[0] in operators for each in definition.tree.find_data("call")
        ):
            continue
        letters = [lone(without_brackets(each)) for items in trees_in(call) for each in items.children]
        others = [split_symbol(each)[0] for each in letters if each]
        if _are_of_one_kind(definition, letters):
            continue
        if letters and len(others) == len(letters) and not {*others, *letters} & {*definition.parameters}:
            yield definition, letters


def _is_density(definition: Definition) -> bool:
    return _DENSITY.fullmatch(split_symbol(definition.symbol)[0]) is not None


def _are_of_one_kind(definition: Definition, letters: Sequence[str]) -> bool:
    r"""Whether a function adds a letter to its parameter, as L in ``w(x) = x^2 (3 L - x)``: of L it is the same one."""
    if len(letters) != 1 or len(definition.parameters) != 1 or _is_density(definition):
        return False
    alone = [{frozenset(symbols_in(term)) for term in terms_of(each)} for each in definition.tree.find_data("sum")]
    return any({frozenset(letters), frozenset(definition.parameters)} <= each for each in alone)


def hides_an_index(vocabulary: Vocabulary, *trees: Formula) -> str:
    """Return why letters under a sum may not be taken for fixed; empty if they may."""
    letter, index = captured_in(vocabulary.with_used(*trees), partial(_hidden_in, vocabulary))
    return f"{vocabulary.name(letter)} may depend on {index}, by which a sum or an integral runs" if letter else ""


def _hidden_in(vocabulary: Vocabulary, symbol: str) -> Collection[str]:
    """Return on what a letter may depend: an expected value, a constant and the imaginary unit on nothing."""
    is_fixed = symbol in vocabulary.kinds.averages.operators or symbol == vocabulary.imaginary
    return () if is_fixed or vocabulary.constant(symbol) is not None else vocabulary.hidden_in(symbol)


def out_of_range(vocabulary: Vocabulary, *trees: Formula) -> str:
    """Return which letter or function is given in a range in which nothing lies that is put in; empty for none."""
    used = vocabulary.used_in(*trees)
    if not any(each.ranges for each in used):
        return ""
    plain = lambda symbol: vocabulary.value(letter_of(symbol))  # noqa: E731
    outside = (each.symbol for each in used if not each.parameters and is_outside(each.ranges, plain, plain))
    given = (each.tree for each in used if not each.parameters)
    left = iter(range(MOST_CALLS))
    called = (_called_outside(vocabulary, each, plain, left) for each in (*trees, *given))
    return next((_in_another_range(vocabulary, each) for each in outside), "") or next(filter(None, called), "")


def _in_another_range(vocabulary: Vocabulary, symbol: str) -> str:
    return f"{vocabulary.name(symbol)} is defined only for other values than those here"


def _called_outside(vocabulary: Vocabulary, tree: Formula, names: Callable[[str], Any], left: Iterator[int]) -> str:
    """Return which function a formula takes outside of its range, itself or through others, or that they are many."""
    for call in tree.find_data("call"):
        function = vocabulary.definitions.get(str(call.children[0]))
        arguments = [each for items in call.children[1:] if isinstance(items, Tree) for each in trees_in(items)]
        if function is None or not function.usable or len(arguments) != len(function.parameters):
            continue
        put = dict(zip(function.parameters, arguments, strict=True))
        own = lambda symbol, put=put: evaluated(put[symbol], names) if symbol in put else names(symbol)  # noqa: E731
        if next(left, None) is None:
            return f"expected at most {MOST_CALLS} values of functions that are defined for a range, got more"
        if is_outside(function.ranges, own, names):
            return _in_another_range(vocabulary, function.symbol)
        if inner := _called_outside(vocabulary, function.tree, own, left):
            return inner
    return ""
