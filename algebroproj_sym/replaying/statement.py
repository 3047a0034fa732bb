"""What a record of the ledger states: its forms, what its symbols stand for, and its setting."""

from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property
from typing import Any

from algebroproj_sym.replaying.evaluation import Algebra, at_point, evaluate, substituting
from algebroproj_sym.replaying.rejection import Rejected, require
from algebroproj_sym.replaying.text import Form, is_name, number, parse, parse_factors, texts

Point = dict[str, Fraction]


class Statement:
    """A record of the ledger, read."""

    def __init__(self, record: Mapping[str, Any]) -> None:
        self.record = record
        self.kind: str = record["kind"]
        self.setting: Mapping[str, Any] = record["setting"]
        self._forms: dict[str, Form] = {}

    def require_meanings(self) -> None:
        """Reject symbols that stand for something and do not occur, or that occur where they stand for themselves.

        A variable must be a name.
        """
        shown = {s for name in ("printed", "corrected") if self.has(name) for s in self._named(name)}
        others = self._named("derived") | {
            s for key in ("constraints", "nonzero") for f in self.listed(key) for s in f.symbols()
        }
        require(self.where.keys() <= shown, "a symbol is explained that does not occur")
        require(
            not self.where.keys() & others, "a symbol stands for an expression in one place and for itself in another"
        )
        require(all(map(is_name, self.variables)), "a variable is not the name of a number")
        require(len({*self.variables}) == len(self.variables), "a variable is listed twice")

    def _named(self, name: str) -> set[str]:
        return self.form(name).symbols() if self.has(name) and self.kind != "numeric" else set()

    def has(self, name: str) -> bool:
        """Whether there is a form of the name."""
        return self.record.get(name) is not None

    def form(self, name: str) -> Form:
        """Return a form."""
        if name not in self._forms:
            read = parse_factors if self.kind == "vanishing" and name != "derived" else parse
            self._forms[name] = read(self.record.get(name))
        return self._forms[name]

    @cached_property
    def where(self) -> dict[str, Form]:
        """What symbols of the printed form stand for."""
        return {name: _scalar(text) for name, text in self.record["where"].items()}

    def listed(self, name: str) -> list[Form]:
        """Return the expressions of an entry of the setting."""
        return [_scalar(text) for text in texts(self.setting.get(name, []))]

    @cached_property
    def symbols(self) -> set[str]:
        """All symbols of the statement, except those that stand for something."""
        names = set[str]()
        for form in ("printed", "corrected"):
            if self.has(form) and self.kind not in ("numeric",):
                names |= self.form(form).symbols()
        shown = names & self.where.keys()
        meant = {symbol for name in shown for symbol in self.where[name].symbols()}
        names = (names - self.where.keys()) | meant
        if self.has("derived"):
            names |= self.form("derived").symbols()
        for form_of in (*self.listed("constraints"), *self.listed("nonzero")):
            names |= form_of.symbols()
        return names | {*self.variables}

    @property
    def variables(self) -> list[str]:
        """The variables of a limit, or of a count."""
        single = [self.setting["variable"]] if "variable" in self.setting else []
        return texts(self.setting.get("variables", single))

    def side(self, name: str, algebra: Algebra) -> list[Any]:
        """Return the entries of a form in some field; in printed and corrected ones symbols are replaced."""
        meaning = algebra if name == "derived" else substituting(algebra, self.where)
        return evaluate(self.form(name), meaning)

    def point(self, given: Any) -> Point:
        """Return a point of the certificate; it may give values to symbols of the statement alone."""
        if not isinstance(given, Mapping):
            raise Rejected("the certificate has no point")
        point = {name: number(value) for name, value in given.items()}
        strange = sorted(point.keys() - self.symbols)
        if strange:
            raise Rejected(f"the point gives a value to {', '.join(strange)}, which does not occur")
        return point

    def require_allowed(self, point: Point) -> None:
        """Reject a point that violates a constraint or a hypothesis."""
        algebra = at_point(point)
        if any(evaluate(form, algebra)[0] != 0 for form in self.listed("constraints")):
            raise Rejected("the point violates a constraint")
        if any(evaluate(form, algebra)[0] == 0 for form in self.listed("nonzero")):
            raise Rejected("a form that must not be zero is zero at the point")


def _scalar(text: Any) -> Form:
    form = parse(text)
    require(not form.shape, "expected a scalar")
    return form
