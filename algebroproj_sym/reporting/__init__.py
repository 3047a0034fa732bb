"""Reporting: the ledger of verdicts and evidence, tables for the terminal, the report."""
