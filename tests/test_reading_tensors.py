r"""Tensors of continuum mechanics: ``A : B``, dyads, deviators, linear maps of matrices, and gradients by a tensor."""

import pytest

from algebroproj_sym.reading import document_of, read_document
from algebroproj_sym.reading.defining.tensors import second_in
from algebroproj_sym.reading.parsing.grammar import parsed

pytestmark = pytest.mark.usefixtures("verdicts_alone")

HOOKE = (
    r"The stress tensor is \[ @S = \lambda @tr(@E) @I + "
    r"2 \mu @E. \] Hence "
)
DEVIATOR = (
    r"The deviatoric stress is "
    r"\[ @s = @S - \frac13 @tr(@S) @I \] and "
    r"\[ J_2 = \frac12 @s : @s. \] Hence "
)
MAP = (
    r"The elasticity tensor is \[ \mathbb{C} = \lambda @I \otimes @I + 2 \mu \mathbb{I} \] and "
    r"the stress is \[ @S = \mathbb{C} : @E. \] Hence "
)
PROJECTOR = (
    r"The deviatoric part of a stress is found by "
    r"\[ \mathbb{P} = \mathbb{I} - \frac13 @I \otimes @I. \] Hence "
)
ENERGY = (
    r"The energy of a strain is \[ \Phi = \frac{\lambda}{2} (@tr \, @e)^2 + "
    r"\mu @e : @e. \] Hence "
)
YIELD = r"Of a deviatoric tensor we have \[ f = \sqrt{\frac32 @s : @s} - \sigma_y. \] Hence "
GRADIENT = r"The deformation gradient is the tensor $\mathbf{F}$. With \[ J = \det \mathbf{F} \] we get "
PARTS = (
    r"The stress tensor is "
    r"\[ @S = \mathbb{D} : (@E - @E_p). \] Hence "
)
MIXED = (
    r"Of the tensor $\mathbf{C}$ we have \[ \psi = \frac{\mu}{2} (@tr(\mathbf{C}) - 3) - "
    r"\frac{\mu}{2} \ln \det \mathbf{C}. \] Hence "
)
RATES = (
    r"Of tensors, \[ \dot{@E} = \dot{@E}^e + \dot{@E}^p \] and \[ \dot{@E}^p = @g @s. \] "
    r"The factor is \[ c = e + p^2. \] Hence "
)
NORM = r"Of a stress $@s$ the norm is \[ q = \| @s \|_{}. \] Hence "
BRACKET = r"The stress tensor is \[ @S = \lambda (@I : @E) @I + 2 \mu @E. \] Hence "
ELASTIC = (
    r"The stress tensor of an elastic body is \[ @S = \lambda @tr(@E) @I + 2 \mu @E \] with "
    r"\[ \lambda = \frac{E \nu}{(1 + \nu)(1 - 2 \nu)}, \qquad \mu = \frac{E}{2 (1 + \nu)}. \] Hence "
)
DYAD = (
    r"With a unit vector $\boldsymbol{n}$ we have the tensor "
    r"\[ \boldsymbol{P} = @I - \boldsymbol{n} \otimes \boldsymbol{n}. \] Hence "
)


SHORT = {"@tr": r"\mathrm{tr} ", "@g": r"\dot\gamma"} | {
    f"@{letter}": rf"\boldsymbol{{{full}}}"
    for letter, full in (("S", r"\sigma"), ("E", r"\varepsilon"), ("e", r"\epsilon"), ("I", "I"), ("s", "s"))
}
"""How long names are written here."""


def last(latex):
    for short, full in SHORT.items():
        latex = latex.replace(short, full)
    return read_document(document_of(latex))[-1]


FOLLOWING = [
    (HOOKE, r"@tr(@S) = (3 \lambda + 2 \mu) @tr(@E)"),
    (DEVIATOR, r"@tr(@s) = 0"),
    (DEVIATOR, r"J_2 = \frac12 @S : @S - \frac16 (@tr @S)^2"),
    (DEVIATOR, r"\sqrt{\frac32 @s : @s} = \sqrt{3 J_2}"),
    (DEVIATOR, r"\sqrt{\frac32} \| @s \| = \sqrt{3 J_2}"),
    (DEVIATOR, r"\| @s \|^2 = 2 J_2"),
    (DEVIATOR, r"@s = \mathrm{dev}(@S)"),
    (MAP, r"@S = \lambda @tr(@E) @I + 2 \mu @E"),
    (MAP, r"@E : \mathbb{C} : @E = \lambda (@tr @E)^2 + 2 \mu @E : @E"),
    (PROJECTOR, r"\mathbb{P} : \mathbb{P} = \mathbb{P}"),
    (PROJECTOR, r"\mathbb{P} : @S = \mathrm{dev} (@S)"),
    (ENERGY, r"\frac{\partial \Phi}{\partial @e} = \lambda (@tr @e) @I + 2 \mu @e"),
    (YIELD, r"\frac{\partial f}{\partial @s} = \frac32 \frac{@s}{\sqrt{\frac32 @s : @s}}"),
    (GRADIENT, r"\frac{\partial J}{\partial \mathbf{F}} = J \mathbf{F}^{-T}"),
    (GRADIENT, r"\dot J = J @tr(\dot{\mathbf{F}} \mathbf{F}^{-1})"),
    (PARTS, r"@S = \mathbb{D} : @E - \mathbb{D} : @E_p"),
    (MIXED, r"2 \frac{\partial \psi}{\partial \mathbf{C}} = \mu (\mathbf{I} - \mathbf{C}^{-T})"),
    (RATES, r"\dot{@E}^e = \dot{@E} - @g @s"),
    (NORM, r"q^2 = @s : @s"),
    (BRACKET, r"@S = \lambda @tr(@E) @I + 2 \mu @E"),
    (ELASTIC, r"@E = \frac{1 + \nu}{E} @S - \frac{\nu}{E} @tr(@S) @I"),
    (DYAD, r"\boldsymbol{P} \boldsymbol{v} = \boldsymbol{v} - (\boldsymbol{n} \cdot \boldsymbol{v}) \boldsymbol{n}"),
]


@pytest.mark.parametrize(("above", "claim"), FOLLOWING)
def test_what_follows_of_tensors(above, claim):
    assert last(rf"{above}\[ {claim} \]").verdict == "follows"


MISPRINTS = [
    (HOOKE, r"@tr(@S) = (2 \lambda + 2 \mu) @tr(@E)"),
    (DEVIATOR, r"J_2 = \frac12 @S : @S - \frac13 (@tr @S)^2"),
    (DEVIATOR, r"\sqrt{\frac32 @s : @s} = \sqrt{2 J_2}"),
    (DEVIATOR, r"\| @s \|^2 = J_2"),
    (MAP, r"@S = \lambda @tr(@E) @I + \mu @E"),
    (MAP, r"@E : \mathbb{C} : @E = \lambda (@tr @E)^2 - 2 \mu @E : @E"),
    (PROJECTOR, r"\mathbb{P} : \mathbb{P} = 2 \mathbb{P}"),
    (ENERGY, r"\frac{\partial \Phi}{\partial @e} = \lambda (@tr @e) @I + \mu @e"),
    (YIELD, r"\frac{\partial f}{\partial @s} = \frac23 \frac{@s}{\sqrt{\frac32 @s : @s}}"),
    (GRADIENT, r"\frac{\partial J}{\partial \mathbf{F}} = J \mathbf{F}^{-1}"),
    (PARTS, r"@S = \mathbb{D} : @E + \mathbb{D} : @E_p"),
    (MIXED, r"2 \frac{\partial \psi}{\partial \mathbf{C}} = \mu (\mathbf{I} + \mathbf{C}^{-T})"),
    (RATES, r"\dot{@E}^e = \dot{@E} + @g @s"),
    (NORM, r"q^2 = 2 @s : @s"),
    (ELASTIC, r"@E = \frac{1 + \nu}{E} @S - \frac{2 \nu}{E} @tr(@S) @I"),
    (DYAD, r"\boldsymbol{P} \boldsymbol{v} = \boldsymbol{v} + (\boldsymbol{n} \cdot \boldsymbol{v}) \boldsymbol{n}"),
]


@pytest.mark.parametrize(("above", "claim"), MISPRINTS)
def test_a_misprint_does_not_follow(above, claim):
    assert last(rf"{above}\[ {claim} \]").verdict != "follows"


def test_three_dimensions_are_said():
    (link,) = last(rf"{DEVIATOR}\[ \mathrm{{tr}}(\boldsymbol{{s}}) = 0 \]").links
    assert link.hypotheses[:2] == ("I is the identity", "space has three dimensions")


FLAT = [
    ("In two dimensions, ", DEVIATOR, r"@tr(@s) = 0"),
    ("In plane strain, ", DEVIATOR, r"@s = \mathrm{dev}(@S)"),
    ("In $d$ dimensions, ", HOOKE, r"@tr(@S) = (3 \lambda + 2 \mu) @tr(@E)"),
]


@pytest.mark.parametrize(("words", "above", "claim"), FLAT)
def test_another_number_of_dimensions_is_heard(words, above, claim):
    assert last(rf"{words}{above}\[ {claim} \]").verdict not in ("follows", "contradicts")


OTHERWISE = [
    r"Of quaternions, \[ \mathbf{P} = \mathbf{q} \otimes \mathbf{p}. \] "
    r"Hence \[ \mathbf{P} \mathbf{v} = (\mathbf{p} \cdot \mathbf{v}) \mathbf{q} \]",
    r"With the Kronecker product, \[ \mathbf{P} = \mathbf{q} \otimes \mathbf{p}. \] "
    r"Hence \[ \mathbf{P} \mathbf{v} = (\mathbf{p} \cdot \mathbf{v}) \mathbf{q} \]",
    r"Of tensors, \[ \mathbf{A} : \mathbf{B} = @tr(\mathbf{A} \mathbf{B}) \] and "
    r"\[ w = \mathbf{A} : \mathbf{B}. \] Hence \[ w = @tr(\mathbf{A}^T \mathbf{B}) \]",
    r"We have \[ p(\mathbf{x} : \mathbf{y}) = q. \] Hence \[ p = q / (\mathbf{x} : \mathbf{y}) \]",
    r"The deviatoric part of a tensor is \[ \mathrm{dev}(@S) = @S - "
    r"\frac12 @tr(@S) @I \]",
]


@pytest.mark.parametrize("latex", OTHERWISE)
def test_other_products_with_these_signs_are_left_open(latex):
    assert last(latex).verdict not in ("follows", "contradicts")


def test_a_letter_behind_a_nabla_is_no_tensor_of_the_second_order():
    sides = parsed(r"s = \tr(\nabla \mathbf{u} + (\nabla \mathbf{u})^T) + \nabla \mathbf{v} : \mathbf{e}").sides
    assert second_in([sides]) == {r"\mathbf{e}"}


def test_no_size_is_called_as_a_letter_that_comes_later():
    claim = r"\sqrt{@s : @s} = \sqrt{q^2 \boldsymbol{n} : \boldsymbol{n}}"
    above = r"Of tensors, the stress is $@S$. \[ @s = @S - p \boldsymbol{1}. \] Hence "
    assert last(rf"{above}\[ {claim} \]").verdict == "independent"
