"""A document read once from its beginning to its end: definitions and premises collected, and each relation judged."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from algebroproj_sym.reading.defining.citing import apart_in, cited_in
from algebroproj_sym.reading.defining.contexts import ANYWHERE, context_of
from algebroproj_sym.reading.defining.dependence import letters_of_symbol
from algebroproj_sym.reading.defining.instances import numbers_put_in
from algebroproj_sym.reading.defining.meanings import VARIES
from algebroproj_sym.reading.defining.premises import (
    MOST_PREMISES,
    Premise,
    derivatives_in,
    extended,
    neighbours,
)
from algebroproj_sym.reading.defining.recognising import (
    EQUALITIES,
    argument_of,
    computes,
    defined_by,
    given_by,
    introduced_by,
    is_circular,
    is_indexed_above,
    is_named,
    is_one_value,
    is_table,
    is_update,
)
from algebroproj_sym.reading.defining.survey import Survey
from algebroproj_sym.reading.defining.symbols import SymbolsFile
from algebroproj_sym.reading.defining.vocabulary import Definition, Vocabulary
from algebroproj_sym.reading.documents.displays import Display, Document
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.judging.deciding import Asked, agree, decide
from algebroproj_sym.reading.judging.questions import (
    asked_of,
    both_sides,
    rests_of,
    used_by,
)
from algebroproj_sym.reading.judging.signs import may_be_negative, without_signs
from algebroproj_sym.reading.judging.supposing import goes_on_with, leads_elsewhere, supposes
from algebroproj_sym.reading.judging.verdicts import Link, Reading
from algebroproj_sym.reading.judging.ways import Standing, ways_of
from algebroproj_sym.reading.judging.words import (
    CASES,
    SAYS,
    Beside,
    beside,
    has_ended,
    is_given_within,
    is_item,
    last_sentence,
    takes_back,
    words_of,
)
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in

MOST_WITHIN = 12
"""How many formulas within the text before an equation may stand in its sentence."""


def read_document(
    document: Document,
    given: SymbolsFile | None = None,
    *,
    seconds: float = 10.0,
    jobs: int = 1,
    lines: Collection[int] | None = None,
) -> list[Reading]:
    r"""Return the equations of a document, each with its verdict.

    Parameters
    ----------
    document : Document
        What was read from a file.
    given : SymbolsFile, optional
        What the user says of its letters.
    seconds : float
        How long the proof of one relation may take.
    jobs : int
        How many worker processes.
    lines : collection of int, optional
        The lines on which the equations begin that are to be decided; by default all are.

    Examples
    --------
    >>> from algebroproj_sym.reading import document_of
    >>> found = read_document(document_of(r"\[ s = a + b \] \[ s^2 = a^2 + 2ab + b^2 \]"))
    >>> [(each.read, each.verdict) for each in found]
    [('s = a + b', 'definition'), ('s**2 = a**2 + 2*a*b + b**2', 'follows')]
    """
    readings, asked = _Pass(Survey(document, given or SymbolsFile())).all()
    asked = [each for each in asked if lines is None or readings[each.reading].line in lines]
    decide(asked, seconds, jobs)
    for each in asked:
        links = list(readings[each.reading].links)
        links[each.place] = each.link
        readings[each.reading] = replace(readings[each.reading], links=tuple(links))
    signs = may_be_negative(document)
    return [without_signs(each, signs) for each in _without_refuted_premises(readings)]


def _without_refuted_premises(readings: Sequence[Reading]) -> list[Reading]:
    """Return readings in which nothing follows from an equation that contradicts."""
    found = list[Reading]()
    refuted = set[str]()
    for each in readings:
        links = tuple(
            replace(link, verdict="independent", reason=f"it follows only from {wrong[0]}, which contradicts")
            if link.verdict == "follows" and (wrong := [where for where in link.rests_on if where in refuted])
            else link
            for link in each.links
        )
        found.append(replace(each, links=links))
        if found[-1].verdict == "contradicts":
            refuted.add(_where(each.statement))
    return found


def _where(statement: Statement) -> str:
    number = statement.number or statement.label
    where = str(statement.display.where)
    return f"({number}), {where}" if number else where


_SCOPES = re.compile(r"\\(begin|end)\{(?:example|exercise|problem|quote|quotation)\*?\}")
_QUOTED = re.compile(r"(?:^|\n)[ \t]*>[> \t]*$")


class _Pass:
    """Goes through a document once, and collects definitions, premises and questions."""

    def __init__(self, survey: Survey) -> None:
        self.survey = survey
        self.given = survey.given
        self.vocabulary = survey.vocabulary()
        self.asserted: dict[str, int] = {}
        self.premises: list[Premise] = []
        self.within: list[tuple[str, Premise]] = []
        self.alone: dict[str, int] = {}
        self.given_at: dict[str, int] = {}
        self.introduced = False
        self.context = ANYWHERE
        self.scope: int | None = None
        self.quoted: int | None = None
        self.part = 0
        self.order = 0
        self.beside = Beside("", "", "", "", False, 0, 0, True)
        self.display: Display | None = None
        self.carried = ""
        self.ended = True

    def all(self) -> tuple[list[Reading], list[Asked]]:
        """Return the displayed equations, and what is to be asked of them."""
        readings: list[Reading] = []
        asked: list[Asked] = []
        for order, statement in enumerate(self.survey.statements, 1):
            self.order = order
            found = self.survey.formulas[id(statement)]
            if statement.display.environment == "inline":
                if isinstance(found, Parsed):
                    self._inline(statement, found)
                continue
            reading, questions = self._displayed(statement, found, len(readings))
            readings.append(reading)
            asked += questions
        return readings, asked

    def _leave(self, display: Display) -> None:
        """Forget what a quotation or an example says where it ends."""
        for mark in _SCOPES.finditer(display.before):
            if mark[1] == "begin" and self.scope is None:
                self.scope = display.place
            elif mark[1] == "end" and self.scope is not None:
                self._retract_from(self.scope)
                self.scope = None
        quoted = _QUOTED.search(display.before) is not None
        if self.quoted is not None and not quoted:
            self._retract_from(self.quoted)
        self.quoted = (display.place if self.quoted is None else self.quoted) if quoted else None

    def _retract_from(self, place: int) -> None:
        self.premises = [each for each in self.premises if each.place < place]
        self._drop([each.symbol for each in self.vocabulary.definitions.values() if each.place >= place])

    def _listen(self, statement: Statement) -> None:
        """Take in the words beside a statement."""
        display = statement.display
        if display is not self.display:
            self._leave(display)
        same_part = self.beside.part == display.part
        if display is not self.display:
            if self.display is not None and takes_back(display.before):
                self._retract(self.display)
            self.carried = "" if self.ended or not same_part else self.beside.sentence
        self.display = display
        self.beside = beside(statement, self.carried)
        self._stand_at(display)
        for symbol in self.beside.changed:
            self._forget(symbol)
        if words_of(display.before):
            self.introduced = self.beside.introduces
        self.ended = has_ended(display)

    def _retract(self, display: Display) -> None:
        """Forget what a display said."""
        self.premises = [each for each in self.premises if each.place != display.place]
        self._drop(each.symbol for each in self.vocabulary.definitions.values() if each.place == display.place)

    def _forget(self, symbol: str) -> None:
        """Forget what was said of a letter, and with it."""
        self.premises = [each for each in self.premises if symbol not in each.symbols]
        self._drop(
            each.symbol for each in self.vocabulary.definitions.values() if symbol in (each.symbol, *each.symbols)
        )

    def _drop(self, symbols: Iterable[str]) -> None:
        for symbol in [*symbols]:
            if symbol in self.vocabulary.definitions:
                self.vocabulary.drop(symbol)

    def _stand_at(self, display: Display) -> None:
        """Take in where an equation holds: what one before it says goes on, up to the next heading."""
        behind = display.after if display.environment == "inline" else ""
        own = context_of(last_sentence(display.before), behind)
        self.context = own if own.kind or self.part != display.part else self.context
        self.part = display.part

    def _named(self, statement: Statement, names: frozenset[str]) -> bool:
        return bool(names & {statement.number, statement.label, str(statement.display.where), "all"} - {""})

    def _inline(self, statement: Statement, formula: Parsed) -> None:
        if self.survey.meanings.reason(statement, formula):
            return
        before, sentence = statement.display.before, last_sentence(statement.display.before)
        self._leave(statement.display)
        number = not any(map(symbols_in, formula.sides[1:]))
        elsewhere = number and leads_elsewhere(statement.display.after)
        says = is_given_within(before, number=number) and not (elsewhere or beside(statement, "").is_denied)
        self._stand_at(statement.display)
        tells = SAYS.search(before) or is_item(before, statement.display.after)
        if len(formula.sides) == 2 and (says or (tells and not CASES.search(sentence))):
            definition = self._definition(statement, formula, explicit=bool(says), late=bool(says))
            if (
                definition is not None
                and not is_one_value(definition.parameters, definition.tree)
                and (says or self._is_only_one(definition))
                and definition.symbol not in self.vocabulary.definitions
            ):
                self.vocabulary.define(definition)
        if len(formula.sides) > 1:
            self._note(statement, formula)
            self._restate(formula)
            if {*formula.relations} == {"="}:
                words = f"${statement.display.latex}$"
                self.within += [(words, each) for each in self._premises_of(statement, formula, formula.sides)]
            del self.within[:-MOST_WITHIN]

    def _is_only_one(self, definition: Definition) -> bool:
        """Whether a letter is given by letters, and by no other equation of the document."""
        ties = self.survey.dependence.ties
        return bool(definition.symbols) and sum(tie.given == definition.symbol for tie in ties) == 1

    def _restate(self, formula: Parsed) -> None:
        """Take notice that a letter with a definition is given within the text, and otherwise."""
        for side in formula.sides:
            known = self.vocabulary.definitions.get(defined_by(side)[0])
            if known is not None and known.tree not in formula.sides and formula.relations[0] in EQUALITIES:
                self.vocabulary.define(replace(known, role="case"))

    def _note(self, statement: Statement, formula: Parsed) -> None:
        for side in formula.sides:
            if formula.relations:
                self.given_at[defined_by(side)[0]] = statement.display.place
            for symbol in symbols_in(side):
                self.asserted.setdefault(symbol, statement.display.place)

    def _displayed(
        self, statement: Statement, found: Parsed | UnreadableError, place: int
    ) -> tuple[Reading, list[Asked]]:
        display = statement.display
        number = statement.number or statement.label
        if isinstance(found, UnreadableError):
            where = self.survey.document.line_of(found.place) if found.place is not None else display.where
            reason = f"{where}: {found}"
            return Reading(number, statement.latex, None, reason, (), statement), []
        sides = [self.vocabulary.text(side) for side in found.sides]
        read = sides[0] + "".join(
            f" {relation} {side}" for relation, side in zip(found.relations, sides[1:], strict=True)
        )
        links: list[Link] = []
        asked: list[Asked] = []
        self._listen(statement)
        if reason := self.survey.meanings.reason(statement, found):
            self._note(statement, found)
            links = [Link("not decided", reason)] * max(1, len(found.relations))
            equal = bool(found.relations) and found.relations[0] in EQUALITIES
            if equal and not reason.endswith(VARIES) and self._introduces(statement, found):
                links[0] = Link("definition")
            return Reading(number, statement.latex, read, "", tuple(links), statement, found), []
        definition = self._definition(statement, found, explicit=False)
        for index, relation in enumerate(found.relations):
            if index == 0 and definition is not None:
                questions = asked_of(self.vocabulary, definition.tree, definition.tree)
                both = both_sides(questions) if isinstance(questions, list) else None
                links.append(Link("definition", rests_on=rests_of(self.vocabulary, definition.tree), sides=both))
                continue
            link, question = self._link(statement, found, index, relation, place)
            links.append(link)
            if question is not None:
                asked.append(question)
        if not found.relations:
            links.append(Link("not decided", "it has no relation, so it states nothing"))
        if definition is not None:
            self.vocabulary.define(definition)
            self.asserted.setdefault(definition.symbol, display.place)
            self.given_at[definition.symbol] = display.place
        else:
            self._note(statement, found)
            self._renew(statement, found)
        self._assert(statement, found, defines=definition is not None)
        return Reading(number, statement.latex, read, "", tuple(links), statement, found), asked

    def _renew(self, statement: Statement, formula: Parsed) -> None:
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
        if not given_by(left) or self._named(statement, self.given.statements):
            return
        elsewhere = known is not None and (
            self.context.excludes(known.context) or (known.part == part and bool(self.beside.strange(known.words)))
        )
        if before == part and not (known and self.beside.defines) and not elsewhere:
            return
        older, recent = self.premises[:-MOST_PREMISES], self.premises[-MOST_PREMISES:]
        told = extended(self.vocabulary, [each.gives for each in recent if each.gives and each.gives.symbol == symbol])
        others = [
            two for each in recent for one, two in ((each.left, each.right), (each.right, each.left)) if one == left
        ]
        letters = told.letters_of(left).union(*map(told.letters_of, others if is_named(left) else []))
        theirs = self.vocabulary.letters_of(value)
        if not (self.beside.renews or elsewhere or letters <= theirs or theirs <= letters):
            return
        if not is_named(left) and (is_one_value(parameters, value) or agree(told, (left, value))):
            return
        self.premises = older + [
            each
            for each in recent
            if (each.part == part and before != part)
            or not (left in (each.left, each.right) if is_named(left) else symbol in each.symbols)
        ]
        if known is None:
            return
        self.vocabulary.drop(symbol)
        if not (statement.condition or self.beside.case() or is_circular(symbol, value, self.vocabulary)):
            where, words = _where(statement), self.beside.words
            given = symbol, parameters, value, where, part, False
            made = Definition(*given, place=self.beside.place, words=words, context=self.context)
            self.vocabulary.define(replace(made, usable=computes(made, self.vocabulary)))

    def _is_of_one_index(self, formula: Parsed) -> bool:
        """Whether an equation with an index holds for one value of it, which the words give."""
        symbols = (symbol for side in formula.sides for symbol in symbols_in(side))
        return bool(self.context.fixed) and any(self.context.fixed in letters_of_symbol(each) for each in symbols)

    def _assert(self, statement: Statement, formula: Parsed, *, defines: bool) -> None:
        """Keep an equation as a premise of what stands behind it."""
        if not formula.relations or statement.condition or {*formula.relations} - {*EQUALITIES}:
            return
        if self.beside.exchanged or not any(self.vocabulary.letters_of(each) for each in formula.sides):
            return
        if self.beside.is_denied or is_update(*formula.sides[:2]) or self._is_of_one_index(formula):
            return
        for each in self._premises_of(statement, formula, formula.sides[defines:]):
            self.premises.append(each)
            sides = map(argument_of, (each.left, each.right))
            self.alone |= dict.fromkeys(map(given_by, sides), statement.display.part)

    def _premises_of(self, statement: Statement, formula: Parsed, sides: Sequence[Formula]) -> list[Premise]:
        """Return the equations between sides of a statement: of those next to each other, and of the first and last."""
        pairs = [*(pairwise(sides) if len(sides) > 2 else ()), *([(sides[0], sides[-1])] if len(sides) > 1 else ())]
        names = frozenset((statement.number, statement.label)) - {""}
        display, special, words = statement.display, bool(self.beside.case()), self.beside.words
        given = _where(statement), display.part, display.place, names, special, words
        chained = len(formula.sides) > 2
        return [Premise(left, right, *given, chained=chained, context=self.context) for left, right in pairs]

    # -- definitions

    def _definition(
        self, statement: Statement, formula: Parsed, *, explicit: bool, late: bool = False
    ) -> Definition | None:
        """Return what a statement defines: a letter, or a function of letters, of which nothing was asserted before."""
        if not formula.relations or formula.relations[0] not in EQUALITIES:
            return None
        relation = formula.relations[0]
        left, right = formula.sides[:2] if relation != "=:" else (formula.sides[1], formula.sides[0])
        symbol, parameters = defined_by(left)
        if not symbol or self._named(statement, self.given.statements) or symbol in self.given.whole.symbols:
            return None
        if self._is_of_one_index(formula) or self.beside.exchanged or (symbol == r"\pi" and not symbols_in(right)):
            return None
        explicit = explicit or relation in (":=", "=:") or self._named(statement, self.given.definitions)
        table = is_table(symbol, right, self.vocabulary)
        if (
            self.beside.is_denied
            or (self.beside.is_conditional and not (explicit or table))
            or (not explicit and is_one_value(parameters, right))
        ):
            return None
        late = late or explicit or self.introduced or table
        used = self.asserted.get(symbol, statement.display.place) != statement.display.place and not late
        again = symbol in self.vocabulary.definitions and relation not in (":=", "=:")
        if used or again or is_circular(symbol, right, self.vocabulary):
            return None
        if not explicit and derivatives_in((left,), self.vocabulary, self.survey.occurring):
            return None
        given = symbol, parameters, right, _where(statement), statement.display.part
        words, place = beside(statement, "").words, statement.display.place
        made = Definition(*given, explicit, not statement.condition, place=place, words=words, context=self.context)
        return replace(made, usable=made.usable and computes(made, self.vocabulary))

    def _tells(self, statement: Statement, formula: Parsed, index: int) -> bool:
        """Whether a relation of a chain says what its left side is, so that there is nothing to check."""
        left, right = formula.sides[index], formula.sides[index + 1]
        if formula.relations[index] == "∈":
            return index > 0 and self._introduces(statement, formula)
        first = index == 0 or (index == 1 and defined_by(left)[0] not in {"", *self.asserted})
        introduces = index == 0 and self._introduces(statement, formula)
        return formula.relations[index] in EQUALITIES and (
            introduces or (first and self._gives(statement, left, right))
        )

    def _introduces(self, statement: Statement, formula: Parsed) -> bool:
        """Whether an equation says what something is of which nothing was said before, though perhaps in a case."""
        left, right = formula.sides[:2] if formula.relations[0] != "=:" else formula.sides[1::-1]
        if self.beside.is_denied or self.beside.exchanged or self._named(statement, self.given.statements):
            return False
        if formula.relations[0] in (":=", "=:"):
            return True
        symbols, place = introduced_by(left), statement.display.place
        before = {*self.vocabulary.definitions, *self.given.whole.symbols}
        before |= {symbol for symbol, since in self.asserted.items() if since != place}
        theirs, parameters = {*symbols_in(right)}, defined_by(left)[1]
        values = [str(each.children[0]) for each in left.iter_subtrees() if each.data == "call"]
        value = not defined_by(right)[0] and (bool(parameters) or all(map(self.survey.has_one_argument, values)))
        everywhere = not values or (bool(parameters) and not is_one_value(parameters, right))
        return (
            bool(symbols)
            and not symbols & (before | theirs)
            and (everywhere or value)
            and bool(theirs)
            and not derivatives_in((left,), self.vocabulary, self.survey.occurring)
            and not self.beside.is_condition
        )

    def _gives(self, statement: Statement, left: Formula, right: Formula) -> bool:
        """Whether an equation is the first one of its section that gives its letter, though the letter was used before.

        It may not be a condition, or hold but roughly.  Where an equation near it may give the letter as well, its
        sentence must say that it is introduced.
        """
        if self.beside.is_denied or self.beside.exchanged:
            return False
        if is_indexed_above(left):
            above = any(
                left in (each.left, each.right) and each.part == statement.display.part for each in self.premises
            )
            return not (above or self.beside.case_of_sentence or left in right.iter_subtrees() or not symbols_in(right))
        square = left.data == "power" and not symbols_in(left.children[1])  # type: ignore[arg-type]  # two trees
        base: Formula = left.children[0] if square else argument_of(left)  # type: ignore[assignment]  # likewise
        symbol, parameters = (str(base.children[0]), ()) if is_named(base) else defined_by(base)
        part = statement.display.part
        if not symbol or not (symbols_in(right) or self.survey.is_parameter(statement)):
            return False
        if is_one_value(parameters, right) and (symbol in self.asserted or not self.survey.has_one_argument(symbol)):
            return False
        if self._named(statement, self.given.statements) or symbol in self.given.whole.symbols:
            return False
        known = self.vocabulary.definitions.get(symbol)
        if self.beside.case_of_sentence or (square and symbol in self.asserted):
            return False
        if self.beside.defines:
            return not is_circular(symbol, right, self.vocabulary)
        if derivatives_in((left,), self.vocabulary, self.survey.occurring):
            return False
        near = neighbours(self.premises, part, self._cited)
        tied = not self.beside.names and any(each.gives is None and symbol in each.symbols for each in near)
        here = (known is not None and known.part == part) or self.alone.get(given_by(base)) == part
        anew = not (self.beside.follows or self._cited) and (self.beside.names or self.beside.renews)
        return not (tied or (here and not anew) or is_circular(symbol, right, self.vocabulary))

    # -- relations

    def _link(
        self, statement: Statement, formula: Parsed, index: int, relation: str, place: int
    ) -> tuple[Link, Asked | None]:
        left, right = formula.sides[index], formula.sides[index + 1]
        rests = rests_of(self.vocabulary, left, right)
        if relation == "∈" and self._tells(statement, formula, index):
            return Link("definition", rests_on=rests), None
        if relation not in EQUALITIES:
            return Link("not decided", f"the relation {relation} is read, and not decided", rests), None
        letters = self.vocabulary.letters_of(left) | self.vocabulary.letters_of(right)
        identity = self._named(statement, self.given.identities)
        certain = not letters and all(each.explicit for each in used_by(self.vocabulary, left, right))
        ways = ways_of(self._standing(statement), statement, formula, index)
        chained = len(formula.sides) > 2
        gives = self._tells(statement, formula, index)
        others = [left] if index > 0 else self._said_of(left) if not symbols_in(right) else []
        gives = gives or any(self._is_instance(each, right) for each in others)
        asked = Asked(
            place,
            index,
            ways,
            Link("not decided", rests_on=rests),
            identity,
            certain,
            chained,
            gives,
            self.beside.follows,
        )
        return asked.link, asked

    def _said_of(self, left: Formula) -> list[Formula]:
        """Return what equations above give as a letter."""
        symbol, parameters = defined_by(left)
        known = self.vocabulary.definitions.get(symbol)
        pairs = [pair for each in self._serving for pair in ((each.left, each.right), (each.right, each.left))]
        given = [known.tree] if known and not (known.parameters or parameters) else []
        return given + [other for one, other in pairs if symbol and one == left]

    def _is_instance(self, left: Formula, right: Formula) -> bool:
        """Whether numbers are put in for letters that have no value: the equation gives them, in this case."""
        given = numbers_put_in(left, right)
        return bool(given) and not any(
            known.usable and not self.vocabulary.letters_of(known.tree)
            for symbol in given
            if (known := self.vocabulary.definitions.get(symbol))
        )

    def _standing(self, statement: Statement) -> Standing:
        """Return where a statement stands."""
        vocabulary = self.vocabulary.copied()
        self._forget_elsewhere(vocabulary)
        for symbol in self._exchanged:
            if symbol in vocabulary.definitions:
                vocabulary.drop(symbol)
        place = statement.display.part, self._serving, self._cited
        own = [each for words, each in self.within if supposes(self.beside, words)]
        return Standing(self.survey, vocabulary, self.beside, *place, self.given_at, (*own, *self._explained_behind()))

    def _explained_behind(self) -> Iterator[Premise]:
        """Yield the equations within the text with which the sentence of a display goes on: "where $w^2 = k/m$"."""
        following = self.survey.statements[self.order : self.order + MOST_WITHIN]
        for each in following if self.display and not has_ended(self.display) else ():
            found, display = self.survey.formulas[id(each)], each.display
            if display.environment != "inline":
                if display is not self.display:
                    return
            elif not goes_on_with(display.before):
                return
            elif (
                isinstance(found, Parsed)
                and {*found.relations} == {"="}
                and not self.survey.meanings.reason(each, found)
            ):
                formula = f"${display.latex}$"
                behind = display.after.partition(".")[0].partition("$")[0].strip().removesuffix("and")
                sentence = f"{display.before}{formula}{behind}"
                if supposes(replace(self.beside, sentence=sentence), formula):
                    yield from self._premises_of(each, found, found.sides)

    @property
    def _cited(self) -> frozenset[str]:
        """The labels and numbers of the equations that words before the display name."""
        return cited_in(self.display.before) if self.display is not None else frozenset()

    @property
    def _apart(self) -> frozenset[str]:
        """Likewise of those of which the words say that it is not so here."""
        return apart_in(self.display.before) if self.display is not None else frozenset()

    def _forget_elsewhere(self, vocabulary: Vocabulary) -> None:
        """Drop the definitions that belong to another context, but for those that words cite."""
        names = tuple(f"({name})" for name in self._cited)
        apart = tuple(f"({name})" for name in self._apart)
        for known in [*vocabulary.definitions.values()]:
            elsewhere = self.context.excludes(known.context) and not known.where.startswith(names)
            elsewhere = elsewhere or (bool(apart) and known.where.startswith(apart))
            if elsewhere and known.symbol in vocabulary.definitions:
                vocabulary.drop(known.symbol)

    @property
    def _serving(self) -> list[Premise]:
        """The premises that do not belong to another context, and those that words cite."""
        cited = self._cited
        changed = self.beside.exchanged
        premises = (each for each in self.premises if not (changed & each.symbols or self._apart & each.names))
        return [each for each in premises if each.names & cited or not self.context.excludes(each.context)]

    @property
    def _exchanged(self) -> list[str]:
        """The letters with a definition that rests on what is exchanged in the sentence."""
        known = self.vocabulary.definitions.values()
        return [each.symbol for each in known if self.beside.exchanged & {each.symbol, *each.symbols}]
