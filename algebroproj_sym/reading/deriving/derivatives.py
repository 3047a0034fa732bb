r"""What derivatives of what is defined are, such as ``\dot V``, ``f'(x)`` and ``\frac{\partial f}{\partial x}``."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

from lark import Token, Tree

from algebroproj_sym.expressions import free_symbols
from algebroproj_sym.proving.reduction import reduced
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import stands_within
from algebroproj_sym.reading.defining.premises import extended, letter_of
from algebroproj_sym.reading.defining.values import with_values
from algebroproj_sym.reading.defining.vocabulary import UNCOMPUTED, Vocabulary
from algebroproj_sym.reading.deriving.chains import chained, filled, slope_of
from algebroproj_sym.reading.deriving.implicit import implicit
from algebroproj_sym.reading.deriving.integrating import integral_in, is_integral
from algebroproj_sym.reading.deriving.jacobians import jacobian_of
from algebroproj_sym.reading.deriving.rates import ONE, UNCHANGED, ZERO, copies_in, rate_of
from algebroproj_sym.reading.deriving.summed import by_summed
from algebroproj_sym.reading.deriving.through import nested, through_arguments
from algebroproj_sym.reading.lexing.names import bare_name, split_symbol, written
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.factors import terms_of
from algebroproj_sym.reading.parsing.grammar import Formula, lone, symbols_in, trees_in, without_brackets

_DERIVATIVE = re.compile(r"(d|\\partial)(\^[23])?(.+)/\1(.+?)(?(2)\2)")
_LOGARITHM = re.compile(r"(\\(?:ln|log)(?![a-z]))?(.*)")
_MIXED = re.compile(r"\\partial\^2(.+)/\\partial(.+?)\\partial(.+)")
_OPERATOR = re.compile(r"(d|\\partial)(\^[23])?/\1([a-zA-Z]|\\[a-z]+)(?(2)\2)")
_ERROR = re.compile(r"(?:e|v|\\eta|\\nu|\\(?:var)?epsilon)(?:_.*)?")
"""How the error of a model is called."""
AT_START = re.compile(r"_\{?0")
_AXIS = re.compile(r"\\(?:mathbf|vec|hat|overrightarrow)\{?(?:\\mathbf\{?)?(?:[ijkxyz]\}*$|e\}*_\{?[xyz123]\}?$)")


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
        else:
            made = _derivative(symbol, vocabulary, occurring)
            if made is not None and made.parameters and symbol not in called:
                made = replace(made, parameters=())
            for each in [made] if made is not None else _by_chains(symbol, vocabulary, occurring, at_vectors):
                found[each.symbol] = each
                waiting += each.symbols
    return [*found.values()][::-1]


def is_worked_out(tree: Formula) -> bool:
    r"""Whether a formula is an integral, or ``\frac{d}{dx}`` with what stands behind it."""
    return is_integral(tree) or (tree.data == "big" and _OPERATOR.fullmatch(str(tree.children[0])) is not None)


def computed(
    tree: Any, vocabulary: Vocabulary, occurring: frozenset[str], own: frozenset[str] = frozenset()
) -> tuple[Any, list[Definition]]:
    r"""Return a formula in which each ``\frac{d}{dx}`` and ``\int_a^b`` is a letter, and what these letters stand for.

    The letters beside x do not change.  A derivative stays as it is if the document speaks of one of another letter.
    The equation that is asked, with the symbols `own`, says of no letter that it changes with one of an integral.
    """
    if not isinstance(tree, Tree):
        return tree, []
    parts = [computed(each, vocabulary, occurring, own) for each in tree.children]
    found, made = Tree(tree.data, [each for each, _ in parts]), [each for _, more in parts for each in more]
    if is_integral(found):
        return _integrated(found, made, vocabulary, occurring, own)
    match = _OPERATOR.fullmatch(str(tree.children[0])) if tree.data == "big" else None
    if match is None:
        return found, made
    sign, order, variable = match.groups()
    body = found.children[1]
    if (sign, order) == ("d", None):
        whole = f"{tree.children[0]} {vocabulary.text(body)}"
        formula = Definition(whole, (), body, vocabulary.text(body), -1, True)
        rate = _of_lone(body, variable, vocabulary, occurring)
        rate = rate or _of_formula(whole, formula, variable, vocabulary, occurring)
        inside = without_brackets(body)
        if rate is None and variable == "t" and inside.data == "opaque":
            given = derivatives_in((inside,), vocabulary, occurring)
            known = extended(vocabulary, given)
            if (function := str(inside.children[0])) in known.definitions:
                made, rate = [*made, *given], _rate(whole, function, known, occurring)
        if rate is not None:
            return letter_of(rate.symbol), [*made, rate]
    if of_letter := _of_operator(sign, order, body, variable, vocabulary, occurring):
        return letter_of(of_letter.symbol), [*made, of_letter]
    letters = vocabulary.letters_of(body) - {each.symbol for each in made}
    others = sorted(letters - {variable})
    changing = _change(others, variable, occurring)
    inside = {variable, *others} & {str(each.children[0]) for each in tree.iter_subtrees() if each.data == "call"}
    if sign == "d":
        hidden = vocabulary.moves_with(others, variable)
    else:
        hidden = any(variable in vocabulary.letters_of(each.tree) for each in vocabulary.used_in(body))
    if variable not in letters or changing or inside or hidden or stands_within(variable, letters):
        return found, made
    where = f"the derivative by {vocabulary.name(variable)}{unchanged(others, vocabulary)}"
    symbol = f"{tree.children[0]} {vocabulary.text(body)}"
    made.append(Definition(symbol, (), slope_of(body, variable, order), where, -1, True))
    return letter_of(symbol), made


def _of_operator(
    sign: str, order: str | None, body: Any, variable: str, vocabulary: Vocabulary, occurring: frozenset[str]
) -> Definition | None:
    r"""Return the derivative of a letter, or of its logarithm, that is printed behind ``\frac{d}{dx}``."""
    inside = without_brackets(body)
    is_logarithm = inside.data == "function" and inside.children[0] in ("ln", "log")
    function = lone(without_brackets(trees_in(inside.children[1])[0] if is_logarithm else inside))
    if not function or order:
        return None
    above = rf"\ln{_bare(function)}" if is_logarithm else _bare(function)
    return _derivative(f"{sign}{above}/{sign}{_bare(variable)}", vocabulary, occurring)


def _integrated(
    tree: Formula, made: list[Definition], vocabulary: Vocabulary, occurring: frozenset[str], own: frozenset[str]
) -> tuple[Formula, list[Definition]]:
    """Return the letter of an integral, if it is computed, and what the letters in it and its own stand for."""
    inner, body = extended(vocabulary, made), tree.children[1]
    integrals = (each.tree for each in made if each.tree.data == "integral")
    bound = {symbol for each in integrals for part in trees_in(each)[-2:] for symbol in symbols_in(part)}
    letters = inner.letters_of(body) - bound if isinstance(body, Tree) else frozenset()
    ordered = [*symbols_in(body), *sorted(letters)] if isinstance(body, Tree) else []
    step = next((each for each in ordered if each.startswith("d ") and each in letters), "")
    variable = step[2:]
    plain = frozenset(each for each in letters if not each.startswith("d "))
    others = sorted(plain - {variable})
    calls = {str(each.children[0]) for each in tree.iter_subtrees() if each.data == "call"}
    moving = {variable, *others} & calls or any("/" in each for each in others)
    moving = moving or _change(others, variable, occurring) or inner.moves_with(others, variable, own)
    is_open = others and variable not in letters and not _are_constant(others, inner)
    if not step or moving or is_open or stands_within(variable, plain):
        return tree, made
    found = integral_in(tree, step, inner)
    if found is None:
        return tree, made
    return letter_of(found.symbol), [*made, replace(found, where=f"{found.where}{unchanged(others, vocabulary)}")]


def _of_lone(tree: Any, variable: str, vocabulary: Vocabulary, occurring: frozenset[str]) -> Definition | None:
    """Return the derivative of a lone letter, or of a derivative that an equation above gives."""
    tree = without_brackets(tree)
    if tree.data not in ("symbol", "opaque"):
        return None
    function = _bare(str(tree.children[0]))
    return _of_factors(f"the rate of {function}", function, variable, vocabulary, occurring)


def has_rate(letter: str, variable: str, occurring: frozenset[str]) -> bool:
    """Whether a document has a derivative of a letter by a variable, also as dots where that is the time."""
    bare, below, name = frozenset(map(_bare, occurring)), _bare(variable), _bare(letter)
    rates = {f"{d}{n}{name}/{d}{below}{n}" for d in ("d", r"\partial") for n in ("", "^2")}
    return not bare.isdisjoint(rates | ({_with_dot(name), _with_dot(_with_dot(name))} if variable == "t" else set()))


def order_of(symbol: str, letter: str, variable: str) -> int | None:
    r"""Return how often a letter is derived by a variable in a symbol; None if the symbol is none of its derivatives.

    Examples
    --------
    >>> order_of(r"\dot{x}", "x", "t"), order_of("d^2y/dx^2", "y", "x"), order_of("x_1", "x", "t")
    (1, 2, None)
    """
    bare, name, below = _bare(symbol), _bare(letter), _bare(variable)
    dots = [name, _with_dot(name), _with_dot(_with_dot(name))] if variable == "t" else []
    written = ([name], [f"d{name}/d{below}", f"{name}'", *dots[1:2]], [f"d^2{name}/d{below}^2", f"{name}''", *dots[2:]])
    return next((order for order, names in enumerate(written) if bare in names), None)


def _change(letters: Iterable[str], variable: str, occurring: frozenset[str], sign: str = "d") -> bool:
    """Whether the document has a derivative of some letter, by a variable, or by time.

    The time does not matter to a partial derivative by another letter.
    """
    bare, below = frozenset(map(_bare, occurring)), _bare(variable)
    by_time = sign == "d" or variable == "t"
    return any(
        {*(f"{d}{_bare(each)}/{d}{below}" for d in ("d", r"\partial"))} & bare
        or (by_time and {_with_dot(each), f"{_bare(each)}'"} & bare)
        for each in letters
    )


_PLAIN = re.compile(r"\\?[a-zA-Z]+(?:_\d+)?")
"""A letter without an index that something may be summed over."""


def _derivative(symbol: str, vocabulary: Vocabulary, occurring: frozenset[str]) -> Definition | None:
    if "/" in symbol:
        if mixed := _MIXED.fullmatch(symbol):
            return _of_two(symbol, mixed, vocabulary)
        match = _DERIVATIVE.fullmatch(symbol)
        if match is None:
            return None
        if match[3] == match[4] and not match[2] and _PLAIN.fullmatch(match[3]) and not vocabulary.is_matrix(match[3]):
            return Definition(symbol, (), ONE, "the derivative of a letter by itself", -1, True)
        if (summed := _of_summed(symbol, match, vocabulary)) is not None:
            return summed
        vocabulary = _for_slope(match, vocabulary)
        factors = _of_factors(symbol, _function_of(match), match[4], vocabulary, occurring)
        found = _of_quotient(symbol, match, vocabulary, occurring) or _as_dots(symbol, match, occurring)
        return factors if found is None or (factors and match[3].endswith(")")) else found
    if "'" in symbol:
        return _of_prime(symbol, vocabulary)
    bare = _without_dot(symbol)
    function = _by_bare(vocabulary.definitions).get(bare) if bare else None
    if function is None or vocabulary.definitions[function].parameters:
        return _of_time(symbol, vocabulary, occurring)
    tree = vocabulary.definitions[function].tree
    rated = any(each in vocabulary.definitions and has_rate(each, "t", occurring) for each in symbols_in(tree))
    by_factors = rated or not vocabulary.is_computed(tree)
    found = _of_factors(symbol, bare, "t", vocabulary, occurring) if by_factors else None
    return found or _rate(symbol, function, vocabulary, occurring)


def _for_slope(match: re.Match[str], vocabulary: Vocabulary) -> Vocabulary:
    """Return the vocabulary for a derivative: a partial one is that of the formula, and its value is tied to nothing.

    An equation with the value, solved for another letter, does not say that this letter depends on others.
    """
    function = _by_bare(vocabulary.definitions).get(match[3], "")
    return vocabulary.apart_from(function) if match[1] != "d" and function else vocabulary


def _by_chains(
    symbol: str, vocabulary: Vocabulary, occurring: frozenset[str], at_vectors: Sequence[Definition]
) -> Iterator[Definition]:
    """Yield what a first derivative is by the chain rule, or by components, which proves and refutes nothing."""
    names = _by_bare(sorted(occurring))
    if "^2" in symbol:
        yield from _second_by_chains(symbol, names, vocabulary)
        return
    match = _DERIVATIVE.fullmatch(symbol if "/" in symbol else f"d{_without_dot(symbol)}/dt")
    if match is None or match[2]:
        return
    sign, _, above, below = match.groups()
    function = names.get(above, "")
    if made := jacobian_of(above, _bare(below), names, vocabulary, {one.symbol: one for one in at_vectors}):
        matrix, (first, *more) = made
        where = " and ".join(dict.fromkeys(each.where for each in (first, *more)))
        yield replace(_made(symbol, matrix, replace(first, where=where), [], vocabulary), role="case")
        return
    by_it = lambda one, other: has_rate(one, other, occurring)  # noqa: E731
    if tied := implicit(sign, function, names.get(_bare(below), ""), vocabulary, by_it):
        tree, fixed, tying = tied
        yield replace(_made(symbol, tree, tying, [*fixed], vocabulary), role="case")
        return
    through = through_arguments(sign, above, below, names, vocabulary) or nested(above, below, names, vocabulary)
    if through is not None:
        tree, places = through
        given = vocabulary.definitions.get(function)
        yield Definition(
            symbol, (), tree, f"the chain rule, and {', '.join(places)}", given.part if given else 0, True, role="case"
        )
        return
    found = chained(sign, function, _bare(below), names, _for_slope(match, vocabulary))
    if found is not None:
        tree, kept, definition, free = found
        others = vocabulary.letters_of(definition.tree)
        if not _change(others - {names[_bare(below)]}, names[_bare(below)], occurring, sign):
            yield replace(_made(symbol, tree, definition, [*kept], vocabulary), role="case")
            yield from [] if free is None else [free]
    elif sign != "d" and (inverse := _of_inverse(symbol, match, names, vocabulary, occurring)):
        yield inverse


def _of_inverse(
    symbol: str, match: re.Match[str], names: dict[str, str], vocabulary: Vocabulary, occurring: frozenset[str]
) -> Definition | None:
    """Return a partial derivative of a letter by one that it gives: one divided by that of the other one by it."""
    sign, _, above, below = match.groups()
    given = vocabulary.definitions.get(names.get(_bare(below), ""))
    letters = vocabulary.letters_of(given.tree) if given and not given.parameters else frozenset()
    if given is None or names.get(above) not in letters or names[above] in vocabulary.definitions:
        return None
    try:
        value = reduced(vocabulary.value(letter_of(given.symbol)))
    except UNCOMPUTED:
        return None
    constant = {vocabulary.symbol_of(str(each)) for each in free_symbols(value)} - {names[above]}
    if vocabulary.moves_with(constant, names[above]) or _change(constant, names[above], occurring, sign):
        return None
    inverse: Formula = Tree("fraction", [ONE, slope_of(letter_of(given.symbol), names[above])])
    return replace(_made(symbol, inverse, given, sorted(constant), vocabulary), role="case")


def _second_by_chains(symbol: str, names: dict[str, str], vocabulary: Vocabulary) -> Iterator[Definition]:
    """Yield what a second partial derivative is, through the letters that give those in its function."""
    above, *below = _names_of_second(symbol)
    made = [chained(r"\partial", names.get(above, ""), each, names, vocabulary) for each in below]
    if made and all(each is not None and each[3] is None for each in made):
        first, last = (each for each in made if each is not None)
        tree = Tree("slope", [first[0], last[0].children[1]])
        yield replace(_made(symbol, tree, first[2], [], vocabulary), role="case")


def _names_of_second(symbol: str) -> tuple[str, ...]:
    """Return the bare names of the function of a second partial derivative, and of both letters; empty for none."""
    if mixed := _MIXED.fullmatch(symbol):
        return mixed[1], mixed[2], mixed[3]
    match = _DERIVATIVE.fullmatch(symbol)
    is_second = match is not None and match[1] == r"\partial" and match[2] == "^2"
    return (match[3], match[4], match[4]) if match and is_second else ("",)


def _function_of(match: re.Match[str]) -> str:
    r"""Return the bare letter of which a quotient is the first derivative: ``d^2r/dt^2`` that of ``dr/dt``."""
    sign, order, above, below = match.groups()
    return {None: re.sub(r"\(.*\)$", "", above), "^2": f"d{above}/d{below}"}.get(order, "") if sign == "d" else ""


def _of_factors(
    symbol: str, function: str, variable: str, vocabulary: Vocabulary, occurring: frozenset[str]
) -> Definition | None:
    """Return the derivative of what a letter stands for, factor by factor; a letter without a rate does not change."""
    definition = vocabulary.definitions.get(_by_bare(vocabulary.definitions).get(function, ""))
    if definition is None or not definition.usable or definition.role == "case":
        return None
    if definition.parameters not in ((), (variable,)):
        return None
    return _of_formula(symbol, definition, variable, vocabulary, occurring)


def _of_formula(
    symbol: str, definition: Definition, variable: str, vocabulary: Vocabulary, occurring: frozenset[str]
) -> Definition | None:
    """Return the derivative of a formula likewise."""
    tree, own = definition.tree, rates_in(occurring, variable)
    try:
        rates, trees = through_given(tree, {**own, variable: ONE}, vocabulary)
        rate = rate_of(tree, rates)
    except UnreadableError:
        return None
    letters = [each for one in trees for each in symbols_in(one) if each != variable]
    if any(each not in rates and vocabulary.gives_letters(each) for each in letters):
        return None
    constant = [each for each in letters if each not in rates and f"{each}({variable})" not in rates]
    known = {*vocabulary.behind(variable)} if variable in vocabulary.definitions else set()
    if (
        known & {*constant}
        or vocabulary.moves_with(constant, variable)
        or any(" " in each or "/" in each for each in constant)
    ):
        return None
    timed = any(variable in symbols_in(one) for one in trees)
    if not (timed or _are_constant(constant, vocabulary) or (variable == "t" and _is_of_motion(occurring))):
        return None
    if rate is None or symbol in symbols_in(rate):
        return None
    return _made(symbol, rate, definition, constant, vocabulary)


def _is_of_motion(occurring: frozenset[str]) -> bool:
    r"""Whether a document has derivatives by ``\dot q``: all coordinates have dots, and nothing else changes."""
    return any(r"/\partial\dot" in _bare(each) for each in occurring)


def _are_constant(letters: Iterable[str], vocabulary: Vocabulary) -> bool:
    """Whether letters are numbers, or said to be constant, or may be fixed though nothing says so.

    What has the index of the start may be, and so may a vector of an axis.
    """
    known, axes_turn = vocabulary.dependence.constant, vocabulary.dependence.axes_turn
    return all(
        each in known
        or AT_START.search(each)
        or (_AXIS.search(each) and not axes_turn)
        or vocabulary.constant(each) is not None
        for each in letters
    )


def rates_in(occurring: frozenset[str], variable: str) -> dict[str, Formula]:
    """Return the letters, and values such as x(t), whose derivatives by a variable stand in a document, with these."""
    found: dict[str, Formula] = {}
    bare = _by_bare(sorted(occurring))
    for each in sorted(occurring):
        name, value = _bare(each), f"{_bare(each)}({variable})"
        second = re.fullmatch(rf"d([^/^]+)/d{re.escape(variable)}", name)
        rate = bare.get(f"d^2{second[1]}/d{variable}^2") if second else bare.get(f"d{name}/d{variable}")
        rate = rate or (bare.get(_with_dot(each)) if variable == "t" else None)
        if rate is not None:
            found[each] = letter_of(rate)
            if second is None and rate == bare.get(_with_dot(each)):
                of_time: Formula = Tree("call", [Token("CALLEE", rate), Tree("items", [letter_of(variable)])])
                found[f"{each}({variable})"] = of_time
        if (whole := bare.get(f"d{value}/d{variable}")) is not None:
            found[f"{each}({variable})"] = found[each] = letter_of(whole)
    return found


def _of_quotient(
    symbol: str, match: re.Match[str], vocabulary: Vocabulary, occurring: frozenset[str] = frozenset()
) -> Definition | None:
    """Return a derivative of what is given by a formula; zero for a partial one by a letter that only others have."""
    sign, order, above, below = match.groups()
    known = _by_bare(vocabulary.definitions)
    logarithm, inside = ("", above) if above in known else _LOGARITHM.fullmatch(above).groups()  # type: ignore[union-attr]  # it always matches
    function = known.get(re.sub(r"\(.*\)$", "", inside), "")
    definition = vocabulary.definitions.get(function)
    if definition is None or not definition.usable or _is_unknown(definition, vocabulary):
        return None
    value = letter_of(definition.symbol)
    if definition.parameters:
        arguments: list[Any] = [*map(letter_of, definition.parameters)]
        value = Tree("call", [Token("CALLEE", definition.symbol), Tree("items", arguments)])
    if logarithm:
        value = Tree("function", [Token("FUNCTION", "ln"), Tree("items", [value])])
    letters = vocabulary.letters_of(definition.tree) | {*definition.parameters}
    variable = _by_bare(sorted(letters)).get(_bare(below))
    used = vocabulary.used_in(definition.tree)
    if variable is None:
        if sign != "d" and not order and _bare(below) in known:
            return _as_if_not_given(symbol, definition, known[_bare(below)], vocabulary)
        other = _of_others(_bare(below), letters, vocabulary, occurring) if sign != "d" else ""
        other = other or (_of_rate(above, _bare(below), definition.tree, vocabulary, occurring) if sign != "d" else "")
        is_zero = other and not _change(letters, other, occurring, sign)
        return _made(symbol, ZERO, definition, sorted(letters), vocabulary) if is_zero else None
    if modelled := [each for each in used if variable in vocabulary.letters_of(each.tree)]:
        return _at_observations(symbol, definition, variable, modelled, vocabulary) if sign != "d" else None
    if stands_within(variable, letters):
        return None
    others = sorted(letters - {variable}) if sign == "d" else []
    if vocabulary.moves_with(others, variable):
        return None
    return _made(symbol, slope_of(value, variable, order), definition, others, vocabulary)


def _at_observations(
    symbol: str, definition: Definition, variable: str, modelled: Sequence[Definition], vocabulary: Vocabulary
) -> Definition | None:
    """Return a partial derivative by a letter of a model, ``y = a x + e``, where y does not change.

    With the model put in, the formula does not have the letter, as ``(y - a x)^2`` then is ``e^2``.
    """
    if not all(any(map(_ERROR.fullmatch, map(lone, terms_of(each.tree)))) for each in modelled):
        return None
    put_in = filled(definition.tree, {each.symbol: each.tree for each in modelled if not each.parameters})
    try:
        rate, whole = (rate_of(each, {variable: ONE}) for each in (definition.tree, put_in))
        is_apart = whole is not None and with_values(vocabulary).value(whole) == 0
    except UNCOMPUTED:
        return None
    if rate is None or not is_apart:
        return None
    return replace(_made(symbol, rate, definition, [each.symbol for each in modelled], vocabulary), role="case")


def _as_if_not_given(symbol: str, definition: Definition, variable: str, vocabulary: Vocabulary) -> Definition | None:
    """Return a partial derivative by a letter as if nothing gave it: the others in the formulas do not change.

    It stands in one formula, or in others that are put in, and not in both: it might be meant at fixed values of these.
    """
    try:
        rates, trees = through_given(definition.tree, {variable: ONE}, vocabulary)
        rate = rate_of(definition.tree, rates)
    except UnreadableError:
        return None
    fixed = {symbol for tree in trees for symbol in symbols_in(tree)} - {*rates}
    twice = variable in symbols_in(definition.tree) and len(trees) > 1
    if rate is None or twice or vocabulary.moves_with(fixed, variable):
        return None
    return replace(_made(symbol, rate, definition, sorted(fixed), vocabulary), role="case")


def through_given(
    tree: Formula, rates: Mapping[str, Formula], vocabulary: Vocabulary
) -> tuple[dict[str, Formula], list[Formula]]:
    """Return rates with those of letters that others give, and the formulas in which they stand with the first one."""
    found, trees = dict(rates), [tree]
    copies = dict.fromkeys(found, 1)
    for each in vocabulary.used_in(tree):
        known = each.symbol in found or each.parameters
        if not known and (rate := rate_of(each.tree, found, copies)) is not None:
            found[each.symbol] = Tree("group", [rate])
            copies[each.symbol] = copies_in(each.tree, copies)
            trees.append(each.tree)
    return found, trees


def _is_unknown(definition: Definition, vocabulary: Vocabulary) -> bool:
    """Whether a letter is the value of a function that nothing gives."""
    tree = without_brackets(definition.tree)
    return tree.data == "call" and str(tree.children[0]) not in vocabulary.definitions


def _of_others(below: str, letters: frozenset[str], vocabulary: Vocabulary, occurring: frozenset[str]) -> str:
    """Return the letter by which the document derives others, and on which some do not depend; empty if they may."""
    known = _by_bare(vocabulary.definitions)
    derived = (
        match[3] for each in map(_bare, occurring) if (match := _DERIVATIVE.fullmatch(each)) and match[4] == below
    )
    trees = [vocabulary.definitions[known[each]].tree for each in derived if each in known]
    used = frozenset().union(*map(vocabulary.letters_of, trees))
    variable = _by_bare(sorted(used - {*vocabulary.definitions})).get(below, "")
    return "" if vocabulary.moves_with(letters, variable) else variable


def _of_rate(above: str, below: str, tree: Formula, vocabulary: Vocabulary, occurring: frozenset[str]) -> str:
    r"""Return a letter of which a function has the rate alone, and by which the document derives it: ``\dot x``.

    No other letter moves with it, also none of the other rates, and none is a term of its own, as a potential is.
    """
    letters = vocabulary.letters_of(tree)
    rate = _by_bare(sorted(letters)).get(_with_dot(below), "")
    derived = rf"\partial{above}/\partial{_bare(rate)}" in map(_bare, occurring)
    moving = {other for other in occurring if _with_dot(other) in map(_bare, letters)} - {below}
    trees = [tree, *(each.tree for each in vocabulary.used_in(tree))]
    alone = letters & {lone(term) for each in trees for term in terms_of(each)}
    is_apart = not (alone or vocabulary.moves_with(letters - {rate} | moving, below))
    return below if derived and _PLAIN.fullmatch(below) and is_apart else ""


def _of_summed(symbol: str, match: re.Match[str], vocabulary: Vocabulary) -> Definition | None:
    """Return a partial derivative by a letter that is summed in the formula of a function, or in what others stand for.

    Nothing else in the formula depends on the letter, at any index.  It stands in one formula alone, or in others: it
    might be meant at fixed values of these.
    """
    sign, order, above, below = match.groups()
    definition = vocabulary.definitions.get(_by_bare(vocabulary.definitions).get(re.sub(r"\(.*\)$", "", above), ""))
    if sign == "d" or order or definition is None or not definition.usable or definition.role == "case":
        return None
    letter, _, script = below.partition("_")
    trees = definition.tree, *(each.tree for each in vocabulary.used_in(definition.tree))
    head = _by_bare(_head_of(each) for tree in trees for each in symbols_in(tree)).get(letter, "")
    variable = written(head, 0, script, "")
    moving = {
        each
        for each in {*vocabulary.definitions, *vocabulary.dependence.equated}
        if head in map(_head_of, vocabulary.behind(each) - {each})
    }
    used = {each.symbol: each for each in vocabulary.used_in(definition.tree) if _head_of(each.symbol) != head}
    through = {name: each.tree for name, each in used.items() if name in moving and not each.parameters}
    used_by = [symbols_in(each) for each in (definition.tree, *through.values())]
    twice = any(head in map(_head_of, each) and not through.keys().isdisjoint(each) for each in used_by)
    tree = filled(definition.tree, through)
    heads = {*map(_head_of, moving)}
    others = (each for each in map(_head_of, symbols_in(tree)) if each != head or not script)
    if not head or twice or vocabulary.is_matrix(variable) or not heads.isdisjoint(others):
        return None
    rate = by_summed(tree, variable, vocabulary.hidden_in)
    if rate is None:
        return None
    places = " with ".join(dict.fromkeys([definition.where, *(used[each].where for each in through)]))
    where = f", where {vocabulary.name(variable)} is in the range of its sum, and at other indices does{UNCHANGED}"
    made = _made(symbol, rate, definition, [], vocabulary)
    return replace(made, where=f"the derivative of {places}{where if script else ''}", role="case")


def _head_of(symbol: str) -> str:
    """Return the letter of a symbol without its scripts."""
    return "" if " " in symbol or "/" in symbol else split_symbol(symbol)[0]


def _of_two(symbol: str, mixed: re.Match[str], vocabulary: Vocabulary) -> Definition | None:
    """Return a derivative by two letters, one after the other."""
    above, first, second = mixed.groups()
    matches = [_DERIVATIVE.fullmatch(rf"\partial{above}/\partial{below}") for below in (first, second)]
    outer, inner = (match and _of_quotient(symbol, match, vocabulary) for match in matches)
    return replace(inner, tree=Tree("slope", [inner.tree, outer.tree.children[1]])) if outer and inner else None


def _as_dots(symbol: str, match: re.Match[str], occurring: frozenset[str]) -> Definition | None:
    r"""Return a derivative by t as the letter with dots, as in ``\frac{dx}{dt} = \dot x``; None if there is none."""
    sign, order, above, below = match.groups()
    dotted = {None: _with_dot(above), "^2": _with_dot(_with_dot(above))}.get(order, "")
    rate = _by_bare(sorted(occurring)).get(dotted) if (sign, below) == ("d", "t") else None
    return Definition(symbol, (), letter_of(rate), "a dot as the derivative by t", -1, True) if rate else None


def _of_prime(symbol: str, vocabulary: Vocabulary) -> Definition | None:
    """Return the derivative of a function of one letter."""
    letter, primes, below, above = split_symbol(symbol)
    definition = vocabulary.definitions.get(written(letter, 0, below, above))
    if definition is None or len(definition.parameters) != 1:
        return None
    return _of_function(symbol, definition, primes, vocabulary)


def _of_function(symbol: str, definition: Definition, order: int, vocabulary: Vocabulary) -> Definition | None:
    """Return the first or a higher derivative of a function of one letter."""
    (variable,) = definition.parameters
    if not definition.usable or any(
        variable in vocabulary.letters_of(each.tree) for each in vocabulary.used_in(definition.tree)
    ):
        return None
    value: Formula = Tree("call", [Token("CALLEE", definition.symbol), Tree("items", [letter_of(variable)])])
    for _ in range(order):
        value = slope_of(value, variable)
    try:
        vocabulary.value(value)
    except UNCOMPUTED:
        return None
    others = sorted(vocabulary.letters_of(definition.tree) - {variable})
    if vocabulary.depends(others, variable):
        return None
    return replace(_made(symbol, value, definition, others, vocabulary), parameters=(variable,))


def _of_time(symbol: str, vocabulary: Vocabulary, occurring: frozenset[str]) -> Definition | None:
    r"""Return the derivative by its dots of a function of t, as ``\ddot x(t)`` of ``x(t)``, or of what has a t.

    A dot on a function of another letter is taken for the derivative by this letter, if that has no dot itself.
    """
    known, bare, dots = _by_bare(vocabulary.definitions), _without_dot(symbol), 1
    while bare and bare not in known:
        bare, dots = _without_dot(bare), dots + 1
    definition = vocabulary.definitions.get(known.get(bare, ""))
    if definition is not None and not definition.parameters and dots > 1:
        return _of_the_time(symbol, definition, dots, vocabulary, occurring)
    if definition is None or len(definition.parameters) != 1:
        return None
    (variable,) = definition.parameters
    made = _of_function(symbol, definition, dots, vocabulary)
    if made is None or variable == "t":
        return made
    where = f"{made.where}, with a dot as the derivative by {vocabulary.name(variable)}"
    moves = _with_dot(variable) in map(_bare, occurring)
    return None if moves else replace(made, where=where, role="case")


def _of_the_time(
    symbol: str, definition: Definition, dots: int, vocabulary: Vocabulary, occurring: frozenset[str]
) -> Definition | None:
    """Return a higher derivative by time of what t alone changes."""
    letters = vocabulary.letters_of(definition.tree)
    others = sorted(letters - {"t"})
    known = {_bare(each) for each in occurring}
    changes = any(_with_dot(each) in known for each in others) or vocabulary.moves_with(others, "t")
    if "t" not in letters or changes or not (definition.usable and vocabulary.dependence.by_time):
        return None
    value = letter_of(definition.symbol)
    for _ in range(dots):
        value = slope_of(value, "t")
    return _made(symbol, value, definition, others, vocabulary)


def _rate(symbol: str, function: str, vocabulary: Vocabulary, occurring: frozenset[str]) -> Definition | None:
    definition = vocabulary.definitions[function]
    if definition.parameters or not definition.usable:
        return None
    rates = _by_bare(sorted(occurring))
    terms: list[Formula] = []
    constant: list[str] = []
    for letter in sorted(vocabulary.letters_of(definition.tree)):
        rate = rates.get(_with_dot(letter))
        if rate == symbol:
            return None
        if rate is not None:
            terms.append(Tree("run", [slope_of(letter_of(function), letter), letter_of(rate)]))
        elif letter == "t" and vocabulary.dependence.by_time:
            terms.append(slope_of(letter_of(function), letter))
        elif not (_without_dot(letter) and vocabulary.is_zero(slope_of(letter_of(function), letter))):
            constant.append(letter)
    timed = "t" in vocabulary.letters_of(definition.tree)
    of_motion = _is_of_motion(occurring) and not any(map(_without_dot, constant))
    fixed = timed or _are_constant(constant, vocabulary) or of_motion
    if not terms or vocabulary.depends(constant, "t") or not fixed:
        return None
    signed: list[Any] = [part for term in terms for part in (Token("SIGN", "+"), term)]
    return _made(symbol, Tree("sum", signed), definition, constant, vocabulary)


def _made(
    symbol: str, tree: Formula, definition: Definition, constant: list[str], vocabulary: Vocabulary
) -> Definition:
    where = f"the derivative of {definition.where}{unchanged(constant, vocabulary)}"
    return Definition(symbol, (), tree, where, definition.part, True, place=definition.place, words=definition.words)


def unchanged(letters: Sequence[str], vocabulary: Vocabulary) -> str:
    """Return the words that some letters do not change; empty for no letters."""
    verb = "does" if len(letters) == 1 else "do"
    return f", where {', '.join(map(vocabulary.name, letters))} {verb}{UNCHANGED}" if letters else ""


def _by_bare(symbols: Iterable[str]) -> dict[str, str]:
    return {_bare(each): each for each in symbols}


def is_rate_of_one(symbol: str, letters: Iterable[str]) -> bool:
    """Whether a letter with dots is the derivative of one of some letters."""
    bare, names = _without_dot(symbol), _by_bare(letters)
    return bool(bare) and (bare in names or is_rate_of_one(bare, letters))


@cache
def _bare(symbol: str) -> str:
    """Return a symbol without braces, and with its dots first."""
    bare = re.sub(r"\\mathbf\\(d*dot)", r"\\\1\\mathbf", bare_name(symbol))
    return re.sub(r"\^(?:\\prime)+", lambda primes: "'" * primes[0].count("p"), bare)


def _without_dot(symbol: str) -> str:
    r"""Return the bare symbol of which one may be the derivative by time; empty for none.

    Examples
    --------
    >>> _without_dot(r"\dot{r}_1"), _without_dot(r"\mathbf{\ddot r}"), _without_dot("r")
    ('r_1', '\\dot\\mathbfr', '')
    """
    bare = _bare(symbol)
    return bare[4:] if bare.startswith(r"\dot") else rf"\dot{bare[5:]}" if bare.startswith(r"\ddot") else ""


def _with_dot(symbol: str) -> str:
    """Return the bare symbol of the derivative by time."""
    bare = _bare(symbol)
    return rf"\d{bare[1:]}" if re.match(r"\\d*dot", bare) else rf"\dot{bare}"
