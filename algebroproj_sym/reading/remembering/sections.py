"""What letters are in each section: E and I are numbers where they stand below a line, and matrices elsewhere."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

from algebroproj_sym.reading.defining.kinds import Kinds, kinds_of
from algebroproj_sym.reading.defining.labels import shows_euler
from algebroproj_sym.reading.defining.positions import BOLD, angles_in, divisors_in, multiplied_in
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.lexing.pieces import UnreadableError
from algebroproj_sym.reading.parsing.grammar import Parsed, symbols_in
from algebroproj_sym.reading.prose.phrases import columns_in, matrices_in, named_otherwise, properties_in, vectors_in

Formulas = Mapping[int, Parsed | UnreadableError]


def kinds_in(statements: Sequence[Statement], formulas: Formulas, known: frozenset[str] = frozenset()) -> Kinds:
    """Return which letters are vectors or matrices by some statements, where some are known to be."""
    read = [*_read(statements, formulas)]
    displays = {id(each.display): each.display for each in statements}.values()
    words = " ".join(f"{each.before} {each.after}" for each in displays)
    said = vectors_in(statements) | {*properties_in(statements)}
    found = kinds_of(read, said | known, words, columns_in(statements))
    matrices = matrices_in(statements, angles_in(read))
    return replace(found, no_numbers=found.no_numbers | matrices, named=named_otherwise(statements))


def kinds_by_section(
    statements: Sequence[Statement], formulas: Formulas, whole: Kinds, given: Collection[str], *, euler: bool
) -> dict[int, tuple[Kinds, frozenset[str]]]:
    r"""Return what letters are in the sections where some are numbers that are none elsewhere, with these.

    They stand below a line there, and nothing in the section, nor the user, says that they are no numbers.  Two of them
    below one line, or one at a dot or a cross, may be vectors that are multiplied.  So is e with ``e^{-t/T}``, if it is
    not Euler's number in the whole document.
    """
    found: dict[int, tuple[Kinds, frozenset[str]]] = {}
    unsure = {each for each in whole.no_numbers | whole.open if each not in given and not BOLD.search(each)}
    for part, own in _sections(statements).items():
        sides = [side for each in _read(own, formulas) for side in each.sides]
        divisors = [[each for each in below if each in unsure] for side in sides for below in divisors_in(side)]
        numbers = frozenset(below[0] for below in divisors if len(below) == 1)
        numbers -= {letter for side in sides for letter in multiplied_in(side)}
        alone = kinds_in(own, formulas) if numbers else whole
        kinds, numbers = whole, numbers - alone.no_numbers - alone.open
        if numbers:
            others = kinds_in([each for each in statements if each.display.part != part], formulas)
            here = kinds_in(own, formulas, others.no_numbers - numbers)
            absent = whole.no_numbers - {symbol for side in sides for symbol in symbols_in(side)}
            kinds = _with_numbers(whole, here, others.open, absent, numbers)
        if not euler and shows_euler(sides):
            numbers |= {"e"}
        if numbers:
            found[part] = kinds, numbers
    return found


def _sections(statements: Sequence[Statement]) -> dict[int, list[Statement]]:
    """Return the statements of each section; nothing if there is only one."""
    found: dict[int, list[Statement]] = {}
    for each in statements:
        found.setdefault(each.display.part, []).append(each)
    return found if len(found) > 1 else {}


def _with_numbers(
    whole: Kinds, here: Kinds, opened: frozenset[str], absent: frozenset[str], numbers: frozenset[str]
) -> Kinds:
    """Return what letters are in a section in which some are numbers, and some do not occur."""
    no_numbers = here.no_numbers | absent
    return replace(
        whole,
        no_numbers=no_numbers,
        columns=(here.columns | whole.columns) & no_numbers,
        open=(here.open | opened) - no_numbers - numbers,
        named=whole.named | numbers,
        inverted=whole.inverted & no_numbers,
    )


def _read(statements: Sequence[Statement], formulas: Formulas) -> Iterator[Parsed]:
    found = (formulas[id(each)] for each in statements)
    return (each for each in found if isinstance(each, Parsed))
