"""Reporting: the ledger of verdicts and evidence."""
