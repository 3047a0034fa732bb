"""Reporting: a document as a derivation folder."""
