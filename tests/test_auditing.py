"""The audit of the transcription: quotes read what claims say is printed, and no slip goes unnoticed."""

import json
import os
import re
import tomllib
from dataclasses import replace
from decimal import Decimal
from pathlib import Path

import pytest
import sympy
from cases import for_each
from click.testing import CliRunner

from algebroproj_sym import Section
from algebroproj_sym.auditing.audit import audit, audited, stale
from algebroproj_sym.auditing.scans import lines_of, misplaced
from algebroproj_sym.cli import main
from algebroproj_sym.declaring import DeclarationError, Quotations, Quote, located, quotations, select
from algebroproj_sym.declaring.quotes import Edit
from algebroproj_sym.declaring.transcription import numbers_in
from algebroproj_sym.expressions import Matrix, TextForm, entries, over, vector
from algebroproj_sym.mutating.forms import mutants
from algebroproj_sym.papers import installed_papers
from algebroproj_sym.proving import prove
from algebroproj_sym.reading import Symbols, Table, UnreadableError, read_formula, symbols_for, tables_in
from algebroproj_sym.reporting.audits import audit_counts, audit_record, audited_shares

x, y, D, u1, u2, up1, upp31, mu1, mu2, y01, z11 = sympy.symbols("x y D u1 u2 up1 upp31 mu1 mu2 y01 z11")
DEMO = Table(
    (),
    {r"\mathcal{J}": "y", r"\zeta": "z"},
    {
        r"\mathbf{u}": vector(1, u1, u2),
        r"\mathbf{M}": Matrix([[mu1, 0, 0], [0, mu2, 0], [0, 0, 1]]),
        r"\mathbf{0}": sympy.Integer(0),
        r"b_0^1": sympy.Symbol("r10"),
    },
)
SYMBOLS = Symbols((DEMO,))


def same(left, right):
    return prove(left, right).verdict == "proved"


def declared(kind, printed, **options):
    derived = printed if kind != "numeric" else over(1, 3)
    return getattr(Section("demo", "1", "Squares"), kind)("1.1", "", printed=printed, derived=derived, **options)


def status(claim, *pieces, **options):
    quote = Quote((claim.number,), 1, pieces, **options)
    return audited(claim, Quotations("demo.txt", {claim.number: quote}), SYMBOLS).status


@for_each(
    ("latex", "expected"),
    [
        (r"\frac{\mu_1 - 1}{u_2}", (mu1 - 1) / u2),
        (r"\frac{u_1^2}{\mathcal{J} _ { 0 1 }}", u1**2 / y01),
        (r"u _ { 3 1 } ^ { \prime \prime }", upp31),
        (r"u''_{31} - u_{31}^{''}", sympy.Integer(0)),
        (r"-x y + 2 x / D", 2 * x / D - x * y),
        (r"x y / D u_1", x * y / (D * u1)),
        (r"\{ x (1 - y) + \zeta_{11} [x - y] \} / D", (x * (1 - y) + z11 * (x - y)) / D),
        (r"\left( x \right)^{2} \cdot y", x**2 * y),
        (r"(x + y)^{10}", (x + y) ** 10),
        (r"b_0^1 + b_0", sympy.Symbol("r10") + sympy.Symbol("b0")),
        (r"\begin{bmatrix} x & 0 \\ 1 & y \end{bmatrix}^T", Matrix([[x, 1], [0, y]])),
        (r"\mathbf{u}^T \mathbf{M} \mathbf{u}", mu1 + mu2 * u1**2 + u2**2),
        (r"\mathbf{M}^{-1} \mathbf{u}", vector(1 / mu1, u1 / mu2, u2)),
        (r"[\mathbf{u} (\mathbf{M} \mathbf{u})]", Matrix([[1, mu1], [u1, mu2 * u1], [u2, u2]])),
        (r"\begin{vmatrix} x & y \\ 1 & 2 \end{vmatrix}", 2 * x - y),
        (r"\det(\mathbf{M})", mu1 * mu2),
        (r"(\mathbf{u} \times \mathbf{M} \mathbf{u}) \cdot \mathbf{u}", sympy.Integer(0)),
        (r"[x \quad y / D \ 1]", Matrix([[x, y / D, 1]])),
        (r"1 - x &\quad + y", 1 - x + y),
    ],
)
def test_formulas_are_read(latex, expected):
    (side,) = read_formula(latex, SYMBOLS)
    assert same(side(), expected)


def test_blocks_make_one_matrix():
    (side,) = read_formula(r"\begin{bmatrix} \mathbf{M} & \mathbf{u} \\ 0 & x \end{bmatrix}", SYMBOLS)
    expected = Matrix([[mu1, 0, 0, 1], [0, mu2, 0, u1], [0, 0, 1, u2], [0, 0, 0, x]])
    assert side() == expected


@for_each(
    "latex",
    [
        *("", "x +", r"\frac{x}", r"\mathbf{q} x", r"\frac{x}{0}", r"\mathbf{M} + x", r"x / \mathbf{u}"),
        *(r"\begin{bmatrix} 1 & \\ x & y \end{bmatrix}", r"\begin{bmatrix} 1 & 2 \\ 3 \end{bmatrix}"),
        *(r"\sum x", r"\infty", "x ? y", "(" * 500),
    ],
)
def test_what_is_no_formula_is_refused(latex):
    with pytest.raises(UnreadableError):
        [side() for side in read_formula(latex, SYMBOLS)]


def test_a_side_that_cannot_be_read_hides_no_other():
    left, right = read_formula(r"\mathbf{q} = x + 1", SYMBOLS)
    assert right() == x + 1
    with pytest.raises(UnreadableError, match=r"no table of symbols has \\mathbf\{q\}"):
        left()


@pytest.mark.parametrize(
    ("latex", "reason"),
    [
        (r"\mathbf{u} + \mathbf{u}^T", r"shapes \(3,\) and \(1, 3\) cannot be added"),
        (r"x - \mathbf{M}", r"shapes \(\) and \(3, 3\) cannot be added"),
        (r"\mathbf{u}^2", r"shape \(3, 1\) cannot be raised to the power 2"),
        (r"(\mathbf{u} \mathbf{u}^T)^y", r"shape \(3, 3\) cannot be raised to the power y"),
        (r"x^{\mathbf{M}}", r"an exponent must be a number, got a matrix"),
    ],
)
def test_what_has_no_value_is_refused_with_the_reason(latex, reason):
    with pytest.raises(UnreadableError, match=reason):
        [side() for side in read_formula(latex, SYMBOLS)]


def test_looks_do_not_matter():
    left, right = read_formula(r"\left( y _ { 0 1 } \right) &= \, 2.", SYMBOLS)
    assert (left(), right()) == (y01, 2)


def test_equal_formulas_pass_and_slips_fail():
    claim = declared("identity", (mu1 - 1) * up1 / y01)
    assert status(claim, r"\tau = \frac{(\mu_1 - 1) u_1'}{y_{01}}") == "equal"
    for tampered in (
        r"\tau = \frac{(\mu_1 + 1) u_1'}{y_{01}}",
        r"\tau = \frac{(\mu_2 - 1) u_1'}{y_{01}}",
        r"\tau = \frac{(\mu_1 - 1) u_1''}{y_{01}}",
        r"\tau = \frac{(\mu_1 - 1) u_1}{y_{01}}",
        r"\tau = \frac{y_{01}}{(\mu_1 - 1) u_1'}",
        r"\tau = \frac{(\mu_1 - 1) u_1'}{y_{02}}",
        r"\tau = (\mu_1 - 1) u_1'",
    ):
        assert status(claim, tampered) == "failed"


@pytest.mark.parametrize(
    ("printed", "latex", "slips"),
    [
        (sympy.cos(x), r"\cos x", [r"\sin x", r"-\cos x", r"\cos y", r"\cos 2 x", r"\tan x"]),
        (sympy.tan(x), r"\frac{\sin x}{\cos x}", [r"\frac{\cos x}{\sin x}", r"\frac{\sin x}{\cos y}"]),
        (sympy.sin(x + y), r"\sin(x + y)", [r"\sin(x - y)", r"\cos(x + y)", r"\sin x + y"]),
        (
            sympy.sqrt(x**2 + y**2),
            r"\sqrt{x^2 + y^2}",
            [r"\sqrt{x^2 - y^2}", r"-\sqrt{x^2 + y^2}", "x^2 + y^2", "x + y"],
        ),
        (x, "x", [r"\sqrt{x^2}", r"\sin x"]),
        (
            Matrix([[sympy.cos(x), -sympy.sin(x)], [sympy.sin(x), sympy.cos(x)]]),
            r"\begin{bmatrix} \cos x & -\sin x \\ \sin x & \cos x \end{bmatrix}",
            [
                r"\begin{bmatrix} \cos x & \sin x \\ -\sin x & \cos x \end{bmatrix}",
                r"\begin{bmatrix} \cos x & -\sin x \\ \sin x & \sin x \end{bmatrix}",
            ],
        ),
    ],
)
def test_real_functions_are_compared_and_slips_fail(printed, latex, slips):
    claim = declared("identity", printed)
    assert status(claim, latex) == "equal"
    assert [status(claim, slip) for slip in slips] == ["failed"] * len(slips)


def test_nothing_derived_is_used():
    claim = declared("identity", D * x, where={D: over(1, x)})
    assert status(claim, "D x") == "equal"
    assert status(claim, "1") == "failed"


def test_pieces_sides_and_cells_are_taken_in_order():
    claim = declared("identity", vector(x, y))
    assert status(claim, "a = x", "b = y") == "equal"
    assert status(claim, "b = y", "a = x") == "failed"
    assert status(claim, "a = x = y", sides=(1, 2)) == "equal"
    assert status(claim, "a = x = y", sides=(2, 1)) == "failed"
    assert status(claim, "$x$\t$y$") == "equal"
    assert status(claim, "$y$\t$x$") == "failed"


def test_expressions_stand_beside_each_other_where_the_quote_says_so():
    claim = declared("identity", Matrix([[x, y], [1, 2]]))
    assert status(claim, "a^T = (x, 1)", "b^T = (y, 2)", beside="columns") == "equal"
    assert status(claim, "a^T = (x, y)", "b^T = (1, 2)", beside="rows") == "equal"
    assert status(claim, "a^T = (x, 2)", "b^T = (y, 1)", beside="columns") == "failed"
    assert status(claim, "a^T = (x, 1)", "b = y", beside="columns") == "failed"


def test_a_matrix_is_not_its_transpose():
    claim = declared("identity", Matrix([[x, y], [1, 2]]))
    assert status(claim, r"\begin{bmatrix} x & y \\ 1 & 2 \end{bmatrix}") == "equal"
    assert status(claim, r"\begin{bmatrix} x & 1 \\ y & 2 \end{bmatrix}") == "failed"


def test_equations_and_their_coefficients():
    assert status(declared("identity", x - y), "x = y", equation=True) == "equal"
    assert status(declared("identity", x + y), "x = y", equation=True) == "failed"
    row = declared("up_to_scale", vector(mu1 - 1, -u2, -1))
    assert status(row, r"(\mu_1 - 1) x - u_2 y = 1", equation=True, coefficients=("x", "y", "1")) == "equal"
    assert status(row, r"(\mu_1 - 1) x + u_2 y = 1", equation=True, coefficients=("x", "y", "1")) == "failed"
    assert status(row, r"(\mu_1 - 1) x - u_2 y + x y = 1", equation=True, coefficients=("x", "y", "1")) == "failed"
    assert status(row, r"(\mu_1 - 1) x - u_2 y = 1", equation=True, coefficients=("x", "y", "-1")) == "failed"


def test_indices_run_over_their_values():
    claim = declared("identity", vector(u1 * mu1, u2 * mu2))
    assert status(claim, r"u_i \mu_i", indices={"i": ("1", "2")}) == "equal"
    assert status(claim, r"u_i \mu_i", indices={"i": ("2", "1")}) == "failed"


def test_printed_numbers_stand_in_their_order():
    section = Section("demo", "1", "Thirds")
    claims = [
        section.numeric(f"1/t#{k}", "", printed=text, derived=over(1, 3)) for k, text in enumerate(("0.333", "0.33"))
    ]

    def found(text):
        quote = Quote(tuple(claim.number for claim in claims), 1, (text,))
        return [audited(claim, Quotations("", {claim.number: quote}), SYMBOLS, claims).status for claim in claims]

    assert found("7\t0.333\t0.33") == ["number", "number"]
    for tampered in ("7\t0.33\t0.333", "0.333\t-0.33", "0.334\t0.33", "0.333\t0.330", "0.3333\t0.33", "0.333"):
        assert set(found(tampered)) == {"failed"}


def test_numbers_are_found_as_they_are_printed():
    assert [str(number) for number in numbers_in("±.022 & - 0.50 & 1,64746 & (1, 2)")] == [
        *("0.022", "-0.50", "1.64746"),
        *("1", "2"),
    ]


def test_counts_and_references_are_found_in_words():
    section = Section("demo", "1", "Counts")
    count = section.count("1/c", "", printed=5, derived=vector(x), variables=(x,))
    assert status(count, "where only five homologous points are needed") == "number"
    assert status(count, "rank(C) = 5") == "number"
    assert status(count, "where only fifteen or 25 points are needed") == "failed"
    reference = section.reference("1/ref", "", printed="1.3.5", meant="1.3.8")
    assert status(reference, "according to (1.3.5) from") == "number"
    assert status(reference, "according to (1.3.51) and (11.3.5)") == "failed"


def test_a_claim_without_quote_must_say_why():
    claim = declared("identity", x)
    assert audited(claim, Quotations(), SYMBOLS).status == "failed"
    assert audited(claim, Quotations(unquoted={"1.1": "implied"}), SYMBOLS).status == "unquoted"
    assert audited(claim, Quotations(beyond=True), SYMBOLS).status == "unquoted"


def test_an_illegible_claim_must_say_why_its_quote_is_not_parsed():
    section = Section("demo", "1", "Squares")
    claim = section.identity(
        "1.1", "", printed=None, derived=x, expect="illegible", corrected=x, note="A sign is lost."
    )
    assert status(claim, "y = x") == "failed"
    assert status(claim, "y = x", unparsed="illegible") == "quoted"


def test_a_quote_must_begin_on_its_line(tmp_path):
    file = tmp_path / "paper.txt"
    file.write_text("title\n\n$$x = y + 1$$ and\n$$z = x\n- 1$$\n", encoding="utf-8")
    assert misplaced(Quote(("1.1",), 3, ("x =  y+1",)), file) == ""
    assert misplaced(Quote(("1.1",), 4, ("z = x - 1",)), file) == ""
    assert misplaced(Quote(("1.1",), 3, ("x = y", "z = x")), file) == ""
    assert "begins on line 3" in misplaced(Quote(("1.1",), 2, ("x = y + 1",)), file)
    assert "does not occur" in misplaced(Quote(("1.1",), 3, ("x = y - 1",)), file)
    assert "begins on line 3" in misplaced(Quote(("1.1",), 4, ("z = x", "x = y")), file)
    with pytest.raises(DeclarationError, match=r"expected the file other\.txt"):
        misplaced(Quote(("1.1",), 3, ("x",)), tmp_path / "other.txt")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("[[quote]]\nclaims = ['1']\nline = 1\n", "expected latex"),
        ("[[quote]]\nclaims = ['1']\nlatex = 'x'\n", "expected claims and a line"),
        ("[[quote]]\nclaims = ['1']\nlatex = 'x'\nline = 1\nunparsed = 'lazy'\n", "expected unparsed to be one of"),
        ("[[quote]]\nclaims = ['1']\nlatex = 'x'\nline = 1\nunparsed = 'unread'\n", "expected also why"),
        ("[[quote]]\nclaims = ['1']\nlatex = 'x'\nline = 1\nbeside = 'cells'\n", "expected beside to be one of"),
        ("[[quote]]\nclaims = ['1']\nlatex = 'x'\nline = 1\nside = 1\n", "expected keys of"),
        ("[[quote]]\nclaims = ['1', '1']\nlatex = 'x'\nline = 1\n", "quoted once"),
        ("[[unquoted]]\nclaims = ['1']\nreason = 'lazy'\n", "expected a reason of"),
        ("[[quote\n", "expected TOML"),
    ],
)
def test_a_malformed_file_of_quotes_is_refused(content, message, tmp_path):
    (tmp_path / "quotes.toml").write_text(content, encoding="utf-8")
    with pytest.raises(DeclarationError, match=message):
        quotations(tmp_path)


def test_quotes_are_read_from_a_file_for_each_section(tmp_path):
    (tmp_path / "quotes").mkdir()
    (tmp_path / "quotes.toml").write_text("source = 'demo.txt'\n", encoding="utf-8")
    for section, line in (("1.10", 90), ("1.9", 40), ("2", 95)):
        quote = f"[[quote]]\nclaims = ['{section}.1']\nline = {line}\nlatex = 'x'\n"
        (tmp_path / "quotes" / f"{section}.toml").write_text(quote, encoding="utf-8")
    found = quotations(tmp_path)
    assert found.source == "demo.txt"
    assert [(number, quote.line) for number, quote in found.quotes.items()] == [
        ("1.9.1", 40),
        ("1.10.1", 90),
        ("2.1", 95),
    ]
    (tmp_path / "quotes" / "3.toml").write_text("[[unquoted]]\nclaims = ['2.1']\nreason = 'implied'\n")
    with pytest.raises(DeclarationError, match=r"quoted once, got \['2.1'\] twice"):
        quotations(tmp_path)


# The papers.  Where their files are given, the quotes are looked up in them as well.


@pytest.fixture(scope="module")
def papers():
    folder = os.environ.get("ALGEBROPROJ_PAPERS")
    return Path(folder) if folder else None


@pytest.fixture(scope="module")
def findings(papers):
    return tuple(audit(located(), papers))


def test_every_claim_of_the_papers_is_audited_or_says_why_not(findings):
    assert [f"{f.claim.paper}:{f.claim.number} {f.reason}" for f in findings if f.status == "failed"] == []
    assert len(findings) == len(select())


def test_only_what_goes_beyond_the_papers_is_without_a_quote(findings):
    without = [f.claim for f in findings if f.status == "unquoted" and f.reason != "beyond"]
    assert len(without) <= 2
    assert not any(f.quote for f in findings if f.reason == "beyond")


def test_no_quote_belongs_to_nothing():
    assert stale(located()) == []


@pytest.mark.parametrize("paper", [paper for paper in installed_papers() if paper != "bridges"])
def test_each_quote_stands_in_the_file_of_its_section_in_the_order_of_the_paper(paper, repository):
    sections = {claim.number: claim.section for claim in select((paper,))}
    folder = repository / "derivations" / paper
    assert "quote" not in tomllib.loads((folder / "quotes.toml").read_text(encoding="utf-8"))
    files = sorted((folder / "quotes").iterdir())
    for file in files:
        text = file.read_text(encoding="utf-8")
        entries = [entry for found in tomllib.loads(text).values() for entry in found]
        claims = [number for entry in entries for number in entry.get("claims", ())]
        claims += [
            number
            for entry in entries
            if "name" in entry
            for number in sections
            if number.startswith(f"{entry['name']}#")
        ]
        assert claims
        assert {sections[number] for number in claims} == {file.stem}, file
        lines = [int(line) for line in re.findall(r"(?m)^line = (\d+)$", text)]
        assert lines == sorted(lines), file
        assert len(lines) == text.count("[[quote]]") + text.count("[[table]]")


def test_most_of_what_the_papers_print_is_audited_by_machine(findings):
    about = [f for f in findings if f.reason != "beyond"]
    by_machine = [f for f in about if f.status in ("equal", "number")]
    assert len(by_machine) > 0.78 * len(about)
    formulas = [f for f in about if f.reason not in ("prose", "illegible")]
    assert len(by_machine) > 0.94 * len(formulas)


def test_the_documentation_has_the_figures(findings, repository):
    text = (repository / "docs" / "explanation" / "transcription.md").read_text(encoding="utf-8")
    for paper, counts in audit_counts(findings).items():
        cells = [counts[name] for name in ("equal", "number", "unread", "illegible", "prose", "beyond", "unquoted")]
        row = " | ".join(map(str, (f"`{paper}`", counts.total(), *cells, *audited_shares(counts))))
        assert f"| {row} |" in text
    for reason in ("unread", "illegible", "prose"):
        assert f"({sum(f.reason == reason for f in findings)})" in text


def test_words_are_quoted_sparingly(findings):
    quotes = {f.quote for f in findings if f.quote and f.quote.unparsed == "prose"}
    for quote in quotes:
        plain = re.sub(r"\$[^$]*\$", " ", " ".join(quote.pieces))
        assert len(re.findall(r"[A-Za-z]{2,}", plain)) <= 20, quote.text


def test_the_record_is_the_same_each_time(findings, papers):
    found = [finding for finding in findings if finding.claim.paper == "okamoto1981"]
    record = audit_record(found, papers is not None)
    again = audit_record(tuple(audit(located(("okamoto1981",)), papers)), papers is not None)
    assert json.dumps(record) == json.dumps(again)
    assert sum(record["summary"]["okamoto1981"].values()) == len(found)


def _again(finding, claim=None, quote=None):
    """Audit a finding's claim with another printed form or another quote."""
    folder = next(d.path.parent for d, c in located((finding.claim.paper,)) if c is finding.claim)
    chosen = quote or finding.quote
    claim = claim or finding.claim
    return audited(
        claim,
        Quotations("", {claim.number: chosen}),
        symbols_for(claim.section, claim.number, tables_in(folder)),
        [claim],
    ).status


def _differs(left, right):
    if isinstance(right, TextForm):
        return left != right
    left, right = ([e for form in (f if isinstance(f, tuple) else (f,)) for e in entries(form)] for f in (left, right))
    return not same(vector(*left), vector(*right)) and not same(vector(*left), -vector(*right))


def test_a_single_change_of_what_claims_say_is_printed_is_noticed(findings):
    sample = [f for f in findings if f.status == "equal"][::27]
    tried = 0
    for finding in sample:
        for mutant in mutants(finding.claim)[::7][:4]:
            if len(str(finding.claim.printed)) < 600 and _differs(mutant.form, finding.claim.printed):
                tried += 1
                assert _again(finding, replace(finding.claim, printed=mutant.form)) == "failed", mutant.change
    assert tried > 15


EXCHANGED = {"sin": "cos", "cos": "sin", "tan": "cos"}


def test_another_function_or_sign_than_the_paper_prints_is_noticed(findings):
    tried = set()
    for finding in findings[::2]:
        form = finding.claim.printed
        if finding.status == "equal" and isinstance(form, TextForm) and form.letters is None:
            for found in re.finditer(r"\b(sin|cos|tan)\(|(?<!\()- ?(?=[a-z])", form.text):
                changed = (
                    form.text[: found.start()]
                    + (f"{EXCHANGED[found[1]]}(" if found[1] else "+")
                    + form.text[found.end() :]
                )
                assert _again(finding, replace(finding.claim, printed=TextForm(changed))) == "failed", changed
                tried.add(finding.claim.number)
    assert len(tried) >= 5


def test_a_single_change_of_a_printed_number_is_noticed(findings):
    for finding in [f for f in findings if f.status == "number"][::40]:
        if isinstance(finding.claim.printed, Decimal) and len(finding.quote.claims) == 1:
            for mutant in mutants(finding.claim):
                assert _again(finding, replace(finding.claim, printed=mutant.form)) == "failed"


def test_a_lost_sign_in_a_quote_is_noticed(findings):
    def tampered(piece):
        left, equals, right = piece.rpartition("=")
        return left + equals + right.replace("-", "+", 1)

    sample = [
        f
        for f in findings
        if f.status == "equal" and f.quote.sides == (-1,) and not f.quote.equation and "-" in f.quote.pieces[0][-60:]
    ]
    changed = [(f, tampered(f.quote.pieces[0])) for f in sample[::6]]
    changed = [(f, piece) for f, piece in changed if piece != f.quote.pieces[0]]
    assert len(changed) > 10
    for finding, piece in changed:
        assert _again(finding, quote=replace(finding.quote, pieces=(piece, *finding.quote.pieces[1:]))) == "failed"


# The command.

MODULE = """
import sympy
from algebroproj_sym import Section
x, y = sympy.symbols("x y")
section = Section("lines", "1", "Lines")
section.identity("1.1", "sum", printed=x + 2 * y, derived=x + y + y)
section.identity("1/beyond/more", "more", printed=x, derived=x)
"""
QUOTES = """
source = "lines.txt"

[[quote]]
claims = ["1.1"]
line = 2
latex = 's = x + 2 \\eta'
"""
TABLE = """
[[table]]
claims = ["1"]

[table.letters]
'\\eta' = "y"
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "s1_lines.py").write_text(MODULE, encoding="utf-8")
    (tmp_path / "quotes.toml").write_text(QUOTES, encoding="utf-8")
    (tmp_path / "symbols.toml").write_text(TABLE, encoding="utf-8")
    (tmp_path / "lines.txt").write_text("On lines\n$$s = x + 2 \\eta$$\n", encoding="utf-8")
    return tmp_path


def run(*arguments):
    return CliRunner().invoke(main, ["audit", *map(str, arguments)], env={"ALGEBROPROJ_PAPERS": None})


def test_the_command_audits_a_folder_of_ones_own(folder):
    result = run(folder, "--papers", folder, "--format", "json")
    assert result.exit_code == 0, result.output
    record = json.loads(result.stdout)
    assert record["against the papers"] is True
    assert record["summary"] == {"lines": {"equal": 1, "beyond": 1}}
    assert record["findings"][0] == {
        **{"paper": "lines", "number": "1.1", "status": "equal", "reason": ""},
        **{"line": 2, "quote": "s = x + 2 \\eta"},
    }


def test_the_lines_that_a_claim_quotes_and_the_others_are_listed(folder):
    (folder / "lines.txt").write_text(
        "On lines\n$$s = x + 2 \\eta$$\n\n$$\n\\begin{bmatrix}\nx \\\\ y\n$$\n(1)\n", encoding="utf-8"
    )
    result = run(folder, "--papers", folder, "--coverage")
    assert result.exit_code == 0
    assert result.output == (
        "lines: claims quote 1 of 2 displays, and 1 of 5 lines with text\n"
        "  displays that no claim quotes, by first line: 4\n"
        "  other lines that no claim quotes: 1, 8\n"
    )
    lines = json.loads(run(folder, "--papers", folder, "--coverage", "--format", "json").stdout)["papers"]["lines"]
    assert [(line["number"], line["display"], line["claims"]) for line in lines] == [
        (1, None, []),
        (2, 2, ["1.1"]),
        (5, 4, []),
        (6, 4, []),
        (8, None, []),
    ]


def test_a_quote_of_several_lines_covers_all_of_them(tmp_path):
    file = tmp_path / "paper.txt"
    file.write_text("$$x = y\n+ 1\n+ 2$$ and\n$$z = x$$\n", encoding="utf-8")
    assert lines_of(Quote(("1.1",), 1, ("x = y + 1 + 2", "z = x")), file) == {1, 2, 3, 4}
    assert lines_of(Quote(("1.1",), 2, ("x = y",)), file) == set()


def test_coverage_needs_the_papers(folder):
    result = run(folder, "--coverage")
    assert result.exit_code == 2
    assert "--papers DIR" in result.output


def test_the_command_says_plainly_that_the_papers_are_not_there(folder):
    result = run(folder)
    assert result.exit_code == 0
    assert "not looked up in the papers" in result.output
    assert "100% of 1" in result.output


def test_the_command_fails_for_a_quote_that_the_paper_has_not(folder):
    (folder / "lines.txt").write_text("On lines\n\n$$s = x + 2 \\eta$$\n", encoding="utf-8")
    result = run(folder, "--papers", folder)
    assert result.exit_code == 1
    assert "begins on line 3" in result.output


def test_the_command_fails_for_a_slip_and_for_a_quote_of_nothing(folder):
    quotes = folder / "quotes.toml"
    quotes.write_text(QUOTES.replace("2 \\eta", "3 \\eta"), encoding="utf-8")
    result = run(folder)
    assert result.exit_code == 1
    assert "lines:1.1  the quote reads x + 3*y" in result.output
    quotes.write_text(QUOTES.replace('"1.1"', '"1.1", "1.2"'), encoding="utf-8")
    result = run(folder)
    assert result.exit_code == 1
    assert "quotes that belong to no claim: 1.2" in result.output


def test_explain_shows_the_quote(folder):
    result = CliRunner().invoke(main, ["explain", f"{folder}:1.1"])
    assert "quoted      line 2: s = x + 2 \\eta" in result.output


def test_a_damaged_place_is_read_as_its_edit_says():
    claim = declared("identity", up1 / mu1)
    assert status(claim, r"\frac{\xi}{\mu_1}") == "failed"
    assert status(claim, r"\frac{\xi}{\mu_1}", edits=(Edit(r"\xi", "u'_1", "a lost prime"),)) == "equal"
    assert status(claim, r"\frac{\xi}{\mu_1}", edits=(Edit(r"\xi", "u_2", "another letter"),)) == "failed"


@pytest.mark.parametrize(
    ("edit", "expected"),
    [
        ('{ scan = "z", read = "y", why = "" }', "edits of the quote"),
        ('{ scan = "", read = "y", why = "" }', "edits of the quote"),
        ('{ scan = "x", read = "y" }', "scan, read and why"),
    ],
)
def test_an_edit_of_something_else_is_refused(edit, expected, tmp_path):
    quote = f'[[quote]]\nclaims = ["1.1"]\nline = 1\nlatex = "x + 1"\nedits = [{edit}]\n'
    (tmp_path / "quotes.toml").write_text(f'source = "demo.txt"\n{quote}', encoding="utf-8")
    with pytest.raises(DeclarationError, match=expected):
        quotations(tmp_path)
