"""What symbols are: how a paper prints them, which claim gives their value, and what functions say of them.

A paper has a page of its symbols, and each of them as a card, which the pages of claims show beside a formula.
"""

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import sympy
from markupsafe import Markup

from algebroproj_sym.declaring import Claim
from algebroproj_sym.declaring.claim import as_stated
from algebroproj_sym.expressions import TextForm, symbols_of
from algebroproj_sym.reading import UnreadableError, symbols_for, tables_in
from algebroproj_sym.reporting.site.addresses import symbol_cards, symbols_page
from algebroproj_sym.reporting.site.catalogue import Catalogue, Entry, Function, Paper
from algebroproj_sym.reporting.site.mathml import math
from algebroproj_sym.reporting.site.templating import page
from algebroproj_sym.showing.names import GREEK, latex_name, plain_name

MOST = 40
_GREEK = "|".join(sorted(GREEK, key=len, reverse=True))
_PRINTED = re.compile(rf"(?<![\\A-Za-z{{])(?:\\(?:{_GREEK})(?![a-z])|[A-Za-z])'*(?:_(?:\{{\w+\}}|\w))?'*(?![A-Za-z'])")
_FIRST_SIDE = re.compile(r"[\s{&]*(.*?)[\s&]*=")


@dataclass
class Symbol:
    """What is known of a symbol."""

    name: str
    """As it is spelled in the derivations."""
    printed: dict[str, Entry] = field(default_factory=dict)
    """How the paper writes it, with the first claim whose quote does so."""
    given: list[Entry] = field(default_factory=list)
    """Claims whose quote begins with it and an equals sign."""
    first: Entry | None = None
    """The first claim with it."""
    functions: dict[str, Function] = field(default_factory=dict)
    """Functions that take it, by what they say of it."""

    @property
    def spoken(self) -> str:
        """The symbol as a screen reader reads it."""
        return plain_name(self.name)

    @property
    def formula(self) -> Markup:
        """The symbol as formulas show it."""
        return math(latex_name(self.name), "inline")

    @property
    def otherwise(self) -> list[Markup]:
        """How the paper prints it where that is another way."""
        shown = dict.fromkeys(math(latex, "inline") for latex in self.printed)
        return [each for each in shown if each != self.formula]


Symbols = dict[tuple[str, str], Symbol]
"""By paper and name."""


def symbols_in(catalogue: Catalogue) -> Symbols:
    """Return what is known of all symbols."""
    found: Symbols = {}

    def known(paper: str, name: str) -> Symbol:
        return found.setdefault((paper, name), Symbol(name))

    for entry in catalogue.entries:
        for name in names_of(entry.claim):
            symbol = known(entry.claim.paper, name)
            symbol.first = symbol.first or entry
        for name, latex, is_given in _printed(entry):
            symbol = known(entry.claim.paper, name)
            symbol.printed.setdefault(latex, entry)
            symbol.given += [entry] if is_given and entry not in symbol.given else []
    for function in catalogue.functions:
        kernel = function.lowered.kernel
        for argument in kernel.arguments:
            for each in argument.read:
                known(kernel.paper, str(each)).functions.setdefault(kernel.describe[argument.name], function)
    return found


def symbol_files(catalogue: Catalogue, paper: Paper, symbols: Symbols) -> dict[str, str]:
    """Return the page of the symbols of a paper, and their cards as a script that a page can load from disk."""
    address = symbols_page(paper.about.key)
    own = [symbol for (key, _), symbol in symbols.items() if key == paper.about.key]
    cards = {
        symbol.name: page("card", address, symbol=symbol).strip()
        for symbol in sorted(own, key=lambda symbol: _in_order(symbol.name))
    }
    script = json.dumps(cards, ensure_ascii=False, indent=0)
    return {
        address: page("symbols", address, catalogue=catalogue, paper=paper, cards=cards),
        symbol_cards(paper.about.key): f"const SYMBOLS = {script};\n",
    }


def _in_order(name: str) -> list[str]:
    """Return what names are sorted by: letters whatever their case, and numbers by their size."""
    return [f"{part:0>6}" if part.isdigit() else part.casefold() for part in re.split(r"(\d+)", name)] + [name]


def names_of(claim: Claim) -> list[str]:
    """Return the names of the symbols in the forms of a claim."""
    forms = (as_stated(claim, part) for part in ("printed", "corrected", "derived"))
    found = {name for form in forms for name in _names(form)}
    return sorted(found)


def _names(form: Any) -> list[str]:
    if isinstance(form, TextForm):
        return form.names
    if isinstance(form, tuple):
        return [name for part in form for name in _names(part)]
    return [symbol.name for symbol in symbols_of([form])] if hasattr(form, "free_symbols") else []


def _printed(entry: Entry) -> Iterator[tuple[str, str, bool]]:
    """Yield the symbols of a quote: name, LaTeX, and whether the quote gives its value."""
    if entry.quote is None or entry.quote.unparsed:
        return
    meaning = symbols_for(entry.claim.section, entry.claim.number, tables_in(entry.derivation.path.parent))
    for text in entry.quote.read:
        side = _FIRST_SIDE.match(text)
        for latex in dict.fromkeys(_PRINTED.findall(text)):
            try:
                value = meaning(latex)
            except UnreadableError:
                continue
            if isinstance(value, sympy.Symbol):
                yield value.name, latex, side is not None and side[1] == latex
