"""Whether what an equation rests on is said of the same thing: where a word is new, that is a hypothesis."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from algebroproj_sym.reading.documents.displays import HEADING, Display
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.judging.verdicts import TRUE_HERE, Link, Reading
from algebroproj_sym.reading.prose.asserting import asserts, doubts, may_take_back
from algebroproj_sym.reading.prose.contexts import context_of
from algebroproj_sym.reading.prose.describing import is_titled, names_a_thing
from algebroproj_sym.reading.prose.devices import heard
from algebroproj_sym.reading.prose.sentences import (
    are_of_two_things,
    last_sentence,
    sentences_of,
    strange_word,
    without_formulas,
    words_of,
)
from algebroproj_sym.reading.prose.words import beside, has_ended, is_denied

_NAME = re.compile(r"\b(?:the|an?) (?:[\w-]+ ){1,2}(?:equation|formula|identity|relation|law)\b", re.IGNORECASE)
"""What an equation is called, as in "This gives the lens equation"."""
_LINE = re.compile(r"\bline \d+(?: of [^,;]+)?")


_ITEM = re.compile(
    r"(?P<ends>\\end\{(?:itemize|enumerate|description)\}|\f|\n\n(?=[^\W\d_]))|\\item\b"
    r"|(?:^|\n)[ ]{0,3}(?:[*+-]|\d+[.)])[ ]|(?:^|[.\n])\s*\((?:[a-h]|i{1,3}|iv)\)\s+(?=[A-Z])"
)
"""Where an item of a list begins, or a list ends."""
_NOTE = re.compile(r"\\(?:footnote(?:text)?|marginpar|note|caption)(?:\[[^\]]*\])?\{(?:[^{}]|\{[^{}]*\})*\Z")
"""What opens a note or a caption, and does not close it."""
_APART = re.compile(r"\.|\\(?:begin|end|textbf|emph|textit|textsc|underline)\{|\([a-h]\)\s+(?=[A-Z])")
"""Where the sentence of a display ends behind it."""
_ANOTHER = re.compile(r"\b(?:[Aa]nother|[Oo]ther)\b(?! (?:hand|words|side|way)\b)")

_TITLE = re.compile(HEADING + r".*")
_HARMLESS = heard(
    r"\s*(?:(?:here|now|then|next|first),? )?(?:we|let us) (?:now |then |first )?"
    r"(?:<step>|us|appl|solv|add|subtract|squar)\w*\b"
    r"|\s*(?:here|and|with|where)?,? ?\$[^$=]*\$ (?:is|denotes) (?:the|its|an?) (?:\w+ ){0,3}\w+$"
)
"""A sentence between two equations by which nothing changes."""
_HAVE = re.compile(r"\b(?:we|one) ha(?:ve|s)\b", re.IGNORECASE)
"""What says by itself that an equation holds, and not that it follows."""


@dataclass(frozen=True)
class _Said:
    """The words of the sentences of a display."""

    words: frozenset[str]
    """All of them."""
    is_limited: bool
    """Whether its sentence begins with where it holds, or for what."""
    is_doubted: bool
    """Whether its sentence denies it, or asks."""
    is_asserted: bool
    """Whether its sentence asserts it."""
    is_plain: bool
    """Whether it does so plainly."""


class _Words:
    """The words beside the displays of a document, and beside the equations within its text."""

    def __init__(self, statements: Sequence[Statement]) -> None:
        shown = {each.display.place: each.display for each in statements}
        self.displays = {place: each for place, each in shown.items() if each.environment != "inline"}
        """By their places."""
        self.within = {place: each for place, each in shown.items() if each.environment == "inline"}
        """The formulas within the text, by their places."""
        self.said: dict[str, dict[int, _Said]] = {}
        """What is said beside the equations of each line, by their places."""
        self.titles: dict[int, str] = {}
        """Of the sections in which they stand."""
        self.items: dict[int, int] = {}
        """The numbers of the items of lists in which they stand; 0 for none."""
        self.others = set[int]()
        """The places of the displays whose sentences speak of another thing."""
        self.first: dict[str, int] = {}
        """Where the display begins before which a word stands first."""
        conditions, title, item = {each.display.place: each.condition for each in statements}, "", 0
        for place, display in shown.items():
            within = place in self.within
            if within and "=" not in display.latex:
                continue
            sentence = last_sentence(display.before)
            behind = _rest_of_sentence(display.after) if within else _behind(display)
            words = words_of(f"{sentence} {conditions[place]} {behind}")
            by_sign = ":=" in display.latex and not doubts(f"{sentence} {behind}")
            asserted, plain = (by_sign or asserts(display.before, behind, plainly=each) for each in (False, True))
            found = self.said.setdefault(str(display.where), {})
            limited = bool(context_of(sentence).kind or _NOTE.search(display.before)) or is_titled(sentence)
            asked = "?" in f"{behind}{display.after.lstrip()[:1]}{display.before.rstrip()[-1:]}"
            doubted = not asserted and (asked or is_denied(f"{sentence} {behind}"))
            found[place] = _Said(words, limited, doubted, asserted, plain)
            item = _item_at(display.before, item)
            self.items[place] = item
            if _ANOTHER.search(sentence):
                self.others.add(place)
            title = (_TITLE.findall(display.before) or [title])[-1]
            self.titles[place] = title
            for word in () if within else words_of(display.before):
                self.first.setdefault(word, place)

    def leaves(self, start: int, end: int) -> bool:
        """Whether another item of a list, or another thing, begins between two displays."""
        since = (place for place in self.displays if start < place <= end)
        return any(place in self.others or self.items[start] not in (0, self.items[place]) for place in since)

    def strange_since(self, start: int, end: int, known: frozenset[str]) -> str:
        """Return a word before the displays behind one, up to another, that is not known."""
        return strange_word(
            " ".join(each.before for place, each in self.displays.items() if start < place <= end), known
        )

    def new_between(self, start: int, end: int) -> str:
        """Return a word of the whole sentences between two displays that stands in no text before the first one.

        A sentence that only tells of a step, or what a letter is, has none.
        """
        said = " ".join(self._sentences_between(start, end))
        return next((each for each in sorted(words_of(said)) if names_a_thing(each) and self.first[each] > start), "")

    def said_between(self, start: int, end: int) -> str:
        """Return the begin of a whole sentence between two displays that may be about the first one; empty for none.

        A sentence of neutral words is not, nor one that says what letters are.
        """
        found = filter(may_take_back, self._sentences_between(start, end))
        return " ".join(without_formulas(next(found, "")).split()[:6])

    def _sentences_between(self, start: int, end: int) -> list[str]:
        since = [each.before for place, each in self.displays.items() if start < place <= end]
        if start in self.within:
            since[:1] = [self.within[start].after.removeprefix(_rest_of_sentence(self.within[start].after))]
        return [
            each for words in since for each in sentences_of(_TITLE.sub("", words))[:-1] if not _HARMLESS.match(each)
        ]

    def new_in_title(self, start: int, end: int) -> str:
        """Return a word of the title above a display, if the title above another one says the same of another thing."""
        there, here = (self.titles[place] for place in (start, end))
        return strange_word(here, words_of(there)) if are_of_two_things(there, here) else ""


def _item_at(before: str, item: int) -> int:
    """Return the number of the item in which a display stands, from that of the one above it; 0 for none."""
    for mark in _ITEM.finditer(before):
        item = 0 if mark["ends"] else abs(item) + 1
    return item


def _behind(display: Display) -> str:
    """Return how the sentence of a display goes on behind it."""
    return "" if has_ended(display) else _APART.split(display.after)[0]


def _rest_of_sentence(after: str) -> str:
    """Return the words behind a formula within the text, up to the end of its sentence, with a mark of a question."""
    rest = sentences_of(after)[0]
    return rest + after[len(rest) : len(rest) + 1].strip(".")


def with_what_is_true_here(readings: Sequence[Reading], statements: Sequence[Statement]) -> list[Reading]:
    """Return readings in which what follows names the lines that may be true of another thing only.

    They are those of which the sentence has not all words of the sentence of the equation, and those with a sentence
    behind them that has a word which is new there.  If a line begins with where it holds, it must have the words of all
    sentences since then.  A contradiction is one only of lines that words plainly assert.
    """
    words = _Words(statements)
    return [replace(each, links=tuple(_told(each, link, words) for link in each.links)) for each in readings]


def _told(reading: Reading, link: Link, words: _Words) -> Link:
    if link.verdict == "contradicts":
        return _if_asserted(reading, link, words)
    return _with_lines(reading, link, words) if link.verdict == "follows" else link


def _lines_of(link: Link) -> list[str]:
    """Return the lines on which a verdict rests."""
    return [*dict.fromkeys(line for each in link.rests_on for line in _LINE.findall(each))]


def _if_asserted(reading: Reading, link: Link, words: _Words) -> Link:
    """Return a contradiction, or why it is none: a line that it rests on is not plainly asserted, or taken back."""
    here = reading.statement.display.place
    for line in _lines_of(link):
        there = words.said.get(line, {})
        above = [place for place in there if place < here]
        if not all(there[place].is_plain for place in above or there):
            return replace(link, verdict="independent", reason=f"the words beside {line} do not plainly assert it")
        if said := words.said_between(max(above, default=here), here):
            return replace(link, verdict="independent", reason=f"the words {said!r} may take {line} back")
    return link


def _with_lines(reading: Reading, link: Link, words: _Words) -> Link:
    """Return what follows, with the lines that may be true of another thing among its hypotheses."""
    here = reading.statement.display.place
    near = beside(reading.statement, "")
    near = replace(near, sentence=f"{_NAME.sub('', near.sentence)} {reading.statement.condition}")
    concludes = replace(near, sentence=_HAVE.sub("", near.sentence)).follows
    found: list[str] = []
    for line in _lines_of(link):
        above = {place: each for place, each in words.said.get(line, {}).items() if place < here}
        if not above:
            continue
        known = frozenset().union(*(each.words for each in above.values()))
        word = near.strange(known) or words.new_between(min(above), here) or words.new_in_title(max(above), here)
        limited = [place for place, each in above.items() if each.is_limited or words.leaves(place, here)]
        since = (words.strange_since(place, here, above[place].words) for place in limited)
        word = word or next(filter(None, since), "")
        if not word and any(r"\doteq" in (words.displays | words.within)[place].latex for place in above):
            word = "doteq"
        if word:
            found.append(f"{line} {TRUE_HERE}, where the word {word!r} is new")
        elif any(each.is_doubted for each in above.values()) or not (
            concludes or all(each.is_asserted for each in above.values())
        ):
            found.append(f"{line} {TRUE_HERE}, which its words do not assert")
    return replace(link, hypotheses=(*link.hypotheses, *found))
