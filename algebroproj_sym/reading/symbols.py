r"""What the symbols of a paper stand for: the reviewed tables in the file ``symbols.toml`` of its derivations.

::

    [[table]]
    claims = ["1.1", "2.2.6"]                    sections and numbers; without, all claims
    letters = { '\mathcal{J}' = "y" }            a letter, or its scan, and how names of symbols begin
    symbols = { '\mathbf{u}' = "[[1], [u1], [u2]]" }   a symbol, and the expression it stands for
    primes = false                               where the claims write no primes

A symbol that no table has is named by rule: letter, a p for each prime, subscript.  Later tables come first.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import sympy

from algebroproj_sym.declaring import Claim, DeclarationError
from algebroproj_sym.expressions import Expression, ParseError, parse
from algebroproj_sym.reading.lexing import GREEK, split_symbol, written

FILE = "symbols.toml"
OF_ANGLES = (r"\sin", r"\cos", r"\tan")
"""Functions that a table may name together with their argument."""


@dataclass(frozen=True)
class Table:
    """What some symbols stand for in some claims.

    Attributes
    ----------
    claims : tuple of str
        Sections and numbers; empty for all.
    letters : mapping of str to str
        How the names of symbols with a letter begin.
    symbols : mapping of str to Expression
        What whole symbols stand for, written as `written` does.
    primes : bool
        Whether the names of symbols have a p for each prime.
    """

    claims: tuple[str, ...]
    letters: Mapping[str, str]
    symbols: Mapping[str, Expression]
    primes: bool = True

    def covers(self, claim: Claim) -> bool:
        """Whether the table is for a claim."""
        return not self.claims or any(_is_part(claim, part) for part in self.claims)


def _is_part(claim: Claim, part: str) -> bool:
    in_section = claim.section == part or claim.section.startswith(f"{part}.")
    return in_section or re.match(rf"{re.escape(part)}(#|/|$)", claim.number) is not None


@dataclass(frozen=True)
class Symbols:
    """The tables for one claim, the most special one first, and values of letters that stand for indices."""

    tables: tuple[Table, ...]
    indices: tuple[tuple[str, str], ...] = ()

    def __call__(self, symbol: str) -> Any:
        """Return what a symbol stands for; None if no table and no rule says so."""
        function = next((name for name in OF_ANGLES if symbol.startswith(name)), "")
        letter, primes, subscript, superscript = split_symbol(symbol.removeprefix(function))
        for index, value in self.indices:
            subscript, superscript = subscript.replace(index, value), superscript.replace(index, value)
        whole = function + written(letter, primes, subscript, superscript)
        for table in self.tables:
            if whole in table.symbols:
                return table.symbols[whole]
        return None if function or superscript else self._by_rule(letter, primes, subscript)

    def _by_rule(self, letter: str, primes: int, subscript: str) -> sympy.Symbol | None:
        begin = next((table.letters[letter] for table in self.tables if letter in table.letters), None)
        if begin is None and letter not in GREEK and not re.fullmatch("[A-Za-z]", letter):
            return None
        marks = "p" * primes if all(table.primes for table in self.tables) else ""
        name = f"{begin if begin is not None else letter.lstrip(chr(92))}{marks}{subscript}"
        return sympy.Symbol(name) if re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name) else None


def tables_in(folder: Path) -> tuple[Table, ...]:
    """Return the tables of a folder of derivations.

    Raises
    ------
    DeclarationError
        If the file cannot be read.
    """
    path = folder / FILE
    return _read(path, path.stat().st_mtime_ns) if path.is_file() else ()


def symbols_for(claim: Claim, tables: Sequence[Table]) -> Symbols:
    """Return what symbols stand for in a claim."""
    return Symbols(tuple(table for table in reversed(tables) if table.covers(claim)))


@cache
def _read(path: Path, stamp: int) -> tuple[Table, ...]:
    try:
        content = tomllib.loads(path.read_text(encoding="utf-8"))
        return tuple(_table(entry) for entry in content.get("table", ()))
    except (tomllib.TOMLDecodeError, ParseError) as error:
        raise DeclarationError(f"{path}: {error}") from error


def _table(entry: Mapping[str, Any]) -> Table:
    symbols = {_canonical(symbol): parse(text, symbol) for symbol, text in entry.get("symbols", {}).items()}
    return Table(tuple(entry.get("claims", ())), dict(entry.get("letters", {})), symbols, entry.get("primes", True))


def _canonical(symbol: str) -> str:
    function = next((name for name in OF_ANGLES if symbol.startswith(name)), "")
    return function + written(*split_symbol(symbol.removeprefix(function).strip()))
