"""A document read once from its beginning to its end, and each relation judged."""

import re
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.domains import range_in, ranges_said
from algebroproj_sym.reading.defining.premises import Premise, sides_of
from algebroproj_sym.reading.defining.recognising import (
    EQUALITIES,
    computes,
    defined_by,
    introduced_by,
    is_circular,
    is_one_value,
    is_reordered,
    is_value_of_itself,
    operations_in,
    says_more_than_a_number,
    values_in,
    without_power,
)
from algebroproj_sym.reading.defining.symbols import SymbolsFile
from algebroproj_sym.reading.deriving.integrating import is_integral
from algebroproj_sym.reading.deriving.rates import ZERO
from algebroproj_sym.reading.documents.displays import Display, Document
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.judging.applying import with_what_is_true_here
from algebroproj_sym.reading.judging.components import by_components
from algebroproj_sym.reading.judging.deciding import OPEN, Asked, Manner, decide
from algebroproj_sym.reading.judging.indexing import gives_at_other_index
from algebroproj_sym.reading.judging.introducing import (
    begins_anew,
    definition_in,
    gives_if_open,
    is_condition_on,
    is_only_one,
    names_its_letter,
    relates_new_letters,
    says_on_what_it_depends,
    split_again,
    tells,
)
from algebroproj_sym.reading.judging.memory import Memory, where_of
from algebroproj_sym.reading.judging.questions import asking_once, rests_of, stated_by, used_by
from algebroproj_sym.reading.judging.signs import denied_by_words, without_denied
from algebroproj_sym.reading.judging.standing import Standing
from algebroproj_sym.reading.judging.stationary import derives, set_to_zero
from algebroproj_sym.reading.judging.survey import Survey
from algebroproj_sym.reading.judging.verdicts import Link, Reading
from algebroproj_sym.reading.judging.ways import ways_of
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in
from algebroproj_sym.reading.prose.meanings import SUMMED, VARIES
from algebroproj_sym.reading.prose.sentences import last_sentence
from algebroproj_sym.reading.prose.supposing import (
    goes_on_in_display,
    goes_on_with,
    is_denied_behind,
    leads_elsewhere,
    names_behind,
    states,
    supposes,
)
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

_SAYS_THE_SAME = re.compile(r"(?:these|they|this|it) (?:is|are) (?:equivalent|equal|identical)\b")
_PARTS = re.compile(r"the derivative of | with |, where ")
"""What stands between the places on which a derivative rests."""
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
    survey = Survey(document, given or SymbolsFile())
    reader = _Pass(survey)
    readings, asked = reader.all()
    asked = [each for each in asked if lines is None or readings[each.reading].line in lines]
    with asking_once(seconds, jobs) as ask:
        decide(asked, ask)
    for each in asked:
        links = list(readings[each.reading].links)
        links[each.place] = each.link
        readings[each.reading] = replace(readings[each.reading], links=tuple(links))
    denied = denied_by_words(document)
    readings = [without_denied(each, denied) for each in _without_refuted_premises(readings, reader.closed)]
    return with_what_is_true_here(readings, survey.statements)


def _without_refuted_premises(readings: Sequence[Reading], closed: Collection[str]) -> list[Reading]:
    """Return readings in which nothing follows from an equation that contradicts.

    Nor does it from the end of a chain that gives a letter, if the end is not proved to be equal to its beginning.

    Nor does it from an equation that one change would mend, within its display, or together with what that one rests
    on: both would give what neither says.
    """
    found = list[Reading]()
    refuted = set[str]()
    mended: dict[str, set[str]] = {}
    places = Counter(where_of(each.statement) for each in readings)
    doubted = {id(each.statement.display) for each in readings if any(link.suggestion for link in each.links)}
    for each in readings:
        own = {where_of(each.statement)} if id(each.statement.display) in doubted else set()
        links = tuple(
            replace(link, verdict="independent", reason=f"it follows only from {wrong[0]}, which is not proved")
            if link.verdict == "follows"
            and (
                wrong := [
                    where
                    for where in link.rests_on
                    if {*_PARTS.split(where)} & (refuted | own)
                    or not mended.get(where, set()).isdisjoint(link.rests_on)
                ]
            )
            else link
            for link in each.links
        )
        found.append(replace(each, links=links))
        where = where_of(each.statement)
        if places[where] == 1 and (rests := {one for link in links if link.suggestion for one in link.rests_on}):
            mended[where] = rests
        open_chain = where in closed and any(link.verdict != "follows" for link in links[1:])
        if found[-1].verdict == "contradicts" or open_chain:
            refuted.add(where)
    return found


def _without_rough_value(formula: Parsed) -> tuple[int, Parsed]:
    r"""Return a chain from where it is exact, and how many sides that leaves out: ``a \approx s = b`` gives s."""
    place = int(formula.relations[:1] == ("≈",) and len(formula.sides) > 2)
    return place, replace(formula, sides=formula.sides[place:], relations=formula.relations[place:])


_BEGINS = re.compile(r"(?:\A|[.,;]|\band)\s*(?:[Ww]here|[Ii]n which)\s*\Z")
"""How a clause begins that says what something is: not as in "points where"."""


_RESTRICTING = ("∈", "<", "<=", ">", ">=")
"""The signs that say in what range a letter is, behind what it is: ``f = a - b <= 0`` is a condition on f."""


def _not_judged(relation: str) -> str:
    return f"the sign {relation} is read, but not judged"


class _Pass:
    """Goes through a document once, and collects definitions, premises and questions."""

    def __init__(self, survey: Survey) -> None:
        self.survey = survey
        self.memory = Memory(survey)
        self.within: list[tuple[str, Premise]] = []
        self.above = frozenset[str]()
        self.order = 0
        self.closed = set[str]()

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
            else:
                reading, questions = self._displayed(statement, found, len(readings))
                readings.append(reading)
                asked += questions
            if isinstance(found, Parsed) and found.relations:
                shown = (symbols_in, operations_in, values_in)
                said = {part for each in shown for side in found.sides for part in each(side)}
                self.memory.seen |= said
                self.memory.equated |= said if {*found.relations} & {*EQUALITIES} else set()
        return readings, asked

    def _inline(self, statement: Statement, formula: Parsed) -> None:
        if self.survey.meanings.reason(statement, formula):
            return
        formula = formula.without_set()
        before, sentence = statement.display.before, last_sentence(statement.display.before)
        self.memory.leave(statement.display)
        number = {symbol for side in formula.sides[1:] for symbol in symbols_in(side)} <= {r"\pi"}
        elsewhere = number and (
            leads_elsewhere(statement.display.after) or is_example(sentence, statement.display.after)
        )
        restricts = self._restricts_new(statement, formula)
        says = is_given_within(before, number=number and not restricts)
        says = says and not (elsewhere or beside(statement, "").is_denied)
        denied = is_denied_behind(statement.display.after)
        says = says and not (ASKS.match(sentence) or denied)
        self.memory.stand_at(statement.display)
        stated = not denied and (SAYS.search(before) or is_item(before, statement.display.after))
        at_value = is_value_of_itself(*formula.sides) if len(formula.sides) == 2 else False
        if len(formula.sides) == 2 and not at_value and (says or (stated and not CASES.search(sentence))):
            definition = definition_in(self.memory, statement, formula, explicit=bool(says))
            if (
                definition is not None
                and not is_one_value(definition.parameters, definition.tree)
                and (says or is_only_one(self.memory, definition))
                and definition.symbol not in self.memory.vocabulary.definitions
            ):
                self.memory.vocabulary.define(definition)
                if number or (beside(statement, "").supposes and definition.symbol in self.memory.seen):
                    self.memory.valued.add(definition.symbol)
            elif (
                says
                and definition is None
                and ends_clause(statement.display)
                and (restricts or self._introduces_within(formula, before))
            ):
                given = self.memory.premises_of(statement, formula, formula.sides)
                self.memory.premises += [replace(each, special=False) for each in given]
        self.memory.give_anew(formula)
        if (
            not at_value
            and {*formula.relations} == {"="}
            and states(beside(statement, ""), statement.display, number=not any(map(symbols_in, formula.sides[1:])))
        ):
            self.memory.state(statement, formula)
        if len(formula.sides) > 1:
            if not at_value:
                self.memory.note(statement, formula)
                self._explain(before, formula)
                self.memory.tie(formula.sides)
                self.memory.restate(formula)
            if {*formula.relations} == {"="}:
                words = f"${statement.display.latex}$"
                self.within += [(words, each) for each in self.memory.premises_of(statement, formula, formula.sides)]
            del self.within[:-MOST_WITHIN]

    def _explain(self, before: str, formula: Parsed) -> None:
        """Take what the sentence of the last display goes on to say of its letters for what they were in it."""
        above = self.memory.display
        if above is not None and goes_on_with(before, ended=has_ended(above)):
            self.memory.given_at |= dict.fromkeys((defined_by(side)[0] for side in formula.sides), above.place)

    def _introduces_within(self, formula: Parsed, before: str) -> bool:
        r"""Whether an equation within the text says what a new letter is, though not alone: "where $L L^T = K$".

        So does "where $e^2 = 2 f - f^2$" of the square of a letter that no equation gives.
        """
        lone = [symbol for side in formula.sides if (symbol := defined_by(side)[0])]
        new = {*symbols_in(formula.sides[0])} - {*self.memory.asserted, *self.memory.vocabulary.definitions}
        if formula.relations == ("=",) and len(formula.sides) == 2 and self._gives_a_square(*formula.sides):
            return _BEGINS.search(before) is not None
        if formula.relations != ("=",) or len(lone) != 1 or not new:
            return False
        return lone[0] not in new and self.memory.vocabulary.is_matrix(lone[0])

    def _restricts_new(self, statement: Statement, formula: Parsed) -> bool:
        """Whether an equation within the text is of letters that its sentence introduces: "with $a^2 + b^2 = 1$"."""
        sentence = last_sentence(statement.display.before)
        same = (each.display for each in self.survey.statements[max(0, self.order - MOST_WITHIN) : self.order - 1])
        places = {each.place for each in same if f"${each.latex}$" in sentence}
        letters = {symbol for side in formula.sides for symbol in symbols_in(side)}
        return len(letters) > 1 and {self.memory.asserted.get(each) for each in letters} <= places

    def _gives_a_square(self, left: Formula, right: Formula) -> bool:
        base = without_power(left)
        symbol = defined_by(base)[0]
        given = {*self.memory.given_at, *self.memory.vocabulary.definitions, *symbols_in(right), ""}
        return base is not left and symbol not in given and says_more_than_a_number(right)

    def _displayed(
        self, statement: Statement, found: Parsed | UnreadableError, place: int
    ) -> tuple[Reading, list[Asked]]:
        display = statement.display
        number = statement.number or statement.label
        if isinstance(found, UnreadableError):
            where = self.survey.document.line_of(found.place) if found.place is not None else display.where
            reason = f"{where}: {found}"
            for symbol in self.survey.left_of(statement):
                self.memory.forget(symbol)
            return Reading(number, statement.latex, None, reason, (), statement), []
        found = self._with_new_letter_first(found)
        sides = [self.memory.vocabulary.text(side) for side in found.sides]
        read = sides[0] + "".join(
            f" {relation} {side}" for relation, side in zip(found.relations, sides[1:], strict=True)
        )
        links: list[Link] = []
        asked: list[Asked] = []
        if display is not self.memory.display:
            self.above = frozenset(self.memory.seen)
        self.memory.listen(statement)
        self.memory.ranges = tuple(self._ranges_beside(display, found))
        if reason := self.survey.meanings.reason(statement, found):
            self.memory.note(statement, found)
            self.memory.leave_open(found, display.part)
            self.memory.tie(found.sides)
            links = [Link("not decided", reason)] * max(1, len(found.relations))
            start, first = _without_rough_value(found)
            equal = bool(first.relations) and first.relations[0] in EQUALITIES
            if equal and not reason.endswith(VARIES):
                if tells(self.memory, statement, first, 0):
                    links[start] = Link("definition")
                elif gives_if_open(self.memory, statement, first) or names_its_letter(self.memory, statement, first):
                    links[start] = Link("definition", f"{OPEN}: {reason}")
                for index in range(1, len(links) if links[0].verdict == "definition" else 1):
                    if relates_new_letters(self.memory, found, index):
                        links[index] = Link("definition", f"{OPEN}: {reason}")
            if reason.endswith(SUMMED) and {*found.relations} == {"="}:
                asked = [*self._by_components(statement, found, place, links)]
                if not (self.memory.beside.is_conditional or statement.condition):
                    self.memory.summed += self.memory.premises_of(statement, found, found.sides)
            return Reading(number, statement.latex, read, "", tuple(links), statement, found), asked
        if says_on_what_it_depends(found) and defined_by(found.sides[0])[0] in self.memory.vocabulary.definitions:
            return Reading(number, statement.latex, read, "", (Link("definition"),), statement, found), []
        if found.relations[:1] == (":=",) and self.survey.says(r"\b<programs>\b"):
            self.memory.forget(defined_by(found.sides[0])[0])
        split_again(self.memory.vocabulary, found)
        definition = definition_in(self.memory, statement, found, explicit=False)
        shown = definition and definition.tree
        definition = definition and replace(self._as_computed(definition, found), ranges=self.memory.ranges)
        if definition is not None and definition.tree is not shown:
            self.closed.add(definition.where)
        plain = definition is not None and not (definition.explicit or definition.parameters)
        if plain and self.survey.indices.counted:
            repeats = gives_at_other_index(self._standing(statement, found), found.sides[0], found.sides[1])
            definition = None if repeats else definition
        if plain and self._is_supposed(found.sides[0]):
            definition = None
        begins = definition is not None or ":=" in found.relations or self._begins(statement, found)
        for index, relation in enumerate(found.relations):
            if index == 0 and definition is not None and not self.memory.ties(definition):
                rests = rests_of(self.memory.vocabulary, definition.tree)
                stated = stated_by(self.memory.vocabulary, definition.tree)
                links.append(Link("definition", rests_on=rests, asked=stated))
                self.memory.tie(found.sides[:1])
                continue
            behind = bool(index and begins) and (relation == "∈" or not {*symbols_in(found.sides[index + 1])})
            if (behind and relation in _RESTRICTING) or self._says_of_what_kind(found, index):
                links.append(Link("definition", "" if relation == "∈" else _not_judged(relation)))
                continue
            gives = (
                definition is not None
                if index == 0
                else begins
                and (relates_new_letters(self.memory, found, index) or self._is_residual(statement, found, index))
            ) or self._is_set_to_zero(found, index)
            link, question = self._link(statement, found, index, place, gives=gives)
            links.append(link)
            if question is not None:
                asked.append(question)
        if not found.relations:
            links.append(Link("not decided", "it has no sign such as = or <, so it states nothing"))
        if definition is not None:
            self.memory.vocabulary.define(definition)
            self.memory.asserted.setdefault(definition.symbol, display.place)
            self.memory.given_at[definition.symbol] = display.place
        else:
            self.memory.note(statement, found)
            self.memory.renew(statement, found)
        self.memory.give_anew(found)
        self.memory.take(statement, found, defines=definition is not None)
        return Reading(number, statement.latex, read, "", tuple(links), statement, found), asked

    def _as_computed(self, definition: Definition, formula: Parsed) -> Definition:
        r"""Return a definition that is computed, where a side behind it is: ``Q = \int_0^R f \, dr = a R^4``."""
        known, rest = self.memory.vocabulary, formula.sides[2:] if {*formula.relations} == {"="} else ()
        is_open = not definition.usable or any(map(is_integral, definition.tree.iter_subtrees()))
        if not (definition.holds and is_open):
            return definition
        others = (replace(definition, tree=each, usable=True) for each in rest if symbols_in(each))
        plain = (each for each in others if not is_circular(each.symbol, each.tree, known) and computes(each, known))
        return next(plain, definition)

    def _by_components(
        self, statement: Statement, formula: Parsed, place: int, links: Sequence[Link]
    ) -> Iterator[Asked]:
        """Yield what is asked of the links of a formula in index notation."""
        standing = self._standing(statement, formula)
        for index, link in enumerate(links):
            if ways := [*by_components(standing, *formula.sides[index : index + 2])]:
                yield Asked(place, index, ways, link, Manner(self.memory.beside.follows))

    def _is_residual(self, statement: Statement, formula: Parsed, index: int) -> bool:
        """Whether a link is a condition, as that of ``r = y - a x = 0`` in a display with several such equations."""
        own = (self.survey.formulas[id(each)] for each in self.survey.statements if each.display is statement.display)
        ends = [each.sides[-2:] for each in own if isinstance(each, Parsed) and len(each.sides) > 2]
        last = index + 2 == len(formula.sides)
        return last and sum(is_condition_on(*each) for each in ends) > 1 and is_condition_on(*formula.sides[-2:])

    def _is_set_to_zero(self, formula: Parsed, index: int) -> bool:
        """Whether a link is the condition at the end of a chain that a derivative is zero, as words say."""
        last = 0 < index == len(formula.sides) - 2 and is_condition_on(*formula.sides[index:])
        return last and derives(formula.sides[0]) and self.memory.optimizes and not self.memory.beside.is_denied

    def _says_of_what_kind(self, formula: Parsed, index: int) -> bool:
        r"""Whether an equation such as ``R \in \mathrm{SO}(3)`` says what letters are that no equation gives."""
        letters = introduced_by(formula.sides[0])
        given = {each for each, place in self.memory.given_at.items() if place != self.memory.beside.place}
        return (
            index == 0
            and formula.relations == ("∈",)
            and bool(letters)
            and letters.isdisjoint(given.union(self.memory.vocabulary.definitions))
            and not (self.memory.beside.is_condition or self.memory.beside.is_denied or self.memory.beside.follows)
        )

    def _begins(self, statement: Statement, formula: Parsed) -> bool:
        """Whether a chain begins with an equation that gives the letter on its left."""
        if formula.relations[1:] == () or formula.relations[0] not in EQUALITIES or not introduced_by(formula.sides[0]):
            return False
        return tells(self.memory, statement, formula, 0) or names_its_letter(self.memory, statement, formula)

    def _with_new_letter_first(self, formula: Parsed) -> Parsed:
        """Return a chain ``a b = s = c`` with s first, if s is a new letter: it says that s is a b, which is c.

        One that sets a derivative to zero has the zero at its end.
        """
        if {*formula.relations} == {"="} and formula.sides[1:2] == (ZERO,) and derives(formula.sides[0]):
            return replace(formula, sides=(formula.sides[0], *formula.sides[2:], ZERO))
        if formula.relations[:2] != ("=", "=") or defined_by(formula.sides[0])[0]:
            return formula
        first, second, *rest = formula.sides
        symbol, parameters = defined_by(second)
        known = self.memory.given_letters.union(self.memory.asserted, *map(symbols_in, (first, *rest)))
        return formula if parameters or symbol in known | {""} else replace(formula, sides=(second, first, *rest))

    def _link(
        self, statement: Statement, formula: Parsed, index: int, place: int, *, gives: bool
    ) -> tuple[Link, Asked | None]:
        left, right, relation = formula.sides[index], formula.sides[index + 1], formula.relations[index]
        rests = rests_of(self.memory.vocabulary, left, right)
        tied = index == 0 and self._is_supposed(left)
        gives = relation in EQUALITIES and not tied and (gives or tells(self.memory, statement, formula, index))
        self.memory.tie([left] if gives else [left, right])
        reason = self._reason_beside(left, right) if relation in EQUALITIES else _not_judged(relation)
        if reason:
            return Link("not decided", reason, rests), None
        ways = ways_of(self._standing(statement, formula), statement, formula, index)
        link = Link("not decided", rests_on=rests)
        start, first = _without_rough_value(formula)
        words, known = self.memory.beside, self.memory.vocabulary
        manner = Manner(
            words.follows,
            gives,
            may_give=index == start and gives_if_open(self.memory, statement, first),
            anew=begins_anew(self.memory, right) and not (words.follows or words.case_of_sentence),
            names=index == start and names_its_letter(self.memory, statement, first),
            chained=len(formula.sides) > 2,
            certain=not known.letters_of(left, right) and all(each.explicit for each in used_by(known, left, right)),
            identity=self.memory.is_named(statement, self.memory.given.identities),
        )
        return link, Asked(place, index, ways, link, manner)

    def _reason_beside(self, left: Formula, right: Formula) -> str:
        """Return why words, or the order of factors, leave open what two sides say; empty for no reason."""
        words, known = self.memory.beside, self.memory.vocabulary.definitions.get(defined_by(left)[0])
        if known is not None and known.tree == right and (word := words.amount(known.words)):
            return f"the word {word!r} beside it may mean another amount of it"
        said = [each.words for each in self.memory.serving if (left, right) in each.both_ways]
        said += [known.words] if known is not None and known.tree == right else []
        if said and (word := words.wider(frozenset().union(*said))):
            return f"the word {word!r} beside it may add what nothing above it says"
        if is_reordered(known.tree if known else left, right):
            return "the order of the factors may matter"
        letters = self.memory.vocabulary.letters_of(left, right)
        if self.memory.arithmetic and not any(map(self.memory.vocabulary.is_matrix, letters)):
            return f"the words {self.memory.arithmetic!r} above it may mean an arithmetic of other things"
        return ""

    def _standing(self, statement: Statement, formula: Parsed) -> Standing:
        """Return where a statement stands."""
        letters = frozenset(symbol for side in formula.sides for symbol in symbols_in(side))
        vocabulary = self.memory.known_here(letters)
        premises = [each for each in self.memory.serving if not self.memory.tells_of_another(each, letters)]
        place = statement.display.part, premises, self.memory.cited
        own = [*self._supposed, *self._explained_behind()]
        free = sorted(letters.difference(self.memory.vocabulary.definitions))
        own += set_to_zero(self.memory.beside, premises, free, self._place_above)
        summed = self.memory.serving_of(self.memory.summed)
        return Standing(self.survey, vocabulary, self.memory.beside, *place, self.memory.given_at, own, summed)

    @property
    def _supposed(self) -> list[Premise]:
        """The equations within the text that the sentence of the display supposes before it."""
        return [each for words, each in self.within if supposes(self.memory.beside, words)]

    def _is_supposed(self, side: Formula) -> bool:
        """Whether these give a side of the display, or have its value: the prover is asked whether it follows."""
        gives = {each.gives.symbol for each in self._supposed if each.gives}
        values = [part for one in sides_of(self._supposed) for part in one.iter_subtrees()]
        return defined_by(side)[0] in gives or (side.data in ("function", "call") and side in values)

    @property
    def _place_above(self) -> int:
        """Where the display above the one that is read begins, or above the first one of its sentence."""
        displays = (each.display for each in self.survey.statements[: self.order][::-1])
        below = self.memory.display
        for each in displays:
            if each.environment != "inline" and each is not below:
                if below is None or below.before.strip():
                    return each.place
                below = each
        return -1

    def _ranges_beside(self, display: Display, formula: Parsed) -> Iterator[Parsed]:
        """Yield the ranges that stand in a display, and within the text in its sentence."""
        before, behind = last_sentence(display.before), display.after.partition(".")[0]
        parameters = defined_by(formula.sides[0])[1]
        yield from ranges_said(f"{before} . {behind}", parameters[0] if len(parameters) == 1 else "")
        for each in self.survey.statements[max(0, self.order - MOST_WITHIN) : self.order + MOST_WITHIN]:
            within = f"${each.display.latex}$"
            inline = each.display.environment == "inline" and (within in before or within in behind)
            if each.display is display or (inline and each.display.part == display.part):
                found = range_in(each, self.survey.formulas[id(each)])
                if found is not None:
                    yield found

    def _explained_behind(self) -> Iterator[Premise]:
        r"""Yield the equations with which the sentence of a display goes on: "where $w^2 = k/m$", "where \[a = b\]"."""
        following = self.survey.statements[self.order : self.order + MOST_WITHIN]
        here = self.memory.display
        ended = here is None or has_ended(here)
        above = here
        for each in following:
            found, display = self.survey.formulas[id(each)], each.display
            if display.environment != "inline":
                if display is not above and not goes_on_in_display(display.before, first=above is here):
                    return
                yield from self._given_behind(each, found)
                above = display
            elif above is not here or not goes_on_with(display.before, ended=ended):
                return
            elif (
                isinstance(found, Parsed)
                and {*found.relations} == {"="}
                and not self.survey.meanings.reason(each, found)
            ):
                formula = f"${display.latex}$"
                behind = re.split(r"\.|\$|\\\(", display.after)[0].strip().removesuffix("and")
                behind = "" if _SAYS_THE_SAME.match(behind) else behind
                sentence = f"{display.before}{formula}{behind}"
                said = names_behind(sentence, formula, display.after) and defined_by(found.sides[0])[0]
                if said or supposes(replace(self.memory.beside, sentence=sentence), formula):
                    yield from self.memory.premises_of(each, found, found.sides)

    def _given_behind(self, statement: Statement, formula: Parsed | UnreadableError) -> Iterator[Premise]:
        """Yield an equation of a display that says what a letter is of which nothing was said before."""
        if isinstance(formula, Parsed) and {*formula.relations} == {"="} and not statement.condition:
            symbol = defined_by(formula.sides[0])[0]
            known = {"", *self.above, *self.memory.vocabulary.definitions, *symbols_in(formula.sides[1])}
            if symbol not in known and not self.survey.meanings.reason(statement, formula):
                yield from self.memory.premises_of(statement, formula, formula.sides[:2])
