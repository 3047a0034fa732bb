r"""What the symbols of a paper stand for: the reviewed tables in its file ``symbols.toml``.

::

    definitions = ["3", "eq:area"]               equations of a document that define the letter on their left
    statements = ["line 12"]                     equations that define nothing
    identities = ["7", "all"]                    equations that hold for all values of their letters

    [[table]]
    claims = ["1.1", "2.2.6"]                    sections and numbers; without, the whole paper
    letters = { '\mathcal{J}' = "y" }            a letter, or its scan, and how names of symbols begin
    symbols = { '\mathbf{u}' = "[[1], [u1], [u2]]" }   a symbol, and the expression it stands for
    sizes = { '\mathbf{R}' = [3, 3] }            a vector or matrix, and its size
    properties = { '\mathbf{R}' = "rotation" }   what a vector or matrix is
    matrices = { '\mathbf{R}' = "R 3x3" }        in claims in letters: the name and the shape of a vector or matrix
    primes = false                               where the claims write no primes

A symbol that no table has is named by rule: letter, a p for each prime, subscript.  Later tables come first.
"""

import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import sympy

from algebroproj_sym.expressions import Expression, Matrix, ParseError, parse
from algebroproj_sym.proving.letters import PROPERTIES
from algebroproj_sym.reading.documents.files import UnreadableDocumentError
from algebroproj_sym.reading.lexing.commands import GREEK
from algebroproj_sym.reading.lexing.names import split_symbol, written
from algebroproj_sym.reading.lexing.pieces import UnreadableError

FILE = "symbols.toml"
OF_ANGLES = (r"\sin", r"\cos", r"\tan")
"""Functions that a table may name together with their argument."""
MOST_ENTRIES = 6
"""How many rows or columns a letter that stands for a vector or matrix may have."""

Size = tuple[int, int]
_LISTS = ("definitions", "statements", "identities")
_KEYS = frozenset((*_LISTS, "table"))
_TABLE_KEYS = frozenset(("claims", "letters", "symbols", "sizes", "properties", "matrices", "primes"))


@dataclass(frozen=True)
class Table:
    """What some symbols stand for in some claims."""

    claims: tuple[str, ...] = ()
    """Sections and numbers; empty for all."""
    letters: Mapping[str, str] = field(default_factory=dict)
    """How the names of symbols with a letter begin."""
    symbols: Mapping[str, Expression] = field(default_factory=dict)
    """What whole symbols stand for, written as `written` does."""
    primes: bool = True
    """Whether the names of symbols have a p for each prime."""
    sizes: Mapping[str, Size] = field(default_factory=dict)
    """Rows and columns of the symbols that are vectors or matrices."""
    properties: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """What vectors and matrices are: one of `algebroproj_sym.proving.letters.PROPERTIES`, or "identity"."""
    matrices: Mapping[str, sympy.MatrixSymbol] = field(default_factory=dict)
    """What symbols stand for in claims in letters."""

    def covers(self, section: str, number: str) -> bool:
        """Whether the table is for the claim with a number in a section."""
        return not self.claims or any(
            section == part or section.startswith(f"{part}.") or re.match(rf"{re.escape(part)}(#|/|$)", number)
            for part in self.claims
        )


@dataclass(frozen=True)
class SymbolsFile:
    """A file of symbols: its tables, and what the user says of the equations of a document."""

    definitions: frozenset[str] = frozenset()
    statements: frozenset[str] = frozenset()
    identities: frozenset[str] = frozenset()
    tables: tuple[Table, ...] = ()

    @cached_property
    def whole(self) -> Table:
        """What the tables for the whole paper say together."""
        tables = [table for table in self.tables if not table.claims]
        return Table(
            letters={name: text for table in tables for name, text in table.letters.items()},
            symbols={name: value for table in tables for name, value in table.symbols.items()},
            sizes={name: size for table in tables for name, size in table.sizes.items()},
            properties={name: listed for table in tables for name, listed in table.properties.items()},
        )


@dataclass(frozen=True)
class Symbols:
    """The tables for one claim, the most special one first, and values of letters that stand for indices.

    With `in_letters` the matrices of the tables are letters, also where others write them out.
    """

    tables: tuple[Table, ...]
    indices: tuple[tuple[str, str], ...] = ()
    in_letters: bool = False

    def __call__(self, symbol: str) -> Any:
        """Return what a symbol stands for; None if no table and no rule says so."""
        function = next((name for name in OF_ANGLES if symbol.startswith(name)), "")
        letter, primes, subscript, superscript = split_symbol(symbol.removeprefix(function))
        for index, value in self.indices:
            subscript, superscript = subscript.replace(index, value), superscript.replace(index, value)
        whole = function + written(letter, primes, subscript, superscript)
        for table in self.tables if self.in_letters else ():
            if whole in table.matrices:
                return table.matrices[whole]
        for table in self.tables:
            if whole in table.symbols:
                return table.symbols[whole]
        if function or superscript:
            return None
        named = self._by_rule(letter, primes, subscript)
        size = next((table.sizes[whole] for table in self.tables if whole in table.sizes), None)
        return named if size is None or named is None else letters_of(named.name, size)

    def _by_rule(self, letter: str, primes: int, subscript: str) -> sympy.Symbol | None:
        begin = next((table.letters[letter] for table in self.tables if letter in table.letters), None)
        if begin is None and letter not in GREEK and not re.fullmatch("[A-Za-z]", letter):
            return None
        marks = "p" * primes if all(table.primes for table in self.tables) else ""
        name = f"{begin if begin is not None else letter.lstrip(chr(92))}{marks}{subscript}"
        return sympy.Symbol(name) if re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name) else None


def letters_of(name: str, size: Size) -> Matrix:
    """Return a vector or matrix of letters.

    Examples
    --------
    >>> letters_of("x", (2, 1)).T, letters_of("R", (1, 2))
    (Matrix([[x_1, x_2]]), Matrix([[R_11, R_12]]))
    """
    rows, columns = size
    places = [str(i + 1) + ("" if columns == 1 else str(j + 1)) for i in range(rows) for j in range(columns)]
    return Matrix(rows, columns, [sympy.Symbol(f"{name}_{place}") for place in places])


def tables_in(folder: Path) -> tuple[Table, ...]:
    """Return the tables of a folder of derivations; it raises `UnreadableDocumentError` if the file cannot be read."""
    path = folder / FILE
    return _read(path, path.stat().st_mtime_ns).tables if path.is_file() else ()


def symbols_for(section: str, number: str, tables: Sequence[Table]) -> Symbols:
    """Return what symbols stand for in the claim with a number in a section."""
    return Symbols(tuple(table for table in reversed(tables) if table.covers(section, number)))


@cache
def _read(path: Path, stamp: int) -> SymbolsFile:
    return symbols_file(path)


def symbols_file(path: Path) -> SymbolsFile:
    """Read a file of symbols; the error for a wrong one names the key, what was expected and what came."""
    try:
        content = tomllib.loads(path.read_text(encoding="utf-8"))
        _require_keys(content, _KEYS)
        lists = {key: frozenset(map(str, content.get(key, ()))) for key in _LISTS}
        return SymbolsFile(**lists, tables=tuple(map(_table, content.get("table", ()))))
    except OSError as error:
        raise UnreadableDocumentError(f"{path}: the file cannot be read: {error.strerror}") from error
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise UnreadableDocumentError(f"{path}: expected TOML, got {error}") from error
    except (ParseError, UnreadableError, ValueError, TypeError, AttributeError) as error:
        raise UnreadableDocumentError(f"{path}: {error}") from error


def _require_keys(content: Mapping[str, Any], known: frozenset[str]) -> None:
    if unknown := sorted(set(content) - known):
        raise ValueError(f"expected keys of {sorted(known)}, got {unknown}")


def _table(entry: Mapping[str, Any]) -> Table:
    _require_keys(entry, _TABLE_KEYS)
    return Table(
        claims=tuple(map(str, entry.get("claims", ()))),
        letters={_canonical(name): str(text) for name, text in entry.get("letters", {}).items()},
        symbols={_canonical(name): parse(text, name) for name, text in entry.get("symbols", {}).items()},
        primes=bool(entry.get("primes", True)),
        sizes={_canonical(name): _size(size, name) for name, size in entry.get("sizes", {}).items()},
        properties={_canonical(name): _known(given, name) for name, given in entry.get("properties", {}).items()},
        matrices={_canonical(name): _matrix(text, name) for name, text in entry.get("matrices", {}).items()},
    )


def _canonical(symbol: str) -> str:
    function = next((name for name in OF_ANGLES if symbol.startswith(name)), "")
    return function + written(*split_symbol(symbol.removeprefix(function).strip()))


def _known(given: Any, name: str) -> tuple[str, ...]:
    listed = (given,) if isinstance(given, str) else tuple(given)
    known = (*PROPERTIES, "identity")
    if unknown := [each for each in listed if each not in known]:
        raise ValueError(f"properties, {name}: expected one of {', '.join(known)}, got {unknown[0]!r}")
    return listed


def _matrix(text: Any, name: str) -> sympy.MatrixSymbol:
    match = re.fullmatch(r"([A-Za-z]\w*) (\d)x(\d)", text) if isinstance(text, str) else None
    if match is None:
        raise ValueError(f"matrices, {name}: expected a name and a shape such as 'R 3x3', got {text!r}")
    return sympy.MatrixSymbol(match[1], int(match[2]), int(match[3]))


def _size(size: Any, name: str) -> Size:
    rows, columns = (size, 1) if isinstance(size, int) else size
    if not (isinstance(rows, int) and isinstance(columns, int) and 1 <= rows <= MOST_ENTRIES >= columns >= 1):
        raise ValueError(f"sizes, {name}: expected one or two numbers from 1 to {MOST_ENTRIES}, got {size}")
    return rows, columns
