"""What a record of the ledger states, as the exporter reads it."""

from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property
from typing import Any

from algebroproj_sym.exporting.reading import Form, form, formula_of, rational, symbol
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import Definitions, Term, Written, free, names, substituted, written
from algebroproj_sym.exporting.terms import name as term_of_name

Point = dict[str, Fraction]


class Statement:
    """A record of the ledger, read."""

    def __init__(self, record: Mapping[str, Any]) -> None:
        self.record = record
        self.kind: str = record["kind"]
        self.setting: Mapping[str, Any] = record.get("setting") or {}

    def form(self, name: str) -> Form:
        """Return a form with every division that was made."""
        return form(self.record[name])

    @cached_property
    def where(self) -> dict[str, Term]:
        """What symbols of the printed form stand for."""
        return {symbol(name): formula_of(text) for name, text in self.record["where"].items()}

    def listed(self, name: str) -> tuple[Term, ...]:
        """Return the expressions of an entry of the setting."""
        return tuple(formula_of(text) for text in self.setting.get(name, ()))

    @property
    def hypotheses(self) -> tuple[Term, ...]:
        """What must not be zero, as the ledger says."""
        return tuple(formula_of(text) for text in self.record["hypotheses"])

    @cached_property
    def symbols(self) -> frozenset[str]:
        """All symbols of the statement, except those that stand for something."""
        terms = [*self.listed("constraints"), *self.listed("nonzero")]
        for name in ("printed", "corrected"):
            if self.record.get(name) is not None and self.kind != "numeric":
                terms += substituted(self.form(name).entries, self.where)
        if self.record.get("derived") is not None:
            terms += self.form("derived").entries
        variables = [*self.setting.get("variables", ()), *filter(None, [self.setting.get("variable")])]
        return frozenset(names(terms)) | {symbol(variable) for variable in variables}

    def point(self, given: Any) -> Point:
        """Return a point of the certificate."""
        if not isinstance(given, Mapping):
            raise NotExportable("the certificate has no point")
        point = {symbol(name): rational(value) for name, value in given.items()}
        if not point.keys() <= self.symbols:
            raise NotExportable("the point gives a value to what does not occur")
        return point

    def written(self, name: str) -> Written:
        """Return a form with names for what it repeats; in the derived one symbols stand for themselves.

        Examples
        --------
        >>> record = {"kind": "identity", "printed": "D/x", "derived": "y", "where": {"D": "x*y"}, "setting": {}}
        >>> Statement(record).written("printed").definitions.keys()
        dict_keys(['D'])
        """
        taken = self.symbols | self.where.keys()
        entries = self.form(name).entries
        if name == "derived":
            return written(entries, "s", taken)
        standing: dict[str, Term] = {}
        definitions: Definitions = {}
        for called in names(entries):
            if called in self.where:
                own = written([self.where[called]], f"{called}_", taken)
                stands = free(called, self.symbols)
                standing[called] = term_of_name(stands)
                definitions |= {**own.definitions, stands: own.entries[0]}
        found = written(substituted(entries, standing), "t", taken)
        return Written(found.entries, definitions | found.definitions)
