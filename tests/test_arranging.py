"""Forms are shown as they are declared: with their order, their brackets and their names."""

import ast
import pickle

import pytest
import sympy
from cases import for_each
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym import Section
from algebroproj_sym.declaring import judge, select
from algebroproj_sym.expressions import Matrix, columns, entries, evaluate, inverse, over, symbols_of, vector
from algebroproj_sym.expressions.arranging import arranged, value_of
from algebroproj_sym.showing.arranging import as_declared, shown
from algebroproj_sym.showing.latex import latex
from algebroproj_sym.showing.naming import in_names, named_latex

x, y, z, a, f = sympy.symbols("x y z a f")
sums = st.recursive(
    st.sampled_from([x, y, z, sympy.Integer(2), sympy.Rational(-1, 3)]),
    lambda parts: st.one_of(
        st.tuples(parts, parts).map(sum),
        st.tuples(parts, parts).map(lambda pair: pair[0] * pair[1]),
        st.tuples(parts, parts).map(lambda pair: pair[0] - pair[1]),
        parts.map(lambda part: over(part, x**2 + 7)),
        parts.map(lambda part: part**2),
    ),
    max_leaves=12,
)


@pytest.fixture
def section():
    return Section("demo", "1", "Demonstration")


def value(expression):
    point = {symbol: sympy.Rational(3 * k + 5, k + 2) for k, symbol in enumerate(symbols_of([expression]))}
    return evaluate(expression, point)


def test_terms_and_factors_keep_their_order_and_brackets(section):
    claim = section.identity("1.1", "line", printed=3 * (y - x) + z / (y * x), derived=z / (x * y) + 3 * y - 3 * x)
    assert shown(as_declared(claim, "printed")) == "3*(y - x) + z/(y*x)"
    assert latex(as_declared(claim, "printed"), ordered=False) == r"3 \left(y - x\right) + \frac{z}{y x}"


def test_entries_of_matrices_keep_their_order(section):
    printed = Matrix([[y - x, 1], [over(a * f, a - f), -z - x]])
    claim = section.identity(
        "1.1",
        "matrix",
        printed=Matrix([[y - x, 1], [over(a * f, a - f), -z - x]]),
        derived=printed,
    )
    assert shown(as_declared(claim, "printed")) == "[y - x, 1], [a*f/(a - f), -z - x]"
    assert shown(as_declared(claim, "derived")) == shown(arranged(printed))


NAMED = Matrix([[y - x, 1]])


def test_entries_of_a_matrix_with_a_name_are_those_of_its_assignment(section):
    claim = section.identity("1.1", "a name", printed=NAMED, derived=NAMED)
    assert shown(as_declared(claim, "printed")) == "[y - x, 1]"


def test_columns_and_vectors_keep_their_order(section):
    claim = section.identity(
        "1.1", "columns", printed=columns(vector(y - x, 1), vector(2, z - y)), derived=Matrix([[y - x, 2], [1, z - y]])
    )
    assert shown(as_declared(claim, "printed")) == "[y - x, 2], [1, z - y]"


def test_factors_of_a_vanishing_claim_keep_their_order(section):
    claim = section.vanishing("1.1", "zeros", printed=(y - x, z), derived=z * (y - x))
    assert shown(as_declared(claim, "printed")) == "(y - x, z)"


def test_what_is_computed_is_in_the_order_of_sympy(section):
    claims = [section.identity(f"1.{j}", "loop", printed=sum([y, -x]) + j, derived=y - x + j) for j in range(3)]
    assert [shown(as_declared(claim, "printed")) for claim in claims] == ["-x + y", "-x + y + 1", "-x + y + 2"]


def test_a_name_that_has_another_meaning_by_now_is_not_believed(section):
    first = x
    claim = section.identity("1.1", "name", printed=first - a, derived=x - a)
    first = y
    assert shown(as_declared(claim, "printed")) == "x - a"
    assert first is y


def test_a_function_of_another_meaning_is_not_believed(section):
    over = lambda above, below: below / above  # noqa: E731
    claim = section.identity("1.1", "name", printed=over(z - x, y), derived=y / (z - x))
    assert value(as_declared(claim, "printed")) == value(claim.printed)


def test_a_claim_that_is_sent_elsewhere_leaves_its_source_behind_and_is_the_same_claim(section):
    claim = section.identity("1.1", "line", printed=y - x, derived=y - x)
    sent = pickle.loads(pickle.dumps(claim))
    assert sent.source is None
    assert sent == claim
    assert shown(as_declared(sent, "printed")) == "-x + y"
    assert judge(sent).verdict == "proved"


@given(sums)
def test_an_arranged_form_is_equal_and_reads_back(expression):
    form = arranged(expression)
    if symbols_of([expression]):
        assert value(form) == value(expression)
        assert value(value_of(form)) == value(expression)
    assert sympy.simplify(sympy.sympify(shown(form)) - expression.doit()) == 0


def test_the_forms_of_a_section_read_back_as_declared():
    found = select(["fundamentals1996:1.3"])
    own = 0
    for claim in found:
        for part in ("printed", "corrected"):
            form = getattr(claim, part)
            if isinstance(form, sympy.Expr):
                declared = as_declared(claim, part)
                own += declared != arranged(form)
                for shown_entry, entry in zip(entries(declared), entries(form), strict=True):
                    assert value(shown_entry) == value(entry), claim.number
    assert own > 10


def test_a_long_form_has_the_names_of_the_derivation():
    (claim,) = select(["fundamentals1996:1.4/type"])
    named = in_names(claim, "printed")
    assert named.text == "frame(seen_points[:3, :]) * core[:3, :] * inverse(A_X)"
    assert [meaning.name for meaning in named.meanings] == ["seen_points", "core", "A_X"]
    assert named_latex(named.written, named.source.names).endswith(r" {\mathbf{A}_{X}}^{-1}")


def test_names_are_explained_with_what_they_meant(section):
    A = Matrix([[x, 1], [0, y]])  # noqa: N806
    claim = section.identity("1.1", "product", printed=inverse(A) * A, derived=inverse(A) * A)
    named = in_names(claim, "printed")
    assert named.text == "inverse(A) * A"
    (meaning,) = named.meanings
    assert meaning.value == A


def test_a_name_that_is_also_a_symbol_explains_nothing(section):
    D = Matrix([[x, 1], [0, y]])  # noqa: N806
    claim = section.identity("1.1", "product", printed=D * D, derived=D * D, where={sympy.Symbol("D"): x})
    assert in_names(claim, "printed") is None


@for_each(
    ("written", "expected"),
    [
        ("(A + B) * C", r"\left(\mathbf{A} + \mathbf{B}\right) \mathbf{C}"),
        ("A - (B - C)", r"\mathbf{A} - \left(\mathbf{B} - \mathbf{C}\right)"),
        ("-A * B", r"-\mathbf{A} \mathbf{B}"),
        ("(A * B).T", r"\left(\mathbf{A} \mathbf{B}\right)^{T}"),
        ("inverse(A_X)", r"{\mathbf{A}_{X}}^{-1}"),
        ("P_star", r"\mathbf{P}^{*}"),
        ("P_star_of_rays", r"\mathbf{P}^{*}_{\text{of rays}}"),
        ("A[1:, 0]", r"{\mathbf{A}}\text{[1:, 0]}"),
        ("frame(g)", r"\text{frame}\left(g\right)"),
        ("mu_u_right", r"\mu_{\text{u right}}"),
        ("columns(-A * B, C)", r"\left[\begin{matrix} -\mathbf{A} \mathbf{B} & \mathbf{C} \end{matrix}\right]"),
        ("over(a, b) ** 2", r"\left(\frac{a}{b}\right)^{2}"),
    ],
)
def test_names_as_latex(written, expected):
    matrices = dict.fromkeys(("A", "B", "C", "A_X", "P_star", "P_star_of_rays"), sympy.eye(2))
    assert named_latex(ast.parse(written, mode="eval").body, matrices) == expected
