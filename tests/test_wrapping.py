"""A changed function has a name, parameters and documentation, and can be stored; `DoubleDouble` reads as a number."""

import copy
import inspect
import pickle
import pydoc
from fractions import Fraction

import numpy as np
import pytest

import algebroproj
from algebroproj import DoubleDouble, metric, optics, projection

WRAPPERS = ["dd", "bounds", "hypotheses", "plain", "rounded"]
every_wrapper = pytest.mark.parametrize("name", WRAPPERS)


def text(results):
    return repr(results)


@every_wrapper
def test_it_has_the_name_the_parameters_and_the_documentation_of_the_function(name):
    wrapped = getattr(algebroproj, name)(optics.scale)
    assert repr(wrapped) == f"{name}(optics.scale)"
    assert (wrapped.__name__, wrapped.__module__) == ("scale", "algebroproj.optics")
    assert [*inspect.signature(wrapped).parameters][:2] == ["f", "x3"]
    assert ("out" in inspect.signature(wrapped).parameters) == (name == "plain")
    assert optics.scale.__doc__ in wrapped.__doc__
    assert wrapped.summary in pydoc.render_doc(wrapped)


@every_wrapper
def test_arguments_have_names(name):
    wrapped = getattr(algebroproj, name)(optics.scale)
    assert text(wrapped(x3=2.0, f=1.0)) == text(wrapped(1.0, x3=2.0)) == text(wrapped(1.0, 2.0))
    for arguments, named in (((1.0,), {}), ((1.0, 2.0), {"x3": 2.0}), ((), {"f": 1.0, "y": 2.0})):
        with pytest.raises(TypeError, match="scale"):
            wrapped(*arguments, **named)


@every_wrapper
@pytest.mark.parametrize("copied", [copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))])
def test_it_can_be_stored(name, copied):
    wrapped = getattr(algebroproj, name)(projection.mu_from_center)
    arguments = np.array([0.5, 0.25, 2.0]), np.array([0.25, 0.5])
    stored = copied(wrapped)
    assert stored == wrapped
    assert hash(stored) == hash(wrapped)
    assert text(stored(*arguments)) == text(wrapped(*arguments))


def test_one_of_a_plain_function_is_stored_as_such():
    wrapped = pickle.loads(pickle.dumps(algebroproj.bounds(algebroproj.plain(optics.scale))))
    assert repr(wrapped) == "bounds(plain(optics.scale))"
    with pytest.raises(TypeError, match=r"dd: expected a generated function, got bounds\(plain\(optics.scale\)\)"):
        algebroproj.dd(wrapped)


@pytest.mark.parametrize("name", ["bounds", "dd", "rounded"])
def test_python_numbers_do_not_widen_arrays(name):
    result = getattr(algebroproj, name)(optics.scale)(np.array([1, 2], np.float32), 2.0)
    first = result[0] if name == "bounds" else getattr(result, "hi", result)
    assert first.dtype == np.float32


def test_a_module_shows_its_functions():
    for module in (metric, optics, projection):
        assert dir(module) == sorted(module.__all__)


# Numbers of twice the digits


def test_they_are_shown_and_converted():
    third = algebroproj.dd(optics.scale)(np.array([1.0, 2.0]), 2.0)
    assert text(third).startswith("DoubleDouble(array([0.33333333, 0.5")
    assert float(third[0]) == 1 / 3
    assert (third[0].hi, third[0].lo) == (1 / 3, 1.850371707708594e-17)
    assert text(DoubleDouble(0.5)) == "DoubleDouble(0.5, 0)"


NUMBERS = [DoubleDouble(a, b) for a in (-1.0, 0.0, 1.0, np.inf) for b in (None, 0.0, -(2.0**-60), 2.0**-60)]


@pytest.mark.parametrize("operator", ["__lt__", "__le__", "__gt__", "__ge__", "__eq__", "__ne__"])
def test_they_compare_as_the_numbers_that_they_stand_for(operator):
    for x in NUMBERS[:12]:
        for y in NUMBERS[:12]:
            exact = [Fraction(number.hi) + Fraction(number.lo or 0) for number in (x, y)]
            assert bool(getattr(x, operator)(y)) == getattr(exact[0], operator)(exact[1])
        assert bool(getattr(x, operator)(NUMBERS[12])) == getattr(0.0, operator)(np.inf)
    assert bool(getattr(NUMBERS[12], operator)(np.inf)) == getattr(np.inf, operator)(np.inf)


def test_they_compare_entry_by_entry_with_single_numbers():
    numbers = DoubleDouble(np.array([1.0, 1.0, 2.0]), np.array([-(2.0**-60), 0.0, 0.0]))
    np.testing.assert_array_equal(numbers < 1, [True, False, False])
    np.testing.assert_array_equal(numbers >= 1, [False, True, True])
    np.testing.assert_array_equal(numbers == 1, [False, True, False])
