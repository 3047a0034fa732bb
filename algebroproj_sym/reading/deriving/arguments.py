"""Functions that are written with and without their argument: x is x(t)."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace

from lark import Tree

from algebroproj_sym.reading.defining.notation import has_rate
from algebroproj_sym.reading.defining.premises import Premise, letter_of
from algebroproj_sym.reading.defining.recognising import defined_by, without_power
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.lexing.names import OF_CHANCE, bare_name
from algebroproj_sym.reading.parsing.grammar import Formula, lone, put_in, symbols_in, trees_in

Changed = Callable[[Formula], Formula]
_AT_ONE_TIME = re.compile(
    r"\b(?:initial|starting|start|final|mean|average|constant|fixed|equilibrium|amplitude|maxim\w+|minim\w+|reference|"
    r"rest)\b[^.$]{0,40}\$([^$=]*)\$"
)
"""Words before a letter that stands for one value of a function."""


_OMITTED = r"(?:drop(?:s|ped|ping)?|omit(?:s|ted|ting)?|suppress(?:es|ed|ing)?)"
_ARGUMENTS = r"(?:dependenc(?:y|e|es|ies)|arguments?)"
_WITHOUT_ARGUMENTS = re.compile(
    rf"\b(?:{_OMITTED}\b[^.]{{0,60}}\b{_ARGUMENTS}|{_ARGUMENTS}\b[^.]{{0,60}}\b{_OMITTED})\b"
)


_ELIMINATES = re.compile(r"\b[Ee]liminat(?:e|es|ed|ing|ion of)\b[^.$]{0,40}\$([^$]*)\$")


def omits_arguments(prose: str) -> bool:
    """Whether words say that functions are written without their arguments."""
    return _WITHOUT_ARGUMENTS.search(prose) is not None


def eliminated_in(sentence: str) -> frozenset[str]:
    """Return the letters that a sentence eliminates: functions of them are taken at one and the same value.

    Examples
    --------
    >>> sorted(eliminated_in("Eliminating the time $t$ yields the trajectory"))
    ['t']
    """
    return frozenset(_ELIMINATES.findall(sentence))


def lone_arguments(formulas: Iterable[Sequence[Formula]], prose: str) -> dict[str, str]:
    """Return the functions that have the same letters as arguments everywhere, and stand elsewhere without them.

    The formulas of a document are given by their sides, and its words as prose.  The letters are separated by spaces.
    None stands beside itself without its arguments, nor beside one of them as a factor, nor is it one value by words.
    """
    arguments: dict[str, set[str]] = {}
    alone, beside = set[str](), set[tuple[str, str]]()
    apart = {bare_name(each) for each in _AT_ONE_TIME.findall(prose)}
    for sides in formulas:
        called = [each for side in sides for each in side.find_data("call")]
        lone = {str(each.children[0]) for side in sides for each in side.find_data("symbol")}
        runs = [[str(part.children[0]) for part in trees_in(each)] for side in sides for each in side.find_data("run")]
        for call in called:
            arguments.setdefault(str(call.children[0]), set()).add(" ".join(defined_by(call)[1]))
        apart |= {str(each.children[0]) for each in called} & lone
        alone |= lone
        beside |= {(one, other) for factors in runs for one in factors for other in factors}
    found = {function: min(letters) for function, letters in arguments.items() if len(letters) == 1}
    return {
        each: letter
        for each, letter in found.items()
        if letter
        and alone.issuperset(letter.split())
        and each in alone - apart
        and beside.isdisjoint((each, one) for one in letter.split())
        and re.sub(r"[{}]", "", each) not in apart
    }


def with_plain_arguments(formulas: Sequence[Sequence[Formula]]) -> dict[Formula, Formula]:
    r"""Return calls of functions that are given, and have the power of a letter in one place everywhere, without it.

    So ``\ell(\mu, \sigma^2)`` is a function of ``\mu`` and ``\sigma``.  The formulas are given by their sides.
    """
    calls: dict[str, set[Formula]] = {}
    for call in (call for sides in formulas for side in sides for call in side.find_data("call")):
        calls.setdefault(str(call.children[0]), set()).add(call)
    given = {str(side.children[0]) for sides in formulas for side in sides if side.data == "call" and len(sides) > 1}
    found: dict[Formula, Formula] = {}
    for name in sorted(given):
        items = [call.children[1] for call in calls[name] if len(call.children) == 2]
        places = [trees_in(each) for each in items if isinstance(each, Tree)]
        if len(places) < len(calls[name]) or len({*map(len, places)}) > 1 or len(places[0]) < 2:
            continue
        same = [column[0] for column in zip(*places, strict=True) if len({*column}) == 1]
        plain = {each: letter_of(base) for each in same if each.data == "power" and (base := lone(without_power(each)))}
        if plain and not OF_CHANCE.fullmatch(name) and len({*plain.values(), *same} - {*plain}) == len(same):
            found |= {call: put_in(call, plain) for call in calls[name]}
    return found


def alike(
    lone_arguments: Mapping[str, str],
    occurring: frozenset[str],
    vocabulary: Vocabulary,
    premises: Iterable[Premise],
    *,
    omitted: bool,
) -> dict[str, str]:
    """Return the functions that are the same with and without their arguments, with the arguments.

    The letters give the function where it stands without them, or the document has its derivative by each, or those of
    both by time, or words say that arguments are omitted.
    """
    lone = {each.gives.symbol for each in premises if each.gives is not None and not each.gives.parameters}
    found = {}
    for function, argument in lone_arguments.items():
        known = vocabulary.definitions.get(function)
        if known is not None and not known.parameters:
            is_same = {*argument.split()} <= vocabulary.behind(function)
        else:
            move = all(has_rate(each, "t", occurring) for each in (function, argument))
            rates = all(has_rate(function, each, occurring) for each in argument.split())
            is_same = function not in lone and (move or rates or omitted)
        if is_same:
            found[function] = argument
    return found


def without_arguments(tree: Formula, functions: Mapping[str, str]) -> Formula:
    """Return a formula in which letters stand for the values of functions at their argument."""
    symbol, parameters = defined_by(tree) if tree.data == "call" else ("", ())
    if parameters and functions.get(symbol) == " ".join(parameters):
        return letter_of(symbol)
    return Tree(
        tree.data, [without_arguments(each, functions) if isinstance(each, Tree) else each for each in tree.children]
    )


def known_without(vocabulary: Vocabulary, functions: Mapping[str, str], changed: Changed) -> Vocabulary:
    """Return what letters stand for where functions are letters, and formulas are changed."""
    found = vocabulary.copied()
    for each in vocabulary.definitions.values():
        own = functions.get(each.symbol) == " ".join(each.parameters) != ""
        tree = changed(each.tree)
        if own and each.symbol in symbols_in(tree):
            found.definitions.pop(each.symbol)
        else:
            found.define(replace(each, tree=tree, parameters=() if own else each.parameters))
    found.forget()
    return found


def premise_without(premise: Premise, changed: Changed) -> Premise:
    """Return an equation of which the sides are changed."""
    return replace(premise, left=changed(premise.left), right=changed(premise.right))
