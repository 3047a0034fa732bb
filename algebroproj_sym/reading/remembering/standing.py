"""Where an equation stands: what is known there, and what it may rest on."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.premises import MOST_NEAR, Premise, applicable, extended, neighbours
from algebroproj_sym.reading.defining.recognising import defined_by
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.parsing.grammar import Formula
from algebroproj_sym.reading.prose.words import Beside
from algebroproj_sym.reading.remembering.survey import Survey


@dataclass(frozen=True)
class Standing:
    """Where an equation stands: what is known there, and what it may rest on."""

    survey: Survey
    """What is known of the whole document."""
    vocabulary: Vocabulary
    """What letters stand for there."""
    beside: Beside
    """The words beside it."""
    part: int
    """How many headings come before it."""
    premises: Sequence[Premise]
    """The equations above it that hold there."""
    cited: frozenset[str]
    """The labels and numbers that words before it name."""
    given_at: Mapping[str, int]
    """Where each letter was alone on a side for the last time."""
    own: Sequence[Premise] = ()
    """The equations within the text that its own sentence supposes."""
    summed: Sequence[Premise] = ()
    """The equations above it in which an index is summed over silently."""

    @property
    def follows(self) -> bool:
        """Whether an equation is said to follow from those above it: by words, an arrow or a citation."""
        return self.beside.follows or bool(self.cited)

    @cached_property
    def above(self) -> list[Premise]:
        """The equations above it on which it may rest."""
        return applicable(self.premises, self.part, self.cited)

    @cached_property
    def given(self) -> list[Definition]:
        """What these say of lone letters."""
        return [each.gives for each in self.above if each.gives is not None]

    def given_beside(self, left: Formula, right: Formula) -> list[Definition]:
        """Return what they say of letters that are not a side of a relation."""
        lone = {defined_by(left)[0], defined_by(right)[0]} - {""}
        return [each for each in self.given if each.symbol not in lone]

    @property
    def told(self) -> Vocabulary:
        """What letters stand for with what these say."""
        return extended(self.vocabulary, self.given)

    def near(self, most: int = MOST_NEAR) -> list[Premise]:
        """Return the last equations of its section, from the last one on, and those cited."""
        return neighbours(self.premises, self.part, self.cited, most)

    def supposed(self, left: Formula, right: Formula) -> list[Premise]:
        """Return what the sentence of a relation supposes beside it."""
        return [each for each in self.own if (left, right) not in each.both_ways]
