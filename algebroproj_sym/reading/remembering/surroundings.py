"""What the sentence of a display says around it: what it supposes, explains, and in which range it holds."""

import re
from collections.abc import Iterator
from dataclasses import replace

from algebroproj_sym.reading.defining.domains import range_in, ranges_said
from algebroproj_sym.reading.defining.premises import Premise, sides_of
from algebroproj_sym.reading.defining.recognising import defined_by
from algebroproj_sym.reading.documents.displays import Display
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in
from algebroproj_sym.reading.prose.sentences import last_sentence
from algebroproj_sym.reading.prose.supposing import goes_on_in_display, goes_on_with, names_behind, supposes
from algebroproj_sym.reading.prose.words import has_ended
from algebroproj_sym.reading.remembering.memory import MOST_WITHIN, Memory
from algebroproj_sym.reading.remembering.standing import Standing
from algebroproj_sym.reading.remembering.stationary import set_to_zero

_SAYS_THE_SAME = re.compile(r"(?:these|they|this|it) (?:is|are) (?:equivalent|equal|identical)\b")


def standing_at(memory: Memory, statement: Statement, formula: Parsed) -> Standing:
    """Return where a statement stands."""
    letters = frozenset(symbol for side in formula.sides for symbol in symbols_in(side))
    vocabulary = memory.known_here(letters)
    premises = [each for each in memory.serving if not memory.tells_of_another(each, letters)]
    place = statement.display.part, premises, memory.cited
    own = [*supposed(memory), *_explained_behind(memory)]
    free = sorted(letters.difference(memory.vocabulary.definitions))
    own += set_to_zero(memory.beside, premises, free, _place_above(memory))
    summed = memory.serving_of(memory.summed)
    return Standing(memory.survey, vocabulary, memory.beside, *place, memory.given_at, own, summed)


def supposed(memory: Memory) -> list[Premise]:
    """Return the equations within the text that the sentence of the display supposes before it."""
    return [each for words, each in memory.within if supposes(memory.beside, words)]


def is_supposed(memory: Memory, side: Formula) -> bool:
    """Whether these give a side of the display, or have its value: the prover is asked whether it follows."""
    gives = {each.gives.symbol for each in supposed(memory) if each.gives}
    values = [part for one in sides_of(supposed(memory)) for part in one.iter_subtrees()]
    return defined_by(side)[0] in gives or (side.data in ("function", "call") and side in values)


def _place_above(memory: Memory) -> int:
    """Return where the display above the one that is read begins, or above the first one of its sentence."""
    displays = (each.display for each in memory.survey.statements[: memory.order][::-1])
    below = memory.display
    for each in displays:
        if each.environment != "inline" and each is not below:
            if below is None or below.before.strip():
                return each.place
            below = each
    return -1


def ranges_beside(memory: Memory, display: Display, formula: Parsed) -> Iterator[Parsed]:
    """Yield the ranges that stand in a display, and within the text in its sentence."""
    before, behind = last_sentence(display.before), display.after.partition(".")[0]
    parameters = defined_by(formula.sides[0])[1]
    yield from ranges_said(f"{before} . {behind}", parameters[0] if len(parameters) == 1 else "")
    for each in memory.survey.statements[max(0, memory.order - MOST_WITHIN) : memory.order + MOST_WITHIN]:
        within = f"${each.display.latex}$"
        inline = each.display.environment == "inline" and (within in before or within in behind)
        if each.display is display or (inline and each.display.part == display.part):
            found = range_in(each, memory.survey.formulas[id(each)])
            if found is not None:
                yield found


def _explained_behind(memory: Memory) -> Iterator[Premise]:
    r"""Yield the equations with which the sentence of a display goes on: "where $w^2 = k/m$", "where \[a = b\]"."""
    following = memory.survey.statements[memory.order : memory.order + MOST_WITHIN]
    here = memory.display
    ended = here is None or has_ended(here)
    above = here
    for each in following:
        found, display = memory.survey.formulas[id(each)], each.display
        if display.environment != "inline":
            if display is not above and not goes_on_in_display(display.before, first=above is here):
                return
            yield from _given_behind(memory, each, found)
            above = display
        elif above is not here or not goes_on_with(display.before, ended=ended):
            return
        elif (
            isinstance(found, Parsed) and {*found.relations} == {"="} and not memory.survey.meanings.reason(each, found)
        ):
            formula = f"${display.latex}$"
            behind = re.split(r"\.|\$|\\\(", display.after)[0].strip().removesuffix("and")
            behind = "" if _SAYS_THE_SAME.match(behind) else behind
            sentence = f"{display.before}{formula}{behind}"
            said = names_behind(sentence, formula, display.after) and defined_by(found.sides[0])[0]
            if said or supposes(replace(memory.beside, sentence=sentence), formula):
                yield from memory.premises_of(each, found, found.sides)


def _given_behind(memory: Memory, statement: Statement, formula: Parsed | UnreadableError) -> Iterator[Premise]:
    """Yield an equation of a display that says what a letter is of which nothing was said before."""
    if isinstance(formula, Parsed) and {*formula.relations} == {"="} and not statement.condition:
        symbol = defined_by(formula.sides[0])[0]
        known = {"", *memory.above, *memory.vocabulary.definitions, *symbols_in(formula.sides[1])}
        if symbol not in known and not memory.survey.meanings.reason(statement, formula):
            yield from memory.premises_of(statement, formula, formula.sides[:2])
