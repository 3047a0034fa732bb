"""Theorems: each has a readable statement, and a proof that names its trees and certificates."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeAlias

from algebroproj_sym.exporting.gallina import conjoined, exponent_list, formula, identifier, listed, tree
from algebroproj_sym.exporting.rational_functions import Field
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import Definitions, Term, free, integer, product, quotient, used, written

CHECKED = "all: vm_cast_no_check (@eq_refl bool true)."


@dataclass(frozen=True)
class Theorem:
    """A theorem: its name, what it says, and the tactics that prove it."""

    name: str
    statement: str
    proof: str

    @property
    def _sides(self) -> list[tuple[str, str]]:
        found = re.findall(r"^([^\n]+) = ([^\n]+?)(?: /\\)?$", self.statement, re.MULTILINE)
        return [(left, right) for left, right in found if not right.endswith("->")]

    @property
    def equations(self) -> int:
        """How many equations it states; one between matrices counts as often as there are entries."""
        _, equal, right = self.statement.rpartition(" =\n")
        return right.count(";") + 1 if equal else len(self._sides)

    @property
    def trivial(self) -> int:
        """How many of these read a = a."""
        return sum(left == right for left, right in self._sides)


@dataclass(frozen=True)
class Goal:
    """An equation, and why it holds: its difference is, up to a power and divisors, a combination of constraints."""

    left: Term
    right: Term
    """The sides."""
    power: int = 1
    """To which power the difference is raised."""
    multiplier: tuple[int, ...] = ()
    """By which powers of the divisors it is multiplied."""
    cofactors: tuple[Term, ...] = ()
    """The factors of the constraints."""


@dataclass(frozen=True)
class Hypotheses:
    """What a theorem assumes."""

    variables: tuple[str, ...]
    """Free variables."""
    divisors: tuple[Term, ...] = ()
    """Polynomials in them that are not zero."""
    definitions: Mapping[str, Term] = field(default_factory=dict)
    """Names of formulas."""
    units: tuple[Term, ...] = ()
    """Other formulas that are not zero."""
    constraints: tuple[Term, ...] = ()
    """Formulas that are zero."""


@dataclass(frozen=True)
class Splitting:
    """Where names stand in the environment, and the field that tells how divisors split.

    Terms that are `closed` are of numbers alone, which need no splitting.
    """

    places: Mapping[str, int]
    field: Field
    closed: bool

    def tree(self, term: Term) -> str:
        """Return a term as a tree, after its divisors were split; each must be listed."""
        if self.closed:
            return tree(term, self.places, {})
        self.field.value(term)
        if len(self.field.divisors) > len(self.field.listed):
            raise NotExportable("a division meets a factor that is not a hypothesis")
        return tree(term, self.places, self.field.splits)

    def trees(self, terms: Sequence[Term]) -> str:
        """Return a list of trees."""
        return listed([self.tree(term) for term in terms])


def splitting(given: Hypotheses, shared: Definitions | None = None) -> Splitting:
    """Return how divisors split under hypotheses, and of more terms that a proof shares."""
    definitions = {**given.definitions, **(shared or {})}
    places = {called: place for place, called in enumerate((*given.variables, *definitions))}
    closed = not given.variables and not given.definitions
    return Splitting(places, _field(given if closed else replace(given, definitions=definitions)), closed)


def _field(given: Hypotheses) -> Field:
    field = Field(given.variables, given.divisors)
    for called, value in given.definitions.items():
        field.define(called, value)
    return field


def with_divisors(given: Hypotheses, terms: Sequence[Term]) -> Hypotheses:
    """Return the hypotheses, and that nothing else vanishes that terms divide by."""
    field = _field(replace(given, definitions=used(given.definitions, terms)))
    for term in terms:
        field.value(term)
    return replace(given, divisors=(*given.divisors, *field.met()))


def needed(given: Hypotheses, goals: Sequence[Goal]) -> Hypotheses:
    """Return the hypotheses without definitions that nothing needs."""
    terms = [term for goal in goals for term in (goal.left, goal.right, *goal.cofactors)]
    return replace(given, definitions=used(given.definitions, [*terms, *given.units, *given.constraints]))


@dataclass(frozen=True)
class Introduced:
    """The names of the hypotheses in a proof."""

    order: tuple[str, ...]
    divisors: tuple[str, ...]
    definitions: tuple[str, ...]
    units: tuple[str, ...]
    constraints: tuple[str, ...]


Using: TypeAlias = Callable[[Introduced, str], str]


def universal(
    given: Hypotheses, goals: Sequence[Goal], conclusion: str = "", using: Using = lambda introduced, proof: proof
) -> tuple[str, str]:
    """Return statement and proof of the theorem that equations follow from hypotheses.

    If another `conclusion` than the conjunction of the equations is stated, `using` makes its proof of the names of the
    hypotheses and the proof of the conjunction.
    """
    given = needed(given, goals)
    stated, introduced = premises(given)
    conclusion = conclusion or equations(goals)
    proof = using(introduced, consequence(given, goals, introduced))
    statement = "\n".join([*stated, conclusion])
    return statement, f"intros {' '.join(introduced.order)}.\nrefine ({proof}).\n{CHECKED}"


def matrix_of(rows: Sequence[Sequence[Term]]) -> str:
    """Return a matrix of formulas."""
    return listed([listed([formula(entry) for entry in row]) for row in rows])


def universal_of_matrix(
    given: Hypotheses,
    rows: Sequence[Sequence[Goal]],
    left: str = "",
    *,
    scalar: bool = False,
    pattern: Sequence[Sequence[Term]] = (),
    marks: Mapping[str, Term] | None = None,
    first: str = "",
    required: Sequence[Term] = (),
    lemma: str = "",
    sides: int = 0,
) -> tuple[str, str]:
    """Return statement and proof that matrices are equal, by the equations between their entries.

    The left side may be another text `left`, of which Coq computes the left sides of the equations.  The tactic `first`
    makes of it what Coq shall compute, and `required` must not be zero for the lemmas that it uses.  Another `lemma` is
    used after it, which assumes as many of the first of these as it has `sides`.  The right side may be a `pattern`, in
    which names occur: `marks` are values for which it holds.  Of a `scalar` the only entry is meant.
    """
    goals = [goal for row in rows for goal in row]
    named = [*(marks or {}).values()]
    given = needed(given, [*goals, *(Goal(value, value) for value in named)])
    stated, introduced = premises(given)
    right = pattern or [[goal.right for goal in row] for row in rows]
    shown = formula(right[0][0]) if scalar else matrix_of(right)
    left = left or matrix_of([[goal.left for goal in row] for row in rows])
    chosen = f"exists {spelled([*(marks or {})])} : R,\n" if marks else ""
    statement = "\n".join([*stated, f"{chosen}{left} =\n{shown}"])
    shared, rows = _sharing(given, rows)
    split = splitting(given, shared)
    listed_rows = listed([listed([_goal(goal, split) for goal in row], ";\n  ") for row in rows], ";\n ")
    variables, definitions = (listed([identifier(n) for n in part]) for part in (given.variables, given.definitions))
    environment = f"(run ({variables} ++ {definitions}) shared)"
    tactics = [f"intros {' '.join(introduced.order)}."] if introduced.order else []
    tactics += [f"exists {', '.join(f'({formula(value)})' for value in named)}."] if named else []
    tactics += [
        f"pose (shared := {split.trees([*shared.values()])} : list expr).",
        f"pose (rows := {listed_rows}).",
        f"assert (all (map (concludes {environment}) (concat rows))) as same.",
        f"{{ refine ({_following(given, split, 'concat rows', introduced, 'shared')}).\n{CHECKED} }}",
        *_nonzero(given, split, required, introduced),
        *filter(None, [first]),
        *([f"rewrite {lemma}; [|{'|'.join(f'vm_cast_no_check side_{k}' for k in range(sides))}]."] if lemma else []),
        "vm_cast_no_check same." if scalar else f"vm_cast_no_check (same_matrix {environment} rows same).",
    ]
    return statement, "\n".join(tactics)


def _sharing(given: Hypotheses, rows: Sequence[Sequence[Goal]]) -> tuple[Definitions, list[list[Goal]]]:
    """Return names for what occurs more than once in equations, and the equations in their terms."""
    found = written(
        [side for row in rows for goal in row for side in (goal.left, goal.right)],
        "shared",
        {*given.variables, *given.definitions},
    )
    sides = iter(found.entries)
    return found.definitions, [[replace(goal, left=next(sides), right=next(sides)) for goal in row] for row in rows]


def _nonzero(given: Hypotheses, split: Splitting, terms: Sequence[Term], introduced: Introduced) -> list[str]:
    """Return the tactics that show of formulas that they are not zero where the hypotheses hold."""
    found = []
    for place, term in enumerate(terms):
        proof = f"calculated [] [Nonzero ({split.tree(term)})] _"
        if not split.closed:
            goal = Goal(product([quotient(integer(1), term), term]), integer(1))
            proof = f"nonzero_by _ ({_following(given, split, listed([_goal(goal, split)]), introduced)})"
        found.append(f"assert ({formula(term)} <> 0) as side_{place}.\n{{ refine ({proof}).\n{CHECKED} }}")
    return found


def premises(given: Hypotheses) -> tuple[list[str], Introduced]:
    """Return the lines that quantify and assume, and the names that a proof introduces."""
    taken = {*given.variables, *given.definitions}

    def called(prefix: str, count: int) -> tuple[str, ...]:
        return tuple(free(f"{prefix}_{place}", taken) for place in range(count))

    divisors, units = called("nonzero", len(given.divisors)), called("unit", len(given.units))
    constraints = called("zero", len(given.constraints))
    lines = [f"forall {spelled(given.variables)} : R,"] if given.variables else []
    lines += [f"{formula(divisor)} <> 0 ->" for divisor in given.divisors]
    defined, definitions = premises_of_definitions(given.definitions, taken)
    lines += defined
    lines += [f"{formula(unit)} <> 0 ->" for unit in given.units]
    lines += [f"{formula(constraint)} = 0 ->" for constraint in given.constraints]
    pairs = [text for pair in zip(map(identifier, given.definitions), definitions, strict=True) for text in pair]
    order = (*map(identifier, given.variables), *divisors, *pairs, *units, *constraints)
    return lines, Introduced(order, divisors, definitions, units, constraints)


def premises_of_definitions(definitions: Mapping[str, Term], taken: set[str]) -> tuple[list[str], tuple[str, ...]]:
    """Return the lines that give names to formulas, and what a proof calls these equations."""
    lines = [f"forall {identifier(n)} : R, {identifier(n)} = {formula(value)} ->" for n, value in definitions.items()]
    return lines, tuple(free(f"is_{place}", taken) for place in range(len(definitions)))


def consequence(given: Hypotheses, goals: Sequence[Goal], introduced: Introduced) -> str:
    """Return the application of the lemma that goals follow."""
    split = splitting(given)
    return _following(given, split, listed([_goal(goal, split) for goal in goals], ";\n  "), introduced)


def _following(
    given: Hypotheses, split: Splitting, certificates: str, introduced: Introduced, shared: str = "[]"
) -> str:
    if split.closed:
        return f"calculated {shared} (map equal ({certificates})) _"
    variables, definitions = (listed([identifier(n) for n in part]) for part in (given.variables, given.definitions))
    return (
        f"follows {variables} {definitions}\n {split.trees(given.divisors)}\n"
        f" {split.trees([*given.definitions.values()])}\n"
        f" {split.trees(given.units)}\n {split.trees(given.constraints)}\n"
        f" {shared} ({certificates})\n _ {conjoined(introduced.divisors)} {conjoined(introduced.definitions)}"
        f" {conjoined(introduced.units)} {conjoined(introduced.constraints)}"
    )


def _goal(goal: Goal, split: Splitting) -> str:
    sides = f"({split.tree(goal.left)}) ({split.tree(goal.right)})"
    return f"Equation {sides} {goal.power} {exponent_list(goal.multiplier)} {split.trees(goal.cofactors)}"


def equations(goals: Sequence[Goal]) -> str:
    """Return the conjunction of the equations."""
    return " /\\\n".join(f"{formula(goal.left)} = {formula(goal.right)}" for goal in goals)


def spelled(variables: Sequence[str]) -> str:
    """Return variables side by side."""
    return " ".join(map(identifier, variables))
