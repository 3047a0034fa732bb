"""Defining: what letters stand for.

The `symbols` file, the `phrases` of a document and its definitions make a `vocabulary`; equations above a relation and
derivatives are `premises` of it.  `kinds` says which letters are vectors or matrices, by their `positions` and the
`closure` of what these say.  `tensors` says which are tensors.  `notation` takes derivatives apart.  Formulas are built
from `parts`, and tensors of the fourth order are `maps`.
"""
