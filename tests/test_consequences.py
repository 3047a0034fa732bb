"""What a case shows multiplies out; whatever is changed in it is noticed before it gets into the ledger."""

from dataclasses import replace

import flint
import pytest
from cases import for_each

from algebroproj_sym.proving.consequences import Case, End, Positive, Step, Zeros, follows

CONTEXT = flint.fmpq_mpoly_ctx.get(("x", "y", "z"), flint.Ordering.degrevlex)
x, y, z = CONTEXT.gens()
ONE = CONTEXT.constant(1)
# Where x*y = 1 and x*z = y**2 + z, x is not zero and the goal is.
ZEROS = [x * y - 1, x * z - y**2 - z]
UNITS = [x - 1]
GOAL = x**2 * (z * (x - 1) - y**2)
STEPS = (
    Step("not zero", x, ONE, {0: -ONE}, y),
    Step("goal", x * z - z - y**2, ONE, {}, x**2),
)
END = End(1, ONE, {1: ONE})
CASE = Case(None, STEPS, END)


def holds(case, goal=GOAL):
    return follows(case, goal, ZEROS, UNITS, lambda polynomial: polynomial)


def test_what_follows_is_granted():
    assert holds(CASE)
    assert holds(Case(None, (), replace(END, cofactors={1: x**2})))


@for_each("place", [0, 1])
@for_each(
    "change",
    [
        lambda step: {"polynomial": step.polynomial + 1},
        lambda step: {"polynomial": -step.polynomial},
        lambda step: {"factor": -step.factor},
        lambda step: {"factor": step.factor + 1},
        lambda step: {"multiplier": step.multiplier * 2},
        lambda step: {"multiplier": x - 1},
        lambda step: {"cofactors": {0: ONE}},
        lambda step: {"cofactors": {1: ONE}},
        lambda step: {"shows": "zero"},
    ],
)
def test_a_step_that_is_changed_is_refused(place, change):
    step = replace(STEPS[place], **change(STEPS[place]))
    steps = (*STEPS[:place], step, *STEPS[place + 1 :])
    assert not holds(replace(CASE, steps=steps))


@pytest.mark.parametrize(
    "end",
    [
        replace(END, exponent=2),
        replace(END, exponent=0),
        replace(END, multiplier=-ONE),
        replace(END, multiplier=y - 1),
        replace(END, cofactors={}),
        replace(END, cofactors={0: ONE}),
        replace(END, cofactors={1: -ONE}),
    ],
)
def test_an_end_that_is_changed_is_refused(end):
    assert not holds(replace(CASE, rest=end))


def test_a_multiplier_is_a_product_of_what_does_not_vanish():
    claim = (x - 1) * y
    given = [(x - 1) ** 2 * y]
    case = Case(None, (Step("goal", y, ONE, {}, x - 1),), End(1, (x - 1) ** 2, {0: ONE}))
    assert follows(case, claim, given, [x - 1], lambda polynomial: polynomial)
    for units in ([], [x], [(x - 1) * y]):
        assert not follows(case, claim, given, units, lambda polynomial: polynomial)


def test_squares_are_zero_together_and_positive_with_a_number():
    given, claim = [x**2 + 2 * y**2], y * z
    zeros = Zeros([(1, x), (2, y)], ONE, {0: ONE})
    case = Case(None, (zeros,), End(1, ONE, {2: z}))
    assert follows(case, claim, given, [], lambda polynomial: polynomial)
    for squares in ([(1, x), (-2, y)], [(1, x), (1, y)], [(1, x), (2, y), (0, z)], [(1, x), (2, x)]):
        forged = replace(case, steps=(replace(zeros, squares=squares),))
        assert not follows(forged, claim, given, [], lambda polynomial: polynomial)


@pytest.mark.parametrize(
    ("polynomial", "squares", "is_positive"),
    [
        (x**2 + 1, [(1, x), (1, ONE)], True),
        (x**2 + 9, [(1, x), (1, 3 * ONE)], True),
        (x**2 + 9, [(1, x), (9, 3 * ONE)], False),
        (x**2 + y**2, [(1, x), (1, y)], False),
        (x**2, [(1, x), (1, 0 * ONE)], False),
        (x**2 - 1, [(1, x), (-1, ONE)], False),
    ],
)
def test_a_sum_of_squares_is_positive_if_one_of_them_is_a_number(polynomial, squares, is_positive):
    case = Case(None, (Positive(polynomial, squares),), End(1, polynomial, {0: ONE}))
    assert follows(case, x, [x * polynomial], [], lambda polynomial: polynomial) is is_positive


def test_of_two_cases_one_is_the_other_denied():
    given, claim = [x * y], y * x**2
    first = Case(("not zero", x), (), End(1, ONE, {0: x}))
    second = Case(("zero", x), (), End(1, ONE, {1: x * y}))
    assert follows(Case(None, (), (first, second)), claim, given, [], lambda polynomial: polynomial)
    for cases in (
        (second, first),
        (first, first),
        (first, replace(second, assumed=("zero", y))),
        (first, replace(second, assumed=None)),
    ):
        assert not follows(Case(None, (), cases), claim, given, [], lambda polynomial: polynomial)
