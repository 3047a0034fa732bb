"""Auditing: what claims say is printed, held against the words and the LaTeX of the papers.

A quote is looked up in the paper's file (`scans`) and read with the paper's tables of symbols.  What it reads must be
what the claim says is printed, symbol by symbol (`audit`).
Which claims quote which line of a paper, `coverage` tells.
"""

from algebroproj_sym.auditing.audit import STATUSES, Finding, Status, audited
from algebroproj_sym.auditing.collection import audit, stale
from algebroproj_sym.auditing.coverage import Line, coverage, ranges
from algebroproj_sym.auditing.scans import lines_of, misplaced

__all__ = [
    "STATUSES",
    "Finding",
    "Line",
    "Status",
    "audit",
    "audited",
    "coverage",
    "lines_of",
    "misplaced",
    "ranges",
    "stale",
]
