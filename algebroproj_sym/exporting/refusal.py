"""Why a claim cannot be exported."""

from __future__ import annotations


class NotExportable(Exception):
    """A claim has no theorem, for a reason."""
