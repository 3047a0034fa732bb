"""Printed columns, which stand as a whole for letters."""

from collections.abc import Iterable
from itertools import pairwise
from typing import Any

from lark import Token, Tree

from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.parsing.factors import terms_of
from algebroproj_sym.reading.parsing.grammar import Formula, trees_in, without_brackets


def columns_as_letters(trees: Iterable[Formula]) -> dict[Formula, Formula]:
    """Return a letter for each printed column of formulas, the same for the same one."""
    every = (matrix for tree in trees for matrix in tree.find_data("matrix"))
    columns = dict.fromkeys(matrix for matrix in every if is_column(matrix))
    return {column: letter_of(rf"\column{{{number}}}") for number, column in enumerate(columns, 1)}


def column_of(*entries: Formula) -> Formula:
    """Return formulas as the entries of a printed column."""
    rows: list[Any] = [Tree("row", [Tree("cell", [each])]) for each in entries]
    return Tree("matrix", [Token("BEGIN", "("), *rows])


def is_column(matrix: Formula) -> bool:
    """Whether a formula is a printed column."""
    rows = trees_in(matrix)
    return matrix.data == "matrix" and len(rows) > 1 and all(len(trees_in(row)) == 1 for row in rows)


def multiplies_columns(side: Formula) -> bool:
    """Whether a term of a formula is a product of two printed columns: it may be one of quaternions."""
    runs = (each for each in terms_of(side) if each.data == "run")
    pairs = (pairwise(map(without_brackets, trees_in(run))) for run in runs)
    return any(is_column(one) and is_column(other) for each in pairs for one, other in each)
