"""Asking: what the prover is asked of two sides.

`questions` makes a question of a relation, with all definitions put in; `refusing` says what is not asked.  `answering`
puts the answers together.  `sampling` is a sieve of points before the prover.  `doubts` says why a relation that fails
need not be a contradiction.
"""
