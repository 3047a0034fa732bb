r"""Derivatives by letters that stand in the formula of a function: ``f'(x)``, ``\frac{\partial f}{\partial x}``.

The other letters of the formula are fixed.  A total derivative supposes it of them.
"""

import re
from dataclasses import replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import stands_within
from algebroproj_sym.reading.defining.notation import DOT, Derivative, by_bare, with_dot
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.deriving.asking import Asked, slope_of
from algebroproj_sym.reading.deriving.rates import ONE
from algebroproj_sym.reading.parsing.grammar import Formula, without_brackets

PLAIN = re.compile(r"\\?[a-zA-Z]+(?:_\d+)?")
"""A letter without an index that something may be summed over."""
_LOGARITHM = re.compile(r"\\(?:ln|log)(?![a-z])(.*)")


def of_itself(asked: Asked) -> Definition | None:
    """Return one as the derivative of a letter by itself."""
    above, below = asked.derivative.function, asked.below
    is_one = asked.derivative.is_first and above == below and PLAIN.fullmatch(above)
    where = "the derivative of a letter by itself"
    return (
        Definition(asked.symbol, (), ONE, where, -1, True) if is_one and not asked.vocabulary.is_matrix(above) else None
    )


def by_letters(asked: Asked) -> Definition | None:
    """Return a derivative of a function, or of its logarithm, by letters that stand in its formula."""
    if not asked.derivative.is_quotient:
        return None
    given, logarithm = function_of(asked)
    if given is None:
        return None
    letters = asked.vocabulary.letters_of(given.tree) | {*given.parameters}
    found = by_bare(sorted(letters))
    variables = [found.get(each, "") for each in asked.derivative.letters]
    if not all(variables) or letters_behind(given, asked).intersection(variables):
        return None
    value = _value(given)
    if logarithm:
        value = Tree("function", [Token("FUNCTION", "ln"), Tree("items", [value])])
    others = [] if asked.is_partial else sorted(letters - {*variables})
    apart = not any(stands_within(each, letters) or (others and asked.changes(others, each)) for each in variables)
    return asked.made(slope_of(value, *variables), given, others) if apart else None


def function_of(asked: Asked) -> tuple[Definition | None, bool]:
    """Return what gives the function of a quotient, or that of which it is the logarithm, which is said."""
    function, logarithm = asked.derivative, None
    if function.function not in asked.known and (logarithm := _LOGARITHM.fullmatch(function.function)):
        function = Derivative("", logarithm[1], ())
    given = asked.given(function.head)
    tree = without_brackets(given.tree) if given else None
    unknown = tree is not None and tree.data == "call" and str(tree.children[0]) not in asked.vocabulary.definitions
    return None if unknown else given, logarithm is not None


def letters_behind(given: Definition, asked: Asked) -> frozenset[str]:
    """Return the letters of what other letters in the formula of a function stand for."""
    used = asked.vocabulary.used_in(given.tree)
    return frozenset().union(*(asked.vocabulary.letters_of(each.tree) for each in used))


def of_one_letter(asked: Asked) -> Definition | None:
    """Return the derivative, with primes or dots, of a function of one letter, and a higher one of what t changes.

    A dot on a function of another letter is taken for the derivative by this letter, if that has no dot itself.
    """
    derivative, vocabulary = asked.derivative, asked.vocabulary
    known = next((each for each in derivative.lower[::-1] if each in asked.known), "")
    given = None if derivative.is_quotient else asked.given(known)
    if given is None or len(given.parameters) > 1:
        return None
    order, (variable,) = len(derivative.letters) - derivative.lower.index(known), given.parameters or ("t",)
    letters = vocabulary.letters_of(given.tree)
    others = sorted(letters - {variable})
    if given.parameters:
        changes = variable in letters_behind(given, asked)
    else:
        by_time = vocabulary.dependence.by_time and "t" in letters and derivative.sign == DOT and order > 1
        changes = not by_time or any(with_dot(each) in asked.names for each in others)
    slope = slope_of(_value(given), *[variable] * order)
    if changes or vocabulary.moves_with(others, variable) or vocabulary.shape_of(slope) is None:
        return None
    made = replace(asked.made(slope, given, others), parameters=given.parameters)
    if variable == "t" or derivative.sign != DOT:
        return made
    where = f"{made.where}, with a dot as the derivative by {vocabulary.name(variable)}"
    return None if with_dot(variable) in asked.names else replace(made, where=where, role="case")


def _value(given: Definition) -> Formula:
    """Return a letter, or the value of a function at its parameters."""
    arguments: list[Any] = [*map(letter_of, given.parameters)]
    call: Formula = Tree("call", [Token("CALLEE", given.symbol), Tree("items", arguments)])
    return call if arguments else letter_of(given.symbol)
