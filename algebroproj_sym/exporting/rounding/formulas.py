"""The formula of a derivation beside the lines of C: their exact values are equal, by multiplying out."""

from dataclasses import dataclass

from algebroproj_sym.exporting.gallina import exponent_list, formula, listed, rational, tree
from algebroproj_sym.exporting.rational_functions import Field, expanded
from algebroproj_sym.exporting.reading import formula_of
from algebroproj_sym.exporting.terms import Term, difference, inlined, integer, name, negative, product, quotient, total
from algebroproj_sym.expressions import Expression, entries, written
from algebroproj_sym.generating.lowering import Lowered
from algebroproj_sym.verifying.a_priori import Analysis
from algebroproj_sym.verifying.straight_line import Operation


@dataclass(frozen=True)
class Derived:
    """What the derivation says of the results that have a bound."""

    formulas: tuple[Term, ...]
    """In the arguments."""
    factors: tuple[Term, ...]
    """Polynomials by which the formulas or the lines divide."""
    field: Field
    """How divisors split into these."""
    places: dict[str, int]
    """The arguments in order."""
    quotients: dict[int, Term]
    """The lines that divide."""

    @property
    def splits(self) -> str:
        """How the divisor of each line splits."""
        found = {number: self.field.splits[term] for number, term in self.quotients.items()}
        return listed([f"({n}, ({rational(s.content)}, {exponent_list(s.exponents)}))" for n, s in found.items()])

    @property
    def trees(self) -> str:
        """The formulas for the checker."""
        return listed([tree(term, self.places, self.field.splits) for term in self.formulas])

    @property
    def factor_trees(self) -> str:
        """The factors for the checker."""
        return listed([tree(term, self.places, {}) for term in self.factors])

    @property
    def nonzero(self) -> str:
        """That no factor is zero."""
        return " /\\ ".join(f"{formula(factor)} <> 0" for factor in self.factors) or "True"

    def is_regular(self, point: tuple[int, ...]) -> bool:
        """Whether no factor is zero at integers."""
        return all(divisor(*point) != 0 for divisor in self.field.divisors)


def derived(lowered: Lowered, found: Analysis) -> Derived:
    """Return the formulas of the results that have a bound."""
    line = found.line
    field = Field(line.inputs)
    quotients: dict[int, Term] = {}
    for number, operation in line.operations.items():
        term = _term(operation, line.inputs)
        field.define(_called(number), term)
        if operation[0] == "/":
            quotients[number] = term
    intermediate = {
        str(symbol): _read(entry)
        for stage in lowered.kernel.stages
        for symbol, entry in zip(stage.results, entries(stage.derived), strict=True)
    }
    wanted = zip(entries(lowered.kernel.derived), found.bounds, strict=True)
    formulas = inlined([_read(entry) for entry, bound in wanted if bound is not None], intermediate)
    for term in formulas:
        field.value(term)
    factors = tuple(expanded(divisor, line.inputs) for divisor in field.divisors)
    places = {called: place for place, called in enumerate(line.inputs)}
    return Derived(tuple(formulas), factors, field, places, quotients)


def _read(expression: Expression) -> Term:
    return formula_of(written(expression, fractions=True))


def _called(number: int) -> str:
    return f"line {number}"


def _term(operation: Operation, inputs: tuple[str, ...]) -> Term:
    operator, operands = operation
    if operator == "constant":
        return integer(operands[0])
    if operator == "input":
        return name(inputs[operands[0]])
    left, *others = (name(_called(operand)) for operand in operands)
    match operator:
        case "neg":
            return negative(left)
        case "product_error":
            return difference(product([left, others[0]]), others[1])
        case "/":
            return quotient(left, others[0])
        case "*":
            return product([left, others[0]])
        case _:
            return difference(left, others[0]) if operator == "-" else total([left, others[0]])
