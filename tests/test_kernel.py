"""A kernel is complete, or it is refused with its name and what came."""

import pickle
import re
from fractions import Fraction

import pytest
import sympy
from cases import for_each

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError, kernels
from algebroproj_sym.expressions import Matrix, NotRationalError, over, vector

x, y, z, a, b = sympy.symbols("x y z a b")
p = vector(*sympy.symbols("p0 p1"))


def kernel(name="shapes.area", **changes):
    parts = {
        "arguments": {"p": p, "x": x},
        "derived": p[0] * x + p[1],
        "claims": ["1.1"],
        "example": {"p": ("1", "2"), "x": "3"},
        "describe": {"p": "A point.", "x": "A number."},
    }
    return Section("demo", "1", "Demonstration").kernel(name, "A summary.", **(parts | changes))


def test_a_complete_kernel_is_accepted():
    made = kernel()
    assert (made.module, made.name, made.qualified_name) == ("shapes", "area", "shapes.area")
    assert made.symbols == (*p, x)
    assert [argument.shape for argument in made.arguments] == [(2,), ()]
    assert [result.shape for result in made.results] == [()]


def test_the_form_is_the_derived_expression_unless_another_is_given():
    assert kernel().form == kernel().derived
    assert kernel(form=x * p[0] + a, where={a: p[1]}).form == x * p[0] + a


def test_the_shape_of_the_result_is_that_of_the_derived_expression():
    assert kernel(derived=p).results[0].shape == (2,)
    assert kernel(derived=Matrix([[x, 0, 1]])).results[0].shape == (1, 3)


@pytest.mark.parametrize("name", ["area", "shapes.", ".area", ""])
def test_a_name_consists_of_module_and_function(name):
    with pytest.raises(DeclarationError, match=rf"^kernel {re.escape(name)}: expected a name of the form module"):
        kernel(name)


@pytest.mark.parametrize(
    "changes",
    [
        {"derived": x + z},
        {"derived": x, "form": x + z},
        {"derived": x + a, "where": {a: x}},
        {"where": {a: z + 1}},
        {"where": {a: b, b: x}},
        {"where": {a: a + 1}},
    ],
    ids=["derived", "form", "abbreviation in derived", "abbreviated", "abbreviation before its definition", "itself"],
)
def test_an_unknown_symbol_is_refused(changes):
    with pytest.raises(
        DeclarationError, match=r"^kernel shapes\.area: expected the symbols of the arguments, got also"
    ):
        kernel(**changes)


def test_the_unknown_symbols_are_named():
    with pytest.raises(DeclarationError, match=r"\['y', 'z'\]"):
        kernel(derived=x + y + z)


def test_an_abbreviation_may_use_earlier_ones():
    assert kernel(where={a: x + 1, b: a * x}, form=b).where == ((a, x + 1), (b, a * x))


@pytest.mark.parametrize(
    "arguments",
    [{"p": vector(x, x), "x": x}, {"p": vector(x, y), "x": x}, {"p": vector(x, 2 * y)}, {"p": vector(x, 1)}],
    ids=["within one", "in two", "an expression", "a number"],
)
def test_the_entries_of_the_arguments_are_different_symbols(arguments):
    with pytest.raises(DeclarationError, match=r"^kernel shapes\.area: expected different plain symbols"):
        kernel(arguments=arguments, derived=x)


def test_symbols_with_assumptions_are_refused():
    positive = sympy.Symbol("x", positive=True)
    with pytest.raises((DeclarationError, NotRationalError), match=r"^kernel shapes\.area.* expected .*symbols"):
        kernel(arguments={"p": p, "x": positive}, derived=positive)


def test_a_scalar_argument_has_the_name_of_its_symbol():
    with pytest.raises(DeclarationError, match=r"^kernel shapes\.area: expected the scalar size as its symbol, got x"):
        kernel(arguments={"p": p, "size": x})


@pytest.mark.parametrize("form", [p, Matrix([[x]]), vector(x)])
def test_form_and_derived_have_one_shape(form):
    with pytest.raises(DeclarationError, match=r"^kernel shapes\.area: expected a form of shape \(\), got"):
        kernel(form=form)


def test_a_kernel_names_the_claims_that_prove_it():
    with pytest.raises(DeclarationError, match=r"^kernel shapes\.area: expected the numbers of the claims .* none"):
        kernel(claims=[])


@pytest.mark.parametrize("part", ["example", "describe"])
@pytest.mark.parametrize("value", [{}, {"p": ("1", "2")}, {"p": ("1", "2"), "x": "3", "q": "4"}])
def test_every_argument_has_an_example_and_a_description_and_nothing_else_has(part, value):
    what = {"example": "example", "describe": "description"}[part]
    with pytest.raises(DeclarationError, match=rf"^kernel shapes\.area: expected an? {what} of each of \['p', 'x'\]"):
        kernel(**{part: value})


@for_each("inexact", [0.5, 0.5 * x, sympy.sqrt(x)])
@for_each("part", ["derived", "form", "where"])
def test_floats_and_roots_are_refused(part, inexact):
    with pytest.raises(NotRationalError, match=rf"^kernel shapes\.area, {part}: expected"):
        kernel(**{part: {a: inexact} if part == "where" else inexact})


def test_exact_numbers_are_accepted():
    assert kernel(derived=Fraction(1, 2)).derived == sympy.Rational(1, 2)


def test_every_kernel_of_the_papers_survives_pickling():
    for declared in kernels():
        assert pickle.loads(pickle.dumps(declared)) == declared


def test_pickling_keeps_divisions():
    assert pickle.loads(pickle.dumps(kernel(derived=over(x, x)))).derived == over(x, x)
