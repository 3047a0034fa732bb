"""Why a certificate is rejected."""

from __future__ import annotations


class Rejected(ValueError):  # noqa: N818 - a judgement, not a malfunction
    """A certificate does not show what the ledger says."""


class NotReplayable(ValueError):  # noqa: N818
    """The ledger holds no evidence that could be replayed."""


def require(holds: bool, reason: str) -> None:
    """Reject with a reason, unless something holds."""
    if not holds:
        raise Rejected(reason)
