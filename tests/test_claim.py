"""A declaration that cannot be judged is refused, and the refusal names the claim and what came."""

import pickle
from fractions import Fraction

import pytest
import sympy
from cases import for_each
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym.declaring import VERDICTS, DeclarationError, select, statement_text
from algebroproj_sym.expressions import Matrix, NotRationalError, TextForm, over, parse, vector

x, y, z = sympy.symbols("x y z")
READ_OTHERWISE = (
    "E",
    "I",
    "N",
    "O",
    "Q",
    "S",
    "beta",
    "gamma",
    "zeta",
    "pi",
    "oo",
    "re",
    "Symbol",
    "Matrix",
    "over",
    "α",
)
NOT_OF_PYTHON = ("lambda", "class", "None", "x'", "x''")
UNWRITABLE = (
    "",
    "a b",
    "2x",
    "x*y",
    "f(x)",
    "x.y",
    "x[0]",
    "x=1",
    "0",
    "x'y",
    "x\n",
    "x\x1b[31m",
    "x\u202e",
    "x" * 101,
)


def identity(number="1.1", *, printed=x, derived=y, **options):
    return Section("demo", "1", "Demonstration").identity(
        number, "a title", printed=printed, derived=derived, **options
    )


def numeric(printed, derived=Fraction(1, 3), **options):
    return Section("demo", "1", "Demonstration").numeric("1.1", "a title", printed=printed, derived=derived, **options)


@for_each("number", ["1.3.8", "2.4/2.3.2", "1.3/y03", "table:2.2", "4/a", "1.3.5#mu3", "1.3/e'0", "7"])
def test_every_form_of_number_of_the_contract_is_accepted(number):
    assert identity(number).number == number


@for_each(
    "number",
    ["", "a", "1.", ".1", "1..2", "1.3.8 ", " 1", "1.3/", "1.3#", "1.3/a b", "1#a#b", "table:a", "-1", "1.3\n"],
)
def test_another_number_is_refused(number):
    with pytest.raises(DeclarationError, match=r"expected the text of a number such as 1\.3\.8") as raised:
        identity(number)
    assert f"claim demo:{number}" in str(raised.value)
    assert repr(number) in str(raised.value)


@pytest.mark.parametrize("verdict", ["misprint", "error", "illegible"])
def test_a_misprint_or_an_illegible_formula_needs_its_corrected_form(verdict):
    with pytest.raises(
        DeclarationError, match=rf"claim demo:1\.1, corrected: expected a form for a claim declared {verdict}"
    ):
        identity(expect=verdict, printed=None if verdict == "illegible" else x)


def test_a_false_statement_needs_what_is_true_instead():
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1, instead: expected the number of the true claim"):
        identity(expect="false")


def test_a_missing_print_is_for_illegible_formulas_only():
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1, printed: expected "):
        identity(printed=None)
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1, printed: expected "):
        identity(printed=x, corrected=y, expect="illegible")
    assert identity(printed=None, corrected=y, expect="illegible").printed is None


def test_only_a_definition_has_no_derived_form():
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1, derived: expected "):
        identity(derived=None)


@pytest.mark.parametrize("verdict", ["open", "true", "", "Proved"])
def test_an_expected_verdict_is_one_of_those_that_can_be_expected(verdict):
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1, expect: expected one of proved, ") as raised:
        identity(expect=verdict)
    assert repr(verdict) in str(raised.value)


def test_the_verdicts_are_those_of_the_contract():
    assert set(VERDICTS) == {"proved", "misprint", "error", "false", "illegible", "definition", "open"}


@for_each("inexact", [0.5, sympy.Float("0.5"), 0.5 * x, sympy.I, b"x", True])
@for_each("form", ["printed", "derived", "corrected"])
def test_whatever_is_not_rational_is_refused(form, inexact):
    with pytest.raises(NotRationalError, match=rf"claim demo:1\.1, {form}: expected") as raised:
        identity(**{form: inexact})
    assert str(inexact) in str(raised.value)


@for_each("function", [sympy.pi, sympy.sqrt(x), x**y])
@for_each("form", ["printed", "derived", "corrected"])
def test_what_has_functions_becomes_text_unless_something_else_is_inexact(form, function):
    claim = identity(**{"expect": "misprint", "corrected": y} | {form: function})
    assert isinstance(getattr(claim, form), TextForm)
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1, nonzero\[0\]: expected"):
        identity(**{form: function}, nonzero=[0.5 * x])


@pytest.mark.parametrize("inexact", [0.5, sympy.Float("0.5"), 0.5 * x])
def test_floats_in_other_places_are_refused_too(inexact):
    matrix = sympy.Matrix([[x, inexact]])
    for options in (
        {"printed": matrix},
        {"derived": matrix},
        {"where": {x: inexact}},
        {"constraints": [inexact]},
        {"nonzero": [inexact]},
    ):
        with pytest.raises(NotRationalError, match=r"claim demo:1\.1"):
            identity(**options)


@for_each("printed", [0.5, 1, None, "abc", "", "NaN", "Infinity", "1/2", "1e3", "+1", ".5", "1_0", "٣"])
def test_a_printed_number_is_the_text_of_a_decimal(printed):
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1.*expected .*decimal") as raised:
        numeric(printed)
    assert repr(printed) in str(raised.value)


def test_a_corrected_number_is_the_text_of_a_decimal():
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1.*expected .*decimal.*0\.25"):
        numeric("0.5", corrected=0.25, expect="misprint")


@pytest.mark.parametrize("derived", [x, x + 1, vector(1, 2)])
def test_a_printed_number_is_compared_with_a_number(derived):
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1.*expected .*number"):
        numeric("1", derived)


@pytest.mark.parametrize(("kind", "derived"), [("structure", vector(y)), ("vanishing", y)])
def test_constraints_are_for_identities(kind, derived):
    declare = getattr(Section("demo", "1", "Demonstration"), kind)
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1, constraints: expected none"):
        declare("1.1", "a title", printed=vector(x), derived=derived, constraints=[z])


FORMS = pytest.mark.parametrize("form", ["printed", "derived", "where", "constraints", "nonzero"])


def claim_with(form, symbol):
    return identity(**{form: {"where": {x: symbol}, "constraints": [symbol], "nonzero": [symbol]}.get(form, symbol)})


@for_each("name", UNWRITABLE)
@FORMS
def test_a_name_that_cannot_be_written_is_refused(form, name):
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1: ") as raised:
        claim_with(form, sympy.Symbol(name))
    assert repr(name) in str(raised.value)


@for_each("name", [*READ_OTHERWISE, *NOT_OF_PYTHON])
@FORMS
def test_every_name_is_read_back_as_the_symbol(form, name):
    assert claim_with(form, sympy.Symbol(name)).kind.startswith("identity")
    symbol = sympy.Symbol(name)
    written = statement_text(symbol**2 + 2 * symbol)
    assert parse(written) == symbol**2 + 2 * symbol
    if name in READ_OTHERWISE:
        assert sympy.sympify(written, locals={name: symbol}) == symbol**2 + 2 * symbol


@pytest.mark.parametrize("symbol", [sympy.Symbol("x", positive=True), sympy.Symbol("x", real=True), sympy.Dummy("x")])
def test_two_symbols_of_one_name_are_refused(symbol):
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1: expected one symbol of the name x"):
        identity(printed=symbol, derived=x)


numbers = st.fractions(-9, 9, max_denominator=5).map(lambda value: sympy.Rational(value.numerator, value.denominator))
coordinates = st.sampled_from([sympy.Rational(n, 97) for n in range(101, 999, 37)])


def combined(parts):
    pairs = st.tuples(parts, parts)
    return st.one_of(
        pairs.map(lambda pair: pair[0] + pair[1]),
        pairs.map(lambda pair: pair[0] - pair[1]),
        pairs.map(lambda pair: pair[0] * pair[1]),
        pairs.map(lambda pair: over(pair[0], 1 + pair[1] ** 2)),
        parts.map(lambda part: -(part**3)),
    )


expressions = st.recursive(st.sampled_from((x, y, z)) | numbers, combined, max_leaves=6)


@given(expressions, expressions, st.tuples(coordinates, coordinates, coordinates))
def test_statement_text_is_parsed_back_to_the_same_values(first, second, point):
    at = dict(zip((x, y, z), point, strict=True))
    for statement in (first, Matrix([[first, second], [second, 1]]), (first, second)):
        parsed = sympy.sympify(statement_text(statement))
        parts = list(statement) if isinstance(statement, tuple | sympy.MatrixBase) else [statement]
        parsed_parts = list(parsed) if isinstance(parsed, tuple | sympy.MatrixBase) else [parsed]
        assert [p.xreplace(at) for p in parsed_parts] == [p.xreplace(at).doit() for p in parts]


@given(st.integers(-(10**9), 10**9), st.integers(0, 9), st.booleans())
def test_statement_text_of_a_number_is_what_is_printed(digits, places, negative):
    whole, fraction = divmod(abs(digits), 10**places)
    printed = ("-" if negative else "") + str(whole) + (f".{fraction:0{places}}" if places else "")
    claim = numeric(printed)
    assert statement_text(claim.printed) == printed
    assert sympy.sympify(statement_text(claim.printed), rational=True) == sympy.Rational(printed)


def test_statement_text_of_nothing_is_nothing():
    assert statement_text(None) is None


RATIONAL = [c for c in select() if c.kind != "numeric" and not isinstance(c.derived, TextForm)]


@pytest.mark.sampled(15)
@pytest.mark.parametrize("claim", RATIONAL[::4], ids=lambda claim: claim.number)
def test_every_statement_of_the_papers_is_parsed_back_to_the_same_values(claim):
    for statement in (claim.printed, claim.derived, claim.corrected):
        if statement is not None:
            parts = list(statement) if isinstance(statement, tuple | sympy.MatrixBase) else [statement]
            parsed = sympy.sympify(statement_text(statement))
            parsed_parts = list(parsed) if isinstance(parsed, tuple | sympy.MatrixBase) else [parsed]
            symbols = sorted({symbol for part in parts for symbol in part.free_symbols}, key=str)
            at = {symbol: sympy.Rational(sympy.prime(k + 20), 2 + k) for k, symbol in enumerate(symbols)}
            values = [part.xreplace(at) for part in parsed_parts]
            assert all(value.is_Rational for value in values)
            assert values == [part.xreplace(at).doit() for part in parts]


def test_every_printed_number_of_the_papers_is_parsed_back():
    for claim in select():
        if claim.kind == "numeric":
            assert Fraction(statement_text(claim.printed)) == Fraction(claim.printed)
            assert sympy.sympify(statement_text(claim.printed)).is_Number


def test_claims_of_the_papers_survive_pickling():
    claims = select()[::8]
    assert pickle.loads(pickle.dumps(claims)) == claims


def test_pickling_keeps_divisions_and_hypotheses():
    claim = identity(printed=over(x * y, x), derived=y, nonzero=[x], witness={x: 1}, where={z: over(x, y)})
    copy = pickle.loads(pickle.dumps(claim))
    assert copy == claim
    assert copy.printed.has(over)
    assert copy.where[z] == over(x, y)
