"""A section collects what is declared, in order, each with its kind."""

from decimal import Decimal

import pytest
import sympy

from algebroproj_sym import Section
from algebroproj_sym.declaring import DeclarationError
from algebroproj_sym.expressions import vector

x, y = sympy.symbols("x y")


@pytest.fixture
def section():
    return Section("demo", "2.1", "Demonstration")


def test_claims_are_kept_in_the_order_of_their_declaration_with_paper_and_section(section):
    declared = [section.identity(f"2.1.{n}", f"title {n}", printed=x, derived=x) for n in (3, 1, 2)]
    assert section.claims == declared
    assert [(c.paper, c.section, c.number, c.title) for c in declared] == [
        ("demo", "2.1", "2.1.3", "title 3"),
        ("demo", "2.1", "2.1.1", "title 1"),
        ("demo", "2.1", "2.1.2", "title 2"),
    ]


def test_each_way_to_declare_gives_its_kind(section):
    kinds = [
        section.identity("1", "", printed=x, derived=x).kind,
        section.identity("2", "", printed=x, derived=y, constraints=[x - y]).kind,
        section.identity("3", "", printed=x, derived=x, nonzero=[x]).kind,
        section.up_to_scale("4", "", printed=vector(x, x), derived=vector(y, y)).kind,
        section.structure("5", "", printed=vector(x), derived=vector(y)).kind,
        section.vanishing("6", "", printed=[x], derived=x).kind,
        section.numeric("7", "", printed="0.50", derived=sympy.Rational(1, 2)).kind,
        section.definition("8", "", printed=x).kind,
    ]
    assert kinds == [
        "identity",
        "identity under constraints",
        "identity",
        "identity up to scale",
        "structure",
        "vanishing",
        "numeric",
        "definition",
    ]


def test_a_claim_is_expected_to_be_proved_and_a_definition_to_define(section):
    assert section.identity("1", "", printed=x, derived=x).expected == "proved"
    assert section.definition("2", "", printed=x).expected == "definition"


def test_a_number_is_declared_once(section):
    section.identity("2.1.1", "", printed=x, derived=x)
    with pytest.raises(DeclarationError, match=r"claim demo:2\.1\.1: .*expected each number once"):
        section.definition("2.1.1", "", printed=x)
    assert len(section.claims) == 1


def test_parts_of_one_number_are_numbers_of_their_own(section):
    section.identity("2.1.1#a", "", printed=x, derived=x)
    section.identity("2.1.1#b", "", printed=x, derived=x)
    assert len(section.claims) == 2


def test_a_claim_that_is_refused_is_not_kept(section):
    with pytest.raises(DeclarationError):
        section.identity("bad", "", printed=x, derived=x)
    assert section.claims == []


def test_printed_numbers_keep_their_digits(section):
    claim = section.numeric("1", "", printed="0.50", derived=1, corrected="1.0", expect="misprint")
    assert (claim.printed, claim.corrected) == (Decimal("0.50"), Decimal("1.0"))
    assert claim.printed.as_tuple().exponent == -2


def test_factors_may_be_given_in_any_sequence(section):
    claim = section.vanishing("1", "", printed=(factor for factor in (x, y)), derived=x * y)
    assert claim.printed == (x, y)


def test_sections_share_nothing(section):
    section.definition("1", "", printed=x)
    assert Section("demo", "2.1", "Another").claims == []


def test_kernels_are_kept_in_the_order_of_their_declaration(section):
    parts = {"arguments": {"x": x}, "derived": x, "claims": ["1"], "example": {"x": "1"}, "describe": {"x": "a number"}}
    declared = [section.kernel(f"{name}.f", "A function.", **parts) for name in ("b", "a")]
    assert section.kernels == declared
    assert [(kernel.paper, kernel.section, kernel.qualified_name) for kernel in declared] == [
        ("demo", "2.1", "b.f"),
        ("demo", "2.1", "a.f"),
    ]
