"""Replaying: every verdict of a ledger is checked again from its evidence, without search and without the prover.

This package shares no code with the rest, and needs Python's standard library alone: it has its own reader of the
ledger's expressions, its own polynomials and rational functions, and its own checks for each kind of claim.
"""

from algebroproj_sym.replaying.entry import declaration_digest
from algebroproj_sym.replaying.ledger import Replayed, Status, replay, replay_claim, replay_identity
from algebroproj_sym.replaying.rejection import NotReplayable, Rejected

__all__ = [
    "NotReplayable",
    "Rejected",
    "Replayed",
    "Status",
    "declaration_digest",
    "replay",
    "replay_claim",
    "replay_identity",
]
