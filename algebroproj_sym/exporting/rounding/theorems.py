"""A file for each function: its lines of C, a certificate, and the bounds that the checker accepts."""

import operator
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from importlib.resources import files as resources
from itertools import count
from random import Random
from types import ModuleType
from typing import Any

from algebroproj_sym.exporting.files import ASSUMPTIONS, LIBRARY, assumptions_of, comment
from algebroproj_sym.exporting.gallina import LEMMAS, formula, identifier, listed
from algebroproj_sym.exporting.rounding.formulas import Derived, derived
from algebroproj_sym.generating.backends.c import c_name
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.generating.ranges import DIGITS, reach
from algebroproj_sym.verifying.a_priori import Analysis, Bound, Fact, PairFact, Terms, analysis
from algebroproj_sym.verifying.straight_line import StraightLine, straight_line_of_c

CHECKER = ("Rounding", "Pairs", "Checker", "Ranges", "Machine", "Elimination", "Formulas", "Instances", "Exact")
"""The files that all others require, each after those that it requires itself."""

_OPERATORS = {
    "constant": "Constant",
    "input": "Input",
    "neg": "Neg",
    "+": "Add",
    "join": "Join",
    "-": "Sub",
    "*": "Mul",
    "/": "Div",
    "product_error": "ProductError",
}
_OPTIONAL = {
    "SumOf": (3,),
    "DifferenceOf": (3,),
    "LowOfSum": (2,),
    "ProductWithBoth": (3,),
    "Separated": (3,),
    "QuotientOf": (7, 8),
}
"""Which arguments of a rule may be absent."""

_THEOREM = re.compile(r"^Theorem (\w+)", re.MULTILINE)

_BY_NUMBER = ("LowOfSum", "Separated", "NegativeOf", "RoundedPair", "RoundedSum")
"""The rules that refer to a fact that is not an exact value."""


@dataclass(frozen=True)
class Accuracy:
    """The bounds of a function."""

    lowered: Lowered
    """The kernel and its program."""
    analysis: Analysis
    """What was found of its C source."""

    @property
    def reach(self) -> int | None:
        """The range of arguments, 2^-k to 2^k, in which nothing overflows or underflows; None if none was found."""
        return reach(self.lowered.program)

    @property
    def name(self) -> str:
        """What the C function, the file and the theorem are called."""
        return c_name(self.lowered.kernel)

    @property
    def bounds(self) -> tuple[Bound, ...]:
        """The bounds that were found."""
        return tuple(bound for bound in self.analysis.bounds if bound is not None)


def accuracy_of(lowered: Lowered, package: ModuleType) -> Accuracy:
    """Return the bounds of the C function of a rational kernel."""
    return Accuracy(lowered, analysis(straight_line_of_c(lowered, package)))


def render(accuracies: Iterable[Accuracy]) -> dict[str, str]:
    """Return the text of every file by its name: the checker, and a file for each function that has a bound."""
    texts = {found.name: _file(found) for found in accuracies if found.bounds}
    checker = {f"{name}.v": _source(name) for name in CHECKER}
    return {
        **checker,
        **{f"{name}.v": text for name, text in texts.items()},
        f"{ASSUMPTIONS}.v": assumptions_of({name: _THEOREM.findall(text) for name, text in texts.items()}),
        "_CoqProject": "".join([f"-R . {LIBRARY}\n", *(f"{name}.v\n" for name in (*CHECKER, *texts, ASSUMPTIONS))]),
    }


def _source(name: str) -> str:
    """Return the text of a file of the checker; those of formulas are shared with the theorems about claims."""
    folder = resources("algebroproj_sym.exporting")
    place = folder if f"{name}.v" in LEMMAS else folder / "rounding"
    return place.joinpath(f"{name}.v").read_text(encoding="utf-8")


def _file(found: Accuracy) -> str:
    line = found.analysis.line
    kernel = found.lowered.kernel
    about = f"{kernel.qualified_name}: {len(found.bounds)} of {len(line.outputs)} results have a bound"
    claims = ", ".join(f"{kernel.paper}:{number}" for number in kernel.claims)
    inputs = ", ".join(f"Input {place} is {name}" for place, name in enumerate(line.inputs, start=1))
    results = ", ".join(f"entry {place} is {number}" for place, number in enumerate(line.outputs, start=1))
    return f"""(** {comment(about)}.

    The formula is that of these claims of the ledger: {comment(claims)}.

    {comment(inputs)}.

    Of the results, in row-major order and one after the other, {comment(results)}. *)

From Coq Require Import Reals ZArith NArith QArith PArith List.
From Flocq Require Import IEEE754.BinarySingleNaN.
From {LIBRARY} Require Import Rounding Checker Ranges Machine Instances Exact.
From {LIBRARY} Require Formulas.
Import ListNotations.
Open Scope positive_scope.

{definitions("", found.analysis)}
{_finite(found) if found.reach is None else _in_range(found, found.reach)}"""


def _unlimited(found: Accuracy, lemma: str, given: str = "") -> str:
    """Return the theorem whose hypotheses are about what the lines compute."""
    test = f"{lemma.removesuffix('_sound').removesuffix('_bounds')}{given} lines certificate bounds divisors"
    return f"""{_computed("accepted", test)}
(** Where no intermediate result underflows, and numbers have no largest exponent. *)
Theorem {found.name} :
  forall input, (forall k, is_float (input k)) -> all_regular input lines -> Forall (determined input lines) divisors ->
  Forall (bounded input lines) bounds.
Proof. exact ({lemma}{given} lines certificate bounds divisors accepted). Qed.
"""


def _in_range(found: Accuracy, k: int) -> str:
    """Return that theorem, and one about machine numbers in a range."""
    such = f"that are zero or between 2^-{k} and 2^{k} in absolute value"
    lemma = f"check_range_sound {k} lines certificate bounds divisors accepted"
    closed = _about_machine_numbers(found, k, "in_range", such, {"A": f"Forall (argument {k}) {{given}}"}, lemma)
    return f"{_unlimited(found, 'check_range_bounds', f' {k}')}\n{closed}"


def _finite(found: Accuracy) -> str:
    """Return that theorem, and one about machine numbers from which the lines give finite numbers."""
    such = "for which every line gives a finite number, and no product or quotient underflows"
    hypotheses = {"F": "all_finite {given} lines", "R": "all_regular {real} lines"}
    lemma = "check_finite lines certificate bounds divisors accepted"
    closed = _about_machine_numbers(found, DIGITS, "finite", such, hypotheses, lemma)
    return f"{_unlimited(found, 'check_sound')}\n{closed}"


def _about_machine_numbers(
    found: Accuracy, k: int, name: str, such: str, hypotheses: Mapping[str, str], lemma: str
) -> str:
    """Return what the formulas are, a theorem about machine numbers, and that there are such numbers."""
    names = [identifier(name) for name in found.analysis.line.inputs]
    given, variables = listed(names), " ".join(names)
    known = derived(found.lowered, found.analysis)
    real, applied = f"(numbers (map B2R {given}))", " ".join(f"(B2R {name})" for name in names)
    stated = [text.format(given=given, real=real) for text in hypotheses.values()]
    supposed = "".join(f"  {text} ->\n" for text in stated)
    chosen = instance(found.analysis, min(2**k, 9), known.is_regular)
    integers = f"{listed([*map(str, chosen)])}%Z"
    tests = [
        _computed("example", f"is_instance {k} lines bounds divisors {integers}"),
        _computed("example_nonzero", f"nonzero_at {integers} Trees.factors"),
    ]
    shown = [*hypotheses, f"(nonzero_at_sound {integers} Trees.factors example_nonzero)", "D"]
    steps = f"  destruct (is_instance_sound {k} lines bounds divisors {integers} example) as (A & D & P).\n"
    if "A" not in hypotheses:
        tests.append(_computed("example_runs", f"runs lines {integers}"))
        steps += f"  destruct (runs_sound lines {integers} example_runs) as (F & R).\n"
    and_ = "\n  /\\ "
    return f"""{_formula(found, known)}
(** For all machine numbers {such}. *)
Theorem {found.name}_{name} :
  forall {variables} : binary64,
{supposed}  nonzero {applied} ->
  Forall (determined {real} lines) divisors ->
  Forall2 (accurate {given} lines) bounds (formula {applied}).
Proof.
  intros {variables} {" ".join(hypotheses)} N D.
  exact ({lemma} {given} _ {" ".join(hypotheses)} D
    ({found.name}_formula {applied} N)).
Qed.

{chr(10).join(tests)}
(** There are such numbers. *)
Theorem {found.name}_possible :
  exists {variables} : binary64,
  {and_.join([*stated, f"nonzero {applied}"])}
  /\\ Forall (determined {real} lines) divisors
  /\\ Forall (applies {real} lines) bounds.
Proof.
  exists {", ".join(f"(machine_integer ({value}))" for value in chosen)}.
{steps}  exact ({" (".join(f"conj {proof}" for proof in shown)} P{")" * len(shown)}.
Qed.
"""


def _computed(name: str, test: str) -> str:
    """Return a lemma that a test succeeds."""
    return f"Lemma {name} : {test} = true.\nProof. vm_cast_no_check (eq_refl true). Qed.\n"


def _formula(found: Accuracy, known: Derived) -> str:
    """Return the formulas of the derivation, and the theorem that they are the exact values of the lines."""
    names = [identifier(name) for name in found.analysis.line.inputs]
    given, variables = listed(names), " ".join(names)
    return f"""(** What the derivation says. *)
Definition formula ({variables} : R) : list R :=
  ({listed([*map(formula, known.formulas)])})%R.

Definition nonzero ({variables} : R) : Prop :=
  ({known.nonzero})%R.

Definition splits : Exact.splits :=
  {known.splits}.

Module Trees.
Import Formulas.

Definition factors : list expr :=
  ({known.factor_trees})%nat.

Definition formulas : list expr :=
  ({known.trees})%nat.
End Trees.

{_computed("equal", f"is_formula {len(names)} lines splits Trees.factors (map fst bounds) Trees.formulas")}
Theorem {found.name}_formula :
  forall {variables} : R, nonzero {variables} ->
  map (exact (numbers {given}) lines) (map fst bounds) = formula {variables}.
Proof.
  intros {variables}.
  exact (is_formula_sound {given} lines splits Trees.factors (map fst bounds) Trees.formulas equal).
Qed.

"""


def definitions(suffix: str, found: Analysis) -> str:
    """Return the definitions of lines, certificate, bounds and divisors, whose names end in some suffix."""
    lines = [f"({number}, {_operation(*operation)})" for number, operation in found.line.operations.items()]
    return "\n".join(
        [
            _listed(f"lines{suffix} : program", lines),
            _listed(f"certificate{suffix} : list command", _commands(found.certificate)),
            _listed(f"bounds{suffix} : list bound", [*map(_bound, filter(None, found.bounds))]),
            _listed(f"divisors{suffix} : list bound", [*map(_bound, filter(None, found.divisors))]),
        ]
    )


def _listed(name: str, items: Sequence[str]) -> str:
    joined = ";\n   ".join(items)
    return f"Definition {name} :=\n  [{joined}].\n"


def _operation(operator: str, operands: Sequence[int]) -> str:
    if operator == "constant":
        return f"Constant ({operands[0]})%Z"
    places = [operand + 1 for operand in operands] if operator == "input" else operands
    return " ".join([_OPERATORS[operator], *map(str, places)])


def _terms(terms: Terms) -> str:
    return f"[{'; '.join(f'({place}, {coefficient}%N)' for place, coefficient in terms)}]"


def _bound(bound: Bound) -> str:
    return f"({bound.result}, ({bound.roundings}%N, {_terms(bound.terms)}))"


def _commands(certificate: Sequence[Fact]) -> list[str]:
    numbers: dict[Fact, int] = {}
    fresh = count(1)
    commands = []
    for fact in certificate:
        given = [_argument(fact.rule, place, argument, numbers) for place, argument in enumerate(fact.arguments)]
        if isinstance(fact, PairFact):
            numbers[fact] = next(fresh)
            given.insert(0, str(numbers[fact]))
        commands.append(" ".join([fact.rule, *given]))
    return commands


def _argument(rule: str, place: int, argument: Any, numbers: Mapping[Fact, int]) -> str:
    if place in _OPTIONAL.get(rule, ()):
        return "None" if argument is None else f"(Some {argument})"
    if isinstance(argument, PairFact):
        if rule in _BY_NUMBER:
            return str(numbers[argument])
        return f"(Known {numbers[argument]})" if argument.rule else f"(Exactly {argument.first})"
    if rule == "Mean" and place == 1:
        return f"{argument}%N"
    return _terms(argument) if isinstance(argument, tuple) else str(argument)


_TRIES = 10_000
"""How many integers are tried."""

_MEANING: Mapping[str, Callable[..., Any]] = {
    "+": operator.add,
    "join": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "neg": operator.neg,
    "product_error": lambda a, b, product: a * b - product,
}


def instance(found: Analysis, most: int, is_regular: Callable[[tuple[int, ...]], bool]) -> tuple[int, ...]:
    """Return integers of bounded size for which no divisor is zero, and no sum whose condition number a bound mentions.

    They are regular in the sense of the caller.  It raises `ValueError` if none is found: then the hypotheses may
    contradict each other.

    Examples
    --------
    >>> from algebroproj_sym.generating.program import recorded
    >>> from algebroproj_sym.verifying.a_priori import analysis
    >>> from algebroproj_sym.verifying.straight_line import numbered
    >>> x, y = instance(analysis(numbered(recorded("xy", lambda x, y: (1 / (x - y),)))), 2, lambda point: True)
    >>> x == y, max(abs(x), abs(y)) <= 2
    (False, True)
    """
    required = [place for bound in (*found.bounds, *found.divisors) if bound is not None for place, _ in bound.terms]
    required += [bound.result for bound in found.divisors if bound is not None]
    for seed in range(_TRIES):
        generator = Random(seed)
        chosen = tuple(generator.choice((-1, 1)) * generator.randint(1, most) for _ in found.line.inputs)
        try:
            values = _values(found.line, chosen)
        except ZeroDivisionError:
            continue
        if all(values[place] for place in required) and is_regular(chosen):
            return chosen
    raise ValueError(f"expected integers up to {most} for which no divisor is zero, found none in {_TRIES} tries")


def _values(line: StraightLine, chosen: Sequence[int]) -> dict[int, Fraction]:
    values: dict[int, Fraction] = {}
    for number, (operation, operands) in line.operations.items():
        if operation == "constant":
            values[number] = Fraction(operands[0])
        elif operation == "input":
            values[number] = Fraction(chosen[operands[0]])
        else:
            values[number] = _MEANING[operation](*(values[operand] for operand in operands))
    return values
