# %% [markdown]
# # 2.1 Spatial intersection and the matrix of correlation
#
# Two images $P'$ and $P''$ of one object: what does one of them know of the other?  The two rays to an object point
# meet, so their directions and the base are coplanar.  In image coordinates this is one bilinear equation.  Its
# coefficients are the matrix of correlation $\mathbf C$.
#
# In the names of symbols a letter `p` stands for one prime and `pp` for two.  The elements of $\mathbf P'$ and
# $\mathbf P''$ are $p_{ij}$ and $q_{ij}$.

# %%
import sympy
from sympy import BlockMatrix, Determinant, Eq, ImmutableMatrix, MatrixSymbol

from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    cross,
    determinant,
    diff,
    dot,
    homogeneous,
    inverse,
    over,
    solve,
    vector,
)
from algebroproj_sym.expressions.letters import Cross, Dot, Skew, Vee

section = Section("fundamentals1996", "2.1", "Spatial intersection and the matrix of correlation")

# %% [markdown]
# ## The base
#
# **Definition.**  By (1.1.4) a ray goes from the center to the object point: $\mathbf y - \mathbf y'_0 = \mu' \mathbf
# p'$ and $\mathbf y - \mathbf y''_0 = \mu'' \mathbf p''$.  The base $\mathbf d$ is what remains of the object point
# in the difference of the two.

# %%
mup, mupp = sympy.symbols("mup mupp")
y, yp0, ypp0, pp, ppp, d_bold = (MatrixSymbol(name, 3, 1) for name in ("y", "yp0", "ypp0", "pp", "ppp", "d"))
base = (y - yp0) - (y - ypp0)
seen_from_centers = [Eq(y, yp0 + mup * pp), Eq(ypp0, y - mupp * ppp), Eq(d_bold, base)]
base

# %% [markdown]
# **Print.**  $\mathbf y'_0 - \mathbf y''_0$, the opposite one.

# %%
section.identity(
    "2.1/d",
    "base of the two centers",
    derived=base,
    expect="misprint",
    corrected=ypp0 - yp0,
    note="Ruled out: a negative sign of both mu, or an interchange of the two images, would contradict (1.1.4) and "
    "(2.1.1).  The scan alone cannot tell a slip of the scan from one of the print.",
)

# %% [markdown]
# (2.1.1) is right with $\mathbf d = \mathbf y''_0 - \mathbf y'_0$.  Both sides are held against the ray from the left
# center to the object point.  In all that is homogeneous in $\mathbf d$ the sign does not matter.

# %%
section.identity(
    "2.1.1",
    "spatial intersection",
    constraints=seen_from_centers,
    derived=BlockMatrix([[y - yp0, y - yp0]]),
)

# %% [markdown]
# ## When do two rays meet?
#
# The vector product of (2.1.1) with $\mathbf d$, and then the scalar product with $\mathbf p''$, leave nothing of its
# right side.

# %%
section.identity("2.1/p''", "triple product with a repeated vector", derived=Dot(Cross(ppp, d_bold), ppp))
section.identity(
    "2.1.2",
    "condition of coplanarity",
    constraints=seen_from_centers,
    nonzero=[mup, mupp],
    derived=Dot(Cross(pp, d_bold), ppp),
)

# %% [markdown]
# The vector product is a product with a skew-symmetric matrix: $\mathbf D \mathbf v = \mathbf d \times \mathbf v$,
# and the row $\mathbf v^T \mathbf D$ is $\mathbf v \times \mathbf d$.  Its elements:

# %%
d = vector(*sympy.symbols("d1 d2 d3"))
ray = vector(*sympy.symbols("pp1 pp2 pp3"))
D_printed = Matrix([[0, -d[2], d[1]], [d[2], 0, -d[0]], [-d[1], d[0], 0]])
unit_vectors = (vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1))
D = columns(*(cross(d, unit) for unit in unit_vectors))
D

# %%
section.identity(
    "2.1/D",
    "the vector product with the base as a product of matrices",
    derived=cross(ray, d),
)

# %% [markdown]
# ## The matrix of correlation
#
# **Definition.**  A ray is $\mathbf p = \mathbf P \mathbf u$.  So the condition of coplanarity is bilinear in the
# image coordinates.  Its coefficients are triple products, $c_{ij} = (\mathbf p'_i \times \mathbf d) \cdot \mathbf
# p''_j$, with the columns of $\mathbf P'$ and $\mathbf P''$.

# %%
P_left, P_right = (Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in ("p", "q"))
u_left, u_right = (homogeneous(vector(*sympy.symbols(f"{name}1 {name}2"))) for name in ("up", "upp"))


def correlation_matrix(left: Matrix, right: Matrix, base: Matrix) -> Matrix:
    """Return C from the matrices of reconstruction and the base."""
    return Matrix(3, 3, lambda i, j: dot(cross(left.col(i), base), right.col(j)))


C = correlation_matrix(P_left, P_right, d)

# %% [markdown]
# **Print.**  Three members, each of which must be the triple product of the two rays and the base.

# %%
Pp, Ppp, C_bold, D_bold = (MatrixSymbol(name, 3, 3) for name in ("Pp", "Ppp", "C", "D"))
up, upp = MatrixSymbol("up", 3, 1), MatrixSymbol("upp", 3, 1)
units = [ImmutableMatrix(unit) for unit in unit_vectors]
triple_products = ImmutableMatrix(3, 3, lambda i, j: Dot(Cross(Pp * units[i], d_bold), Ppp * units[j]))
triple = Dot(Cross(pp, d_bold), ppp)

section.identity(
    "2.1.3",
    "condition of coplanarity in image coordinates",
    constraints=[
        Eq(pp, Pp * up),
        Eq(ppp, Ppp * upp),
        Eq(D_bold, Skew(d_bold)),
        Eq(C_bold, triple_products),
    ],
    derived=ImmutableMatrix([[triple, triple, triple]]),
)

# %% [markdown]
# As a product, and by components:

# %%
section.identity(
    "2.1.4",
    "matrix of correlation, as a product",
    derived=C,
)
section.identity("2.1.4#components", "matrix of correlation, by components", derived=P_left.T * D * P_right)

# %% [markdown]
# **Do homologous points satisfy it?**  They are images of one object point $\mathbf y$.  Both rays, $\mu \mathbf P
# \mathbf u$ from their centers, end there.  From now on $\mathbf C$ is the product (2.1.4).

# %%
C_bold = Pp.T * Skew(d_bold) * Ppp
homologous = [Eq(y, yp0 + mup * Pp * up), Eq(ypp0, y - mupp * Ppp * upp), Eq(d_bold, base)]

section.identity(
    "2.1.3#homologous",
    "homologous points satisfy the equation",
    constraints=homologous,
    nonzero=[mup, mupp],
    derived=Dot(up, C_bold * upp),
)

# %% [markdown]
# By components: with $\mathbf u'$ and $\mu'$ given, the right image sees the point at $\mu'' \mathbf u'' = \mathbf
# P''^* (\mu' \mathbf P' \mathbf u' - \mathbf d)$.

# %%
projected = solve(P_right, mup * P_left * u_left - d)
seen = {
    mupp: projected[0],
    u_right[1]: over(projected[1], projected[0]),
    u_right[2]: over(projected[2], projected[0]),
}
seen_right = u_right.xreplace(seen)

# %% [markdown]
# **An example.**  Two cameras in $(0, 0, 0)$ and $(4, 0, 0)$ look at the point $P = (2, 1, 4)$.  Their matrix of
# correlation is

# %%
EXAMPLE_BASE, SEEN = vector(4, 0, 0), vector(2, 1, 4)
HALF = sympy.Rational(1, 2)
corners_left = [vector(3 * HALF, -HALF, -HALF), vector(-HALF, -HALF, 3 * HALF), vector(HALF, 1, HALF)]
corners_right = [vector(-2, 0, -1), vector(-HALF, -HALF, -HALF), vector(0, HALF, 2)]


def reconstruction(corners: list[Matrix]) -> Matrix:
    return columns(corners[0], corners[1] - corners[0], corners[2] - corners[0])


cameras = reconstruction(corners_left), reconstruction(corners_right)
correlation_matrix(*cameras, EXAMPLE_BASE)

# %% [markdown]
# and all that this section is about can be seen at once.


# %%
def pierced(camera: Matrix, direction: Matrix) -> Matrix:
    """Return where a ray of a direction meets the image plane, seen from the center."""
    return (direction / solve(camera, direction)[0]).doit()


SpaceDrawing(
    "Two centers C' and C'', and the images p' and p'' of a point P.  The rays and the base lie in one plane.  It cuts "
    "the image planes in the epipolar lines, through the epipoles E' and E''.",
    {"C'": vector(0, 0, 0), "C''": EXAMPLE_BASE, "P": SEEN}
    | {"p'": pierced(cameras[0], SEEN), "p''": EXAMPLE_BASE + pierced(cameras[1], SEEN - EXAMPLE_BASE)}
    | {"E'": pierced(cameras[0], EXAMPLE_BASE), "E''": EXAMPLE_BASE + pierced(cameras[1], -EXAMPLE_BASE)}
    | {f"G'{j}": corner for j, corner in enumerate(corners_left)}
    | {f"G''{j}": EXAMPLE_BASE + corner for j, corner in enumerate(corners_right)},
    segments=[("p'", "E'"), ("p''", "E''")],
    triangles=[("C'", "C''", "P"), ("G'0", "G'1", "G'2"), ("G''0", "G''1", "G''2")],
)

# %% [markdown]
# ## 1. The determinant
#
# $\mathbf D$ takes the base to zero.  So $\mathbf D$ is singular, and with it $\mathbf C$.

# %%
section.identity("2.1/det-D", "the matrix of the base is singular", derived=Determinant(Skew(d_bold)))
section.identity("2.1/det-C", "the matrix of correlation is singular", derived=Determinant(C_bold))

# %% [markdown]
# ## 2. Where is the partner of a point?
#
# **Definition.**  $\mathbf C$ takes a point of one image to a line of the other, $\mathbf h' = \mathbf C \mathbf u''$
# and $\mathbf h'' = \mathbf C^T \mathbf u'$.

# %%
C_elements = Matrix(3, 3, sympy.symbols("c:3:3"))

section.definition("2.1.5", "dual transformations", printed=columns((u_left.T * C_elements).T, C_elements * u_right))

# %% [markdown]
# **Meaning.**  The homologous point lies on this line.

# %%
section.identity(
    "2.1/lines",
    "homologous points lie on the lines",
    derived=vector(dot(C * seen_right, u_left), dot(C.T * u_left, seen_right)),
)

# %% [markdown]
# The line is the image of the whole ray, the locus of homologous points of which item 4 speaks.  It joins the image
# of the left center with that of the point at infinity of the left ray.

# %%
section.up_to_scale(
    "2.1/locus",
    "the line is the image of the ray",
    printed=C_bold.T * up,
    derived=Cross(Ppp.I * -d_bold, Ppp.I * Pp * up),
)

# %% [markdown]
# ## 3. The epipoles
#
# **Definition.**  An epipole is the image of the other center of projection.

# %%
inverse_left, inverse_right = (Matrix(3, 3, sympy.symbols(f"{name}:3:3")) for name in ("ps", "qs"))
inverses = given(inverse_left, inverse(P_left)) | given(inverse_right, inverse(P_right))
center_left, center_right = (vector(*sympy.symbols(f"{name}01 {name}02 {name}03")) for name in ("yp", "ypp"))
at_centers = given(d, center_right - center_left)
P_star, Pp_star, Ppp_star = (MatrixSymbol(name, 3, 3) for name in ("Ps", "Pps", "Ppps"))
between_centers = Eq(d_bold, ypp0 - yp0)

# %% [markdown]
# **Print.**  The factor $\mu_0$ is free.  For the right image it takes the sign, for the left center lies in the
# direction $-\mathbf d$.

# %%
section.up_to_scale(
    "2.1/epipoles#left",
    "epipole in P'",
    constraints=[Eq(P_star, Pp.I), between_centers],
    derived=Pp.I * (ypp0 - yp0),
)
section.up_to_scale(
    "2.1/epipoles#right",
    "epipole in P''",
    constraints=[Eq(P_star, Ppp.I), between_centers],
    derived=Ppp.I * (yp0 - ypp0),
)

# %% [markdown]
# **What does $\mathbf C$ do to an epipole?**  $\mathbf P^*$ is the inverse of $\mathbf P$ by (1.1.5), and $\mathbf D
# \mathbf d = \mathbf 0$.

# %%
epipole_left, epipole_right = solve(P_left, d), solve(P_right, d)

section.definition(
    "2.1/inverse",
    "matrices of projection and reconstruction",
    printed=inverse(P_left) * P_left,
)
section.identity("2.1/Dd", "the base annihilates itself", derived=Skew(d_bold) * d_bold)

# %% [markdown]
# So the epipole of $P''$ is annihilated.  Both sides of the chain, the product and zero, are held against $\mathbf C
# \mathbf u''_0$.

# %%
section.identity(
    "2.1/Cu0''",
    "dual transformation of the epipole of P''",
    constraints=[Eq(D_bold, Skew(d_bold)), Eq(Ppp_star, Ppp.I)],
    derived=BlockMatrix([[C_bold * Ppp.I * d_bold, C_bold * Ppp.I * d_bold]]),
)

# %% [markdown]
# The other chain is for the epipole of $P'$.

# %%
section.identity(
    "2.1/u0'C",
    "dual transformation of the epipole of P'",
    constraints=[Eq(D_bold, Skew(d_bold)), Eq(Pp_star, Pp.I)],
    derived=(Pp.I * d_bold).T * C_bold,
)
section.identity("2.1/u0'C#zero", "the left epipole is annihilated", derived=(Pp.I * d_bold).T * C_bold)

# %% [markdown]
# **Meaning.**  The epipoles are the solutions of $\mathbf C^T \mathbf u'_0 = \mathbf 0$ and $\mathbf C
# \mathbf u''_0 = \mathbf 0$.  The images of the centers satisfy them.  As long as the rank is 2 there are no others.

# %%
section.identity(
    "2.1.6",
    "equations for the epipoles",
    constraints=[between_centers],
    derived=BlockMatrix([[C_bold.T * Pp.I * (ypp0 - yp0), C_bold * Ppp.I * (yp0 - ypp0)]]),
)
section.rank(
    "2.1/rank-C",
    "the rank of the matrix of correlation",
    derived=Pp.T * Skew(d_bold) * Ppp,
    kernel=[Ppp.I * d_bold],
)

# %% [markdown]
# So $\mathbf C$ alone gives the epipoles, without any camera.  The solution of two of the three equations is the vector
# product of their coefficients.

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
# Whatever the point $\mathbf u'$ is, its line goes through the epipole of the other image.  All lines of an image meet
# there.  The scan begins the item with 'transformation $P'$ to $P''$'; $\mathbf u'$ to $\mathbf h''$ is meant.

# %%
section.identity(
    "2.1/epipolar-line",
    "every line h'' contains the epipole of P''",
    derived=ImmutableMatrix([[Dot(C_bold.T * up, Ppp.I * d_bold), Dot(up, C_bold * Ppp.I * d_bold)]]),
)
section.identity(
    "2.1/beyond/epipolar-line-left",
    "every line h' contains the epipole of P'",
    printed=0,
    derived=Dot(C_bold * upp, Pp.I * d_bold),
)

# %% [markdown]
# ## 5. Relations with both factors
#
# The equation $\mathbf u'^T \mathbf C \mathbf u'' = 0$ has lost the factors $\mu'$ and $\mu''$.  Can they be kept?
#
# **Definition.**  For the two rays $\mathbf z' = \mathbf d + \mathbf z''$ to one point, $\mathbf D$ takes the base
# away: $\mathbf D \mathbf z' = \mathbf D \mathbf z''$.  This common value is the moment $\mathbf d \times \mathbf
# z'$.  The sides of all equations below are held against it, and against what $\mathbf P'^T$ and $\mathbf P''^T$ make
# of it.

# %%
moment = Cross(d_bold, y - yp0)
hp, hpp = MatrixSymbol("hp", 3, 1), MatrixSymbol("hpp", 3, 1)
base_matrix = Eq(D_bold, Skew(d_bold))
correlated = [base_matrix, Eq(MatrixSymbol("C", 3, 3), C_bold), Eq(hp, C_bold * upp), Eq(hpp, C_bold.T * up)]

section.identity(
    "2.1/intersection",
    "spatial intersection in image coordinates",
    constraints=homologous,
    derived=BlockMatrix([[y - yp0, y - yp0]]),
)
section.identity(
    "2.1.7",
    "symmetric relation between the image coordinates",
    constraints=[base_matrix, *homologous],
    derived=BlockMatrix([[moment, moment]]),
)

# %% [markdown]
# **Print.**  (2.1.7), multiplied from the left by $\mathbf P'^T$, is the first equation (2.1.8).  Its members 1, 3
# and 4 are right.  In the second one $\mathbf P''^T$ is printed.

# %%
section.identity(
    "2.1.8#left",
    "first equation: first, third and fourth member",
    constraints=[*correlated, *homologous],
    derived=BlockMatrix([[Pp.T * moment, Pp.T * moment, Pp.T * moment]]),
)
section.identity(
    "2.1.8#left-second",
    "first equation: second member",
    constraints=[base_matrix, *homologous],
    derived=Pp.T * moment,
    expect="error",
    corrected=mupp * Pp.T * D_bold * Ppp * upp,
    note="The same exchange stands in both equations, in products that exist: the scan alone did not make it.  Ruled "
    "out: an interchange of the images changes all members.",
    follows="The second members are those of the other image. Who used them would get the moment of the wrong bundle; "
    "the first and third members are right.",
)

# %% [markdown]
# The second equation is (2.1.7) multiplied by $\mathbf P''^T$.  The same exchange again.

# %%
section.identity(
    "2.1.8#right",
    "second equation: first, third and fourth member",
    constraints=[*correlated, *homologous],
    derived=BlockMatrix([[Ppp.T * moment, Ppp.T * moment, Ppp.T * moment]]),
)
section.identity(
    "2.1.8#right-second",
    "second equation: second member",
    constraints=[base_matrix, *homologous],
    derived=Ppp.T * moment,
    expect="error",
    corrected=mup * Ppp.T * D_bold * Pp * up,
    note="The first factor must be P''^T, as in the first equation it must be P'^T.",
    same_as="2.1.8#left-second",
)
section.identity(
    "2.1/D-skew", "the matrix of the base is skew-symmetric", constraints=[base_matrix], derived=Skew(d_bold).T
)

# %% [markdown]
# **What do the equations contain?**  All elements of both transformations, says the paper, and they are very
# nonlinear.  There are 21 elements, those of $\mathbf P'$, $\mathbf P''$ and $\mathbf d$.  Each of them occurs: no
# derivative of the equations vanishes.  They are of the third degree: every term has two elements of the matrices and
# one of the base.

# %%
k, n = sympy.symbols("k n")
members = Matrix.vstack(P_left.T * D * P_left * u_left, C * u_right, P_right.T * D * P_right * u_right, C.T * u_left)
mixture = dot(members, vector(*sympy.symbols("w:12")))
elements = (*P_left, *P_right, *d)
section.rank(
    "2.1/all-elements",
    "the equations contain all elements of both transformations",
    printed=21,
    derived=Matrix(21, 21, lambda i, j: diff(mixture, elements[i]) if i == j else sympy.S.Zero),
)
section.identity(
    "2.1/beyond/degree",
    "the equations are of the third degree in these elements",
    printed=k**2 * n * members,
    derived=members.xreplace({element: n * element if element in d else k * element for element in elements}),
)

# %% [markdown]
# ## The matrix K
#
# **Definition.**  The left sides of (2.1.8) contain $\mathbf K = \mathbf P^T \mathbf D \mathbf P$.  It belongs to one
# image, $\mathbf P = \mathbf P'$ or $\mathbf P = \mathbf P''$.  Its elements are the triple products of the base and
# two columns of $\mathbf P$.

# %%
P, P_inverse = P_left, inverse_left
K = Matrix(3, 3, lambda i, j: dot(P.col(i), cross(d, P.col(j))))
kappa = vector(*sympy.symbols("kappa0 kappa1 kappa2"))
kappa_elements = vector(K[2, 1], K[0, 2], K[1, 0])
DET = sympy.Symbol("D")


def skew(a: sympy.Expr, b: sympy.Expr, c: sympy.Expr) -> Matrix:
    """Return the pattern that (2.1.9) prints four times."""
    return Matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]])


section.rank(
    "2.1/rank-K",
    "the rank of the products on the left of (2.1.8)",
    derived=Pp.T * Skew(d_bold) * Pp,
    kernel=[Pp.I * d_bold],
)

# %% [markdown]
# **Print.**  (2.1.9) has $\mathbf K$ in five forms.

# %%
section.identity("2.1.9#product", "K as a product", derived=K)
p0, p1, p2 = (MatrixSymbol(name, 3, 1) for name in ("p0", "p1", "p2"))
P_bold = BlockMatrix([[p0, p1, p2]])
K_product = P_bold.T * Skew(d_bold) * P_bold

section.identity("2.1.9#triple", "K by triple products with the base in the middle", derived=K_product)
section.identity("2.1.9#volume", "K by triple products with the base at the end", derived=K_product)

# %% [markdown]
# For the fourth form the vector products are expressed by the rows $\mathbf p^j$ of $\mathbf P^*$, the reciprocal
# vectors of (1.1.3): $\mathbf p_i \times \mathbf p_j = \det(\mathbf P)\, \mathbf p^k$, for $i, j, k$ cyclic.  The
# factor is $D = \det \mathbf P$.  The print has $1/D$.

# %%
reciprocal_products = [dot(P_inverse.row(j), d) for j in range(3)]
section.identity(
    "2.1.9#reciprocal",
    "K by the rows of the matrix of projection",
    where={DET: determinant(P)} | inverses,
    derived=P.T * D * P,
    expect="error",
    corrected=DET * skew(*reciprocal_products),
    note="1/D is right if D is the determinant of P*, but the text defines D = det(P).  With the adjugate of P for P* "
    "the factor would be 1.  No single sign or letter explains an inverted factor.",
    follows="K differs from its definition by the factor det(P)^2. Epipoles, which are homogeneous, do not notice "
    "it. The relations (2.1.13), which have no free factor, do.",
)

# %% [markdown]
# **Meaning.**  Three numbers remain, $\kappa_0, \kappa_1, \kappa_2$.  They are the projection of the base:
# $\boldsymbol\kappa = \det(\mathbf P)\, \mathbf P^* \mathbf d$.

# %%
section.structure("2.1.9#kappa", "K is skew-symmetric", derived=Pp.T * Skew(d_bold) * Pp)
section.identity(
    "2.1/beyond/kappa",
    "the three elements of K are the projection of the base",
    printed=Determinant(Pp) * Pp.I * d_bold,
    derived=Vee(Pp.T * Skew(d_bold) * Pp),
)

# %% [markdown]
# ## Points, lines and epipoles of one image
#
# With $\mathbf K$ the equations (2.1.8) relate a point to the line of its partner, in one and the same image, with the
# factors $\mu$.

# %%
K_left = K
K_right = P_right.T * D * P_right
lines = [*homologous, Eq(hp, C_bold * upp), Eq(hpp, C_bold.T * up)]
section.identity(
    "2.1.10#left",
    "dual relation in P'",
    constraints=lines,
    nonzero=[mup],
    derived=Pp.T * Skew(d_bold) * Pp * up,
)
section.identity(
    "2.1.10#right",
    "dual relation in P''",
    constraints=lines,
    nonzero=[mupp],
    derived=Ppp.T * Skew(d_bold) * Ppp * upp,
)

# %% [markdown]
# $\mathbf K$ annihilates the epipole, and its elements are the epipole: that of either image, for $\mathbf d$ and
# $-\mathbf d$ have the same quotients.

# %%
section.identity("2.1.11", "K annihilates the epipole", derived=Pp.T * Skew(d_bold) * Pp * Pp.I * d_bold)
projected_base = solve(P, d)
section.identity(
    "2.1.12",
    "epipole from the elements of K",
    where=given(kappa, kappa_elements),
    derived=homogeneous(vector(over(projected_base[1], projected_base[0]), over(projected_base[2], projected_base[0]))),
)

# %% [markdown]
# ## The basic points
#
# What do four known points tell?  For the basic point $G_j$ the equations (2.1.8) hold with $\mathbf u = \mathbf
# e'_j$, and its factor $\mu_j$ is a parameter of orientation.
#
# **Definition.**  As in section 1.2 the rays to $G_0, G_1, G_2$ and $\mu_0, \mu_1, \mu_2$ fix $\mathbf P$: the base
# vectors are $\mathbf b_j = (\mathbf e_j - \mathbf y_0) / \mu_j$.  Then $\mathbf P^*$ fixes $\mu_3$ and $\mathbf u_3$.

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


at_left = given(P_left, reconstruction_of_basic_points(center_left, parameters_left))
at_right = given(P_right, reconstruction_of_basic_points(center_right, parameters_right))
at_basic_points = at_left | at_right | at_centers
fourth_points = fourth_point(center_left, parameters_left, fourth_left) | fourth_point(
    center_right, parameters_right, fourth_right
)
images_left = weighted_images(parameters_left, fourth_left)
images_right = weighted_images(parameters_right, fourth_right)
moments = columns(*(cross(center_right - center_left, unit - center_left) for unit in object_units))

# %% [markdown]
# **Print.**  The columns are the left sides for $j = 0, 1, 2, 3$, and then the right sides.

# %%
section.identity(
    "2.1.13#left",
    "first relation for the four basic points",
    printed=columns(*(K_left * image for image in images_left), *(C * image for image in images_right)),
    where=at_basic_points | fourth_points,
    derived=columns((P_left.T).xreplace(at_left) * moments, (P_left.T).xreplace(at_left) * moments),
)
section.identity(
    "2.1.13#right",
    "second relation for the four basic points",
    printed=columns(*(K_right * image for image in images_right), *(-C.T * image for image in images_left)),
    where=at_basic_points | fourth_points,
    derived=columns((P_right.T).xreplace(at_right) * moments, (P_right.T).xreplace(at_right) * moments),
)
