"""Compensation changes the digits of a program, never its value."""

from fractions import Fraction

import numpy as np
import pytest
from cases import for_each

from algebroproj_sym.declaring import kernels
from algebroproj_sym.generating.compensation import compensated, with_sums_rounded_twice
from algebroproj_sym.generating.expansion import expanded
from algebroproj_sym.generating.program import Call, Program, Step, run
from algebroproj_sym.generating.runtime.pairs import DIGITS

NAMES = [kernel.qualified_name for kernel in kernels()]


def erased(program):
    """Return what is computed, with every result of a step as its expression: without changes of digits and lets."""
    meaning = {name: name for name in program.inputs}
    calls = []

    def of(operand):
        return meaning.get(operand, operand)

    for step in program.steps:
        if isinstance(step, Step):
            operands = tuple(map(of, step.operands))
            meaning[step.name] = operands[0] if step.operator in DIGITS else (step.operator, operands)
        elif step.primitive == "let":
            meaning |= dict(zip(step.names, map(of, step.rows[0]), strict=True))
        else:
            meaning |= {name: (len(calls), place) for place, name in enumerate(step.names)}
            calls.append((step.primitive, tuple(tuple(map(of, row)) for row in step.rows)))
    return calls, tuple(map(of, program.outputs))


@pytest.mark.sampled(12)
@pytest.mark.parametrize("throughout", [False, True])
@pytest.mark.parametrize("name", [name for name in NAMES if name != "critical.quadric"])
def test_without_changes_of_digits_the_program_is_the_one_it_was(name, throughout, lowered):
    program = lowered(name).plain
    result = compensated(program, throughout)
    assert erased(with_sums_rounded_twice(result)) == erased(program)
    names = [n for step in result.steps for n in (step.names if isinstance(step, Call) else (step.name,))]
    assert len(names) == len(set(names)), "each name is assigned once"
    assert erased(result) == erased(program)


STEPS = (
    Step("t0", "*", ("x", "y")),
    Step("t1", "*", ("z", "w")),
    Step("t2", "-", ("t0", "t1")),
    Step("t3", "/", ("t2", "x")),
)


def test_a_determinant_that_cancels_is_rounded_once():
    program = Program(("x", "y", "z", "w"), STEPS, ("t2", "t3"))
    x, y, z = 1.1, 1.3, 0.9
    w = np.nextafter(x * y / z, 2)
    exact = Fraction(x) * Fraction(y) - Fraction(z) * Fraction(w)
    inputs = {"x": x, "y": y, "z": z, "w": w}
    assert float(exact) != run(program, inputs)[0]
    value, quotient = run(compensated(program), inputs)
    assert value == float(exact)
    assert quotient == value / x


def test_sums_that_cannot_cancel_stay_as_they_are():
    steps = (
        Step("t0", "*", ("x", "x")),
        Step("t1", "*", ("y", "y")),
        Step("t2", "+", ("t0", "t1")),
        Step("t3", "-", ("x", "y")),
        Step("t4", "*", ("t2", "t3")),
        Step("t5", "/", (0, "x")),
        Step("t6", "+", ("t4", "t5")),
    )
    program = Program(("x", "y"), steps, ("t6",))
    assert compensated(program) == program
    assert compensated(program, throughout=True) != program


SQUARES = Step("a", "*", ("x", "x")), Step("b", "*", ("y", "y")), Step("c", "*", ("z", "z"))


@for_each(
    ("steps", "cancels"),
    [
        ((*SQUARES, Step("d", "+", ("a", "b")), Step("e", "+", ("d", "c"))), False),
        ((*SQUARES, Step("d", "*", ("a", "b")), Step("e", "+", ("d", "c"))), False),
        ((*SQUARES, Step("d", "/", ("a", "b")), Step("e", "+", ("d", "c"))), False),
        ((*SQUARES, Step("d", "/", ("x", "x")), Step("e", "+", ("d", "c"))), True),
        ((*SQUARES, Step("d", "-", ("a", "b")), Step("e", "+", ("d", "c"))), True),
        ((*SQUARES, Step("d", "*", ("a", "x")), Step("e", "+", ("d", "c"))), True),
        ((*SQUARES, Step("d", "+", ("x", "x")), Step("e", "+", ("d", "c"))), True),
        ((*SQUARES, Step("e", "-", ("a", "c"))), True),
    ],
)
def test_a_sum_cancels_unless_both_terms_are_known_not_to_be_negative(steps, cancels):
    last = compensated(Program(("x", "y", "z"), steps, ("e",))).steps[-1]
    assert last.name == "e"
    assert (last.operator == "rounded") is cancels


@pytest.mark.parametrize("name", ["projection.projection_matrix", "correlation.epipoles", "projection.project"])
def test_expanded_programs_give_the_same_bits(name, lowered):
    program = with_sums_rounded_twice(compensated(lowered(name).plain))
    assert program.operations()["rounded_twice"]
    rng = np.random.default_rng(5)
    inputs = {symbol: rng.uniform(-3, 3, 200) for symbol in program.inputs}
    single = expanded(program)
    assert single.operations().keys().isdisjoint(DIGITS)
    for ours, theirs in zip(run(single, inputs), run(program, inputs), strict=True):
        assert np.array_equal(ours, theirs)


def roundings(*steps):
    return with_sums_rounded_twice(compensated(Program(("x", "y", "z"), steps, (steps[-1].name,)))).operations()


PRODUCT, SUM_OF_INPUTS = Step("t0", "*", ("x", "y")), Step("t1", "-", ("x", "z"))
DIFFERENCE = Step("t2", "-", ("t0", "z"))


@pytest.mark.parametrize(
    ("steps", "word"),
    [
        ([PRODUCT, DIFFERENCE], "rounded_twice"),
        ([SUM_OF_INPUTS, Step("t2", "*", ("t1", "y")), Step("t3", "+", (1, "t2"))], "rounded_twice"),
        ([PRODUCT, Step("t2", "neg", ("t0",)), Step("t3", "-", ("t2", "z"))], "rounded_twice"),
        ([SUM_OF_INPUTS, Step("t2", "-", ("t1", "y"))], "rounded"),
        ([PRODUCT, DIFFERENCE, Step("t3", "-", ("t2", "y"))], "rounded"),
        ([PRODUCT, DIFFERENCE, Step("t3", "*", ("t2", "y")), Step("t4", "-", ("t3", "z"))], "rounded"),
    ],
)
def test_last_sums_are_rounded_twice_where_their_terms_are_no_sums_of_products(steps, word):
    words = roundings(*steps)
    assert (words[word], words["rounded"] + words["rounded_twice"]) == (1, 1)


def test_a_sum_that_is_used_otherwise_is_rounded_once():
    steps = PRODUCT, Step("t2", "-", ("t0", "z")), Step("t3", "*", ("t2", "t2")), Step("t4", "-", ("t3", "x"))
    program = compensated(Program(("x", "y", "z"), steps, ("t2", "t4")))
    assert with_sums_rounded_twice(program) == program
