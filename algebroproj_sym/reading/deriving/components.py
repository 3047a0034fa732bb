r"""Columns of which a document names the components: x in ``x^T Q x``, beside ``x_1`` to ``x_3``, if Q is printed."""

from collections.abc import Collection, Iterable, Iterator
from itertools import count, pairwise

from lark import Token, Tree

from algebroproj_sym.reading.defining.premises import letter_of
from algebroproj_sym.reading.defining.vocabulary import Definition
from algebroproj_sym.reading.lexing.names import split_symbol, written
from algebroproj_sym.reading.parsing.factors import terms_of
from algebroproj_sym.reading.parsing.grammar import Formula, trees_in, without_brackets


def columns_beside_matrices(sides: Iterable[Formula], occurring: Collection[str]) -> Iterator[Definition]:
    r"""Yield the letters that are multiplied by printed matrices of one size, and have as many components.

    Examples
    --------
    >>> from algebroproj_sym.reading.parsing.grammar import parsed
    >>> form = parsed(r"x_1^2 + x_2^2 = x^T \begin{pmatrix} 1 & 0 \\ 0 & 1 \end{pmatrix} x")
    >>> [each.where for each in columns_beside_matrices(form.sides, ["x", "x_1", "x_2"])]
    ['x_1 to x_2 as the components of x']
    >>> [*columns_beside_matrices(form.sides, ["x", "x_1"])]
    []
    """
    found: dict[str, set[int]] = {}
    for side in sides:
        for letter, size in _multiplied(side):
            found.setdefault(letter, set()).add(size)
    for letter, sizes in found.items():
        components = _components(letter, occurring)
        if len(components) > 1 and sizes == {len(components)}:
            rows = [Tree("row", [Tree("cell", [letter_of(each)])]) for each in components]
            column: Formula = Tree("matrix", [Token("BEGIN", r"\begin{bmatrix}"), *rows])
            where = f"{components[0]} to {components[-1]} as the components of {letter}"
            yield Definition(letter, (), column, where, -1, True, role="case")


def columns_as_letters(trees: Iterable[Formula]) -> dict[Formula, Formula]:
    """Return a letter for each printed column of formulas, the same for the same one."""
    every = (matrix for tree in trees for matrix in tree.find_data("matrix"))
    columns = dict.fromkeys(matrix for matrix in every if _is_column(matrix))
    return {column: letter_of(rf"\column{{{number}}}") for number, column in enumerate(columns, 1)}


def _is_column(matrix: Formula) -> bool:
    rows = trees_in(matrix)
    return matrix.data == "matrix" and len(rows) > 1 and all(len(trees_in(row)) == 1 for row in rows)


def multiplies_columns(side: Formula) -> bool:
    """Whether a term of a formula is a product of two printed columns: it may be one of quaternions."""
    runs = (each for each in terms_of(side) if each.data == "run")
    pairs = (pairwise(map(without_brackets, trees_in(run))) for run in runs)
    return any(_is_column(one) and _is_column(other) for each in pairs for one, other in each)


def _multiplied(tree: Formula) -> Iterator[tuple[str, int]]:
    """Yield the letters behind printed matrices, and the turned ones before them, with their size."""
    for run in tree.find_data("run"):
        for one, other in pairwise(trees_in(run)):
            if one.data == "matrix" and other.data == "symbol":
                yield str(other.children[0]), len(trees_in(trees_in(one)[0]))
            if other.data == "matrix" and one.data == "marked" and one.children[1] == "T":
                (turned,) = trees_in(one)
                if turned.data == "symbol":
                    yield str(turned.children[0]), len(trees_in(other))


def _components(letter: str, occurring: Collection[str]) -> list[str]:
    """Return the components of a letter in the document, from the first one on."""
    name, primes, below, above = split_symbol(letter)
    found = list[str]()
    for number in count(1):
        component = written(name, primes, str(number), "")
        if below or above or component not in occurring:
            return found
        found.append(component)
    return found
