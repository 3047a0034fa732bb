"""Where each page is: file names that depend on paper and number alone, so that a citation stays valid."""

from posixpath import dirname, relpath

START = "index.html"
SEARCH = "search.html"
FUNCTIONS = "functions/index.html"
LEDGER = "ledger.json"
PROVER = "prover.html"
LIVE_SCRIPT = "live/live.js"

_PLAIN = frozenset("abcdefghijklmnopqrstuvwxyz0123456789.-")
_NAMED = {"/": "_", "#": "~", "'": "=", ":": ","}


def slug(number: str) -> str:
    """Return a number as part of a file name: no two numbers share one, not even where case does not count.

    Capital letters follow a plus sign, and so do the codes of what no file name should contain.

    Examples
    --------
    >>> slug("2.2.6"), slug("1.3.5#mu3"), slug("2.1/u0'C"), slug("table:2.2"), slug("1.3/P*")
    ('2.2.6', '1.3.5~mu3', '2.1_u0=+c', 'table,2.2', '1.3_+p+2a')
    """
    return "".join(map(_escaped, number))


def _escaped(character: str) -> str:
    if character in _PLAIN:
        return character
    if character in _NAMED:
        return _NAMED[character]
    if "A" <= character <= "Z":
        return f"+{character.lower()}"
    code = ord(character)
    return f"+{code:02x}" if code < 0x80 else f"+8{code:06x}"


def paper_page(paper: str) -> str:
    """Return the address of the page of a paper."""
    return f"{paper}/index.html"


def errata_page(paper: str) -> str:
    """Return the address of the errata of a paper."""
    return f"{paper}/errata.html"


def graph_page(paper: str, section: str | None = None) -> str:
    """Return the address of the graph of what rests on what, in a section or of the sections of a paper."""
    return f"{paper}/graph.html" if section is None else f"{paper}/graph-{slug(section)}.html"


def claim_page(paper: str, number: str) -> str:
    """Return the address of the page of a claim."""
    return f"{paper}/{slug(number)}.html"


def symbols_page(paper: str) -> str:
    """Return the address of the page of the symbols of a paper."""
    return f"{paper}/symbols.html"


def symbol_cards(paper: str) -> str:
    """Return the address of the cards of the symbols of a paper, as a script."""
    return f"{paper}/cards.js"


def function_page(qualified_name: str) -> str:
    """Return the address of the page of a generated function."""
    return f"functions/{qualified_name}.html"


def notebook_page(module: str) -> str:
    """Return the address of the notebook of a derivation module."""
    return f"notebooks/{module}.html"


def relative(address: str, page: str) -> str:
    """Return an address as seen from a page.

    Examples
    --------
    >>> relative("functions/index.html", "fundamentals/2.2.6.html")
    '../functions/index.html'
    """
    path, hash_sign, anchor = address.partition("#")
    return f"{relpath(path, dirname(page) or '.')}{hash_sign}{anchor}"
