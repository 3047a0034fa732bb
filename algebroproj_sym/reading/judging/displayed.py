"""A displayed equation: what each of its links says, or what the prover is asked of it."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from algebroproj_sym.reading.asking.questions import rests_of, stated_by
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.recognising import (
    EQUALITIES,
    computes,
    defined_by,
    introduced_by,
    is_circular,
    is_reordered,
)
from algebroproj_sym.reading.deriving.integrating import is_integral
from algebroproj_sym.reading.deriving.rates import ZERO
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.judging.deciding import OPEN, Asked, Manner
from algebroproj_sym.reading.judging.verdicts import Link, Reading
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in
from algebroproj_sym.reading.prose.meanings import SUMMED, VARIES
from algebroproj_sym.reading.remembering.hearing import listen
from algebroproj_sym.reading.remembering.introducing import (
    begins_anew,
    definition_in,
    gives_if_open,
    is_condition_on,
    names_its_letter,
    relates_new_letters,
    says_on_what_it_depends,
    split_again,
    tells,
)
from algebroproj_sym.reading.remembering.keeping import forget_other_functions, keep, renew
from algebroproj_sym.reading.remembering.memory import Memory
from algebroproj_sym.reading.remembering.stationary import derives
from algebroproj_sym.reading.remembering.surroundings import is_supposed, ranges_beside, standing_at
from algebroproj_sym.reading.ways.components import by_components
from algebroproj_sym.reading.ways.indexing import gives_at_other_index
from algebroproj_sym.reading.ways.trying import ways_of

_RESTRICTING = ("∈", "<", "<=", ">", ">=")
"""The signs that say in what range a letter is, behind what it is: ``f = a - b <= 0`` is a condition on f."""


def take_displayed(
    memory: Memory, statement: Statement, found: Parsed | UnreadableError, place: int
) -> tuple[Reading, list[Asked]]:
    """Take in a displayed equation; return what is known of it, and what is to be asked of it, by its place."""
    number = statement.number or statement.label
    if isinstance(found, UnreadableError):
        for symbol in memory.survey.left_of(statement):
            memory.forget(symbol)
        where = memory.survey.document.line_of(found.place) if found.place is not None else statement.display.where
        return Reading(number, statement.latex, None, f"{where}: {found}", (), statement), []
    formula = _with_new_letter_first(memory, found)
    first, *others = map(memory.vocabulary.text, formula.sides)
    read = first + "".join(f" {relation} {side}" for relation, side in zip(formula.relations, others, strict=True))
    if statement.display is not memory.display:
        memory.above = frozenset(memory.seen)
    listen(memory, statement)
    memory.ranges = tuple(ranges_beside(memory, statement.display, formula))
    if reason := memory.survey.meanings.reason(statement, formula):
        links, asked = _left_open(memory, statement, formula, place, reason)
    elif says_on_what_it_depends(formula) and defined_by(formula.sides[0])[0] in memory.vocabulary.definitions:
        links, asked = [Link("definition")], []
    else:
        links, asked = _judged(memory, statement, formula, place)
    return Reading(number, statement.latex, read, "", tuple(links), statement, formula), asked


def _left_open(
    memory: Memory, statement: Statement, formula: Parsed, place: int, reason: str
) -> tuple[list[Link], list[Asked]]:
    """Return the links of an equation with something that is not computed: it may give its letter none the less."""
    memory.note(statement, formula)
    memory.leave_open(formula, statement.display.part)
    memory.tie(formula.sides)
    links = [Link("not decided", reason)] * max(1, len(formula.relations))
    start, first = _without_rough_value(formula)
    equal = bool(first.relations) and first.relations[0] in EQUALITIES
    if equal and not reason.endswith(VARIES):
        if tells(memory, statement, first, 0):
            links[start] = Link("definition")
        elif gives_if_open(memory, statement, first) or names_its_letter(memory, statement, first):
            links[start] = Link("definition", f"{OPEN}: {reason}")
        for index in range(1, len(links) if links[0].verdict == "definition" else 1):
            if relates_new_letters(memory, formula, index):
                links[index] = Link("definition", f"{OPEN}: {reason}")
    if not (reason.endswith(SUMMED) and {*formula.relations} == {"="}):
        return links, []
    asked = [*_by_components(memory, statement, formula, place, links)]
    if not (memory.beside.is_conditional or statement.condition):
        memory.summed += memory.premises_of(statement, formula, formula.sides)
    return links, asked


def _judged(memory: Memory, statement: Statement, formula: Parsed, place: int) -> tuple[list[Link], list[Asked]]:
    """Return the links of an equation; keep the definition, or the premise, that it is."""
    if formula.relations[:1] == (":=",) and memory.survey.says(r"\b<programs>\b"):
        memory.forget(defined_by(formula.sides[0])[0])
    forget_other_functions(memory, formula)
    split_again(memory.vocabulary, formula)
    definition = _definition_in(memory, statement, formula)
    begins = definition is not None or ":=" in formula.relations or _begins(memory, statement, formula)
    links, asked = list[Link](), list[Asked]()
    for index in range(len(formula.relations)):
        if (told := _told(memory, formula, index, definition, begins=begins)) is not None:
            links.append(told)
            continue
        gives = definition is not None
        if index > 0:
            new = begins and relates_new_letters(memory, formula, index)
            gives = new or (begins and _is_residual(memory, statement, formula, index))
        gives = gives or _is_set_to_zero(memory, formula, index)
        link, question = _link(memory, statement, formula, index, place, gives=gives)
        links.append(link)
        asked += [question] if question is not None else []
    if not formula.relations:
        links.append(Link("not decided", "it has no sign such as = or <, so it states nothing"))
    if definition is not None:
        memory.vocabulary.define(definition)
        memory.asserted.setdefault(definition.symbol, statement.display.place)
        memory.given_at[definition.symbol] = statement.display.place
    else:
        memory.note(statement, formula)
        renew(memory, statement, formula)
    memory.give_anew(formula)
    keep(memory, statement, formula, defines=definition is not None)
    return links, asked


def _definition_in(memory: Memory, statement: Statement, formula: Parsed) -> Definition | None:
    """Return what an equation defines, if it repeats nothing at another index, and nothing supposed gives it."""
    shown = definition_in(memory, statement, formula, explicit=False)
    if shown is None:
        return None
    definition = replace(_as_computed(memory, shown, formula), ranges=memory.ranges)
    if definition.tree is not shown.tree:
        memory.closed.add(definition.where)
    if definition.explicit or definition.parameters:
        return definition
    counted = memory.survey.indices.counted
    if counted and gives_at_other_index(standing_at(memory, statement, formula), *formula.sides[:2]):
        return None
    return None if is_supposed(memory, formula.sides[0]) else definition


def _told(memory: Memory, formula: Parsed, index: int, definition: Definition | None, *, begins: bool) -> Link | None:
    """Return a link that needs no question: it gives a letter, or says in what range or of what kind it is."""
    relation = formula.relations[index]
    if index == 0 and definition is not None and not memory.ties(definition):
        known = memory.known_here(frozenset(definition.symbols))
        rests, stated = rests_of(known, definition.tree), stated_by(known, definition.tree)
        memory.tie(formula.sides[:1])
        return Link("definition", rests_on=rests, asked=stated)
    behind = bool(index and begins) and (relation == "∈" or not {*symbols_in(formula.sides[index + 1])})
    if (behind and relation in _RESTRICTING) or _says_of_what_kind(memory, formula, index):
        return Link("definition", "" if relation == "∈" else _not_judged(relation))
    return None


def _as_computed(memory: Memory, definition: Definition, formula: Parsed) -> Definition:
    r"""Return a definition that is computed, where a side behind it is: ``Q = \int_0^R f \, dr = a R^4``."""
    known, rest = memory.vocabulary, formula.sides[2:] if {*formula.relations} == {"="} else ()
    is_open = not definition.usable or any(map(is_integral, definition.tree.iter_subtrees()))
    if not (definition.holds and is_open):
        return definition
    others = (replace(definition, tree=each, usable=True) for each in rest if symbols_in(each))
    plain = (each for each in others if not is_circular(each.symbol, each.tree, known) and computes(each, known))
    return next(plain, definition)


def _by_components(
    memory: Memory, statement: Statement, formula: Parsed, place: int, links: Sequence[Link]
) -> Iterator[Asked]:
    """Yield what is asked of the links of a formula in index notation."""
    standing = standing_at(memory, statement, formula)
    for index, link in enumerate(links):
        if ways := [*by_components(standing, *formula.sides[index : index + 2])]:
            yield Asked(place, index, ways, link, Manner(memory.beside.follows))


def _is_residual(memory: Memory, statement: Statement, formula: Parsed, index: int) -> bool:
    """Whether a link is a condition, as that of ``r = y - a x = 0`` in a display with several such equations."""
    own = (memory.survey.formulas[id(each)] for each in memory.survey.statements if each.display is statement.display)
    ends = [each.sides[-2:] for each in own if isinstance(each, Parsed) and len(each.sides) > 2]
    last = index + 2 == len(formula.sides)
    return last and sum(is_condition_on(*each) for each in ends) > 1 and is_condition_on(*formula.sides[-2:])


def _is_set_to_zero(memory: Memory, formula: Parsed, index: int) -> bool:
    """Whether a link is the condition at the end of a chain that a derivative is zero, as words say."""
    last = 0 < index == len(formula.sides) - 2 and is_condition_on(*formula.sides[index:])
    return last and derives(formula.sides[0]) and memory.optimizes and not memory.beside.is_denied


def _says_of_what_kind(memory: Memory, formula: Parsed, index: int) -> bool:
    r"""Whether an equation such as ``R \in \mathrm{SO}(3)`` says what letters are that no equation gives."""
    letters = introduced_by(formula.sides[0])
    given = {each for each, place in memory.given_at.items() if place != memory.beside.place}
    return (
        index == 0
        and formula.relations == ("∈",)
        and bool(letters)
        and letters.isdisjoint(given.union(memory.vocabulary.definitions))
        and not (memory.beside.is_condition or memory.beside.is_denied or memory.beside.follows)
    )


def _begins(memory: Memory, statement: Statement, formula: Parsed) -> bool:
    """Whether a chain begins with an equation that gives the letter on its left."""
    if formula.relations[1:] == () or formula.relations[0] not in EQUALITIES or not introduced_by(formula.sides[0]):
        return False
    return tells(memory, statement, formula, 0) or names_its_letter(memory, statement, formula)


def _with_new_letter_first(memory: Memory, formula: Parsed) -> Parsed:
    """Return a chain ``a b = s = c`` with s first, if s is a new letter: it says that s is a b, which is c.

    One that sets a derivative to zero has the zero at its end.
    """
    if {*formula.relations} == {"="} and formula.sides[1:2] == (ZERO,) and derives(formula.sides[0]):
        return replace(formula, sides=(formula.sides[0], *formula.sides[2:], ZERO))
    if formula.relations[:2] != ("=", "=") or defined_by(formula.sides[0])[0]:
        return formula
    first, second, *rest = formula.sides
    symbol, parameters = defined_by(second)
    known = memory.given_letters.union(memory.asserted, *map(symbols_in, (first, *rest)))
    return formula if parameters or symbol in known | {""} else replace(formula, sides=(second, first, *rest))


def _link(
    memory: Memory, statement: Statement, formula: Parsed, index: int, place: int, *, gives: bool
) -> tuple[Link, Asked | None]:
    left, right, relation = formula.sides[index], formula.sides[index + 1], formula.relations[index]
    rests = rests_of(memory.vocabulary, left, right)
    tied = index == 0 and is_supposed(memory, left)
    gives = relation in EQUALITIES and not tied and (gives or tells(memory, statement, formula, index))
    memory.tie([left] if gives else [left, right])
    reason = _reason_beside(memory, left, right) if relation in EQUALITIES else _not_judged(relation)
    if reason:
        return Link("not decided", reason, rests), None
    ways = ways_of(standing_at(memory, statement, formula), statement, formula, index)
    link = Link("not decided", rests_on=rests)
    start, first = _without_rough_value(formula)
    words, known = memory.beside, memory.vocabulary
    manner = Manner(
        words.follows,
        gives,
        may_give=index == start and gives_if_open(memory, statement, first),
        anew=begins_anew(memory, right) and not (words.follows or words.case_of_sentence),
        names=index == start and names_its_letter(memory, statement, first),
        chained=len(formula.sides) > 2,
        certain=not known.letters_of(left, right) and all(each.explicit for each in known.used_in(left, right)),
        identity=memory.is_named(statement, memory.given.identities),
    )
    return link, Asked(place, index, ways, link, manner)


def _reason_beside(memory: Memory, left: Formula, right: Formula) -> str:
    """Return why words, or the order of factors, leave open what two sides say; empty for no reason."""
    words, known = memory.beside, memory.vocabulary.definitions.get(defined_by(left)[0])
    if known is not None and known.tree == right and (word := words.amount(known.words)):
        return f"the word {word!r} beside it may mean another amount of it"
    said = [each.words for each in memory.serving if (left, right) in each.both_ways]
    said += [known.words] if known is not None and known.tree == right else []
    if said and (word := words.wider(frozenset().union(*said))):
        return f"the word {word!r} beside it may add what nothing above it says"
    if is_reordered(known.tree if known else left, right):
        return "the order of the factors may matter"
    letters = memory.vocabulary.letters_of(left, right)
    if memory.arithmetic and not any(map(memory.vocabulary.is_matrix, letters)):
        return f"the words {memory.arithmetic!r} above it may mean an arithmetic of other things"
    return ""


def _without_rough_value(formula: Parsed) -> tuple[int, Parsed]:
    r"""Return a chain from where it is exact, and how many sides that leaves out: ``a \approx s = b`` gives s."""
    place = int(formula.relations[:1] == ("≈",) and len(formula.sides) > 2)
    return place, replace(formula, sides=formula.sides[place:], relations=formula.relations[place:])


def _not_judged(relation: str) -> str:
    return f"the sign {relation} is read, but not judged"
