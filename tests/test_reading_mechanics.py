r"""Texts on constitutive models as textbooks have them: what they derive follows, and not with a misprint.

The mark ``@`` stands before the letter of a tensor, and ``|>`` before an equation that follows.
"""

import re

import pytest
from textbooks import follow, with_misprint

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")
PLASTICITY = r"""The stress tensor is split into \[ @S = @s + p @I, \qquad p = \frac13 \tr(@S). \] The equivalent
stress is \[ q = \sqrt{\frac32 @s : @s}. \] The yield function is \[ f = q - \sigma_y. \] The flow direction is |>\[
\frac{\partial f}{\partial @S} = \frac32 \frac{@s}{q} \] With \[ @n = \frac32 \frac{@s}{q} \] we have |>\[ @n : @n =
\frac32 \] and |>\[ \tr(@n) = 0. \]"""
MAPPING = r"""The stress deviator of the trial state has the norm \[ q = \sqrt{\frac32 @s : @s}. \] With the flow rule
\[ \Delta @e^p = \Delta\gamma \, \frac32 \frac{@s}{q} \] the updated deviator is \[ @T = @s - 2 G \Delta @e^p. \]
Substituting the flow rule yields |>\[ @T = \left( 1 - \frac{3 G \Delta\gamma}{q} \right) @s. \]"""
TANGENT = r"""The deviatoric strain is the tensor \[ @e = \mathbb{P} : @E. \] With the unit normal \[ @n =
\frac{@e}{\|@e\|} \] we have |>\[ \frac{\partial \|@e\|}{\partial @e} = @n \] |>\[ \frac{\partial @n}{\partial @e} =
\frac{1}{\|@e\|} (\mathbb{I} - @n \otimes @n). \]"""
CHAIN = r"""Let $@S$ be the stress tensor with \[ I_1 = \tr(@S), \qquad @s = @S - \frac13 I_1 @I, \qquad J_2 = \frac12
@s : @s. \] The yield function is \[ f = \sqrt{J_2} + \alpha I_1 - k. \] By the chain rule |>\[ \frac{\partial
f}{\partial @S} = \frac{\partial f}{\partial I_1} \frac{\partial I_1}{\partial @S} + \frac{\partial f}{\partial J_2}
\frac{\partial J_2}{\partial @S} \] so that |>\[ \frac{\partial f}{\partial @S} = \alpha @I + \frac{1}{2 \sqrt{J_2}}
@s. \]"""
ENERGY = r"""The free energy of a strain tensor is \[ \psi = \frac12 K e_v^2 + G @e : @e, \] with \[ e_v = \tr(@E),
\qquad @e = @E - \frac13 e_v @I. \] The stress is \[ @S = \frac{\partial \psi}{\partial @E}. \] That is, |>\[ @S = K
e_v @I + 2 G @e. \] The pressure is \[ p = \frac13 \tr(@S). \] Thus |>\[ p = K e_v. \] |>\[ \frac{\partial
p}{\partial @S} = \frac13 @I \]"""
HYPERELASTICITY = r"""The deformation gradient $@F$ is a tensor with \[ J = \det @F, \qquad @C = @F^T @F. \] The strain
energy is \[ \Psi = \frac{\mu}{2} (\tr(@C) - 3) - \mu \ln J + \frac{\lambda}{2} (\ln J)^2. \] The first
Piola-Kirchhoff stress \[ @P = \frac{\partial \Psi}{\partial @F} \] is |>\[ @P = \mu (@F - @F^{-T}) + \lambda \ln J \,
@F^{-T}. \] The Kirchhoff stress is \[ @T = @P @F^T. \] Therefore |>\[ @T = \mu (@F @F^T - @I) + \lambda \ln J \, @I.
\]"""
INCREMENTS = r"""The stress tensor $@S$ obeys $@S : @S = 1$. The residuals are \[ @r = \Delta @E - \Delta @T +
\Delta\gamma \, @n = @0, \qquad g = \Delta a - (1 - a) \Delta w = 0. \] The values at the end of the step are \[ a =
a_n + \theta \Delta a. \] They are functions \[ @r = @r(\Delta @E, \Delta\gamma) \] and \[ g = g(\Delta a). \] The
derivatives are |>\[ \frac{\partial @r}{\partial \Delta\gamma} = @n \] |>\[ \frac{\partial @r}{\partial \Delta @E} =
\mathbb{I} + \Delta\gamma \frac{\partial @n}{\partial \Delta @E} \] |>\[ \frac{\partial g}{\partial \Delta a} = 1 +
\theta \Delta w. \]"""
TEXTS = {
    "plasticity": PLASTICITY,
    "mapping": MAPPING,
    "tangent": TANGENT,
    "chain": CHAIN,
    "energy": ENERGY,
    "hyperelasticity": HYPERELASTICITY,
    "increments": INCREMENTS,
}
MISPRINTS = [
    ("plasticity", r"= \frac32 \frac{@s}{q} \] With", r"= \frac23 \frac{@s}{q} \] With"),
    ("plasticity", r"@n : @n = \frac32", r"@n : @n = \frac23"),
    ("mapping", r"3 G \Delta", r"2 G \Delta"),
    ("mapping", r"1 - \frac", r"1 + \frac"),
    ("tangent", r"\mathbb{I} - @n", r"\mathbb{I} + @n"),
    ("tangent", r"\frac{1}{\|@e\|} (", r"\frac{1}{\|@e\|^2} ("),
    ("chain", r"\frac{1}{2 \sqrt{J_2}} @s", r"\frac{1}{\sqrt{J_2}} @s"),
    ("chain", r"+ \frac{\partial f}{\partial J_2}", r"- \frac{\partial f}{\partial J_2}"),
    ("energy", "+ 2 G @e. ", "+ G @e. "),
    ("energy", "p = K e_v", "p = 3 K e_v"),
    ("hyperelasticity", r"(@F - @F^{-T})", r"(@F - @F^{-1})"),
    ("hyperelasticity", r"(@F @F^T - @I)", r"(@F^T @F - @I)"),
    ("increments", r"\mathbb{I} + \Delta", r"\mathbb{I} - \Delta"),
    ("increments", r"1 + \theta \Delta w", r"1 - \theta \Delta w"),
]
LETTERS = {"S": r"\sigma", "E": r"\varepsilon", "T": r"\tau"}


def verdicts(text: str, style: str = r"\boldsymbol") -> list[str]:
    bold = re.sub(r"@(\w)", lambda found: f"{style}{{{LETTERS.get(found[1], found[1])}}}", text.replace("|>", ""))
    return [each.verdict for each in read_document(document_of(bold.replace(r"\tr", r"\mathrm{tr}")))]


@pytest.mark.parametrize("name", TEXTS)
def test_what_a_text_on_constitutive_models_derives_follows(name):
    found = verdicts(TEXTS[name])
    assert [each == "follows" for each in found] == follow(TEXTS[name]), found


@pytest.mark.parametrize("name", ["plasticity", "energy", "hyperelasticity"])
def test_lines_below_letters_are_read_as_bold_ones(name):
    found = verdicts(TEXTS[name], r"\underline")
    assert [each == "follows" for each in found] == follow(TEXTS[name]), found


@pytest.mark.parametrize(("name", "printed", "wrong"), MISPRINTS)
def test_no_misprint_of_a_constitutive_model_follows(name, printed, wrong):
    text, place = with_misprint(TEXTS[name], printed, wrong)
    found = verdicts(text)
    assert found[place] != "follows", found


DEFINING = [
    (
        r"The residuals are \[ r = x - a y = 0, \qquad s = z - b y = 0. \] Hence \[ b x = a z \]",
        ["definition", "definition", "follows"],
    ),
    (r"The modulus is \[ k^{\text{rs}}{\left( T \right)} = c \exp{\left( \frac{a}{T} \right)} \]", ["definition"]),
    (r"We set \[ \Phi_{\varepsilon}{\left(x, y\right)} = x + y - \sqrt{x^2 + y^2} \]", ["definition"]),
    (
        r"The volume strain is \[ \varepsilon^\mathrm{V} = 3 a \] and its power \[ w = (\varepsilon^\text{V})^2. \] "
        r"Hence \[ w = 9 a^2 \]",
        ["definition", "definition", "follows"],
    ),
    (
        r"The tensor $@S$ has the deviator \[ @s = @S - \frac13 I_1(@S) @I. \] Hence \[ \tr(@s) = 0 \]",
        ["definition", "follows"],
    ),
]


@pytest.mark.parametrize(("text", "wanted"), DEFINING)
def test_what_defines_a_letter_of_mechanics(text, wanted):
    assert verdicts(text) == wanted


OTHERWISE = [
    r"The matrix $D$ takes the strain tensor to \[ @S = D @E, \qquad w = @S : @E. \] Hence \[ @S = @E D \]",
    r"The tensor $@E$ has \[ @S = @F D @E, \qquad w = @S : @E. \] Hence \[ @S = D @F @E \]",
    r"The stress tensor gives \[ f = q + p, \qquad p = q^2 + \tr(@S). \] Hence \[ \frac{\partial f}{\partial q} = 1 \]",
    r"The bounds of the interval are \[ \underline{a} = b - c, \qquad \overline{a} = b + c. \] Hence "
    r"\[ \overline{a} = \underline{a}^T \]",
    r"The tensor \[ @S = 2 G @E, \qquad w = @S : @E. \] Hence \[ \frac{\partial w}{\partial @S} = 2 @E \]",
]


@pytest.mark.parametrize("text", OTHERWISE)
def test_what_tensors_do_not_say_does_not_follow(text):
    assert verdicts(text)[-1] != "follows"
