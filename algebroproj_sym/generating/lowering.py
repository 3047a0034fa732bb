"""Lowering: from the expression of a kernel to a straight-line program, proved equal to the derivation.

Where the derivation divides by a factor by which the program does not, the program is given a guard: it adds
0/factor, which is exactly zero, and not a number where the factor vanishes.  A singular input then never passes
for a regular one.  Where the program divides by a sum of squares, which overflows long before the quotient does, it
adds 0*sum, which is not a number where the sum has overflowed: the quotient would be zero there.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce
from typing import Any

import sympy

from algebroproj_sym.declaring import Kernel, Result, Stage
from algebroproj_sym.expressions import Scalar, determinant, divided, entries, evaluate, vector
from algebroproj_sym.generating.compensation import compensated
from algebroproj_sym.generating.graph import Graph, Signed
from algebroproj_sym.generating.program import (
    Call,
    Operand,
    Program,
    Recorder,
    Step,
    fresh_names,
    operand_of,
    run,
    with_names,
)
from algebroproj_sym.generating.sharing import share_pairs, share_reciprocals
from algebroproj_sym.proving import RationalFunctionField


class LoweringError(ValueError):
    """A kernel's form is not equal to what its derivation computes."""


@dataclass(frozen=True)
class Lowered:
    """A kernel and its program."""

    kernel: Kernel
    """What was lowered."""
    program: Program
    """The program that is shipped, with twice the digits where they are needed."""
    plain: Program
    """The same without changes of digits, proved equal to ``kernel.derived``."""
    hypotheses: tuple[Scalar, ...]
    """The irreducible factors that must not vanish."""
    guarded: tuple[Scalar, ...]
    """Those of them that only guards divide by."""
    forms: int = 1
    """Among how many forms, all proved equal, this one was chosen."""

    @property
    def input_hypotheses(self) -> tuple[Scalar, ...]:
        """Those hypotheses that the inputs alone decide, not the results of primitive functions."""
        return tuple(factor for factor in self.hypotheses if not factor.free_symbols & {*self.kernel.intermediate})

    @property
    def lets(self) -> tuple[Stage, ...]:
        """The names for rational expressions of the inputs, also through other names."""
        known, found = {*self.kernel.symbols}, []
        for stage in self.kernel.stages:
            if stage.primitive == "let" and stage.derived.free_symbols <= known:
                found.append(stage)
                known |= {*stage.results}
        return tuple(found)

    @property
    def rational_hypotheses(self) -> tuple[Scalar, ...]:
        """Those hypotheses that are about rational functions of the inputs."""
        known = {*self.kernel.symbols, *(symbol for stage in self.lets for symbol in stage.results)}
        return tuple(factor for factor in self.hypotheses if factor.free_symbols <= known)

    @property
    def determinants(self) -> tuple[Scalar, ...]:
        """The determinants of linear systems that the inputs alone decide."""
        systems = [stage.derived[:, : len(stage.results)] for stage in self.kernel.stages if stage.primitive == "solve"]
        return tuple(determinant(m) for m in systems if not m.free_symbols & {*self.kernel.intermediate})


def lowered_form(kernel: Kernel, reciprocals: bool = False) -> Lowered:
    """Lower the form of a kernel and prove the program.

    Quotients with one divisor can be products with its reciprocal.

    It raises `LoweringError` if the program, run on rational functions, does not give the derived expression, or an
    entry is a constant fraction, which integers cannot give.
    """
    field = RationalFunctionField((*kernel.symbols, *kernel.intermediate), "flint")
    wanted = (*(stage.derived for stage in kernel.stages), kernel.derived)
    derived = [value for expression in wanted for value in evaluate(expression, field.variables, field.lift)]
    hypotheses = field.divisors()
    unguarded = program_of(kernel, (), reciprocals)
    steps = [step for step in unguarded.steps if isinstance(step, Step)]
    if any(all(isinstance(operand, int) for operand in step.operands) for step in steps):
        raise LoweringError(
            f"kernel {kernel.qualified_name}, form: expected no constant fraction, which floating point would round"
        )
    divisors = divisors_of(kernel, unguarded)
    guarded = tuple(factor for factor in hypotheses if factor not in divisors)
    program = program_of(kernel, guarded, reciprocals) if guarded else unguarded
    for place, (expected, value) in enumerate(zip(derived, computed_values(program, field), strict=True)):
        if not (expected - value).is_zero:
            raise LoweringError(f"kernel {kernel.qualified_name}, form: entry {place} differs from the derivation")
    hypotheses = divisors_of(kernel, program) if guarded else divisors
    return Lowered(kernel, compensated(program), program, hypotheses, guarded)


def computed_values(program: Program, field: RationalFunctionField) -> tuple[Any, ...]:
    """Run a program on rational functions; return what its calls are given, and the outputs.

    What a call gives are variables of the field, by its names.
    """
    variables = {symbol.name: value for symbol, value in field.variables.items()}
    given: list[Any] = []

    def interpretation(call: Call, rows: tuple[tuple[Any, ...], ...]) -> tuple[Any, ...]:
        given.extend(value for row in rows for value in row)
        return tuple(variables[name] for name in call.names)

    outputs = run(program, variables, interpretation)
    return (*given, *outputs)


def divisors_of(kernel: Kernel, program: Program) -> tuple[Scalar, ...]:
    """Return the irreducible factors by which a program divides."""
    field = RationalFunctionField((*kernel.symbols, *kernel.intermediate), "flint")
    computed_values(program, field)
    return field.divisors()


def program_of(kernel: Kernel, guarded: Sequence[Scalar], reciprocals: bool = False) -> Program:
    """Lower the form of a kernel, with a guard for each of the given factors."""
    graph = Graph()
    known = {symbol: graph.input(symbol.name) for symbol in (*kernel.symbols, *kernel.intermediate)}
    calls = [(stage, [graph.add(divided(entry), known) for entry in stage.form]) for stage in kernel.stages]
    abbreviations: dict[sympy.Symbol, Signed] = {}
    for symbol, expression in kernel.where:
        abbreviations[symbol] = graph.add(divided(expression), known)
        known[symbol] = graph.input(symbol.name)
    outputs = [graph.add(entry, known) for entry in entries(kernel.form)]
    guards = [graph.quotient(graph.number(0), known_factor(factor, kernel, graph, known)) for factor in guarded]
    if guards:
        guard = graph.sum(guards)
        constant = {out for out in outputs if graph.nodes[out[1]].kind == "number"}
        kept = constant if constant < set(outputs) else set()
        outputs = [out if out in kept else graph.sum([out, guard]) for out in outputs]
    wanted = [*(operand for _, operands in calls for operand in operands), *abbreviations.values(), *outputs]
    if reciprocals:
        share_reciprocals(graph, wanted)
    share_pairs(graph, wanted)
    emitter = _Emitter(graph, [symbol.name for symbol in kernel.symbols])
    for stage, operands in calls:
        emitter.call(stage, operands)
    for symbol, signed in abbreviations.items():
        emitter.name(signed, symbol.name)
    return _with_guards_of_sums_of_squares(emitter.program(outputs))


def _with_guards_of_sums_of_squares(program: Program) -> Program:
    """Add 0*sum to the outputs for each sum of squares that divides."""
    steps = {step.name: step for step in program.steps if isinstance(step, Step)}

    def is_sum_of_squares(operand: Operand, alone: bool = False) -> bool:
        step = steps.get(str(operand))
        if step is not None and step.operator == "+":
            return all(is_sum_of_squares(term, alone=True) for term in step.operands)
        return alone and step is not None and step.operator == "*" and step.operands[0] == step.operands[1]

    divisors = [step.operands[1] for step in steps.values() if step.operator == "/"]
    sums = [divisor for divisor in dict.fromkeys(divisors) if is_sum_of_squares(divisor)]
    if not sums:
        return program
    fresh = fresh_names(program.names)
    added: list[Step] = []

    def appended(operator: str, *operands: Operand) -> Operand:
        added.append(Step(next(fresh), operator, operands))
        return added[-1].name

    guard = reduce(lambda left, right: appended("+", left, right), [appended("*", 0, total) for total in sums])
    outputs = tuple(out if isinstance(out, int) else appended("+", out, guard) for out in program.outputs)
    return Program(program.inputs, (*program.steps, *added), outputs)


def factors_of(lowered: Lowered) -> Program:
    """Return the program that computes the factors that must not vanish, in the order of the hypotheses."""
    kernel = lowered.kernel
    column = vector(*lowered.hypotheses)
    used = column.free_symbols
    needed = max((k for k, stage in enumerate(kernel.stages, start=1) if used & {*stage.results}), default=0)
    results = (Result("factors", column, column),)
    return compensated(program_of(replace(kernel, results=results, stages=kernel.stages[:needed], where=()), ()))


def known_factor(factor: Scalar, kernel: Kernel, graph: Graph, known: dict[sympy.Symbol, Signed]) -> Signed:
    """Return a factor as a node: an abbreviation that equals it but for the sign, or the expression itself."""
    for symbol, expression in kernel.where:
        if sympy.expand(expression - factor) == 0 or sympy.expand(expression + factor) == 0:
            return known[symbol]
    return graph.add(factor, known)


class _Emitter:
    """Writes the nodes of a graph as steps, each node once."""

    def __init__(self, graph: Graph, inputs: Sequence[str]) -> None:
        self.graph = graph
        self.recorder = Recorder(inputs, [str(node.value) for node in graph.nodes if node.kind == "input"])
        self._numbers: dict[Signed, Any] = dict(zip(map(graph.input, inputs), self.recorder.inputs, strict=True))
        self._bindings: list[tuple[str, Any]] = []
        self._called: list[Any] = []

    def call(self, stage: Stage, operands: Sequence[Signed]) -> None:
        """Write the call of a primitive function."""
        width = stage.form.cols
        numbers = [self.signed(operand) for operand in operands]
        rows = [numbers[i : i + width] for i in range(0, len(numbers), width)]
        names = [symbol.name for symbol in stage.results]
        results = self.recorder.call(names, stage.primitive, rows)
        self._called += results
        self._numbers |= dict(zip(map(self.graph.input, names), results, strict=True))

    def name(self, signed: Signed, name: str) -> None:
        """Write an abbreviation, whose last step gets its name."""
        number = self.signed(signed)
        self._bindings.append((name, number))
        self._numbers[self.graph.input(name)] = number

    def program(self, outputs: Sequence[Signed]) -> Program:
        """Return what the outputs and the calls need, and the outputs."""
        numbers = [self.signed(output) for output in outputs]
        program = self.recorder.program([*numbers, *self._called])
        program = replace(program, outputs=program.outputs[: len(numbers)])
        return with_names(program, [(name, operand_of(number)) for name, number in self._bindings])

    def signed(self, signed: Signed) -> Any:
        """Return the number for a signed node, writing the steps it needs."""
        if signed not in self._numbers:
            self._numbers[signed] = self._written(*signed)
        return self._numbers[signed]

    def _written(self, sign: int, place: int) -> Any:
        node = self.graph.nodes[place]
        if node.kind == "number":
            return sign * int(node.value)
        long_and_written = len(node.operands) > 2 and (-sign, place) in self._numbers
        if long_and_written or (sign < 0 and not self._negatable(place)):
            return self.recorder.step("neg", self.signed((-sign, place)))
        if node.kind == "sum":
            return self._sum([(sign * s, operand) for s, operand in node.operands])
        return self._chain("*" if node.kind == "product" else "/", sign, [operand for _, operand in node.operands])

    def _negatable(self, place: int) -> bool:
        """Whether the negative of a node, not yet written, costs no negation: a sum in it can be turned around."""
        node = self.graph.nodes[place]
        if (1, place) in self._numbers:
            return False
        turned = node.kind == "sum" and any(sign < 0 for sign, _ in node.operands)
        return turned or any(self._negatable(operand) for _, operand in node.operands)

    def _sum(self, terms: Sequence[Signed]) -> Any:
        first, *rest = sorted(terms, key=lambda term: (term[0] < 0, not self._negatable(term[1])))
        left = self.signed(first)
        for sign, place in rest:
            left = self.recorder.step("+" if sign > 0 else "-", left, self.signed((1, place)))
        return left

    def _chain(self, operator: str, sign: int, places: Sequence[int]) -> Any:
        turned = next((place for place in places if self._negatable(place)), None) if sign < 0 else None
        left: Any = None
        for place in places:
            factor = self.signed((-1 if place == turned else 1, place))
            turned = None if place == turned else turned
            left = factor if left is None else self.recorder.step(operator, left, factor)
        return left
