"""What a document has said up to an equation: definitions, premises, and the words beside it."""

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from itertools import pairwise

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import letters_of_symbol, speaks_of
from algebroproj_sym.reading.defining.notation import is_rate_of_one, order_of
from algebroproj_sym.reading.defining.premises import Premise
from algebroproj_sym.reading.defining.recognising import (
    EQUALITIES,
    defined_by,
)
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.documents.displays import Display
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in
from algebroproj_sym.reading.prose.citing import apart_in, cited_in
from algebroproj_sym.reading.prose.contexts import ANYWHERE
from algebroproj_sym.reading.prose.scopes import Scopes
from algebroproj_sym.reading.prose.sentences import (
    are_of_two_things,
    last_sentence,
    words_of,
)
from algebroproj_sym.reading.prose.words import Beside
from algebroproj_sym.reading.remembering.survey import Survey

Known = Premise | Definition
MOST_WITHIN = 12
"""How many formulas within the text before an equation may stand in its sentence."""


class Memory:
    """What was said so far, and what of it still holds."""

    def __init__(self, survey: Survey) -> None:
        self.survey = survey
        self.given = survey.given
        self.vocabulary = survey.vocabulary()
        self.vocabulary.regard(*survey.kinds_in(0))
        self.asserted: dict[str, int] = {}
        self.seen = set[str]()
        self.equated = set[str]()
        self.order = 0
        self.above = frozenset[str]()
        self.within: list[tuple[str, Premise]] = []
        self.closed = set[str]()
        self.premises: list[Premise] = []
        self.stated: list[tuple[str, Premise]] = []
        self.alone: dict[str, int] = {}
        self.given_at: dict[str, int] = {}
        self.tied = set[str]()
        self.named: dict[tuple[str, int], frozenset[str]] = {}
        self.open: dict[str, int] = {}
        self.summed: list[Premise] = []
        self.introduced = False
        self.context = ANYWHERE
        self.held = ANYWHERE
        self.held_at = -1
        self.cases: dict[int, frozenset[str]] = {}
        self.over = set[int]()
        self.ranges: tuple[Parsed, ...] = ()
        self.scopes = Scopes()
        self.supposed = set[int]()
        self.conditions = set[int]()
        self.sentences: dict[int, str] = {}
        self.arithmetic = ""
        self.optimizes = False
        self.denied = False
        self.running = set[int]()
        self.part = 0
        self.valued = set[str]()
        self.beside = Beside("", "", "", "", False, 0, 0, True)
        self.display: Display | None = None
        self.carried = ""
        self.ended = True

    def forget_all(self, is_over: Callable[[Known], bool]) -> None:
        """Forget the equations and definitions that hold no longer, and what rests on them."""
        self.premises = [each for each in self.premises if not is_over(each)]
        for symbol in [each.symbol for each in self.vocabulary.definitions.values() if is_over(each)]:
            if symbol in self.vocabulary.definitions:
                self.vocabulary.drop(symbol)

    def forget(self, symbol: str) -> None:
        """Forget what was said of a letter, and with it."""
        self.forget_all(lambda each: speaks_of(symbols_of(each), symbol))

    def is_named(self, statement: Statement, names: frozenset[str]) -> bool:
        """Whether a statement is one of those that the symbols file names."""
        return bool(names & {statement.number, statement.label, str(statement.display.where), "all"} - {""})

    @property
    def given_letters(self) -> frozenset[str]:
        """The letters that have a definition, or a value in the symbols file."""
        return frozenset((*self.vocabulary.definitions, *self.given.whole.symbols))

    @property
    def restricted(self) -> frozenset[str]:
        """Likewise, and those that are said to be equal to something, or in some relation."""
        return self.given_letters | self.tied

    def state(self, statement: Statement, formula: Parsed) -> None:
        """Keep an equation that a sentence states within the text, if nothing above it says what its letter is."""
        lone = _lone_in(formula)
        if lone.isdisjoint(self.given_at) and lone.isdisjoint(self.vocabulary.definitions):
            words = words_of(last_sentence(statement.display.before))
            given = self.premises_of(statement, formula, formula.sides)
            latex = f"${statement.display.latex}$"
            self.stated += [(latex, replace(each, special=True, words=words)) for each in given]

    def give_anew(self, formula: Parsed) -> None:
        """Forget what was stated within the text of letters that an equation gives."""
        if formula.relations:
            self.stated = [each for each in self.stated if _lone_in(formula).isdisjoint(each[1].symbols)]

    def note(self, statement: Statement, formula: Parsed) -> None:
        """Take notice of the letters of a statement, and of those that are alone on a side."""
        for side in formula.sides:
            if formula.relations:
                self.given_at[defined_by(side)[0]] = statement.display.place
            for symbol in symbols_in(side):
                self.asserted.setdefault(symbol, statement.display.place)

    def tie(self, sides: Collection[Formula]) -> None:
        """Take notice of the letters of sides that are said to be equal, or in some relation."""
        self.tied.update(symbol for side in sides for symbol in symbols_in(side))

    def ties(self, definition: Definition) -> bool:
        """Whether a definition may follow from what is above it: words say so, or an equation has its letter.

        So does an equation with a derivative of it, or with that of which it is one.
        """
        known = self.vocabulary.definitions
        above: list[Known] = [*self.premises, *known.values()]
        used = frozenset().union(*(each.symbols for each in above))
        variables = (*definition.parameters, "t")
        derived = (order_of(each, definition.symbol, variable) for each in used.union(known) for variable in variables)
        has = definition.symbol in used or any(derived) or is_rate_of_one(definition.symbol, known)
        return self.beside.follows or (has and not definition.explicit)

    def leave_open(self, formula: Parsed, part: int) -> None:
        """Take notice of the letters of an equation of which nothing is decided, in a part of the document."""
        self.open |= {symbol: part for side in formula.sides for symbol in symbols_in(side)}

    def said_before(self, symbols: Collection[str], place: int) -> frozenset[str]:
        """Return those of some letters of which a display before a place said something."""
        return frozenset(each for each in symbols if self.asserted.get(each, place) != place)

    def restate(self, formula: Parsed) -> None:
        """Take notice that a letter with a definition is given within the text, and otherwise."""
        for side in formula.sides:
            known = self.vocabulary.definitions.get(defined_by(side)[0])
            if known is not None and known.tree not in formula.sides and formula.relations[0] in EQUALITIES:
                self.vocabulary.define(replace(known, role="case"))

    def is_of_one_index(self, formula: Parsed) -> bool:
        """Whether an equation with an index holds for one value of it, which the words give."""
        symbols = (symbol for side in formula.sides for symbol in symbols_in(side))
        return bool(self.context.fixed) and any(self.context.fixed in letters_of_symbol(each) for each in symbols)

    def premises_of(self, statement: Statement, formula: Parsed, sides: Sequence[Formula]) -> list[Premise]:
        """Return the equations between sides of a statement: of those next to each other, and of the first and last."""
        pairs = [*(pairwise(sides) if len(sides) > 2 else ()), *([(sides[0], sides[-1])] if len(sides) > 1 else ())]
        names = frozenset((statement.number, statement.label)) - {""}
        special = bool(self.beside.case_of_premise)
        display, words = statement.display, self.beside.words
        given = where_of(statement), display.part, display.place, names, special, words
        chained = len(formula.sides) > 2
        held = self.context, self.ranges
        return [Premise(left, right, *given, chained, *held) for left, right in pairs]

    def tells_of_another(self, known: Known, letters: frozenset[str]) -> bool:
        """Whether an equation above one of some letters is of no others, and says the same of another thing."""
        symbols = symbols_of(known)
        here = self.sentences.get(self.beside.place, "")
        return symbols <= letters and are_of_two_things(self.sentences.get(known.place, ""), here)

    def _is_of_some(self, known: Known) -> bool:
        """Whether an equation gives a number to a letter that is any here, or holds in a case of it."""
        symbols = symbols_of(known)
        return bool(symbols & self.beside.quantified) and (len(symbols) == 1 or known.context.is_case)

    def _is_over(self, place: int) -> bool:
        """Whether a display was the condition of a sentence that has ended, or of a case that has."""
        here = None if self.display is None else self.display.place
        return place in self.over or (place in self.conditions - self.running and here not in (None, place))

    def _is_of_other_kinds(self, known: Known) -> bool:
        """Whether an equation of another section has a letter that is a number there and none here, or vice versa."""
        here, there = (self.survey.kinds_in(part)[1] for part in (self.part, known.part))
        return not symbols_of(known).isdisjoint(here ^ there)

    def known_here(self, letters: frozenset[str]) -> Vocabulary:
        """Return what letters stand for where an equation of some letters stands.

        Left out are definitions of another context, of another thing, conditions, numbers of letters that are any, and
        what rests on exchanged letters; but not what words cite.
        """
        found = self.vocabulary.copied()
        for known in [*found.definitions.values()]:
            over = self._is_over(known.place) and not is_cited(known, self.cited)
            if self._is_of_some(known) or over or self._is_of_other_kinds(known):
                del found.definitions[known.symbol]
        found.forget()
        for known in [*found.definitions.values()]:
            elsewhere = self.context.excludes(known.context) and not is_cited(known, self.cited)
            elsewhere = elsewhere or is_cited(known, self.apart) or self.tells_of_another(known, letters)
            elsewhere = elsewhere or bool(self.beside.exchanged & symbols_of(known))
            if elsewhere and known.symbol in found.definitions:
                found.drop(known.symbol)
        return found

    @property
    def is_item(self) -> bool:
        """Whether another item of a list begins before the display, and what it says is not said to follow."""
        new = self.display is not None and r"\item" in self.display.before
        return new and not self.beside.follows

    @property
    def cited(self) -> frozenset[str]:
        """The labels and numbers of the equations that words before the display name."""
        return cited_in(self.display.before) if self.display is not None else frozenset()

    @property
    def apart(self) -> frozenset[str]:
        """Likewise of those of which the words say that it is not so here."""
        return apart_in(self.display.before) if self.display is not None else frozenset()

    @property
    def serving(self) -> list[Premise]:
        """The premises that do not belong to another context, and those that words cite."""
        return self.serving_of([*self.premises, *(each for _, each in self.stated)])

    def serving_of(self, known: Sequence[Premise]) -> list[Premise]:
        """Return the equations that do not belong to another context, and those that words cite."""
        cited, changed = self.cited, self.beside.exchanged
        return [
            each
            for each in known
            if not (changed & each.symbols or is_cited(each, self.apart) or self._is_of_some(each))
            and not self._is_of_other_kinds(each)
            and (is_cited(each, cited) or not (self.context.excludes(each.context) or self._is_over(each.place)))
        ]


def symbols_of(known: Known) -> set[str]:
    """Return the symbols of an equation, or of a definition with its letter."""
    return {*known.symbols, *([known.symbol] if isinstance(known, Definition) else [])}


def is_cited(known: Known, names: Collection[str]) -> bool:
    """Whether some labels and numbers name an equation, or the one that defines a letter."""
    if isinstance(known, Premise):
        return not known.names.isdisjoint(names)
    return known.where.startswith(tuple(f"({name})" for name in names))


def _lone_in(formula: Parsed) -> set[str]:
    return {defined_by(side)[0] for side in formula.sides} - {""}


def where_of(statement: Statement) -> str:
    """Return the number, or the label, and the line of a statement."""
    number = statement.number or statement.label
    where = str(statement.display.where)
    return f"({number}), {where}" if number else where
