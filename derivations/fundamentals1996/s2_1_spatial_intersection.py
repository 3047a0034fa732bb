# %% [markdown]
# # 2.1 Spatial intersection and the matrix of correlation
#
# Two images $P'$ and $P''$ of one object.  Where the two rays to an object point meet, their directions and the base
# are coplanar; written in image coordinates this is one bilinear equation, and its coefficients are the matrix of
# correlation $\mathbf C$.  In the names of symbols a letter `p` stands for one prime and `pp` for two; the elements of
# $\mathbf P'$ and $\mathbf P''$ are $p_{ij}$ and $q_{ij}$.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    cross,
    determinant,
    dot,
    homogeneous,
    inverse,
    over,
    rows,
    solve,
    vector,
)

section = Section("fundamentals1996", "2.1", "Spatial intersection and the matrix of correlation")

# %% [markdown]
# ## The base
#
# By (1.1.4) a ray goes from the center to the object point: $\mathbf y - \mathbf y'_0 = \mu' \mathbf p'$ and
# $\mathbf y - \mathbf y''_0 = \mu'' \mathbf p''$.  The base $\mathbf d$ is the difference of the two.

# %%
factor_left, factor_right = sympy.symbols("mup mupp")
point = vector(y1, y2, y3)
center_left = vector(*sympy.symbols("yp01 yp02 yp03"))
center_right = vector(*sympy.symbols("ypp01 ypp02 ypp03"))
to_point_left, to_point_right = point - center_left, point - center_right

d = vector(*sympy.symbols("d1 d2 d3"))
base = to_point_left - to_point_right
p_left, p_right = (vector(*sympy.symbols(f"{name}1 {name}2 {name}3")) for name in ("pp", "ppp"))
seen_from_centers = {
    **dict(zip(d, base, strict=True)),
    **{symbol: over(entry, factor_left) for symbol, entry in zip(p_left, to_point_left, strict=True)},
    **{symbol: over(entry, factor_right) for symbol, entry in zip(p_right, to_point_right, strict=True)},
}

section.identity(
    "2.1/d",
    "base of the two centers",
    printed=center_left - center_right,
    derived=base,
    expect="misprint",
    corrected=center_right - center_left,
    note="With the printed base (2.1.1) would hold for rays from the object to the centers, but (1.1.4), on which the "
    "section goes on to build, has mu p = y - y0; a negative sign of both mu, or an interchange of the two images, "
    "would contradict (1.1.4) and (2.1.1).  In all that is homogeneous in d the sign does not matter.  The scan alone "
    "cannot tell a slip of the scan from one of the print.",
)
section.identity(
    "2.1.1",
    "spatial intersection",
    printed=columns(factor_left * p_left, d + factor_right * p_right),
    where=seen_from_centers,
    derived=columns(to_point_left, to_point_left),
    note="Both sides are held against the ray from the left center to the object point, with d = y''0 - y'0; see "
    "2.1/d for its sign.",
)

# %% [markdown]
# ## Coplanarity
#
# The vector product with $\mathbf d$ and then the scalar product with $\mathbf p''$ leave nothing of the right side of
# (2.1.1).

# %%
section.identity(
    "2.1/p''",
    "triple product with a repeated vector",
    printed=0,
    derived=dot(cross(p_right, d), p_right),
)
section.identity(
    "2.1.2",
    "condition of coplanarity",
    printed=0,
    derived=dot(cross(p_left, d), p_right).xreplace(seen_from_centers),
)

# %% [markdown]
# The vector product is a product with a skew-symmetric matrix, $\mathbf D \mathbf v = \mathbf d \times \mathbf v$ and
# $\mathbf v^T \mathbf D = (\mathbf v \times \mathbf d)^T$.

# %%
D_printed = Matrix([[0, -d[2], d[1]], [d[2], 0, -d[0]], [-d[1], d[0], 0]])
unit_vectors = (vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1))
D = columns(*(cross(d, unit) for unit in unit_vectors))

section.identity(
    "2.1/D",
    "the vector product with the base as a product of matrices",
    printed=D_printed.T * p_left,
    derived=cross(p_left, d),
    note="The row vector of the print is compared as a column.",
)

# %% [markdown]
# ## The matrix of correlation
#
# A ray is $\mathbf p = \mathbf P \mathbf u$.  The condition of coplanarity becomes bilinear in the image coordinates;
# its coefficients are $c_{ij} = (\mathbf p'_i \times \mathbf d) \cdot \mathbf p''_j$ with the columns of $\mathbf P'$
# and $\mathbf P''$.

# %%
P_left, P_right = (Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in ("p", "q"))
columns_left, columns_right = ([P.col(j) for j in range(3)] for P in (P_left, P_right))
u_left, u_right = (homogeneous(vector(*sympy.symbols(f"{name}1 {name}2"))) for name in ("up", "upp"))
C = Matrix(3, 3, lambda i, j: dot(cross(columns_left[i], d), columns_right[j]))
C_elements = Matrix(3, 3, sympy.symbols("c:3:3"))
correlation = dict(zip(C_elements, C, strict=True))
triple = dot(cross(P_left * u_left, d), P_right * u_right)

section.identity(
    "2.1.3",
    "condition of coplanarity in image coordinates",
    printed=vector(
        (p_left.T * D_printed * p_right)[0],
        (u_left.T * P_left.T * D_printed * P_right * u_right)[0],
        (u_left.T * C_elements * u_right)[0],
    ),
    where=correlation
    | dict(zip(p_left, P_left * u_left, strict=True))
    | dict(zip(p_right, P_right * u_right, strict=True)),
    derived=vector(triple, triple, triple),
)
section.identity(
    "2.1.4",
    "matrix of correlation, as a product",
    printed=P_left.T * D_printed * P_right,
    derived=C,
    note="Read as rows p'_j^T and columns p''_j: the scan has the vectors of both matrices one below the other, and "
    "the T of a transposition behind the first stack.  (2.1.9) has the same product with the transpositions in their "
    "places.",
)
p0_left, p1_left, p2_left = columns_left
p0_right, p1_right, p2_right = columns_right
section.identity(
    "2.1.4#components",
    "matrix of correlation, by components",
    printed=Matrix(
        [
            [dot(cross(p0_left, d), p0_right), dot(cross(p0_left, d), p1_right), dot(cross(p0_left, d), p2_right)],
            [dot(cross(p1_left, d), p0_right), dot(cross(p1_left, d), p1_right), dot(cross(p1_left, d), p2_right)],
            [dot(cross(p2_left, d), p0_right), dot(cross(p2_left, d), p1_right), dot(cross(p2_left, d), p2_right)],
        ]
    ),
    derived=P_left.T * D * P_right,
)

# %% [markdown]
# Homologous points are images of one object point.  With $\mathbf u'$ and $\mu'$ given, the ray of $P'$ ends at the
# object point, and $\mu'' \mathbf u'' = \mathbf P''^* (\mu' \mathbf P' \mathbf u' - \mathbf d)$.

# %%
ray_left = factor_left * P_left * u_left
ray_right = ray_left - d
projected = solve(P_right, ray_right)
homologous = {
    factor_right: projected[0],
    u_right[1]: over(projected[1], projected[0]),
    u_right[2]: over(projected[2], projected[0]),
}
seen_right = u_right.xreplace(homologous)

section.identity(
    "2.1.3#homologous",
    "homologous points satisfy the equation",
    printed=0,
    derived=dot(u_left, C * seen_right),
)

# %% [markdown]
# ## 1. The determinant

# %%
section.identity("2.1/det-D", "the matrix of the base is singular", printed=0, derived=determinant(D))
section.identity("2.1/det-C", "the matrix of correlation is singular", printed=0, derived=determinant(C))

# %% [markdown]
# ## 2. The dual transformations
#
# A point of one image is transformed to a line of the other: the line on which its homologous point lies.

# %%
h_left, h_right = (vector(*sympy.symbols(f"{name}0 {name}1 {name}2")) for name in ("hp", "hpp"))

section.definition("2.1.5", "dual transformations", printed=columns((u_left.T * C_elements).T, C_elements * u_right))
section.identity(
    "2.1/lines",
    "homologous points lie on the lines",
    printed=vector(0, 0),
    derived=vector(dot(C * seen_right, u_left), dot(C.T * u_left, seen_right)),
    note="h'^T u' = 0 with h' = C u'', and h''^T u'' = 0 with h'' = C^T u'.",
)
section.up_to_scale(
    "2.1/locus",
    "the line is the image of the ray",
    printed=C.T * u_left,
    derived=cross(solve(P_right, -d), solve(P_right, P_left * u_left)),
    note="The sentence of item 4 on the loci of homologous points.  Derived is the line through the images of the left "
    "center and of the point at infinity of the left ray.",
)

# %% [markdown]
# ## 3. The epipoles
#
# An epipole is the image of the other center of projection.

# %%
inverse_left, inverse_right = (Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in ("ps", "qs"))
inverses = dict(zip(inverse_left, inverse(P_left), strict=True)) | dict(
    zip(inverse_right, inverse(P_right), strict=True)
)
at_centers = dict(zip(d, center_right - center_left, strict=True))

section.up_to_scale(
    "2.1/epipoles#left",
    "epipole in P'",
    printed=inverse_left * d,
    where=inverses | at_centers,
    derived=solve(P_left, center_right - center_left),
    note="The factor mu_0 of the print is free.",
)
section.up_to_scale(
    "2.1/epipoles#right",
    "epipole in P''",
    printed=inverse_right * d,
    where=inverses | at_centers,
    derived=solve(P_right, center_left - center_right),
    note="The factor mu_0 of the print is free; here it takes the sign, for the left center lies in direction -d.",
)
epipole_left, epipole_right = solve(P_left, d), solve(P_right, d)

section.definition(
    "2.1/inverse",
    "matrices of projection and reconstruction",
    printed=inverse(P_left) * P_left,
    note="P* is the inverse of P by (1.1.5).",
)
section.identity("2.1/Dd", "the base annihilates itself", printed=vector(0, 0, 0), derived=D * d)
section.identity(
    "2.1/Cu0''",
    "dual transformation of the epipole of P''",
    printed=columns(P_left.T * D_printed * P_right * (inverse_right * d), vector(0, 0, 0)),
    where=inverses,
    derived=columns(C * epipole_right, C * epipole_right),
    note="Both sides of the chain, the product and zero, are held against C u''0.",
)
section.identity(
    "2.1/u0'C",
    "dual transformation of the epipole of P'",
    printed=(d.T * inverse_left.T * P_left.T * D_printed * P_right).T,
    where=inverses,
    derived=C.T * epipole_left,
    note="u'0^T = d^T P'*^T has the three marks that are lost, and the line above has all of its own.",
)
section.identity(
    "2.1/u0'C#zero",
    "the left epipole is annihilated",
    printed=vector(0, 0, 0),
    derived=C.T * epipole_left,
)
section.identity(
    "2.1.6",
    "equations for the epipoles",
    printed=columns(vector(0, 0, 0), vector(0, 0, 0)),
    derived=columns(
        C.T.xreplace(at_centers) * solve(P_left, center_right - center_left),
        C.xreplace(at_centers) * solve(P_right, center_left - center_right),
    ),
    note="Put in are the images of the centers.",
)
section.rank(
    "2.1/rank-C",
    "the rank of the matrix of correlation",
    printed=2,
    derived=C,
    kernel=[epipole_right],
    note="The equations (2.1.6) are consistent, and fix the epipoles as long as the rank is 2.",
)

# %% [markdown]
# That $\mathbf C$ alone gives the epipoles: the solution of two of the three equations is the vector product of their
# coefficients.

# %%
section.up_to_scale(
    "2.1.6#right",
    "epipole of P'' from the matrix of correlation",
    printed=cross(C[1, :].T, C[2, :].T),
    derived=epipole_right,
)
section.up_to_scale(
    "2.1.6#left",
    "epipole of P' from the matrix of correlation",
    printed=cross(C[:, 1], C[:, 2]),
    derived=epipole_left,
)

# %% [markdown]
# ## 4. Epipolar lines
#
# Whatever the point $\mathbf u'$ is, its line goes through the epipole.

# %%
section.identity(
    "2.1/epipolar-line",
    "every line h'' contains the epipole of P''",
    printed=vector(0, 0),
    derived=vector(dot(C.T * u_left, epipole_right), dot(u_left, C * epipole_right)),
    note="The scan begins this item with 'transformation P' -> P'''; u' -> h'' is meant, as in item 2.",
)
section.identity(
    "2.1/beyond/epipolar-line-left",
    "every line h' contains the epipole of P'",
    printed=0,
    derived=dot(C * u_right, epipole_left),
    note="Not in the paper: the other image.",
)

# %% [markdown]
# ## 5. Relations with both factors
#
# $\mathbf D$ takes the base away: $\mathbf D \mathbf z' = \mathbf D \mathbf z''$ for the two rays
# $\mathbf z' = \mathbf d + \mathbf z''$ to one point.  The derived sides below are
# $\mathbf d \times \mathbf z'$ and what $\mathbf P'^T$ and $\mathbf P''^T$ make of it.

# %%
moment = cross(d, ray_left)
moment_left, moment_right = P_left.T * moment, P_right.T * moment
mu_u_right = factor_right * u_right
lines = dict(zip(h_left, C * seen_right, strict=True)) | dict(zip(h_right, C.T * u_left, strict=True))

section.identity(
    "2.1/intersection",
    "spatial intersection in image coordinates",
    printed=columns(factor_left * P_left * u_left, d + P_right * mu_u_right),
    where=homologous,
    derived=columns(ray_left, ray_left),
)
section.identity(
    "2.1.7",
    "symmetric relation between the image coordinates",
    printed=columns(D_printed * (factor_left * P_left * u_left), D_printed * (P_right * mu_u_right)),
    where=homologous,
    derived=columns(moment, moment),
)
section.identity(
    "2.1.8#left",
    "first equation: first, third and fourth member",
    printed=columns(
        P_left.T * (D_printed * (P_left * (factor_left * u_left))),
        C_elements * mu_u_right,
        factor_right * h_left,
    ),
    where=correlation | homologous | lines,
    derived=columns(moment_left, moment_left, moment_left),
)
section.identity(
    "2.1.8#left-second",
    "first equation: second member",
    printed=P_right.T * (D_printed * (P_right * mu_u_right)),
    where=homologous,
    derived=moment_left,
    expect="error",
    corrected=P_left.T * (D_printed * (P_right * mu_u_right)),
    note="The first factor must be P'^T, and in the second equation P''^T: the same exchange twice, in products that "
    "exist, so that the scan alone did not make it.  The equation is (2.1.7) multiplied from the left by P'^T on both "
    "sides, and its third member, mu'' C u'', needs C = P'^T D P''.  An interchange of the images changes all members.",
    follows="The second members are those of the other image. Who used them would get the moment of the wrong bundle; "
    "the first and third members are right.",
)
section.identity(
    "2.1.8#right",
    "second equation: first, third and fourth member",
    printed=columns(
        P_right.T * (D_printed * (P_right * mu_u_right)),
        -factor_left * C_elements.T * u_left,
        -factor_left * h_right,
    ),
    where=correlation | homologous | lines,
    derived=columns(moment_right, moment_right, moment_right),
)
section.identity(
    "2.1.8#right-second",
    "second equation: second member",
    printed=P_left.T * (D_printed * (P_left * (factor_left * u_left))),
    derived=moment_right,
    expect="error",
    corrected=P_right.T * (D_printed * (P_left * (factor_left * u_left))),
    note="The first factor must be P''^T, as in the first equation it must be P'^T: see 2.1.8#left-second.",
    same_as="2.1.8#left-second",
)
section.identity(
    "2.1/D-skew",
    "the matrix of the base is skew-symmetric",
    printed=-D_printed,
    derived=D.T,
)

# %% [markdown]
# ## The matrix K
#
# $\mathbf K = \mathbf P^T \mathbf D \mathbf P$ belongs to one image, $\mathbf P = \mathbf P'$ or
# $\mathbf P = \mathbf P''$.  Its elements are the triple products of the base and two columns of $\mathbf P$; with the
# rows $\mathbf p^j$ of $\mathbf P^*$, the reciprocal vectors of the columns, they are
# $\mathbf p_i \times \mathbf p_j = \det(\mathbf P)\, \mathbf p^k$, for $i, j, k$ cyclic.

# %%
P, P_inverse = P_left, inverse_left
p0, p1, p2 = columns_left
K = Matrix(3, 3, lambda i, j: dot(P.col(i), cross(d, P.col(j))))
kappa0, kappa1, kappa2 = sympy.symbols("kappa0 kappa1 kappa2")
kappa = vector(kappa0, kappa1, kappa2)
kappa_elements = vector(K[2, 1], K[0, 2], K[1, 0])
DET = sympy.Symbol("D")


def skew(a: sympy.Expr, b: sympy.Expr, c: sympy.Expr) -> Matrix:
    """Return the pattern that (2.1.9) prints four times."""
    return Matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]])


section.rank(
    "2.1/rank-K",
    "the rank of the products on the left of (2.1.8)",
    printed=2,
    derived=K,
    kernel=[solve(P, d)],
    note="The sentence names C as well: see 2.1/rank-C.",
)
section.identity(
    "2.1.9#product",
    "K as a product",
    printed=rows(p0, p1, p2) * D_printed * columns(p0, p1, p2),
    derived=K,
)
section.identity(
    "2.1.9#triple",
    "K by triple products with the base in the middle",
    printed=Matrix(
        [
            [0, dot(cross(p0, d), p1), dot(cross(p0, d), p2)],
            [dot(cross(p1, d), p0), 0, dot(cross(p1, d), p2)],
            [dot(cross(p2, d), p0), dot(cross(p2, d), p1), 0],
        ]
    ),
    derived=P.T * D * P,
)
section.identity(
    "2.1.9#volume",
    "K by triple products with the base at the end",
    printed=skew(dot(cross(p1, p2), d), dot(cross(p2, p0), d), dot(cross(p0, p1), d)),
    derived=P.T * D * P,
)
reciprocal_products = [dot(P_inverse.row(j), d) for j in range(3)]
section.identity(
    "2.1.9#reciprocal",
    "K by the rows of the matrix of projection",
    printed=skew(*reciprocal_products) / DET,
    where={DET: determinant(P)} | inverses,
    derived=P.T * D * P,
    expect="error",
    corrected=DET * skew(*reciprocal_products),
    note="The factor is D = det(P), not 1/D: the reciprocal vectors of (1.1.3) are cross products divided by D, hence "
    "the cross products are D times the reciprocal vectors.  1/D is right if D is the determinant of P*, but the text "
    "defines D = det(P); with the adjugate of P for P* the factor would be 1.  The factor as a whole is "
    "inverted, which no single sign or letter explains.",
    follows="K differs from its definition by the factor det(P)^2. Epipoles, which are homogeneous, do not notice "
    "it. The relations (2.1.13), which have no free factor, do.",
)
section.structure("2.1.9#kappa", "K is skew-symmetric", printed=skew(*kappa), derived=P.T * D * P)
section.identity(
    "2.1/beyond/kappa",
    "the three elements of K are the projection of the base",
    printed=DET * (P_inverse * d),
    where={DET: determinant(P)} | inverses,
    derived=kappa_elements,
    note="Not in the paper: kappa = det(P) P* d, which is why (2.1.12) gives the epipole.",
)

# %% [markdown]
# ## Points, lines and epipoles of one image

# %%
K_left = K
K_right = P_right.T * D * P_right
section.identity(
    "2.1.10#left",
    "dual relation in P'",
    printed=over(factor_right, factor_left) * h_left,
    where=homologous | lines,
    derived=K_left * u_left,
)
section.identity(
    "2.1.10#right",
    "dual relation in P''",
    printed=-over(factor_left, factor_right) * h_right,
    where=homologous | lines,
    derived=K_right * seen_right,
)
section.identity(
    "2.1.11",
    "K annihilates the epipole",
    printed=vector(0, 0, 0),
    derived=K * solve(P, d),
    note="For either image; the scan shows the primes of either as a superscript theta or (i).",
)
projected_base = solve(P, d)
section.identity(
    "2.1.12",
    "epipole from the elements of K",
    printed=kappa / kappa0,
    where=dict(zip(kappa, kappa_elements, strict=True)),
    derived=homogeneous(vector(over(projected_base[1], projected_base[0]), over(projected_base[2], projected_base[0]))),
    note="For either image: the epipole of P'' is the projection of -d, with the same quotients.",
)

# %% [markdown]
# ## The basic points
#
# For the basic point $G_j$ the equations (2.1.8) hold with $\mathbf u = \mathbf e'_j$, and its factor $\mu_j$ is a
# parameter of orientation.  As in section 1.2 the rays to $G_0, G_1, G_2$ and $\mu_0, \mu_1, \mu_2$ fix
# $\mathbf P$, and $\mathbf P^*$ fixes $\mu_3$ and $\mathbf u_3$.  The base vectors are
# $\mathbf b_j = (\mathbf e_j - \mathbf y_0) / \mu_j$.

# %%
parameters_left, parameters_right = (vector(*sympy.symbols(f"{name}:4")) for name in ("mup", "mupp"))
fourth_left, fourth_right = (vector(*sympy.symbols(f"{name}31 {name}32")) for name in ("up", "upp"))
object_units = (e0, e1, e2, e3)


def reconstruction_of_basic_points(center: Matrix, parameters: Matrix) -> Matrix:
    b0, b1, b2 = ((object_units[j] - center) / parameters[j] for j in range(3))
    return columns(b0, b1 - b0, b2 - b0)


def fourth_point(center: Matrix, parameters: Matrix, image: Matrix) -> dict[sympy.Symbol, sympy.Expr]:
    seen = solve(reconstruction_of_basic_points(center, parameters), e3 - center)
    return {parameters[3]: seen[0], image[0]: over(seen[1], seen[0]), image[1]: over(seen[2], seen[0])}


def weighted_images(parameters: Matrix, image: Matrix) -> list[Matrix]:
    image_units = (image_e0, image_e1, image_e2, homogeneous(image))
    return [parameter * unit for parameter, unit in zip(parameters, image_units, strict=True)]


at_left = dict(zip(P_left, reconstruction_of_basic_points(center_left, parameters_left), strict=True))
at_right = dict(zip(P_right, reconstruction_of_basic_points(center_right, parameters_right), strict=True))
at_basic_points = at_left | at_right | at_centers
fourth_points = fourth_point(center_left, parameters_left, fourth_left) | fourth_point(
    center_right, parameters_right, fourth_right
)
images_left = weighted_images(parameters_left, fourth_left)
images_right = weighted_images(parameters_right, fourth_right)
moments = columns(*(cross(center_right - center_left, unit - center_left) for unit in object_units))

section.identity(
    "2.1.13#left",
    "first relation for the four basic points",
    printed=columns(*(K_left * image for image in images_left), *(C * image for image in images_right)),
    where=at_basic_points | fourth_points,
    derived=columns((P_left.T).xreplace(at_left) * moments, (P_left.T).xreplace(at_left) * moments),
    note="The columns are the left sides for j = 0, 1, 2, 3 and then the right sides.",
)
section.identity(
    "2.1.13#right",
    "second relation for the four basic points",
    printed=columns(*(K_right * image for image in images_right), *(-C.T * image for image in images_left)),
    where=at_basic_points | fourth_points,
    derived=columns((P_right.T).xreplace(at_right) * moments, (P_right.T).xreplace(at_right) * moments),
    note="The columns are the left sides for j = 0, 1, 2, 3 and then the right sides.",
)
