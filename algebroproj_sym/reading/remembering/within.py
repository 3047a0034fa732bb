"""Formulas within the text: what they define, state and explain."""

import re
from dataclasses import replace

from algebroproj_sym.reading.defining.recognising import (
    defined_by,
    is_one_value,
    is_value_of_itself,
    says_more_than_a_number,
    without_power,
)
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in
from algebroproj_sym.reading.prose.sentences import last_sentence
from algebroproj_sym.reading.prose.supposing import goes_on_with, is_denied_behind, leads_elsewhere, states
from algebroproj_sym.reading.prose.words import (
    ASKS,
    CASES,
    SAYS,
    beside,
    ends_clause,
    has_ended,
    is_example,
    is_given_within,
    is_item,
)
from algebroproj_sym.reading.remembering.hearing import leave, stand_at
from algebroproj_sym.reading.remembering.introducing import definition_in, is_only_one
from algebroproj_sym.reading.remembering.memory import MOST_WITHIN, Memory

_BEGINS = re.compile(r"(?:\A|[.,;]|\band)\s*(?:[Ww]here|[Ii]n which)\s*\Z")
"""How a clause begins that says what something is: not as in "points where"."""


def take_within(memory: Memory, statement: Statement, formula: Parsed) -> None:
    """Take in a formula within the text: it may define its letter, be a premise, or state something."""
    if memory.survey.meanings.reason(statement, formula):
        return
    formula = formula.without_set()
    leave(memory, statement.display)
    restricts = _restricts_new(memory, statement, formula)
    says = _is_said(statement, formula, restricts=restricts)
    stand_at(memory, statement.display)
    at_value = len(formula.sides) == 2 and is_value_of_itself(*formula.sides)
    if len(formula.sides) == 2 and not at_value and (says or _is_stated(statement)):
        _give_or_restrict(memory, statement, formula, says=says, restricts=restricts)
    memory.give_anew(formula)
    words, equal = beside(statement, ""), {*formula.relations} == {"="}
    number = not any(map(symbols_in, formula.sides[1:]))
    if equal and not at_value and states(words, statement.display, number=number):
        memory.state(statement, formula)
    if formula.relations and not at_value:
        memory.note(statement, formula)
        _explain(memory, statement.display.before, formula)
        memory.tie(formula.sides)
        memory.restate(formula)
    if equal:
        latex = f"${statement.display.latex}$"
        memory.within += [(latex, each) for each in memory.premises_of(statement, formula, formula.sides)]
        del memory.within[:-MOST_WITHIN]


def _is_number(formula: Parsed) -> bool:
    """Whether there is a number behind the first side."""
    return {symbol for side in formula.sides[1:] for symbol in symbols_in(side)} <= {r"\pi"}


def _is_said(statement: Statement, formula: Parsed, *, restricts: bool) -> bool:
    """Whether words plainly say that an equation within the text holds."""
    before, after = statement.display.before, statement.display.after
    sentence, number = last_sentence(before), _is_number(formula)
    elsewhere = number and (leads_elsewhere(after) or is_example(sentence, after))
    denied = beside(statement, "").is_denied or is_denied_behind(after)
    asserted = not (elsewhere or denied or ASKS.match(sentence))
    return asserted and is_given_within(before, number=number and not restricts)


def _is_stated(statement: Statement) -> bool:
    """Whether a sentence with an equation within the text may say what its letter is, if nothing else does."""
    before, after = statement.display.before, statement.display.after
    stated = SAYS.search(before) is not None or is_item(before, after)
    return stated and not (is_denied_behind(after) or CASES.search(last_sentence(before)))


def _give_or_restrict(memory: Memory, statement: Statement, formula: Parsed, *, says: bool, restricts: bool) -> None:
    """Take an equation for the definition of its letter, or for a premise, if it is one of these."""
    definition = definition_in(memory, statement, formula, explicit=says)
    if definition is not None:
        known = definition.symbol in memory.vocabulary.definitions
        single = says or is_only_one(memory, definition)
        if single and not (known or is_one_value(definition.parameters, definition.tree)):
            memory.vocabulary.define(definition)
            if _is_number(formula) or (beside(statement, "").supposes and definition.symbol in memory.seen):
                memory.valued.add(definition.symbol)
        return
    introduces = restricts or _introduces_within(memory, formula, statement.display.before)
    if says and introduces and ends_clause(statement.display):
        given = memory.premises_of(statement, formula, formula.sides)
        memory.premises += [replace(each, special=False) for each in given]


def _explain(memory: Memory, before: str, formula: Parsed) -> None:
    """Take what the sentence of the last display goes on to say of its letters for what they were in it."""
    above = memory.display
    if above is not None and goes_on_with(before, ended=has_ended(above)):
        memory.given_at |= dict.fromkeys((defined_by(side)[0] for side in formula.sides), above.place)


def _introduces_within(memory: Memory, formula: Parsed, before: str) -> bool:
    r"""Whether an equation within the text says what a new letter is, though not alone: "where $L L^T = K$".

    So does "where $e^2 = 2 f - f^2$" of the square of a letter that no equation gives.
    """
    lone = [symbol for side in formula.sides if (symbol := defined_by(side)[0])]
    new = {*symbols_in(formula.sides[0])} - {*memory.asserted, *memory.vocabulary.definitions}
    if formula.relations == ("=",) and len(formula.sides) == 2 and _gives_a_square(memory, *formula.sides):
        return _BEGINS.search(before) is not None
    if formula.relations != ("=",) or len(lone) != 1 or not new:
        return False
    return lone[0] not in new and memory.vocabulary.is_matrix(lone[0])


def _restricts_new(memory: Memory, statement: Statement, formula: Parsed) -> bool:
    """Whether an equation within the text is of letters that its sentence introduces: "with $a^2 + b^2 = 1$"."""
    sentence = last_sentence(statement.display.before)
    same = (each.display for each in memory.survey.statements[max(0, memory.order - MOST_WITHIN) : memory.order - 1])
    places = {each.place for each in same if f"${each.latex}$" in sentence}
    letters = {symbol for side in formula.sides for symbol in symbols_in(side)}
    return len(letters) > 1 and {memory.asserted.get(each) for each in letters} <= places


def _gives_a_square(memory: Memory, left: Formula, right: Formula) -> bool:
    base = without_power(left)
    symbol = defined_by(base)[0]
    given = {*memory.given_at, *memory.vocabulary.definitions, *symbols_in(right), ""}
    return base is not left and symbol not in given and says_more_than_a_number(right)
