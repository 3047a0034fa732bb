"""Replaying: every verdict follows from its evidence, and no longer does when anything in either is changed."""

import copy
import json
import re
from fractions import Fraction

import pytest
import sympy
from cases import for_each
from click.testing import CliRunner
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from tampering import at_path, leaves, tampered

from algebroproj_sym import Section
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import judge, select
from algebroproj_sym.declaring.declaration import declared
from algebroproj_sym.expressions import Matrix, over, text, vector
from algebroproj_sym.replaying import NotReplayable, Rejected, declaration_digest, replay
from algebroproj_sym.replaying import replay_claim as replay_entry
from algebroproj_sym.replaying.evaluation import at_point, evaluate
from algebroproj_sym.replaying.field import Field
from algebroproj_sym.replaying.polynomial import Polynomial, constant, variables
from algebroproj_sym.replaying.text import parse
from algebroproj_sym.reporting.ledger import ledger

a, b, c, d, s, t, x, y, z = sympy.symbols("a b c d s t x y z")
EXPRESSIONS = ("printed", "derived", "corrected", "where", "setting")
EVIDENCE = ("hypotheses", "counterexample", "certificate")


def every_kind():
    """A small claim of every kind and every verdict that its kind can have."""
    section = Section("demo", "1", "Squares")
    circle, at = [x**2 + y**2 - 1], {x: Fraction(3, 5), y: Fraction(4, 5)}
    section.identity("1.1", "normal form", printed=(x**2 - y**2) / (x - y), derived=over(x * (x + y), x))
    section.identity(
        "1.2", "misprint", printed=x * a, derived=x**2 / y, corrected=x**2 / y, expect="misprint", where={a: x}
    )
    section.identity("1.3", "false", printed=vector(x, 1), derived=vector(x, y), expect="false", instead="1.1")
    section.identity("1.4", "illegible", printed=None, derived=x * y, corrected=y * x, expect="illegible")
    section.identity("1.5", "circle", printed=x**2 / y, derived=(1 - y**2) / y, constraints=circle, witness=at)
    section.identity(
        "1.6", "circle, false", printed=x, derived=y, constraints=circle, witness=at, expect="false", instead="1.1"
    )
    section.up_to_scale("1.7", "scale", printed=vector(2 * x, 2 * y), derived=vector(x / z, y / z))
    section.up_to_scale("1.8", "no scale", printed=vector(x, y), derived=vector(y, x), expect="false", instead="1.1")
    section.up_to_scale(
        "1.9",
        "scale on a circle",
        printed=vector(1 - y, x),
        derived=vector(x, 1 + y),
        constraints=circle,
        witness=at,
        nonzero=[x],
    )
    section.structure("1.10", "skew", printed=Matrix([[0, a], [-a, 0]]), derived=Matrix([[0, x / y], [-x / y, 0]]))
    section.structure(
        "1.11",
        "not skew",
        printed=Matrix([[0, a], [-a, 0]]),
        derived=Matrix([[0, x], [x, 0]]),
        expect="false",
        instead="1.1",
    )
    section.vanishing("1.12", "factors", printed=(x, x + y), derived=(x**3 + x**2 * y) * z / z**2, nonzero=[z])
    section.vanishing("1.13", "other factors", printed=(x,), derived=x * y, expect="false", instead="1.1")
    section.rank("1.14", "rank 1", printed=1, derived=Matrix([[x, y], [2 * x, 2 * y]]), kernel=[vector(y, -x)])
    section.rank("1.15", "full rank", printed=2, derived=Matrix([[x, y], [y, x]]))
    section.rank("1.16", "larger", printed=1, derived=Matrix([[x, y], [y, x]]), expect="false", instead="1.15")
    section.rank(
        "1.17",
        "smaller",
        printed=2,
        derived=Matrix([[x, y], [x, y]]),
        kernel=[vector(y, -x)],
        expect="false",
        instead="1.15",
    )
    section.count("1.18", "ratio", printed=1, derived=vector(x / y, y / x), variables=[x, y], kernel=[vector(x, y)])
    section.limit("1.19", "limit", printed=vector(x / y, 0), derived=vector((x + a) / (y - a), a * x), variable=a)
    section.limit("1.20", "pole", printed=x, derived=x / a, variable=a, expect="false", instead="1.19")
    section.limit("1.21", "other limit", printed=y, derived=x + a * y, variable=a, expect="false", instead="1.19")
    section.numeric("1.22", "third", printed="0.33", derived=sympy.Rational(1, 3))
    section.numeric(
        "1.23", "not a third", printed="0.34", derived=sympy.Rational(1, 3), corrected="0.33", expect="misprint"
    )
    section.numeric("1.24", "cut off", printed="-0.66", derived=sympy.Rational(-2, 3), rounding="cut")
    section.reference("1.25", "reference", printed="1.3.8", meant="1.3.8")
    section.reference("1.26", "wrong reference", printed="1.3.8", meant="1.3.9")
    section.definition("1.27", "definition", printed=vector(x / (y - 1), a), where={a: x**2})
    section.identity("1.28", "error", printed=y / x, derived=over(x, y), corrected=x / y, expect="error")
    return ledger([judge(claim) for claim in section.claims], timed=False)


@pytest.fixture(scope="module")
def small():
    return every_kind()


@pytest.fixture(scope="module")
def real():
    selectors = (
        "fundamentals1996:1.3",
        "fundamentals1996:2.2",
        "fundamentals1996:1.2.2#base",
        "fundamentals1996:2.4/2.3.0",
    )
    return ledger([judge(claim) for claim in select(selectors) if not claim.letters], timed=False)


def replay_claim(record):
    """Replay an entry as if all that it declares had been declared so."""
    return replay_entry({**record, "declaration": declaration_digest(record)})


def by_number(book, number):
    return copy.deepcopy(next(claim for claim in book["claims"] if claim["number"] == number))


def test_every_kind_and_verdict_is_replayed(small):
    results = list(replay(small))
    assert [(r.number, r.status, r.reason) for r in results] == [(r.number, "replayed", "") for r in results]
    assert len({r.kind for r in results}) == 11
    assert {r.verdict for r in results} == {"proved", "misprint", "error", "false", "illegible", "definition"}


def test_real_sections_are_replayed(real):
    assert {(r.status, r.reason) for r in replay(real)} == {("replayed", "")}
    assert len(real["claims"]) > 60


def replayed(claim):
    return replay_claim(ledger([judge(claim)], timed=False)["claims"][0]).status


def test_a_symbol_that_cancels_when_its_meaning_is_put_in_has_a_value_at_the_counterexample():
    meaning = {a: over(x, y) + b}
    printed, corrected = vector(a - b, x - c), vector(a - b, x)
    claim = declared(
        "demo", "1", "1.1", "shift", "identity", printed, vector(over(x, y), x),
        corrected=corrected, expect="misprint", where=meaning,
    )  # fmt: skip
    assert judge(claim).counterexample[b] == 1
    assert replayed(claim) == "replayed"


def test_a_divisor_of_many_terms_is_replayed():
    divisor = sum(sympy.symbols("d:9")) ** 2
    expanded = sympy.expand(divisor * sum(sympy.symbols("e:9")))
    claim = declared("demo", "1", "1.1", "long", "identity", a / (expanded + 1), over(a, expanded + 1))
    assert replayed(claim) == "replayed"


def test_worker_processes_change_nothing(small):
    assert list(replay(small, jobs=2)) == list(replay(small))


def test_an_open_claim_is_not_replayable(small):
    claim = {**by_number(small, "1.1"), "verdict": "open", "expected": "open"}
    assert replay_claim(claim).status == "not replayable"


@for_each(
    ("number", "change", "reason"),
    [
        ("1.1", {"derived": "x - y"}, "the two sides differ"),
        ("1.1", {"derived": "x + y"}, "by which no form divides"),
        (
            "1.1",
            {"hypotheses": ["x"], "certificate": {"method": "normal form", "denominators": ["x"]}},
            "does not list",
        ),
        ("1.1", {"verdict": "false", "expected": "false", "instead": "1.7"}, "counterexample"),
        ("1.2", {"verdict": "proved", "expected": "proved", "corrected": None}, "counterexample"),
        ("1.2", {"corrected": "x*a"}, "differ"),
        ("1.5", {"setting": {"constraints": ["x**2 + y**2 - 2"]}}, "numerators"),
        ("1.5", {"kind": "identity"}, "setting"),
        ("1.14", {"printed": "2"}, "minor is not of the claimed size"),
        ("1.15", {"printed": "1"}, "minor is not of the claimed size"),
        ("1.1", {"engine": "magic"}, "engine"),
        ("1.1", {"expected": "false"}, "was declared"),
        ("1.1", {"surplus": 1}, "expected the fields"),
        ("1.1", {"title": "a\x1b[2Jb"}, "printable"),
        ("1.1", {"number": "1.1 "}, "expected a number"),
        ("1.24", {"setting": {"rounding": "nearest"}}, "rounded number is wrong"),
        ("1.24", {"setting": {}}, "expected the rounding nearest or cut"),
        ("1.24", {"setting": {"rounding": "up"}}, "expected the rounding nearest or cut"),
        ("1.24", {"printed": "-0.67"}, "the exact number, rounded, differs from the printed one"),
        ("1.24", {"printed": "-0.666"}, "differ in the number of decimals"),
        ("1.24", {"derived": "Matrix([[-2/3], [5]])"}, "matrix"),
        (
            "1.24",
            {"certificate": {"method": "exact rounding", "rounded": "-0.67"}},
            "rounded number is wrong",
        ),
        (
            "1.24",
            {"certificate": {"method": "exact rounding", "rounded": "0.66"}},
            "rounded number is wrong",
        ),
        ("1.22", {"setting": {"rounding": "cut"}, "derived": "2/3", "printed": "0.67"}, "rounded number is wrong"),
        ("1.1", {"printed": "__import__('os').getcwd()"}, "expected an expression"),
    ],
)
def test_what_is_wrong_is_named(small, number, change, reason):
    result = replay_claim({**by_number(small, number), **change})
    assert result.status == "rejected"
    assert reason in result.reason


def test_constraints_that_nothing_satisfies_prove_nothing(small):
    claim = by_number(small, "1.5")
    claim["certificate"]["witness"] = {"x": "0", "y": "0"}
    assert "violates a constraint" in replay_claim(claim).reason


def test_a_denominator_in_the_ideal_proves_nothing():
    """x/g = y/g modulo g: the cofactors are right, but no point satisfies constraint and hypothesis."""
    claim = {
        **by_number(every_kind(), "1.5"), "printed": "x/(x - y)", "derived": "y/(x - y)",
        "setting": {"constraints": ["x - y"]}, "hypotheses": ["x - y"],
        "certificate": {
            "method": "ideal membership", "denominators": ["x - y"], "claims": ["x - y"], "generators": ["x - y"],
            "units": ["x - y"], "entries": [{"exponent": 1, "multiplier": "1", "cofactors": {"0": "1"}}],
            "witness": {"x": "1", "y": "1"},
        },
    }  # fmt: skip
    assert replay_claim(claim).reason == "a form that must not be zero is zero at the point"


@pytest.mark.parametrize(
    "change", [{"schema": 2}, {"summary": {"proved": 1}}, {"claims": "none"}, {"claims": [{}, {}]}]
)
def test_a_ledger_that_is_not_what_it_says_is_rejected(small, change):
    with pytest.raises(Rejected):
        list(replay({**small, **change}))


@pytest.mark.parametrize("instead", ["1.99", "1.3", None])
def test_what_is_true_instead_must_be_a_claim_that_holds(small, instead):
    book = copy.deepcopy(small)
    record = next(claim for claim in book["claims"] if claim["number"] == "1.3")
    record["instead"] = instead
    record["declaration"] = declaration_digest(record)
    rejected = [result.number for result in replay(book) if result.status != "replayed"]
    assert rejected == ["1.3"]


# Tampering: a single change of a sign, a number, a symbol or an operation, anywhere.


def reread(record):
    """The claim that a record states, as if it had been declared so."""
    names = re.findall(r"[A-Za-z_]\w*", json.dumps([record[key] for key in EXPRESSIONS]))
    symbols = {name: sympy.Symbol(name) for name in names if name != "Matrix"}

    def read(text):
        if text is None or record["kind"] == "numeric":
            return text
        value = sympy.sympify(text, locals=symbols)
        return tuple(value) if isinstance(value, sympy.Tuple) else value

    setting = record["setting"]
    options = {
        "where": {symbols[name]: read(text) for name, text in record["where"].items()},
        "constraints": [read(text) for text in setting.get("constraints", ())],
        "nonzero": [read(text) for text in setting.get("nonzero", ())],
        "variables": [symbols[name] for name in setting.get("variables", ())],
    }
    if "variable" in setting:
        options["variable"] = symbols[setting["variable"]]
    if "rounding" in setting:
        options["rounding"] = setting["rounding"]
    kernel = (
        (record["certificate"] or {}).get("kernel")
        or (record["certificate"].get("refutation") or {}).get("kernel")
        or ()
    )
    options["kernel"] = [sympy.sympify(text, locals=symbols) for text in kernel]
    if "witness" in record["certificate"]:
        options["witness"] = {
            symbols[n]: Fraction(v) for n, v in record["certificate"]["witness"].items() if n in symbols
        }
    elif record["counterexample"]:
        options["witness"] = {symbols[n]: Fraction(v) for n, v in record["counterexample"].items() if n in symbols}
    printed, derived, corrected = (read(record[key]) for key in ("printed", "derived", "corrected"))
    if record["kind"] == "numeric":
        from algebroproj_sym.declaring.kinds.numeric import decimal

        printed, derived = decimal(printed, "printed"), sympy.sympify(derived)
        corrected = None if corrected is None else decimal(corrected, "corrected")
    return declared(
        "demo", "1", "1.1", "", record["kind"], printed, derived, corrected=corrected, instead=record["instead"] or "",
        expect=record["verdict"], **options,
    )  # fmt: skip


def same_function(old, new, signs):
    """Whether two texts are the same rational function, or the same but for one of the signs."""
    if isinstance(old, int):
        return False
    first, second = (
        sympy.sympify(text, locals={n: sympy.Symbol(n) for n in re.findall(r"(?!Matrix)[A-Za-z_]\w*", text)})
        for text in (old, new)
    )
    pairs = [(first, second)] if isinstance(first, sympy.Expr) else zip(first, second, strict=True)
    return any(all(sympy.cancel(p - sign * q) == 0 for p, q in pairs) for sign in signs)


def still_true(record, path):
    """Whether the changed claim, judged afresh by the prover, has the verdict that the record states."""
    try:
        return judge(reread(record)).verdict == record["verdict"]
    except Exception:
        return False


def point_shows(record, path):
    """Whether the changed point shows the same, by substitution into SymPy expressions."""
    claim = reread(record)
    given = at_path(record, path[:-1])
    if isinstance(given, list):  # rows or columns of a minor
        certificate = record["certificate"]
        given = (
            certificate["kernel at"] if "kernel rows" in path else certificate.get("point") or record["counterexample"]
        )
        path = (*path[:-2], "kernel at" if "kernel rows" in path else "point", "")
    point = {sympy.Symbol(n): sympy.Rational(v) for n, v in given.items()}
    entries = [] if claim.derived is None else list(sympy.Matrix([claim.derived]))
    if path[-2] in ("witness", "nonzero at"):
        return all(g.xreplace(point) == 0 for g in claim.constraints) and all(
            g.xreplace(point) != 0 for g in claim.nonzero
        )
    if path[-2] in ("point", "kernel at") or record["kind"] in ("rank", "count"):
        certificate = record["certificate"]
        if path[-2] == "kernel at":
            matrix, rows = sympy.Matrix.hstack(*claim.kernel), certificate["kernel rows"]
            columns, value = list(range(matrix.cols)), certificate["kernel minor"]
        else:
            matrix = claim.derived if record["kind"] == "rank" else sympy.Matrix(entries).jacobian(claim.variables)
            rows, columns, value = certificate["rows"], certificate["columns"], certificate["minor"]
        return matrix.extract(rows, columns).xreplace(point).det() == sympy.Rational(value) != 0
    printed = claim.printed if isinstance(claim.printed, tuple) else list(sympy.Matrix([claim.printed]))
    values = [entry.xreplace(claim.where).xreplace(point) for entry in printed]
    if path[-2] == "instance":
        return values == [sympy.Rational(v) for v in record["certificate"]["values"]]
    if any(g.xreplace(point) != 0 for g in claim.constraints) or any(g.xreplace(point) == 0 for g in claim.nonzero):
        return False
    refutation = record["certificate"].get("refutation") or record["certificate"]
    right = [entry.xreplace(point) for entry in entries]
    if record["kind"] == "vanishing":
        return (sympy.Mul(*values) == 0) != (right[0] == 0)
    return [sympy.Rational(v) for v in refutation["left"]] != [sympy.Rational(v) for v in refutation["right"]]


def is_equivalent(before, after, path):
    """Whether a change leaves a true statement and valid evidence, judged without the replay."""
    old, new = at_path(before, path), at_path(after, path)
    if len(path) > 1 and path[-2] in ("rows", "columns", "kernel rows"):
        return point_shows(after, path)
    if path[0] in EXPRESSIONS:
        return still_true(after, path)
    if path[-1] == "pivot" and "constraints" in after["setting"]:  # an entry that is not zero at the point
        point = {sympy.Symbol(n): sympy.Rational(v) for n, v in after["certificate"]["nonzero at"].items()}
        sides = (sympy.Matrix([side]) for side in (reread(after).printed, reread(after).derived))
        return all(0 <= new < len(side) and side[new].xreplace(point) != 0 for side in sides)
    if path[-1] == "multiplier":  # of zero, any other number is as good
        return after["certificate"]["claims"][path[2]] == "0" != new
    if path[0] == "counterexample" or (
        len(path) > 1 and path[-2] in ("witness", "nonzero at", "point", "kernel at", "instance")
    ):
        return point_shows(after, path)
    listed = path[0] == "hypotheses" or path[1:2][0] in ("divisors", "claims", "generators", "units")
    return same_function(old, new, (1, -1) if listed else (1,))


def require_rejection(data, record):
    paths = [path for key in (*EXPRESSIONS, *EVIDENCE) for path in leaves(record[key], (key,))]
    paths = [path for path in paths if path[-1] not in ("method", "variable") and "variables" not in path]
    names = {*re.findall(r"[A-Za-z_]\w*", json.dumps([record["derived"], record["printed"]]))} - {"Matrix"}
    changed, path = tampered(data, record, paths, names, opposites=True)
    if replay_claim(changed).status == "replayed":
        assert is_equivalent(record, changed, path), (path, at_path(record, path), at_path(changed, path))


@settings(max_examples=4 * settings.default.max_examples)
@given(data=st.data())
def test_a_change_anywhere_in_any_kind_of_claim_is_noticed(small, data):
    record = data.draw(st.sampled_from(small["claims"]))
    require_rejection(data, record)


@settings(max_examples=4 * settings.default.max_examples)
@given(data=st.data())
def test_a_change_anywhere_in_a_real_claim_is_noticed(real, data):
    record = data.draw(st.sampled_from(real["claims"]))
    require_rejection(data, record)


@settings(max_examples=2 * settings.default.max_examples)
@given(data=st.data())
def test_another_verdict_or_kind_is_noticed(small, data):
    record = data.draw(st.sampled_from(small["claims"]))
    key = data.draw(st.sampled_from(["verdict", "kind"]))
    other = data.draw(st.sampled_from(sorted({claim[key] for claim in small["claims"]} - {record[key]})))
    assume((record["kind"], other) not in (("rank", "count"), ("count", "rank")))
    changed = {**record, key: other} | ({"expected": other} if key == "verdict" else {})
    assert replay_claim(changed).status == "rejected" or still_true(changed, (key,))


# The parts.

SUMS = st.recursive(
    st.sampled_from([x, y, z])
    | st.integers(-3, 3).map(sympy.Integer)
    | st.fractions(-2, 2, max_denominator=3).map(sympy.Rational),
    lambda inner: st.tuples(inner, inner, st.sampled_from("+-*/^")).map(
        lambda parts: {
            "+": parts[0] + parts[1],
            "-": parts[0] - parts[1],
            "*": parts[0] * parts[1],
            "/": over(parts[0], parts[1]) if parts[1] != 0 else parts[0],
            "^": parts[0] ** 2,
        }[parts[2]]
    ),
    max_leaves=8,
)


def exactly(expression, point):
    """The value, with every division that was remembered; SymPy's own powers of zero are none."""
    from algebroproj_sym.expressions import evaluate as evaluate_expression

    return evaluate_expression(expression, point)[0]


@given(SUMS, st.tuples(*[st.fractions(-3, 3, max_denominator=4)] * 3))
@example(over(x, x) + 1, (Fraction(2), Fraction(1), Fraction(1)))
def test_the_text_has_the_value_and_the_divisions_of_the_expression(expression, point):
    exact = dict(zip("xyz", point, strict=True))
    form = parse(text(expression))
    try:
        value = evaluate(form, at_point(exact))[0]
    except Rejected:
        with pytest.raises(ZeroDivisionError):
            exactly(expression, {sympy.Symbol(name): number for name, number in exact.items()})
        return
    done = expression.doit()
    assert value == Fraction(str(done.xreplace({sympy.Symbol(n): sympy.Rational(v) for n, v in exact.items()})))
    assert value == evaluate(parse(str(done)), at_point(exact))[0]


@given(SUMS, SUMS)
def test_the_field_decides_equality_as_sympy_does(first, second):
    field = Field("xyz")
    try:
        left, right = (evaluate(parse(str(e.doit())), field.algebra)[0] for e in (first, second))
    except Rejected:
        assume(False)
    assert (left - right).is_zero == (sympy.cancel(first.doit() - second.doit()) == 0)


@given(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3), st.integers(-4, 4)), min_size=1, max_size=5), st.data())
def test_an_exact_quotient_is_found_and_no_other(terms, data):
    u, v = variables(2)

    def polynomial(chosen):
        total = constant(0)
        for i, j, value in chosen:
            total = total + (u**i * v**j).scaled(value)
        return total

    divisor = polynomial(terms)
    assume(bool(divisor))
    factor = polynomial(
        data.draw(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3), st.integers(-4, 4)), max_size=4))
    )
    assert (divisor * factor).quotient(divisor) == factor
    if not divisor.is_constant():
        assert (divisor * factor + constant(1)).quotient(divisor) is None


def test_exponents_are_exact_or_refused():
    huge = variables(2)[0] ** (2**62)
    assert (huge * variables(2)[1]).quotient(huge) == variables(2)[1]
    with pytest.raises(NotReplayable):
        huge * huge
    with pytest.raises(NotReplayable):
        parse("2**99999999999")
    assert isinstance(variables(1)[0] ** 3, Polynomial)


@settings(max_examples=2 * settings.default.max_examples)
@given(
    st.lists(st.integers(0, 2**63 - 1), min_size=2, max_size=2),
    st.lists(st.integers(0, 2**63 - 1), min_size=2, max_size=2),
)
def test_a_product_of_powers_has_the_sums_of_the_exponents_or_is_refused(first, second):
    u, v = variables(2)
    left, right = (u ** p[0] * v ** p[1] for p in (first, second))
    if max(a + b for a, b in zip(first, second, strict=True)) < 2**63:
        assert left * right == u ** (first[0] + second[0]) * v ** (first[1] + second[1])
    else:
        with pytest.raises(NotReplayable):
            left * right


@for_each(
    "text",
    ["", "x +", "(x", "x)", "1.5", "x**y", "x**(1/2)", "f(x)", "x y", "Matrix([[1, 2], [3]])", "x²", "٣", "$0", "x/*y"],
)
def test_what_is_not_of_the_grammar_is_rejected(text):
    with pytest.raises(Rejected):
        parse(text)


@for_each("name", ["α", "Matrix", "E", "lambda", "x'", "é", "_", "S"])
def test_any_name_is_read(name):
    assert parse(f"{name} + 1").symbols() == {name}


# The command.


def run(*arguments):
    return CliRunner().invoke(main, ["replay", *map(str, arguments)])


def test_the_command_replays_a_ledger(small, tmp_path):
    path = tmp_path / "ledger.json"
    path.write_text(json.dumps(small), encoding="utf-8")
    result = run(path)
    assert result.exit_code == 0
    assert f"{len(small['claims'])} claims: {len(small['claims'])} replayed, 0 rejected" in result.stdout


def test_the_command_names_what_it_rejects(small, tmp_path):
    book = copy.deepcopy(small)
    book["claims"][0]["derived"] = "x"
    path = tmp_path / "ledger.json"
    path.write_text(json.dumps(book), encoding="utf-8")
    result = run(path)
    assert result.exit_code == 1
    assert "demo:1.1  rejected: the digest differs from that of the declaration" in result.stdout
    record = json.loads(run(path, "--format", "json").stdout)
    assert record["summary"] == {"replayed": len(book["claims"]) - 1, "rejected": 1}


def test_a_ledger_is_compared_with_the_derivations(real, tmp_path):
    path = tmp_path / "ledger.json"
    selector = "fundamentals1996:1.3"
    book = json.loads(CliRunner().invoke(main, ["check", selector, "--format", "json"]).stdout)
    path.write_text(json.dumps(book), encoding="utf-8")
    assert "Only the ledger was checked" in run(path).stdout
    same = run(path, "--derivations", "--source", selector)
    assert (same.exit_code, "The ledger agrees with the derivations." in same.stdout) == (0, True)
    more = run(path, "--derivations", "--source", selector, "--source", "fundamentals1996:1.2")
    assert more.exit_code == 1
    assert "missing in the ledger: fundamentals1996:1.2" in more.stderr
    assert run(path, "--source", selector).exit_code == 2
    for key, value in {"note": "forged", "title": "forged", "quote": {"line": 1, "latex": "x"}}.items():
        forged = copy.deepcopy(book)
        forged["claims"][0][key] = value
        forged["claims"][0]["declaration"] = declaration_digest(forged["claims"][0])
        path.write_text(json.dumps(forged), encoding="utf-8")
        compared = run(path, "--derivations", "--source", selector)
        assert compared.exit_code == 1
        assert "the derivations declare something else" in compared.stdout


def test_how_a_damaged_place_is_read_is_compared_with_the_derivations(tmp_path):
    path = tmp_path / "ledger.json"
    selector = "fundamentals1996:1.3.2"
    book = json.loads(CliRunner().invoke(main, ["check", selector, "--format", "json"]).stdout)
    (edit,) = next(claim["quote"]["read_as"] for claim in book["claims"] if claim["quote"].get("read_as"))
    readings = [[{**edit, name: f"{edit[name]}0"}] for name in ("read", "why")]
    readings += [[{**edit, "scan": edit["scan"][1:]}], [edit, edit], [{**edit, "read": ""}], None]
    for reading in readings:
        forged = copy.deepcopy(book)
        for claim in forged["claims"]:
            if claim["quote"].pop("read_as", None) and reading:
                claim["quote"]["read_as"] = reading
            claim["declaration"] = declaration_digest(claim)
        path.write_text(json.dumps(forged), encoding="utf-8")
        assert run(path).exit_code == 0, reading
        compared = run(path, "--derivations", "--source", selector)
        assert compared.exit_code == 1, reading
        assert "the derivations declare something else" in compared.stdout


@pytest.mark.parametrize("content", ["", "[]", "{}", '{"claims": 1}'])
def test_what_is_no_ledger_is_wrong_usage(content, tmp_path):
    path = tmp_path / "ledger.json"
    path.write_text(content, encoding="utf-8")
    assert run(path).exit_code == 2
    assert run(tmp_path / "missing.json").exit_code == 2


@pytest.mark.parametrize(
    ("key", "other"), [("derived", '"x"'), ("verdict", '"proved"'), ("note", "NaN"), ("note", "-Infinity")]
)
def test_a_ledger_that_says_a_thing_twice_is_wrong_usage(small, tmp_path, key, other):
    """A person reads the first of two entries, a program the last one."""
    path = tmp_path / "ledger.json"
    text = json.dumps(small)
    assert f'"{key}": ' in text
    path.write_text(text.replace(f'"{key}": ', f'"{key}": {other}, "{key}": ', 1), encoding="utf-8")
    found = run(path)
    assert found.exit_code == 2
    assert "expected" in found.output


def circles():
    """Claims under constraints that only the thorough search decides."""
    section = Section("demo", "2", "Squares")
    section.identity("2.1", "square", printed=x, derived=sympy.Integer(0), constraints=[x**2 + y**2])
    section.identity("2.2", "radical", printed=x, derived=sympy.Integer(0), constraints=[x**2])
    section.identity("2.3", "irrational witness", printed=x**3, derived=2 * x, constraints=[x**2 - 2])
    return section.claims


@pytest.mark.parametrize("claim", circles(), ids=lambda claim: claim.title)
def test_what_a_thorough_search_proves_is_replayed(claim):
    judgement = judge(claim)
    result = replay_claim(ledger([judgement], timed=False)["claims"][0])
    assert (judgement.verdict, result.status, result.reason) == ("proved", "replayed", "")
