# %% [markdown]
# # 2.3 Critical situations of projective image correlation
#
# Section 2.2 solves eight equations for eight unknowns.  When do they fail?  Five points beside the basic points decide
# about that, through a determinant of quadratic forms.  As a function of one of the points it is a quadric.  Which
# quadrics are dangerous?  The paper's answer is judged here; s2_3_factorisation gives the whole answer.

# %%
import sympy

from algebroproj_derivations.figures import QuadricDrawing
from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import (
    M_star,
    homogeneous_center,
    mu_of_y0,
    u_of_y,
)
from algebroproj_derivations.fundamentals1996.s2_2_correlation import (
    Z,
    basic_rows,
    design,
    differences,
    polynomials,
    primed,
    reduced,
    remaining,
    up1,
    up2,
    upp1,
    upp2,
)
from algebroproj_sym import Section
from algebroproj_sym.expressions import (
    Matrix,
    columns,
    determinant,
    diff,
    divided,
    dot,
    homogeneous,
    linear_system,
    over,
    solve,
    vector,
)

section = Section("fundamentals1996", "2.3", "Critical situations of projective image correlation")

# %% [markdown]
# ## The images of a point are quotients of planes
#
# **Definition.**  The rows of $\mathbf M^*$ are $\mathbf m_0^T, \mathbf m_1^T, \mathbf m_2^T$; applied to $(1,
# \mathbf y)$ they are the denominator $d$ and the numerators $n_1, n_2$ of the image coordinates.  Each of the three
# is the equation of a plane through the center.

# %%
M = M_star[:3, :]
point = homogeneous(vector(y1, y2, y3))
d, n1, n2, yj = sympy.symbols("d n1 n2 yj")
image = u_of_y.subs(mu0, 1)
denominator = 1 + (mu1 - 1) * y1 + (mu2 - 1) * y2 + (mu3 - 1) * y3

# %% [markdown]
# **Print.**  In the numerator $y$ has the index $j$ of the sum.  There is a sum in the denominator alone.

# %%
section.identity(
    "2.3.1",
    "image coordinates",
    printed=vector((yj * mu1 + y3 * u31 * mu3) / denominator, (yj * mu2 + y3 * u32 * mu3) / denominator),
    derived=image,
    expect="misprint",
    corrected=vector((y1 * mu1 + y3 * u31 * mu3) / denominator, (y2 * mu2 + y3 * u32 * mu3) / denominator),
    note=(
        "(1.3.1), to which the text refers, has y_i.  The second index of the coordinates of the sum is left out."
        "  The scan alone cannot tell a slip of the scan from one of the print."
    ),
)

# %% [markdown]
# As quotients of the three forms they are right.

# %%
section.identity(
    "2.3.1#forms",
    "image coordinates as quotients of linear forms",
    where={d: dot(M.row(0).T, point), n1: dot(M.row(1).T, point), n2: dot(M.row(2).T, point)},
    derived=image,
)
section.identity("2.3/d", "the denominator", derived=(M * point)[0])

# %% [markdown]
# Of the separate numerators the print drops the image coordinate of $G_3$, which (2.3.1) has.

# %%
section.identity(
    "2.3/n",
    "the numerators",
    derived=(M * point)[1:, :],
    expect="misprint",
    corrected=vector(y1 * mu1 + y3 * u31 * mu3, y2 * mu2 + y3 * u32 * mu3),
)

# %% [markdown]
# ## The determinant of the eight equations
#
# **Definition.**  In the equations of 2.2 the image coordinates are replaced by these quotients.  A point enters by its
# forms $(d', n'_1, n'_2)$ and $(d'', n''_1, n''_2)$.

# %%
dp, n1p, n2p, dpp, n1pp, n2pp = sympy.symbols("dp n1p n2p dpp n1pp n2pp")
left, right = vector(dp, n1p, n2p), vector(dpp, n1pp, n2pp)
quotients = {up1: over(n1p, dp), up2: over(n2p, dp), upp1: over(n1pp, dpp), upp2: over(n2pp, dpp)}
M_left, M_right = primed(M, "p"), primed(M, "pp")


def homologous(y: Matrix) -> dict[sympy.Symbol, sympy.Expr]:
    return dict(zip((*left, *right), (*(M_left * y), *(M_right * y)), strict=True))


d1p, d2p, d1pp, d2pp = sympy.symbols("d1p d2p d1pp d2pp")

# %% [markdown]
# **Print.**  The rows of the three basic points are numbers; one row stands for the points 3 to 7.  The print gives
# $d$ two indices, for two coordinates that have one denominator.

# %%
section.identity(
    "2.3.2",
    "the matrix of the eight equations in object coordinates",
    printed=Matrix(
        [
            [1, 0, 0, 0, 0, 0, 0, 0],
            [1, 1, 0, 1, 0, 0, 0, 0],
            [1, 0, 1, 0, 0, 1, 0, 1],
            [
                1,
                n1pp / d1pp,
                n2pp / d2pp,
                n1p * n1pp / (d1p * d1pp),
                n1p * n2pp / (d1p * d2pp),
                n2p / d2p,
                n2p * n1pp / (d2p * d1pp),
                n2p * n2pp / (d2p * d2pp),
            ],
        ]
    ),
    where={denominators: homologous(point)[dp] for denominators in (d1p, d2p)}
    | {denominators: homologous(point)[dpp] for denominators in (d1pp, d2pp)}
    | homologous(point),
    derived=basic_rows.col_join(design.xreplace(quotients).xreplace(homologous(point)))[:, :8],
)

# %% [markdown]
# The first row is a unit vector: row and column leave the determinant.  $u'_{ik}$ and $u''_{ik}$ stand for the
# quotients.


# %%
def at(row: Matrix, index: int) -> Matrix:
    """Return a row, or an entry, for the image points with an index."""
    symbols = sympy.symbols(f"up{index}1 up{index}2 upp{index}1 upp{index}2")
    return row.xreplace(dict(zip((up1, up2, upp1, upp2), symbols, strict=True)))


GENERAL = range(3, 8)
A8 = basic_rows.col_join(Matrix.vstack(*(at(design, index) for index in GENERAL)))[:, :8]
A7 = A8[1:, 1:]
section.identity("2.3/A7", "the determinants of A8 and A7", printed=determinant(A7), derived=determinant(A8))

# %% [markdown]
# ## Six determinants of five points
#
# $\mathbf A_7$ has two ones in its first row and three in its second row.  The paper expands by both: two times three
# determinants of five points remain.


# %%
def expanded(row: int, kept: tuple[int, ...]) -> list[tuple[int, tuple[int, ...]]]:
    """Return signs and columns of the minors that the ones of a row of A7 leave of some columns."""
    ones = [place for place, column in enumerate(kept) if A7[row, column] == 1]
    return [((-1) ** place, kept[:place] + kept[place + 1 :]) for place in ones]


minors = [(sign * second, five) for sign, six in expanded(0, tuple(range(7))) for second, five in expanded(1, six)]
section.identity(
    "2.3/A7#six",
    "two expansions leave six determinants of five points",
    printed=vector(2, 6),
    derived=vector(sum(A7.row(0)), len(minors)),
)
subdeterminants = vector(*(sign * determinant(A7[2:, list(five)]) for sign, five in minors))

# %% [markdown]
# **Print.**  Each subdeterminant has five of seven columns, which the image products below name.  In the third and in
# the sixth one a column is wrong.

# %%
entry = {
    "1": upp1,
    "2": upp2,
    "11": up1 * upp1,
    "12": up1 * upp2,
    "20": up2,
    "21": up2 * upp1,
    "22": up2 * upp2,
}


def partial(sign: int, *names: str) -> sympy.Expr:
    """Return a subdeterminant whose columns are printed as products of image coordinates."""
    return sign * determinant(Matrix.vstack(*(at(Matrix([[entry[name] for name in names]]), k) for k in GENERAL)))


printed_terms = [
    partial(1, "11", "12", "20", "21", "22"),
    partial(-1, "2", "11", "12", "21", "22"),
    partial(-1, "2", "11", "12", "20", "22"),
    partial(-1, "1", "12", "20", "21", "22"),
    partial(-1, "1", "2", "12", "21", "22"),
    partial(-1, "1", "20", "12", "20", "21"),
]
SLIPS = {
    2: (
        partial(-1, "2", "11", "12", "20", "21"),
        "The last numerator must be n'2 n''1 over d'2 d''1.  The sentence on complete coplanarity needs the columns 12 "
        "and 21 together in every determinant.",
    ),
    5: (
        partial(-1, "1", "2", "12", "20", "21"),
        "The second column must be n''2 over d''2.  With the fourth column repeated the determinant is zero.",
    ),
}
UNSURE = "  The scan alone cannot tell a slip of the scan from one of the print."
for place, printed_term in enumerate(printed_terms):
    slip = SLIPS.get(place)
    section.identity(
        f"2.3/A7#{place + 1}",
        f"subdeterminant {place + 1} of the expansion",
        printed=printed_term,
        derived=subdeterminants[place],
        **({"expect": "misprint", "corrected": slip[0], "note": slip[1] + UNSURE} if slip else {}),
    )

# %% [markdown]
# With the two columns corrected the sum is the determinant.  All six signs are right.

# %%
section.identity(
    "2.3/A7#sum",
    "the determinant of A7 as a sum of six determinants",
    printed=sympy.Add(*printed_terms),
    derived=determinant(A7),
    expect="misprint",
    corrected=sympy.Add(*(SLIPS[place][0] if place in SLIPS else term for place, term in enumerate(printed_terms))),
    same_as="2.3/A7#3",
)

# %% [markdown]
# ## May the points lie in one plane?
#
# In the plane of $G_0, G_1, G_2$, where $y_3 = 0$, the columns 12 and 21 are proportional.

# %%
in_plane = {y3: sympy.Integer(0)}
mup1, mup2, mup3 = primed(mu, "p")
mupp1, mupp2, mupp3 = primed(mu, "pp")
flat_left, flat_right = M_left[:, :3], M_right[:, :3]

section.identity(
    "2.3/coplanar#columns",
    "proportional columns",
    printed=vector(mup1 * mupp2 * y1 * y2 / (dp * dpp), mup2 * mupp1 * y1 * y2 / (dp * dpp)),
    where={symbol: homologous(point.xreplace(in_plane))[symbol] for symbol in (dp, dpp)},
    derived=vector(entry["12"], entry["21"]).xreplace(quotients).xreplace(homologous(point.xreplace(in_plane))),
)

# %% [markdown]
# So all six determinants vanish, if the five points lie in this plane.  From here on the row of a point is multiplied
# by its $d' d''$, which changes no zero.


# %%
def on_plane(k: int) -> Matrix:
    return vector(1, *sympy.symbols(f"y{k}1 y{k}2"), 0)


def in_space(k: int) -> Matrix:
    return vector(1, *sympy.symbols(f"y{k}(1:4)"))


def as_forms(row: Matrix) -> Matrix:
    """Return a row of products of image coordinates, multiplied by d' d''."""
    return (dp * dpp * row.xreplace({symbol: quotient.doit() for symbol, quotient in quotients.items()})).expand()


A7_forms = as_forms(design[:, 1:8])
rows_on_plane = Matrix.vstack(*(A7_forms.xreplace(homologous(on_plane(k))) for k in GENERAL))
section.identity(
    "2.3/coplanar",
    "all six determinants vanish for coplanar points",
    printed=Matrix.zeros(6, 1),
    derived=vector(*(determinant(rows_on_plane[:, list(five)]) for _, five in minors)),
    note=("The determinants as derived.  The third one as printed vanishes as well, but not for proportional columns."),
)

# %% [markdown]
# **Meaning.**  How many may lie there?  The plane holds three independent conics through the basic points.  So five
# columns have rank 3 there: three of the five points may lie in the plane of the basic points, four are too many.

# %%
five_forms = divided(linear_system([dot(left, Z * right)], remaining)[0])


def forms_at(y: Matrix) -> Matrix:
    return five_forms.xreplace(homologous(y))


section.rank(
    "2.3/beyond/coplanar-rank",
    "rank of the equations of coplanar points",
    printed=3,
    derived=Matrix.vstack(*(forms_at(on_plane(k)) for k in GENERAL)),
    kernel=[
        vector(0, mup2 * mupp1, 0, -mup1 * mupp2, 0),
        vector(0, over(mup2 * (mup1 - mupp1), mup1), mupp2, 0, mup2 - mupp2),
    ],
)

# %% [markdown]
# The paper's two sentences agree.  Two of the points 3 to 7 have to be outside; nothing is special about $G_3$.  With
# two outside, six coplanar points do no harm.

# %%
section.identity(
    "2.3/two-points",
    "the determinant vanishes if only one point is outside the plane",
    printed=0,
    derived=determinant(Matrix.vstack(*(forms_at(on_plane(k)) for k in range(4, 8)), forms_at(in_space(3)))),
)
section.rank(
    "2.3/six-coplanar",
    "six points may be coplanar",
    printed=5,
    derived=Matrix.vstack(*(forms_at(on_plane(k)) for k in range(3, 6)), *(forms_at(in_space(k)) for k in (6, 7))),
)

# %% [markdown]
# Why does a plane say so little?  Two images of it are related by a projectivity, as in a rectification.  It predicts
# one image from the other, and leaves the cameras open.

# %%
section.up_to_scale(
    "2.3/projectivity",
    "images of a plane are related by a projectivity",
    printed=flat_right * flat_left.adjugate() * M_left * on_plane(3),
    derived=M_right * on_plane(3),
)
section.vanishing(
    "2.3/projectivity#regular",
    "where the projectivity is regular",
    printed=(mup1, mup2, mupp1, mupp2),
    derived=determinant(flat_right * flat_left),
)

# %% [markdown]
# ## The determinant of five equations
#
# The same number has a shorter form.  Column operations leave one 1 in each of the first two rows of $\mathbf A_7$:
# column 01 is subtracted from column 11, and column 02 from the columns 20 and 22.

# %%
operations = Matrix(7, 7, lambda i, j: int(i == j) - int((i, j) in ((0, 2), (1, 4), (1, 6))))
A7_reduced = A7 * operations
A5 = Matrix.vstack(*(at(reduced[:, :5], index) for index in GENERAL))
section.identity(
    "2.3/A5#rows",
    "A7 after the column operations",
    printed=Matrix.eye(7)[:2, :],
    derived=A7_reduced[:2, :],
)

# %% [markdown]
# The paper then expands "with respect to the first columns".  It must be the rows: the first row has a single
# element, the first column has the coordinate $u''_1$ of every point.

# %%
section.identity(
    "2.3/A5#expansion",
    "the line along which the determinant is expanded has one element",
    printed=A7_reduced[:, 0],
    derived=A7_reduced[0, :].T,
    expect="misprint",
    corrected=vector(1, *[0] * 6),
    note="Printed: expanding two times with respect to the first columns.",
)

# %% [markdown]
# What remains is the determinant of the five equations (2.2.4).

# %%
section.identity(
    "2.3/A5",
    "the determinant is that of the five equations (2.2.4)",
    printed=determinant(A5),
    derived=determinant(A7),
)

# %% [markdown]
# **Print.**  Each entry is a product of two planes, one of each image; the third entry is a difference of two
# products.  Which row belongs to which image cannot be read: the scan lost a prime here and doubled a T there.

# %%
m0_left, m1_left, m2_left = (M_left.row(i).T for i in range(3))
m0_right, m1_right, m2_right = (M_right.row(i).T for i in range(3))
planes = {
    "11": (m1_right, m1_left - m0_left),
    "12": (m1_left, m2_right),
    "21": (m2_left, m1_right),
    "22": (m2_right, m2_left - m0_left),
}
outer = {name: dot(point, first) * dot(second, point) for name, (first, second) in planes.items()}
outer["20"] = dot(point, (m2_left * m0_right.T - m2_right * m0_left.T) * point)
both_denominators = dot(m0_left, point) * dot(m0_right, point)
COLUMNS = ("11", "12", "20", "21", "22")
PRIMES = (
    "With single primes only, as scanned, no row of the second image would be left.  (2.2.4), to which the text "
    "refers, decides which rows belong to which image; where the scan shows TT it agrees."
)
for place, name in enumerate(COLUMNS):
    section.identity(
        f"2.3/A5#{place + 1}",
        f"entry {place + 1} of a row of A5",
        printed=None,
        derived=reduced[0, place].xreplace(quotients).xreplace(homologous(point)),
        expect="illegible",
        corrected=outer[name] / both_denominators,
        note=f"The column of z{name}.  {PRIMES}",
        same_as="2.3/A5#1" if place else "",
    )

# %% [markdown]
# **Meaning.**  The denominators are common to a row and cancel.  Only the numerators decide, quadratic forms of
# $(1, \mathbf y)$.


# %%
def numbered(row: Matrix, k: int) -> Matrix:
    return row.xreplace({symbol: sympy.Symbol(f"{symbol.name}_{k}") for symbol in (*left, *right)})


section.identity(
    "2.3/denominators",
    "the denominators cancel out",
    printed=determinant(Matrix.vstack(*(numbered(five_forms, k) for k in GENERAL))),
    derived=determinant(Matrix.vstack(*(numbered(reduced[:, :5].xreplace(quotients), k) for k in GENERAL)))
    * sympy.Mul(*(numbered(Matrix([[dp * dpp]]), k)[0] for k in GENERAL)),
)

# %% [markdown]
# ## Where may the last point not lie?
#
# **Definition.**  Four points are fixed, the last one moves.  The determinant is expanded with respect to the last row;
# $D_l$ is the minor of the fixed rows without column $l$.

# %%
fixed_rows = Matrix(4, 5, sympy.symbols("f(3:7)(1:6)"))
last_row = sympy.symbols("f7(1:6)")
D1, D2, D3, D4, D5 = D = sympy.symbols("D1:6")


def minors_of(matrix: Matrix) -> list[sympy.Expr]:
    """Return the minors of a matrix of four rows and five columns, each without one column."""
    return [determinant(columns(*(matrix.col(j) for j in range(5) if j != skipped))) for skipped in range(5)]


section.identity(
    "2.3.3#signs",
    "the signs of the expansion with respect to the last row",
    printed=vector(1, -1, 1, -1, 1),
    derived=vector(
        *(
            over(
                diff(determinant(fixed_rows.col_join(Matrix([last_row]))), element),
                minors_of(fixed_rows)[place],
            )
            for place, element in enumerate(last_row)
        )
    ),
)

# %% [markdown]
# **Print.**  The signs of (2.3.3) are legible, the primes are not.

# %%
section.identity(
    "2.3.3",
    "the determinant as a function of the last point",
    printed=None,
    where=dict(zip(D, minors_of(fixed_rows), strict=True)),
    derived=determinant(fixed_rows.col_join(forms_at(point))),
    expect="illegible",
    corrected=outer["11"] * D1 - outer["12"] * D2 + outer["20"] * D3 - outer["21"] * D4 + outer["22"] * D5,
    note=PRIMES,
)

# %% [markdown]
# **Meaning.**  The signed minors are the elements of a matrix $\mathbf X$ that looks like $\mathbf Z$, with a zero in
# the place of the 1.  The determinant is the quadratic form $(\mathbf M' \mathbf y)^T \mathbf X (\mathbf M'' \mathbf
# y)$, and where it vanishes is a quadric.

# %%
signed = dict(zip(remaining, (D1, -D2, D3, -D4, D5), strict=True))
X = divided(Z - Z.xreplace(dict.fromkeys(remaining, sympy.Integer(0)))).xreplace(signed)
X

# %%
bilinear = M_left.T * X * M_right


def quadric(camera_left: Matrix, camera_right: Matrix) -> Matrix:
    """Return the symmetric matrix of the quadric, as a function of the minors."""
    product = camera_left.T * X * camera_right
    return (product + product.T).applyfunc(lambda entry: over(entry, 2) if entry != 0 else entry)


Q_of_minors = quadric(M_left, M_right)
surface = dot(point, bilinear * point)

section.identity(
    "2.3/X",
    "the equation of the quadric is bilinear in the images",
    printed=outer["11"] * D1 - outer["12"] * D2 + outer["20"] * D3 - outer["21"] * D4 + outer["22"] * D5,
    derived=surface,
)

# %% [markdown]
# As a symmetric matrix it is the sum of both orders.

# %%
section.identity(
    "2.3/Q",
    "the quadric as a symmetric matrix",
    printed=dot(point, Q_of_minors * point),
    derived=dot(forms_at(point), vector(D1, -D2, D3, -D4, D5)),
)

# %% [markdown]
# This is no statement about any four rows alone.  With two cameras and five points put in, both sides agree as
# polynomials in all 25 variables.

# %%
four_points = [in_space(k) for k in range(3, 7)]
minors_of_points = dict(zip(D, minors_of(Matrix.vstack(*map(forms_at, four_points))), strict=True))
section.identity(
    "2.3/beyond/expanded",
    "the determinant of two cameras and five points as a function of the last point",
    printed=dot(M_left * point, X * (M_right * point)),
    where=minors_of_points,
    derived=determinant(Matrix.vstack(*map(forms_at, (*four_points, point)))),
)

# %% [markdown]
# ## Which points lie on the quadric?
#
# Both centers do: a center is taken to zero by the matrix of its image, (1.1.7), whatever the minors are.

# %%
center_left, center_right = primed(homogeneous_center, "p"), primed(homogeneous_center, "pp")
section.identity(
    "2.3/centers#rows",
    "the rows of each matrix, at the center of its image",
    printed=Matrix.zeros(3, 2),
    derived=columns(M_left * center_left, M_right * center_right),
)


def surface_at(y: Matrix) -> sympy.Expr:
    return dot(y, Q_of_minors * y)


section.identity(
    "2.3/centers",
    "both centers are points of the quadric",
    printed=vector(0, 0),
    derived=vector(surface_at(center_left), surface_at(center_right)),
)

# %% [markdown]
# So do the four fixed points, as a determinant with two equal rows is zero.  And so do $G_0, G_1, G_2$, where each of
# the five forms vanishes.  The paper does not say this.  Where the determinant vanishes there are *ten* points on the
# quadric, not seven.

# %%
section.identity(
    "2.3/beyond/fixed-points",
    "the four fixed points are points of the quadric",
    printed=Matrix.zeros(4, 1),
    derived=vector(*(determinant(fixed_rows.col_join(fixed_rows[k, :])) for k in range(4))),
)
basic_points = [homogeneous(e) for e in (e0, e1, e2)]
section.identity(
    "2.3/beyond/basic-points",
    "the basic points of the images are points of the quadric",
    printed=Matrix.zeros(3, 5),
    derived=Matrix.vstack(*map(forms_at, basic_points)),
)

# %% [markdown]
# $G_3$ is a point like any other.  It lies on the quadric exactly if its images satisfy the bilinear equation.

# %%
up31, up32, upp31, upp32 = (*primed(fourth_image, "p"), *primed(fourth_image, "pp"))
section.vanishing(
    "2.3/beyond/G3",
    "the fourth basic point is not a point of the quadric in general",
    printed=(mup3, mupp3, dot(vector(1, up31, up32), X * vector(1, upp31, upp32))),
    derived=surface_at(homogeneous(e3)),
)

# %% [markdown]
# ## Is it the ruled quadrics that are critical?
#
# **The paper's answer.**  $\mathbf A_5$ becomes singular if the points 3 to 7 and both centers lie on a ruled quadric.
#
# **A counterexample.**  Take them on the hyperbolic paraboloid $y_3 = y_1 y_2 + 1$, on which the basic points do not
# lie.  The five equations stay independent.


# %%
def monomials(y: Matrix) -> Matrix:
    """Return the ten products of homogeneous coordinates, in a row."""
    return Matrix([[y[i] * y[j] for i in range(4) for j in range(i, 4)]])


def camera(position: Matrix, fourth: Matrix) -> Matrix:
    """Return the matrix of projection of a camera from its center and the image of G3."""
    values = {**dict(zip(center, position, strict=True)), **dict(zip(fourth_image, fourth, strict=True))}
    return M.xreplace(values | dict(zip(mu, divided(mu_of_y0).xreplace(values), strict=True)))


FOURTH_LEFT, FOURTH_RIGHT = vector(2, 1), vector(3, 1)


def equations(camera_left: Matrix, camera_right: Matrix, points: list[Matrix]) -> Matrix:
    """Return the numerators of A5 for two cameras and homogeneous points."""
    images = [dict(zip((*left, *right), (*(camera_left * y), *(camera_right * y)), strict=True)) for y in points]
    return Matrix.vstack(*(five_forms.xreplace(each) for each in images))


saddle = [vector(a, b, a * b + 1) for a, b in ((2, 1), (-1, 2), (3, 2), (1, 3), (-2, -1), (1, -2), (4, -1))]
saddle_cameras = camera(saddle[0], FOURTH_LEFT), camera(saddle[1], FOURTH_RIGHT)
section.rank(
    "2.3/singular-if",
    "A5 is singular if five points and the centers lie on a ruled quadric",
    printed=4,
    derived=equations(*saddle_cameras, [homogeneous(y) for y in saddle[2:]]),
    expect="false",
    instead="2.3/beyond/theorem",
    note=(
        "The sentence is right if its quadric is the one of (2.3.3), on which the basic points lie.  Nor is a "
        "quadric necessary: 2.3/beyond/normalisation#A5."
    ),
    grade="results",
    follows="A test of these seven points for a ruled quadric rejects good configurations: in the example they lie "
    "on one, and the five equations are independent. The quadric has to contain the three basic points as "
    "well, and it may be any quadric. See docs/findings/determinant-of-a5.md.",
)


def named(positions: list[Matrix]) -> dict[str, Matrix]:
    """Return both centers, the points 3 to 7 and the three basic points of the images by their names."""
    names = ("C'", "C''", *(f"P{k}" for k in GENERAL))
    return dict(zip(names, positions, strict=True)) | {"G0": e0, "G1": e1, "G2": e2}


QuadricDrawing(
    "Both centers C', C'' and the points P3 to P7 lie on the hyperbolic paraboloid y3 = y1 y2 + 1, a ruled quadric.  "
    "The basic points G0, G1 and G2 lie below it, and the five equations are independent.",
    Matrix([[2, 0, 0, -1], [0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0]]),
    named(saddle),
)

# %% [markdown]
# **Meaning.**  A quadric through seven points says nothing.  It has ten coefficients, and seven points impose seven
# conditions: there is always one, and in general there are many.

# %%
section.rank(
    "2.3/beyond/seven-points",
    "conditions that seven points impose on a quadric",
    printed=7,
    derived=Matrix.vstack(*(monomials(in_space(k)) for k in range(1, 8))),
)

# %% [markdown]
# **And need it be ruled?**  No straight line lies on a sphere.  Take the one with the diameter from $G_0$ to $(1, 1,
# 1)$, which goes through the basic points.  Lines through $G_0$ meet it again in points with rational coordinates:
# two of them become centers, five become points, $G_3$ first.


# %%
def second_intersection(quadric: Matrix, direction: Matrix) -> Matrix:
    """Return where a line from G0, a point of the quadric, meets it again."""
    towards = vector(0, *direction)
    factor = -2 * dot(quadric.row(0).T, towards) / dot(towards, quadric * towards)
    return vector(1, *(factor * direction))


DIRECTIONS = [
    vector(*each) for each in ((3, 1, 1), (1, -3, 4), (0, 0, 1), (2, 3, -1), (1, 4, 2), (-1, 2, 6), (5, 2, 2))
]


def points_on(quadric: Matrix) -> list[Matrix]:
    """Return two centers and five points, homogeneous, on a quadric through G0."""
    return [second_intersection(quadric, direction) for direction in DIRECTIONS]


def on_quadric(quadric: Matrix) -> tuple[Matrix, Matrix, list[Matrix]]:
    """Return two cameras and five points with all centers and points on a quadric."""
    first, second, *points = points_on(quadric)
    return camera(first[1:, :], FOURTH_LEFT), camera(second[1:, :], FOURTH_RIGHT), points


def diagonal(a: int, b: int, c: int) -> Matrix:
    """Return the matrix of 2a (y1^2 - y1) + 2b (y2^2 - y2) + 2c (y3^2 - y3)."""
    return Matrix([[0, -a, -b, -c], [-a, 2 * a, 0, 0], [-b, 0, 2 * b, 0], [-c, 0, 0, 2 * c]])


def dependence(matrix: Matrix) -> Matrix:
    """Return what a singular matrix of five rows takes to zero."""
    m1, m2, m3, m4, m5 = minors_of(matrix[:4, :])
    return vector(m1, -m2, m3, -m4, m5)


# %% [markdown]
# With ten points on the sphere the five equations are dependent, although both cameras are regular.  The relative
# orientation itself fails on ruled quadrics alone.  But the linear equations fail on every quadric.

# %%
sphere = equations(*on_quadric(diagonal(1, 1, 1)))
section.rank(
    "2.3/beyond/sphere",
    "A5 is singular on a quadric that is not ruled, too",
    printed=4,
    derived=sphere,
    kernel=[dependence(sphere)],
)
QuadricDrawing(
    "Both centers, the basic points and the points P3 to P7 lie on a sphere, which is not ruled, and yet the five "
    "equations are dependent.  P3 is G3.",
    diagonal(1, 1, 1),
    named([y[1:, :] for y in points_on(diagonal(1, 1, 1))]),
)

# %% [markdown]
# ## Vanishing columns
#
# The paper adds three cases.  A column that is zero at all five points makes the determinant zero: in the plane
# $n''_1 = 0$ or $n''_2 = 0$ through the right center, and so for the left image, and on a certain quadric.

# %%


def on_form(form: sympy.Expr, solved: int, k: int) -> Matrix:
    """Return a point where a form, linear in a coordinate, is zero."""
    y = in_space(k)
    at_point = form.xreplace(homologous(y))
    return y.xreplace({y[solved]: solve(*linear_system([at_point], [y[solved]]))[0]})


for number, title, form, solved, zero_columns in (
    ("1", "the five points lie in the plane n''1 = 0, where the columns 1 and 4 vanish", n1pp, 1, (0, 3)),
    ("2", "the five points lie in the plane n''2 = 0, where the columns 2 and 5 vanish", n2pp, 2, (1, 4)),
    (
        "3",
        "the five points lie on the quadric n'2 d'' = n''2 d', where column 3 vanishes",
        n2p * dpp - n2pp * dp,
        1,
        (2,),
    ),
):
    section.rank(
        f"2.3/columns#{number}",
        f"the system is singular: {title}",
        printed=5 - len(zero_columns),
        derived=Matrix.vstack(*(forms_at(on_form(form, solved, k)) for k in GENERAL)),
        kernel=[vector(*(int(j == place) for j in range(5))) for place in zero_columns],
    )

# %% [markdown]
# They are right, but no cases of their own.  The surface of a column is the quadric $\mathbf Q$ with one minor alone:
# it contains both centers as all of them do.  Four are pairs of planes, one through each center; the third carries
# lines, as its determinant is a square.

# %%
section.identity(
    "2.3/columns#centers",
    "the surface of every column contains both centers",
    printed=Matrix.zeros(2, 5),
    derived=Matrix.vstack(forms_at(center_left), forms_at(center_right)),
)
for place, (name, minor) in enumerate(zip(COLUMNS, D, strict=True)):
    column_quadric = Q_of_minors.xreplace({symbol: sympy.Integer(int(symbol == minor)) for symbol in D})
    if name in planes:
        first, second = planes[name]
        section.up_to_scale(
            f"2.3/beyond/column#{place + 1}",
            f"the surface of column {place + 1} is a pair of planes",
            printed=first * second.T + second * first.T,
            derived=column_quadric,
        )
    else:
        section.identity(
            f"2.3/beyond/column#{place + 1}",
            f"the surface of column {place + 1} is a ruled quadric",
            printed=over(determinant(columns(m2_left, m0_right, m2_right, m0_left)) ** 2, 16),
            derived=determinant(column_quadric),
        )

# %% [markdown]
# ## Are rasters of points dangerous?
#
# Let the third axis be vertical.  In Gruber's arrangement two columns of points go through the two nadir points.
# Then all points lie in two vertical planes, whatever the heights, and the centers above the nadir points do as well.
# Two planes are a quadric.  The left center is in the plane $y_1 = 0$ if $u'_{31} = 0$; for the right one in $y_1 =
# 1$ there is a condition for $u''_{31}$.

# %%
six_forms = five_forms.row_join(Matrix([[n1p * dpp - dp * n1pp]]))
C0 = polynomials.xreplace(differences)
in_columns = {
    up31: sympy.Integer(0),
    upp31: over(mupp2 * (mupp3 - 1) - upp32 * (mupp2 - 1) * mupp3, mupp2 * mupp3),
}
section.identity(
    "2.3/gruber#centers",
    "the centers are in the planes of the columns",
    printed=vector(0, 0),
    derived=vector(center_left[1], center_right[1] - center_right[0]).xreplace(in_columns),
)

# %% [markdown]
# $G_0$, $G_2$ and two points lie in one column, $G_1$ and three points in the other.  The equations here are those
# for all six elements, $c_{10}$ the last one: it is not the division that fails.  They have two solutions.  One is
# the pair of planes, the other the true matrix of correlation.


# %%
def on_column(k: int, column: int) -> Matrix:
    return vector(1, column, *sympy.symbols(f"y{k}2 y{k}3"))


two_columns = [on_column(k, int(k > 4)) for k in GENERAL]
section.rank(
    "2.3/gruber",
    "two columns of points through the nadir points",
    printed=4,
    derived=Matrix.vstack(*(six_forms.xreplace(homologous(y)) for y in two_columns)).xreplace(in_columns),
    kernel=[
        vector(1, (mupp2 - 1) / mupp2, 0, 0, 0, -1),
        vector(*(C0[i, j] for i, j in ((1, 1), (1, 2), (2, 0), (2, 1), (2, 2), (1, 0)))).xreplace(in_columns),
    ],
)

# %% [markdown]
# A regular raster as such is not critical.  Eight nodes of a square raster of nine, with general heights, give five
# independent equations.

# %%
raster = [(1, 1), (-1, 0), (-1, 1), (-1, -1), (1, -1)]
section.rank(
    "2.3/beyond/raster",
    "a regular raster of points with irregular heights leaves the equations regular",
    printed=5,
    derived=Matrix.vstack(
        *(forms_at(vector(1, *node, sympy.Symbol(f"y{k}3"))) for k, node in zip(GENERAL, raster, strict=True))
    ),
)
