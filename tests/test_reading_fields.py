r"""Vector fields by components: ``\nabla \cdot (\nabla \times a) = 0``, and what equations of fields say derived."""

from itertools import product

import pytest
import sympy
from cases import for_each
from sympy.vector import CoordSys3D, Vector, curl, divergence, gradient

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

SPACE = CoordSys3D("S")
X, Y, Z = SPACE.base_scalars()
U, V, W = SPACE.base_vectors()
PHI, PSI = X**2 * Y + 3 * Z**2 + X, Y**2 * Z - 2 * X * Z + 5
A = (X * Y**2 + Z) * U + (Y * Z - X**3) * V + (X * Z**2 + Y) * W
B = (Y**3 - X) * U + (X * Z + 2 * Y**2) * V + (X**2 + Y * Z) * W


def along(vector, value):
    parts = [value.diff(letter) for letter in (X, Y, Z)]
    return sum((vector.dot(axis) * part for axis, part in zip((U, V, W), parts, strict=True)), 0 * value)


def laplacian(value):
    return sum((value.diff(letter, 2) for letter in (X, Y, Z)), 0 * value)


# The terms of each identity, which is that their sum is zero, with what each is for the fields above.
IDENTITIES = [
    {
        r"\nabla \times (\nabla \times \mathbf{a})": curl(curl(A)),
        r"-\nabla (\nabla \cdot \mathbf{a})": -gradient(divergence(A)),
        r"\nabla^2 \mathbf{a}": laplacian(A),
    },
    {
        r"\nabla \cdot (\psi \mathbf{a})": divergence(PSI * A),
        r"-\psi \nabla \cdot \mathbf{a}": -PSI * divergence(A),
        r"-\mathbf{a} \cdot \nabla \psi": -A.dot(gradient(PSI)),
    },
    {
        r"\nabla \times (\psi \mathbf{a})": curl(PSI * A),
        r"-\psi \nabla \times \mathbf{a}": -PSI * curl(A),
        r"-\nabla \psi \times \mathbf{a}": -gradient(PSI).cross(A),
    },
    {
        r"\nabla \cdot (\mathbf{a} \times \mathbf{b})": divergence(A.cross(B)),
        r"-\mathbf{b} \cdot (\nabla \times \mathbf{a})": -B.dot(curl(A)),
        r"\mathbf{a} \cdot (\nabla \times \mathbf{b})": A.dot(curl(B)),
    },
    {
        r"\nabla (\mathbf{a} \cdot \mathbf{b})": gradient(A.dot(B)),
        r"-(\mathbf{a} \cdot \nabla) \mathbf{b}": -along(A, B),
        r"-\mathbf{b} \cdot \nabla \mathbf{a}": -along(B, A),
        r"-\mathbf{a} \times (\nabla \times \mathbf{b})": -A.cross(curl(B)),
        r"-\mathbf{b} \times (\nabla \times \mathbf{a})": -B.cross(curl(A)),
    },
    {
        r"\nabla \times (\mathbf{a} \times \mathbf{b})": curl(A.cross(B)),
        r"-\mathbf{a} (\nabla \cdot \mathbf{b})": -A * divergence(B),
        r"\mathbf{b} (\nabla \cdot \mathbf{a})": B * divergence(A),
        r"-(\mathbf{b} \cdot \nabla) \mathbf{a}": -along(B, A),
        r"(\mathbf{a} \cdot \nabla) \mathbf{b}": along(A, B),
    },
    {
        r"\nabla^2 (\phi \psi)": laplacian(PHI * PSI),
        r"-\phi \nabla^2 \psi": -PHI * laplacian(PSI),
        r"-\psi \nabla^2 \phi": -PSI * laplacian(PHI),
        r"-2 \nabla \phi \cdot \nabla \psi": -2 * gradient(PHI).dot(gradient(PSI)),
    },
    {
        r"\nabla \cdot (\phi \nabla \psi)": divergence(PHI * gradient(PSI)),
        r"-\phi \nabla^2 \psi": -PHI * laplacian(PSI),
        r"-\nabla \phi \cdot \nabla \psi": -gradient(PHI).dot(gradient(PSI)),
    },
    {r"\nabla \cdot \nabla \times \mathbf{a}": divergence(curl(A))},
    {r"\nabla \times \nabla \psi": curl(gradient(PSI))},
]
AT = {X: sympy.Rational(2, 3), Y: sympy.Rational(-5, 7), Z: sympy.Rational(3, 2)}
# Documents about vector fields have a divergence or a curl.
BEGIN = r"The source is \[ q = \nabla \cdot \mathbf{v}. \] For all fields "


def verdict(latex):
    return read_document(document_of(latex))[-1].verdict


def is_zero(value):
    parts = [value.dot(axis) for axis in (U, V, W)] if isinstance(value, Vector) else [value]
    return all(sympy.expand(part.subs(AT)) == 0 for part in parts)


def scaled(signs, terms):
    """Return the sum of terms, some with the other sign, as text and as a value."""
    first, *others = terms
    chosen = [
        (text, terms[text]) if sign > 0 else (text[1:] if text[0] == "-" else f"-{text}", -terms[text])
        for sign, text in zip(signs, others, strict=True)
    ]
    text = " ".join([first, *(each if each[0] == "-" else f"+ {each}" for each, _ in chosen)])
    return text, sum((value for _, value in chosen), terms[first])


@for_each("terms", IDENTITIES)
def test_an_identity_of_fields_follows_with_its_signs_alone(terms):
    for signs in product((1, -1), repeat=len(terms) - 1):
        text, value = scaled(signs, terms)
        zero = "0" if not isinstance(value, Vector) else r"\mathbf{0}"
        found = verdict(BEGIN + rf"\[ {text} = {zero}. \]")
        assert (found == "follows") is is_zero(value), text
        assert found != "contradicts", text


MAXWELL = (
    r"Maxwell's equations in empty space are \[ \nabla \cdot \mathbf{E} = 0, \quad \nabla \cdot \mathbf{B} = 0, \quad "
    r"\nabla \times \mathbf{E} = -\frac{\partial \mathbf{B}}{\partial t}, \quad "
    r"\nabla \times \mathbf{B} = \frac{1}{c^2} \frac{\partial \mathbf{E}}{\partial t}. \] Hence "
)
FLOW = (
    r"The fluid has the momentum \[ \rho \frac{\partial \mathbf{u}}{\partial t} + \rho (\mathbf{u} \cdot \nabla) "
    r"\mathbf{u} = -\nabla p + \mu \nabla^2 \mathbf{u}, \] and its divergence is \[ \nabla \cdot \mathbf{u} = 0. \] "
)
WAVE = (
    r"The pressure and the velocity of sound waves obey \[ \rho \frac{\partial u}{\partial t} = -\frac{\partial p}"
    r"{\partial x}, \qquad \frac{\partial p}{\partial t} = -K \frac{\partial u}{\partial x}. \] Hence "
)


@for_each(
    "latex",
    [
        MAXWELL + r"\[ \nabla^2 \mathbf{E} = \frac{1}{c^2} \frac{\partial^2 \mathbf{E}}{\partial t^2}. \]",
        MAXWELL + r"\[ \frac{\partial^2 \mathbf{B}}{\partial t^2} = c^2 \nabla^2 \mathbf{B}. \]",
        FLOW + r"The divergence gives \[ \nabla^2 p = -\rho \nabla \cdot ((\mathbf{u} \cdot \nabla) \mathbf{u}). \]",
        FLOW + r"Its vorticity is \[ \boldsymbol\omega = \nabla \times \mathbf{u}. \] Hence \[ \frac{\partial "
        r"\boldsymbol\omega}{\partial t} + (\mathbf{u} \cdot \nabla) \boldsymbol\omega = (\boldsymbol\omega \cdot "
        r"\nabla) \mathbf{u} + \frac{\mu}{\rho} \nabla^2 \boldsymbol\omega. \]",
        WAVE + r"\[ \frac{\partial^2 p}{\partial t^2} = \frac{K}{\rho} \frac{\partial^2 p}{\partial x^2}. \]",
        r"The field is \[ \mathbf{B} = \nabla \times \mathbf{A}. \] Hence \[ \operatorname{div} \mathbf{B} = 0. \]",
        r"The field is \[ \mathbf{E} = -\nabla \phi - \frac{\partial \mathbf{A}}{\partial t}. \] Hence \[ \nabla "
        r"\times \mathbf{E} = -\frac{\partial}{\partial t} (\nabla \times \mathbf{A}). \]",
        r"With the stream function \[ u = \frac{\partial \psi}{\partial y}, \quad v = -\frac{\partial \psi}{\partial x}"
        r" \] we have \[ \frac{\partial u}{\partial x} + \frac{\partial v}{\partial y} = 0. \]",
        r"The source is \[ \nabla \cdot \vec{v} = \frac{\partial v_x}{\partial x} + \frac{\partial v_y}{\partial y} + "
        r"\frac{\partial v_z}{\partial z}. \]",
    ],
)
def test_what_equations_of_fields_say_when_they_are_derived_follows(latex):
    assert verdict(latex) == "follows"


@for_each(
    "latex",
    [
        MAXWELL + r"\[ \nabla^2 \mathbf{E} = -\frac{1}{c^2} \frac{\partial^2 \mathbf{E}}{\partial t^2}. \]",
        MAXWELL + r"\[ \nabla^2 \mathbf{E} = \frac{1}{c} \frac{\partial^2 \mathbf{E}}{\partial t^2}. \]",
        MAXWELL + r"\[ \nabla^2 \mathbf{E} = \frac{1}{c^2} \frac{\partial^2 \mathbf{B}}{\partial t^2}. \]",
        FLOW + r"The divergence gives \[ \nabla^2 p = \rho \nabla \cdot ((\mathbf{u} \cdot \nabla) \mathbf{u}). \]",
        WAVE + r"\[ \frac{\partial^2 p}{\partial t^2} = \frac{\rho}{K} \frac{\partial^2 p}{\partial x^2}. \]",
        WAVE + r"\[ \frac{\partial^2 p}{\partial t^2} = \frac{K}{\rho} \frac{\partial^2 u}{\partial x^2}. \]",
        # What stands below a line or above it is no coordinate.
        r"\[ q = \nabla \cdot \mathbf{v}. \] Then \[ \frac{\partial u}{\partial s} \frac{\partial s}{\partial u} "
        r"= 1. \]",
        r"\[ q = \nabla \cdot \mathbf{v}. \] The path is given. Then \[ \frac{\partial x}{\partial t} = 0. \]",
        # x is a mole fraction, and r may be any vector.
        r"\[ q = \nabla \cdot \mathbf{v}. \] The fraction of the salt is $x$. Then \[ \nabla \cdot \nabla x = 0. \]",
        r"\[ q = \nabla \cdot \mathbf{v}. \] Then \[ \nabla \cdot \mathbf{r} = 3. \]",
        # The matrix of second derivatives.
        r"\[ g = \nabla f \] \[ \nabla^2 (f h) = f \nabla^2 h + h \nabla^2 f + 2 \nabla f \cdot \nabla h. \]",
        # Two derivatives of one vector.
        r"\[ \partial_t (\mathbf{a} \times \mathbf{b}) = \partial_x (\mathbf{a} \times \mathbf{b}). \]",
        # At a fixed x, or along the path.
        r"\[ f = x^2 + t, \quad x = a t. \] Then \[ \frac{\partial f}{\partial t} = 2 a^2 t + 1. \]",
        # A component of another letter.
        r"\[ q = \nabla \cdot \vec{v}. \] Hence \[ q = \frac{\partial u_x}{\partial x} "
        r"+ \frac{\partial u_y}{\partial y} + \frac{\partial u_z}{\partial z}. \]",
        # At a place, and in a state of rest.
        r"At the wall \[ \nabla \cdot \mathbf{u} = 0. \] The source is \[ q = \nabla \cdot \mathbf{u}. \] "
        r"Hence \[ q = 0. \]",
        r"In equilibrium \[ \nabla p = 0, \quad \nabla \cdot \mathbf{v} = 0. \] The force is \[ \mathbf{f} = -\nabla "
        r"p. \] Hence \[ \mathbf{f} = 0. \]",
        # The equations are of two cases.
        r"The field is static: \[ \nabla \times \mathbf{E} = 0. \] With magnets \[ \nabla \times \mathbf{E} = "
        r"-\partial_t \mathbf{B}. \] Hence \[ \partial_t \mathbf{B} = 0. \]",
        r"The flow has \[ \nabla \cdot \mathbf{u} = 0. \] With sources we have \[ \nabla \cdot \mathbf{u} = q. \] "
        r"Hence \[ q = 0. \]",
        # The flow is another one in this case.
        FLOW + r"If the flow is steady, \[ \frac{\partial \mathbf{u}}{\partial t} = 0. \] In general \[ (\mathbf{u} "
        r"\cdot \nabla) \mathbf{u} = -\frac{1}{\rho} \nabla p + \frac{\mu}{\rho} \nabla^2 \mathbf{u}. \]",
    ],
)
def test_nothing_else_follows(latex):
    assert verdict(latex) != "follows"


def test_a_proof_tells_what_it_supposes():
    found = read_document(
        document_of(
            WAVE + r"\[ \frac{\partial^2 p}{\partial t^2} = \frac{K}{\rho} \frac{\partial^2 p}{\partial x^2}. \]"
        )
    )
    (link,) = found[-1].links
    said = {"letters are smooth functions of x, y, z and t", "K does not change", "rho does not change"}
    assert said <= {*link.hypotheses}
    assert any(each.endswith("holds everywhere") for each in link.hypotheses)


def test_an_equation_gives_no_meaning_to_what_an_operator_makes():
    first, _, last, _ = read_document(document_of(MAXWELL))
    assert first.verdict == last.verdict == "independent"


@for_each(
    "latex",
    [
        # By a square, or by a coordinate with its number above.
        r"\[ g = \frac{\partial f}{\partial x}. \] Hence \[ \frac{\partial g}{\partial x} = \frac{\partial f}"
        r"{\partial x^2}. \]",
        r"\[ g = \frac{\partial f}{\partial x}. \] Hence \[ g = \frac{\partial^2 f}{\partial x}. \]",
        # The density changes.
        WAVE + r"with $\rho = \rho(x)$ we get \[ \frac{\partial^2 p}{\partial t^2} = \frac{K}{\rho} "
        r"\frac{\partial^2 p}{\partial x^2}. \]",
        # Two vectors of one letter.
        r"\[ q = \nabla \cdot \mathbf{a}. \] Then \[ q = \nabla \cdot \vec{a}. \]",
    ],
)
def test_signs_that_differ_are_different_derivatives_and_vectors(latex):
    assert verdict(latex) != "follows"


def test_a_proof_tells_where_its_definitions_hold_and_what_nabla_is():
    latex = r"\[ q = \nabla \cdot \mathbf v. \] On the wall \[ \phi = \psi. \] Hence \[ \nabla \phi = \nabla \psi. \]"
    for link in read_document(document_of(latex))[-1].links:
        assert {"line 1 holds everywhere", "nabla is by Cartesian coordinates"} <= {*link.hypotheses}


@for_each(
    "name",
    [r"E^\mathrm{rot}", r"E_{1,\mathrm{rot}}", r"\mathrm{rot}", r"\mathrm{div}"],
)
def test_the_name_of_an_operator_is_a_name_in_a_script_and_before_no_argument(name):
    assert verdict(rf"\[ c = {name} + b. \] Hence \[ {name} = c - b. \]") == "follows"
