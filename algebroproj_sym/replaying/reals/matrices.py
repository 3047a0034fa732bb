"""Statements of several parts: entries of matrices, or real and imaginary parts, compared where all are defined."""

from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any

from algebroproj_sym.replaying.reals.complex_numbers import real_statements
from algebroproj_sym.replaying.reals.statement import require_real
from algebroproj_sym.replaying.rejection import require, require_keys
from algebroproj_sym.replaying.text import natural

START, END = "Matrix([", "])"


def is_matrix(text: Any) -> bool:
    """Whether a text is that of a matrix."""
    return isinstance(text, str) and text.startswith(START)


def rows_of(text: str) -> list[list[str]]:
    """Return the entries of a matrix as text.

    Examples
    --------
    >>> rows_of("Matrix([[cos(x), atan2(y, x)], [0, 1]])")
    [['cos(x)', 'atan2(y, x)'], ['0', '1']]
    """
    require(text.startswith(START) and text.endswith(END), "expected the rows of a matrix")
    rows = [[*_parts(row[1:-1])] for row in _parts(text[len(START) : -len(END)]) if row[:1] + row[-1:] == "[]"]
    whole = ", ".join(f"[{', '.join(row)}]" for row in rows)
    require(f"{START}{whole}{END}" == text, "expected rows in brackets, and a comma and a space between entries")
    require(bool(rows) and len({len(row) for row in rows}) == 1, "expected rows of one length")
    return rows


def _parts(text: str) -> Iterator[str]:
    """Yield what is between the commas that are in no brackets."""
    depth, cuts = 0, [-2]
    for place, letter in enumerate(text):
        depth += (letter in "([") - (letter in ")]")
        require(depth >= 0, "a bracket is closed that was not opened")
        if letter == "," and depth == 0:
            cuts.append(place)
    require(depth == 0, "a bracket is not closed")
    yield from (text[start + 2 : end] for start, end in pairwise([*cuts, len(text)]))


def entries_of(record: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the statement of each entry, which has the domain of the whole matrices.

    Examples
    --------
    >>> entries_of({"lhs": "Matrix([[x, 1/y]])", "rhs": "Matrix([[x, 1]])"})[0]["lhs"]
    '0*((x) + (1/y) + (x) + (1)) + (x)'
    """
    left, right = rows_of(record["lhs"]), rows_of(record["rhs"])
    require([*map(len, left)] == [*map(len, right)], "the two sides have not the same shape")
    sides = [entry for row in left for entry in row], [entry for row in right for entry in row]
    domain = " + ".join(f"({entry})" for side in sides for entry in side)
    return [{**record, "lhs": f"0*({domain}) + ({a})", "rhs": b} for a, b in zip(*sides, strict=True)]


def require_real_form(record: Mapping[str, Any]) -> None:
    """Check whether the verdict on a statement with real functions follows from its evidence.

    The statement is about real numbers, about matrices, or, with the key ``complex``, about complex numbers.

    It raises `Rejected` if it does not, and `NotReplayable` if there is no evidence.
    """
    if "complex" not in record and not is_matrix(record["lhs"]):
        require_real(record)
        return
    certificate = record["certificate"]
    if "complex" in record:
        own = {key: value for key, value in record.items() if key != "complex"}
        statements = [{**own, **each} for each in real_statements(record)]
    else:
        require(record["relation"] == "=", "matrices are equal, or are not compared")
        statements = entries_of(record)
    if record["verdict"] == "refuted":
        require_keys(certificate, {"method", "proof" if "proof" in certificate else "bits", "entry"})
        place = natural(certificate["entry"])
        require(place < len(statements), "there is no such entry")
        own = {key: value for key, value in certificate.items() if key != "entry"}
        require_real({**statements[place], "certificate": own})
        return
    require_keys(certificate, {"method", "entries"})
    require(certificate["method"] == "real laws", "expected the method 'real laws'")
    require(isinstance(certificate["entries"], list), "expected a proof of each entry")
    require(len(certificate["entries"]) == len(statements), "expected a proof of each entry")
    for statement, proof in zip(statements, certificate["entries"], strict=True):
        require_real({**statement, "certificate": proof})
