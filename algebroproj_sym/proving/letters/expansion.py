"""Statements of fixed size, entry by entry, in the coordinates of their letters."""

from functools import cached_property
from typing import Any

import sympy

from algebroproj_sym.expressions import over
from algebroproj_sym.expressions.letters import LetterError, Term, factors_of, letters_text
from algebroproj_sym.proving.letters.entries import Field, Rows, entries_of
from algebroproj_sym.proving.letters.properties import Coordinates, coordinates
from algebroproj_sym.proving.letters.statements import Statement

_EXPRESSIONS = Field(lambda value: sympy.Rational(value.numerator, value.denominator), over)


class Expansion:
    """A statement of fixed size in the coordinates of its letters."""

    def __init__(self, statement: Statement) -> None:
        self.statement = statement
        self.letters: dict[str, Coordinates] = {
            k: coordinates(letter) for k, letter in sorted(statement.letters.items())
        }
        numbers = {part.value for term in statement.terms for part in factors_of(term) if part.kind == "symbol"}
        names = [*numbers, *(name for each in self.letters.values() for name in each.names)]
        for name in names:
            if names.count(name) > 1 or name in self.letters:
                raise LetterError(f"expected other names: {name} is also that of a coordinate of a letter")
        self.signs = [name for each in self.letters.values() for name in each.signs]
        self.is_constrained = bool(statement.constraints) or any(each.equations for each in self.letters.values())
        free = {*names} - (set() if self.is_constrained else {*self.signs})
        self.symbols = tuple(sympy.Symbol(name) for name in sorted(free))

    def texts(self) -> dict[str, str]:
        """Return the entries of the letters as text."""
        return {name: letters_text(each.entries) for name, each in self.letters.items()}

    @cached_property
    def rows(self) -> dict[str, Rows]:
        """The entries of the letters as expressions."""
        return {name: entries_of(each.entries, {}, self.values, _EXPRESSIONS) for name, each in self.letters.items()}

    @cached_property
    def values(self) -> dict[str, sympy.Symbol]:
        """The coordinates as symbols."""
        return {symbol.name: symbol for symbol in self.symbols}

    def matrix(self, term: Term) -> Any:
        """Return a term as a matrix of expressions."""
        return sympy.ImmutableDenseMatrix(entries_of(term, self.rows, self.values, _EXPRESSIONS))

    @cached_property
    def equations(self) -> list[Any]:
        """What is zero, entry by entry, each once; empty if coordinates say it all."""
        if not self.is_constrained:
            return []
        terms = [*self.statement.constraints, *(term for each in self.letters.values() for term in each.equations)]
        found = [entry for term in terms for entry in self.matrix(term).flat()]
        found += [self.values[name] ** 2 - 1 for name in self.signs]
        return [*dict.fromkeys(sympy.expand(entry) for entry in found if entry != 0)]
