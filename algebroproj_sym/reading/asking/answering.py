"""What the prover answers, and what the answers to all questions of a way come to."""

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from itertools import islice

from algebroproj_sym.proving import Ask, Outcome, Question, asking
from algebroproj_sym.reading.asking.questions import Way, asked_under, complex_letters_in


@contextmanager
def asking_once(seconds: float, jobs: int) -> Iterator[Ask]:
    """Give what decides questions as `asking` does, and each of them once."""
    with asking(seconds=seconds, jobs=jobs) as ask:
        known: dict[str, Outcome] = {}

        def told(questions: Sequence[Question]) -> list[Outcome]:
            new = {repr(each): each for each in questions if repr(each) not in known}
            known.update(zip(new, ask([*new.values()]), strict=True))
            return [known[repr(each)] for each in questions]

        yield told


def answers(ways: Sequence[Way], ask: Ask) -> list[tuple[tuple[Question, ...], Outcome]]:
    """Return the questions of each way with the outcome; one that cannot be asked is open."""
    asked = [asked_under(each) for each in ways]
    told = iter(ask([question for group in asked if isinstance(group, list) for question in group]))
    return [
        (tuple(each), _of_questions(way, each, [*islice(told, len(each))]))
        if isinstance(each, list)
        else ((), Outcome("open", "none", 0.0, each))
        for way, each in zip(ways, asked, strict=True)
    ]


def _of_questions(way: Way, questions: Sequence[Question], told: Sequence[Outcome]) -> Outcome:
    """Return what the outcomes of all questions of a way come to."""
    found = _without_opposite_roots(_of_entries(_without_squares(way, told)))
    return _at_each_step(way, _with_letters(questions, _with_each_once(found)))


def _without_squares(way: Way, found: Sequence[Outcome]) -> Sequence[Outcome]:
    """Return the outcomes of a way: a sum of squares that is zero proves nothing of complex numbers."""
    if not any(map(_is_of_squares, found)) or not complex_letters_in(way.vocabulary, *way.sides, *way.given):
        return found
    return [
        Outcome("open", "none", each.seconds, "it is shown for real numbers only") if _is_of_squares(each) else each
        for each in found
    ]


def _at_each_step(way: Way, outcome: Outcome) -> Outcome:
    """Return an outcome; what is to hold at the last step of an induction is to hold at each one."""
    if not way.last:
        return outcome
    letter = re.compile(rf"(?<![a-zA-Z_]){re.escape(way.vocabulary.name(way.last))}(?![a-zA-Z_])")
    smaller = f", also for each smaller {way.vocabulary.name(way.last)}"
    return replace(
        outcome, hypotheses=tuple(f"{each}{smaller}" if letter.search(each) else each for each in outcome.hypotheses)
    )


def _is_of_squares(outcome: Outcome) -> bool:
    certificate = outcome.certificate or {}
    return "sums of squares" in (certificate.get("method"), certificate.get("proof", {}).get("method"))


def _with_letters(questions: Sequence[Question], outcome: Outcome) -> Outcome:
    """Return an outcome with what its letters are taken for among its hypotheses; a sum has the size of its terms."""
    letters = {name: text for each in questions for name, text in (each.letters or {}).items() if name[-1:] != "_"}
    below = dict.fromkeys(
        each for one in questions for each in one.nonzero if not {each, f"{each} != 0"} & {*outcome.hypotheses}
    )
    taken = (*below, *(f"{name} is {text}" for name, text in letters.items()))
    return replace(outcome, hypotheses=(*outcome.hypotheses, *taken))


def _with_each_once(outcome: Outcome) -> Outcome:
    """Return an outcome in which no letter is said not to be zero with a minus as well."""
    plain = (re.sub(r"^-(?=\w+ != 0$)", "", each) for each in outcome.hypotheses)
    return replace(outcome, hypotheses=tuple(dict.fromkeys(plain)))


def _without_opposite_roots(outcome: Outcome) -> Outcome:
    """Return an outcome; no proof if it holds but where something and its opposite are both the square of a root."""
    roots = {each for each in outcome.hypotheses if each.endswith(" >= 0")}
    if outcome.verdict == "proved" and any(f"-{each}" in roots for each in roots):
        return Outcome("open", "none", outcome.seconds, "it is shown only where a root in it is zero")
    return outcome


def _of_entries(found: Sequence[Outcome]) -> Outcome:
    """Return what the outcomes of all entries come to."""
    if len(found) == 1:
        return found[0]
    decisive = next((each for each in found if each.verdict == "refuted"), None)
    decisive = decisive or next((each for each in found if each.verdict != "proved"), None)
    if decisive is not None:
        return decisive
    hypotheses = tuple(dict.fromkeys(name for each in found for name in each.hypotheses))
    certificate = {"method": "entries", "entries": [each.certificate for each in found]}
    return Outcome("proved", "entries", sum(each.seconds for each in found), "", hypotheses, None, certificate)
