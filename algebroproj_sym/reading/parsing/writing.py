"""A tree becomes text."""

from collections.abc import Callable, Sequence
from typing import Any

from lark import Token

from algebroproj_sym.reading.parsing.evaluating import FUNCTIONS
from algebroproj_sym.reading.parsing.gathering import _Gathering, paired
from algebroproj_sym.reading.parsing.grammar import Formula

Text = tuple[str, int]
_SUM, _PRODUCT, _POWER, _ATOM = range(4)


def text_of(tree: Formula, names: Callable[[str], str]) -> str:
    """Return a tree as text; `names` gives the name of a symbol."""
    return str(_Texts(names).made(tree)[0])


class _Texts(_Gathering):
    """Writes a tree as text; each part with how tightly it binds."""

    def __init__(self, names: Callable[[str], str]) -> None:
        self.names = names

    def sum(self, *parts: Any) -> Text:
        terms = parts if isinstance(parts[0], Token) else (Token("SIGN", "+"), *parts)
        text = "".join(f" {sign} {_in(term, _PRODUCT)}" for sign, term in paired(terms))
        return ("-" if text[1] == "-" else "± "[: 2 * (text[1] == "±")]) + text[3:], _SUM

    def product(self, first: Text, *rest: Any) -> Text:
        signs = {"DOT": "*", "CROSS": " x ", "CIRCLED": " o "}
        text = _in(first, _PRODUCT) + "".join(f"{signs[sign.type]}{_in(part, _PRODUCT)}" for sign, part in paired(rest))
        return text, _PRODUCT

    def quotient(self, *parts: Text) -> Text:
        return "/".join([_in(parts[0], _PRODUCT), *(_in(part, _POWER) for part in parts[1:])]), _PRODUCT

    def run(self, *factors: Text) -> Text:
        return "*".join(_in(factor, _PRODUCT) for factor in factors), _PRODUCT

    chained = run

    def number(self, token: Token) -> Text:
        return str(token), _ATOM

    def symbol(self, token: Token) -> Text:
        return self.names(str(token)), _ATOM

    opaque = symbol

    def shown(self, token: Token) -> Text:
        return f"[{' '.join(token.split())}]", _ATOM

    def call(self, token: Token, arguments: list[Text]) -> Text:
        return f"{self.names(str(token))}({_listed(arguments)})", _ATOM

    def power(self, base: Text, exponent: Text) -> Text:
        return f"{_in(base, _ATOM)}**{_in(exponent, _ATOM)}", _POWER

    def marked(self, base: Text, mark: Token) -> Text:
        if mark.startswith("_"):
            return f"({base[0]}){mark}", _ATOM
        return (f"{_in(base, _ATOM)}.T" if mark == "T" else f"{mark}({base[0]})"), _ATOM

    def operated(self, kind: Token, *parts: Text) -> Text:
        return f"{kind}({_listed([*parts])})", _ATOM

    def factorial(self, base: Text) -> Text:
        return f"factorial({base[0]})", _ATOM

    def fraction(self, above: Text, below: Text) -> Text:
        return self.quotient(above, below)

    def function(self, name: Token, arguments: list[Text]) -> Text:
        return f"{_WRITTEN.get(str(name), str(name))}({_listed(arguments)})", _ATOM

    def raised_function(self, name: Token, exponent: Text, arguments: list[Text]) -> Text:
        if exponent[0] == "-1" and f"arc{name}" in FUNCTIONS:
            return self.function(Token("FUNCTION", f"arc{name}"), arguments)
        return self.power(self.function(name, arguments), exponent)

    def root(self, inside: Text) -> Text:
        return f"sqrt({inside[0]})", _ATOM

    def nth_root(self, degree: Text, inside: Text) -> Text:
        return f"root({inside[0]}, {degree[0]})", _ATOM

    def big(self, name: Token, body: Text) -> Text:
        return f"[{name}]({body[0]})", _ATOM

    def absolute(self, inside: Text) -> Text:
        return f"Abs({inside[0]})", _ATOM

    def norm(self, inside: Text) -> Text:
        return f"norm({inside[0]})", _ATOM

    def inner(self, items: list[Text]) -> Text:
        return f"inner({_listed(items)})", _ATOM

    def bracket(self, items: list[Text]) -> Text:
        return items[0] if len(items) == 1 else (f"[[{_listed(items)}]]", _ATOM)

    def cell(self, value: Text = ("", _ATOM)) -> Text:
        return value

    def row(self, *cells: Text) -> str:
        return f"[{_listed(cells)}]"

    def matrix(self, begin: Token, *rows: str) -> Text:
        return (f"det([{', '.join(rows)}])" if "vmatrix" in begin else f"[{', '.join(rows)}]"), _ATOM

    def case(self, value: Text, condition: Token) -> str:
        return f"({value[0]}, {condition or 'otherwise'})"

    def cases(self, *cases: str) -> Text:
        return f"Piecewise({', '.join(cases)})", _ATOM


_WRITTEN = {"ln": "log", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "sgn": "sign", "arctan2": "atan2"}


def _listed(parts: Sequence[Text]) -> str:
    return ", ".join(part[0] for part in parts)


def _in(part: Text, level: int) -> str:
    return part[0] if part[1] >= level else f"({part[0]})"
