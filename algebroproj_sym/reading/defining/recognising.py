"""Which equations define a letter, and of which letter an equation speaks."""

import re
from collections.abc import Sequence

from lark import Token, Tree

from algebroproj_sym.expressions import require_bounded
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import letters_in, letters_of_symbol
from algebroproj_sym.reading.defining.letters import has_shape
from algebroproj_sym.reading.defining.vocabulary import UNCOMPUTED, Vocabulary
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.parsing.grammar import (
    UNSEEN,
    Formula,
    lone,
    put_in,
    symbols_in,
    tokens_in,
    trees_in,
    without_brackets,
)

_NAME = re.compile(r"(?:[a-zA-Z]{2,}|[EPV]|\\math(?:bb|ds)\{[EPV]\})(?:_.*)?")
_VALUES = re.compile(r"(?:[a-zA-Z]{2,}|E|\\math(?:bb|ds)\{E\})(?:_.*)?")
"""Names of which one value may be given by others; no probability, and no value of a state."""
_RANDOM = re.compile(r"[XYZ](?:_.*)?")
_OPERATOR = re.compile(r"\\math(?:cal|scr|frak)(?![a-zA-Z])")
_STEP = re.compile(r"[a-su-z]( [-+] \d(?: \d)?)?")
EQUALITIES = ("=", ":=", "=:", "≡")
"""The relations that say that two sides are equal."""


def defined_by(tree: Formula) -> tuple[str, tuple[str, ...]]:
    """Return the letter that is a side of its own, and its parameters if it is a function of letters."""
    tree = without_brackets(tree)
    if tree.data == "symbol":
        return str(tree.children[0]), ()
    if tree.data == "call":
        name, arguments = tree.children
        inside = arguments.children if isinstance(arguments, Tree) else []
        parameters = [defined_by(each)[0] if isinstance(each, Tree) else "" for each in inside]
        if all(parameters) and len({*parameters}) == len(parameters):
            return str(name), tuple(parameters)
    return "", ()


def without_power(tree: Formula) -> Formula:
    """Return what a side is a power of, with a number above it."""
    base, exponent = tree.children if tree.data == "power" else (tree, tree)
    return base if isinstance(base, Tree) and isinstance(exponent, Tree) and not symbols_in(exponent) else tree


def without_numbers(tree: Formula) -> Formula:
    """Return the value of a function of which a side is a multiple."""
    *numbers, last = trees_in(tree) or [tree]
    is_multiple = tree.data == "run" and last.data == "call" and all(each.data == "number" for each in numbers)
    return last if is_multiple else tree


def is_matrix(tree: Formula) -> bool:
    """Whether a side is a printed matrix, perhaps transposed."""
    tree = without_brackets(tree)
    return tree.data == "matrix" or (tree.data == "marked" and is_matrix(tree.children[0]))  # type: ignore[arg-type]


def introduced_by(tree: Formula) -> frozenset[str]:
    r"""Return the letters that a left side may introduce; empty if it is none that does.

    ``W(e^{it})``, ``2 W(t)``, ``x^T`` and ``\ln L`` introduce W, x and L, and a printed column all of its entries.  So
    do ``(a, b)``, and T, of a column in brackets.
    """
    tree = argument_of(tree)
    items = trees_in(trees_in(tree)[0]) if tree.data == "bracket" and trees_in(tree) else []
    if len(items) > 1:
        inside = [*map(introduced_by, items)]
        return frozenset().union(*inside) if all(inside) else frozenset()
    if symbol := defined_by(tree)[0]:
        return frozenset((symbol,))
    if tree.data == "call":
        return frozenset((str(tree.children[0]),))
    if tree.data == "matrix":
        entries = [introduced_by(part) for cell in tree.find_data("cell") for part in cell.children]  # type: ignore[arg-type]
        return frozenset().union(*entries) if all(entries) else frozenset()
    if (bare := without_numbers(tree)) is not tree:
        return introduced_by(bare)
    is_map = tree.data == "run" and [each.data for each in trees_in(tree)] == ["symbol", "bracket"]
    if is_map and (columns := [*tree.find_data("matrix")]) and all(map(introduced_by, columns)):
        return introduced_by(trees_in(tree)[0])
    return introduced_by(tree.children[0]) if tree.data == "marked" else frozenset()  # type: ignore[arg-type]


def named_on_left(tree: Formula) -> str:
    r"""Return the letter that a side is, with whatever stands at it and in brackets behind it; empty for none.

    Of an operator in calligraphic style it is the operator, and of two letters with an operation the operation.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> sides = r"\mathcal{C}_s^N(F)", r"\chi^2(m, b)", r"(\mathcal{D} u)(t)", r"x \oplus y", "2 x", "x y"
    >>> [named_on_left(parsed(f"{each} = a").sides[0]) for each in sides]
    ['\\mathcal{C}_s', '\\chi', '\\mathcal{D}', 'oplus', '', '']
    """
    tree = without_brackets(tree)
    parts, first = trees_in(tree), tree.children[0]
    if tree.data == "symbol" or (tree.data == "call" and isinstance(first, Token)):
        return str(first)
    if tree.data == "product" and len(parts) == 2 and (operations := operations_in(tree)):
        return operations[0] if parts[0] != parts[1] and all(defined_by(each)[0] for each in parts) else ""
    letter = next(iter(symbols_in(tree)), "")
    if tree.data == "run" and parts[-1].data in ("bracket", "call") and _OPERATOR.match(letter):
        return letter
    applied = tree.data == "run" and [each.data for each in parts[1:]] == ["bracket"]
    return named_on_left(parts[0]) if parts and (applied or tree.data in ("power", "marked")) else ""


def value_on_left(tree: Formula) -> str:
    r"""Return a side as text if it is a value of its own, though its letter may have others; empty for none.

    So is the value of a named function, an entry of a letter, and a letter with an index above it.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> sides = r"E[X_1]", r"(a, b)_{rs}", r"V_t^0(a)", r"E[T]^{[r]}", "f(x)", "x^2"
    >>> [value_on_left(parsed(f"{each} = a", functions=()).sides[0]) for each in sides]
    ['call E X_1', 'marked a b _rs', 'power V_t 0', 'power E T r', '', '']
    """
    tree = without_brackets(tree)
    if tree.data == "run" and [each.data for each in trees_in(tree)] == ["power", "bracket"]:
        tree = trees_in(tree)[0]
    entry = tree.data == "marked" and str(tree.children[-1]).startswith("_")
    return _as_text(tree) if has_values(tree) or entry or _has_index(tree) else ""


def values_in(tree: Formula) -> list[str]:
    """Return all that may be a value of its own in a formula, as text: without its index it is another one."""
    indexed = [each.children[0] for each in tree.iter_subtrees() if _has_index(each)]
    values = (each for each in tree.iter_subtrees() if each.data in ("call", "marked", "power"))
    return [_as_text(each) for each in values if not any(each is base for base in indexed)]


def _has_index(tree: Formula) -> bool:
    """Whether a formula is a value with an index above it, in brackets or not."""
    exponent = tree.children[1] if tree.data == "power" else None
    return isinstance(exponent, Tree) and (exponent.data == "bracket" or is_indexed_above(tree) or _is_zero(exponent))


def _is_zero(tree: Formula) -> bool:
    return tree.data == "number" and tree.children == ["0"]


def _as_text(tree: Formula) -> str:
    return " ".join([tree.data, *tokens_in(tree)])


def operations_in(tree: Formula) -> list[str]:
    r"""Return the operations in circles that stand in a formula, such as the one of ``x \oplus y``."""
    return tokens_in(tree, "CIRCLED")


def is_named(tree: Formula) -> bool:
    """Whether a side is the value of a function with a name of its own, such as Var(X): the value is what is given.

    So is the entropy H(X), or h(X), of a random variable X, Y or Z.
    """
    if tree.data != "call":
        return False
    head, random = str(tree.children[0]), all(map(_RANDOM.fullmatch, defined_by(tree)[1] or ("",)))
    return _NAME.fullmatch(head) is not None or (head in ("H", "h", "I") and random)


def has_values(tree: Formula) -> bool:
    """Whether a side is the value of a named function, such as E(X), that other values of it may give."""
    return tree.data == "call" and _VALUES.fullmatch(str(tree.children[0])) is not None and bool(defined_by(tree)[0])


def given_by(tree: Formula) -> str:
    """Return the letter that is a side of its own, or the value of a named function, as text; empty for neither."""
    symbol, _ = defined_by(tree)
    if not is_named(tree):
        return symbol
    return f"{tree.children[0]} {' '.join(tokens_in(tree))}"


def argument_of(tree: Formula) -> Formula:
    r"""Return the letter of which a side is a function, as in ``\ln L`` and ``- 2 \ln L``; else the side itself."""
    *others, last = trees_in(tree) or [tree]
    if tree.data in ("sum", "run") and all(each.data == "number" for each in others) and _has_no_plus(tree):
        found = argument_of(last)
        return tree if found is last else found
    inside = tree.children[-1] if tree.data == "function" else None
    lone = isinstance(inside, Tree) and len(inside.children) == 1 and defined_by(inside)[0]
    return inside if isinstance(inside, Tree) and lone else tree


def _has_no_plus(tree: Formula) -> bool:
    return tree.data == "run" or len(trees_in(tree)) == 1


def is_indexed_above(tree: Formula) -> bool:
    r"""Whether a side is a letter with an index above it, as in ``w_t^n`` and ``x^{k+1}``, and hardly a power.

    So is the value of a function of which the index stands before the argument, as in ``f^p(x)``, and a list of such.
    """
    parts = trees_in(tree)
    if tree.data == "bracket" and len(items := trees_in(parts[0])) > 1:
        return all(map(is_indexed_above, items))
    applied = tree.data == "run" and [each.data for each in parts] == ["power", "bracket"]
    tree = parts[0] if applied else tree
    base, exponent = tree.children if tree.data == "power" else (tree, tree)
    exponent = without_brackets(exponent, UNSEEN)
    if not (isinstance(base, Tree) and isinstance(exponent, Tree)) or base.data != "symbol" or base is exponent:
        return False
    if r"\mathbf{" in str(base.children[0]) and lone(exponent):
        return True
    step = _STEP.fullmatch(" ".join(tokens_in(exponent)))
    return (
        step is not None
        and base.children[0] != "e"
        and (applied or step[1] is not None or "_" in str(base.children[0]))
    )


def is_step(left: Formula, right: Formula) -> bool:
    r"""Whether an equation steps to the next value of a function, as ``v(t + \Delta t) = v(t)`` does.

    ``f(x + h) = f(x) + h`` need be none: it may be the formula of Taylor.
    """
    inside = trees_in(left.children[1]) if left.data == "call" else []  # type: ignore[arg-type]
    terms = trees_in(inside[0]) if len(inside) == 1 and inside[0].data == "sum" else []
    steps = any(each.data == "number" or str(each.children[0]).startswith(r"\Delta") for each in terms)
    return steps and any(
        str(each.children[0]) == str(left.children[0]) and each != left for each in right.find_data("call")
    )


def is_one_value(parameters: tuple[str, ...], value: Formula) -> bool:
    """Whether an equation such as y(a) = b says one value of a function, and not what it is everywhere."""
    limits = (letters_in(str(each.children[0])) for each in value.find_data("big"))
    symbols = {*symbols_in(value)}.union(*limits)
    return bool(parameters) and not {*parameters} & symbols and not any("/" in each for each in symbols)


def is_value_of_itself(left: Formula, right: Formula) -> bool:
    """Whether a letter is at a value of its own, as in "where ``t = t_0`` is the start": it stands for more of them.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> [is_value_of_itself(*parsed(each).sides) for each in ("t = t_0", "t = s_0", "t_1 = t_0")]
    [True, False, False]
    """
    symbol, value = defined_by(left)[0], defined_by(right)[0]
    return bool(symbol) and symbol != value and split_symbol(value)[0] == symbol


def is_symmetry(left: Formula, right: Formula) -> bool:
    """Whether two sides are a letter with its indices in two orders: that they are equal gives neither.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> [is_symmetry(*parsed(each).sides) for each in ("a_{ij} = a_{ji}", "a_{ij} = b_{ji}", "a_{ij} = a_{kj}")]
    [True, False, False]
    """
    one, other = defined_by(left)[0], defined_by(right)[0]
    if not one or not other or "/" in one + other:
        return False
    (letter, primes, below, above), (like, others, under, over) = split_symbol(one), split_symbol(other)
    return (letter, primes, above) == (like, others, over) and sorted(below) == sorted(under)


def is_case_of(parameters: tuple[str, ...], value: Formula) -> bool:
    """Whether an equation says one value of a function, and its value names the argument nowhere.

    It does so in ``R(q) = a q_1 + b q_2``, also of a bold q, and in the conditions of a distinction of cases.
    """
    if _has_cases(value):
        return False
    scripts = frozenset[str]().union(*map(letters_of_symbol, symbols_in(value)))
    tokens = [each for each in value.scan_values(lambda each: isinstance(each, Token)) if isinstance(each, Token)]
    shown = _thin(" ".join(each for each in tokens if each.type in ("CONDITION", "SHOWN") or " " in each))
    entries = {_thin(split_symbol(each)[0]) for each in symbols_in(value)}
    named = any(each in scripts or _thin(each) in entries or re.search(_alone(each), shown) for each in parameters)
    return is_one_value(parameters, value) and not named


def _alone(symbol: str) -> str:
    """Return a pattern for a letter among others, in whatever style."""
    return rf"(?<![a-zA-Z\\]){re.escape(_thin(symbol))}(?![a-zA-Z])"


def _thin(symbol: str) -> str:
    """Return letters without their style: that of a vector is the one of its entries."""
    return re.sub(r"[{}]|\\(?:math[a-z]+|boldsymbol|bm|vec)(?![a-z])", "", symbol).strip()


def says_more_than_a_number(value: Formula) -> bool:
    """Whether a value has letters, entries or cases, or is a set or the like, which is only shown; no bold zero has."""
    return (
        any(_thin(each) != "0" for each in symbols_in(value))
        or is_matrix(value)
        or value.data == "shown"
        or _has_cases(value)
    )


def _has_cases(value: Formula) -> bool:
    return any(True for _ in value.find_data("cases"))


def is_arithmetic(value: Formula) -> bool:
    """Whether a value is of several numbers, and of no letter."""
    return len(tokens_in(value, "NUMBER")) > 1 and not symbols_in(value)


def is_table(symbol: str, value: Formula, vocabulary: Vocabulary) -> bool:
    """Whether a value is a printed matrix, and the letter for it has no size yet: it cannot have been a condition."""
    return is_matrix(value) and vocabulary.size_of(symbol) is None


def is_circular(symbol: str, value: Formula, vocabulary: Vocabulary) -> bool:
    """Whether a value depends on the letter that it would define."""
    used = {each.symbol for each in vocabulary.used_in(value)}
    return symbol in used | {*symbols_in(value)} | vocabulary.letters_of(value)


def without_others(left: Formula, value: Formula) -> Formula:
    """Return a value without what the letter on its left is not: p(x, y) and p(0) beside p(x), and its length.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> [str(without_others(*parsed(each).sides).data) for each in ("x = |x|", "x = |y|")]
    ['number', 'absolute']
    """
    symbol, parameters = defined_by(left)
    if value.data == "call" and str(value.children[0]) == symbol:
        inside = trees_in(value.children[1])  # type: ignore[arg-type]
        if len(inside) != len(parameters) or not any(map(symbols_in, inside)) or (has_values(left) and value != left):
            return _OTHER
    if value.data == "cases" and parameters:
        value = put_in(value, {Tree("symbol", [Token("SYMBOL", symbol)]): _OTHER})
    if value.data in ("norm", "absolute") and not parameters and [*symbols_in(value)] == [symbol]:
        return Tree("number", [Token("NUMBER", "1")])
    return Tree(value.data, [without_others(left, x) if isinstance(x, Tree) else x for x in value.children])


_OTHER: Formula = Tree("symbol", [Token("SYMBOL", r"\mathrm{other}")])


def without_own_indices(left: Formula, value: Formula) -> Formula:
    r"""Return a matrix or a list without its own letter where an index stands above it, as in ``a = (a^1, a^2)``.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> [[*symbols_in(without_own_indices(*parsed(each).sides))] for each in ("a = (a^1, b)", "a = b a^1")]
    [['\\mathrm{other}', 'b'], ['b', 'a']]
    """
    symbol, parameters = defined_by(left)
    is_list = value.data == "bracket" and len(trees_in(trees_in(value)[0])) > 1
    own = bool(symbol) and not parameters and (is_list or is_matrix(value))
    powers = (each for each in value.find_data("power") if defined_by(trees_in(each)[0])[0] == symbol)
    return put_in(value, dict.fromkeys(powers, _OTHER)) if own else value


def is_update(left: Formula, right: Formula) -> bool:
    """Whether the right side adds to the letter on the left, or multiplies it, as in ``x = x - a g``: no equation."""
    given = defined_by(left)
    terms = [each for each in right.children if isinstance(each, Tree)] if right.data == "sum" else [right]
    factors = (each.children if each.data in ("run", "product") else [each] for each in terms)
    return bool(given[0]) and any(
        defined_by(each) == given for parts in factors for each in parts if isinstance(each, Tree)
    )


def computes(definition: Definition, vocabulary: Vocabulary) -> bool:
    """Whether what a definition says is a value or a function, and not only read, or known without it."""
    if definition.symbol == r"\Gamma" and vocabulary.gamma:
        return False
    if definition.parameters:
        return True
    try:
        require_bounded(vocabulary.value(definition.tree), definition.symbol)
    except UNCOMPUTED:
        return has_shape(vocabulary, definition.tree)
    return True


def is_reordered(one: Formula, other: Formula) -> bool:
    r"""Whether two products are of the same letters in another order: of numbers, nobody says that it follows.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> [is_reordered(*parsed(each).sides) for each in ("A B = B A", "a b = a b", "2 a b = 2 b a")]
    [True, False, False]
    """
    factors, others = ([str(part) for part in each.children] if each.data == "run" else [] for each in (one, other))
    lone = all(isinstance(part, Tree) and part.data in ("symbol", "call") for part in one.children)
    return lone and len(factors) > 1 and factors != others and sorted(factors) == sorted(others)


def differ_in_one_letter(some: Sequence[Formula], others: Sequence[Formula]) -> bool:
    """Whether formulas differ in one letter, as ``h - a = 0`` and ``h - b = 0``: they may be of two cases."""
    pairs = [
        pair
        for one, other in zip(some, others, strict=True)
        for pair in zip(*([str(each) for each in tree.scan_values(bool)] for tree in (one, other)), strict=False)
    ]
    renamed = {pair for pair in pairs if pair[0] != pair[1]}
    if len(renamed) != 1:
        return False
    before, now = (Tree("symbol", [Token("SYMBOL", each)]) for each in renamed.pop())
    return [put_in(each, {before: now}) for each in some] == [*others]
