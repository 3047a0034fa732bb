"""The index of the search: numbers, titles and symbols, as a script that a page can load from disk."""

import json
import re
from collections.abc import Iterable

from algebroproj_sym.reporting.site.addresses import paper_page
from algebroproj_sym.reporting.site.catalogue import Catalogue
from algebroproj_sym.reporting.site.symbols import Symbols, names_of
from algebroproj_sym.showing.names import plain_name

MOST_SYMBOLS = 60


def search_index(catalogue: Catalogue, symbols: Symbols) -> list[list[str]]:
    """Return an entry for each claim, function and paper: address, where, number or name, title, verdict, symbols."""
    claims = [
        [
            entry.page,
            entry.claim.paper,
            entry.claim.number,
            entry.claim.title,
            entry.judgement.verdict,
            _spelled(entry.claim.paper, names_of(entry.claim), symbols),
        ]
        for entry in catalogue.entries
    ]
    kernels = [(function.page, function.lowered.kernel) for function in catalogue.functions]
    functions = [
        [
            page,
            "function",
            kernel.qualified_name,
            kernel.summary,
            "",
            _spelled(kernel.paper, map(str, kernel.read), symbols),
        ]
        for page, kernel in kernels
    ]
    papers = [
        [
            paper_page(paper.about.key),
            "paper",
            paper.about.key,
            f"{paper.about.title} {paper.about.origin}",
            "",
            "errata",
        ]
        for paper in catalogue.papers
    ]
    return claims + functions + papers


def search_script(catalogue: Catalogue, symbols: Symbols) -> str:
    """Return the index as JavaScript; what could end the script element or a line is escaped."""
    index = search_index(catalogue, symbols)
    lines = [json.dumps(entry, ensure_ascii=True).replace("<", "\\u003c") for entry in index]
    return "const SEARCH_INDEX = [\n" + ",\n".join(lines) + "\n];\n"


def _spelled(paper: str, names: Iterable[str], symbols: Symbols) -> str:
    """Return symbols as they are spelled in the derivations, as text, and as the paper prints them."""
    spellings = [
        spelling
        for name in sorted({*names})[:MOST_SYMBOLS]
        for spelling in (name, plain_name(name), *map(_typed, symbols[paper, name].printed))
    ]
    return " ".join(dict.fromkeys(spellings))


def _typed(latex: str) -> str:
    r"""Return a printed symbol as it is typed, without primes behind an index.

    Examples
    --------
    >>> _typed(r"\zeta_{22}"), _typed("u_{31}''"), _typed("u''_{31}")
    ('zeta22', "u''31", "u''31")
    """
    primes = "'" * latex.count("'")
    letter, _, index = re.sub(r"[\\{}']", "", latex).partition("_")
    return f"{letter}{primes}{index}"
