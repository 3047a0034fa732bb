"""The report: verdicts, findings and generated functions, as Markdown."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import TYPE_CHECKING

from algebroproj_sym.declaring import VERDICTS, Judgement
from algebroproj_sym.reporting.explaining import failure_text, finding_line
from algebroproj_sym.reporting.findings import is_finding
from algebroproj_sym.reporting.ledger import summary_by_paper
from algebroproj_sym.reporting.tables import failed_function
from algebroproj_sym.reporting.templating import TEMPLATES

if TYPE_CHECKING:
    from algebroproj_sym.generating.lowering import Lowered
    from algebroproj_sym.verifying.verification import Verification


def report(judgements: Sequence[Judgement], lowered: Sequence[Lowered], verified: Sequence[Verification]) -> str:
    """Return the report: a page to be read, with links to the files that have the rest.

    It has what is not as declared, verdicts by paper, a line for each claim that does not hold as printed, and the
    functions with their figures.
    """
    from algebroproj_sym.verifying.accuracy import BOUND

    return TEMPLATES.get_template("report.md.j2").render(
        wrong=[failure_text(judgement) for judgement in judgements if not judgement.as_declared],
        failed=[failed_function(verification) for verification in verified if not verification.passed],
        verdicts=VERDICTS,
        counts=summary_by_paper(judgements),
        papers=[
            (paper, [(j, finding_line(j)) for j in found if is_finding(j)])
            for paper, found in groupby(judgements, key=lambda j: j.claim.paper)
        ],
        functions=[_function(low, v) for low, v in zip(lowered, verified, strict=True)],
        bound=BOUND,
    )


def _function(low: Lowered, verification: Verification) -> dict[str, object]:
    from algebroproj_sym.generating.operation_counts import derived_operations

    overall = verification.accuracy.overall
    return {
        "name": low.kernel.qualified_name,
        "claims": ", ".join(low.kernel.claims),
        "operations": f"{derived_operations(low.kernel)}, {low.plain.operations().total()}",
        "source": "proved" if verification.proved else "differs",
        "median": f"{overall.median_ulp:.2f}",
        "largest": f"{overall.max_ulp:.3g}",
        "ratio": f"{overall.max_ratio:.2f}",
    }
