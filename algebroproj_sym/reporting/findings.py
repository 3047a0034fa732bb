"""Findings: what does not hold as printed or cannot be read, the grave ones first, each once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from algebroproj_sym.declaring import GRADES, KINDS, Claim, Grade, Judgement, grade_of
from algebroproj_sym.reporting.explaining import finding_line, sides_at_counterexample
from algebroproj_sym.reporting.templating import TEMPLATES
from algebroproj_sym.showing import folded

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

    Attributes
    ----------
    first : Judgement
        That of the claim that tells it.
    others : tuple of Judgement
        Those of the claims that are declared to have the same finding.
    """

    first: Judgement
    others: tuple[Judgement, ...] = ()

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
    def follows(self) -> str:
        """What follows: as declared, or the values at the counterexample if they are short."""
        return self.claim.follows or values_at_counterexample(self.first)


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
    return [Finding(j, tuple(same.get(key, ()))) for key, j in found.items() if id(j) not in also]


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
    )


def values_at_counterexample(judgement: Judgement) -> str:
    """Return in a sentence what is printed and what is right at the counterexample; nothing if that is long."""
    point = judgement.counterexample or {}
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
