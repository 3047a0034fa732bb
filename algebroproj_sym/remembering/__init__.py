"""What earlier runs have proved, so that a run proves again only what has changed.

A verdict and its evidence are a function of the claim's declaration as data, the engine and the prover alone.  The key
of an entry is the digest of all of these; whatever is read and does not fit its key is forgotten and proved again.
"""

from algebroproj_sym.remembering.key import key_of, prover
from algebroproj_sym.remembering.memory import Memory, cache_folder

__all__ = ["Memory", "cache_folder", "key_of", "prover"]
