"""The printed statements do what the program does: the same operations, in the same association, to the last bit."""

import ast
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from cases import for_each
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.declaring import kernels
from algebroproj_sym.generating.backends.numpy.printer import LINE, packed, statements
from algebroproj_sym.generating.program import Program, Step, run
from algebroproj_sym.generating.runtime.pairs import rounded, rounded_twice, wide

INPUTS = ("x", "y", "z")


@st.composite
def programs(draw):
    """Any straight-line program: every operator, integers of both signs, steps used never, once or often."""
    names, steps = list(INPUTS), []
    for place in range(draw(st.integers(0, 14))):
        operator = draw(st.sampled_from(("+", "-", "*", "/", "neg")))
        recent = st.sampled_from(names[-3:]) | st.sampled_from(names)
        operands = [draw(recent)]
        if operator != "neg":
            operands.insert(draw(st.integers(0, 1)), draw(recent | st.integers(-3, 3)))
        names.append(draw(st.sampled_from((f"t{place}", f"t{place}", f"w{place}"))))
        steps.append(Step(names[-1], operator, tuple(operands)))
    outputs = draw(st.lists(st.sampled_from(names[-4:]) | st.integers(-3, 3), min_size=1, max_size=3))
    return Program(INPUTS, tuple(steps), tuple(outputs))


def printed(program):
    """Return the statements as a tree: assignments, and a tuple that is returned."""
    text = "\n    ".join(["def body():", *statements(program)])
    (function,) = ast.parse(text).body
    return function.body


def lines_of(program):
    *assigned, returned = printed(program)
    return [*map(ast.unparse, assigned), *map(ast.unparse, returned.value.elts)]


def executed(program, inputs):
    namespace = {"wide": wide, "rounded": rounded, "rounded_twice": rounded_twice}
    exec("\n    ".join([f"def body({', '.join(inputs)}):", *statements(program)]), namespace)
    return list(namespace["body"](*inputs.values()))


def bits(value):
    return type(value), value if isinstance(value, int) else value.tobytes()


floats = st.floats(width=64).map(np.float64)
singles = st.floats(width=32).map(np.float32)


@given(programs(), st.tuples(floats, floats, floats) | st.tuples(singles, singles, singles))
def test_the_printed_statements_give_the_bits_of_the_program(program, values):
    inputs = dict(zip(INPUTS, values, strict=True))
    with np.errstate(all="ignore"):
        assert list(map(bits, executed(program, inputs))) == list(map(bits, run(program, inputs)))


@given(programs())
def test_every_operation_is_printed_once(program):
    tree = ast.Module(printed(program), [])
    names = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
    found = Counter()
    for node in ast.walk(tree):
        if isinstance(node, ast.BinOp):
            found[names[type(node.op)]] += 1
        elif isinstance(node, ast.UnaryOp) and not isinstance(node.operand, ast.Constant):
            assert isinstance(node.op, ast.USub)
            found["neg"] += 1
    assert found == program.operations()


@given(programs())
def test_every_name_is_assigned_once_and_before_its_use(program):
    known = set(INPUTS)
    *assigned, returned = printed(program)
    assert isinstance(returned, ast.Return)
    for statement in assigned:
        assert isinstance(statement, ast.Assign)
        (target,) = statement.targets
        assert {node.id for node in ast.walk(statement.value) if isinstance(node, ast.Name)} <= known
        assert target.id not in known
        known.add(target.id)
    assert {node.id for node in ast.walk(returned.value) if isinstance(node, ast.Name)} <= known


@given(programs())
def test_abbreviations_are_printed_under_their_names(program):
    assigned = {line.partition(" = ")[0] for line in statements(program)}
    assert {step.name for step in program.steps if step.name.startswith("w")} <= assigned


@given(programs())
def test_what_is_used_twice_has_a_line_of_its_own(program):
    assigned = {line.partition(" = ")[0] for line in statements(program)}
    uses = Counter(operand for step in program.steps for operand in step.operands) + Counter(program.outputs)
    assert {step.name for step in program.steps if uses[step.name] > 1} <= assigned


def nested(*operators):
    """Return the program ((x op y) op z), and the one that associates to the right, (x op (y op z))."""
    first, second = operators
    left = Program(INPUTS, (Step("t0", first, ("x", "y")), Step("t1", second, ("t0", "z"))), ("t1",))
    right = Program(INPUTS, (Step("t0", second, ("y", "z")), Step("t1", first, ("x", "t0"))), ("t1",))
    return lines_of(left) + lines_of(right)


@for_each(
    ("operators", "left", "right"),
    [
        ("++", "x + y + z", "x + (y + z)"),
        ("--", "x - y - z", "x - (y - z)"),
        ("-+", "x - y + z", "x - (y + z)"),
        ("**", "x * y * z", "x * (y * z)"),
        ("//", "x / y / z", "x / (y / z)"),
        ("/*", "x / y * z", "x / (y * z)"),
        ("+*", "(x + y) * z", "x + y * z"),
        ("*+", "x * y + z", "x * (y + z)"),
        ("-/", "(x - y) / z", "x - y / z"),
    ],
)
def test_parentheses_stand_where_they_are_needed_and_nowhere_else(operators, left, right):
    assert nested(*operators) == [left, right]


def test_signs_are_told_from_differences():
    steps = (
        Step("t0", "neg", ("x",)),
        Step("t1", "-", ("y", "t0")),
        Step("t2", "neg", ("t1",)),
        Step("t3", "*", (-2, "t2")),
    )
    assert lines_of(Program(INPUTS, steps, ("t3", -1))) == ["-2 * -(y - -x)", "-1"]


def test_outputs_are_returned_in_order():
    program = Program(("x",), (Step("t0", "*", ("x", "x")),), ("t0", 0, "x", "t0"))
    assert statements(program) == ["t0 = x * x", "return t0, 0, x, t0"]


@given(st.lists(st.text("abc()", min_size=1, max_size=LINE)))
def test_packed_lines_hold_all_items_in_order_and_stay_readable(items):
    lines = packed(items)
    assert " ".join(lines) == " ".join(f"{item}," for item in items)
    assert max(map(len, lines), default=0) <= LINE + 1


def test_a_number_of_twice_the_digits_stands_on_the_left_as_arrays_need_not_know_of_it():
    steps = (
        Step("t0", "wide", ("x",)),
        Step("t1", "-", ("y", "t0")),
        Step("t2", "*", (2, "t1")),
        Step("t3", "rounded", ("t2",)),
        Step("t4", "-", ("y", "t3")),
    )
    assert lines_of(Program(INPUTS, steps, ("t4",))) == ["y - rounded(2 * (wide(y) - wide(x)))"]
    twice = [replace(step, operator="rounded_twice") if step.operator == "rounded" else step for step in steps]
    assert lines_of(Program(INPUTS, tuple(twice), ("t4",))) == ["y - rounded_twice(2 * (wide(y) - wide(x)))"]


def test_lines_stay_readable():
    steps = [Step("t0", "+", ("x", "y"))]
    steps += [Step(f"t{k}", "+-*"[k % 3], (f"t{k - 1}", "z")) for k in range(1, 200)]
    program = Program(INPUTS, tuple(steps), ("t199",))
    assert max(map(len, statements(program))) <= 2 * LINE
    inputs = {"x": np.float64(1.1), "y": np.float64(0.3), "z": np.float64(-0.7)}
    assert list(map(bits, executed(program, inputs))) == list(map(bits, run(program, inputs)))


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", [kernel.qualified_name for kernel in kernels() if not kernel.stages])
def test_the_kernels_of_the_papers_are_printed_to_the_bit(name, lowered):
    program = lowered(name).program
    generator = np.random.default_rng(5)
    for _ in range(5):
        inputs = {name: np.float64(generator.uniform(-3, 3)) for name in program.inputs}
        assert list(map(bits, executed(program, inputs))) == list(map(bits, run(program, inputs)))
