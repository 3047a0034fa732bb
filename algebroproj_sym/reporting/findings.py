"""Findings: what does not hold as printed or cannot be read, the grave ones first, each once."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import sympy

from algebroproj_sym.declaring import (
    GRADES,
    KINDS,
    NUMBER_OF,
    VERDICTS,
    Claim,
    Grade,
    Judgement,
    grade_of,
    statement_text,
)
from algebroproj_sym.reporting.explaining import finding_line, sides_at_counterexample
from algebroproj_sym.reporting.ledger import summary_by_paper
from algebroproj_sym.reporting.templating import TEMPLATES
from algebroproj_sym.showing.display import folded

HEADINGS: dict[Grade, str] = {
    "results": "Findings that change results",
    "formula": "Findings that change a formula or a statement",
    "slip": "Slips",
}
MOST_COORDINATES = 4
LONGEST_VALUE = 40


@dataclass(frozen=True)
class Finding:
    """A finding, and the claims that have it.

    The first one tells it; the others are declared to have the same. The claims of the paper are known by their
    numbers.
    """

    first: Judgement
    others: tuple[Judgement, ...] = ()
    numbers: Mapping[str, Claim] = field(default_factory=dict)

    @property
    def claim(self) -> Claim:
        """The claim that tells it."""
        return self.first.claim

    @property
    def grade(self) -> Grade:
        """How much it matters: the gravest that one of its claims has."""
        return min((grade_of(judgement.claim) for judgement in (self.first, *self.others)), key=GRADES.index)

    @property
    def line(self) -> str:
        """What is printed, and what is right."""
        return finding_line(self.first)

    @property
    def instead(self) -> Claim | None:
        """The claim that says what is true, for a false statement."""
        return self.numbers.get(self.claim.instead)

    @property
    def follows(self) -> str:
        """What follows: as declared, or the values at the counterexample if they are short."""
        return declared_consequence(self.claim, self.numbers) or values_at_counterexample(self.first)


def is_finding(judgement: Judgement) -> bool:
    """Whether a claim does not hold as printed, or cannot be read."""
    return judgement.verdict not in ("proved", "definition")


def gathered(judgements: Sequence[Judgement]) -> list[Finding]:
    """Return the findings in the order of their claims; those that are the same are one."""
    found = {(j.claim.paper, j.claim.number): j for j in judgements if is_finding(j)}
    same: dict[tuple[str, str], list[Judgement]] = {}
    for (paper, _), judgement in found.items():
        if judgement.claim.same_as and (paper, judgement.claim.same_as) in found:
            same.setdefault((paper, judgement.claim.same_as), []).append(judgement)
    also = {id(judgement) for others in same.values() for judgement in others}
    numbers: dict[str, dict[str, Claim]] = {}
    for judgement in judgements:
        numbers.setdefault(judgement.claim.paper, {})[judgement.claim.number] = judgement.claim
    return [
        Finding(judgement, tuple(same.get(key, ())), numbers[key[0]])
        for key, judgement in found.items()
        if id(judgement) not in also
    ]


def declared_consequence(claim: Claim, numbers: Mapping[str, Claim]) -> str:
    """Return what a claim says to follow, with the proved numbers of other claims of the paper in their places.

    ``{4/c#left.u01}`` stands for the number of this claim, the corrected one if there is one.  If the claim was not
    judged, it is named instead.
    """

    def number(of: str) -> str:
        other = numbers.get(of)
        right = None if other is None else other.printed if other.corrected is None else other.corrected
        return statement_text(right) or f"({of})"

    return NUMBER_OF.sub(lambda found: number(found[1]), claim.follows)


def by_grade(found: Sequence[Finding]) -> Iterator[tuple[Grade, list[Finding]]]:
    """Yield the grades, the gravest first, with the findings that have a printed form."""
    for grade in GRADES:
        yield grade, [finding for finding in found if finding.grade == grade and finding.first.verdict != "illegible"]


def findings(judgements: Sequence[Judgement]) -> str:
    """Return the findings as Markdown: what is printed, what is true, what follows."""
    found = gathered(judgements)
    return TEMPLATES.get_template("findings.md.j2").render(
        grades=[(HEADINGS[grade], entries) for grade, entries in by_grade(found)],
        illegible=[finding for finding in found if finding.first.verdict == "illegible"],
        count=len(found),
        total=sum(is_finding(judgement) for judgement in judgements),
        claims=len(judgements),
        verdicts=VERDICTS,
        counts=summary_by_paper(judgements),
    )


def values_at_counterexample(judgement: Judgement) -> str:
    """Return in a sentence what is printed and what is right at the counterexample; nothing if that is long.

    Matrices are too long, as points of statements in letters have them.
    """
    point = judgement.counterexample or {}
    if any(isinstance(value, sympy.MatrixBase) for value in point.values()):
        return ""
    different = [(place, pair) for place, pair in enumerate(sides_at_counterexample(judgement)) if pair[0] != pair[1]]
    if not different or not 0 < len(point) <= MOST_COORDINATES or not KINDS[judgement.claim.kind].is_marked:
        return ""
    place, (printed, right) = different[0]
    if max(len(str(printed)), len(str(right))) > LONGEST_VALUE:
        return ""
    columns = getattr(judgement.claim.derived, "cols", 0)
    what = f"the element {place // columns + 1}, {place % columns + 1}" if columns else "it"
    where = ", ".join(f"{symbol} = {value}" for symbol, value in point.items())
    return f"At {folded(where, 2 * LONGEST_VALUE)} {what} is {right}. The printed form gives {printed}."
