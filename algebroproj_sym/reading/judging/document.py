"""A document read once from its beginning to its end, and each relation judged."""

from collections.abc import Collection
from dataclasses import replace

from algebroproj_sym.reading.asking.answering import asking_once
from algebroproj_sym.reading.defining.recognising import EQUALITIES, operations_in, values_in
from algebroproj_sym.reading.defining.symbols import SymbolsFile
from algebroproj_sym.reading.documents.displays import Document
from algebroproj_sym.reading.judging.applying import with_what_is_true_here
from algebroproj_sym.reading.judging.deciding import Asked, decide
from algebroproj_sym.reading.judging.displayed import take_displayed
from algebroproj_sym.reading.judging.signs import denied_by_words, without_denied
from algebroproj_sym.reading.judging.verdicts import Reading
from algebroproj_sym.reading.judging.withdrawing import without_refuted_premises
from algebroproj_sym.reading.parsing.grammar import Parsed, symbols_in
from algebroproj_sym.reading.remembering.memory import Memory
from algebroproj_sym.reading.remembering.survey import Survey
from algebroproj_sym.reading.remembering.within import take_within


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
    memory = Memory(Survey(document, given or SymbolsFile()))
    readings, asked = _read(memory)
    asked = [each for each in asked if lines is None or readings[each.reading].line in lines]
    with asking_once(seconds, jobs) as ask:
        decide(asked, ask)
    for each in asked:
        links = list(readings[each.reading].links)
        links[each.place] = each.link
        readings[each.reading] = replace(readings[each.reading], links=tuple(links))
    denied = denied_by_words(document)
    readings = [without_denied(each, denied) for each in without_refuted_premises(readings, memory.closed)]
    return with_what_is_true_here(readings, memory.survey.statements)


def _read(memory: Memory) -> tuple[list[Reading], list[Asked]]:
    """Go through a document once; return the displayed equations, and what is to be asked of them."""
    readings, asked = list[Reading](), list[Asked]()
    for order, statement in enumerate(memory.survey.statements, 1):
        memory.order = order
        found = memory.survey.formulas[id(statement)]
        if statement.display.environment != "inline":
            reading, questions = take_displayed(memory, statement, found, len(readings))
            readings.append(reading)
            asked += questions
        elif isinstance(found, Parsed):
            take_within(memory, statement, found)
        if isinstance(found, Parsed) and found.relations:
            shown = (symbols_in, operations_in, values_in)
            said = {part for each in shown for side in found.sides for part in each(side)}
            memory.seen |= said
            memory.equated |= said if {*found.relations} & {*EQUALITIES} else set()
    return readings, asked
