"""Judging: each relation of a document gets a verdict.

An equation *follows* if it is proved from the definitions and equations above it.  It *contradicts* only if it is
asserted of letters that are all given: see `doubts`.  An equation that holds for some values and fails for others is
*independent*: it may be a new statement, a condition or another case.

`document` goes through the equations; `standing` is what is known where one stands.  `ways` lists how a relation may be
meant: with equations above it put in (`substituting`), under these (`constraining`), with what its sentence supposes
(`supposing`), with letters for other formulas (`renaming`), by `components`, or as matrices of `quaternions`; and what
is usually taken for granted of letters (`assuming`), at another index (`indexing`), or by roots and inverse functions
(`inverting`).
`questions` says what the prover is asked, `deciding` what its answers come to.  Where a relation fails, `repairs` are
the smallest changes by which it may hold.  `verdicts` is what a reader gets.
"""
