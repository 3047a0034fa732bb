r"""Quotes: where a paper prints what a claim is about, word for word, from the files of quotes beside its derivations.

The file ``quotes.toml`` tells of the paper::

    source = "name of the paper's file"

The file ``quotes/1.3.toml`` has the quotes of section 1.3 in the order of the paper.  A short paper may have all in
``quotes.toml``::

    [[quote]]
    claims = ["1.3.5#mu3"]                          several claims may share a quote
    line = 201                                      the line on which it begins
    latex = '\mu_3 = -\frac{y_{00}}{u_{30}y_{03}}'    or a list of pieces that follow one another
    edits = [{ scan = '\mu_{31}', read = 'u_{31}', why = "the scan takes u for mu" }]     where the scan is damaged

    [[table]]
    name = "4/a"                                    the cell of row 1 and column y2 is the claim 4/a#1.y2
    line = 976                                      of the first row
    columns = ["X1", "X2", "y1", "y2"]
    given = ["X1", "X2"]                            columns that are not claims
    names = { "$O'$" = "O1" }                       what the claims call a row; "" for one with quotes of its own
    rows = "1\t292.50\t202.50\t-0.0\t0.5"             a line for each row: its name and its cells, with tabs between

    [[unquoted]]
    claims = ["1.3/core"]
    reason = "implied"

The references and captions of ``outline.toml`` are quotes as well, but for those that a claim with ``/ref-`` in its
number quotes.  A claim with ``/beyond/`` in its number has no quote; where a whole folder goes beyond the papers,
``beyond = true``.
"""

import re
import tomllib
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from functools import cache
from pathlib import Path
from typing import Any, Literal, get_args

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.outline import Mark, captions, outline, references

Unparsed = Literal["prose", "illegible", "unread"]
Beside = Literal["rows", "columns"]
Unquoted = Literal["beyond", "implied", "figure", "lost"]
UNPARSED: dict[Unparsed, str] = {
    "prose": "the paper says it in words: no formula and no number of the sentence states the claim",
    "illegible": "the scan does not preserve the formula",
    "unread": "the formula is legible, and not read; the quote says why",
}
UNQUOTED: dict[Unquoted, str] = {
    "beyond": "the claim goes beyond the paper",
    "implied": "the statement follows from several places of the paper, and no single one prints it",
    "figure": "it stands in a figure or table that the scan does not have as text",
    "lost": "the scan has lost the place",
}
Cells = Mapping[str, Mapping[str, str]]
"""The cells of a table, by row and column."""
_BEYOND = "/beyond/"
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
FILE, SECTIONS = "quotes.toml", "quotes"


@dataclass(frozen=True)
class Edit:
    """How a damaged place of a quote is read."""

    scan: str
    """What the scan shows, a part of one of the pieces of the quote."""
    read: str
    """What it is read as, everywhere in the quote."""
    why: str
    """The reason."""

    @property
    def text(self) -> str:
        """The edit in a line."""
        return f"{self.read or 'nothing'} where the scan has {self.scan}: {self.why}"


@dataclass(frozen=True)
class Quote:
    """What a paper prints about some claims, and how the parts that a claim is about are taken from it."""

    claims: tuple[str, ...]
    """The numbers of the claims."""
    line: int
    """The line of the paper's file on which the quote begins."""
    pieces: tuple[str, ...]
    """The quote; several pieces where something else stands between them."""
    sides: tuple[int, ...] = (-1,)
    """Which sides of each piece the claims are about, counted as in a Python sequence."""
    equation: bool = False
    """Whether the claims are about the difference of the first and the last side."""
    coefficients: tuple[str, ...] = ()
    """Then: the unknowns whose coefficients the claims list, "1" for the constant, "-1" for it on the right side."""
    indices: Mapping[str, tuple[str, ...]] = field(default_factory=dict, hash=False)
    """Letters that stand for indices, and the values for which the quote is read."""
    beside: Beside | Literal[""] = ""
    """Whether the expressions of the quote are the rows or the columns of one matrix."""
    unparsed: Unparsed | Literal[""] = ""
    """Why the quote is not read as a formula; empty if it is."""
    why: str = ""
    """What prevents that, in a few words: each quote that is ``unread`` says it."""
    edits: tuple[Edit, ...] = ()
    """How damaged places are read."""

    @property
    def text(self) -> str:
        """The pieces in one line."""
        return " … ".join(self.pieces)

    @property
    def read(self) -> tuple[str, ...]:
        """The pieces as they are read."""
        pieces = self.pieces
        for edit in self.edits:
            pieces = tuple(piece.replace(edit.scan, edit.read) for piece in pieces)
        return pieces


@dataclass(frozen=True)
class Quotations:
    """The quotes of the claims of one folder of derivations."""

    source: str = ""
    """The name of the paper's file; empty if the folder has no quotes."""
    quotes: Mapping[str, Quote] = field(default_factory=dict)
    """By the number of the claim."""
    unquoted: Mapping[str, Unquoted] = field(default_factory=dict)
    """Why a claim has no quote, by its number."""
    beyond: bool = False
    """Whether all claims of the folder go beyond the papers."""
    tables: Mapping[str, Cells] = field(default_factory=dict)
    """The cells of each table, by row and column; those that are empty are left out."""

    def numbers(self, claim: str) -> tuple[str, ...]:
        """Return the numbers in the quote of a claim, as they are printed."""
        return tuple(_NUMBER.findall(self.quotes[claim].text))

    def decimals(self, claim: str) -> tuple[str, ...]:
        """Return the decimal fractions in the quote of a claim, as they are printed."""
        return tuple(number for number in self.numbers(claim) if "." in number)

    def rows(self, table: str, *columns: str) -> dict[str, tuple[str, ...]]:
        """Return some columns of a table; without the rows in which one of them is empty."""
        return {
            name: tuple(cells[column] for column in columns)
            for name, cells in self.tables[table].items()
            if cells.keys() >= {*columns}
        }

    def cell(self, claim: str) -> str | None:
        """Return the cell of a table that a claim is about, None if it is about none."""
        table, _, place = claim.partition("#")
        row, _, column = place.partition(".")
        return self.tables.get(table, {}).get(row, {}).get(column)

    def why_unquoted(self, claim: Claim) -> Unquoted | None:
        """Return why a claim has no quote; None if that is not stated."""
        return "beyond" if self.beyond or _BEYOND in claim.number else self.unquoted.get(claim.number)


def quotations(folder: Path) -> Quotations:
    """Return the quotes of a folder of derivations; none if it has no files of quotes.

    It raises `DeclarationError` if a file cannot be read, or a claim has two quotes.
    """
    return _read(folder, tuple((path, path.stat().st_mtime_ns) for path in quote_files(folder)))


def quote_files(folder: Path) -> list[Path]:
    """Return the files with the quotes of a folder, in the order of its sections."""
    sections = sorted((folder / SECTIONS).glob("*.toml"), key=lambda path: _natural(path.stem))
    return [path for path in (folder / FILE, *sections) if path.is_file()]


def _natural(section: str) -> list[tuple[int, str]]:
    return [(int(part or 0), rest) for part, rest in re.findall(r"(\d*)(\D*)", section)]


@cache
def _read(folder: Path, stamps: tuple[tuple[Path, int], ...]) -> Quotations:
    settings: dict[str, Any] = {}
    quotes, reasons, tables = list[Quote](), list[tuple[str, Unquoted]](), dict[str, Cells]()
    for path, _ in stamps:
        content = _content(path)
        settings |= content
        quotes += [_quote(entry, path) for entry in content.get("quote", ())]
        for entry in content.get("table", ()):
            rows = [*_rows(entry, path)]
            named = {name: cells for _, name, cells in rows if name}
            tables[entry["name"]] = {**tables.get(entry["name"], {}), **named}
            quotes += _quotes_of(entry, rows)
        reasons += [reason for entry in content.get("unquoted", ()) for reason in _reasons(entry, path)]
    _require_once(
        [*(number for quote in quotes for number in quote.claims), *(number for number, _ in reasons)], folder
    )
    by_number = {number: quote for quote in quotes for number in quote.claims}
    by_number |= {mark.claim: Quote((mark.claim,), mark.line, (mark.words,)) for mark, _ in counted(folder, quotes)}
    return Quotations(
        str(settings.get("source", "")), by_number, dict(reasons), bool(settings.get("beyond", False)), tables
    )


def _content(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise DeclarationError(f"{path}: expected TOML, got {error}") from error


Row = tuple[str, str, dict[str, str]]


def _rows(entry: Mapping[str, Any], path: Path) -> Iterator[Row]:
    """Yield each row of a table: its text, its name for claims, its cells."""
    known = {"name", "line", "columns", "given", "names", "rows"}
    where = f"{path}, table {entry.get('name', '?')}"
    if set(entry) - known or known - {"given", "names"} - set(entry):
        raise DeclarationError(f"{where}: expected keys of {sorted(known)}, got {sorted(entry)}")
    for text in entry["rows"].strip("\n").split("\n"):
        name, *cells = text.split("\t")
        if len(cells) > len(entry["columns"]):
            raise DeclarationError(
                f"{where}: expected {len(entry['columns'])} cells in a row, got {len(cells)}: {text}"
            )
        filled = {column: cell for column, cell in zip(entry["columns"], cells, strict=False) if cell}
        yield text, entry.get("names", {}).get(name, name), filled


def _quotes_of(entry: Mapping[str, Any], rows: Sequence[Row]) -> Iterator[Quote]:
    """Yield a quote for each row of a table that has claims."""
    for line, (text, name, cells) in enumerate(rows, entry["line"]):
        claims = tuple(f"{entry['name']}#{name}.{column}" for column in cells if column not in entry.get("given", ()))
        if name and claims:
            yield Quote(claims, line, (text,))


def counted(folder: Path, quotes: Iterable[Quote]) -> list[tuple[Mark, str]]:
    """Return the references and captions that no quote for a reference contains, with their right numbers."""
    marks = outline(folder)
    referring = [quote for quote in quotes if any("/ref-" in claim for claim in quote.claims)]
    return [
        (mark, place)
        for mark, place in (*references(marks), *captions(marks))
        if not any(quote.line == mark.line and mark.number in quote.text for quote in referring)
    ]


def _quote(entry: Mapping[str, Any], path: Path) -> Quote:
    latex = entry.get("latex")
    pieces = (latex,) if isinstance(latex, str) else tuple(latex or ())
    unparsed = entry.get("unparsed", "")
    known = {"latex", *(part.name for part in fields(Quote) if part.name != "pieces")}
    where = f"{path}, quote of {', '.join(entry.get('claims', ['?']))}"
    if not pieces or not all(isinstance(piece, str) and piece.strip() for piece in pieces):
        raise DeclarationError(f"{where}: expected latex, a text or a list of texts, got {latex!r}")
    if not isinstance(entry.get("line"), int) or not entry.get("claims"):
        raise DeclarationError(f"{where}: expected claims and a line, got {sorted(entry)}")
    if set(entry) - known:
        raise DeclarationError(f"{where}: expected keys of {sorted(known)}, got {sorted(set(entry) - known)}")
    if unparsed and unparsed not in get_args(Unparsed):
        raise DeclarationError(f"{where}: expected unparsed to be one of {get_args(Unparsed)}, got {unparsed!r}")
    if unparsed == "unread" and not entry.get("why"):
        raise DeclarationError(f"{where}: expected also why the formula is not read")
    if (beside := entry.get("beside", "")) not in ("", *get_args(Beside)):
        raise DeclarationError(f"{where}: expected beside to be one of {get_args(Beside)}, got {beside!r}")
    return Quote(
        claims=tuple(entry["claims"]),
        line=entry["line"],
        pieces=pieces,
        sides=tuple(entry.get("sides", (-1,))),
        equation=bool(entry.get("equation", "coefficients" in entry)),
        coefficients=tuple(entry.get("coefficients", ())),
        indices={letter: tuple(map(str, values)) for letter, values in entry.get("indices", {}).items()},
        beside=beside,
        unparsed=unparsed,
        why=str(entry.get("why", "")),
        edits=tuple(_edits(entry.get("edits", ()), pieces, where)),
    )


def _edits(entries: Iterable[Mapping[str, str]], pieces: Sequence[str], where: str) -> Iterator[Edit]:
    for entry in entries:
        if entry.keys() != {"scan", "read", "why"} or not all(isinstance(text, str) for text in entry.values()):
            raise DeclarationError(f"{where}: expected edits with scan, read and why, got {entry!r}")
        if not entry["scan"] or not any(entry["scan"] in piece for piece in pieces):
            raise DeclarationError(f"{where}: expected edits of the quote, got one of {entry['scan']!r}")
        yield Edit(**entry)


def _reasons(entry: Mapping[str, Any], path: Path) -> Iterator[tuple[str, Unquoted]]:
    reason: Any = entry.get("reason")
    if reason not in get_args(Unquoted):
        raise DeclarationError(f"{path}: expected a reason of {get_args(Unquoted)}, got {reason!r}")
    for number in entry.get("claims", ()):
        yield number, reason


def _require_once(numbers: list[str], path: Path) -> None:
    twice = sorted(number for number, count in Counter(numbers).items() if count > 1)
    if twice:
        raise DeclarationError(f"{path}: expected claims that are quoted once, got {twice} twice")
