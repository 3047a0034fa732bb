"""Reciprocals change their sign where that spares negations, and no result changes."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.generating.program import Call, Program, Step, run
from algebroproj_sym.generating.signs import with_negative_reciprocals

INPUTS = ("x", "y", "z")
OFTEN = st.sampled_from([True] * 9 + [False])
"""Nearly always true."""


@st.composite
def programs(draw):
    """Draw programs of reciprocals, their products and negatives of these; seldom something else is wanted."""
    reciprocals = [Step(f"r{k}", "/", (1, draw(st.sampled_from(INPUTS)))) for k in range(draw(st.integers(1, 3)))]
    names = [step.name for step in reciprocals]
    factors = st.sampled_from([*INPUTS, *INPUTS, *names])
    pairs = st.tuples(factors, st.sampled_from(names)).flatmap(st.permutations)
    drawn = draw(st.lists(pairs, min_size=1, max_size=5))
    products = [Step(f"p{k}", "*", tuple(pair)) for k, pair in enumerate(drawn)]
    negatives = [Step(f"n{k}", "neg", (step.name,)) for k, step in enumerate(products) if draw(OFTEN) or draw(OFTEN)]
    others = [Step("s", "+", (draw(factors), products[0].name))] if not draw(OFTEN) else []
    steps = (*reciprocals, *products, *negatives, *others)
    outputs = [step.name for step in steps if step in negatives or not draw(OFTEN)]
    return Program(INPUTS, steps, tuple(outputs))


def bits(program, values):
    """Return the bits of the results; what is not a number has no sign."""
    inputs = dict(zip(INPUTS, map(np.float64, values), strict=True))
    with np.errstate(all="ignore"):
        return ["nan" if np.isnan(result) else result.tobytes() for result in run(program, inputs)]


@given(programs(), st.tuples(*[st.floats(0.1, 10) for _ in INPUTS]), st.sets(st.sampled_from(["r0", "p0"])))
def test_no_result_changes_and_no_operation_is_added(program, values, kept):
    changed = with_negative_reciprocals(program, kept)
    assert bits(changed, values) == bits(program, values)
    assert changed.operations().total() <= program.operations().total()
    names = {step.name: step for step in program.steps}
    assert all(
        step == names[step.name] for step in changed.steps if step.name in kept and names[step.name].operator == "/"
    )


def test_a_reciprocal_that_is_wanted_with_its_own_sign_keeps_it():
    steps = (Step("r", "/", (1, "z")), Step("a", "*", ("x", "r")), Step("b", "neg", ("a",)))
    for outputs in (("b", "r"), ("b", "a"), ("a",)):
        assert with_negative_reciprocals(Program(INPUTS, steps, outputs)).steps[0] == steps[0]


def test_what_is_kept_keeps_its_value():
    steps = (Step("r", "/", (1, "z")), Step("a", "*", ("x", "r")), Step("b", "neg", ("a",)))
    program = Program(INPUTS, steps, ("b",))
    assert with_negative_reciprocals(program) != program
    for kept in ("r", "a"):
        assert with_negative_reciprocals(program, {kept}) == program


def test_steps_of_other_kinds_stay_among_those_that_change():
    reciprocal, product, negative = Step("r", "/", (1, "z")), Step("a", "*", ("x", "r")), Step("b", "neg", ("a",))
    call = Call("let", ("c",), (("y",),))
    changed = with_negative_reciprocals(Program(INPUTS, (reciprocal, call, product, negative), ("b", "c")))
    assert changed.steps == (Step("r", "/", (-1, "z")), call, Step("b", "*", ("x", "r")))


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
