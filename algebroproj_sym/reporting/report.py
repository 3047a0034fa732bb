"""The report: verdicts, findings and generated functions, as Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import TYPE_CHECKING

from jinja2 import Environment, PackageLoader, StrictUndefined

from algebroproj_sym.declaring import VERDICTS, Judgement
from algebroproj_sym.reporting.explaining import failure_text, finding_line
from algebroproj_sym.reporting.ledger import summary
from algebroproj_sym.reporting.tables import failed_function

if TYPE_CHECKING:
    from algebroproj_sym.generating import Lowered
    from algebroproj_sym.verifying import Verification

_TEMPLATES = Environment(
    loader=PackageLoader("algebroproj_sym.reporting"),
    undefined=StrictUndefined,
    keep_trailing_newline=True,
    trim_blocks=True,
    lstrip_blocks=True,
)


def report(judgements: Sequence[Judgement], lowered: Sequence[Lowered], verified: Sequence[Verification]) -> str:
    """Return the report: a page to be read, with links to the files that have the rest.

    Parameters
    ----------
    judgements : sequence of Judgement
        All claims.
    lowered : sequence of Lowered
        All kernels.
    verified : sequence of Verification
        The figures of the generated functions, in the order of the kernels.

    Returns
    -------
    str
        Markdown: what is not as declared, verdicts by paper, a line for each claim that does not hold as
        printed, the functions with their figures.
    """
    from algebroproj_sym.verifying import BOUND

    return _TEMPLATES.get_template("report.md.j2").render(
        wrong=[failure_text(judgement) for judgement in judgements if not judgement.as_declared],
        failed=[failed_function(verification) for verification in verified if not verification.passed],
        verdicts=VERDICTS,
        papers=[
            (paper, summary(group), [(j, finding_line(j)) for j in group if _is_finding(j)])
            for paper, group in _by_paper(judgements)
        ],
        functions=[_function(low, v) for low, v in zip(lowered, verified, strict=True)],
        bound=BOUND,
    )


def findings(judgements: Sequence[Judgement]) -> str:
    """Return a line for each claim that does not hold as printed or cannot be read, as Markdown, paper by paper."""
    papers = [(paper, [j for j in group if _is_finding(j)]) for paper, group in _by_paper(judgements)]
    return _TEMPLATES.get_template("findings.md.j2").render(
        papers=papers, total=sum(len(found) for _, found in papers), claims=len(judgements)
    )


def _is_finding(judgement: Judgement) -> bool:
    return judgement.verdict not in ("proved", "definition")


def _by_paper(judgements: Iterable[Judgement]) -> list[tuple[str, list[Judgement]]]:
    return [(paper, list(group)) for paper, group in groupby(judgements, key=lambda j: j.claim.paper)]


def _function(low: Lowered, verification: Verification) -> dict[str, object]:
    from algebroproj_sym.generating import operation_counts

    overall = verification.accuracy.overall
    return {
        "name": low.kernel.qualified_name,
        "claims": ", ".join(low.kernel.claims),
        "operations": operation_counts(low),
        "source": "proved" if verification.proved else "differs",
        "median": f"{overall.median_ulp:.2f}",
        "largest": f"{overall.max_ulp:.3g}",
        "ratio": f"{overall.max_ratio:.2f}",
    }
