"""The digest of all that a verdict depends on: the declaration, the engine, the prover and its libraries."""

from __future__ import annotations

import hashlib
import json
import platform
from collections.abc import Mapping
from dataclasses import fields
from decimal import Decimal
from fractions import Fraction
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import sympy

from algebroproj_sym.declaring import Claim
from algebroproj_sym.expressions import assumption, in_steps, is_plain, shape

ROOT = Path(__file__).resolve().parent.parent
STAGES = ("expressions", "proving", "declaring", "remembering")
LIBRARIES = ("sympy", "python-flint", "mpmath")


def key_of(claim: Claim, engine: str) -> str:
    """Return the key under which the verdict of a claim is remembered.

    Examples
    --------
    >>> from algebroproj_sym import Section
    >>> x = sympy.Symbol("x")
    >>> claim = Section("demo", "1", "Squares").identity("1.1", "square", printed=x**2, derived=x * x)
    >>> key_of(claim, "flint") == key_of(claim, "sympy")
    False
    """
    return _digest([prover(), engine, declaration(claim)])


@cache
def prover() -> str:
    """Return the digest of the prover: its source, and the versions of what it computes with."""
    files = sorted(path for stage in STAGES for path in (ROOT / stage).rglob("*.py"))
    sources = [[path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")] for path in files]
    return _digest([sources, platform.python_version(), [[name, version(name)] for name in LIBRARIES]])


def declaration(claim: Claim) -> list[Any]:
    """Return all that a claim declares as plain data; expressions with every division that they make."""
    return [[field.name, _data(getattr(claim, field.name))] for field in fields(claim) if field.compare]


def _data(value: Any) -> Any:
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, Decimal | Fraction | int):
        return [type(value).__name__, str(value)]
    if isinstance(value, sympy.Symbol) and not is_plain(value):
        return ["assumption", assumption(value)]
    if isinstance(value, sympy.Expr | sympy.MatrixBase):
        return ["expression", shape(value), in_steps(value)]
    if isinstance(value, Mapping):
        return ["mapping", [[_data(key), _data(entry)] for key, entry in value.items()]]
    return ["sequence", list(map(_data, value))]


def _digest(data: Any) -> str:
    return hashlib.sha256(json.dumps(data, ensure_ascii=False).encode()).hexdigest()
