"""The laws of real functions: each holds with its side conditions, and is refused without each of them."""

import math
import random
from fractions import Fraction

import mpmath
import pytest
from cases import for_each

from algebroproj_sym.replaying import NotReplayable, Rejected
from algebroproj_sym.replaying.reals.comparisons import comparisons
from algebroproj_sym.replaying.reals.intervals import Intervals
from algebroproj_sym.replaying.reals.proofs import ALL_LAWS, apply
from algebroproj_sym.replaying.reals.terms import read, written
from algebroproj_sym.replaying.reals.theory import Theory
from algebroproj_sym.replaying.reals.values import UndecidedError, UndefinedError


def theory(given=(), terms=()):
    """What is known if some conditions hold and some terms are defined."""
    symbols = {name for text in (*terms,) for name in read(text).symbols()}
    conditions = [pair for text in given for pair in comparisons(text)]
    symbols |= {name for _, term in conditions for name in term.symbols()}
    found = Theory(symbols)
    for text in terms:
        found.term(read(text), granted=True)
    for relation, term in conditions:
        found.add(relation, found.term(term, granted=True))
    return found


def follows(zero, cofactors, exponent=1, multiplier=(), scale=1):
    return {
        "law": "follows", "zero": zero, "exponent": exponent, "scale": scale, "multiplier": dict(multiplier),
        "cofactors": cofactors,
    }  # fmt: skip


def sign(polynomial, relation, total, multiplier=(), scale=1, cofactors=()):
    return {
        "law": "sign", "polynomial": polynomial, "relation": relation, "scale": scale, "multiplier": dict(multiplier),
        "sum": total, "cofactors": dict(cofactors),
    }  # fmt: skip


def nonzero(polynomial, factor, multiplier):
    return {
        "law": "nonzero", "polynomial": polynomial, "factor": factor, "scale": 1, "multiplier": multiplier,
        "cofactors": {},
    }  # fmt: skip


GOAL = {"steps": [], "end": "goal"}


def mean_value(function, start, given, relation=">", variable="x", proof=GOAL):
    return {
        "law": "mean value", "variable": variable, "function": function, "from": start, "given": given,
        "relation": relation, "proof": proof,
    }  # fmt: skip


def on_a_range(function, *ends, variable="x", bits=64):
    return {"law": "on a range", "variable": variable, "function": function, "ends": [*ends], "bits": bits}


POWERS = {"law": "order of powers", "larger": "x", "smaller": "y", "degree": 2}
ORDER = {"law": "order of sines", "larger": "x", "smaller": "y"}

# law: what is given, each needed; the terms that are defined; the step; what follows; steps that are wrong
CASES = [
    (["x > 0"], ["y"], {"law": "defined", "term": "sqrt(x) + log(x) + 1/x"}, None, [
        {"law": "defined", "term": "sqrt(-x)"}, {"law": "defined", "term": "log(x - 1)"},
        {"law": "defined", "term": "1/y"}, {"law": "defined", "term": "asin(x)"},
        {"law": "defined", "term": "atan2(y, y)"}, {"law": "defined", "term": "acosh(x)"},
        {"law": "defined", "term": "y**0"}, {"law": "defined", "term": "tan(y)"},
        {"law": "defined", "term": "atanh(x)"}, {"law": "defined", "term": "y**x"},
    ]),
    (["x^2 = 0"], ["y"], follows("x", {"0": "1"}, exponent=2), ("=", "x"), [
        follows("x", {"0": "1"}), follows("y", {"0": "1"}, exponent=2), follows("x", {"0": "1"}, exponent=2, scale=-1),
        follows("x", {"0": "1"}, exponent=2, scale=0), follows("x", {"1": "1"}, exponent=2),
    ]),
    (["x*y = 0", "y != 0"], [], follows("x", {"0": "1"}, multiplier={"1": 1}), ("=", "x"), [
        follows("x", {"0": "1"}), follows("x", {"0": "1"}, multiplier={"0": 1}),
        follows("x", {"0": "1"}, multiplier={"1": -1}), follows("x", {"1": "1"}, multiplier={"1": 1}),
    ]),
    (["x > 0", "y >= 0"], ["z"], sign("x + y", ">", [["1", "1", {"0": 1}], ["1", "1", {"1": 1}]]), (">", "x + y"), [
        sign("x - y", ">", [["1", "1", {"0": 1}], ["-1", "1", {"1": 1}]]),
        sign("y", ">", [["1", "1", {"1": 1}]]), sign("z", ">=", [["1", "1", {}]]),
        sign("z^2 + x", ">", [["1", "z", {}]]), sign("z**2", ">", [["1", "z", {}]]),
        sign("x + y", "!=", [["1", "1", {"0": 1}], ["1", "1", {"1": 1}]]),
    ]),
    (["x*y > 0", "x > 0"], [], sign("y", ">", [["1", "1", {"0": 1}]], multiplier={"1": 1}), (">", "y"), [
        sign("y", ">", [["1", "1", {"0": 1}]]), sign("y", ">", [["1", "1", {"0": 1}]], multiplier={"0": 1}),
    ]),
    (["x != 0"], [], sign("x**2", ">", [["1", "1", {"0": 2}]]), (">", "x**2"), [
        sign("x", ">", [["1", "1", {"0": 1}]]), sign("x**3", ">", [["1", "1", {"0": 3}]]),
    ]),
    (["x*y != 0"], [], nonzero("x", "y", {"0": 1}), ("!=", "x"), [
        nonzero("x", "y", {}), nonzero("x", "x", {"0": 1}), nonzero("x - 1", "y", {"0": 1}),
    ]),
    (["x >= 0", "x != 0"], [], {"law": "both", "polynomial": "x"}, (">", "x"), [{"law": "both", "polynomial": "-x"}]),
    (["x >= 0", "x <= 0"], [], {"law": "both", "polynomial": "x"}, ("=", "x"), [
        {"law": "both", "polynomial": "x + 1"},
    ]),
    ([], ["sqrt(2)", "x"], {"law": "value", "polynomial": "100*_1 - 141", "bits": 64}, (">", "100*_1 - 141"), [
        {"law": "value", "polynomial": "100*_1 - 142", "bits": 64}, {"law": "value", "polynomial": "x", "bits": 64},
        {"law": "value", "polynomial": "_1**2 - 2", "bits": 64},
        {"law": "value", "polynomial": "100*_1 - 141", "bits": 10**6},
    ]),
    ([], ["sin(x + 2*y)", "sin(x)", "sin(y)"], {"law": "addition", "target": "_1", "parts": [[1, "x"], [2, "y"]]},
     ("=", "_1 - (2*_4*_5*_6 + _3*(_6^2 - _5^2))"), [
        {"law": "addition", "target": "_1", "parts": [[1, "x"], [1, "y"]]},
        {"law": "addition", "target": "_1", "parts": [[1, "x"], [-2, "y"]]},
        {"law": "addition", "target": "_2", "parts": [[1, "x"], [2, "y"]]},
        {"law": "addition", "target": "_1", "parts": [[1, "x"], [1, "2*y"]]},
    ]),
    ([], ["sin(pi/2 - x)", "sin(x)"], {"law": "addition", "target": "_1", "parts": [[1, "pi/2"], [-1, "x"]]},
     ("=", "_1 - _4"), [
        {"law": "addition", "target": "_1", "parts": [[2, "pi/2"], [-1, "x"]]},
        {"law": "addition", "target": "_1", "parts": [[-1, "pi/2"], [-1, "x"]]},
    ]),
    ([], ["exp(x + y)", "exp(x)", "exp(y)"], {"law": "exponents", "target": "_1", "parts": [[1, "_2"], [1, "_3"]]},
     ("=", "_1 - _2*_3"), [
        {"law": "exponents", "target": "_1", "parts": [[1, "_2"], [-1, "_3"]]},
        {"law": "exponents", "target": "_1", "parts": [[1, "_2"]]},
        {"law": "exponents", "target": "_1", "parts": []},
    ]),
    ([], ["exp(log(x))"], {"law": "exponents", "target": "_2", "parts": [[1, "_1"]]}, ("=", "_2 - x"), [
        {"law": "exponents", "target": "_1", "parts": [[1, "_2"]]},
        {"law": "exponents", "target": "_2", "parts": [[2, "_1"]]},
    ]),
    ([], ["log(x*y)", "log(x)", "log(y)"],
     {"law": "logarithms", "target": "_1", "parts": [[1, "x"], [1, "y"]]}, ("=", "_1 - _2 - _3"), [
        {"law": "logarithms", "target": "_1", "parts": [[1, "x"], [2, "y"]]},
        {"law": "logarithms", "target": "_1", "parts": [[1, "-x"], [1, "-y"]]},
        {"law": "logarithms", "target": "_1", "parts": [[1, "x*y"], [0, "x"]]},
    ]),
    ([], ["log(exp(x))"], {"law": "logarithms", "target": "_2", "parts": [[1, "_1"]]}, ("=", "_2 - x"), [
        {"law": "logarithms", "target": "_2", "parts": [[2, "_1"]]},
    ]),
    (["x >= 0", "y >= 0", "x^2 = y^2"], [], {"law": "equal powers", "left": "x", "right": "y", "degree": 2},
     ("=", "x - y"), [
        {"law": "equal powers", "left": "x", "right": "-y", "degree": 2},
        {"law": "equal powers", "left": "x", "right": "y", "degree": 3},
        {"law": "equal powers", "left": "x", "right": "y", "degree": 0},
        {"law": "equal powers", "left": "x", "right": "y", "degree": -2},
    ]),
    (["sin(x) = 0", "-pi < x", "x < pi"], [], {"law": "zero of sine", "angle": "x"}, ("=", "x"), [
        {"law": "zero of sine", "angle": "2*x"},
    ]),
    (["cos(x) = 1", "-2*pi < x", "x < 2*pi"], [], {"law": "full turn", "angle": "x"}, ("=", "x"), [
        {"law": "full turn", "angle": "-x"},
    ]),
    (["0 < x", "x < pi"], ["sin(x)"], {"law": "sine in range", "angle": "x"}, (">", "sin(x)"), []),
    (["0 <= x", "x <= pi"], ["sin(x)"], {"law": "sine in range", "angle": "x"}, (">=", "sin(x)"), []),
    (["-pi/2 < x", "x < pi/2"], ["cos(x)"], {"law": "cosine in range", "angle": "x"}, (">", "cos(x)"), []),
    (["sin(x) > 0", "-pi <= x", "x <= 2*pi"], [], {"law": "range of sine", "angle": "x"}, (">", "pi - x"), []),
    (["cos(x) > 0", "-3*pi/2 <= x", "x <= 3*pi/2"], [], {"law": "range of cosine", "angle": "x"},
     (">", "pi + 2*x"), []),
    (["sin(x) >= 0", "-pi < x", "x < 2*pi"], [], {"law": "range of sine", "angle": "x"}, (">=", "pi - x"), []),
    (["sin(x) >= 0", "-pi < x", "x < 2*pi"], [], {"law": "range of sine", "angle": "x"}, (">=", "x"), []),
    (["cos(x) >= 0", "-3*pi/2 < x", "x < 3*pi/2"], [], {"law": "range of cosine", "angle": "x"},
     (">=", "pi + 2*x"), []),
    (["x >= 0", "x^2 - y^2 >= 0"], [], POWERS, (">=", "x - y"), [
        {**POWERS, "degree": 1}, {**POWERS, "degree": 3}, {**POWERS, "degree": 0}, {**POWERS, "degree": -2},
        {**POWERS, "larger": "y", "smaller": "x"}, {**POWERS, "larger": "-x"}, {**POWERS, "smaller": "2*y"},
    ]),
    (["x >= 0", "x^3 - y^3 > 0"], [], {**POWERS, "degree": 3}, (">", "x - y"), []),
    (["sin(x) >= sin(y)", "-pi/2 <= x", "x <= pi/2", "-pi/2 <= y", "y <= pi/2"], [], ORDER, (">=", "x - y"), [
        {**ORDER, "larger": "y", "smaller": "x"}, {**ORDER, "larger": "x + 1"}, {**ORDER, "smaller": "-y"},
    ]),
    (["sin(x) > sin(y)", "-pi/2 <= x", "x <= pi/2", "-pi/2 <= y", "y <= pi/2"], [], ORDER, (">", "x - y"), []),
    (["sin(x) = sin(y)", "-pi/2 <= x", "x <= pi/2", "-pi/2 <= y", "y <= pi/2"], [], ORDER, ("=", "x - y"), []),
    (["x > 0"], ["sign(x)"], {"law": "sign function", "target": "_1"}, ("=", "_1 - 1"), [
        {"law": "sign function", "target": "x"},
    ]),
    (["x < 0"], ["sign(x)"], {"law": "sign function", "target": "_1"}, ("=", "_1 + 1"), []),
    (["x = 0"], ["sign(x)"], {"law": "sign function", "target": "_1"}, ("=", "_1"), []),
    (["x > 0"], ["sqrt(x)"], {"law": "strict bounds", "target": "_1"}, (">", "sqrt(x)"), [
        {"law": "strict bounds", "target": "x"}, {"law": "strict bounds", "target": "_2"},
    ]),
    (["x != 0"], ["exp(x)"], {"law": "strict bounds", "target": "_1"}, (">", "exp(x) - 1 - x"), []),
    (["x != 0"], ["exp(x)"], {"law": "strict bounds", "target": "_1"}, (">", "1 - exp(x)*(1 - x)"), []),
    (["x != 1"], ["log(x)"], {"law": "strict bounds", "target": "_1"}, (">", "x - 1 - log(x)"), []),
    (["x != 1"], ["log(x)"], {"law": "strict bounds", "target": "_1"}, (">", "x*log(x) - x + 1"), []),
    (["x >= 0"], ["y"], mean_value("x**2", "0", ["x >= 0"]), (">=", "x**2"), [
        mean_value("x**2", "1", ["x >= 0"]), mean_value("x**2", "-1", ["x >= 0"]), mean_value("x**2", "x", ["x >= 0"]),
        mean_value("x**2", "0", ["x > 0"]), mean_value("x**2", "0", ["x >= 1"]), mean_value("x**2", "0", ["x <= 9"]),
        mean_value("x**2", "0", ["x**2 >= 0"]), mean_value("x**2", "0", ["x >= 0"], relation="="),
        mean_value("x**2", "0", ["x >= 0"], relation="<"), mean_value("-x**2", "0", ["x >= 0"]),
        mean_value("x**2", "0", ["x >= 0"], variable="y"), mean_value("x**2", "0", ["x >= 0"], variable="pi"),
        mean_value("x + sign(x - 3)", "0", ["x >= 0"]), mean_value("x - 1/(x - 3)", "0", ["x >= 0"]),
        mean_value("x + sqrt(2 - x)", "0", ["x >= 0"]), mean_value("x - sqrt((x - 2)**2)", "0", ["x >= 0"]),
        mean_value("x + y", "0", ["x >= 0", "y > 0"]), mean_value("x + atan2(x, -1)", "0", ["x >= 0"]),
        mean_value("diff(x**2, x)", "0", ["x >= 0"]), mean_value("x + log(-x)", "0", ["x >= 0"]),
        mean_value("x + 0*sqrt(-x)", "0", ["x >= 0"]), mean_value("x + 1/x", "0", ["x >= 0"]),
        mean_value("x**2", "0", ["x >= 0"], proof={"steps": [], "end": "contradiction"}),
    ]),
    (["x > 0"], [], mean_value("x**2", "0", ["x > 0"]), (">", "x**2"), []),
    (["x < y"], [], mean_value("-2*x", "y", []), (">", "2*y - 2*x"), [mean_value("2*x", "y", [])]),
    (["x >= 0", "x <= 2"], ["y"], on_a_range("x**2 - 2*x + 2", "0", "1", "2"), (">", "x**2 - 2*x + 2"), [
        on_a_range("x**2 - 2*x + 2", "1/10", "1", "2"), on_a_range("x**2 - 2*x + 2", "0", "1", "19/10"),
        on_a_range("x**2 - 2*x + 2", "0", "3", "2"), on_a_range("x**2 - 2*x + 2", "2"), on_a_range("x - 1", "0", "2"),
        on_a_range("x**2 - 2*x + 1", "0", "1", "2"), on_a_range("1/(x - 1)**2", "0", "1/2", "2"),
        on_a_range("sqrt(x - 1) + 9", "0", "2"), on_a_range("y**2 + 1", "0", "2"), on_a_range("x + y + 9", "0", "2"),
        on_a_range("y**2 + 1", "0", "2", variable="y"), on_a_range("x**2 - 2*x + 2", "0", "1", "2", bits=0),
        on_a_range("abs(x - 1) - 1/100", "0", "2"), on_a_range("sign(x - 1/2) + 9/10", "0", "1", "2"),
    ]),
]  # fmt: skip


def accepts(known, step):
    try:
        apply(known, step)
    except (Rejected, NotReplayable, KeyError, TypeError, ValueError, AttributeError):
        return False
    return True


@for_each("case", CASES)
def test_a_law_needs_each_of_its_side_conditions(case):
    given, terms, step, conclusion, wrong = case
    known = theory(given, terms)
    assert accepts(known, step)
    if conclusion is not None:
        relation, text = conclusion
        assert known.holds(relation, known.term(read(text)))
    every = [*terms, *(written(part) for text in given for _, part in comparisons(text))]
    for place in range(len(given)):
        weaker = theory(given[:place] + given[place + 1 :], every)
        assert not accepts(weaker, step) or conclusion is None or not weaker.holds(*_read(weaker, conclusion)), given[
            place
        ]
    for forged in wrong:
        assert not accepts(theory(given, terms), forged), forged
    for key in step:
        assert not accepts(theory(given, terms), {name: value for name, value in step.items() if name != key})
    assert not accepts(theory(given, terms), {**step, "more": 1})


def _read(known, conclusion):
    return conclusion[0], known.term(read(conclusion[1]))


def test_every_law_is_tested():
    assert {case[2]["law"] for case in CASES} == {*ALL_LAWS}


def test_a_range_that_is_not_strict_gives_no_strict_sign():
    known = theory(["0 <= x", "x <= pi"], ["sin(x)"])
    apply(known, {"law": "sine in range", "angle": "x"})
    assert not known.holds(">", known.term(read("sin(x)")))


@pytest.mark.parametrize(("law", "given"), [
    ("range of sine", ["sin(x) >= 0", "-pi <= x", "x < 2*pi"]),
    ("range of sine", ["sin(x) >= 0", "-pi < x", "x <= 2*pi"]),
    ("range of cosine", ["cos(x) >= 0", "-3*pi/2 <= x", "x < 3*pi/2"]),
    ("range of cosine", ["cos(x) >= 0", "-3*pi/2 < x", "x <= 3*pi/2"]),
])  # fmt: skip
def test_a_sign_that_is_not_strict_gives_no_range_where_the_ends_belong_to_it(law, given):
    assert not accepts(theory(given), {"law": law, "angle": "x"})


POINTS = [Fraction(p, q) for p, q in ((1, 2), (-1, 2), (2, 1), (-3, 1), (7, 5), (1, 9), (-11, 3), (0, 1))]


@pytest.mark.parametrize(
    "text",
    ["sqrt(x)", "x^(1/3)", "exp(x)", "log(x)", "sin(x)", "cos(x)", "atan(x)", "asin(x)", "sign(x)", "atan2(x, y)"],
)
def test_the_facts_of_each_function_hold_where_it_is_defined(text):
    """The facts are evaluated at points with intervals, for which they are no input."""
    from algebroproj_sym.replaying.reals.values import value_of

    seen = 0
    for first in POINTS:
        for second in POINTS:
            point = {"x": first, "y": second}
            known = theory((), [text])
            numbers = Intervals(200)
            try:
                value_of(read(text), point, numbers)
            except (UndefinedError, UndecidedError):
                continue
            values = {"pi": numbers.pi(), **point}
            for name, application in known.applications.items():
                args = [known._enclosed(arg, numbers, values) for arg in application.args]
                root = application.function == "root"
                values[name] = (
                    numbers.root(args[0], application.degree)
                    if root
                    else numbers.atan2(*args)
                    if application.function == "atan2"
                    else numbers.applied(application.function, args[0])
                )
            for fact in known.facts:
                value = known._at(fact.polynomial, numbers, values)
                low, high = value if isinstance(value, tuple) else (value, value)
                assert {"=": low <= 0 <= high, "!=": True, ">": high > 0, ">=": high >= 0}[fact.relation], fact
                seen += 1
    assert seen > 20


def test_intervals_enclose_what_mpmath_computes():
    generator = random.Random(3)
    checked = 0
    with mpmath.workprec(500):
        for _ in range(300):
            bits = generator.choice((30, 64, 150))
            numbers = Intervals(bits)
            value = Fraction(generator.randint(-2000, 2000), generator.randint(1, 300))
            number = mpmath.mpf(value.numerator) / value.denominator
            for name in ("exp", "sin", "cos", "atan", "asin", "log"):
                try:
                    found = numbers.applied(name, value)
                except (UndefinedError, UndecidedError):
                    continue
                low, high = found if isinstance(found, tuple) else (found * 2**bits, found * 2**bits)
                true = getattr(mpmath, name)(number) * 2**bits
                assert mpmath.mpf(int(low)) <= true <= mpmath.mpf(int(high))
                checked += 1
    assert checked > 1000


SMALL = [(low, high) for low in range(-5, 6) for high in range(low, 6)]


def test_the_arithmetic_of_intervals_is_the_narrowest_that_encloses():
    numbers = Intervals(2)
    for left in SMALL:
        for right in SMALL:
            assert numbers.plus(left, right) == (left[0] + right[0], left[1] + right[1])
            products = [Fraction(a * b, 4) for a in left for b in right]
            assert numbers.times(left, right) == (math.floor(min(products)), math.ceil(max(products)))
            if right[0] <= 0 <= right[1]:
                with pytest.raises(UndecidedError):
                    numbers.over(left, right)
            else:
                quotients = [Fraction(4 * a, b) for a in left for b in right]
                assert numbers.over(left, right) == (math.floor(min(quotients)), math.ceil(max(quotients)))


@for_each("interval", SMALL)
def test_an_interval_has_the_sign_of_all_its_numbers_or_none(interval):
    numbers, signs = Intervals(2), {(number > 0) - (number < 0) for number in range(interval[0], interval[1] + 1)}
    if len(signs) == 1:
        assert {numbers.sign(interval)} == signs
    else:
        with pytest.raises(UndecidedError):
            numbers.sign(interval)
    if -1 not in signs or signs == {-1}:
        assert numbers.is_negative(interval) is (signs == {-1})
    else:
        with pytest.raises(UndecidedError):
            numbers.is_negative(interval)
    assert numbers.even(interval) == tuple(max(end, 0) for end in interval) or interval[1] < 0


def test_the_enclosure_of_a_number_is_the_narrowest_and_its_sign_is_known():
    numbers = Intervals(2)
    for value in (Fraction(n, d) for n in range(-9, 10) for d in (1, 3, 4, 5, 8)):
        assert numbers.enclosed(value) == (math.floor(4 * value), math.ceil(4 * value))
        assert numbers.sign(value) == (value / abs(value) if value else 0)
        assert numbers.is_negative(value) is (value != abs(value))
        assert numbers.even(value) == value
    assert numbers.unit_interval() == (numbers.enclosed(Fraction(0))[0], numbers.enclosed(Fraction(1))[1])


@pytest.mark.parametrize("bits", [10, 30, 64, 150, 256])
def test_pi_is_enclosed_between_neighbouring_numbers_or_nearly(bits):
    low, high = theory(terms=["pi"]).value(theory(terms=["pi"]).pi, bits)
    with mpmath.workprec(500):
        assert low < mpmath.pi * 2**bits < high
    assert high - low <= 3


WIDE = [
    "sin(x)", "cos(3*x)", "exp(x)", "log(x + 3)", "atan(x)", "asin(x/4)", "sqrt(x + 3)", "(x + 1)^4", "x^3 - x",
    "abs(x)",
    "1/(x^2 + 1/2)", "sin(x)*exp(-x) - cos(x)", "atan2(x, 1 - x)", "tanh(x)*x - 1/10", "x^(-2)", "tan(x)", "sign(x)",
]  # fmt: skip
PLAIN = {"sign": mpmath.sign, "abs": abs, "atan2": mpmath.atan2} | {
    name: getattr(mpmath, name) for name in ("sin", "cos", "exp", "log", "atan", "asin", "sqrt", "tan", "tanh")
}


def plain(text, x):
    return eval(text.replace("^", "**"), {"__builtins__": {}, "x": x, **PLAIN})


@pytest.mark.parametrize("text", WIDE)
def test_what_is_enclosed_on_a_range_are_all_values_there(text):
    from algebroproj_sym.replaying.reals.proofs import is_positive
    from algebroproj_sym.replaying.reals.values import value_of

    generator, seen, positive = random.Random(text), 0, 0
    term = read(text)
    for _ in range(80):
        low = Fraction(generator.randint(-250, 250), 100)
        high = low + Fraction(generator.randint(1, 150), generator.choice((100, 1000)))
        inside = [low + (high - low) * Fraction(part, 16) for part in range(17)]
        values = []
        for x in inside:
            with mpmath.workdps(30):
                try:
                    values.append(plain(text, mpmath.mpf(x.numerator) / x.denominator))
                except ZeroDivisionError:
                    values.append(mpmath.nan)
        if is_positive(term, "x", low, high, 64):
            positive += 1
            assert all(value > 0 for value in values)
        numbers = Intervals(64)
        try:
            found = value_of(term, {"x": (numbers.enclosed(low)[0], numbers.enclosed(high)[1])}, numbers)
        except (UndefinedError, UndecidedError):
            continue
        seen += 1
        bottom, top = numbers.lifted(found)
        with mpmath.workdps(30):
            assert all(bottom - 1 <= value * 2**64 <= top + 1 for value in values)
    assert seen > 10
    assert positive
