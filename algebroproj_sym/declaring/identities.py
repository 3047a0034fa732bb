"""Identities that no paper states: files of statements as text, with the expected verdicts."""

import difflib
from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from algebroproj_sym.files import AmbiguousError, strict_json
from algebroproj_sym.proving.statements import RELATIONS
from algebroproj_sym.proving.worker import Outcome, Question
from algebroproj_sym.replaying.reals.terms import has_parts

EXPECTED = ("proved", "refuted", "open")
KEYS = ("name", *(field.name for field in fields(Question)), "expected")
MAX_BYTES = 20_000_000


class MalformedFileError(ValueError):
    """A file is not a list of identities."""


@dataclass(frozen=True)
class Identity:
    """A statement of a file."""

    file: Path
    place: str
    """Where it stands: file, item and name."""
    name: str
    """Its name, or its place in the file."""
    question: Question
    """What is asked."""
    expected: str | None
    """The verdict that is declared, if one is."""


@dataclass(frozen=True)
class Answer:
    """An identity and what became of it."""

    identity: Identity
    outcome: Outcome

    @property
    def as_declared(self) -> bool:
        """Whether it is decided, and as declared; an identity declared open may stay open."""
        expected = self.identity.expected
        if expected is None:
            return self.outcome.verdict in ("proved", "refuted")
        return self.outcome.verdict == expected


def identities(path: Path) -> tuple[Identity, ...]:
    """Read a file of identities.

    Parameters
    ----------
    path : Path
        JSON: a list of objects with ``lhs`` and ``rhs`` as text, and optionally ``relation`` (one of
        `algebroproj_sym.proving.statements.RELATIONS`), ``constraints``, ``nonzero`` and ``assumptions`` (lists of
        text), ``name``, ``letters`` (the vectors and matrices, such as ``{"R": "3x3 rotation"}``), ``complex`` (the
        names of complex variables; see `prove`), ``variables`` (the names that may occur), ``witness`` (name to
        rational number as text) and ``expected`` (one of `EXPECTED`).  Other keys, such as ``source``, are kept out.

    Raises
    ------
    MalformedFileError
        Naming file, item and key.  Mathematics is read later, by the workers that decide it.
    """
    try:
        if path.stat().st_size > MAX_BYTES:
            raise MalformedFileError(f"expected at most {MAX_BYTES} bytes, got {path.stat().st_size}")
        items = strict_json(path.read_text(encoding="utf-8"))
    except (AmbiguousError, MalformedFileError) as error:
        raise MalformedFileError(f"{path}: {error}") from error
    except OSError as error:
        raise MalformedFileError(f"{path}: expected a readable file, got {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise MalformedFileError(f"{path}: expected JSON, got {error}") from error
    if not isinstance(items, list):
        raise MalformedFileError(f"{path}: expected a list of objects, got {_kind(items)}")
    if not items:
        raise MalformedFileError(f"{path}: expected at least one object, got an empty list")
    return tuple(_identity(path, place, item) for place, item in enumerate(items))


def _identity(path: Path, place: int, item: Any) -> Identity:
    where = f"{path}, item {place}"
    if not isinstance(item, dict):
        raise MalformedFileError(f"{where}: expected an object, got {_kind(item)}")
    name = item.get("name", f"{path.stem}[{place}]")
    if not _text(where, "name", name).isprintable():
        raise MalformedFileError(f"{where}, key 'name': expected text on one line, got {name!r:.80}")
    where = f"{where} ({name[:80]})"
    for key in item:
        near = [] if key in KEYS else difflib.get_close_matches(key, KEYS, n=1, cutoff=0.8)
        if near:
            raise MalformedFileError(f"{where}: expected the key {near[0]!r}, got {key!r}")
    for key in ("lhs", "rhs"):
        if key not in item:
            raise MalformedFileError(f"{where}, key {key!r}: expected text, got nothing")
    expected = item.get("expected")
    if expected is not None and expected not in EXPECTED:
        raise MalformedFileError(
            f"{where}, key 'expected': expected one of {', '.join(EXPECTED)}, got {expected!r:.80}"
        )
    constraints, nonzero = (_texts(where, key, item.get(key, [])) for key in ("constraints", "nonzero"))
    letters = _letters(where, item) if "letters" in item else None
    variables = _texts(where, "variables", item["variables"]) if "variables" in item else None
    question = Question(
        _text(where, "lhs", item["lhs"]),
        _text(where, "rhs", item["rhs"]),
        constraints,
        nonzero,
        _witness(where, item["witness"]) if "witness" in item else None,
        variables,
        _texts(where, "assumptions", item.get("assumptions", [])),
        letters,
        _relation(where, item.get("relation", "=")),
        _complex(where, item),
    )
    return Identity(path, where, name, question, expected)


def _complex(where: str, item: Mapping[str, Any]) -> tuple[str, ...] | None:
    """Return the complex variables; there may be none in a statement about complex numbers."""
    if "complex" in item:
        return _texts(where, "complex", item["complex"])
    stated = [item["lhs"], item["rhs"], *item.get("constraints", []), *item.get("nonzero", [])]
    return () if any(map(has_parts, stated)) else None


def _relation(where: str, value: Any) -> str:
    if value not in RELATIONS:
        raise MalformedFileError(f"{where}, key 'relation': expected one of {', '.join(RELATIONS)}, got {value!r:.80}")
    return str(value)


def _text(where: str, key: str, value: Any) -> str:
    if not isinstance(value, str):
        raise MalformedFileError(f"{where}, key '{key}': expected text, got {_kind(value)}")
    if any("\ud800" <= letter <= "\udfff" for letter in value):
        raise MalformedFileError(f"{where}, key {key!r}: expected text, got half a surrogate pair")
    return value


def _texts(where: str, key: str, value: Any) -> tuple[str, ...]:
    if not isinstance(value, list):
        raise MalformedFileError(f"{where}, key {key!r}: expected a list of text, got {_kind(value)}")
    return tuple(_text(where, f"{key}', entry '{place}", entry) for place, entry in enumerate(value))


def _witness(where: str, value: Any) -> Mapping[str, str]:
    if not isinstance(value, dict):
        raise MalformedFileError(f"{where}, key 'witness': expected an object, got {_kind(value)}")
    return {name: _text(where, f"witness', entry '{name}", number) for name, number in value.items()}


def _letters(where: str, item: Mapping[str, Any]) -> Mapping[str, str]:
    for key in ("variables", "witness"):
        if key in item:
            raise MalformedFileError(f"{where}, key {key!r}: expected none beside the key 'letters'")
    letters = item["letters"]
    if not isinstance(letters, dict):
        raise MalformedFileError(f"{where}, key 'letters': expected an object, got {_kind(letters)}")
    return {name: _text(where, f"letters', entry '{name}", text) for name, text in letters.items()}


def _kind(value: Any) -> str:
    names = {dict: "an object", list: "a list", str: "text", bool: "true or false", type(None): "null"}
    return names.get(type(value), "a number")
