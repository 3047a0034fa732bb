"""Which equations are kept as premises, and what an equation that gives a letter anew puts an end to."""

from collections import Counter
from dataclasses import replace

from algebroproj_sym.reading.asking.sampling import agree, are_one_matrix, samples_of
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.notation import bare, derivative_in
from algebroproj_sym.reading.defining.premises import MOST_PREMISES, Premise, extended
from algebroproj_sym.reading.defining.recognising import (
    EQUALITIES,
    argument_of,
    computes,
    defined_by,
    differ_in_one_letter,
    given_by,
    introduced_by,
    is_circular,
    is_named,
    is_one_value,
    is_symmetry,
    is_update,
)
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in
from algebroproj_sym.reading.prose.conditions import is_condition
from algebroproj_sym.reading.prose.sentences import (
    words_of,
)
from algebroproj_sym.reading.remembering.memory import Known, Memory, where_of


def renew(memory: Memory, statement: Statement, formula: Parsed) -> None:
    """Forget what a letter was in another section or context, and what rests on it, where one gives it anew.

    It does if words say so, or if its value is another one of the same letters; one of other letters may be equal.
    The letter stands for the new value from there on, unless words speak of a case.  A function stays what it is where
    an equation of the letter alone is said to follow.
    """
    if not formula.relations or formula.relations[0] not in EQUALITIES:
        return
    left, value, part = formula.sides[0], formula.sides[1], statement.display.part
    symbol, parameters = defined_by(left)
    known = memory.vocabulary.definitions.get(symbol)
    before = known.part if known else memory.alone.get(given_by(left), part)
    said = known is not None and (known.parameters, known.tree) == (parameters, value)
    if not given_by(left) or said or memory.is_named(statement, memory.given.statements) or is_symmetry(left, value):
        return
    elsewhere = known is not None and (
        memory.context.excludes(known.context) or (known.part == part and bool(memory.beside.strange(known.words)))
    )
    if before == part and not (known and memory.beside.defines) and not elsewhere:
        return
    if known is not None and known.parameters and not parameters and memory.beside.follows:
        return
    older, recent = memory.premises[:-MOST_PREMISES], memory.premises[-MOST_PREMISES:]
    told = extended(memory.vocabulary, [each.gives for each in recent if each.gives and each.gives.symbol == symbol])
    others = [two for each in recent for one, two in each.both_ways if one == left]
    letters = told.letters_of(left, *(others if is_named(left) else []))
    theirs = memory.vocabulary.letters_of(value)
    if not (memory.beside.renews or elsewhere or letters <= theirs or theirs <= letters):
        return
    if not is_named(left) and (is_one_value(parameters, value) or agree(samples_of(told), (left, value))):
        return
    if known and memory.vocabulary.is_matrix(symbol) and are_one_matrix(memory.vocabulary, (left, value)):
        return
    memory.premises = older + [
        each
        for each in recent
        if (each.part == part and before != part)
        or not (left in each.sides if is_named(left) else symbol in each.symbols)
    ]
    if known is None:
        return
    memory.vocabulary.drop(symbol)
    if not (statement.condition or memory.beside.case() or is_circular(symbol, value, memory.vocabulary)):
        where, words = where_of(statement), memory.beside.words
        given = symbol, parameters, value, where, part, False
        apart = (known.apart | known.words) - words
        held = memory.beside.place, words, memory.context, apart, memory.ranges
        made = Definition(*given, True, "definition", *held)
        memory.vocabulary.define(replace(made, usable=computes(made, memory.vocabulary)))


def forget_other_functions(memory: Memory, formula: Parsed) -> None:
    r"""Forget what another section gives as a function of which a differential equation is stated: it is another one.

    Such is ``m \ddot x + k x = 0`` in a section on springs, below one in which x is where a stone flies.
    """
    if memory.beside.follows or memory.cited:
        return
    symbols = {symbol for side in formula.sides for symbol in symbols_in(side)}
    calls = {str(call.children[0]) for side in formula.sides for call in side.find_data("call")}
    derived = {symbol: each for symbol in symbols | calls if (each := derivative_in(symbol)) is not None}
    orders = {(each.head, len(each.letters)) for each in derived.values()}
    orders |= {(bare(each), 0) for each in (symbols | calls) - {*derived}}
    times = Counter(function for function, _ in orders)
    rates = {function for function, order in orders if order and times[function] > 1}
    for known in [*memory.vocabulary.definitions.values()]:
        if bare(known.symbol) in rates and known.part != memory.part:
            memory.forget(known.symbol)


def keep(memory: Memory, statement: Statement, formula: Parsed, *, defines: bool) -> None:
    """Keep an equation as a premise of what stands behind it."""
    if is_condition(memory.beside, formula):
        memory.conditions.add(statement.display.place)
    if memory.context.is_case:
        words = f"{memory.beside.before} {memory.beside.sentence} {memory.context.words}"
        memory.cases.setdefault(statement.display.place, words_of(words))
    formula = formula.without_set()
    if not formula.relations or statement.condition or {*formula.relations} - {*EQUALITIES}:
        return
    if memory.beside.exchanged or not memory.vocabulary.letters_of(*formula.sides):
        return
    if memory.beside.is_denied or is_update(*formula.sides[:2]) or memory.is_of_one_index(formula):
        return
    known = memory.vocabulary.definitions.get(defined_by(formula.sides[0])[0])
    if known and len(formula.sides) == 2 and differ_in_one_letter([known.tree], formula.sides[1:]):
        return
    found = memory.premises_of(statement, formula, formula.sides[defines:])
    if contended := [other for each in found for other in _contended(memory, each)]:
        for other in contended:
            if isinstance(other, Definition):
                memory.vocabulary.define(replace(other, role="case"))
        memory.premises = [replace(each, special=True) if each in contended else each for each in memory.premises]
        return
    if defines and len(formula.sides) > 2 and symbols_in(formula.sides[-1]):
        found += memory.premises_of(statement, formula, formula.sides)[-1:]
    for each in found:
        memory.premises.append(each)
        sides = map(argument_of, each.sides)
        memory.alone |= dict.fromkeys(map(given_by, sides), statement.display.part)


def _contended(memory: Memory, premise: Premise) -> list[Known]:
    r"""Return what gives otherwise what an equation gives, by the same letters or by some of them.

    Two values of other letters may be equal, as in ``F = -k x`` and ``F = m a``.  What an operator makes has one
    value: ``\nabla \cdot u`` is zero, or q in another case.
    """
    found: list[Known] = []
    for side, value in premise.both_ways:
        symbol, parameters = defined_by(side)
        known = memory.vocabulary.definitions.get(symbol)
        above: list[tuple[Known, Formula]]
        above = [(known, known.tree)] if known is not None and known.parameters == parameters else []
        above += [(each, two) for each in memory.serving for one, two in each.both_ways if one == side]
        for each, other in above if introduced_by(side) else ():
            near = each.place == premise.place
            is_other = symbol in memory.survey.applied and other != value
            if each.part == premise.part and (is_other or _contend(memory, other, value, near=near)):
                found.append(each)
    return found


def _contend(memory: Memory, one: Formula, other: Formula, *, near: bool) -> bool:
    """Whether values differ, and one has all letters of the other.

    In one display both have the same letters, or none more than one: its rows may be steps, in which letters go.
    That does not matter where words speak of several things, as in "The bounds are".
    """
    ours, theirs = map(memory.vocabulary.letters_of, (one, other))
    if near:
        tied = (bool(ours) and ours == theirs) or all(len([*symbols_in(each)]) < 2 for each in (one, other))
        tied = tied or memory.beside.lists
    else:
        tied = bool(ours and theirs) and (ours <= theirs or theirs <= ours)
    if one == other or not tied:
        return False
    samples = samples_of(memory.vocabulary)
    computed = all(agree(samples, (each, each)) for each in (one, other))
    return computed and not agree(samples, (one, other))
