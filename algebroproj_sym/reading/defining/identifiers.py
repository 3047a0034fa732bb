"""Names of symbols that a Python program could use: one of its own for each symbol."""

import re
from collections.abc import Mapping

from algebroproj_sym.reading.lexing.commands import STYLES
from algebroproj_sym.reading.lexing.names import split_symbol

MOST_LETTERS = 60
"""How many letters the name of a symbol has; what has the same name by then gets a number."""
ZERO = re.compile(r"\\math(?:bf|bb)\{0\}(?:_.*)?|\\mathbf0(?:_.*)?")
"""A vector or a matrix of zeros."""
BOLD = re.compile(r"\\(?:mathbf|mathsf|mathbb|vec|overrightarrow|mathfrak)(?![a-z]{2})")


class Identifiers:
    r"""The names of the symbols of a document, in the order in which they are asked for; some letters have given ones.

    Examples
    --------
    >>> names = Identifiers({})
    >>> [names.name(each) for each in (r"\alpha_1", "a", r"\mathbf{a}", r"\mathrm{a}")]
    ['alpha_1', 'a', 'a_bold', 'a_v2']
    """

    def __init__(self, given: Mapping[str, str]) -> None:
        self._given = given
        self._names: dict[str, str] = {}
        self._taken: dict[str, str] = {}
        self._shown: dict[str, str] = {}

    def name(self, symbol: str) -> str:
        """Return the name of a symbol: one of its own for each, that a Python program could use."""
        if symbol not in self._names:
            wanted = _identifier(symbol, self._given)[:MOST_LETTERS].rstrip("_")
            if wanted in self._taken and BOLD.search(symbol):
                wanted += "_bold"
            name, count = wanted, 1
            while self._taken.setdefault(name, symbol) != symbol:
                count += 1
                name = f"{wanted}_v{count}"
            self._names[symbol] = name
        return self._names[symbol]

    def symbol_of(self, name: str) -> str:
        """Return the symbol that has a name; the name itself if it is that of no symbol alone."""
        return self._taken.get(name, name)

    def show(self, name: str, value: str) -> None:
        """Say what a letter stands for that no document has, such as a sum."""
        self._shown.setdefault(name, value)

    def spelled(self, text: str) -> str:
        """Return a text with the sums and values of functions that are letters in it, as ``cos(x)``."""
        return _VALUE.sub(lambda found: self._spelled(found[0]), text)

    def _spelled(self, name: str) -> str:
        return self.spelled(self._shown[name]) if name in self._shown else name


def is_accented(symbol: str) -> bool:
    r"""Whether a letter has an accent that nothing defines, as in ``\uvec{v}``: it may be that of a vector."""
    match = re.match(r"(\\[a-zA-Z]+)\{", symbol)
    return match is not None and match[1] not in STYLES


_VALUE = re.compile(r"\b(?:whole|free)_\w+")
_ACCENTS = re.compile(r"\\(tilde|bar|hat|dot|ddot|vec|overline|widehat|widetilde|check|breve|underline)(?![a-z])")


_STYLES = re.compile(r"\\math(?:bf|cal|rm|bb|frak|sf|it|tt|scr|ds)")
_OF_SEVERAL = re.compile(r"[ /]|\\,|^(?:\\[a-zA-Z]+){2,}$")
"""What stands between the letters of a name, as in the unit m/s."""


def _identifier(symbol: str, letters: Mapping[str, str]) -> str:
    if _OF_SEVERAL.search(symbol):
        is_slope = re.match(r"(d|\\partial|\\delta).*/\1", symbol)
        text = _STYLES.sub("", symbol if is_slope else symbol.replace("/", "_per_"))
    else:
        letter, primes, below, above = split_symbol(symbol)
        accents = "".join(f"_{each}" for each in _ACCENTS.findall(letter))
        letter = re.sub(r"^\\(?!math)([a-zA-Z]+)\{", r"\1_{", letter) if is_accented(letter) else letter
        plain = letters.get(letter) or _STYLES.sub("", _ACCENTS.sub("", letter)) + accents
        text = plain + (f"_{below}" if below else "") + "p" * primes + (f"_{above}" if above else "")
    text = text.replace(r"\lambda", "lam").replace("*", "star").replace("+", "plus").replace("-", "minus")
    name = re.sub(r"\W+", "_", re.sub(r"[\\{}]", "", text), flags=re.ASCII).strip("_") or "symbol"
    return name if name[0].isalpha() else f"s_{name}"
