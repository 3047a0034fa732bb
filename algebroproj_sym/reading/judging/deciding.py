"""Every relation decided: as it stands, in other ways, and with the smallest changes."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, islice

from lark import Token, Tree

from algebroproj_sym.expressions import entries, free_symbols
from algebroproj_sym.proving import Ask, Outcome, Question
from algebroproj_sym.proving.letters.deciding import NOWHERE
from algebroproj_sym.proving.reals.prove import often_agree
from algebroproj_sym.proving.statements import has_functions
from algebroproj_sym.reading.asking.answering import answers
from algebroproj_sym.reading.asking.doubts import A_CONDITION, NOT_COMPUTED, NOT_GIVEN
from algebroproj_sym.reading.asking.questions import (
    Way,
    asked_of,
    has_letters,
    is_lettered,
    rests_of,
    values_of,
)
from algebroproj_sym.reading.asking.sampling import agree, samples_of
from algebroproj_sym.reading.defining.sizing import FREE
from algebroproj_sym.reading.deriving.rates import ZERO
from algebroproj_sym.reading.judging.mending import MOST_ASKED, is_trivial, likely_repairs, repairs_in
from algebroproj_sym.reading.judging.repairs import MULTIPLE, STRONG, Repair
from algebroproj_sym.reading.judging.verdicts import Link
from algebroproj_sym.reading.parsing.grammar import Formula

NOT_DERIVED = "it defines its letter; that it follows is not proved"
OPEN = "it defines its letter; whether it follows is not decided"


Answer = tuple[tuple[Question, ...], Outcome]
UNASKED = Outcome("open", "none", 0.0, "it is not asked: another way is proved")


@dataclass(frozen=True)
class Manner:
    """What the verdict of a link depends on, besides the answers of the prover."""

    claimed: bool
    """Whether words say that it follows."""
    gives: bool = False
    """Whether it gives its letter, unless it follows."""
    may_give: bool = False
    """Whether it gives its letter, if nothing tells whether it follows."""
    anew: bool = False
    """Whether it has letters of which nothing was said."""
    names: bool = False
    """Whether it names its letter, which nobody may be able to compute."""
    chained: bool = False
    """Whether it is part of a chain."""
    certain: bool = False
    """Whether it has numbers alone, of which nothing else is known."""
    identity: bool = False
    """Whether the symbols file says that it holds for all values of its letters."""


@dataclass
class Asked:
    """A link that is yet to be decided: as it stands, and in other ways."""

    reading: int
    place: int
    ways: list[Way]
    link: Link
    manner: Manner
    answers: list[Outcome] = field(default_factory=list)


def decide(asked: Sequence[Asked], ask: Ask) -> None:
    """Decide every link, first as it stands, then in other ways, then with single changes."""
    failing: list[tuple[Asked, Way, Outcome]] = []
    for each, found in zip(asked, _answered(asked, ask), strict=True):
        each.answers = [answer for _, answer in found]
        place = _place_of_proof(each.answers)
        each.link = replace(_link_of(each, each.answers[place], each.ways[place]), asked=found[place][0])
        if each.link.verdict != "follows":
            answered = zip(each.ways, each.answers, strict=True)
            failing += [(each, *one) for one in answered if _refutes(*one)]
    candidates = [
        [] if way.doubt in (A_CONDITION, NOT_GIVEN) else likely_repairs(way, chained=each.manner.chained)
        for each, way, _ in failing
    ]
    found = answers([way for changes in candidates for _, way in changes], ask)
    for (each, way, refutation), changes in zip(failing, candidates, strict=True):
        tried = [(repair, changed, *found.pop(0)) for repair, changed in changes]
        proved = (one for one in tried if one[3].verdict == "proved")
        best = next((one for one in proved if way.right != ZERO or not is_trivial(one[1])), None)
        link = _refuted(each, way, refutation, best[0] if best else None, best[1] if best else way)
        if best and len(best[2]) == 1 and best[1].left is way.left:
            link = replace(link, corrected=best[2][0].rhs)
        if way is each.ways[0] or _says(link) > _says(each.link):
            each.link = link
    for each in asked:
        if each.manner.gives and each.link.verdict != "follows" and not any(_says(each.link)):
            rests = rests_of(each.ways[0].vocabulary, each.ways[0].right)
            each.link = Link("definition", NOT_DERIVED if each.manner.claimed else "", rests_on=rests)
    _suggest([each for each in asked if _may_be_misprinted(each)], ask)
    for each in asked:
        verdict, manner = each.link.verdict, each.manner
        gives = manner.names or (manner.may_give and (verdict == "not decided" or manner.anew))
        if gives and verdict in ("not decided", "independent") and not any(_says(each.link)):
            why = f"{OPEN}: {each.link.reason}" if each.link.reason else OPEN
            each.link = Link("definition", why, rests_on=rests_of(each.ways[0].vocabulary, each.ways[0].right))


def _answered(asked: Sequence[Asked], ask: Ask) -> list[list[Answer]]:
    """Return what became of all ways: each link is asked in one way after the other, until there is a proof."""
    found: list[list[Answer]] = [[((), UNASKED)] * len(each.ways) for each in asked]
    for place in range(max((len(each.ways) for each in asked), default=0)):
        open_links = [one for one, answered in enumerate(found) if place < _first_proof(answered)]
        told = answers([asked[one].ways[place] for one in open_links], ask)
        for one, answer in zip(open_links, told, strict=True):
            found[one][place] = answer
    return found


def _first_proof(found: Sequence[Answer]) -> int:
    """Return the place of the first proof; that of the end if none is there, or it inverts a matrix."""
    place = next((i for i, (_, answer) in enumerate(found) if answer.verdict == "proved"), len(found))
    inverts = place < len(found) and any(each.startswith("det(") for each in found[place][1].hypotheses)
    return len(found) if inverts else place


def _refutes(way: Way, answer: Outcome) -> bool:
    return answer.verdict == "refuted" and way.is_as_it_stands


def _may_be_misprinted(asked: Asked) -> bool:
    """Whether a link that says nothing yet may be one with a misprint: what gives its letter is said to follow."""
    is_open = asked.link.verdict in ("independent", "not decided")
    return not asked.link.suggestion and (is_open or (asked.link.verdict == "definition" and asked.manner.claimed))


def _suggest(asked: Sequence[Asked], ask: Ask) -> None:
    """Tell by which change links would follow in the other ways; their verdicts remain as they are."""
    candidates = [
        [*islice(chain.from_iterable(map(repairs_in, each.ways, each.answers)), MOST_ASKED)] for each in asked
    ]
    found = answers([way for changes in candidates for _, way in changes], ask)
    for each, changes in zip(asked, candidates, strict=True):
        tried = [(repair, way, found.pop(0)[1]) for repair, way in changes]
        proved = (one for one in tried if one[2].verdict == "proved" and not is_trivial(one[1]))
        if best := next(proved, None):
            each.link = replace(each.link, suggestion=_suggestion(best[1], best[0]))


def _suggestion(way: Way, repair: Repair) -> str:
    now, before = (way.vocabulary.text(tree) for tree in (repair.now, repair.before))
    return f"{now} instead of {before}"


def _place_of_proof(answered: Sequence[Outcome]) -> int:
    """Return the first way that is proved, or else the first one.

    It is the one that nothing satisfies if what is inverted has no inverse where all is put in that is known of it.
    """
    place = next((i for i, answer in enumerate(answered) if answer.verdict == "proved"), 0)
    inverts = any(each.startswith("det(") for each in answered[place].hypotheses)
    return next((i for i, answer in enumerate(answered) if inverts and answer.reason == NOWHERE), place)


def _says(link: Link) -> tuple[bool, bool]:
    """Return how much a link that does not follow says."""
    return link.verdict == "contradicts", bool(link.suggestion)


def _doubt_of_refutation(way: Way) -> str:
    """Return why sides that differ at a point may still be meant to be equal; empty for no reason."""
    questions = asked_of(way.vocabulary, *way.sides)
    assert isinstance(questions, list)
    letters = questions[0].letters
    if any(re.search(r"[a-z]x|x[a-z]", text.partition(" ")[0]) for text in (letters or {}).values()):
        return "the document does not state the sizes of its matrices"
    if values := values_of(questions):
        if values == {FREE}:
            return "no equation above it defines the function"
        return f"a function, a sum or an integral in it {NOT_COMPUTED}"
    if letters is not None:
        return ""
    if _are_opposite(way):
        return "its sides differ in sign: for quaternions and homogeneous vectors both may mean the same"
    elementary = [each for each in questions if has_functions(each.lhs) or has_functions(each.rhs)]
    positive = bool(elementary) and all(often_agree(each.lhs, each.rhs) for each in elementary)
    return "it holds where its letters are positive" if positive else ""


def _are_opposite(way: Way) -> bool:
    """Whether a vector or a matrix is printed on both sides, with the opposite sign in all of its entries."""
    if not all(side.data == "matrix" for side in way.sides):
        return False
    opposite: Formula = Tree("sum", [Token("SIGN", "-"), way.right])
    return len(entries(way.vocabulary.value(way.left))) > 1 and agree(samples_of(way.vocabulary), (way.left, opposite))


def _link_of(asked: Asked, outcome: Outcome, way: Way) -> Link:
    """Return the verdict of a link, as far as it is decided without changes."""
    link = asked.link
    if outcome.verdict == "proved":
        return replace(
            link,
            verdict="follows",
            reason=f"read as {way.reads}" if way.reads else "",
            rests_on=way.rests_on,
            hypotheses=(*way.supposes, *map(way.vocabulary.names.spelled, outcome.hypotheses)),
            certificate=outcome.certificate,
        )
    why = ("the prover cannot read it: " if outcome.unreadable else "") + outcome.reason
    return replace(link, reason=link.reason or why)


def _holds_beside(way: Way, repaired: Way) -> bool:
    """Whether two entries with letters hold, and a change that makes all hold does not concern them."""
    if is_lettered(way):
        return False
    before, after = ([*map(entries, map(way.vocabulary.value, each.sides))] for each in (way, repaired))
    same = [a for a, b, c, d in zip(*before, *after, strict=True) if (a, b) == (c, d) and free_symbols(a)]
    return len(same) >= 2


def _refuted(asked: Asked, way: Way, refutation: Outcome, repair: Repair | None, repaired: Way) -> Link:
    """Return the verdict of a link that fails at a point, and of the smallest change by which it would follow."""
    suggestion = "" if repair is None else _suggestion(way, repair)
    doubt = _doubt_of_refutation(way)
    doubt = doubt if doubt.endswith(NOT_COMPUTED) else way.doubt or doubt
    plain = way is asked.ways[0]
    certain = not doubt and (
        (plain and asked.manner.certain)
        or (
            repair is not None
            and (
                repair.kind in STRONG
                or (repair.kind == MULTIPLE and asked.manner.chained)
                or (repair.kind == "letter" and _holds_beside(way, repaired))
            )
        )
    )
    asserted = certain or (plain and asked.manner.identity and not (doubt and has_letters(way)))
    reason = "" if asserted else doubt or "it holds for some values of its letters, but not for all"
    undecided = doubt.endswith(NOT_COMPUTED)
    return replace(
        asked.link,
        verdict="contradicts" if asserted else "not decided" if undecided else "independent",
        reason=reason,
        rests_on=way.rests_on,
        counterexample=refutation.counterexample,
        suggestion=suggestion,
        certificate=refutation.certificate,
    )
