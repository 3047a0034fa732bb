"""Operations counted by hand."""

import pytest
import sympy
from cases import for_each

from algebroproj_sym import Section
from algebroproj_sym.declaring import kernels
from algebroproj_sym.expressions import Matrix, over, vector
from algebroproj_sym.generating.choosing import lower
from algebroproj_sym.generating.lowering import lowered_form
from algebroproj_sym.generating.operation_counts import derived_operations, operations

x, y, z = sympy.symbols("x y z")


def counted(derived, form=None, where=None):
    kernel = Section("demo", "1", "Demonstration").kernel(
        "demo.f",
        "A function.",
        arguments={"x": x, "y": y, "z": z},
        derived=derived,
        form=derived if form is None else form,
        where=where or {},
        claims=["1.1"],
        example=dict.fromkeys("xyz", "1"),
        describe=dict.fromkeys("xyz", "A number."),
    )
    return derived_operations(kernel), lower(kernel).plain.operations().total()


@for_each(
    ("expression", "count"),
    [
        (x, 0),
        (sympy.Integer(7), 0),
        (x + y, 1),
        (x - y, 1),
        (-x + y - z, 2),
        (x + y + z + 1, 3),
        (x * y, 1),
        (2 * x, 1),
        (x * y * z, 2),
        (x**2, 1),
        (x**5, 4),
        (x / y, 1),
        (1 / x, 1),
        (1 / (x * y), 2),
        (1 / x**2, 2),
        (x / (y * z), 2),
        (x * y / z, 2),
        (x / 2, 1),
        (2 * x / 3, 2),
        (sympy.Rational(2, 3), 1),
        (sympy.Rational(1, 2) + x, 2),
        ((x + y) ** 2, 2),
        ((x + y) * (x - y), 3),
        ((x - y) / (x * y**2), 4),
        ((x + y) ** 3 / (x - 1), 5),
        (1 / (x + 1 / y), 3),
        (x * (y + z) - z, 3),
        (vector(x, 0, 1), 0),
        (vector(x + y, x + y), 2),
        (Matrix([[x * y, x], [1 / y, -1]]), 2),
    ],
)
def test_operations_of_an_expression_as_written(expression, count):
    assert operations(expression) == count


@pytest.mark.parametrize(
    ("derived", "counts"),
    [
        (x + y, (1, 1)),
        (vector(x * y + 1, x * y + z), (4, 3)),
        (vector((x + y) * z, (x + y) / z), (4, 3)),
        (vector(x + y, y + x), (2, 1)),
        (over(x, y) + over(z, y), (3, 2)),
        (Matrix([[1, x], [0, y]]), (0, 0)),
    ],
    ids=str,
)
def test_what_is_shared_is_counted_once(derived, counts):
    assert counted(derived) == counts


def test_a_guard_is_counted():
    assert counted(over(x * y, x), form=y) == (0, 2)


def test_a_better_form_and_its_abbreviations_are_what_the_program_counts():
    s = sympy.Symbol("s")
    assert counted(x * z + y * z, form=s * z, where={s: x + y}) == (3, 2)


def test_negations_of_the_program_are_counted():
    assert counted(-(x * y))[1] == 2


@pytest.mark.sampled(4)
@pytest.mark.parametrize(
    "kernel", [kernel for kernel in kernels() if not kernel.stages], ids=lambda k: k.qualified_name
)
def test_a_form_takes_no_more_operations_than_the_derived_expression_but_for_guards_and_signs(kernel):
    low = lowered_form(kernel)
    entries = len(low.plain.outputs)
    negations = low.plain.operations()["neg"]
    assert low.plain.operations().total() - negations <= derived_operations(kernel) + len(
        low.guarded
    ) * 3 + entries * bool(low.guarded)
