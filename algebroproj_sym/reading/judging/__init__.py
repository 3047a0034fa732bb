"""Judging: each relation of a document gets a verdict.

An equation *follows* if it is proved from the definitions and equations above it.  It *contradicts* only if it is
asserted of letters that are all given.  An equation that holds for some values and fails for others is *independent*:
it may be a new statement, a condition or another case.

`document` goes through the equations, and `displayed` takes each of them: it defines a letter, or the prover is asked.
`deciding` says what its answers come to.  Where a relation fails, `repairs` are the smallest changes by which it may
hold, and `mending` asks which of them does.  `applying`, `signs` and `withdrawing` look at all verdicts together.
`verdicts` is what a reader gets.
"""
