"""Reciprocals change their sign where that spares negations, and no result changes."""

import struct

from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.generating.program import Program, Step, run
from algebroproj_sym.generating.signs import with_negative_reciprocals

INPUTS = ("x", "y", "z")
SMALL = st.integers(0, 30)


@st.composite
def programs(draw):
    """Draw programs with many reciprocals and negations; their results may be any steps."""
    names = [*INPUTS]
    steps = []
    for place in range(draw(st.integers(1, 14))):
        operator = draw(st.sampled_from(["/", "*", "*", "neg", "neg", "+"]))
        left, right = (names[draw(SMALL) % len(names)] for _ in range(2))
        operands = {"/": (1, right), "neg": (left,)}.get(operator, (left, right))
        steps.append(Step(f"t{place}", operator, operands))
        names.append(f"t{place}")
    outputs = [names[draw(SMALL) % len(names)] for _ in range(draw(st.integers(1, 4)))]
    return Program(INPUTS, tuple(steps), tuple(outputs))


def bits(values):
    return [struct.pack("d", value) for value in values]


@given(programs(), st.tuples(*[st.floats(0.1, 10) for _ in INPUTS]), st.sets(st.sampled_from(["t0", "t1", "t2"])))
def test_no_result_changes_and_no_operation_is_added(program, values, kept):
    changed = with_negative_reciprocals(program, kept)
    inputs = dict(zip(INPUTS, values, strict=True))
    assert bits(run(changed, inputs)) == bits(run(program, inputs))
    assert changed.operations().total() <= program.operations().total()
    names = {step.name: step for step in program.steps}
    assert all(
        step == names[step.name] for step in changed.steps if step.name in kept and names[step.name].operator == "/"
    )


def test_a_reciprocal_that_is_wanted_with_its_own_sign_keeps_it():
    steps = (Step("r", "/", (1, "z")), Step("a", "*", ("x", "r")), Step("b", "neg", ("a",)))
    for outputs in (("b", "r"), ("b", "a"), ("a",)):
        assert with_negative_reciprocals(Program(INPUTS, steps, outputs)).steps[0] == steps[0]


def test_a_product_of_two_reciprocals_keeps_its_sign():
    steps = (
        Step("r", "/", (1, "y")),
        Step("s", "/", (1, "z")),
        Step("a", "*", ("r", "s")),
        Step("b", "neg", ("a",)),
    )
    program = Program(INPUTS, steps, ("b",))
    assert run(with_negative_reciprocals(program), {"x": 1.0, "y": 2.0, "z": 4.0}) == (-0.125,)


def test_a_square_of_a_reciprocal_keeps_its_sign():
    steps = (Step("r", "/", (1, "y")), Step("a", "*", ("r", "r")), Step("b", "neg", ("a",)))
    program = Program(INPUTS, steps, ("b",))
    assert run(with_negative_reciprocals(program), {"x": 1.0, "y": 2.0, "z": 4.0}) == (-0.25,)
