"""Whether what an equation rests on is said of the same thing: where a word beside it is new, that is a hypothesis."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.judging.sentences import last_sentence, words_of
from algebroproj_sym.reading.judging.verdicts import TRUE_HERE, Link, Reading
from algebroproj_sym.reading.judging.words import beside, has_ended

_LINE = re.compile(r"\bline \d+(?: of [^,;]+)?")


def with_what_is_true_here(readings: Sequence[Reading], statements: Sequence[Statement]) -> list[Reading]:
    """Return readings in which what follows names the lines that may be true of another thing only.

    They are those of which the sentence has not all words that the sentence of the equation has.
    """
    words: dict[str, frozenset[str]] = {}
    for each in statements:
        behind = "" if has_ended(each.display) else each.display.after.partition(".")[0]
        sentence = f"{last_sentence(each.display.before)} {behind}"
        where = str(each.display.where)
        words[where] = words.get(where, frozenset()) | words_of(sentence)
    return [replace(each, links=tuple(_with_lines(each, link, words) for link in each.links)) for each in readings]


def _with_lines(reading: Reading, link: Link, words: Mapping[str, frozenset[str]]) -> Link:
    if link.verdict != "follows":
        return link
    near = beside(reading.statement, "")
    lines = dict.fromkeys(line for each in link.rests_on for line in _LINE.findall(each) if line in words)
    new = {line: word for line in lines if line != str(reading.where) and (word := near.strange(words[line]))}
    found = (f"{line} {TRUE_HERE}, where the word {word!r} is new" for line, word in new.items())
    return replace(link, hypotheses=(*link.hypotheses, *found))
