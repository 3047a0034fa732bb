"""What the words beside an equation do to what was said before: what holds no longer, and where it holds."""

import re
from dataclasses import replace

from algebroproj_sym.reading.defining.dependence import speaks_of
from algebroproj_sym.reading.defining.premises import Premise
from algebroproj_sym.reading.documents.displays import HEADING, Display
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.prose.acting import acted_on, is_acted_on
from algebroproj_sym.reading.prose.conditions import goes_on
from algebroproj_sym.reading.prose.contexts import ANYWHERE, context_behind, last_context
from algebroproj_sym.reading.prose.describing import described, is_same, names_a_thing
from algebroproj_sym.reading.prose.devices import says
from algebroproj_sym.reading.prose.renaming import renamed_in
from algebroproj_sym.reading.prose.sentences import (
    last_sentence,
    main_clause,
    sentences_of,
    strange_word,
    without_formulas,
    words_of,
)
from algebroproj_sym.reading.prose.words import arithmetic_in, beside, denies, has_ended, is_denied, takes_back
from algebroproj_sym.reading.remembering.memory import Known, Memory, symbols_of

_IS = re.compile(r"\b(?:is|are)\W*$")
_IS_THE = re.compile(r"\s*is (?:the|an?|its|our) [a-z]")
_LIST = re.compile(r"\\begin\{(?:itemize|enumerate)\}")
_LIST_ENDS = re.compile(r"\\end\{(?:itemize|enumerate)\}")
_NAMED = re.compile(r"(?<=[a-z] )[A-Z]\b")
"""The letter of a thing in the text, as in "model B"."""
_NOTE = re.compile(r"\\footnote\{([^{}]*)")
_ONLY = re.compile(r"\W*([^.$]*?) only\b")
"""Words behind an equation that limit it, as in "in the first case only"."""


def leave(memory: Memory, display: Display) -> None:
    """Forget what a quotation, an example or a theorem says where it ends, and the cases of another section."""
    if display.part != memory.part:
        for symbol in memory.valued & {*memory.vocabulary.definitions}:
            del memory.vocabulary.definitions[symbol]
        memory.vocabulary.regard(*memory.survey.kinds_in(display.part))
        memory.valued.clear()
    memory.scopes, ended, supposed = memory.scopes.at(display)
    if ended:
        memory.forget_all(lambda each: each.place >= min(ended))
    if supposed:
        memory.forget_all(lambda each: each.place >= min(supposed) and each.place in memory.supposed)


def listen(memory: Memory, statement: Statement) -> None:
    """Take in the words beside a statement."""
    display, above = statement.display, memory.display
    same_part = memory.beside.part == display.part
    if display is not above:
        leave(memory, display)
        _take_back(memory, display)
        memory.carried = "" if memory.ended or not same_part else memory.beside.sentence
        memory.display = display
        _hear_of_all(memory, display)
    memory.beside = beside(statement, memory.carried)
    if memory.denied:
        memory.beside = replace(memory.beside, condition=f"{memory.beside.condition} false")
    memory.sentences[display.place] = last_sentence(display.before)
    own = display.before.rpartition(HEADING)[2]
    memory.arithmetic = arithmetic_in(f"{own} {memory.beside.behind}") or (memory.arithmetic if same_part else "")
    memory.optimizes = says(r"\b<optimizes>", own) or (same_part and memory.optimizes)
    if display is not above:
        _end_cases(memory, display)
        _keep_stated(memory, display)
        if above is not None:
            _run_on(memory, above, display)
    if memory.beside.supposes:
        memory.supposed.add(display.place)
    stand_at(memory, display)
    marked = {each for each in memory.survey.occurring for mark in memory.beside.dropped if mark in each}
    for symbol in renamed_in(memory.beside.before) | marked:
        memory.forget(symbol)
    _hear_of_letters(memory, display)
    spoken = {*filter(names_a_thing, words_of(memory.beside.sentence))}
    for symbol in [each.symbol for each in memory.vocabulary.definitions.values() if each.apart & spoken]:
        memory.forget(symbol)
    if words_of(display.before):
        memory.introduced = memory.beside.introduces
    memory.ended = has_ended(display)


def _take_back(memory: Memory, display: Display) -> None:
    """Forget the display above if words take it back, and the letters on which they say that something acts."""
    before = display.before
    taken = takes_back(before) or is_acted_on(before) or says(r"\b<same-letter>\b", before)
    if memory.display is not None and taken:
        last = memory.display.place
        memory.forget_all(lambda each: each.place == last)
    for symbol in acted_on(before):
        memory.forget(symbol)


def _run_on(memory: Memory, above: Display, display: Display) -> None:
    """Take notice of the displays of which a sentence goes on: the conditions among them hold still."""
    same = bool(memory.carried) and last_sentence(display.before) == display.before.rstrip()
    same = same and r"\item" not in display.before
    own = {above.place} if same or goes_on(memory.beside) else set()
    memory.running = own | (memory.running if same or memory.beside.follows else set())


def _hear_of_all(memory: Memory, display: Display) -> None:
    """Take notice of a title, or of words before a list, that deny what stands behind them."""
    *above, own = display.before.split(HEADING)
    lead, *items = _LIST.split(own)
    if items and (denies(lead) or is_denied(last_sentence(lead.rstrip(" \n.:")))):
        memory.denied = True
    elif above or _LIST_ENDS.search(own):
        memory.denied = bool(above) and denies(own.partition("\n")[0])
    if says(r"\b<letters-change>\b", " ".join(own.split())):
        memory.forget_all(lambda each: each.place >= 0)


def _keep_stated(memory: Memory, display: Display) -> None:
    """Forget what was stated within the text before words of another thing."""

    def stays(latex: str, premise: Premise) -> bool:
        between = display.before.rpartition(latex)[2]
        is_other = strange_word(between, premise.words) or _NAMED.search(without_formulas(between))
        return not (is_other or memory.beside.strange(premise.words))

    memory.stated = [each for each in memory.stated if stays(*each)]


def _end_cases(memory: Memory, display: Display) -> None:
    """Take notice of the cases that are over: whole sentences, or clauses before the main one, speak of others."""
    *whole, last = sentences_of(display.before)
    lead = "" if memory.carried and display.before.lstrip()[:1].islower() else last.removesuffix(main_clause(last))
    spoken = ". ".join(each for each in (*whole, lead) if "$" not in each)
    memory.over |= {place for place, words in memory.cases.items() if strange_word(spoken, words)}
    if memory.held_at in memory.over:
        memory.held = ANYWHERE


def _hear_of_letters(memory: Memory, display: Display) -> None:
    """Forget what other sections said of a letter, and with it, where words say that it is something else."""
    sections = display.before.rstrip().split(HEADING)
    sections[-1] += (f" ${display.latex}$" if _is_called(memory, display) else ". ") + memory.beside.behind
    for part, words in enumerate(sections, display.part + 1 - len(sections)):
        for symbol, nouns in described(words):
            _forget_from_elsewhere(memory, symbol, nouns, part)
            memory.named[symbol, part] = memory.named.get((symbol, part), frozenset()) | nouns


def _is_called(memory: Memory, display: Display) -> bool:
    """Whether words right beside a display say what its letter is: "is", or "is the mass" behind it."""
    return _IS.search(display.before) is not None or _IS_THE.match(memory.beside.behind) is not None


def _named_at(memory: Memory, symbol: str, part: int) -> frozenset[str]:
    """Return what words called a letter in a section, or else in the last one above it that called it anything."""
    above = [each for name, each in memory.named if name == symbol and each <= part]
    return memory.named[symbol, max(above)] if above else frozenset()


def _forget_from_elsewhere(memory: Memory, symbol: str, nouns: frozenset[str], part: int) -> None:
    """Forget what other sections said of a letter, and with it, but for what may be called by the same nouns.

    So does a section itself where words called it something else before.
    """
    told = bool(nouns and memory.named.get((symbol, part)))

    def stays(each: Known) -> bool:
        same = is_same(nouns, each.words | _named_at(memory, symbol, each.part))
        return same or (each.part == part and not told)

    memory.forget_all(lambda each: speaks_of(symbols_of(each), symbol) and not stays(each))


def stand_at(memory: Memory, display: Display) -> None:
    """Take in where an equation holds: what one before it says goes on, up to the next heading."""
    inline = display.environment == "inline"
    limited = None if inline else _ONLY.match(display.after)
    sentences = [limited[1]] if limited else sentences_of(display.before.rpartition(HEADING)[2])
    own = last_context(sentences, display.after if inline else "")
    passing = inline and bool(own.kind) and not own.is_of_things
    if (own.kind and not passing) or memory.part != display.part:
        memory.held, memory.held_at = ANYWHERE if passing else own, display.place
    note = _NOTE.search(sentences[-1]) or _NOTE.match(display.after.lstrip())
    ended = inline or has_ended(display)
    behind = context_behind(note[1]) if note else ANYWHERE if ended else context_behind(display.after)
    memory.context = own if passing else behind if behind.kind else memory.held
    memory.part = display.part
