"""Judgements in a folder, a file each: written whole or not at all, believed only if they fit their keys."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import sys
import tempfile
import time
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

import sympy

from algebroproj_sym.declaring import VERDICTS, Claim, Judgement
from algebroproj_sym.expressions import parse, text
from algebroproj_sym.remembering.key import key_of, prover

VARIABLE = "ALGEBROPROJ_CACHE"
DAYS = 30


def cache_folder() -> Path:
    """Return the user's folder for what can be computed again; the variable ALGEBROPROJ_CACHE names another."""
    if named := os.environ.get(VARIABLE):
        return Path(named)
    usual = {"win32": ("LOCALAPPDATA", "AppData/Local"), "darwin": ("", "Library/Caches")}
    variable, below_home = usual.get(sys.platform, ("XDG_CACHE_HOME", ".cache"))
    return Path(os.environ.get(variable) or Path.home() / below_home) / "algebroproj"


@dataclass(frozen=True)
class Memory:
    """What earlier runs have proved.

    Attributes
    ----------
    folder : Path
        Where the entries are; it may be deleted at any time.
    fresh : bool
        Whether to recall nothing, and to replace what is there.
    """

    folder: Path
    fresh: bool = False

    def recall(self, claim: Claim, engine: str) -> Judgement | None:
        """Return the judgement of an earlier run; None if there is none that fits the claim, the engine and the prover.

        A file that is damaged, or was written for another key, is no judgement.
        """
        if self.fresh:
            return None
        key = key_of(claim, engine)
        try:
            entry = json.loads(self._file(key).read_text(encoding="utf-8"))
            if entry["digest"] != _digest(key, entry["evidence"]):
                return None
            return _judgement(claim, engine, entry["evidence"])
        except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
            return None

    def keep(self, judgement: Judgement) -> None:
        """Write a judgement, if it can be read back as it is and the folder can be written to."""
        key = key_of(judgement.claim, judgement.engine)
        evidence = _evidence(judgement)
        if _judgement(judgement.claim, judgement.engine, json.loads(json.dumps(evidence))) == judgement:
            try:
                _write(self._file(key), json.dumps({"digest": _digest(key, evidence), "evidence": evidence}))
            except OSError:
                return

    def forget_what_is_old(self) -> None:
        """Remove what provers left behind that have not been used for a month."""
        oldest = time.time() - DAYS * 86400
        for folder in self.folder.glob("prover-*"):
            if folder.is_dir() and folder.stat().st_mtime < oldest:
                shutil.rmtree(folder, ignore_errors=True)

    def _file(self, key: str) -> Path:
        return self.folder / f"prover-{prover()[:16]}" / f"{key}.json"


def _evidence(judgement: Judgement) -> dict[str, Any]:
    point = judgement.counterexample
    return {
        "verdict": judgement.verdict,
        "hypotheses": [text(factor) for factor in judgement.hypotheses],
        "certificate": judgement.certificate,
        "counterexample": None if point is None else {symbol.name: str(value) for symbol, value in point.items()},
        "seconds": judgement.seconds,
    }


def _judgement(claim: Claim, engine: str, evidence: dict[str, Any]) -> Judgement:
    if evidence["verdict"] not in VERDICTS:
        raise ValueError(f"verdict: expected one of {VERDICTS}, got {evidence['verdict']!r}")
    point = evidence["counterexample"]
    return Judgement(
        claim=claim,
        verdict=evidence["verdict"],
        hypotheses=tuple(parse(factor, "hypotheses") for factor in evidence["hypotheses"]),
        certificate=evidence["certificate"],
        counterexample=None if point is None else {sympy.Symbol(name): Fraction(v) for name, v in point.items()},
        engine=engine,
        seconds=float(evidence["seconds"]),
    )


def _digest(key: str, evidence: dict[str, Any]) -> str:
    return hashlib.sha256(f"{key}\n{json.dumps(evidence)}".encode()).hexdigest()


def _write(path: Path, content: str) -> None:
    """Write a file under a name of its own first, so that two runs may write the same entry."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile("w", encoding="utf-8", dir=path.parent, suffix=".partial", delete=False) as file:
        temporary = Path(file.name)
        try:
            file.write(content)
            file.close()
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)
