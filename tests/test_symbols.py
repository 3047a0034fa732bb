"""Names and SymPy's assumptions mean what they say, in `prove` and in claims, or are refused with the reason."""

import json
from fractions import Fraction

import pytest
import sympy
from cases import for_each
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym import prove as thorough
from algebroproj_sym.declaring import DeclarationError, judge
from algebroproj_sym.expressions import (
    NotRationalError,
    SymbolError,
    admits,
    divided,
    over,
    parse,
    values_of,
    vector,
    written,
)
from algebroproj_sym.proving import prove
from algebroproj_sym.replaying import replay
from algebroproj_sym.reporting.explaining import explanation
from algebroproj_sym.reporting.ledger import ledger

NAMES = (
    *("E", "I", "N", "O", "Q", "S", "beta", "gamma", "zeta", "pi", "oo", "nan", "lambda", "class", "None", "True"),
    *("Matrix", "over", "sqrt", "α", "Ω_1", "x'", "x''", "x_1", "x1y2", "_", "__import__", "e", "print", "é", "漢"),
)
UNWRITABLE = (
    "",
    "x y",
    "x+y",
    "2x",
    "x-1",
    "f(x)",
    "x\n",
    "x'y",
    "'",
    "\x1b[31m",
    "x\u202ey",
    "x" * 101,
    "x**2",
    "over(1,x)",
)
decide = pytest.mark.parametrize("decide", [prove, thorough])


def claim(printed, derived, **options):
    return Section("demo", "1", "Names").identity("1.1", "a title", printed=printed, derived=derived, **options)


def names_of(text):
    return {symbol.name for symbol in parse(text).free_symbols}


@for_each("name", NAMES)
@decide
def test_every_name_works_in_prove(decide, name):
    a, b = sympy.Symbol(name), sympy.Symbol("b")
    assert decide(over(a**2 - b**2, a - b), a + b).hypotheses == (a - b,) or name > "b"
    assert decide(a, b).counterexample.keys() == {a, b}
    proof = decide(a**2, b**2, constraints=[a - b], witness={name: 1, "b": 1})
    assert proof.certificate["witness"] == {name: "1", "b": "1"}
    assert names_of(proof.certificate["generators"][0]) == {name, "b"}


@for_each("name", NAMES)
def test_every_name_works_in_claims_and_in_their_ledger(name):
    a, b = sympy.Symbol(name), sympy.Symbol("b")
    section = Section("demo", "1", "Names")
    claims = [
        section.identity("1.1", "t", printed=over(a**2 - b**2, a - b), derived=a + b),
        section.identity("1.2", "t", printed=a, derived=a + b, corrected=b + a, expect="misprint"),
        section.identity("1.3", "t", printed=a**2, derived=b**2, constraints=[a - b]),
        section.up_to_scale("1.4", "t", printed=vector(a, b), derived=vector(a * b, b**2)),
        section.vanishing("1.5", "t", printed=[a], derived=a * b, nonzero=[b]),
        section.rank("1.6", "t", printed=1, derived=vector(a, b)),
        section.count("1.7", "t", printed=1, derived=vector(a), variables=[a]),
        section.limit("1.8", "t", printed=b, derived=a + b, variable=a),
        section.definition("1.9", "t", printed=a + b),
        section.structure("1.10", "t", printed=sympy.Matrix([[a, 0]]), derived=sympy.Matrix([[b, 0]])),
    ]
    judgements = [judge(entry) for entry in claims]
    assert [judgement.verdict for judgement in judgements] == [entry.expected for entry in claims]
    record = json.loads(json.dumps(ledger(judgements)))
    assert {result.status for result in replay(record, 1)} == {"replayed"}
    for entry, kept in zip(claims, record["claims"], strict=True):
        if entry.kind not in ("vanishing", "rank"):
            assert divided(parse(kept["printed"])) == divided(entry.printed)
        assert str(explanation(judgements[0], "module", []))


@pytest.mark.parametrize("name", UNWRITABLE)
@decide
def test_a_name_that_cannot_be_written_is_refused(decide, name):
    a, b = sympy.Symbol(name), sympy.Symbol("b")
    for arguments in ({"lhs": a}, {"constraints": [a]}, {"nonzero": [a + b]}):
        with pytest.raises(SymbolError, match="expected a name such as") as raised:
            decide(**{"lhs": b, "rhs": b} | arguments)
        assert repr(name) in str(raised.value)


def test_names_that_only_look_alike_stay_apart():
    latin, kelvin = sympy.symbols("K \u212a")
    assert thorough(latin, kelvin).verdict == "refuted"
    assert prove(sympy.Symbol("x"), sympy.Symbol("x'")).verdict == "refuted"


# -- assumptions ------------------------------------------------------------------------------------------------------

ASSUMED = (
    {"positive": True},
    {"negative": True},
    {"nonnegative": True},
    {"nonzero": True},
    {"integer": True},
    {"integer": True, "positive": True},
    {"even": True},
    {"odd": True, "negative": True},
    {"prime": True},
    {"zero": True},
    {"integer": False},
    {"positive": False},
    {"rational": True},
)
NO_NUMBER = ({"imaginary": True}, {"infinite": True}, {"irrational": True}, {"real": False}, {"transcendental": True})
each = pytest.mark.parametrize("assumptions", ASSUMED, ids=str)
z = sympy.Symbol("z")


def fits(assumptions, value):
    value = (
        sympy.sympify(value) if not isinstance(value, Fraction) else sympy.Rational(value.numerator, value.denominator)
    )
    return all(getattr(value, f"is_{fact}") is holds for fact, holds in assumptions.items())


@each
@decide
def test_points_satisfy_what_is_assumed(decide, assumptions):
    s, t = sympy.symbols("s t", **assumptions)
    for proof in (
        decide(s + z, t * z),
        decide(s**2 + z, z + 1 + s),
        decide(z, s, constraints=[z - s * t]),
        decide(z, s, constraints=[z**2 - s**2]),
        decide(z**2, s, constraints=[z**2 - s**2]),
    ):
        if proof.verdict == "refuted":
            assert all(fits(assumptions, v) for k, v in proof.counterexample.items() if k.name in ("s", "t"))
        else:
            assert assumptions in ({"zero": True}, {"integer": False}) or proof.verdict == "open"
    proof = decide(z**3, s**3, constraints=[z - s])
    assert proof.verdict == "proved"
    assert fits(assumptions, proof.certificate["witness"]["s"])
    assert [symbol.name for symbol in proof.assumptions] == ["s"]


@decide
def test_an_assumption_is_no_reason_to_prove_what_is_false(decide):
    p, n, k = sympy.Symbol("p", positive=True), sympy.Symbol("n", negative=True), sympy.Symbol("k", integer=True)
    assert decide(p, sympy.sqrt(p**2)).verdict == "proved"
    assert decide(p, n).verdict == "refuted"
    assert decide(k, k + 1).verdict == "refuted"
    assert decide(p, 1, constraints=[p**2 - 1]).verdict in ("open", "proved")
    assert decide(p, -1, constraints=[p**2 - 1]).counterexample == {sympy.Symbol("p"): 1}
    assert decide(z, 0, constraints=[p * z]).verdict == "proved"
    assert decide(z, 0, constraints=[sympy.Symbol("q", nonnegative=True) * z]).verdict == "refuted"


@decide
def test_what_is_assumed_must_leave_a_point(decide):
    zero, even, odd = sympy.Symbol("o", zero=True), sympy.Symbol("e", even=True), sympy.Symbol("d", odd=True)
    for proof in (
        decide(over(1, zero), over(1, zero)),
        decide(z, z, nonzero=[zero]),
        decide(zero, 1, constraints=[zero - z, z]),
        decide(even, odd, constraints=[even - odd]),
        decide(z, 1, constraints=[even + 1]),
    ):
        assert proof.verdict in ("open", "refuted")
        assert proof.verdict == "open" or proof.counterexample[sympy.Symbol("o")] == 0


@pytest.mark.parametrize("assumptions", NO_NUMBER, ids=str)
@decide
def test_symbols_for_no_rational_number_are_refused_with_the_reason(decide, assumptions):
    s = sympy.Symbol("s", **assumptions)
    with pytest.raises(SymbolError, match="no rational number is known to satisfy what is assumed: s is "):
        decide(s, s)
    with pytest.raises(DeclarationError, match=r"claim demo:1\.1: .*no rational number"):
        claim(s, s)


@decide
def test_symbols_that_do_not_commute_are_refused(decide):
    a, b = sympy.symbols("a b", commutative=False)
    with pytest.raises(NotRationalError):
        decide(a * b, a * b)
    with pytest.raises(NotRationalError):
        claim(a + b, a + b)


@each
def test_claims_keep_what_is_assumed(assumptions):
    s = sympy.Symbol("s", **assumptions)
    plain = sympy.Symbol("s")
    declared = claim(s**2 + z, z + s**2 + s, corrected=s + z + s**2, expect="misprint")
    assert declared.assumed == (s,)
    assert declared.printed == plain**2 + z
    assert (plain in declared.nonzero) == (s.is_zero is False)
    judgement = judge(declared)
    assert judgement.verdict == ("misprint" if assumptions != {"zero": True} else "open")
    if judgement.counterexample:
        assert fits(assumptions, judgement.counterexample[plain])
    assert "assumed: s is " in str(explanation(judgement, "module", []))


@pytest.mark.parametrize("kind", ["structure", "vanishing", "rank", "count", "limit", "definition"])
def test_kinds_that_do_not_look_at_assumptions_refuse_them(kind):
    s, real = sympy.Symbol("s", positive=True), sympy.Symbol("s", real=True)
    section = Section("demo", "1", "Names")

    def declare(number, s):
        matrix = sympy.Matrix([[s, 0], [0, s]])
        parts = {
            "structure": {"printed": sympy.Matrix([[z, 0], [0, z]]), "derived": matrix},
            "vanishing": {"printed": [s], "derived": s},
            "rank": {"printed": 2, "derived": matrix},
            "count": {"printed": 1, "derived": vector(s), "variables": [s]},
            "limit": {"printed": 0, "derived": s, "variable": s},
            "definition": {"printed": s},
        }
        return getattr(section, kind)(number, "t", **parts[kind])

    with pytest.raises(DeclarationError, match=f"expected plain or real ones, got s is positive.*{kind}"):
        declare("1.1", s)
    assert judge(declare("1.2", real)).verdict in ("proved", "definition")


@pytest.mark.parametrize("form", ["rhs", "constraints", "nonzero"])
@decide
def test_two_symbols_of_one_name_are_refused(decide, form):
    x, other = sympy.Symbol("x"), sympy.Symbol("x", positive=True)
    with pytest.raises(SymbolError, match="one symbol of the name x, got two with different assumptions"):
        decide(**{"lhs": x, "rhs": x} | {form: other if form == "rhs" else [other]})
    with pytest.raises(SymbolError, match="one symbol of the name x"):
        decide(sympy.Dummy("x"), sympy.Dummy("x"))


@given(st.fractions(-70, 70, max_denominator=7), st.sampled_from(ASSUMED))
def test_what_a_symbol_admits_is_what_sympy_says_of_the_number(value, assumptions):
    s = sympy.Symbol("s", **assumptions)
    assert admits(s, value) == fits(dict(s.assumptions0), value)
    assert all(admits(s, number) for number in values_of(s))


# -- witnesses of claims ----------------------------------------------------------------------------------------------

x, y = sympy.symbols("x y")


@pytest.mark.parametrize(
    ("printed", "derived", "constraints"),
    [
        (x**3, x, [x**2 - 1]),
        (x**4, 4, [x**2 - 2]),
        (over(1 - x, y), over(y, 1 + x), [x**2 + y**2 - 1]),
        (x**4, y**4, [x**2 + y**2 - 3, x**2 - y**2]),
        (x, 0, [x**2 + y**2]),
    ],
)
def test_a_section_finds_a_witness_where_prove_does(printed, derived, constraints):
    assert thorough(printed, derived, constraints=constraints).verdict == "proved"
    judgement = judge(claim(printed, derived, constraints=constraints))
    assert judgement.verdict == "proved"
    assert judgement.certificate["witness"].keys() == {written(s) for c in constraints for s in c.free_symbols}


def test_a_claim_up_to_scale_finds_one_too():
    section = Section("demo", "1", "Witnesses")
    entry = section.up_to_scale(
        "1.1", "t", printed=vector(x, y), derived=vector(x**3, x**2 * y), constraints=[x**2 + y**2 - 25]
    )
    assert judge(entry).verdict == "proved"


def test_a_claim_that_differs_at_irrational_points_only_is_open_and_says_so():
    judgement = judge(claim(x, 1, constraints=[x**2 - 2]))
    assert judgement.verdict == "open"
    assert "no rational counterexample" in judgement.certificate["reason"]
    assert judgement.counterexample is None


def test_a_witness_of_a_claim_may_be_named():
    entry = claim(x**2, y**2, constraints=[x - y], witness={"x": 3, "y": "3"})
    assert judge(entry).certificate["witness"] == {"x": "3", "y": "3"}
    with pytest.raises(DeclarationError, match=r"witness: expected symbols that occur in the claim, got 'w'"):
        claim(x**2, y**2, constraints=[x - y], witness={"w": 3})
