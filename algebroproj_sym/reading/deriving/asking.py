"""A derivative that is asked for, and the answer that a rule gives."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from lark import Tree

from algebroproj_sym.reading.defining.definition import Definition, Role
from algebroproj_sym.reading.defining.notation import DOT, PARTIAL, TOTAL, Derivative, by_bare, change, names_in
from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.parsing.grammar import Formula

UNCHANGED = " not change"
"""How the name of a derivative ends that rests on letters that are taken to be fixed."""


@dataclass(frozen=True)
class Asked:
    """A derivative that stands in a document, with what is known there."""

    symbol: str
    """As tables write it."""
    derivative: Derivative
    """What it says."""
    vocabulary: Vocabulary
    """What letters stand for."""
    occurring: frozenset[str]
    """The symbols of the document."""
    at_vectors: Sequence[Definition] = ()
    """What some functions are at a vector."""

    @cached_property
    def names(self) -> Mapping[str, str]:
        """The symbols of the document by their bare names."""
        return names_in(self.occurring)

    @cached_property
    def known(self) -> Mapping[str, str]:
        """The letters with definitions by their bare names."""
        return by_bare(self.vocabulary.definitions)

    @property
    def sign(self) -> str:
        r"""Whether it is a total derivative, ``d``, or a partial one, ``\partial``."""
        return self.derivative.sign if self.derivative.is_quotient else TOTAL

    @property
    def is_partial(self) -> bool:
        """Whether other letters of a formula are fixed, by what the sign says."""
        return self.sign == PARTIAL

    @property
    def is_first(self) -> bool:
        """Whether it is a quotient of first order, or has dots: these are derivatives by t, one after the other."""
        return self.derivative.is_first or self.derivative.sign == DOT

    @property
    def above(self) -> str:
        """The bare name of what is derived last: ``dr/dt`` in ``d^2r/dt^2``."""
        return self.derivative.lower[-1]

    @property
    def below(self) -> str:
        """The bare name of the letter by which that is derived."""
        return self.derivative.letters[-1]

    def given(self, name: str) -> Definition | None:
        """Return the usable definition of a letter with a bare name."""
        found = self.vocabulary.definitions.get(self.known.get(name, ""))
        return found if found is not None and found.usable else None

    def changes(self, letters: Collection[str], variable: str) -> bool:
        """Whether letters may change with another one, by equations or by derivatives in the document."""
        moves = self.vocabulary.moves_with(letters, variable)
        return moves or change(letters, variable, self.occurring, self.sign)

    def made(self, tree: Formula, given: Definition, constant: Iterable[str] = ()) -> Definition:
        """Return what the derivative is, by a definition, where some letters do not change."""
        where = f"the derivative of {given.where}{unchanged([*constant], self.vocabulary)}"
        role: Role = "case" if given.role == "case" else "definition"
        source = given.part, True, True, role, given.place, given.words
        return Definition(self.symbol, (), tree, where, *source)

    def case(self, tree: Formula, given: Definition, constant: Iterable[str] = ()) -> Definition:
        """Return it as one that proves, and refutes nothing."""
        return replace(self.made(tree, given, constant), role="case")


def unchanged(letters: Sequence[str], vocabulary: Vocabulary) -> str:
    """Return the words that some letters do not change; empty for no letters."""
    verb = "does" if len(letters) == 1 else "do"
    return f", where {', '.join(map(vocabulary.name, letters))} {verb}{UNCHANGED}" if letters else ""


def slope_of(value: Formula, *letters: str) -> Formula:
    """Return the derivative of a value by one letter after the other."""
    for each in letters:
        value = Tree("slope", [value, letter_of(each)])
    return value
