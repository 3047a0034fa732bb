"""Whether what an equation rests on is said of the same thing: where a word is new, that is a hypothesis."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from algebroproj_sym.reading.defining.contexts import context_of
from algebroproj_sym.reading.documents.displays import Display
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.judging.sentences import last_sentence, strange_word, words_of
from algebroproj_sym.reading.judging.verdicts import TRUE_HERE, Link, Reading
from algebroproj_sym.reading.judging.words import beside, has_ended

_NAME = re.compile(r"\b(?:the|an?) (?:[\w-]+ ){1,2}(?:equation|formula|identity|relation|law)\b", re.IGNORECASE)
"""What an equation is called, as in "This gives the lens equation"."""
_LINE = re.compile(r"\bline \d+(?: of [^,;]+)?")


@dataclass(frozen=True)
class _Said:
    """The words of the sentences of a line."""

    words: frozenset[str]
    """All of them."""
    place: int
    """Where its first display begins."""
    is_limited: bool
    """Whether a sentence begins with where it holds."""


def with_what_is_true_here(readings: Sequence[Reading], statements: Sequence[Statement]) -> list[Reading]:
    """Return readings in which what follows names the lines that may be true of another thing only.

    They are those of which the sentence has not all words of the sentence of the equation.  If it begins with where it
    holds, it must have those of all sentences since then.
    """
    said: dict[str, _Said] = {}
    displays = {each.display.place: each.display for each in statements if each.display.environment != "inline"}
    for each in statements:
        display, where = each.display, str(each.display.where)
        sentence = last_sentence(display.before)
        words = words_of(f"{sentence} {'' if has_ended(display) else display.after.partition('.')[0]}")
        limited = bool(context_of(sentence).kind)
        known = said.get(where, _Said(frozenset(), display.place, is_limited=False))
        said[where] = _Said(known.words | words, known.place, is_limited=known.is_limited or limited)
    return [
        replace(each, links=tuple(_with_lines(each, link, said, displays) for link in each.links)) for each in readings
    ]


def _with_lines(reading: Reading, link: Link, said: dict[str, _Said], displays: dict[int, Display]) -> Link:
    if link.verdict != "follows":
        return link
    here = reading.statement.display.place
    near = beside(reading.statement, "")
    near = replace(near, sentence=_NAME.sub("", near.sentence))
    found: list[str] = []
    for line in dict.fromkeys(line for each in link.rests_on for line in _LINE.findall(each)):
        if line == str(reading.where) or (known := said.get(line)) is None:
            continue
        word = near.strange(known.words)
        if known.is_limited and not word:
            since = " ".join(each.before for place, each in displays.items() if known.place < place <= here)
            word = strange_word(since, known.words)
        found += [f"{line} {TRUE_HERE}, where the word {word!r} is new"] if word else []
    return replace(link, hypotheses=(*link.hypotheses, *found))
