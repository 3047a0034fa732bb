"""What a document has said up to an equation: definitions, premises, and the words beside it."""

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from itertools import pairwise

from algebroproj_sym.reading.asking.sampling import agree, are_one_matrix, samples_of
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import letters_of_symbol, speaks_of
from algebroproj_sym.reading.defining.notation import is_rate_of_one, order_of
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
    is_update,
)
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.documents.displays import HEADING, Display
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in
from algebroproj_sym.reading.prose.acting import acted_on, is_acted_on
from algebroproj_sym.reading.prose.citing import apart_in, cited_in
from algebroproj_sym.reading.prose.conditions import goes_on, is_condition
from algebroproj_sym.reading.prose.contexts import ANYWHERE, context_behind, last_context
from algebroproj_sym.reading.prose.describing import described, is_same, names_a_thing
from algebroproj_sym.reading.prose.devices import says
from algebroproj_sym.reading.prose.renaming import renamed_in
from algebroproj_sym.reading.prose.scopes import Scopes
from algebroproj_sym.reading.prose.sentences import (
    are_of_two_things,
    last_sentence,
    main_clause,
    sentences_of,
    strange_word,
    without_formulas,
    words_of,
)
from algebroproj_sym.reading.prose.words import Beside, arithmetic_in, beside, denies, has_ended, is_denied, takes_back
from algebroproj_sym.reading.remembering.survey import Survey

Known = Premise | Definition
MOST_WITHIN = 12
"""How many formulas within the text before an equation may stand in its sentence."""
_IS = re.compile(r"\b(?:is|are)\W*$")
_IS_THE = re.compile(r"\s*is (?:the|an?|its|our) [a-z]")
_NAMED = re.compile(r"(?<=[a-z] )[A-Z]\b")
"""The letter of a thing in the text, as in "model B"."""
_LIST = re.compile(r"\\begin\{(?:itemize|enumerate)\}")
_LIST_ENDS = re.compile(r"\\end\{(?:itemize|enumerate)\}")
_NOTE = re.compile(r"\\footnote\{([^{}]*)")
_ONLY = re.compile(r"\W*([^.$]*?) only\b")
"""Words behind an equation that limit it, as in "in the first case only"."""


class Memory:
    """What was said so far, and what of it still holds."""

    def __init__(self, survey: Survey) -> None:
        self.survey = survey
        self.given = survey.given
        self.vocabulary = survey.vocabulary()
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

    def leave(self, display: Display) -> None:
        """Forget what a quotation, an example or a theorem says where it ends, and the cases of another section."""
        if display.part != self.part:
            for symbol in self.valued & {*self.vocabulary.definitions}:
                del self.vocabulary.definitions[symbol]
            self.vocabulary.forget()
            self.valued.clear()
        self.scopes, ended, supposed = self.scopes.at(display)
        if ended:
            self._forget(lambda each: each.place >= min(ended))
        if supposed:
            self._forget(lambda each: each.place >= min(supposed) and each.place in self.supposed)

    def listen(self, statement: Statement) -> None:
        """Take in the words beside a statement."""
        display = statement.display
        if display is not self.display:
            self.leave(display)
        same_part = self.beside.part == display.part
        if display is not self.display:
            taken = (
                takes_back(display.before) or is_acted_on(display.before) or says(r"\b<same-letter>\b", display.before)
            )
            if self.display is not None and taken:
                last = self.display.place
                self._forget(lambda each: each.place == last)
            for symbol in acted_on(display.before):
                self.forget(symbol)
            self.carried = "" if self.ended or not same_part else self.beside.sentence
        before, self.display = self.display, display
        if display is not before:
            self._hear_of_all(display)
        self.beside = beside(statement, self.carried)
        if self.denied:
            self.beside = replace(self.beside, condition=f"{self.beside.condition} false")
        self.sentences[display.place] = last_sentence(display.before)
        own = display.before.rpartition(HEADING)[2]
        self.arithmetic = arithmetic_in(f"{own} {self.beside.behind}") or (self.arithmetic if same_part else "")
        self.optimizes = says(r"\b<optimizes>", own) or (same_part and self.optimizes)
        if before is not display:
            self._end_cases(display)
            self._keep_stated(display)
        if before is not None and before is not display:
            same = bool(self.carried) and last_sentence(display.before) == display.before.rstrip()
            same = same and r"\item" not in display.before
            above = {before.place} if same or goes_on(self.beside) else set()
            self.running = above | (self.running if same or self.beside.follows else set())
        if self.beside.supposes:
            self.supposed.add(display.place)
        self.stand_at(display)
        marked = {each for each in self.survey.occurring for mark in self.beside.dropped if mark in each}
        for symbol in renamed_in(self.beside.before) | marked:
            self.forget(symbol)
        self._hear_of_letters(display)
        spoken = {*filter(names_a_thing, words_of(self.beside.sentence))}
        for symbol in [each.symbol for each in self.vocabulary.definitions.values() if each.apart & spoken]:
            self.forget(symbol)
        if words_of(display.before):
            self.introduced = self.beside.introduces
        self.ended = has_ended(display)

    def _hear_of_all(self, display: Display) -> None:
        """Take notice of a title, or of words before a list, that deny what stands behind them."""
        *above, own = display.before.split(HEADING)
        lead, *items = _LIST.split(own)
        if items and (denies(lead) or is_denied(last_sentence(lead.rstrip(" \n.:")))):
            self.denied = True
        elif above or _LIST_ENDS.search(own):
            self.denied = bool(above) and denies(own.partition("\n")[0])
        if says(r"\b<letters-change>\b", " ".join(own.split())):
            self._forget(lambda each: each.place >= 0)

    def _end_cases(self, display: Display) -> None:
        """Take notice of the cases that are over: whole sentences, or clauses before the main one, speak of others."""
        *whole, last = sentences_of(display.before)
        lead = "" if self.carried and display.before.lstrip()[:1].islower() else last.removesuffix(main_clause(last))
        spoken = ". ".join(each for each in (*whole, lead) if "$" not in each)
        self.over |= {place for place, words in self.cases.items() if strange_word(spoken, words)}
        if self.held_at in self.over:
            self.held = ANYWHERE

    def _forget(self, is_over: Callable[[Known], bool]) -> None:
        """Forget the equations and definitions that hold no longer, and what rests on them."""
        self.premises = [each for each in self.premises if not is_over(each)]
        for symbol in [each.symbol for each in self.vocabulary.definitions.values() if is_over(each)]:
            if symbol in self.vocabulary.definitions:
                self.vocabulary.drop(symbol)

    def forget(self, symbol: str) -> None:
        """Forget what was said of a letter, and with it."""
        self._forget(lambda each: speaks_of(_symbols_of(each), symbol))

    def _hear_of_letters(self, display: Display) -> None:
        """Forget what other sections said of a letter, and with it, where words say that it is something else."""
        sections = display.before.rstrip().split(HEADING)
        sections[-1] += (f" ${display.latex}$" if self._is_called(display) else ". ") + self.beside.behind
        for part, words in enumerate(sections, display.part + 1 - len(sections)):
            for symbol, nouns in described(words):
                self._forget_from_elsewhere(symbol, nouns, part)
                self.named[symbol, part] = self.named.get((symbol, part), frozenset()) | nouns

    def _is_called(self, display: Display) -> bool:
        """Whether words right beside a display say what its letter is: "is", or "is the mass" behind it."""
        return _IS.search(display.before) is not None or _IS_THE.match(self.beside.behind) is not None

    def _named_at(self, symbol: str, part: int) -> frozenset[str]:
        """Return what words called a letter in a section, or else in the last one above it that called it anything."""
        above = [each for name, each in self.named if name == symbol and each <= part]
        return self.named[symbol, max(above)] if above else frozenset()

    def _forget_from_elsewhere(self, symbol: str, nouns: frozenset[str], part: int) -> None:
        """Forget what other sections said of a letter, and with it, but for what may be called by the same nouns.

        So does a section itself where words called it something else before.
        """
        told = bool(nouns and self.named.get((symbol, part)))

        def stays(each: Known) -> bool:
            same = is_same(nouns, each.words | self._named_at(symbol, each.part))
            return same or (each.part == part and not told)

        self._forget(lambda each: speaks_of(_symbols_of(each), symbol) and not stays(each))

    def stand_at(self, display: Display) -> None:
        """Take in where an equation holds: what one before it says goes on, up to the next heading."""
        inline = display.environment == "inline"
        limited = None if inline else _ONLY.match(display.after)
        sentences = [limited[1]] if limited else sentences_of(display.before.rpartition(HEADING)[2])
        own = last_context(sentences, display.after if inline else "")
        passing = inline and bool(own.kind) and not own.is_of_things
        if (own.kind and not passing) or self.part != display.part:
            self.held, self.held_at = ANYWHERE if passing else own, display.place
        note = _NOTE.search(sentences[-1]) or _NOTE.match(display.after.lstrip())
        ended = inline or has_ended(display)
        behind = context_behind(note[1]) if note else ANYWHERE if ended else context_behind(display.after)
        self.context = own if passing else behind if behind.kind else self.held
        self.part = display.part

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

    def _keep_stated(self, display: Display) -> None:
        """Forget what was stated within the text before words of another thing."""
        kept = list[tuple[str, Premise]]()
        for latex, premise in self.stated:
            between = display.before.rpartition(latex)[2]
            is_other = strange_word(between, premise.words) or _NAMED.search(without_formulas(between))
            if not (is_other or self.beside.strange(premise.words)):
                kept.append((latex, premise))
        self.stated = kept

    def note(self, statement: Statement, formula: Parsed) -> None:
        """Take notice of the letters of a statement, and of those that are alone on a side."""
        for side in formula.sides:
            if formula.relations:
                self.given_at[defined_by(side)[0]] = statement.display.place
            for symbol in symbols_in(side):
                self.asserted.setdefault(symbol, statement.display.place)

    def renew(self, statement: Statement, formula: Parsed) -> None:
        """Forget what a letter was in another section or context, and what rests on it, where one gives it anew.

        It does if words say so, or if its value is another one of the same letters; one of other letters may be equal.
        The letter stands for the new value from there on, unless words speak of a case.
        """
        if not formula.relations or formula.relations[0] not in EQUALITIES:
            return
        left, value, part = formula.sides[0], formula.sides[1], statement.display.part
        symbol, parameters = defined_by(left)
        known = self.vocabulary.definitions.get(symbol)
        before = known.part if known else self.alone.get(given_by(left), part)
        said = known is not None and (known.parameters, known.tree) == (parameters, value)
        if not given_by(left) or said or self.is_named(statement, self.given.statements):
            return
        elsewhere = known is not None and (
            self.context.excludes(known.context) or (known.part == part and bool(self.beside.strange(known.words)))
        )
        if before == part and not (known and self.beside.defines) and not elsewhere:
            return
        older, recent = self.premises[:-MOST_PREMISES], self.premises[-MOST_PREMISES:]
        told = extended(self.vocabulary, [each.gives for each in recent if each.gives and each.gives.symbol == symbol])
        others = [two for each in recent for one, two in each.both_ways if one == left]
        letters = told.letters_of(left, *(others if is_named(left) else []))
        theirs = self.vocabulary.letters_of(value)
        if not (self.beside.renews or elsewhere or letters <= theirs or theirs <= letters):
            return
        if not is_named(left) and (is_one_value(parameters, value) or agree(samples_of(told), (left, value))):
            return
        if known and self.vocabulary.is_matrix(symbol) and are_one_matrix(self.vocabulary, (left, value)):
            return
        self.premises = older + [
            each
            for each in recent
            if (each.part == part and before != part)
            or not (left in each.sides if is_named(left) else symbol in each.symbols)
        ]
        if known is None:
            return
        self.vocabulary.drop(symbol)
        if not (statement.condition or self.beside.case() or is_circular(symbol, value, self.vocabulary)):
            where, words = where_of(statement), self.beside.words
            given = symbol, parameters, value, where, part, False
            apart = (known.apart | known.words) - words
            held = self.beside.place, words, self.context, apart, self.ranges
            made = Definition(*given, True, "definition", *held)
            self.vocabulary.define(replace(made, usable=computes(made, self.vocabulary)))

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

    def take(self, statement: Statement, formula: Parsed, *, defines: bool) -> None:
        """Keep an equation as a premise of what stands behind it."""
        if is_condition(self.beside, formula):
            self.conditions.add(statement.display.place)
        if self.context.is_case:
            words = f"{self.beside.before} {self.beside.sentence} {self.context.words}"
            self.cases.setdefault(statement.display.place, words_of(words))
        formula = formula.without_set()
        if not formula.relations or statement.condition or {*formula.relations} - {*EQUALITIES}:
            return
        if self.beside.exchanged or not self.vocabulary.letters_of(*formula.sides):
            return
        if self.beside.is_denied or is_update(*formula.sides[:2]) or self.is_of_one_index(formula):
            return
        known = self.vocabulary.definitions.get(defined_by(formula.sides[0])[0])
        if known and len(formula.sides) == 2 and differ_in_one_letter([known.tree], formula.sides[1:]):
            return
        found = self.premises_of(statement, formula, formula.sides[defines:])
        if contended := [other for each in found for other in self._contended(each)]:
            for other in contended:
                if isinstance(other, Definition):
                    self.vocabulary.define(replace(other, role="case"))
            self.premises = [replace(each, special=True) if each in contended else each for each in self.premises]
            return
        if defines and len(formula.sides) > 2 and symbols_in(formula.sides[-1]):
            found += self.premises_of(statement, formula, formula.sides)[-1:]
        for each in found:
            self.premises.append(each)
            sides = map(argument_of, each.sides)
            self.alone |= dict.fromkeys(map(given_by, sides), statement.display.part)

    def _contended(self, premise: Premise) -> list[Known]:
        r"""Return what gives otherwise what an equation gives, by the same letters or by some of them.

        Two values of other letters may be equal, as in ``F = -k x`` and ``F = m a``.  What an operator makes has one
        value: ``\nabla \cdot u`` is zero, or q in another case.
        """
        found: list[Known] = []
        for side, value in premise.both_ways:
            symbol, parameters = defined_by(side)
            known = self.vocabulary.definitions.get(symbol)
            above: list[tuple[Known, Formula]]
            above = [(known, known.tree)] if known is not None and known.parameters == parameters else []
            above += [(each, two) for each in self.serving for one, two in each.both_ways if one == side]
            for each, other in above if introduced_by(side) else ():
                near = each.place == premise.place
                is_other = symbol in self.survey.applied and other != value
                if each.part == premise.part and (is_other or self._contend(other, value, near=near)):
                    found.append(each)
        return found

    def _contend(self, one: Formula, other: Formula, *, near: bool) -> bool:
        """Whether values differ, and one has all letters of the other.

        In one display both have the same letters, or none more than one: its rows may be steps, in which letters go.
        That does not matter where words speak of several things, as in "The bounds are".
        """
        ours, theirs = map(self.vocabulary.letters_of, (one, other))
        if near:
            tied = (bool(ours) and ours == theirs) or all(len([*symbols_in(each)]) < 2 for each in (one, other))
            tied = tied or self.beside.lists
        else:
            tied = bool(ours and theirs) and (ours <= theirs or theirs <= ours)
        if one == other or not tied:
            return False
        samples = samples_of(self.vocabulary)
        computed = all(agree(samples, (each, each)) for each in (one, other))
        return computed and not agree(samples, (one, other))

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
        symbols = _symbols_of(known)
        here = self.sentences.get(self.beside.place, "")
        return symbols <= letters and are_of_two_things(self.sentences.get(known.place, ""), here)

    def _is_of_some(self, known: Known) -> bool:
        """Whether an equation gives a number to a letter that is any here, or holds in a case of it."""
        symbols = _symbols_of(known)
        return bool(symbols & self.beside.quantified) and (len(symbols) == 1 or known.context.is_case)

    def _is_over(self, place: int) -> bool:
        """Whether a display was the condition of a sentence that has ended, or of a case that has."""
        here = None if self.display is None else self.display.place
        return place in self.over or (place in self.conditions - self.running and here not in (None, place))

    def known_here(self, letters: frozenset[str]) -> Vocabulary:
        """Return what letters stand for where an equation of some letters stands.

        Left out are definitions of another context, of another thing, conditions, numbers of letters that are any, and
        what rests on exchanged letters; but not what words cite.
        """
        found = self.vocabulary.copied()
        for known in [*found.definitions.values()]:
            if self._is_of_some(known) or (self._is_over(known.place) and not is_cited(known, self.cited)):
                del found.definitions[known.symbol]
        found.forget()
        for known in [*found.definitions.values()]:
            elsewhere = self.context.excludes(known.context) and not is_cited(known, self.cited)
            elsewhere = elsewhere or is_cited(known, self.apart) or self.tells_of_another(known, letters)
            elsewhere = elsewhere or bool(self.beside.exchanged & _symbols_of(known))
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
            and (is_cited(each, cited) or not (self.context.excludes(each.context) or self._is_over(each.place)))
        ]


def _symbols_of(known: Known) -> set[str]:
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
