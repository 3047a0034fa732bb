"""Identities that no paper states: whether the verdict on a statement follows from the evidence beside it."""

from collections.abc import Mapping
from typing import Any

from algebroproj_sym.replaying.consequences import (
    Question,
    is_zero,
    number_of,
    numbers_of,
    require_consequence,
    require_divisors,
)
from algebroproj_sym.replaying.entry import require_seconds
from algebroproj_sym.replaying.evaluation import Algebra, evaluate
from algebroproj_sym.replaying.field import Field
from algebroproj_sym.replaying.letters import require_in_letters
from algebroproj_sym.replaying.reals import METHODS, require_real_form
from algebroproj_sym.replaying.rejection import NotReplayable, require, require_keys
from algebroproj_sym.replaying.text import parse_statement, texts

KEYS = {
    "file", "name", "lhs", "rhs", "constraints", "nonzero", "verdict", "expected", "method", "reason", "hypotheses",
    "counterexample", "certificate",
}  # fmt: skip

_OF_REALS = {"assumptions", "complex", "relation"}
_OF_SOME = {"letters", *_OF_REALS}


def require_identity(record: Mapping[str, Any]) -> None:
    """Require that the verdict on an identity of a file follows from its evidence.

    It raises `Rejected` if it does not, and `NotReplayable` if there is no evidence.
    """
    require(
        record.keys() - {"seconds", *_OF_SOME} == KEYS,
        f"expected the entries {sorted(KEYS)}, got {sorted(record)}",
    )
    verdict, certificate = record["verdict"], record["certificate"]
    require(verdict in ("proved", "refuted", "open", "error"), f"there is no verdict {verdict!r}")
    require(record["expected"] in (None, verdict), "the verdict is not the expected one")
    for key in ("file", "name"):
        require(isinstance(record[key], str) and record[key].isprintable(), f"{key}: expected a printable text")
    require_seconds(record)
    if verdict in ("open", "error"):
        raise NotReplayable("an identity that is not decided has no evidence")
    require(record["method"] == certificate["method"], "the method differs from that of the certificate")
    require(record["reason"] is None, "a decided identity must not give a reason")
    if "letters" in record:
        require(not record.keys() & _OF_REALS, "assumptions and relations are used by real laws alone")
        require_in_letters(record)
        return
    if certificate["method"] in METHODS:
        require_real_form({"relation": "=", "assumptions": [], **record})
        return
    require(not record.keys() & _OF_REALS, "assumptions and relations are used by real laws alone")
    question = _question(record)
    if verdict == "refuted":
        _require_difference(record, question, certificate)
        return
    require(record["counterexample"] is None, "a proved identity must not have a counterexample")
    if certificate["method"] == "normal form":
        require_keys(certificate, {"method", "denominators"})
        require(not question.constraints, "a normal form decides nothing under constraints")
        field = Field(question.symbols, certificate["denominators"])
        require(all(entry.is_zero for entry in question.difference(field)), "the two sides differ")
        field.units(question.nonzero)
        require_divisors(question.hypotheses, field, certificate["denominators"])
    else:
        require_consequence(question, certificate)


def _question(record: Mapping[str, Any]) -> Question:
    left, right = parse_statement(record["lhs"]), parse_statement(record["rhs"])
    require(left.shape == right.shape, "the two sides differ in shape")
    constraints = [parse_statement(text) for text in texts(record["constraints"])]
    nonzero = [parse_statement(text) for text in texts(record["nonzero"])]
    require(not any(form.shape for form in (*constraints, *nonzero)), "expected scalars as constraints and conditions")
    symbols = {name for form in (left, right, *constraints, *nonzero) for name in form.symbols()}

    require("pi" not in symbols, "pi is a number, which is known by real laws alone")

    def sides(algebra: Algebra) -> tuple[list[Any], list[Any]]:
        return evaluate(left, algebra), evaluate(right, algebra)

    return Question(sides, constraints, nonzero, symbols, record["hypotheses"])


def _require_difference(record: Mapping[str, Any], question: Question, certificate: Mapping[str, Any]) -> None:
    require_keys(certificate, {"method", "left", "right"}, {"extension"})
    require(certificate["method"] == "counterexample", "expected the method 'counterexample'")
    require(question.hypotheses == [], "a refuted identity must not have hypotheses")
    numbers = numbers_of(certificate)
    sides = question.sides_at(record["counterexample"], numbers)
    for name, values in zip(("left", "right"), sides, strict=True):
        shown = [number_of(text, numbers) for text in texts(certificate[name])]
        same = len(shown) == len(values) and all(is_zero(a - b) for a, b in zip(shown, values, strict=True))
        require(same, f"the recorded value of the {name} side at the point is wrong")
    require(any(not is_zero(a - b) for a, b in zip(*sides, strict=True)), "the two sides do not differ")
