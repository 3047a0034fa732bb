"""Stages fit together, and are refused with their name and what came where they do not."""

import pickle
from dataclasses import FrozenInstanceError

import pytest
import sympy
from cases import for_each

from algebroproj_sym import Section
from algebroproj_sym.declaring import (
    PRIMITIVES,
    DeclarationError,
    arctan2,
    cos_sin,
    exp,
    hypot,
    let,
    log,
    null_vector,
    solution,
    sqrt,
)
from algebroproj_sym.expressions import Matrix, NotRationalError, over, vector

x, y, z, a, b, c, s, phi = sympy.symbols("x y z a b c s phi")
square = Matrix([[x, y], [1, 2]])
wide = Matrix([[x, y, 1], [1, 2, z]])


def staged(derived, through, **changes):
    parts = {
        "arguments": {"x": x, "y": y},
        "derived": derived,
        "through": through,
        "claims": ["1.1"],
        "example": {"x": "1", "y": "2"},
        "describe": {"x": "A number.", "y": "A number."},
    }
    return Section("demo", "1", "Demonstration").kernel("demo.f", "A summary.", **(parts | changes))


EXAMPLES = {
    "let": let({a: x + y, b: over(x, y)}),
    "cos_sin": cos_sin(c, s, x + y),
    "arctan2": arctan2(phi, x, y),
    "exp": exp(a, x),
    "hypot": hypot(a, x, y),
    "log": log(a, x + y),
    "sqrt": sqrt(a, x * y),
    "solve": solution([a, b], square, vector(x, 1)),
    "null_vector": null_vector([a, b, c], wide.xreplace({z: y})),
}
each_stage = pytest.mark.parametrize("primitive", PRIMITIVES)


# What a stage takes and gives


def test_there_is_a_way_to_declare_every_primitive_function():
    assert set(PRIMITIVES) == set(EXAMPLES)
    assert {stage.primitive for stage in EXAMPLES.values()} == set(PRIMITIVES)


def test_the_results_are_in_the_order_of_the_declaration():
    assert [stage.results for stage in EXAMPLES.values()] == [
        (a, b), (c, s), (phi,), (a,), (a,), (a,), (a,), (a, b), (a, b, c),
    ]  # fmt: skip


def test_the_operands_stand_as_they_are_given():
    assert list(EXAMPLES["let"].derived) == [x + y, over(x, y)]
    assert list(EXAMPLES["cos_sin"].derived) == [x + y]
    assert list(EXAMPLES["arctan2"].derived) == list(EXAMPLES["hypot"].derived) == [x, y]
    assert [EXAMPLES[name].derived[0] for name in ("exp", "log", "sqrt")] == [x, x + y, x * y]
    assert EXAMPLES["solve"].derived == Matrix([[x, y, x], [1, 2, 1]])
    assert EXAMPLES["null_vector"].derived == Matrix([[x, y, 1], [1, 2, y]])


@each_stage
def test_the_form_is_what_is_derived_unless_another_is_given(primitive):
    assert EXAMPLES[primitive].form == EXAMPLES[primitive].derived


def test_another_form_is_kept_beside_what_is_derived():
    system = Matrix([[x, y, 2 * x - x], [1, 2, 1]])
    assert solution([a, b], square, vector(over(x * y, y), 1), form=system).form == system
    assert null_vector([a, b, c], wide, form=2 * wide / 2).form == wide
    stage = let({a: over(x**2, x), b: y}, form={a: x, b: y})
    assert (list(stage.derived), list(stage.form)) == ([over(x**2, x), y], [x, y])


def test_the_order_of_the_forms_of_names_does_not_matter():
    assert list(let({a: x, b: y}, form={b: y, a: x}).form) == [x, y]


def test_exact_numbers_are_operands():
    assert cos_sin(c, s, 1).derived == Matrix([[1]])
    assert list(let({a: 0, b: 2}).derived) == [0, 2]


def test_a_stage_does_not_change():
    with pytest.raises(FrozenInstanceError):
        EXAMPLES["let"].primitive = "solve"


@each_stage
def test_a_stage_survives_pickling_with_its_divisions(primitive):
    restored = pickle.loads(pickle.dumps(EXAMPLES[primitive]))
    assert restored == EXAMPLES[primitive]
    assert sympy.srepr(restored.derived) == sympy.srepr(EXAMPLES[primitive].derived)


# What does not fit


@for_each(
    ("matrix", "right_side", "got"),
    [
        (square, vector(x), r"\(2, 2\) and \(1, 1\)"),
        (square, vector(x, y, z), r"\(2, 2\) and \(3, 1\)"),
        (square, Matrix([[x, y]]), r"\(2, 2\) and \(1, 2\)"),
        (square, x, r"\(2, 2\) and \(\)"),
        (wide, vector(x, y), r"\(2, 3\) and \(2, 1\)"),
        (wide.T, vector(x, y), r"\(3, 2\) and \(2, 1\)"),
        (vector(x, y), vector(x, y), r"\(2, 1\) and \(2, 1\)"),
        (x, vector(x, y), r"\(\) and \(2, 1\)"),
    ],
)
def test_a_system_has_as_many_equations_as_unknowns(matrix, right_side, got):
    message = rf"^solution: expected a matrix \(2, 2\) and a right side \(2, 1\), got {got}$"
    with pytest.raises(DeclarationError, match=message):
        solution([a, b], matrix, right_side)


@pytest.mark.parametrize(
    ("unknowns", "matrix", "message"),
    [
        ([a, b, c], square, r"expected a matrix \(2, 3\), got \(2, 2\)"),
        ([a, b, c], wide.T, r"expected a matrix \(2, 3\), got \(3, 2\)"),
        ([a, b], wide, r"expected a matrix \(1, 2\), got \(2, 3\)"),
        ([a, b, c, s], wide, r"expected a matrix \(3, 4\), got \(2, 3\)"),
        ([a, b], vector(x, y), r"expected a matrix \(1, 2\), got \(2,\)"),
        ([a, b, c], x, r"expected a matrix \(2, 3\), got \(\)"),
    ],
    ids=str,
)
def test_a_null_space_of_one_dimension_has_one_equation_less_than_unknowns(unknowns, matrix, message):
    with pytest.raises(DeclarationError, match=f"^null_vector: {message}$"):
        null_vector(unknowns, matrix)


@pytest.mark.parametrize("value", [vector(x), vector(x, y), Matrix([[x, y]])], ids=str)
def test_angles_coordinates_and_named_values_are_scalars(value):
    shape = r"got a matrix of shape \("
    with pytest.raises(DeclarationError, match=rf"^angle: expected a scalar, {shape}"):
        cos_sin(c, s, value)
    with pytest.raises(DeclarationError, match=rf"^y: expected a scalar, {shape}"):
        arctan2(phi, value, x)
    with pytest.raises(DeclarationError, match=rf"^x: expected a scalar, {shape}"):
        arctan2(phi, x, value)
    with pytest.raises(DeclarationError, match=rf"^b: expected a scalar, {shape}"):
        let({a: x, b: value})


@for_each(
    ("declare", "primitive"),
    [
        (lambda first, second: cos_sin(first, second, x), "cos_sin"),
        (lambda first, second: solution([first, second], square, vector(1, 2)), "solve"),
        (lambda first, second: null_vector([first, second, z], wide), "null_vector"),
    ],
)
@for_each(("first", "second"), [(a, a), (a, 2 * b), (a + b, b), (a, 1), ("a", b)])
def test_the_results_are_different_symbols(declare, primitive, first, second):
    with pytest.raises(DeclarationError, match=f"^{primitive}: expected different symbols for its results, got"):
        declare(first, second)


@pytest.mark.parametrize("name", [x + 1, -x, sympy.Integer(2), "a"], ids=str)
def test_a_name_and_an_angle_are_symbols(name):
    with pytest.raises(DeclarationError, match=r"^let: expected different symbols for its results"):
        let({name: x})
    with pytest.raises(DeclarationError, match=r"^arctan2: expected different symbols for its results"):
        arctan2(name, x, y)


@pytest.mark.parametrize("form", [square, wide.T, vector(x, y), Matrix([[x, y, 1]])], ids=str)
def test_a_form_has_the_shape_of_what_is_derived(form):
    with pytest.raises(DeclarationError, match=r"^solve: expected a form of shape \(2, 3\), got \("):
        solution([a, b], square, vector(x, y), form=form)
    with pytest.raises(DeclarationError, match=r"^null_vector: expected a form of shape \(2, 3\), got \("):
        null_vector([a, b, c], wide, form=form)


@pytest.mark.parametrize("inexact", [sympy.Float(0.5), 0.5 * x, sympy.cos(x), sympy.sqrt(x), sympy.pi], ids=str)
def test_operands_are_rational(inexact):
    with pytest.raises(NotRationalError, match=r"^angle: expected"):
        cos_sin(c, s, inexact)
    with pytest.raises(NotRationalError, match=r"^y: expected"):
        arctan2(phi, inexact, x)
    with pytest.raises(NotRationalError, match=r"^x: expected"):
        arctan2(phi, x, inexact)
    with pytest.raises(NotRationalError, match=r"^a: expected"):
        let({a: inexact})
    with pytest.raises(NotRationalError, match=r"^matrix: expected"):
        solution([a, b], Matrix([[x, y], [1, inexact]]), vector(1, 2))
    with pytest.raises(NotRationalError, match=r"^right_side: expected"):
        solution([a, b], square, vector(1, inexact))
    with pytest.raises(NotRationalError, match=r"^form: expected"):
        null_vector([a, b, c], wide, form=Matrix([[x, y, inexact], [1, 2, z]]))


@pytest.mark.parametrize("foreign", ["x", None, 0.5, [[1, 2], [3, 4]]], ids=str)
def test_operands_are_expressions(foreign):
    for name, declare in {
        "angle": lambda: cos_sin(c, s, foreign),
        "y": lambda: arctan2(phi, foreign, x),
        "a": lambda: let({a: foreign}),
        "matrix": lambda: solution([a, b], foreign, vector(1, 2)),
        "right_side": lambda: solution([a, b], square, foreign),
    }.items():
        with pytest.raises(
            NotRationalError, match=f"^{name}: expected a SymPy expression, a matrix or an exact number"
        ):
            declare()


@pytest.mark.parametrize(
    "declare",
    [
        lambda: let({a: x}, form={b: x}),
        lambda: let({a: x}, form={a: x, b: y}),
        lambda: solution([a, b], square, vector(1, 1), form=x),
    ],
    ids=["form for another name", "form for too many names", "scalar form"],
)
def test_forms_that_do_not_fit_are_refused(declare):
    with pytest.raises(DeclarationError):
        declare()


def test_a_single_equation_can_be_solved():
    assert solution([a], Matrix([[x]]), vector(y)).results == (a,)


# Kernels with stages


@pytest.mark.parametrize(
    "through",
    [[cos_sin(x, s, x)], [let({s: x}), let({s: y})], [let({s: x}), cos_sin(c, s, s)]],
    ids=["an argument", "twice", "an earlier result"],
)
def test_a_stage_gives_new_symbols(through):
    with pytest.raises(DeclarationError):
        staged(s * x, through)


@pytest.mark.parametrize("name", ["lambda", "out", "arguments", "cos_sin"])
def test_names_of_stages_are_free_in_the_generated_code(name):
    symbol = sympy.Symbol(name)
    with pytest.raises(DeclarationError):
        staged(symbol * c, [let({symbol: x}), cos_sin(c, s, y)])


def test_the_symbols_of_the_stages_are_kept_apart_from_the_arguments():
    kernel = staged(vector(a * c, b * s), [EXAMPLES["solve"], EXAMPLES["cos_sin"]])
    assert kernel.symbols == (x, y)
    assert kernel.intermediate == (a, b, c, s)
    assert kernel.stages == (EXAMPLES["solve"], EXAMPLES["cos_sin"])


def test_a_kernel_without_stages_has_no_intermediate_symbols():
    kernel = staged(x * y, ())
    assert (kernel.stages, kernel.intermediate) == ((), ())


def test_a_stage_may_use_what_earlier_ones_give():
    kernel = staged(phi, [let({a: x * y}), cos_sin(c, s, a + x), arctan2(phi, s, c + a)])
    assert kernel.intermediate == (a, c, s, phi)


@for_each(
    "through",
    [
        [cos_sin(c, s, a), let({a: x})],
        [cos_sin(c, s, z)],
        [let({a: z})],
        [arctan2(phi, x, c), cos_sin(c, s, phi)],
        [let({a: x, b: a})],
        [let({a: a + x})],
        [solution([a, b], Matrix([[x, b], [1, 2]]), vector(1, 2))],
        [null_vector([a, b, c], wide)],
    ],
)
def test_a_stage_uses_only_what_comes_before(through):
    with pytest.raises(DeclarationError, match=r"^kernel demo\.f: expected the symbols of the arguments, got also \['"):
        staged(x, through)


@pytest.mark.parametrize("reversed_order", [False, True])
def test_the_order_of_the_stages_counts(reversed_order):
    through = [let({a: x * y}), cos_sin(c, s, a)]
    if reversed_order:
        with pytest.raises(DeclarationError, match=r"got also \['a'\]"):
            staged(s, through[::-1])
    else:
        assert staged(s, through).intermediate == (a, c, s)


def test_the_form_of_a_stage_uses_only_what_comes_before():
    with pytest.raises(DeclarationError, match=r"got also \['z'\]"):
        staged(a, [let({a: x}, form={a: x + z})])
    with pytest.raises(DeclarationError, match=r"got also \['b'\]"):
        staged(a, [let({a: x}, form={a: x + b}), let({b: 0})])


def test_results_and_abbreviations_may_use_the_stages():
    assert staged(a + c, [let({a: x}), cos_sin(c, s, y)]).intermediate == (a, c, s)
    kernel = staged(2 * c, [cos_sin(c, s, x)], where={b: c + c}, form=b)
    assert kernel.where == ((b, 2 * c),)


def test_a_stage_does_not_use_the_abbreviations():
    with pytest.raises(DeclarationError, match=r"got also \['b'\]"):
        staged(c, [cos_sin(c, s, b)], where={b: x})


@pytest.mark.parametrize("derived", [a + z, c, {"first": a, "second": z}], ids=str)
def test_a_result_uses_only_arguments_and_stages(derived):
    with pytest.raises(DeclarationError, match=r"^kernel demo\.f: expected the symbols of the arguments, got also"):
        staged(derived, [let({a: x})])


# Kernels with several results


def test_several_results_have_names_shapes_and_an_order():
    kernel = staged({"area": x * y, "corner": vector(x, y), "frame": square}, ())
    assert [(result.name, result.shape) for result in kernel.results] == [
        ("area", ()),
        ("corner", (2,)),
        ("frame", (2, 2)),
    ]
    assert kernel.derived == kernel.form == vector(x * y, x, y, x, y, 1, 2)


def test_a_single_result_keeps_its_shape():
    kernel = staged(square, ())
    assert [result.shape for result in kernel.results] == [(2, 2)]
    assert kernel.derived == square


def test_each_result_has_a_form_of_its_own():
    kernel = staged({"p": over(x * y, y), "q": y}, (), form={"p": x, "q": y})
    assert [(result.derived, result.form) for result in kernel.results] == [(over(x * y, y), x), (y, y)]
    assert (kernel.derived, kernel.form) == (vector(over(x * y, y), y), vector(x, y))


@pytest.mark.parametrize(
    "form",
    [{"p": x}, {"p": x, "q": y, "r": x}, {"q": y, "p": x}, {"p": x, "r": y}, {}, vector(x, y), x],
    ids=str,
)
def test_there_is_a_form_for_each_result_in_order(form):
    with pytest.raises(
        DeclarationError, match=r"^kernel demo\.f: expected a form for each of the results \['p', 'q'\]"
    ):
        staged({"p": x, "q": y}, (), form=form)


def test_there_is_a_result():
    with pytest.raises(DeclarationError, match=r"^kernel demo\.f: expected a form for each of the results \[\], got"):
        staged({}, ())


def test_a_form_has_the_shape_of_its_result_even_if_all_together_have_as_many_entries():
    with pytest.raises(DeclarationError, match=r"^kernel demo\.f: expected a form of shape \(\), got \(2,\)"):
        staged({"p": x, "q": vector(x, y)}, (), form={"p": vector(x, y), "q": x})


@pytest.mark.parametrize("name", ["x", "p", "q0", "a", "b"])
def test_a_result_has_a_name_that_nothing_else_has(name):
    q = vector(*sympy.symbols("q0 q1"))
    parts = {
        "arguments": {"x": x, "p": q},
        "example": {"x": "1", "p": ("1", "2")},
        "describe": {"x": "A number.", "p": "A point."},
        "where": {b: 2 * x},
    }
    with pytest.raises(DeclarationError, match=rf"^kernel demo\.f: .*'{name}'"):
        staged({name: a, "other": x}, [let({a: x + 1})], **parts)
    assert staged({"mine": a, "other": x}, [let({a: x + 1})], **parts).results[0].name == "mine"


@pytest.mark.parametrize("name", ["lambda", "a b", "t0", "arguments"])
def test_names_of_results_are_free_in_the_generated_code(name):
    with pytest.raises(DeclarationError):
        staged({name: x * y, "other": x * y + x}, [])


@pytest.mark.parametrize("part", ["derived", "form"])
def test_an_inexact_result_is_named(part):
    exact, inexact = {"p": x, "corner": y}, {"p": x, "corner": sympy.sqrt(y)}
    derived, form = (inexact, exact) if part == "derived" else (exact, inexact)
    with pytest.raises(NotRationalError, match=r"^kernel demo\.f, (form of )?corner: expected"):
        staged(derived, (), form=form)


def test_a_staged_kernel_survives_pickling():
    kernel = staged(
        {"turned": vector(c * a, s * b), "angle": phi},
        [EXAMPLES["solve"], cos_sin(c, s, over(a, b)), arctan2(phi, s, c)],
        form={"turned": vector(a * c, b * s), "angle": phi},
    )
    restored = pickle.loads(pickle.dumps(kernel))
    assert restored == kernel
    assert (restored.derived, restored.form, restored.intermediate) == (kernel.derived, kernel.form, (a, b, c, s, phi))
