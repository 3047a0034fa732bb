"""Reading a document: what is understood, what each verdict rests on, and that no true equation is called wrong."""

import contextlib
import json
import random
import re

import pytest
import sympy
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_sym.cli import main
from algebroproj_sym.expressions import evaluate, over
from algebroproj_sym.proving import prove
from algebroproj_sym.reading import (
    SymbolsFile,
    UnreadableDocumentError,
    UnreadableError,
    document_at,
    document_of,
    read_document,
    read_formula,
    symbols_file,
)
from algebroproj_sym.reading.documents.displays import MAX_FORMULAS
from algebroproj_sym.reading.documents.statements import statements
from algebroproj_sym.reading.lexing.names import split_symbol
from algebroproj_sym.reading.lexing.pieces import pieces_of
from algebroproj_sym.reading.parsing.grammar import parsed
from algebroproj_sym.reading.parsing.writing import text_of
from algebroproj_sym.replaying import replay_claim

pytestmark = pytest.mark.usefixtures("decided_here")

A, B, C, X, Y = sympy.symbols("a b c x y")


def plain(symbol):
    letter, primes, below, above = split_symbol(symbol)
    letter = letter.removeprefix("\\")
    return sympy.Symbol(letter + below + "p" * primes) if letter in ("theta", *"abcxky") and not above else None


def value(latex):
    (side,) = read_formula(latex, plain)
    return side()


def text(latex):
    found = parsed(latex, functions=frozenset())
    return text_of(found.sides[0], lambda name: name)


def readings(latex, given=None, **options):
    return read_document(document_of(latex, **options), given)


def verdicts(latex, given=None):
    return [each.verdict for each in readings(latex, given)]


# Formulas.


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\frac12 x", X / 2),
        (r"\frac1{2x}", over(1, 2 * X)),
        (r"\tfrac{a}{b}c", over(A, B) * C),
        (r"2^{10}", 1024),
        (r"x^{-2}", over(1, X**2)),
        (r"x^\frac12", sympy.sqrt(X)),
        (r"\sqrt[3]{x}", sympy.root(X, 3)),
        (r"\cos\theta\sin\theta", sympy.cos(sympy.Symbol("theta")) * sympy.sin(sympy.Symbol("theta"))),
        (r"\cos^2 x + \sin^{2}(x)", sympy.cos(X) ** 2 + sympy.sin(X) ** 2),
        (r"\sin 2x", sympy.sin(2 * X)),
        (r"\sin^{-1} x", sympy.asin(X)),
        (r"\operatorname{atan2}(y, x)", sympy.atan2(Y, X)),
        (r"\mathrm{arctan}\frac{y}{x}", sympy.atan(over(Y, X))),
        (r"\left| a \right| |b|", sympy.Abs(A) * sympy.Abs(B)),
        (r"\left. a \right.", A),
        (r"a \, b \; c~x", A * B * C * X),
        (r"a \times b \cdot c", A * B * C),
        (r"3! a", 6 * A),
        (r"0.25 a", A / 4),
        (r"x''_{k}", sympy.Symbol("xkpp")),
        (r"\det \begin{pmatrix} a & b \\ c & x \end{pmatrix}", A * X - B * C),
        (r"\operatorname{tr}\begin{pmatrix} a & b \\ c & x \end{pmatrix}", A + X),
        (r"\left|\begin{array}{cc} a & b \\ c & x \end{array}\right|", A * X - B * C),
    ],
)
def test_formulas_become_expressions(latex, expected):
    assert value(latex).doit() == sympy.sympify(expected).doit()


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"f(x)", "f(x)"),
        (r"f(x, y) + a(b + c)", "f(x, y) + a*(b + c)"),
        (r"\sum_{i=1}^{n} x_i + 1", r"[\sum_{i=1}^{n}](x_i) + 1"),
        (r"\int_0^1 x^2 \,\mathrm{d}x", r"[\int_{0}^{1}](x**2*d x)"),
        (r"\frac{\partial f}{\partial x}", r"\partialf/\partialx"),
        (r"\frac{d}{dt} x", r"[d/dt](x)"),
        (
            r"\begin{cases} x & \text{if } x > 0 \\ 0 & \text{otherwise} \end{cases}",
            "Piecewise((x, if x > 0), (0, otherwise))",
        ),
        (r"\hat{\mathbf{x}}_{k}^\top \mathbf{y}", r"\hat{\mathbfx}_k.T*\mathbf{y}"),
        (r"\|\mathbf{x}\|^2", r"norm(\mathbf{x})**2"),
        (r"[\mathbf{t}]_\times", r"hat(\mathbf{t})"),
        (r"\boldsymbol{\omega}^\wedge", r"hat(\mathbf{\omega})"),
        (r"{\bf r}'_{A}", r"\mathbf{r}_A'"),
        (r"a \pm b", "a ± b"),
        (r"\left(a b\right)_x", "(a*b)_x"),
    ],
)
def test_what_is_not_computed_is_read(latex, expected):
    assert text(latex) == expected


@pytest.mark.parametrize(
    ("latex", "message", "place"),
    [
        (r"a + ", "ends too early", 2),
        (r"(a + b", "not closed", 5),
        (r"a) + b", "never opened", 1),
        (r"\frac{a}", "expected an argument", 7),
        ("{" * 100 + "}" * 100, "levels of nesting", None),
        ("(" * 100 + "x" + ")" * 100, "levels of nesting", None),
        ("9" * 2000, "at most 1000 digits", 0),
    ],
)
def test_where_reading_stops_is_said(latex, message, place):
    with pytest.raises(UnreadableError, match=message) as error:
        parsed(latex, functions=frozenset())
    assert place is None or error.value.place == place


@pytest.mark.parametrize("latex", ["9^{999999999}", r"(2^{900})^{900}", "(-1)!", r"\frac{1}{0}", r"\mathbf{x} + a"])
def test_what_has_no_value_is_refused(latex):
    with pytest.raises(UnreadableError):
        read_formula(latex, lambda name: None if "mathbf" in name else plain(name))[0]()


trees = st.recursive(
    st.sampled_from(["a", "b", "x_{1}", "2", "3"]),
    lambda inner: st.tuples(st.sampled_from("+-*/"), inner, inner),
    max_leaves=6,
)


def printed(tree):
    """Return LaTeX and the expression that it means, made side by side."""
    if isinstance(tree, str):
        return tree, sympy.Symbol("x1") if "_" in tree else sympy.sympify(tree)
    sign, left, right = tree
    (first, one), (second, two) = printed(left), printed(right)
    if sign == "/":
        return rf"\frac{{{first}}}{{{second}}}", over(one, two)
    if sign == "*":
        return rf"\left({first}\right)\left({second}\right)", one * two
    return rf"\left({first} {sign} {second}\right)", one + two if sign == "+" else one - two


@given(trees)
def test_what_is_printed_is_what_is_read(tree):
    try:
        latex, meant = printed(tree)
    except ZeroDivisionError:
        return
    read = value(latex)
    point = dict(zip(sympy.symbols("a b x1"), map(sympy.Rational, ("3/7", "-5/3", "11/2")), strict=True))
    with contextlib.suppress(ZeroDivisionError):
        assert evaluate(read, point) == evaluate(meant, point)


# Documents.


def test_displays_of_every_kind_are_found_with_lines_and_numbers():
    latex = r"""\documentclass{article}
\newcommand{\half}[1]{\frac{#1}{2}} \def\be{\begin{equation}} \def\ee{\end{equation}}
% \[ hidden = 1 \]
\begin{verbatim} \[ code = 1 \] \end{verbatim}
\begin{equation} a = \half{b} \label{eq:a} \end{equation}
\[ c = 1 \]
$$ d = 2 \tag{X} $$
\begin{align} e &= 1 \\ f &= 2 \nonumber \\ g &= 3 \end{align}
\be h = 1 \ee
\begin{subequations} \begin{equation} k = 1 \end{equation} \begin{equation} l = 2 \end{equation} \end{subequations}
\begin{gather*} m = 1 \\ n = 2 \end{gather*}
\begin{multline} p = 1 \\ + 2 \end{multline}
"""
    found = [(each.display.line, each.number, each.latex) for each in statements(document_of(latex))]
    assert found == [
        (5, "1", r"a = \frac{b}{2}"),
        (6, "", "c = 1"),
        (7, "X", "d = 2"),
        (8, "2", "e = 1"),
        (8, "", "f = 2"),
        (8, "3", "g = 3"),
        (9, "4", "h = 1"),
        (10, "5a", "k = 1"),
        (10, "5b", "l = 2"),
        (11, "", "m = 1"),
        (11, "", "n = 2"),
        (12, "6", "p = 1  + 2"),
    ]


@pytest.mark.parametrize(
    "latex",
    [
        r"\mathbf{a} = b \times \mathbf{c} \times d",
        r"a = \left\lVert u - v \right\rVert",
        r"a = \left| u \right| + \left\| v \right\|",
        r"a = \bar x",
        r"a = \alpha\beta c",
    ],
)
def test_the_latex_of_a_statement_is_read_as_the_statement_is(latex):
    (printed,) = statements(document_of(rf"\[ {latex} \]"))
    again = pieces_of(printed.latex)
    assert [each.text for each in printed.pieces if each.text.strip()] == [
        each.text for each in again if each.text.strip()
    ]
    assert parsed(again) == parsed(printed.pieces)
    assert printed.latex.count(r"\left") == printed.latex.count(r"\right")


def test_rows_that_go_on_are_one_chain_and_equations_side_by_side_are_several():
    latex = r"""\begin{align} a &= b + c \\ &= c + b \\ &\quad + d - d \\ x &= 1 & y &= 2 \end{align}
    \[ u = v, \quad v = w \quad \text{for } w > 0, \qquad w_i = 1, \; i = 1, \ldots, n \]
    \[ r_j = s_j, \quad j = 1, 2, 3 \]"""
    stated = statements(document_of(latex))
    found = [(each.read, one.condition) for each, one in zip(readings(latex), stated, strict=True)]
    assert found == [
        ("a = b + c = c + b + d - d", ""),
        ("x = 1", ""),
        ("y = 2", ""),
        ("u = v", ""),
        ("v = w", "for w > 0"),
        ("w_i = 1", r"i = 1 \ldots n"),
        ("r_j = s_j", "j = 1 2 3"),
    ]


def test_markdown_and_notebooks_are_read_with_the_lines_of_the_file(tmp_path):
    markdown = "# Sums\n\n```\n$$ code = 1 $$\n```\nLet\n$$\na = b + c\n$$\n"
    (tmp_path / "a.md").write_text(markdown, encoding="utf-8")
    assert [(e.line, e.read) for e in read_document(document_at(tmp_path / "a.md"))] == [(7, "a = b + c")]
    cells = [
        {"cell_type": "code", "source": ["x = '$$ no = 1 $$'"], "metadata": {}},
        {"cell_type": "markdown", "source": ["Let\n", "$$ a = b $$"], "metadata": {}},
    ]
    (tmp_path / "a.ipynb").write_text(json.dumps({"cells": cells}, indent=1), encoding="utf-8")
    (found,) = read_document(document_at(tmp_path / "a.ipynb"))
    line = (tmp_path / "a.ipynb").read_text(encoding="utf-8").split("\n")[found.line - 1]
    assert found.read == "a = b"
    assert "$$ a = b $$" in line


def test_macros_that_the_code_of_a_notebook_has_written_are_known(tmp_path):
    shown = {"data": {"text/markdown": ["$\n", "\\def\\mf{\\mathbf}\n", "$$ c = 1 $$\n"]}}
    cells = [
        {"cell_type": "code", "source": ["load()"], "metadata": {}, "outputs": [shown]},
        {"cell_type": "markdown", "source": ["Let\n", "$$ \\mf r = f \\mf u + g \\mf v $$"], "metadata": {}},
    ]
    (tmp_path / "a.ipynb").write_text(json.dumps({"cells": cells}, indent=1), encoding="utf-8")
    (found,) = read_document(document_at(tmp_path / "a.ipynb"))
    assert found.read == "r = f*u + g*v"
    assert "mf r" in (tmp_path / "a.ipynb").read_text(encoding="utf-8").split("\n")[found.line - 1]


def test_a_file_that_is_no_document_is_refused_by_name(tmp_path):
    (tmp_path / "a.tex").write_bytes(b"\xff\xfe\xff")
    (tmp_path / "a.ipynb").write_text("[" * 50_000, encoding="utf-8")
    (tmp_path / "many.tex").write_text("$$ a $$" * (MAX_FORMULAS + 1), encoding="utf-8")
    for name in ("a.tex", "a.ipynb", "many.tex", "none.tex"):
        with pytest.raises(UnreadableDocumentError):
            document_at(tmp_path / name)


@pytest.mark.parametrize(
    "latex",
    [
        r"\newcommand{\a}{\a\a} \[ \a = 1 \]",
        r"\def\b{\c} \def\c{\b} \[ \b = 1 \]",
        r"\newcommand{\x}[1]{#1#1#1#1#1#1#1#1} \[ \x{\x{\x{\x{\x{\x{1}}}}}} = 1 \]",
        r"\[ x = " + "{" * 10**6 + "1" + "}" * 10**6 + r" \]",
        r"\[ x = " + "{" * 20_000 + "1" + "}" * 20_000 + r" \]",
        r"\[ x = " + r"\frac{1}{" * 5_000 + "1" + "}" * 5_000 + r" \]",
        r"\[ x = " + "x^{" * 9_000 + "1" + "}" * 9_000 + r" \]",
    ],
)
def test_what_has_no_end_is_not_read(latex):
    (found,) = readings(latex)
    assert found.verdict == "not read"
    assert found.reason


@pytest.mark.parametrize(
    "latex",
    [
        "9^{999999999} = 1",
        "9^{9^{9^9}} = 2",
        r"y = 2^{1000} \] \[ z = y^{1000} \] \[ z^{1000} = 1",
        "(10!)^{1000} = 1",
        r"\det\begin{pmatrix}"
        + r"\\".join("&".join(f"a_{{{i},{j}}}" for j in range(9)) for i in range(9))
        + r"\end{pmatrix} = 1",
    ],
)
def test_what_is_too_large_is_not_decided(latex):
    assert verdicts(rf"\[ {latex} \]")[-1] == "not decided"


# Verdicts.


def test_each_verdict_names_what_it_rests_on():
    found = readings(
        r"""\begin{equation} s = a + b \end{equation} \begin{equation} p = a b \end{equation}
        \begin{equation} s^2 - 4 p = (a - b)^2 \end{equation}"""
    )
    assert [each.verdict for each in found] == ["definition", "definition", "follows"]
    (link,) = found[2].links
    assert link.rests_on == ("(1), line 1", "(2), line 1")
    assert link.certificate["method"] == "normal form"


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ s = a + b \] \[ s^2 = a^2 + 2ab - b^2 \]",
        r"\[ y = (a + b)^2 = a^2 + 2ab + b^3 \]",
        r"\[ y = x_1 (x_1 + x_2) = x_1 x_1 + x_2 x_2 \]",
        r"\[ D := ad - bc \] \[ D = ad + bc \]",
        r"\[ D = ad - bc \] Hence \[ D = ad + bc \]",
        r"\[ M = \begin{pmatrix} a & b \\ c & d \end{pmatrix} \] \[ \det M = ad + bc \]",
        r"\[ f(x) = x^2 \] \[ f(x + 1) - f(x) = 2x - 1 \]",
        r"\[ 2^3 = 9 \]",
    ],
)
def test_what_contradicts_has_an_exact_point(latex):
    found = readings(latex)[-1]
    assert found.verdict == "contradicts"
    link = next(each for each in found.links if each.verdict == "contradicts")
    names = {n: sympy.Symbol(n) for n in link.counterexample}
    left, right = (sympy.sympify(side, names) for side in (link.asked[0].lhs, link.asked[0].rhs))
    point = {sympy.Symbol(name): sympy.Rational(number) for name, number in link.counterexample.items()}
    assert left.subs(point) != right.subs(point)


def test_the_smallest_change_is_suggested():
    (_, found) = readings(r"\[ s = a + b \] \[ s^2 = a^2 + 2ab - b^2 \]")
    assert found.links[0].suggestion == "a**2 + 2*a*b + b**2 instead of a**2 + 2*a*b - b**2"


INNOCENT = [
    r"\[ F = m a \] \[ F = -k x \]",
    r"\[ F = m a \] \[ F = m g \]",
    r"\[ T = \frac12 m v^2 \] \[ V = m g h \] \[ T = V \]",
    r"\[ x = a + b \] \[ x = a - b \]",
    r"\[ E = m c^2 + p \] For $p = 0$ this is \[ E = m c^2 \]",
    r"\[ (a + b)^2 = a^2 + b^2 \]",
    r"\[ y = r x (1 - x) = x \]",
    r"\[ y' = 2x - 2a = 0 \]",
    r"\[ n = 2 \] \[ n = 3 \]",
    r"\[ s = \frac13 \] \[ s = 0.333 \]",
    r"\[ p = (a + i b)(a - i b) = a^2 + b^2 \]",
    r"\[ \frac{dy}{dx} = 2x \] \[ y = x^2 \]",
    r"\[ y = x^2 \] \[ \frac{dy}{dx} = 2x \] \[ dy/dx = 2 x \]",
    r"\[ y = x^2 \] \[ \dot y = 2 x \dot x \]",
    r"\[ M = \begin{pmatrix} a & b \\ c & d \end{pmatrix} \] \[ \det M = 0 \] \[ \det M = 1 \]",
    r"\[ \mathbf{A}\mathbf{B} - \mathbf{B}\mathbf{A} = \mathbf{C} = \mathbf{0} \]",
    r"\[ f(x) = x^2 \] \[ f(x) = x \]",
    r"\[ s = a + b \] If the signs are opposite, \[ s^2 = a^2 - 2ab + b^2 \]",
    r"\[ r = \begin{cases} a & a > 0 \\ -a & a < 0 \end{cases} \] \[ r = -a \] \[ r^2 = a \]",
    r"\section{One} \[ D := a - b \] \section{Two} \[ D = a + b \]",
    r"\[ x^2 = a \] \[ x = 3 \] \[ a = 9 \] \[ a = x \]",
    r"\[ \sum_{i=1}^n x_i = n \bar{x} = 2 n \bar{x} - \sum_{i=1}^n x_i \]",
    r"\[ s = \sqrt{x^2} = x \]",
    r"\[ 1\,000 + 1 = 1\,001 \]",
    r"\[ \log 100 = 2 \]",
    r"\[ L := 10 \log P \] \[ P = 10^{L/10} \]",
    r"\[ 1\frac12 = \frac32 \]",
    r"\[ \ln 2^3 = 3 \ln 2 \]",
    r"\[ y := \ln x \] \[ 2 y = \ln(x)^2 \]",
    r"\[ s := \sin\theta \] \[ s = \sqrt{1 - \cos^2\theta} \] \[ c := \cos\theta \] \[ c = \sqrt{1 - s^2} \]",
    r"\[ y := \tan x \] \[ x = \arctan y \]",
    r"\[ y := x^2 \] \[ \sqrt{y} = x \]",
    r"\[ y := \sin k(x + t) \] \[ y = \sin(kx + kt) \]",
    r"\[ \sin 30^\circ = \frac12 \]",
    r"\[ \sqrt[3]{-8} = -2 \]",
    r"\verb|\[ 1 = 2 \]| and \verb+$$ 1 = 3 $$+",
    "\\iffalse\n\\[ 1 = 2 \\]\n\\fi",
    r"\begin{verbatim*} \[ 1 = 2 \] \end{verbatim*}",
    r"\[ 3 \text{ apples} + 4 = 7 \]",
    r"\[ 2\,\text{m} + 3\,\text{m} = 5\,\text{m} \]",
    r"\[ 10 \equiv 3 \ (7) \]",
    r"\[ (a + b)^2 \equiv a^2 + b^2 \]",
    r"\[ \nabla u \cdot r \equiv 0 \]",
    r"\[ 1024 = 1\;024 = 1~024 \]",
    r"\[ 100\,^\circ\mathrm{C} = 373\,\mathrm{K} \]",
]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("latex", INNOCENT)
def test_a_statement_that_may_be_true_is_never_called_a_contradiction(latex):
    assert "contradicts" not in verdicts(latex)


def test_nothing_is_decided_of_what_has_no_value():
    assert verdicts(r"\[ \sum_i x_i = \sum_j x_j \]") == ["not decided"]


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\[ (a \pm b)^2 = a^2 \pm 2ab + b^2 \]", "follows"),
        (r"\[ (a \pm b)(a \mp b) = a^2 - b^2 \]", "follows"),
        (r"\[ y = (a \pm b)^2 = a^2 \mp 2ab + b^2 \]", "independent"),
        (r"\[ a = b \pm c = b \mp c \]", "independent"),
        (r"\[ s := a + b \] \[ s = a \pm b \]", "independent"),
    ],
)
def test_two_signs_are_two_statements(latex, verdict):
    assert verdicts(latex)[-1] == verdict


@pytest.mark.parametrize(
    ("latex", "read"),
    [
        (r"\[ p^h = (u, v, 1) \]", "p_h = [[u, v, 1]]"),
        (r"\[ p^h = 2 h \]", "p**h = 2*h"),
        (r"\[ e^x = 2 \]", "e**x = 2"),
        (r"\[ \lim \limits_{l \to 0} l^2 = 0 \]", r"[\lim_{l\to0}](l**2) = 0"),
        (r"\[ \sum_i \lbrace a_i + b_i \rbrace = c \]", r"[\sum_{i}](a_i + b_i) = c"),
        (r"\[ 0_{2\times1} = x \]", "[[0], [0]] = x"),
        (r"\[ a = b \Rightarrow c = d \]", "c = d"),
        (r"\[ y = \underset{x}{\text{min.}} \:\: \lVert x \rVert \]", "y = [min._{x}](norm(x))"),
        (r"\[ y = \underset{x}{z} \]", None),
    ],
)
def test_what_print_means(latex, read):
    assert readings(latex)[-1].read == read


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \sin 2x = 2 \sin x \cos x \]",
        r"\[ A = \pi r^2 \] \[ C = 2 \pi r \] \[ A = \frac{C^2}{4\pi} \]",
        r"\[ c = \sqrt{a^2 + b^2} \] \[ c^2 = a^2 + b^2 \]",
        r"\[ N = N_0 e^{-\lambda t} \] \[ \ln\frac{N}{N_0} = -\lambda t \]",
        r"\[ \cosh x = \frac{e^x + e^{-x}}{2} \]",
        r"\[ \operatorname{artanh} x = \frac12 \ln\frac{1 + x}{1 - x} \]",
        r"\[ \ln 2^3 = 3 \ln 2 \]",
        r"\[ \ln(x)^2 = 2 \ln x \]",
        r"\[ 1\,000 + 1 = 1001 \]",
        r"\[ \sin 30^\circ = \cos 60^{\circ} \]",
        r"\[ R = \begin{pmatrix} \cos a & -\sin a \\ \sin a & \cos a \end{pmatrix} \]"
        r"\[ R R^T = \begin{pmatrix} 1 & 0 \\ 0 & 1 \end{pmatrix} \]",
    ],
)
def test_real_functions_are_decided(latex):
    assert verdicts(latex)[-1] == "follows"


@pytest.mark.parametrize(
    ("latex", "suggestion"),
    [
        (r"\[ g := \sin u \cos u \] \[ 2 g = \cos 2 u \]", "sin(2*u) instead of cos(2*u)"),
        (r"\[ h := \sqrt{a^2 + b^2} \] \[ h^2 = a^2 - b^2 \]", "a**2 + b**2 instead of a**2 - b**2"),
        (r"\[ N := N_0 e^{-k t} \] \[ \ln\frac{N}{N_0} = k t \]", "-k*t instead of k*t"),
        (r"\[ V := \frac43 \pi r^3 \] \[ 3 V = 3 \pi r^3 \]", "4 instead of 3"),
        (r"\[ q := \sin^2 u \] \[ q = 1 + \cos^2 u \]", "1 - cos(u)**2 instead of 1 + cos(u)**2"),
        (
            r"\[ R := \begin{pmatrix} \cos a & -\sin a \\ \sin a & \cos a \end{pmatrix} \]"
            r"\[ R^2 = \begin{pmatrix} \cos 2a & \sin 2a \\ \sin 2a & \cos 2a \end{pmatrix} \]",
            "-sin(2*a) instead of sin(2*a)",
        ),
    ],
)
def test_slips_in_real_functions_are_found(latex, suggestion):
    found = readings(latex)[-1]
    assert found.verdict == "contradicts"
    assert found.links[-1].counterexample
    assert found.links[-1].suggestion == suggestion


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ \exp(1) = E \]",
        r"\[ \sqrt{-1} = I \]",
        r"\[ \ln(-1) = I \pi \]",
        r"\[ \begin{pmatrix} \exp(1) \\ 2 \end{pmatrix} = \begin{pmatrix} E \\ 2 \end{pmatrix} \]",
        r"\[ \cos^{-1} x = \frac{1}{\cos x} \]",
        r"\[ e^2 = \exp(2) \]",
    ],
)
def test_no_letter_is_a_number_of_sympy(latex):
    assert "follows" not in verdicts(latex)


def test_what_stands_in_a_frame_is_read():
    assert verdicts(r"\[ \boxed{(a + b)(a - b) = a^2 - b^2} \]") == ["follows"]


def test_unknown_functions_are_no_factors():
    (found,) = readings(r"\[ \operatorname{foo} x = x \operatorname{foo} \]")
    assert found.verdict == "not read"
    assert "the function foo is not known" in found.reason


def test_a_name_of_several_letters_is_shown_whole():
    assert [each.read for each in readings(r"\[ 2\,\mathrm{km} = a\,\mathrm{km}_1 \]")] == ["2*km = a*km_1"]


def test_vectors_are_judged_where_their_sizes_are_given(tmp_path):
    cross = r"\[ \mathbf{u} \times \mathbf{v} = -\mathbf{v} \times \mathbf{u} \]"
    latex = cross + r" \[ \mathbf{A}\mathbf{u} = \mathbf{u}\mathbf{A} \]"
    path = tmp_path / "symbols.toml"
    path.write_text(
        "[[table]]\nsizes = { '\\mathbf{u}' = 3, '\\mathbf{v}' = [3, 1], '\\mathbf{A}' = [3, 3] }\n", "utf-8"
    )
    assert verdicts(latex, symbols_file(path)) == ["follows", "not decided"]
    assert verdicts(r"$\mathbf{u} \in \mathbb{R}^3$ \[ \mathbf{u} \times \mathbf{u} = 0 \]") == ["follows"]


def test_the_transpose_of_numbers_makes_no_matrix_of_them():
    assert verdicts(r"\[ s = a + b \] \[ \mathbf{x} = [a, b]^T \] \[ s - a = b \]")[-1] == "follows"


def test_the_user_may_overrule_what_is_recognised(tmp_path):
    latex = r"\begin{equation} s = a + b \end{equation} \begin{equation} (a + b)^2 = a^2 + b^2 \end{equation}"
    assert verdicts(latex) == ["definition", "independent"]
    assert verdicts(latex, SymbolsFile(identities=frozenset({"2"}))) == ["definition", "contradicts"]
    assert verdicts(latex, SymbolsFile(statements=frozenset({"1"}))) == ["independent", "independent"]
    (tmp_path / "symbols.toml").write_text("identity = ['2']\n", encoding="utf-8")
    with pytest.raises(UnreadableDocumentError, match="expected keys of"):
        symbols_file(tmp_path / "symbols.toml")


def test_letters_that_look_alike_have_different_names():
    found = readings(r"\[ x_p = x' + \mathbf{x} + \hat{x} + \lambda + x^{(p)} + \dot{x} \]")[0].read
    left, right = found.split(" = ")
    assert len({left, *right.split(" + ")}) == 7


def polynomial(numbers):
    return " + ".join(f"{c} a^{{{i}}} b^{{{j}}}" for i, j, c in numbers)


def test_identities_follow_and_planted_misprints_are_found():
    """Products multiplied out; then one coefficient, sign or exponent of each is changed."""
    numbers = random.Random(1)
    true, wrong = [], []
    for _ in range(12):
        p, q, r, s = (numbers.randint(2, 9) for _ in range(4))
        left = rf"({p} a + {q} b)({r} a - {s} b)"
        middle = r * q - p * s
        right = [f"{p * r} a^2", f"{abs(middle)} a b", f"{q * s} b^2"]
        sign = "+" if middle >= 0 else "-"
        true.append(f"y = {left} = {right[0]} {sign} {right[1]} - {right[2]}")
        wrong.append(f"y = {left} = {right[0]} {sign} {right[1]} + {right[2]}")
        wrong.append(f"y = {left} = {right[0].replace('a^2', 'a^3')} {sign} {right[1]} - {right[2]}")
        wrong.append(f"y = {left} = {p * r + 1} a^2 {sign} {right[1]} - {right[2]}")
    document = r"\[ z_{%d} = %s \]"
    found = readings(" ".join(document.replace("%d", str(i)).replace("%s", each[4:]) for i, each in enumerate(true)))
    assert {each.links[-1].verdict for each in found} == {"follows"}
    found = readings(" ".join(document.replace("%d", str(i)).replace("%s", each[4:]) for i, each in enumerate(wrong)))
    assert {each.links[-1].verdict for each in found} == {"contradicts"}


# The command.

DOCUMENT = r"""\section{Sums}
\begin{equation} s = a + b \end{equation}
\begin{align} s^2 &= (a+b)^2 \\ &= a^2 + 2ab + b^2 \end{align}
\[ s^2 = a^2 + 2 a b - b^2 \]
\[ \exists b = 2 \]
\[ F = - k x \]
\[ (F + 1)^2 = 3 \]
"""


@pytest.fixture
def document(tmp_path):
    path = tmp_path / "sums.tex"
    path.write_text(DOCUMENT, encoding="utf-8")
    return path


def run(*arguments):
    return CliRunner().invoke(main, list(map(str, arguments)))


def test_the_record_is_that_of_the_contract(document):
    result = run("read", document, "--format", "json")
    assert result.exit_code == 1
    record = json.loads(result.stdout)
    assert record["schema"] == 1
    keys = "line number latex read reason verdict rests_on hypotheses counterexample suggestion certificate"
    assert {*keys.split()} <= {*record["equations"][0]}
    assert [each["verdict"] for each in record["equations"]] == [
        *("definition", "follows", "contradicts", "not read", "definition", "independent"),
    ]
    assert record["summary"] == {"contradicts": 1, "definition": 2, "follows": 1, "independent": 1, "not read": 1}
    wrong = record["equations"][2]
    assert wrong["line"] == 4
    assert wrong["rests_on"] == ["(1), line 2"]
    assert set(wrong["counterexample"]) == {"a", "b"}
    assert record["equations"][3]["reason"] == r"line 5: the command \exists is not known"


def test_the_text_fits_a_screen_and_says_what_is_wrong(document):
    result = run("read", document)
    assert result.exit_code == 1
    assert "line 4  contradicts  s**2 = a**2 + 2*a*b - b**2" in result.output
    assert "would follow with a**2 + 2*a*b + b**2" in result.output
    assert r"not read: the command \exists is not known (line 5)" in result.output
    full = run("read", document, "--full").output
    assert "line 6  definition  F = -k*x" in full


def test_a_document_without_contradiction_is_well(document):
    document.write_text(DOCUMENT.replace("2 a b - b", "2 a b + b"), encoding="utf-8")
    assert run("read", document).exit_code == 0
    assert run("read", document.with_name("none.tex")).exit_code == 2


def test_the_folder_is_checked_at_once(document, tmp_path):
    assert run("read", document, "--out", tmp_path / "out").exit_code == 1
    folder = tmp_path / "out" / "sums"
    result = run("check", folder, "--format", "json")
    assert result.exit_code == 0, result.output
    found = {claim["number"]: claim["verdict"] for claim in json.loads(result.stdout)["claims"]}
    assert found == {
        "1": "definition",
        "2#1": "proved",
        "2#2": "proved",
        "2/line4": "misprint",
        "2/line6": "definition",
    }
    (module,) = (path.read_text(encoding="utf-8") for path in folder.glob("s02_*.py"))
    assert r"# derive: line 5, not read: line 5: the command \exists is not known" in module
    again = run("read", document, "--out", tmp_path / "out")
    assert again.exit_code == 2
    assert "nothing was written" in again.output


STATED = r"""\section{The \emph{long} side}
We do as \cite{a} in Eq.~\eqref{b} with $\hat{n}$, and get 5\% more:
\[ h = \sqrt{a^2 + b^2} \] \[ h^2 = a^2 + b^2 \] \[ \sin 2x = 2\sin x\cos x \]
\[ P(t) = \begin{bmatrix} \cos t & -\sin t \\ \sin t & \cos t \end{bmatrix} \]
\section*{Rotations}
The matrix $R$ is a rotation matrix and $\mathbf{a}$ a vector.
\[ \mathbf{b} = R\mathbf{a} \] \[ R^T\mathbf{b} = \mathbf{a} \]
\[ q = \sum_i x_i \] The complex number $z$. \[ z\bar{z} = |z|^2 \]
"""


def test_a_folder_states_functions_and_letters_and_is_replayed(tmp_path):
    path = tmp_path / "sides.tex"
    path.write_text(STATED, encoding="utf-8")
    assert run("read", path, "--out", tmp_path / "out").exit_code == 0
    folder = tmp_path / "out" / "sides"
    result = run("check", folder, "--format", "json")
    assert result.exit_code == 0, result.output
    claims = json.loads(result.stdout)["claims"]
    assert [claim["verdict"] for claim in claims] == ["definition", "proved", "proved", *["definition"] * 2, "proved"]
    assert {replay_claim(claim).status for claim in claims} == {"replayed"}
    first = (folder / "s02_the_long_side.py").read_text(encoding="utf-8")
    assert 'Section("sides", "2", "The long side")' in first
    assert r"# We do as [a] in Eq. b with $\hat{n}$, and get 5% more:" in first
    second = (folder / "s03_rotations.py").read_text(encoding="utf-8")
    assert "# derive: line 8, definition: it has values that are not computed" in second
    assert not re.search(r"^(?!#).*long side", second, re.MULTILINE)


def test_conditions_are_shown_as_they_are(tmp_path):
    path = tmp_path / "conditions.tex"
    latex = r"\[ \ln xy = \ln x + \ln y \] \[ \frac{x}{x} = 1 \] the rotation matrix $R$ \[ R^T R = RR^T \]"
    path.write_text(latex + r"\[ \mathbf{a} = -\mathbf{a} \]", encoding="utf-8")
    shown = run("read", path, "--full").output
    assert "holds where x*y > 0, x > 0, y > 0" in shown
    assert "holds where x != 0" in shown
    assert "holds where R is nxn rotation\n" in shown
    assert "fails at a = [[" in shown
    assert "'" not in shown


def test_every_follows_is_proved_again():
    for reading in readings(
        r"\[ s = a + b \] \[ s^2 = (a + b)(b + a) = a^2 + 2ab + b^2 \] \[ \frac{s^2}{s} = a + b \]"
    ):
        for link in reading.links:
            if link.verdict == "follows":
                names = {str(n): n for n in sympy.symbols("a b")}
                (asked,) = link.asked
                left, right = (sympy.sympify(side, names) for side in (asked.lhs, asked.rhs))
                assert prove(left, right).verdict == "proved"
