"""Decide statements of several parts, entries of matrices or parts of complex numbers, each in the domain of all."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import Any

import sympy

from algebroproj_sym.expressions import NotRationalError
from algebroproj_sym.proving.proof import Proof
from algebroproj_sym.proving.reals.reading import term_of
from algebroproj_sym.replaying.reals.matrices import END, START, entries_of, is_matrix, rows_of
from algebroproj_sym.replaying.reals.terms import written
from algebroproj_sym.replaying.rejection import Rejected


def real_text(value: Any, argument: str) -> str:
    """Return text, a number, an expression or a matrix of such as text.

    Examples
    --------
    >>> x = sympy.Symbol("x")
    >>> real_text(sympy.Matrix([[sympy.cos(x), 0]]), "lhs")
    'Matrix([[cos(x), 0]])'
    """
    if isinstance(value, sympy.MatrixBase):
        rows: list[list[Any]] = value.tolist()
    elif is_matrix(value):
        try:
            rows = rows_of(value)
        except Rejected as error:
            raise NotRationalError(f"{argument}: {error}") from None
    else:
        return written(term_of(value, argument))
    texts = (f"[{', '.join(written(term_of(entry, argument)) for entry in row)}]" for row in rows)
    return f"{START}{', '.join(texts)}{END}"


def proof_of_matrix(lhs: Any, rhs: Any, prove: Callable[[str, str], Proof]) -> Proof:
    """Decide whether two matrices are equal, by what decides two scalars that are text.

    It raises `NotRationalError` if only one side is a matrix, or the shapes differ.
    """
    sides = {"lhs": real_text(lhs, "lhs"), "rhs": real_text(rhs, "rhs")}
    if not all(map(is_matrix, sides.values())):
        raise NotRationalError("prove: expected two sides of one shape, got a matrix and a scalar")
    try:
        entries = entries_of(sides)
    except Rejected as error:
        raise NotRationalError(f"prove: {error}") from None
    return together(prove(entry["lhs"], entry["rhs"]) for entry in entries)


def together(found: Iterable[Proof]) -> Proof:
    """Return the proof of all statements, or the refutation of the first that is refuted."""
    proofs = list[Proof]()
    for place, proof in enumerate(found):
        if proof.verdict == "refuted":
            return in_part(proof, place)
        proofs.append(proof)
    undecided = next((proof for proof in proofs if proof.verdict == "open"), None)
    return undecided or replace(proofs[0], certificate={"method": "real laws", "entries": [*map(_evidence, proofs)]})


def in_part(refutation: Proof, place: int) -> Proof:
    """Return the refutation of one of several statements as one of all."""
    return replace(refutation, certificate={**_evidence(refutation), "entry": place})


def _evidence(proof: Proof) -> Mapping[str, Any]:
    return proof.certificate or {}
