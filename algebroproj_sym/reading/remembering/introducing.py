"""Which equations say what a letter is, so that there is nothing to check."""

import re
from dataclasses import replace
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import free_symbols, letters_in
from algebroproj_sym.reading.defining.notation import bare, derivative_in
from algebroproj_sym.reading.defining.premises import Premise, letter_of, neighbours, sides_of
from algebroproj_sym.reading.defining.recognising import (
    EQUALITIES,
    argument_of,
    computes,
    defined_by,
    given_by,
    introduced_by,
    is_arithmetic,
    is_case_of,
    is_circular,
    is_indexed_above,
    is_matrix,
    is_named,
    is_one_value,
    is_step,
    is_table,
    named_on_left,
    operations_in,
    says_more_than_a_number,
    value_on_left,
    values_in,
    without_numbers,
    without_others,
    without_own_indices,
    without_power,
)
from algebroproj_sym.reading.defining.twists import tells_hat
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.derivatives import derivatives_in
from algebroproj_sym.reading.deriving.instances import numbers_put_in
from algebroproj_sym.reading.deriving.rates import ZERO
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.parsing.factors import terms_of
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, lone, put_in, symbols_in, tokens_in, trees_in
from algebroproj_sym.reading.prose.meanings import CHANGES
from algebroproj_sym.reading.prose.words import beside
from algebroproj_sym.reading.remembering.memory import Memory, is_cited, where_of


def definition_in(memory: Memory, statement: Statement, formula: Parsed, *, explicit: bool) -> Definition | None:
    """Return what a statement defines: a letter, or a function of letters, of which nothing was asserted before."""
    if not formula.relations or formula.relations[0] not in EQUALITIES:
        return None
    relation = formula.relations[0]
    left, right = formula.sides[:2] if relation != "=:" else (formula.sides[1], formula.sides[0])
    symbol, parameters = defined_by(left)
    if not symbol or _gives_nothing(memory, statement, left) or symbol in memory.given.whole.symbols:
        return None
    if memory.is_of_one_index(formula) or (symbol == r"\pi" and not symbols_in(right)):
        return None
    explicit = explicit or relation in (":=", "=:") or memory.is_named(statement, memory.given.definitions)
    table = is_table(symbol, right, memory.vocabulary)
    if (
        memory.beside.is_denied
        or (memory.beside.is_conditional and not (explicit or table))
        or (not explicit and is_one_value(parameters, right))
    ):
        return None
    late = explicit or memory.introduced or table
    used = bool(memory.said_before((symbol,), statement.display.place)) and not late
    again = symbol in memory.vocabulary.definitions and relation not in (":=", "=:")
    if used or again or is_circular(symbol, right, memory.vocabulary):
        return None
    if not explicit and _is_derivative(memory, left):
        return None
    given = symbol, parameters, right, where_of(statement), statement.display.part
    words, place = beside(statement, "").words, statement.display.place
    made = Definition(*given, explicit, not statement.condition, place=place, words=words, context=memory.context)
    return replace(made, usable=made.usable and computes(made, memory.vocabulary), holds=made.usable)


def tells(memory: Memory, statement: Statement, formula: Parsed, index: int) -> bool:
    """Whether a relation of a chain says what its left side is, so that there is nothing to check.

    So does one that names the entries of a matrix: ``x = (q, u) = (a, b, c, d)``, and one that puts numbers in.
    """
    left, right = formula.sides[index], formula.sides[index + 1]
    if _gives_nothing(memory, statement, left):
        return False
    others = [left] if index > 0 else _said_of(memory, left) if not symbols_in(right) else []
    first = index == 0 or (index == 1 and defined_by(left)[0] not in {"", *memory.asserted})
    return (
        (index == 0 and _introduces(memory, statement, formula))
        or (
            is_matrix(right)
            and (index > 0 or _may_be_listed(memory, right))
            and _are_new(memory, introduced_by(right), left, statement)
        )
        or (first and _gives(memory, statement, left, right))
        or _is_free(memory, left, right, value=index > 0)
        or _is_new_value(memory, left, right)
        or (
            memory.survey.shows_components(left, right, statement.display.place)
            and {*symbols_in(left), *symbols_in(right)}.isdisjoint(memory.vocabulary.definitions)
        )
        or (index == 0 and _is_told(memory, left, right))
        or any(_is_instance(memory, each, right) for each in others)
        or (index == 0 and (_brings(memory, left, right) or _is_rate(memory, left, right)))
        or ":=" in formula.relations[index:]
        or tells_hat(left, right)
    )


def relates_new_letters(memory: Memory, formula: Parsed, index: int) -> bool:
    """Whether a side of a link has letters that nothing restricts, and the other one has not: it says what they are.

    Equations that use a letter to give theirs do not restrict it.  A number is a condition, and an operation in a
    circle may stand between two equations.  Letters over which a sum or an integral runs are none, nor are
    derivatives, nor is the identity.
    """
    left, right = sides = formula.sides[index : index + 2]
    if formula.relations[index] not in EQUALITIES or operations_in(left) or not says_more_than_a_number(right):
        return False
    known = memory.given_letters.union(memory.seen & memory.tied, *map(_bound_in, sides))
    ours, theirs = ({*symbols_in(each)} - known for each in sides)
    new = ours ^ theirs
    if memory.vocabulary.with_identity(left, right) is not None:
        new = {each for each in new if not memory.vocabulary.is_like_identity(each)}
    new -= {*memory.survey.applied}
    return any(memory.vocabulary.constant(each) is None and not CHANGES.search(each) for each in new)


def says_on_what_it_depends(formula: Parsed) -> bool:
    """Whether an equation says of which letters another one is a function, and no more, as ``f = f(x, y)``."""
    if formula.relations != ("=",) or not (letter := lone(formula.sides[0])):
        return False
    right = formula.sides[1]
    if right.data == "call":
        return right.children[0] == letter and all(map(lone, trees_in(trees_in(right)[0])))
    factors = trees_in(right) if right.data == "run" else []
    return [each.data for each in factors] == ["symbol", "bracket"] and lone(factors[0]) == letter


def split_again(vocabulary: Vocabulary, formula: Parsed) -> None:
    r"""Let ``S = s + p I`` give s where the next equation gives p by S, as ``p = \frac13 \mathrm{tr}(S)`` does."""
    symbol = defined_by(formula.sides[0])[0] if formula.relations[:1] == ("=",) else ""
    if not symbol or symbol in vocabulary.definitions:
        return
    for known in (vocabulary.definitions.get(each) for each in symbols_in(formula.sides[1])):
        if known is None or known.parameters or not known.usable or symbol not in known.symbols:
            continue
        terms = terms_of(known.tree)
        known_here = {"", symbol, *vocabulary.definitions}
        alone = [each for each in map(lone, terms) if not (each in known_here or vocabulary.is_like_identity(each))]
        rest = put_in(known.tree, {letter_of(alone[0]): ZERO}) if len(alone) == 1 else None
        if rest is not None and alone[0] not in symbols_in(rest) and _has_plus(known.tree, alone[0]):
            del vocabulary.definitions[known.symbol]
            vocabulary.forget()
            signed: list[Any] = [Token("SIGN", "+"), letter_of(known.symbol), Token("SIGN", "-"), Tree("group", [rest])]
            vocabulary.define(replace(known, symbol=alone[0], tree=Tree("sum", signed)))
            return


def _has_plus(tree: Formula, letter: str) -> bool:
    """Whether a letter is added in a sum that has no other sums within."""
    parts = [*tree.children]
    place = next((place for place, each in enumerate(parts) if isinstance(each, Tree) and lone(each) == letter), -1)
    return place == 0 or (place > 0 and str(parts[place - 1]) == "+")


def is_condition_on(left: Formula, right: Formula) -> bool:
    """Whether what a letter has just been said to be is zero, as in ``r = y - a x = 0``: that is a condition."""
    zero = re.fullmatch(r"(?:\\math[a-z]+\{)?0\}?", " ".join(tokens_in(right))) is not None
    return zero and bool(symbols_in(left))


def _bound_in(tree: Formula) -> set[str]:
    """Return the letters in the limits of sums and integrals, and those by which is integrated."""
    limits = (letters_in(str(each.children[0])) for each in tree.find_data("big"))
    steps = {each for each in symbols_in(tree) if each.startswith("d ")}
    return steps.union((each.removeprefix("d ") for each in steps), *limits)


def _may_be_listed(memory: Memory, table: Formula) -> bool:
    """Whether nothing has the entries of a matrix that a letter is said to have, and no words doubt it."""
    return memory.seen.isdisjoint(introduced_by(table)) and not memory.beside.is_condition


def _are_new(memory: Memory, symbols: frozenset[str], other: Formula, statement: Statement) -> bool:
    """Whether nothing was said of letters before, and the other side does not have them."""
    elsewhere = memory.given_letters.union(symbols_in(other))
    return bool(symbols) and not symbols & elsewhere and not memory.said_before(symbols, statement.display.place)


def _gives_nothing(memory: Memory, statement: Statement, left: Formula) -> bool:
    r"""Whether an equation gives no letter, whatever it looks like.

    Words reject it, or letters are not what they were in its sentence.  Or the symbols file says so.  Or its left side
    is what an operator makes of something, as ``\nabla \cdot u``.
    """
    of_operator = not introduced_by(left).isdisjoint(memory.survey.applied)
    refused = memory.beside.is_rejected or bool(memory.beside.exchanged)
    return refused or of_operator or memory.is_named(statement, memory.given.statements)


def _is_derivative(memory: Memory, left: Formula) -> bool:
    """Whether a side is a derivative of what is defined, or has one."""
    return bool(derivatives_in((left,), memory.vocabulary, memory.survey.occurring))


def _introduces(memory: Memory, statement: Statement, formula: Parsed) -> bool:
    """Whether an equation says what something is of which nothing was said before, though perhaps in a case."""
    left, right = formula.sides[:2] if formula.relations[0] != "=:" else formula.sides[1::-1]
    if formula.relations[0] in (":=", "=:"):
        return True
    parameters = defined_by(left)[1]
    values = [str(each.children[0]) for each in left.iter_subtrees() if each.data == "call"]
    value = not defined_by(right)[0] and (bool(parameters) or all(map(memory.survey.has_one_argument, values)))
    one_value = is_one_value(parameters, right) and not memory.survey.are_variables(parameters)
    everywhere = not values or (bool(parameters) and not one_value)
    return (
        _are_new(memory, introduced_by(left), right, statement)
        and (everywhere or value)
        and bool(symbols_in(right))
        and not _is_derivative(memory, left)
        and not memory.beside.is_supposed
    )


def gives_if_open(memory: Memory, statement: Statement, formula: Parsed) -> bool:
    """Whether an equation gives its letter if nothing tells whether it follows.

    A letter that equations above it give is given anew by new letters alone, and by nothing that is said to follow.
    """
    left, right = formula.sides[:2]
    known = memory.vocabulary.definitions.get(_letter_of(left)[0])
    above = [*_said_of(memory, left), *([known.tree] if known else [])]
    old = {symbol for each in above for symbol in symbols_in(each)}
    again = bool(above) and not begins_anew(memory, right)
    again = again and (memory.beside.follows or {*symbols_in(right)} <= old)
    inside = known is not None and _base_of(left) is not left and not memory.survey.meanings.is_label(left)
    renames = memory.beside.follows and bool(defined_by(right)[0])
    excluded = again or inside or renames or _gives_nothing(memory, statement, left)
    return not excluded and _may_give(memory, statement, left, right)


def names_its_letter(memory: Memory, statement: Statement, formula: Parsed) -> bool:
    """Whether the left side of an equation is one letter, whatever stands at it, or a value that no equation above has.

    Then it says what the letter is, though nobody may be able to compute it.  Such an equation is no premise.
    """
    left, right = formula.sides[:2]
    used = memory.equated.union(memory.given.whole.symbols, symbols_in(right), operations_in(right))
    return (
        not _gives_nothing(memory, statement, left)
        and (
            named_on_left(left) not in used | {""}
            or value_on_left(left) not in {"", *memory.equated, *values_in(right)}
        )
        and formula.relations[0] in EQUALITIES
        and says_more_than_a_number(right)
        and not is_case_of(defined_by(left)[1], right)
        and not (_is_derivative(memory, left) or memory.beside.is_condition)
    )


def begins_anew(memory: Memory, right: Formula) -> bool:
    """Whether nothing above an equation can say anything of it: its value has a letter of which nothing was said.

    So does an item of a list, which speaks of another thing than the items above it.
    """
    return memory.is_item or not {*symbols_in(right)} <= memory.seen | {*memory.vocabulary.definitions}


def _may_give(memory: Memory, statement: Statement, left: Formula, right: Formula) -> bool:
    """Whether a letter stands alone on the left of an equation that is no condition, and that may say what it is."""
    symbol, parameters = _letter_of(left)
    if not symbol or symbol in memory.given.whole.symbols:
        return False
    if not (says_more_than_a_number(right) or memory.survey.is_parameter(statement)):
        return False
    is_case = is_case_of(parameters, right) and not memory.survey.are_variables(parameters)
    elsewhere = memory.alone.get(given_by(_base_of(left)), statement.display.part) != statement.display.part
    is_case = is_case and not elsewhere and (symbol in memory.asserted or not memory.survey.has_one_argument(symbol))
    power = without_power(left) is not left and not memory.survey.meanings.is_label(left)
    if (is_case and not memory.beside.defines) or (power and (symbol in memory.given_at or _has_alone(memory, left))):
        return False
    if not memory.beside.defines:
        condition = memory.beside.is_condition and not memory.beside.names
        if condition or _is_derivative(memory, left):
            return False
    others = without_others(left, without_own_indices(left, right))
    by_more = others == right or says_more_than_a_number(others)
    circular = is_circular(symbol, others, memory.vocabulary)
    return by_more and not (circular and is_circular(symbol, others, _known_here(memory)))


def _has_alone(memory: Memory, power: Formula) -> bool:
    """Whether an equation above gives a power, or has its letter without it."""
    above = sides_of(memory.premises)
    above += [each.tree for each in memory.vocabulary.definitions.values()]
    others = {symbol for each in above for symbol in symbols_in(put_in(each, {power: Tree("number", [])}))}
    return power in above or not others.isdisjoint(symbols_in(power))


def _known_here(memory: Memory) -> Vocabulary:
    """Return what the letters stand for by the section that is read, and by what words cite."""
    known = memory.vocabulary.definitions.values()
    here = (each for each in known if each.part in (memory.part, 0) or is_cited(each, memory.cited))
    return memory.vocabulary.changed(definitions={each.symbol: each for each in here})


def _base_of(left: Formula) -> Formula:
    """Return what a left side is a power or a function of; else the side itself."""
    return without_power(left) if without_power(left) is not left else argument_of(left)


def _letter_of(left: Formula) -> tuple[str, tuple[str, ...]]:
    """Return the letter that a left side is, or is a power or a function of, and its parameters."""
    base = _base_of(left)
    return (str(base.children[0]), ()) if is_named(base) else defined_by(base)


def _gives(memory: Memory, statement: Statement, left: Formula, right: Formula) -> bool:
    """Whether an equation is the first one of its section that gives its letter, though the letter was used before.

    It may not hold but roughly.  Where an equation near it may give the letter as well, its sentence must say that it
    is introduced.
    """
    part = statement.display.part
    if is_indexed_above(left) or is_step(left, right):
        above = any(left in each.sides and each.part == part for each in memory.premises)
        return not (above or memory.beside.case_of_sentence or left in right.iter_subtrees() or not symbols_in(right))
    if not (gives := _may_give(memory, statement, left, right)) or memory.beside.defines:
        return gives
    symbol, _ = _letter_of(left)
    known = memory.vocabulary.definitions.get(symbol)
    near = neighbours(memory.premises, part, memory.cited)
    tied = any(symbol in each.symbols and not _gives_a_letter(memory, each) for each in near)
    tied = tied or memory.open.get(symbol) == part
    told = memory.beside.names or memory.introduced
    here = (known is not None and known.part == part) or memory.alone.get(given_by(_base_of(left))) == part
    other = memory.beside.strange(_words_beside(memory, symbol, part)) and not memory.beside.case_of_sentence
    anew = bool(other) or (not memory.cited and (memory.beside.names or memory.beside.renews))
    anew = anew and not memory.beside.follows
    if memory.beside.case_of_sentence and (known or symbol in memory.tied):
        return False
    return not ((tied and not told) or (here and not anew))


def _gives_a_letter(memory: Memory, premise: Premise) -> bool:
    """Whether a premise gives a letter, or the value of a function of which nothing else is said."""
    value = premise.at_vector
    return premise.gives is not None or (value is not None and value.symbol not in memory.vocabulary.definitions)


def _words_beside(memory: Memory, symbol: str, part: int) -> frozenset[str]:
    """Return the words beside what a section has said of a letter."""
    known = memory.vocabulary.definitions.get(symbol)
    said = [known.words] if known is not None and known.part == part else []
    said += [each.words for each in memory.premises if each.part == part and symbol in each.symbols]
    return frozenset().union(*said)


def _is_free(memory: Memory, left: Formula, right: Formula, *, value: bool) -> bool:
    """Whether nothing above an equation restricts what stands on its left, so that it can only say what it is.

    A letter that other equations use to give theirs is not restricted by them.  The value of a function at one place
    counts where wished for: in a chain, whose first side it gives.
    """
    symbols, calls = introduced_by(left), any(each.data == "call" for each in left.iter_subtrees())
    function, parameters = defined_by(without_numbers(left))
    alone = bool(parameters) and memory.survey.has_one_argument(function)
    everywhere = alone or (bool(parameters) and not is_case_of(parameters, right))
    return (
        bool(symbols)
        and (value or everywhere or not calls)
        and not symbols & memory.restricted.union(symbols_in(right))
        and (says_more_than_a_number(right) or is_arithmetic(right) or alone)
        and not any(is_circular(each, right, memory.vocabulary) for each in symbols)
        and not (_is_derivative(memory, left) or memory.beside.is_condition)
    )


def _is_new_value(memory: Memory, left: Formula, right: Formula) -> bool:
    r"""Whether the length or the mean of something is given the first time, as in ``\langle x \rangle = x_1 + x_2``."""
    value = without_power(left)
    weighted = value.data == "marked" and str(value.children[1]).startswith("_")
    value = value.children[0] if weighted else value  # type: ignore[assignment]
    is_value = value.data == "norm" or (
        value.data == "inner" and all(len(each.children) == 1 for each in trees_in(value))
    )
    above = sides_of(memory.premises)
    return (
        is_value
        and bool(symbols_in(right))
        and not (value.data == "norm" and not weighted and {*symbols_in(value)} & {*symbols_in(right)})
        and not any(value == part for side in (right, *above) for part in side.iter_subtrees())
        and not (memory.beside.follows or memory.beside.is_condition)
    )


def _is_told(memory: Memory, left: Formula, right: Formula) -> bool:
    """Whether words say what a formula with a new letter is, as in "The displacement is $r - s = a b$"."""
    return (
        (memory.beside.tells or (memory.beside.defines and left.data in ("inner", "run")))
        and not defined_by(left)[0]
        and not any(part.data in ("opaque", "slope") for part in left.iter_subtrees())
        and bool({*symbols_in(left)}.difference(memory.restricted, symbols_in(right)) or left.data == "inner")
        and says_more_than_a_number(right)
        and not _is_derivative(memory, left)
        and not (memory.beside.follows or memory.beside.is_condition or memory.beside.is_denied)
    )


def _brings(memory: Memory, left: Formula, right: Formula) -> bool:
    r"""Whether an equation says what new letters are by one that is known, as ``x = \bar x + e``.

    A condition says nothing, nor does one value of a function.  A column says nothing of the entries of another one.
    """
    new = {*symbols_in(right)} - {*memory.seen, *memory.given.whole.symbols, *symbols_in(left)}
    new -= {each for part in right.find_data(left.data) if left.data == "matrix" for each in symbols_in(part)}
    given = not introduced_by(left).isdisjoint(memory.given_at)
    return (
        bool(new)
        and left.data != "marked"
        and bool(introduced_by(left))
        and not introduced_by(left) & {*symbols_in(right)}
        and not (is_case_of(defined_by(left)[1], right) or (left.data == "call" and not defined_by(left)[0]))
        and not (_is_derivative(memory, left) or memory.beside.case_of_sentence or memory.beside.is_denied)
        and not (given and memory.beside.follows)
    )


def _is_rate(memory: Memory, left: Formula, right: Formula) -> bool:
    r"""Whether a letter that nothing restricts is said to be a derivative, as in ``\frac{dx}{dt} = v``."""
    symbol = defined_by(right)[0]
    return (
        symbol not in memory.restricted.union(free_symbols(left), ("", r"\infty"))
        and symbol not in " ".join(tokens_in(left, "OPAQUE"))
        and (left.data in ("opaque", "slope") or "'" in named_on_left(left))
        and not _is_of_what_is_given(memory, left)
        and not (memory.beside.follows or memory.beside.is_condition or memory.beside.is_denied)
    )


def _is_of_what_is_given(memory: Memory, left: Formula) -> bool:
    """Whether a derivative is that of a letter that an equation gives: what it is equal to is a claim."""
    slope = derivative_in(" ".join(tokens_in(left, "OPAQUE")))
    return slope is not None and slope.function in map(bare, memory.vocabulary.definitions)


def _said_of(memory: Memory, left: Formula) -> list[Formula]:
    """Return what equations above give as a letter."""
    symbol, parameters = defined_by(left)
    known = memory.vocabulary.definitions.get(symbol)
    pairs = [pair for each in memory.serving for pair in each.both_ways]
    given = [known.tree] if known and not (known.parameters or parameters) else []
    return given + [other for one, other in pairs if symbol and one == left]


def _is_instance(memory: Memory, left: Formula, right: Formula) -> bool:
    """Whether numbers are put in for letters that have no value: the equation gives them, in this case."""
    given = numbers_put_in(left, right)
    return bool(given) and not any(
        known.usable and not memory.vocabulary.letters_of(known.tree)
        for symbol in given
        if (known := memory.vocabulary.definitions.get(symbol))
    )


def is_only_one(memory: Memory, definition: Definition) -> bool:
    """Whether a letter is given by letters, and by no other equation of the document."""
    ties = memory.survey.dependence.ties
    return bool(definition.symbols) and sum(tie.given == definition.symbol for tie in ties) == 1
