"""What a record of the ledger states: its forms, what its symbols stand for, and its setting."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property
from typing import Any

from algebroproj_sym.replaying.evaluation import Algebra, at_point, evaluate, substituting
from algebroproj_sym.replaying.field import Element, Field
from algebroproj_sym.replaying.rejection import Rejected
from algebroproj_sym.replaying.text import Form, number, parse, parse_factors, parse_steps

Point = dict[str, Fraction]


class Statement:
    """A record of the ledger, read.

    Parameters
    ----------
    record : mapping
        A claim of the ledger.
    """

    def __init__(self, record: Mapping[str, Any]) -> None:
        self.record = record
        self.kind: str = record["kind"]
        self.setting: Mapping[str, Any] = record.get("setting") or {}
        self._forms: dict[str, Form] = {}

    def has(self, name: str) -> bool:
        """Whether there is a form of the name."""
        return self.record.get(name) is not None

    def text_form(self, name: str) -> Form:
        """Return a form as its text has it."""
        key = f"text of {name}"
        if key not in self._forms:
            read = parse_factors if self.kind == "vanishing" and name != "derived" else parse
            self._forms[key] = read(self.record.get(name))
        return self._forms[key]

    def form(self, name: str) -> Form:
        """Return a form with every division that was made."""
        if name not in self._forms:
            shown = self.text_form(name)
            steps = self._steps(name)
            exact = parse_steps(steps["steps"], steps["entries"], shown.shape) if steps else shown
            if len(exact.entries) != len(shown.entries):
                raise Rejected(f"the steps of the form {name} have not as many entries as its text")
            self._forms[name] = exact
        return self._forms[name]

    def _steps(self, name: str) -> Mapping[str, Any]:
        return (self.record.get("divisions") or {}).get(name) or {}

    @cached_property
    def where(self) -> dict[str, Form]:
        """What symbols of the printed form stand for."""
        steps = self._steps("where")
        return {
            name: parse(text) if name not in steps else parse_steps(steps[name]["steps"], steps[name]["entries"], ())
            for name, text in self.record["where"].items()
        }

    def listed(self, name: str) -> list[Form]:
        """Return the expressions of an entry of the setting."""
        return [parse(text) for text in self.setting.get(name, ())]

    @cached_property
    def symbols(self) -> set[str]:
        """All symbols of the statement, except those that stand for something."""
        names = set[str]()
        for form in ("printed", "corrected"):
            if self.has(form) and self.kind not in ("numeric",):
                names |= self.form(form).symbols()
        shown = names & self.where.keys()
        names |= {symbol for name in shown for symbol in self.where[name].symbols()}
        names -= self.where.keys() - {symbol for name in shown for symbol in self.where[name].symbols()}
        if self.has("derived"):
            names |= self.form("derived").symbols()
        for form_of in (*self.listed("constraints"), *self.listed("nonzero")):
            names |= form_of.symbols()
        names |= set(self.setting.get("variables", ()))
        return names | ({self.setting["variable"]} if "variable" in self.setting else set())

    def field(self, divisors: Any) -> Field:
        """Return the field of rational functions in the symbols, with listed divisors."""
        if not isinstance(divisors, list):
            raise Rejected("the certificate lists no divisors")
        field = Field(self.symbols)
        field.list([self.element(text, field) for text in divisors])
        if field.used:
            raise Rejected("a listed divisor is not a polynomial")
        return field

    def algebra(self, field: Field) -> Algebra:
        """Return the algebra of a field."""
        return Algebra(field.symbol, field.number)

    def element(self, text: Any, field: Field) -> Element:
        """Return the text of a certificate as an element of a field."""
        form = parse(text)
        if form.shape:
            raise Rejected("expected a scalar in the certificate")
        value: Element = evaluate(form, self.algebra(field))[0]
        return value

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
            raise Rejected("something vanishes at the point that must not")

    def require_faithful(self) -> None:
        """Reject a text that is not the form which its steps make."""
        for name in self.record.get("divisions") or {}:
            if name == "where":
                pairs = [
                    (f"value of {key}", parse(self.record["where"][key]), self.where[key]) for key in self._steps(name)
                ]
            else:
                pairs = [(f"form {name}", self.text_form(name), self.form(name))]
            for what, shown, made in pairs:
                field = Field(shown.symbols() | made.symbols())
                made_entries, shown_entries = (evaluate(form, self.algebra(field)) for form in (made, shown))
                if not all((a - b).is_zero for a, b in zip(shown_entries, made_entries, strict=True)):
                    raise Rejected(f"the text of the {what} is not what its steps make")
