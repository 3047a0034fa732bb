# %% [markdown]
# # 2.2 Computation of the parameters
#
# The matrix of correlation is known.  What are the rotations?  The epipoles give tip and swing of each image; one
# column of $\mathbf Z$ then gives the tilt.  A matrix with a free factor does not know its sign, and an epipole does
# not either:  signs and quadrants are the hard part.

# %%
import sympy
from sympy import Abs, BlockMatrix, Eq, MatrixSymbol, cos, pi, sin, sqrt, tan

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.inserting import given
from algebroproj_derivations.normalcase1992.notation import *
from algebroproj_derivations.normalcase1992.s2_1_rotations import C_rational, R_p, R_pp, t3
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, diff, dot, over, vector
from algebroproj_sym.expressions.letters import Skew

section = Section("normalcase1992", "2.2", "Computation of the parameters")

# %% [markdown]
# ## What do the epipoles say?
#
# **Definition.**  An epipole is the image of the other center of projection, that is, of the base.  $\mathbf C$ or
# $\mathbf C^T$ takes it to zero (1.2.5).  Its factor may have either sign.

# %%
X0_left = vector(*sympy.symbols("X01 X02 X03"))
X0_right = X0_left + unit_base
b_symbols = vector(*sympy.symbols("b1:4"))
base_left, base_right = R_p.T * (X0_right - X0_left), R_pp.T * (X0_left - X0_right)

Rp, Rpp, Z_bold = (MatrixSymbol(name, 3, 3) for name in ("Rp", "Rpp", "Z"))
xp_o, xpp_o, b_bold, X0p, X0pp = (MatrixSymbol(name, 3, 1) for name in ("xp_o", "xpp_o", "b", "X0p", "X0pp"))
lam_p, lam_pp, z = sympy.symbols("lam_p lam_pp z")
EPIPOLES = [Eq(b_bold, X0pp - X0p), Eq(xp_o, Rp.T * (X0pp - X0p) / lam_p), Eq(xpp_o, Rpp.T * (X0p - X0pp) / lam_pp)]
section.identity(
    "2.2/zero",
    "the matrix of correlation takes the epipoles to zero",
    constraints=[*EPIPOLES, Eq(Z_bold, Rp.T * Skew(b_bold) * Rpp / z)],
    properties={Rp: "rotation", Rpp: "rotation"},
    derived=sympy.ZeroMatrix(3, 2),
)
section.identity(
    "2.2/base",
    "the epipoles are the images of the base",
    constraints=EPIPOLES,
    derived=BlockMatrix([[lam_p * xp_o, lam_pp * xpp_o]]),
)
base_left

# %% [markdown]
# **Print.**  Each is a function of two angles, and does not depend on the tilt.

# %%
section.identity(
    "2.2/base#left",
    "image of the base in the left image",
    derived=base_left,
)
section.identity(
    "2.2/base#right",
    "image of the base in the right image",
    derived=base_right,
)
section.identity(
    "2.2/independent",
    "the epipoles do not depend on the tilt",
    printed=Matrix.zeros(3, 1),
    derived=base_right.diff(Omegapp),
)

# %% [markdown]
# **An example.**  A left image with the tip whose sine is $-7/25$.

# %%
EXAMPLE = given((*PHI_LEFT, *KAPPA_LEFT), map(sympy.Rational, ("24/25", "-7/25", "1", "0")))
picture = R_p.xreplace(EXAMPLE)
corners = {f"{k}": picture * vector(x, y, -2) for k, (x, y) in enumerate(((-1, -1), (1, -1), (1, 1), (-1, 1)), 1)}
seen_base = picture.T * unit_base
SpaceDrawing(
    "The left image, with tip, and its center C'.  The base meets the plane of the image in the epipole E.",
    {
        "C'": vector(0, 0, 0),
        "C''": 12 * unit_base,
        "E": picture * (-2 / seen_base[2] * seen_base),
        **corners,
    },
    segments=[("C'", "C''"), ("1", "2"), ("2", "3"), ("3", "4"), ("4", "1"), *(("C'", name) for name in corners)],
    axes=("X_1", "X_2", "X_3"),
)

# %% [markdown]
# ## How do tip and swing follow?
#
# **Definition.**  $\lambda_0 (x_0, y_0, -c)^T$ is the image of the base.

# %%
lam0, x0, y0 = sympy.symbols("lam0 x0 y0")


def epipole(base_image: Matrix) -> dict[sympy.Symbol, sympy.Expr]:
    first, second, third = (over(component, lam0) for component in (*base_image[:2, :], -base_image[2]))
    return given((x0, y0, c), (first, second, third))


def equations(values: dict[sympy.Symbol, sympy.Expr]) -> list[Eq]:
    return [Eq(symbol, value) for symbol, value in values.items()]


IMAGES = (
    ("'", "left", epipole(base_left), phip, kappap),
    ("''", "right", epipole(base_right), phipp, kappapp),
)

# %% [markdown]
# **Print.**  The swing is a quotient of two coordinates, in which the factor cancels.

# %%
section.reference(
    "2.2/ref-2.3.1",
    "number of the equations for swing and tip",
    meant="2.2.1",
    note="The equation stands in section 2.2; section 2.3 has a (2.3.1) of its own, to which section 3.2 refers.",
)
for primes, image, coordinates, _, kappa in IMAGES:
    section.identity(
        f"2.2/2.3.1#kappa{primes}",
        f"swing of the {image} image",
        derived=tan(kappa),
        constraints=equations(coordinates),
    )

# %% [markdown]
# **And the tip?**  The root $\sqrt{x_0^2 + y_0^2}$ is $\cos\varphi / |\lambda_0|$.  With the factors positive, as in
# the displays, the sign of $\sin\varphi = \mp c \lambda_0$ differs between the images.

# %%
for primes, image, coordinates, phi, _ in IMAGES:
    section.identity(
        f"2.2/root{primes}",
        f"the root of the {image} image",
        derived=over(cos(phi), Abs(lam0)),
        constraints=equations(coordinates),
        assumptions=[cos(phi) > 0],
    )
section.identity(
    "2.2/2.3.1#phi'",
    "tip of the left image",
    derived=tan(phip),
    constraints=equations(IMAGES[0][2]),
    assumptions=[lam0 > 0, cos(phip) > 0],
)
section.identity(
    "2.2/2.3.1#phi''",
    "tip of the right image",
    derived=tan(phipp),
    constraints=equations(IMAGES[1][2]),
    assumptions=[lam0 > 0, cos(phipp) > 0],
    expect="error",
    corrected=over(c, sqrt(x0**2 + y0**2)),
    note="The equation is printed for both images.  With a positive factor lambda0'', that is x0'' < 0 if cos kappa'' "
    "> 0, the minus sign of the image of the base turns the sign around: in the example x0'' is -178.264 and phi'' "
    "+17.799 gon, not -17.8.  Ruled out: a negative factor, which means x0'' > 0, and a swing near 200 gon, which the "
    "correlation excludes, because it ties the signs of both epipoles (2.2/beyond/epipoles).",
    follows="The tip of the right image gets the wrong sign. In the example it is {4/approximate#phipp} gon, and the "
    "printed formula gives the negative of it.",
)

# %% [markdown]
# **One equation for both images**, whatever the sign of the factor, has the swing in it:

# %%
for primes, image, coordinates, phi, kappa in IMAGES:
    section.identity(
        f"2.2/beyond/phi{primes}",
        f"tip of the {image} image with its sign",
        printed=-c * cos(kappa) / x0,
        constraints=equations(coordinates),
        derived=tan(phi),
    )

# %% [markdown]
# ## How does the tilt follow?
#
# **Definition.**  The third column of (2.1.3), with $k'_2 = 0$ and $\mathbf k''$ of (2.1.1).

# %%
i2, i3, j2, j3, k3 = sympy.symbols("i2p i3p j2p j3p k3p")
c32, z13, z23, z33 = sympy.symbols("c32 z13 z23 z33")
left = R_left.subs(sympy.Symbol("k2p"), 0)
column = correlation(left, R_pp, unit_base).col(2)
SIGN = (
    "The sign of the whole left side is missing: c13 = i3' k2'' - i2' k3'' with k2'' = -sin Omega'' cos phi'' and "
    "k3'' = cos Omega'' cos phi''.  The last of the three equations has its sign, and (2.3.2) needs this one: from the "
    "printed one the tangent would follow with the opposite sign, and with that of i3' or j3' changed.  A slip of the "
    "scan cannot be told from one of the print."
)
for place, (u2, u3) in enumerate(((i2, i3), (j2, j3))):
    section.identity(
        f"2.2/tilt#{place + 1}3",
        f"element c{place + 1}3",
        derived=column[place],
        expect="misprint",
        corrected=-(u2 * cos(Omegapp) + u3 * sin(Omegapp)) * cos(phipp),
        note=SIGN,
        same_as="2.2/tilt#13" if place else "",
    )
section.identity("2.2/tilt#33", "element c33", derived=column[2])
OF_C = equations(given((z13, z23, z33), (over(element, c32) for element in column)))
section.identity("2.2/cosine", "cosine of the tip from the last equation", constraints=OF_C, derived=cos(phipp))

# %% [markdown]
# **Print.**  Put into the first or the second equation, it gives the tangent of the tilt: two forms, which agree for an
# exact matrix of correlation.  The tangent gives the tilt up to 200 gon.

# %%
section.reference(
    "2.2/ref-2.3.2",
    "number of the equations for the tilt",
    meant="2.2.2",
    note="The same slip as 2.2/ref-2.3.1.",
    same_as="2.2/ref-2.3.1",
)
section.identity(
    "2.2/2.3.2", "both forms of the tangent of the tilt", constraints=OF_C, derived=vector(*(tan(Omegapp),) * 2)
)

# %% [markdown]
# Would other elements do?  None of the derivatives of the nine elements with respect to the tilt, or to the tangent of
# its half, is zero: any will do.

# %%
section.structure(
    "2.2/any",
    "the tilt occurs in every element of the matrix of correlation",
    printed=Matrix(3, 3, sympy.symbols("d:3:3")),
    derived=C_rational.applyfunc(lambda element: diff(element, t3)),
)

# %% [markdown]
# ### When do the two forms agree?
#
# For a measured $\mathbf Z$ the two forms differ, unless the left epipole satisfies the equation of the third column,
# the third component of $\mathbf Z^T \mathbf x'_0 = \mathbf 0$.

# %%
AT_LEFT = {
    symbol: R_p[row, column_] for row, column_, symbol in ((1, 0, i2), (2, 0, i3), (1, 1, j2), (2, 1, j3), (2, 2, k3))
}
third_component = dot(R_p.row(0), vector(z13, z23, z33))
first_product = (z33 * i2 * (z23 * k3 - z33 * j3)).xreplace(AT_LEFT)
second_product = (z33 * j2 * (z13 * k3 - z33 * i3)).xreplace(AT_LEFT)
section.identity(
    "2.2/symmetric",
    "the two forms agree where the epipole satisfies the equation of the third column",
    printed=first_product,
    derived=second_product,
    constraints=[third_component],
    witness=given((*ANGLES[:2], z13, z23, z33), (0, 0, 0, 5, 4)),
)

# %% [markdown]
# If $\det \mathbf Z = 0$, the epipole satisfies all three equations and the forms agree, even where $\mathbf Z$ is no
# correlation of calibrated images.  The condition is necessary as well, unless $z_{33} = 0$:

# %%
section.identity(
    "2.2/beyond/difference",
    "difference of the two forms",
    printed=-z33 * third_component,
    derived=first_product - second_product,
)

# %% [markdown]
# ## Which other angles have the same matrix?
#
# $\mathbf Z$ has no sign, and neither has an epipole.  Two changes of the angles change no more than the sign of
# $\mathbf C$.  Half a turn of the tilt: points in front of both images tell the two apart.  And half a turn of the
# model about its third axis, which makes the base point the other way; $\cos\kappa' > 0$ excludes it.


# %%
C = correlation(R_p, R_pp, unit_base)


def with_other_angles(angles: dict[sympy.Symbol, sympy.Expr]) -> Matrix:
    """Return the matrix of correlation of other angles, as it stands."""
    with sympy.evaluate(False):
        return C.xreplace(angles)


section.identity(
    "2.2/beyond/opposite",
    "a tilt that differs by half a turn changes the sign of the matrix",
    printed=-C,
    derived=with_other_angles({Omegapp: Omegapp + pi}),
)
section.identity(
    "2.2/beyond/half-turn",
    "both swings increased by half a turn and the other angles reversed change the sign of the matrix",
    printed=-C,
    derived=with_other_angles(
        {phip: -phip, kappap: kappap + pi, Omegapp: -Omegapp, phipp: -phipp, kappapp: kappapp + pi}
    ),
)

# %% [markdown]
# **Nothing else is ambiguous**, for the adjugate ties the signs of both epipoles: it is $\mathbf x''_0 \mathbf x'^T_0$
# (section 1.2), with both vectors along the base.  A multiple of each with the right sign, if $i'_1 > 0$:

# %%
u, v = vector(*sympy.symbols("u1:4")), vector(*sympy.symbols("v1:4"))
A = u * v.T
section.identity(
    "2.2/beyond/epipoles",
    "both epipoles with their signs from the adjugate",
    printed=Matrix.hstack(dot(u, u) * v[0] * v, dot(u, u) * dot(v, v) * v[0] * u),
    derived=Matrix.hstack(A.T * A * e1, A * A.T * A * e1),
)

# %% [markdown]
# The tilt from the third column of $\mathbf R' \mathbf C$ uses all three equations of that column.  The factor of
# $\mathbf C$ cancels from the tangent.

# %%
turned = R_p * C
section.identity(
    "2.2/beyond/tilt",
    "cosine and sine of the tilt from the matrix and the left orientation",
    printed=vector(-cos(Omegapp) * cos(phipp), -sin(Omegapp) * cos(phipp)),
    derived=vector(turned[1, 2], turned[2, 2]),
)
