"""Theorems about real functions, from the proofs of the ledger: each law is a lemma of ``Functions.v``."""

from collections.abc import Mapping
from typing import Any

from algebroproj_sym.exporting.reals.formulas import called, compared, concluded, formula
from algebroproj_sym.exporting.reals.steps import write_proof
from algebroproj_sym.exporting.reals.writing import Written
from algebroproj_sym.exporting.refusal import Silent
from algebroproj_sym.replaying.reals.comparisons import compared as between
from algebroproj_sym.replaying.reals.definitions import conditions
from algebroproj_sym.replaying.reals.matrices import entries_of, is_matrix, rows_of
from algebroproj_sym.replaying.reals.statement import Statement, statement_of
from algebroproj_sym.replaying.reals.terms import CALCULUS, read

Proved = dict[str, tuple[str, str]]
KINDS = ("identity", "identity under constraints", "inequality")
"""The kinds of claims that have theorems."""


def real_theorems(record: Mapping[str, Any]) -> Proved:
    """Return statements and proofs of what a proved statement with real functions says, by what they show.

    A record has what is stated, the verdict and the certificate.  It raises `Silent` if it is refuted, or has
    derivatives, integrals or expansions, or its proof uses a law without a lemma.

    Examples
    --------
    >>> from algebroproj_sym.proving.reals import decided
    >>> asked = {"lhs": "sqrt(x)^2", "rhs": "x", "relation": "=", "assumptions": [], "constraints": [], "nonzero": []}
    >>> print(real_theorems(decided(asked))["holds"][0])
    forall x : R,
    0 <= x ->
    (sqrt x) ^ 2 = x
    """
    if "complex" in record:
        raise Silent("no theorem is written yet about complex numbers")
    if record["verdict"] != "proved":
        raise Silent("no theorem is written yet that refutes a statement with real functions")
    if not is_matrix(record["lhs"]):
        return {"holds": _theorem(statement_of(record), record["certificate"]["proof"])}
    left, right = rows_of(record["lhs"]), rows_of(record["rhs"])
    places = [(i, j) for i, row in enumerate(left, 1) for j, _ in enumerate(row, 1)]
    return {
        f"entry {i} {j}": _theorem(
            statement_of(each), each["certificate"]["proof"], (left[i - 1][j - 1], right[i - 1][j - 1])
        )
        for (i, j), each in zip(places, _proofs_of_entries(record), strict=True)
    }


def theorems_of_claim(record: Mapping[str, Any]) -> Proved:
    """Return the theorems of a claim of the ledger; of one with a correction, that this holds."""
    if record["verdict"] == "false" or record["kind"] not in KINDS:
        raise Silent("no theorem is written yet for a claim with real functions of this kind or verdict")
    form = "printed" if record["verdict"] == "proved" else "corrected"
    certificate = {key: value for key, value in record["certificate"].items() if key != "refutation"}
    sides = {"lhs": record[form], "rhs": record["derived"], "verdict": "proved", "certificate": certificate}
    return real_theorems({"relation": "=", "constraints": [], "nonzero": [], **record["setting"], **sides})


def _proofs_of_entries(record: Mapping[str, Any]) -> list[dict[str, Any]]:
    pairs = zip(entries_of(record), record["certificate"]["entries"], strict=True)
    return [{**each, "certificate": certificate} for each, certificate in pairs]


def _theorem(statement: Statement, proof: Mapping[str, Any], entry: tuple[str, str] | None = None) -> tuple[str, str]:
    """Return statement and proof; of an entry of matrices, both sides are said without the rest of the matrices."""
    parts = [part for side in (*statement.sides, *(term for _, term in statement.given)) for part in side.parts()]
    if statement.domain or any(part.kind in CALCULUS for part in parts):
        raise Silent("no theorem is written yet for derivatives, integrals and expansions")
    said = dict.fromkeys(
        [
            *(pair for given in statement.given for pair in (*conditions(given[1]), given)),
            *(pair for side in statement.sides for pair in conditions(side) if pair[1].kind != "number"),
        ]
    )
    texts = {pair: compared(pair) for pair in said}
    names = {text: f"premise'{place}" for place, text in enumerate(dict.fromkeys(t for t, _ in texts.values()), 1)}
    premises = [(pair, f"({proves.format(names[text])})") for pair, (text, proves) in texts.items()]
    theory = Written(statement.symbols(), premises)
    for given in statement.given:
        theory.given(given, dict(premises)[given])
    for side in statement.sides:
        theory.term(side, granted=True)
    goal = between(read(entry[0]), "=", read(entry[1])) if entry else statement.goal
    text, lemma = concluded(goal)

    def conclude(reached: Written) -> None:
        name = reached.proof(goal[0], reached.term(goal[1]), formula(goal[1]), reached.rewriting(goal[1]))
        reached.lines.append(f"exact ({lemma} _ _ {name}).")

    write_proof(theory, proof, conclude)
    variables = [called(name) for name in sorted(statement.symbols())]
    shown = [f"forall {' '.join(variables)} : R,"] if variables else []
    introduced = [*variables, *names.values()]
    intros = [f"intros {' '.join(introduced)}."] if introduced else []
    return "\n".join([*shown, *(f"{text} ->" for text in names), text]), "\n".join([*intros, *theory.lines])
