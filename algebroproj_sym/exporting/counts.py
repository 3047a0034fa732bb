"""Counts of independent functions: derivatives that are a regular matrix, and directions along which nothing changes.

The functions are one function F from points to lists of values.  What the theorems say of its derivatives is said with
`derivable_pt_lim`; the proofs name F as a program of trees, which the lemmas differentiate.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from algebroproj_sym.exporting.gallina import conjoined, formula, identifier, listed, rational, tree
from algebroproj_sym.exporting.points import Point
from algebroproj_sym.exporting.terms import Definitions, Term, free, used
from algebroproj_sym.exporting.theorems import CHECKED, Hypotheses, premises, spelled, splitting, with_divisors


@dataclass(frozen=True)
class Functions:
    """Functions of some variables."""

    variables: tuple[str, ...]
    """All symbols that occur."""
    definitions: Mapping[str, Term]
    """Names of formulas."""
    entries: tuple[Term, ...]
    """The functions."""

    def chosen(self, rows: Sequence[int]) -> Functions:
        """Return some of the functions, with the definitions that they use."""
        entries = tuple(self.entries[row] for row in rows)
        return Functions(self.variables, used(self.definitions, entries), entries)

    @property
    def called(self) -> str:
        """What they are called together."""
        return free("F", {*self.variables, *self.definitions})

    @property
    def places(self) -> dict[str, int]:
        """Where variables and definitions stand in the environment."""
        return {called: place for place, called in enumerate((*self.variables, *self.definitions))}

    def stated(self) -> str:
        """Return the lines that introduce them in a statement."""
        x = free("x", {*self.variables, *self.definitions, self.called})
        matched = listed([*map(identifier, self.variables)])
        named = [f"let {identifier(called)} : R := {formula(value)} in" for called, value in self.definitions.items()]
        opened = f"let {self.called} := fun {x} : list R => match {x} with {matched} =>"
        return "\n".join([opened, *named, f"{_formulas(self.entries)} | _ => [] end in"])

    def introduced(self, definitions: str, results: str) -> str:
        """Return the tactics that introduce them, and the proof that they are the program of some trees."""
        left = f"{self.called} (coordinates {len(self.variables)} x)"
        cast = f"(fun x => ltac:(vm_cast_no_check (@eq_refl (list R) ({left}))))"
        program = f"{self.called} {definitions}\n {results} {len(self.variables)}"
        return f"intro {self.called}.\npose proof (is_program {program}\n {cast}) as same."


def _formulas(terms: Sequence[Term]) -> str:
    return listed([formula(term) for term in terms])


def independent_at(functions: Functions, point: Point, places: Sequence[int]) -> tuple[str, str]:
    """Return statement and proof that the derivatives of functions by some variables are a regular matrix at a point.

    There are as many functions as variables by which derivatives are taken; these are given by their places among all.
    """
    values = [point[variable] for variable in functions.variables]
    definitions = listed([tree(value, functions.places, {}) for value in functions.definitions.values()])
    results = listed([tree(entry, functions.places, {}) for entry in functions.entries])
    chosen = listed([*map(str, places)]) + "%nat"
    names = listed([*map(identifier, functions.variables)])
    statement = "\n".join(
        [
            functions.stated(),
            f"exists {spelled(functions.variables)} : R,",
            f"regular_derivatives {functions.called} {names} {chosen}",
        ]
    )
    given = listed([*map(rational, values)])
    proof = [
        functions.introduced(definitions, results),
        f"exists {', '.join(f'(Q2R {rational(value)})' for value in values)}.",
        f"refine (regular_at {given} {definitions}\n {results}\n {chosen}\n {functions.called} _ same).",
        CHECKED,
    ]
    return statement, "\n".join(proof)


def unchanged_along(functions: Functions, directions: Sequence[Sequence[Term]]) -> tuple[str, str]:
    """Return statement and proof that functions have no derivatives along directions, given by their components."""
    given = Hypotheses(functions.variables, (), Definitions(functions.definitions))
    given = with_divisors(given, [*functions.entries, *(part for direction in directions for part in direction)])
    split = splitting(given)
    definitions, results = split.trees([*given.definitions.values()]), split.trees(functions.entries)
    lines, introduced = premises(Hypotheses(given.variables, given.divisors))
    names = listed([*map(identifier, given.variables)])
    said = [f"stationary {functions.called} {names} {_formulas(direction)}" for direction in directions]
    statement = "\n".join([functions.stated(), *lines, " /\\\n".join(said)])
    held = conjoined(introduced.divisors)
    proofs = [
        f"(stationary_by {names} {split.trees(direction)}\n {split.trees(given.divisors)}\n {definitions}\n {results}\n"
        f" {functions.called} _ {held} same)"
        for direction in directions
    ]
    proof = [
        functions.introduced(definitions, results),
        f"intros {' '.join(introduced.order)}.",
        f"refine {conjoined(proofs)}.",
        CHECKED,
    ]
    return statement, "\n".join(proof)
