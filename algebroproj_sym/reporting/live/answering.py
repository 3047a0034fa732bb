"""The answers to the questions of a page.  It runs in the browser, so it imports only what an answer needs."""

import json
from collections.abc import Callable, Mapping
from typing import Any

MOST_CHARACTERS = 20_000
CONDITIONS = ("constraints", "nonzero", "assumptions")
_KINDS: Mapping[type, str] = {str: "text", dict: "an object"}


def answer(question: str) -> str:
    """Answer a question of the page.

    Parameters
    ----------
    question : str
        JSON.  ``{"do": "replay", "claim": ENTRY}`` checks an entry of the ledger again.  ``{"do": "prove", "lhs": TEXT,
        "rhs": TEXT}`` decides an identity, or an inequality with its ``relation``; ``constraints``, ``nonzero`` and
        ``assumptions`` are lists of texts, and ``where`` has the text of each name that the forms use.
        ``{"do": "prepare"}`` imports the prover.

    Returns
    -------
    str
        JSON: what was found, or ``{"error": MESSAGE}``.

    Examples
    --------
    >>> json.loads(answer('{"do": "prove", "lhs": "(x^2 - 1)/(x - 1)", "rhs": "x + 1"}'))
    {'verdict': 'proved', 'hypotheses': ['x - 1 != 0'], 'counterexample': {}, 'left': [], 'right': [], 'reason': ''}
    >>> json.loads(answer('{"do": "prove", "lhs": "1/(1 + x", "rhs": "x"}'))
    {'error': "lhs, position 8: expected an operator or ')', got the end"}
    """
    try:
        asked = json.loads(question)
        do = _entry(asked, "do", str)
        if do not in _ANSWERS:
            raise ValueError(f"do: expected {' or '.join(_ANSWERS)}, got {do}")
        told = _ANSWERS[do](asked)
    except (ValueError, TypeError, ArithmeticError, NotImplementedError, RecursionError, MemoryError) as error:
        told = {"error": str(error) or type(error).__name__}
    return json.dumps(told, ensure_ascii=False)


def _entry(asked: Any, name: str, kind: type) -> Any:
    """Return an entry of a question."""
    value = asked.get(name) if isinstance(asked, Mapping) else None
    if not isinstance(value, kind):
        raise TypeError(f"{name}: expected {_KINDS[kind]}, got {type(value).__name__}")
    return value


def _replay(asked: Mapping[str, Any]) -> dict[str, Any]:
    from algebroproj_sym.replaying import replay_claim

    found = replay_claim(_entry(asked, "claim", dict))
    return {"status": found.status, "reason": found.reason}


def _prove(asked: Mapping[str, Any]) -> dict[str, Any]:
    from algebroproj_sym import prove

    given: dict[str, Any] = {key: [*asked.get(key, ())] for key in (*CONDITIONS, "letters")}
    lhs, rhs = (_entry(asked, side, str) for side in ("lhs", "rhs"))
    length = sum(map(len, (lhs, rhs, *(text for texts in given.values() for text in texts))))
    if length > MOST_CHARACTERS:
        raise ValueError(f"expected at most {MOST_CHARACTERS} characters in all, got {length}")
    given["letters"] = dict(map(_letter, given["letters"])) or None
    given["relation"] = _entry({"relation": "=", **asked}, "relation", str)
    if named := _entry({"where": {}, **asked}, "where", dict):
        read = _reader(named)
        given |= {key: [read(text) for text in given[key]] for key in ("constraints", "nonzero")}
        proof = prove(read(lhs), read(rhs), **given)
    else:
        proof = prove(lhs, rhs, **given)
    evidence = proof.certificate or {}
    return {
        "verdict": proof.verdict,
        "hypotheses": [each if isinstance(each, str) else f"{each} != 0" for each in proof.hypotheses],
        "counterexample": {str(name): str(value) for name, value in (proof.counterexample or {}).items()},
        "left": [str(value) for value in evidence.get("left", ())],
        "right": [str(value) for value in evidence.get("right", ())],
        "reason": str(evidence.get("reason", "")) if proof.verdict == "open" else "",
    }


def _letter(text: str) -> tuple[str, str]:
    """Return a letter and what it is."""
    name, colon, meaning = text.partition(":")
    if not colon:
        raise ValueError(f"letters: expected a letter and what it is, such as R: 3x3 rotation, got {text}")
    return name.strip(), meaning.strip()


def _reader(named: Mapping[str, str]) -> Callable[[str], Any]:
    """Return how a text with names is read: each name stands for its form, which may use later names."""
    from sympy import Symbol

    from algebroproj_sym.expressions import parse

    forms = {Symbol(name): parse(text) for name, text in named.items()}

    def read(text: str) -> Any:
        form = parse(text)
        for _ in forms:
            form = form.xreplace(forms)
        return form

    return read


def _prepare(_: Mapping[str, Any]) -> dict[str, Any]:
    import flint
    import sympy

    from algebroproj_sym import prove

    prove("x", "x")
    return {"sympy": sympy.__version__, "flint": flint.__version__}


_ANSWERS: Mapping[str, Callable[[Mapping[str, Any]], dict[str, Any]]] = {
    "replay": _replay,
    "prove": _prove,
    "prepare": _prepare,
}
