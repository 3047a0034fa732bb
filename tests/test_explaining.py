"""What `explain` and a failing claim say: short enough to be read, nothing left out that a verdict depends on."""

from io import StringIO

import pytest
import sympy
from click.testing import CliRunner
from rich.console import Console

from algebroproj_sym import Section
from algebroproj_sym.cli import main
from algebroproj_sym.cli.terminal import show
from algebroproj_sym.declaring import judge, located, quotations
from algebroproj_sym.expressions import Matrix, size, vector
from algebroproj_sym.reporting.answers import answers_table
from algebroproj_sym.reporting.explaining import explanation, failure_text
from algebroproj_sym.reporting.report import report
from algebroproj_sym.reporting.tables import SCREEN, claims_table
from algebroproj_sym.showing.display import markdown

MOST_LINES = 60
LONG = 150
x, y, z = sympy.symbols("x y z")
OPEN = """
import sympy
from algebroproj_sym import Section

x = sympy.Symbol("x")
section = Section("mine", "1", "Squares")
section.vanishing("1.1", "no rational zero", printed=(), derived=x**2 + 1)
section.identity("1.2", "a square", printed=x**2, derived=x * x)
"""


@pytest.fixture
def section():
    return Section("demo", "1", "Demonstration")


def on_a_terminal(text, width=80):
    console = Console(width=width, file=StringIO(), highlight=False)
    console.print(text)
    return console.file.getvalue()


def explained(claim, **options):
    return str(explanation(judge(claim), "module", ["some.function"], **options))


def long_claims():
    """Return the claims whose explanation may be long: large forms, many entries, meanings, conditions, long notes."""
    for derivation, claim in located():
        forms = [form for form in (claim.printed, claim.derived, claim.corrected) if isinstance(form, sympy.Basic)]
        if sum(size(form, LONG) for form in forms) > LONG or len(claim.where) > 4 or len(claim.note) > 600:
            yield derivation, claim


@pytest.mark.parametrize("step", [25, pytest.param(8, marks=pytest.mark.whole)])
def test_no_explanation_of_a_claim_takes_more_than_sixty_lines_of_a_terminal(step):
    lines = {}
    for derivation, claim in [*long_claims()][::step]:
        quote = quotations(derivation.path.parent).quotes.get(claim.number)
        text = explanation(judge(claim), derivation.module, ["projection.reconstruction_matrix"] * 3, quote)
        lines[claim.paper, claim.number] = on_a_terminal(text).count("\n")
    assert len(lines) > 200 // step
    assert {key: count for key, count in lines.items() if count > MOST_LINES} == {}


def test_a_long_form_is_folded_with_its_size_and_shown_in_full_on_demand(section):
    terms = sympy.Add(*(k * x**k * y for k in range(1, 200)))
    claim = section.identity("1.1", "long", printed=sympy.expand(terms), derived=sympy.expand(terms))
    short, full = explained(claim), explained(claim, full=True)
    assert "characters)" in short
    assert "--full" in short
    assert len(short) < 2000
    assert "…" not in full
    (line,) = [line for line in full.splitlines() if line.startswith("printed")]
    assert sympy.expand(sympy.sympify(line.removeprefix("printed")) - terms) == 0


def test_what_was_declared_is_told_where_another_verdict_was_found(section):
    right = section.identity("1.1", "right", printed=x, derived=x)
    wrong = section.identity("1.2", "wrong", printed=x + 1, derived=x)
    assert "proved, a claim of kind identity\n" in explained(right)
    assert "false, declared proved, a claim of kind identity\n" in explained(wrong)


def test_a_long_form_is_shown_by_its_names():
    output = CliRunner().invoke(main, ["explain", "fundamentals1996:1.4/type"]).output
    assert "printed     frame(seen_points[:3, :]) * core[:3, :] * inverse(A_X)\n" in output
    assert "where A_X = [1, 0, 0, 0], [G00, a00, a10, a20], [G01, a01, a11, a21], [G02, a02, a12, a22]\n" in output
    assert len(output) < 2000
    full = CliRunner().invoke(main, ["explain", "fundamentals1996:1.4/type", "--full"]).output
    assert len(full) > 10_000


def test_conditions_stand_beside_every_verdict(section):
    q = sympy.symbols("q0:4")
    unit = sum(symbol**2 for symbol in q) - 1
    claim = section.identity(
        "1.1",
        "square of a product",
        printed=sympy.Integer(1),
        derived=(unit + 1) ** 2,
        constraints=[unit],
        nonzero=[q[0]],
        witness={q[0]: 1, q[1]: 0, q[2]: 0, q[3]: 0},
    )
    judgement = judge(claim)
    assert judgement.verdict == "proved"
    condition = "claimed wherever this is zero: q0**2 + q1**2 + q2**2 + q3**2 - 1"
    assert condition in explained(claim)
    assert condition in failure_text(judgement)
    assert "claimed wherever this is not zero: q0" in explained(claim)
    assert r"claimed wherever this is zero: ${q_{0}}^{2} + {q_{1}}^{2} + {q_{2}}^{2} + {q_{3}}^{2} - 1$" in markdown(
        judgement
    )


def test_a_refuted_identity_shows_the_difference_and_both_values_at_the_counterexample(section):
    claim = section.identity("1.1", "sum", printed=x + y, derived=x - y, expect="false", instead="1.2")
    section.identity("1.2", "difference", printed=x - y, derived=x - y)
    for text in (explained(claim), failure_text(judge(claim))):
        assert "difference  printed - derived = 2*y\n" in text
        assert "counterexample: " in text
        assert "at this point printed = " in text
        assert "at this point derived = " in text


def test_the_entries_that_differ_are_shown_as_they_are_declared(section):
    claim = section.identity(
        "1.1",
        "column",
        printed=vector(y - x, z),
        derived=vector(x + y, z),
        corrected=vector(y + x, z),
        expect="misprint",
    )
    assert "differs     row 1, column 1: printed y - x, corrected y + x\n" in explained(claim)


def test_a_claim_that_stays_open_exits_with_1(tmp_path):
    module = tmp_path / "squares.py"
    module.write_text(OPEN, encoding="utf-8")
    result = CliRunner().invoke(main, ["explain", f"{module}:1.1"])
    assert result.exit_code == 1
    assert "verdict     open, declared proved" in result.output
    assert CliRunner().invoke(main, ["explain", f"{module}:1.2"]).exit_code == 0


@pytest.mark.parametrize("width", [20, 40, 80])
def test_names_in_tables_are_never_cut(section, width, monkeypatch):
    number = "1.1/beyond/a-rather-long-name-of-a-claim#part"
    claim = section.identity(number, "a title that is long as well " * 3, printed=x, derived=x)
    console = Console(width=width, file=StringIO(), highlight=False)
    monkeypatch.setattr("algebroproj_sym.cli.terminal.console", lambda: console)
    show(claims_table([judge(claim)]))
    assert f"demo:{number} " in console.file.getvalue()
    assert answers_table([]).columns[0].no_wrap


def test_the_report_is_a_page(section):
    big = sympy.expand((x + 2 * y + 3 * z + 1) ** 12)
    section.identity("1.1", "long", printed=big, derived=big + 1, expect="false", instead="1.2")
    section.identity("1.2", "right", printed=x, derived=x)
    section.identity(
        "1.3",
        "sign",
        printed=Matrix([[y - x]]),
        derived=Matrix([[x + y]]),
        corrected=Matrix([[y + x]]),
        expect="misprint",
    )
    text = report([judge(claim) for claim in section.claims], [], [])
    assert "row 1, column 1: printed y - x, corrected y + x" in text
    assert "[ledger.json](ledger.json)" in text
    assert len(text) < 2000


def test_claims_that_fill_more_than_a_screen_are_counted_and_those_not_as_declared_have_a_row_each():
    section = Section("demo", "1", "Many claims")
    for k in range(SCREEN + 1):
        section.identity(f"1.{k}", f"claim {k}", printed=x + k, derived=x + (0 if k == 7 else k))
    judgements = [judge(claim) for claim in section.claims]
    rows = list(zip(*(column.cells for column in claims_table(judgements).columns), strict=True))
    assert [(str(key), str(told), count) for key, told, count in rows] == [
        ("demo:1", f"{SCREEN} proved, 1 false", str(SCREEN + 1)),
        ("demo:1.7", "false, declared proved", ""),
    ]
    assert claims_table(judgements, full=True).row_count == SCREEN + 1
    assert claims_table(judgements[:SCREEN]).row_count == SCREEN
