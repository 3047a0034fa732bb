"""What a verdict says: of a relation, and of an equation of a document."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, get_args

from algebroproj_sym.proving import Question
from algebroproj_sym.reading.deriving.rates import ZERO
from algebroproj_sym.reading.documents.files import Line
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.parsing.grammar import Parsed

Verdict = Literal["definition", "follows", "contradicts", "independent", "not decided", "not read"]


VERDICTS: tuple[Verdict, ...] = get_args(Verdict)
_ROUGHLY = ("≈", "≅", "≍", "~", "∝")


TRUE_HERE = "is true here"
"""How a hypothesis ends, or goes on, that an equation above speaks of the same thing."""


@dataclass(frozen=True)
class Link:
    """One relation of a chain."""

    verdict: Verdict
    """One of `VERDICTS`."""
    reason: str = ""
    """Why it is not decided, or what else there is to say."""
    rests_on: tuple[str, ...] = ()
    """Definitions, equations above it, derivatives, and words."""
    hypotheses: tuple[str, ...] = ()
    """What is not zero where it holds, and which equations must be true there as well."""
    counterexample: Mapping[str, str] | None = None
    """A point at which the sides differ."""
    suggestion: str = ""
    """The smallest change by which it would follow; empty for none."""
    certificate: Mapping[str, Any] | None = field(default=None, repr=False)
    """The evidence."""
    asked: tuple[Question, ...] = field(default=(), repr=False)
    """What the prover was asked, with all definitions put in."""
    corrected: str = field(default="", repr=False)
    """The right side with the suggested change, if it is one of the right side."""


@dataclass(frozen=True)
class Reading:
    """An equation of a document, what was understood, and its verdict.

    Attributes
    ----------
    number : str
        Its number, else its label, else empty.
    latex : str
        Its LaTeX.
    read : str or None
        What was understood.
    reason : str
        Where and why reading stopped, or why there is no decision.
    links : tuple of Link
        The relations, one after the other.
    statement : Statement
        Where it comes from.
    formula : Parsed or None
        What was parsed.
    """

    number: str
    latex: str
    read: str | None
    reason: str
    links: tuple[Link, ...]
    statement: Statement
    formula: Parsed | None = None

    @property
    def where(self) -> Line:
        """The line on which its display begins."""
        return self.statement.display.where

    @property
    def line(self) -> int:
        """The number of that line."""
        return self.where.number

    @property
    def verdict(self) -> Verdict:
        r"""The verdict: of several links, the one that matters most.

        What is only roughly equal, as in ``a = b \approx 3``, is not judged where something else is equal.
        """
        if self.read is None:
            return "not read"
        relations = self.formula.relations if self.formula else ()
        roughly = [place for place, relation in enumerate(relations) if relation in _ROUGHLY]
        exactly = {link.verdict for place, link in enumerate(self.links) if place not in roughly}
        found = exactly or {link.verdict for link in self.links}
        if self._sets_to_zero and found == {"definition", "independent"}:
            return "definition"
        order: tuple[Verdict, ...] = ("contradicts", "not decided", "independent", "definition", "follows")
        return next((verdict for verdict in order if verdict in found), "not decided")

    @property
    def _sets_to_zero(self) -> bool:
        """Whether a chain says by a sign what a letter is, and in its last link that this is zero."""
        formula = self.formula
        is_zero = formula is not None and formula.relations[:1] == (":=",) and formula.sides[-1] == ZERO
        return is_zero and {link.verdict for link in self.links[:-1]} == {"definition"}

    @property
    def supposes(self) -> bool:
        """Whether it follows only if an equation that may be of another thing is true here, too."""
        return self.verdict == "follows" and any(TRUE_HERE in name for link in self.links for name in link.hypotheses)
