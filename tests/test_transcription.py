"""A claim without a printed form takes it from its quote: identical to the typed one, or a named error."""

import re
import tomllib
from decimal import Decimal

import pytest
import sympy

from algebroproj_sym.auditing.audit import audited
from algebroproj_sym.declaring import (
    BrokenModuleError,
    derivation_at,
    derivations_of,
    judge,
    quotations,
    statement_text,
)
from algebroproj_sym.expressions import TextForm, evaluate, over, symbols_of, vector
from algebroproj_sym.reading import symbols_for, tables_in
from algebroproj_sym.showing.arranging import as_declared, shown

HEAD = """
import sympy
from algebroproj_sym import Section
from algebroproj_sym.expressions import evaluate, over, symbols_of, vector
from algebroproj_sym.showing.arranging import as_declared, shown
section = Section("demo", "1", "Squares")
x, y = sympy.symbols("x y")
"""
SYMBOLS = r"""
[[table]]
symbols = { '\mathbf{u}' = "[[x], [y]]" }
[[table]]
claims = ["1.9"]
symbols = { 'z' = "x" }
"""
IDENTITY = 'section.identity("1.1", "", derived=x)'


@pytest.fixture
def declared(tmp_path):
    """Return a function that declares claims beside a quote."""

    def declare(calls, quote, claims=("1.1",), symbols=SYMBOLS):
        (tmp_path / "symbols.toml").write_text(symbols)
        (tmp_path / "quotes.toml").write_text(f"[[quote]]\nclaims = {list(claims)}\nline = 7\n{quote}\n")
        (tmp_path / "module.py").write_text(f"{HEAD}\n{calls}\n")
        (derivation,) = derivation_at(tmp_path / "module.py")
        return derivation.section.claims

    return declare


@pytest.mark.parametrize(
    ("call", "quote", "printed"),
    [
        (IDENTITY, r"latex = 'a = \frac{x}{y} + y^{\prime}'", "over(x, y) + yp"),
        (IDENTITY, "latex = 'x + 1 = y'\nsides = [0]", "x + 1"),
        (IDENTITY, "latex = 'x + 1 = y'\nequation = true", "x + 1 - y"),
        (IDENTITY, "latex = 'x = q'\nedits = [{ scan = 'q', read = 'y', why = 'worn' }]", "y"),
        ('section.identity("1.1", "", derived=vector(x, y))', r"latex = '\mathbf{u}'", "vector(x, y)"),
        ('section.identity("1.1", "", derived=vector(x, y))', "latex = ['a = x y', 'b = 2']", "vector(x*y, 2)"),
        ('section.identity("1.1", "", derived=vector(x, y))', "latex = 'a = 0'", "vector(0, 0)"),
        ('section.identity("1.1", "", derived=vector(x, y))', r"latex = 'a^T &= [x \ y]'", "vector(x, y)"),
        ('section.identity("1.1", "", derived=vector(x, y).T)', r"latex = 'a^T = [x \ y]'", "vector(x, y).T"),
        (
            'section.identity("1.1", "", derived=sympy.eye(3, 2))',
            "latex = ['a = 0', 'b = 0']",
            "vector(0, 0, 0) * vector(0, 0).T",
        ),
        ('section.definition("1.1", "")', "latex = 'a = x/y'", "over(x, y)"),
        ('section.definition("1.1", "")', "latex = 'a^T = (x, y)'\nbeside = 'columns'", "vector(x, y)"),
        (
            'section.identity("1.1", "", derived=sympy.eye(2))',
            "latex = ['a^T = (x, 1)', 'b^T = (y, 2)']\nbeside = 'columns'",
            "sympy.Matrix([[x, y], [1, 2]])",
        ),
        ('section.vanishing("1.1", "", derived=x * y)', "latex = ['x = 0', 'y = 0']\nsides = [0]", "(x, y)"),
        ('section.up_to_scale("1.1", "", derived=vector(x, y))', r"latex = '\mathbf{u}'", "vector(x, y)"),
    ],
)
def test_the_printed_form_is_the_one_that_the_quote_has(call, quote, printed, declared):
    x, y, yp = sympy.symbols("x y yp")
    wanted = eval(printed, {"x": x, "y": y, "yp": yp, "over": over, "vector": vector, "sympy": sympy})
    (claim,) = declared(call, quote)
    assert statement_text(claim.printed) == statement_text(wanted)


COLUMN = 'section.identity("1.1", "", derived=vector(x, y))'
TABLE = 'section.identity("1.1", "", derived=sympy.Matrix([[x, y], [1, 2], [3, 4]]))'


@pytest.mark.parametrize(
    ("call", "quote", "message"),
    [
        (COLUMN, r"latex = 'a = [x \ y]'", "shape"),
        (COLUMN, r"latex = '[x \ y]'", "shape"),
        (COLUMN, r"latex = 'a = \mathbf{u}^T'", "shape"),
        (TABLE, r"latex = ['a = 0', 'b = 0', 'c = 0']", "got 3 expressions"),
        (TABLE, r"latex = 'a = 0'", "got 1 expressions"),
        (TABLE, r"latex = ['a = (x, 1, 3)^T', 'b = (y, 2, 4)^T']", "got 2 expressions"),
        (TABLE, r"latex = ['a = (x, y)', 'b = (1, 2)', 'c = (3, 4)']", "got 3 expressions"),
    ],
)
def test_a_quote_is_not_given_the_shape_of_what_is_derived(call, quote, message, declared):
    with pytest.raises(BrokenModuleError, match=message):
        declared(call, quote)


@pytest.mark.parametrize(
    ("latex", "shown_as"),
    [
        (r"y + x", "y + x"),
        (r"3 (y - x) z", "3*(y - x)*z"),
        (r"-\frac{y - 1}{z y} + y/x", "-(y - 1)/(z*y) + y/x"),
        (r"(y - x)^2 \cdot z y^{\prime}", "(y - x)**2*z*yp"),
        (r"\begin{vmatrix} y & x \\ 1 & z \end{vmatrix}", "-x + y*z"),
    ],
)
def test_a_form_is_shown_in_the_order_of_print(latex, shown_as, declared):
    (claim,) = declared(IDENTITY, f"latex = 'a = {latex}'", symbols="")
    assert shown(as_declared(claim, "printed")) == shown_as


def test_the_sides_of_an_equation_and_the_entries_of_a_vector_keep_their_order(declared):
    (claim,) = declared(IDENTITY, "latex = 'y + x = z - a'\nequation = true", symbols="")
    assert shown(as_declared(claim, "printed")) == "y + x - (z - a)"
    call = 'section.identity("1.1", "", derived=vector(x, y))'
    for latex in (r"(y - x, 2 z y)^T", r"\begin{pmatrix} y - x \\ 2 z y \end{pmatrix}"):
        (claim,) = declared(call, f"latex = '{latex}'", symbols="")
        assert shown(as_declared(claim, "printed")) == "[y - x], [2*z*y]"


def test_factors_that_vanish_keep_their_order(declared):
    quote = "latex = ['y - x = 0', 'y z = 0']\nsides = [0]"
    (claim,) = declared('section.vanishing("1.1", "", derived=x * y)', quote, symbols="")
    assert shown(as_declared(claim, "printed")) == "(y - x, y*z)"


def test_claims_that_share_a_row_share_its_numbers(declared):
    calls = "\n".join(f'section.numeric("1.1#{i}", "", derived=over({i}, 4))' for i in (1, 2))
    shared = ("1.1#1", "1.1#2")
    found = declared(calls, "latex = '0,25 & -0.500'", shared)
    assert [claim.printed.as_tuple() for claim in found] == [Decimal(each).as_tuple() for each in ("0.25", "-0.500")]


def test_a_row_with_another_count_of_numbers_is_refused(declared):
    call = 'section.numeric("1.1", "", derived=over(1, 4))'
    with pytest.raises(BrokenModuleError, match="a number for each of 1 claims, got 3 in the quote on line 7"):
        declared(call, "latex = '1.25 & 2.00 & -0.500'")


@pytest.mark.parametrize(
    ("latex", "wanted"),
    [
        ("mu = 1 and nu = 0,25", "0.25"),
        ("mu'_1 = mu'_2 = 0.25", "0.25"),
        ("y_{01} = -0.25", "-0.25"),
        ("7 0.25", "0.25"),
    ],
)
def test_the_only_number_that_can_be_meant_is_taken(latex, wanted, declared):
    (claim,) = declared('section.numeric("1.1", "", derived=over(1, 4))', f'latex = "{latex}"')
    assert str(claim.printed) == wanted


COUNT = 'section.count("1.1", "", derived=vector(x, y), variables=(x, y))'
RANK = 'section.rank("1.1", "", derived=vector(x, y))'
REFERENCE = 'section.reference("1.1", "", meant="1.3.8")'


@pytest.mark.parametrize(
    ("call", "latex", "printed"),
    [
        (COUNT, "two independent ones", 2),
        (COUNT, "of $B_{15}$ only **11** are left", 11),
        (RANK, "(rank(P)=4), by (1.1.1)", 4),
        (REFERENCE, "as in (1.3.5) above", sympy.Matrix([[1, 3, 5]])),
    ],
)
def test_counts_and_references_are_read_from_the_words(call, latex, printed, declared):
    (claim,) = declared(call, f'latex = "{latex}"')
    assert claim.printed == printed


@pytest.mark.parametrize(
    ("call", "latex", "message"),
    [
        (COUNT, "some are independent", "one whole number, got 0"),
        (COUNT, "two of 11", "one whole number, got 2"),
        (RANK, "2.5 or 3/4 x_{7}", "one whole number, got 2"),
        (REFERENCE, "(1.3.5) and (1.3.6)", "one reference, got 2"),
    ],
)
def test_words_with_no_number_or_several_ones_are_refused(call, latex, message, declared):
    with pytest.raises(BrokenModuleError, match=f"claim demo:1.1, printed: expected {message}"):
        declared(call, f'latex = "{latex}"')


@pytest.mark.parametrize(
    ("quote", "message"),
    [
        ('latex = "x"\nunparsed = "illegible"', "line 7 is not read: the scan does not preserve"),
        ('latex = "x = z"\nsides = [4]', "line 7: the formula has 2 sides, and no side 4"),
        ("latex = 'a = x +'", "line 7, at character 7: the formula ends too early"),
        (r"latex = 'a = \mathbf{w}'", r"line 7, at character 5: no table of symbols has \\mathbf\{w\}"),
        ("latex = ['x', 'y']", "expected one expression, got 2 expressions in the quote on line 7"),
        ("latex = 'x^{9999999999}'", "line 7: "),
    ],
)
def test_a_quote_that_cannot_be_read_is_named_with_place_and_reason(quote, message, declared):
    with pytest.raises(BrokenModuleError, match=f"claim demo:1.1, printed: .*{message}"):
        declared(IDENTITY, quote)


def test_a_claim_with_neither_a_form_nor_a_quote_is_refused(declared):
    with pytest.raises(BrokenModuleError, match=r"claim demo:1.1, printed: expected .*files of quotes of .*, got"):
        declared(IDENTITY, 'latex = "x"', ("1.2",))


def test_a_misprint_in_the_quote_is_refuted(declared):
    (claim,) = declared('section.identity("1.1", "", derived=x + y)', 'latex = "x - y"')
    assert judge(claim).verdict == "false"
    assert judge(claim).counterexample


def test_a_table_for_other_claims_says_nothing(declared):
    calls = "\n".join(f'section.identity("{number}", "", derived=x)' for number in ("1.9", "1.8"))
    nine, eight = declared(calls, 'latex = "z"', ("1.9", "1.8"))
    assert (str(nine.printed), str(eight.printed)) == ("x", "z")


LETTERS = r"""
[[table]]
symbols = { '\mathbf{R}' = "[[r11, r12], [r21, r22]]", '\mathbf{0}' = "0" }
matrices = { '\mathbf{R}' = "R 3x3", '\mathbf{b}' = "b 3x1" }
"""


@pytest.mark.parametrize(
    ("quote", "text", "derived"),
    [
        (r"latex = '2 \mathbf{R}^T \mathbf{b}'", "2*R.T*b", "z"),
        (r"latex = '(\mathbf{b} \times \mathbf{b}) \cdot \mathbf{b}'", "dot(cross(b, b), b)", "z.T * z"),
        (r"latex = '\frac{\mu}{\nu} \mathbf{R}^{-1} \mathbf{b} - \mathbf{b}'", "-b + (mu*nu**-1)*R**-1*b", "z"),
        (r"latex = '\det(\mathbf{R}) \mathbf{b}'", "det(R)*b", "z"),
        (
            r"latex = '\begin{bmatrix} \mathbf{R} & \mathbf{b} \end{bmatrix}'",
            "block([R, b])",
            "z * z.T * z * [[1, 1, 1, 1]]",
        ),
        ("latex = '\\mathbf{b} = \\mathbf{R} \\mathbf{b}'\nsides = [0, 1]", "block([b, R*b])", "z * [[1, 1]]"),
        (r"latex = ['\mathbf{b} = \mathbf{0}', '\mathbf{R} \mathbf{b} = \mathbf{0}']", "0", "z"),
    ],
)
def test_a_quote_is_read_in_letters_where_the_derived_form_has_them(quote, text, derived, declared):
    derived = derived.replace("[[", "sympy.Matrix([[").replace("]]", "]])")
    call = f'z = sympy.MatrixSymbol("z", 3, 1)\nsection.identity("1.1", "", derived={derived})'
    (claim,) = declared(call, quote, symbols=LETTERS)
    folder = claim.source.folder
    assert str(claim.printed) == text
    assert judge(claim).verdict == "false"
    assert audited(claim, quotations(folder), symbols_for("1", "1.1", tables_in(folder))).status == "equal"


@pytest.mark.parametrize(
    ("latex", "stated", "shape"),
    [
        (r"z = \mathbf{R}^T \mathbf{b}", "R.T*b", (3, 1)),
        (r"\mathbf{b} = \mathbf{R} \mathbf{b} + \mathbf{b}", "R*b + b", (3, 1)),
        (r"\mathbf{b} = x", None, ()),
    ],
)
def test_a_definition_is_read_in_letters_where_it_names_matrices(latex, stated, shape, declared):
    (claim,) = declared('section.definition("1.1", "")', f"latex = '{latex}'", symbols=LETTERS)
    folder = claim.source.folder
    assert claim.stated.get("printed", None) == (stated and TextForm(stated, claim.letters))
    assert getattr(claim.printed, "shape", ()) == shape
    assert judge(claim).verdict == "definition"
    assert audited(claim, quotations(folder), symbols_for("1", "1.1", tables_in(folder))).status == "equal"


def test_an_audit_tells_letters_that_are_not_those_of_the_quote(declared):
    call = 'z = sympy.MatrixSymbol("b", 3, 1)\nsection.identity("1.1", "", printed=-z, derived=z)'
    (claim,) = declared(call, r"latex = '\mathbf{b}'", symbols=LETTERS)
    folder = claim.source.folder
    found = audited(claim, quotations(folder), symbols_for("1", "1.1", tables_in(folder)))
    assert (found.status, found.reason) == ("failed", "the quote reads b")


def test_a_broken_matrix_of_a_table_is_a_named_error(declared):
    with pytest.raises(BrokenModuleError, match=r"matrices, b: expected a name and a shape such as 'R 3x3', got 'b 3'"):
        declared(IDENTITY, 'latex = "x"', symbols="[[table]]\nmatrices = { b = 'b 3' }")


def test_a_broken_table_is_a_named_error(declared):
    with pytest.raises(BrokenModuleError, match=r"symbols.toml: expected keys of .*'sizes'.* got \['size'\]"):
        declared(IDENTITY, 'latex = "x"', symbols="[[table]]\nsize = 1")


def test_what_is_shown_of_a_quote_is_what_is_claimed():
    claims = [claim for derivation in derivations_of(["fundamentals1996"]) for claim in derivation.section.claims]
    quoted = [
        c
        for c in claims
        if c.source.argument("printed") is None
        and isinstance(c.printed, sympy.Expr | sympy.MatrixBase)
        and not c.letters
    ]
    assert len(quoted) > 100
    for claim in quoted:
        form = as_declared(claim, "printed")
        point = {symbol: sympy.Rational(7 * k + 5, k + 3) for k, symbol in enumerate(symbols_of([claim.printed]))}
        assert evaluate(form, point) == evaluate(claim.printed, point), claim.number


def indices(symbol):
    """The digits of a symbol or a name, those of superscripts first."""
    above = re.findall(r"\^\{?(\d+)", symbol)
    return "".join([*above, *re.findall(r"\d", re.sub(r"\^\{?\d+", "", symbol))])


def test_no_table_of_symbols_repairs_an_index_in_silence(repository):
    """What the scan or the press got wrong is an edit of the quote, with its reason; a table only gives names."""
    assert indices(r"b_1^0") == indices("r01") != indices("r10")
    assert indices(r"\mu_{13}'") != indices("mu31")
    named = [
        (path, symbol, name)
        for path in sorted((repository / "derivations").glob("*/symbols.toml"))
        for table in tomllib.loads(path.read_text(encoding="utf-8"))["table"]
        for symbol, name in table.get("symbols", {}).items()
        if name.isidentifier()
    ]
    assert len(named) > 50
    for path, symbol, name in named:
        assert indices(symbol) == indices(name), (path, symbol)
