"""Exporting: theorems for Coq's kernel, from the statement and the evidence of each claim of the ledger.

The stages are the modules: `reading` reads a form of the ledger as `terms`, a `statement` is all forms of a claim;
`rational_functions` finds what they divide by, and how divisors split; `theorems` and `points` state and prove what
follows from hypotheses and what holds at a point; `claims` does so for each kind of claim; `files` lays theorems out in
files; `compiling` has them checked.  The replay comes first.  `letters` and `reals` take from it how statements are
read, `reals` also in which order facts are found; all else has code of its own.
"""
