"""Claims with real functions, or in letters: their evidence is that of the same statements from elsewhere."""

from collections.abc import Mapping
from typing import Any

from algebroproj_sym.replaying.letters import read_alone, require_in_letters
from algebroproj_sym.replaying.reals import require_real_form
from algebroproj_sym.replaying.rejection import require, require_keys

UP_TO_SCALE = "identity up to scale"
LANGUAGES = frozenset({"assumptions", "letters"})
"""The entry of the setting that a claim with real functions has, and the one that a claim in letters has."""


def require_form(record: Mapping[str, Any], form: str, certificate: Mapping[str, Any]) -> None:
    """Check the proof that a form equals the derived one, perhaps up to scale; what is defined equals itself."""
    proved = {"verdict": "proved", "hypotheses": record["hypotheses"], "counterexample": None}
    if record["kind"] != UP_TO_SCALE:
        other = form if record["kind"] == "definition" else "derived"
        _require(record, record[form], record[other], certificate, **proved)
        return
    require("nonzero at" in certificate, "no point shows that neither side is zero everywhere")
    own = {key: value for key, value in certificate.items() if key != "nonzero at"}
    left, right = _proportional(record, form)
    _require(record, left, right, own, **proved)
    require_keys(certificate["nonzero at"], {"point", "left", "right"})
    point, *values = (certificate["nonzero at"][key] for key in ("point", "left", "right"))
    differing = {"method": "counterexample", "left": values[0], "right": values[1]}
    nonzero = {"verdict": "refuted", "hypotheses": [], "counterexample": point}
    _require(record, left, "0", differing, **nonzero)


def require_no_form(record: Mapping[str, Any], form: str, certificate: Mapping[str, Any]) -> None:
    """Check the point at which a form differs from the derived one, whatever the scale."""
    up_to_scale = record["kind"] == UP_TO_SCALE
    left, right = _proportional(record, form) if up_to_scale else (record[form], record["derived"])
    refuted = {"verdict": "refuted", "hypotheses": [], "counterexample": record["counterexample"]}
    _require(record, left, right, certificate, **refuted)


def _proportional(record: Mapping[str, Any], form: str) -> tuple[str, str]:
    """Return two matrices that are equal where a form and the derived one are proportional, or one is zero."""
    require(all(isinstance(record[name], str) for name in (form, "derived")), "expected text")
    read_alone(record["setting"], record[form], record["derived"])
    return f"kron({record[form]}, {record['derived']})", f"kron({record['derived']}, {record[form]})"


def _require(record: Mapping[str, Any], left: str, right: str, certificate: Mapping[str, Any], **found: Any) -> None:
    setting = record["setting"]
    require(len(LANGUAGES & setting.keys()) == 1, "expected a statement with real functions, or one in letters")
    require(record["where"] == {}, "a symbol is explained that stands for itself")
    statement = {
        "constraints": [],
        "nonzero": [],
        **setting,
        "lhs": left,
        "rhs": right,
        "certificate": certificate,
        **found,
    }
    if "letters" in setting:
        require_in_letters(statement)
    else:
        require_real_form({"relation": "=", **statement})
