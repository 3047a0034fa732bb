"""Why a certificate is rejected."""

from collections.abc import Mapping, Set
from typing import Any


class Rejected(ValueError):  # noqa: N818 - a judgement, not a malfunction
    """A certificate does not show what the ledger says."""


class NotReplayable(ValueError):  # noqa: N818
    """The ledger holds no evidence that could be replayed."""


def require(holds: bool, reason: str) -> None:
    """Reject with a reason, unless something holds."""
    if not holds:
        raise Rejected(reason)


def require_keys(part: Mapping[str, Any], needed: Set[str], possible: Set[str] = frozenset()) -> None:
    """Reject a part of a record with an entry that is missing or unknown."""
    found = part.keys()
    require(needed <= found <= needed | possible, f"expected the entries {sorted(needed)}, got {sorted(found)}")
