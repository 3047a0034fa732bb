"""In a notebook a claim shows its number, its formula, its verdict and the evidence."""

import re

import pytest
import sympy
from cases import for_each

from algebroproj_sym import Section
from algebroproj_sym.declaring import judge, select
from algebroproj_sym.expressions import Matrix, over, vector
from algebroproj_sym.showing.display import evidence_lines, markdown

x, y, u31 = sympy.symbols("x y u31")


@pytest.fixture
def section():
    return Section("demo", "1", "Demonstration")


def paragraphs(claim):
    heading, formula, *rest = markdown(judge(claim)).split("\n\n")
    assert re.fullmatch(r"\$\$.+\$\$", formula, re.DOTALL)
    return heading, formula[2:-2], "\n".join(rest)


def test_a_proved_claim(section):
    claim = section.identity("1.3.8", "a quotient", printed=x + y, derived=over(x**2 - y**2, x - y), note="Mind y.")
    heading, formula, rest = paragraphs(claim)
    assert heading == "**(1.3.8)** a quotient: **proved**"
    assert formula == "x + y = x + y"
    assert "normal form" in rest
    assert "$x - y$" in rest
    assert "Mind y." in rest


def test_a_misprint_shows_correction_and_counterexample(section):
    claim = section.identity(
        "1.2", "a square", printed=x**2 + 1, derived=(x + 1) ** 2, corrected=x**2 + 2 * x + 1, expect="misprint"
    )
    heading, formula, rest = paragraphs(claim)
    assert heading == "**(1.2)** a square: **misprint**"
    assert formula.startswith("x^{2} + 1 ")
    assert "corrected:\n$$x^{2} + 2 x + 1$$" in rest
    (value,) = re.findall(r"counterexample: \$x\$ = \$(-?\d+)\$$", rest, re.MULTILINE)
    assert sympy.Rational(value) != 0


def test_a_false_claim_shows_counterexample_and_what_is_true_instead(section):
    claim = section.identity("1.2", "a square", printed=x * y, derived=x + y, expect="false", instead="1.7/sum")
    heading, formula, rest = paragraphs(claim)
    assert heading == "**(1.2)** a square: **false**"
    assert formula.startswith("x y ")
    x_value, y_value = map(sympy.Rational, re.findall(r"\$[xy]\$ = \$(-?\d+)\$", rest))
    assert x_value * y_value != x_value + y_value
    assert "(1.7/sum)" in rest


def test_what_fails_is_not_shown_as_if_it_held(section):
    true = section.identity("1.1", "", printed=x, derived=x)
    false = section.identity("1.2", "", printed=x, derived=x + 1, expect="false", instead="1.1")
    assert r"\n" not in paragraphs(true)[1]
    assert paragraphs(false)[1] == r"x \neq x + 1"


def test_factors_that_do_not_fit_are_not_shown_as_if_they_did(section):
    claim = section.vanishing("1.2", "zeros", printed=(x,), derived=x * y, expect="misprint", corrected=(x, y))
    assert r"x y = 0 \nLeftrightarrow \left(x\right) = 0" in paragraphs(claim)[1]


def test_an_illegible_claim_shows_its_reconstruction(section):
    claim = section.identity("1.2", "lost", printed=None, derived=x + x, corrected=2 * x, expect="illegible")
    heading, formula, rest = paragraphs(claim)
    assert heading == "**(1.2)** lost: **illegible**"
    assert "2 x" in formula
    assert "None" not in markdown(judge(claim))
    assert "reconstructed:\n$$2 x$$" in rest
    assert "normal form" in rest


def test_a_definition_shows_its_formula_and_an_instance(section):
    heading, formula, rest = paragraphs(section.definition("1.2", "a point", printed=vector(u31, over(x, y))))
    assert heading == "**(1.2)** a point: **definition**"
    assert formula == r"\left[\begin{matrix} u_{31} \\ \frac{x}{y} \end{matrix}\right]"
    assert "instance" in rest
    assert "y" in rest


def test_a_vanishing_claim_shows_expression_and_factors(section):
    heading, formula, rest = paragraphs(section.vanishing("1.2", "zeros", printed=(x, y - 1), derived=x * (y - 1)))
    assert heading == "**(1.2)** zeros: **proved**"
    expression, factors = formula.split(r"\iff")
    assert expression.replace(" ", "") in (r"x\left(y-1\right)=0", "xy-x=0")
    assert r"\left(x\right) \cdot \left(y - 1\right) = 0" in factors
    assert "factorisation" in rest


def test_a_numeric_claim_shows_the_printed_digits(section):
    claim = section.numeric("1.2", "a cell", printed="-0.0000000", derived=sympy.Rational(-1, 10**9))
    heading, formula, rest = paragraphs(claim)
    assert heading == "**(1.2)** a cell: **proved**"
    assert formula.startswith("-0.0000000 ")
    assert "rounding" in rest


def test_an_equality_up_to_scale_is_not_shown_as_an_equality(section):
    formula = paragraphs(section.up_to_scale("1.2", "", printed=Matrix([[2 * x, 2]]), derived=Matrix([[x, 1]])))[1]
    assert r"\sim" in formula
    assert "=" not in formula


def test_a_rank_and_a_limit_are_not_shown_as_equal_to_their_argument(section):
    rank = section.rank("1.2", "a rank", printed=1, derived=Matrix([[x, x], [x, x]]), kernel=[vector(1, -1)])
    assert paragraphs(rank)[1].startswith(r"1 = \operatorname{rank} \left[")
    limit = section.limit("1.3", "a limit", printed=y, derived=x + y, variable=x)
    assert paragraphs(limit)[1] == r"y = \lim_{x \to 0} \left(x + y\right)"


def test_an_open_claim_shows_why_it_is(section):
    claim = section.vanishing("1.2", "no zero", printed=(), derived=x**2 + 1)
    heading, _, rest = paragraphs(claim)
    assert heading == "**(1.2)** no zero: **open, declared proved**"
    assert "no rational point" in rest


def test_the_evidence_of_the_command_line_is_part_of_what_a_notebook_shows(section):
    claim = section.identity("1.2", "a quotient", printed=x, derived=over(x * y, y) + 1, expect="false", instead="1.1")
    lines = evidence_lines(judge(claim))
    assert lines
    assert all(line in markdown(judge(claim)).replace("$", "").split("\n\n") for line in lines)


def test_what_markdown_takes_for_markup_is_shown_as_it_is(section):
    claim = section.identity("1.2/P*", "P* is P*", printed=x, derived=x, note="u_31 * u_32 * [1], <b>, `$5$`")
    heading, _, rest = paragraphs(claim)
    assert heading == r"**(1.2/P\*)** P\* is P\*: **proved**"
    assert r"note: u\_31 \* u\_32 \* \[1\], \<b\>, \`\$5\$\`" in rest


def test_what_is_too_long_to_be_read_is_described(section):
    terms = sympy.Add(*(k * x**k for k in range(1, 300)))
    formula = paragraphs(section.identity("1.2", "long", printed=terms, derived=over(terms * y, y)))[1]
    assert formula.startswith(r"\text{a sum of 299 terms")
    assert len(formula) < 200


@for_each("claim", select(["fundamentals1996:1.3"]))
def test_every_claim_of_section_1_3_shows_itself(claim):
    heading, formula, rest = paragraphs(claim)
    assert heading.replace("\\", "") == f"**({claim.number})** {claim.title}: **{claim.expected}**"
    assert formula.count("{") == formula.count("}")
    assert "over" not in formula
    assert rest
