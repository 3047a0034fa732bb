"""Reporting: the ledger of verdicts and evidence, tables for the terminal, the report."""

from algebroproj_sym.reporting.answers import answers_record, answers_summary, answers_table
from algebroproj_sym.reporting.audits import (
    audit_counts,
    audit_lines,
    audit_record,
    audit_table,
    audited_share,
    coverage_lines,
    coverage_record,
)
from algebroproj_sym.reporting.explaining import explanation, failure_text, form_lines
from algebroproj_sym.reporting.ledger import (
    declaration,
    ledger,
    summary,
    write_json,
    write_text,
)
from algebroproj_sym.reporting.notebooks import Notebook, NotebookError, run_notebook
from algebroproj_sym.reporting.report import findings, report
from algebroproj_sym.reporting.tables import (
    claims_table,
    failed_function,
    operations_table,
    summary_text,
    verification_table,
)

__all__ = [
    "Notebook",
    "NotebookError",
    "answers_record",
    "answers_summary",
    "answers_table",
    "audit_counts",
    "audit_lines",
    "audit_record",
    "audit_table",
    "audited_share",
    "claims_table",
    "coverage_lines",
    "coverage_record",
    "declaration",
    "explanation",
    "failed_function",
    "failure_text",
    "findings",
    "form_lines",
    "ledger",
    "operations_table",
    "report",
    "run_notebook",
    "summary",
    "summary_text",
    "verification_table",
    "write_json",
    "write_text",
]
