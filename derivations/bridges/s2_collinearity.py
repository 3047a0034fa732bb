# %% [markdown]
# # 2 Collinearity
#
# Okamoto's general collinearity equations have eleven coefficients $A_1, \dots, A_{11}$; the matrix of projection of
# 1996 has five parameters, referred to the basic points.  Where are the other six?  In the affine frames of image and
# object.

# %%
import sympy

from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.fundamentals1996.notation import mu0, mu1, mu2, mu3, u31, u32
from algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection import M_star
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import y0_of_mu
from algebroproj_derivations.fundamentals1996.s1_4_orthonormalized_systems import coordinates, frame
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, columns, homogeneous, inverse, over, rows, vector

section = Section("bridges", "2", "Collinearity")

core = M_star[:3, :]
core_parameters = (mu1, mu2, mu3, u31, u32)

# %% [markdown]
# ## Which matrix is it?
#
# **Definition.**  With homogeneous vectors $(1, X, Y, Z)$ and $(1, x, y)$ the common denominator is the first row.


# %%
def okamoto(a: tuple[sympy.Symbol, ...]) -> Matrix:
    """Return the matrix (3 by 4) of the collinearity equations with the coefficients A1 to A11."""
    return Matrix([[1, *a[8:]], [a[3], *a[:3]], [a[7], *a[4:7]]])


def inhomogeneous(image: Matrix) -> Matrix:
    return vector(over(image[1], image[0]), over(image[2], image[0]))


coefficients = sympy.symbols("A1:12")
A1, A2, A3, A4, A5, A6, A7, A8, A9, A10, A11 = coefficients
X, Y, Z = point = vector(*sympy.symbols("X Y Z"))
camera = okamoto(coefficients)
denominator = A9 * X + A10 * Y + A11 * Z + 1

section.identity(
    "2/collinearity",
    "collinearity equations",
    printed=vector((A1 * X + A2 * Y + A3 * Z + A4) / denominator, (A5 * X + A6 * Y + A7 * Z + A8) / denominator),
    derived=inhomogeneous(camera * homogeneous(point)),
)

# %% [markdown]
# ## What is left when frames are taken away?
#
# **Definition.**  Rows of $G$ are four basic points.  In their affine system the camera is $\mathbf A \mathbf A_X$,
# whose columns give the images of the basic points.

# %%
G = Matrix(4, 3, sympy.symbols("G:4:3"))


def images_of_basic_points(affine_camera: Matrix) -> list[Matrix]:
    first = affine_camera.col(0)
    return [first, *(first + affine_camera.col(j) for j in (1, 2, 3))]


section.identity(
    "2/object-frame",
    "the camera in the affine system of the object",
    printed=columns(*images_of_basic_points(camera * frame(G))),
    derived=columns(*(camera * homogeneous(G.row(n).T) for n in range(4))),
)

# %% [markdown]
# **Result.**  These images are the affine frame of the image, and their denominators are the factors $\mu_j$:  $\mathbf
# A_v \mathbf M^* = \mathbf A \mathbf A_X$ without a factor.  So the collinearity equations annihilate the center of
# 1996 in the affine system, $\mathbf A_X \mathbf y_0$, with $\mu_j / \mu_0$ for its parameters.

# %%
affine_camera = Matrix(3, 4, sympy.symbols("b:3:4"))
seen = images_of_basic_points(affine_camera)
g = rows(*map(inhomogeneous, seen[:3]))
u3 = coordinates(inhomogeneous(seen[3]), g)
of_camera = given((mu0, mu1, mu2, mu3, u31, u32), (*(image[0] for image in seen), *u3))

section.identity(
    "2/core",
    "the matrix of the collinearity equations and the core of 1996",
    printed=frame(g) * core,
    where=of_camera,
    derived=affine_camera,
)
section.identity(
    "2/center",
    "the center of projection of both papers",
    printed=vector(0, 0, 0),
    derived=core * homogeneous(y0_of_mu.xreplace({m: over(m, mu0) for m in (mu1, mu2, mu3)})),
)

# %% [markdown]
# ## How many parameters are these?
#
# **Count.**  Five parameters of the core and six of the affine frame of the image: in the affine system of the object
# they give all eleven coefficients.  $\mu_0 = 1$ belongs to the constant of the denominator.

# %%
g_any = Matrix(3, 2, sympy.symbols("g:3:2"))
in_affine_system = (frame(g_any) * core).xreplace({mu0: sympy.Integer(1)})
section.count(
    "2/eleven",
    "core and frame of the image have as many parameters as the collinearity equations",
    printed=11,
    derived=vector(*in_affine_system[1:]),
    variables=(*core_parameters, *g_any),
)

# %% [markdown]
# ## What do affine coordinates not notice?
#
# **Definition.**  Okamoto's camera: rotation $(e_{ij})$ and center, principal distance $c$, then an orthogonal
# projection of the picture to the comparator, with the rotation $(d_{ij})$.  The comparator sees the picture through an
# affine transformation, which affine coordinates do not notice.  Hence $\mathbf M^*$ needs neither the interior
# orientation nor the inclination of the comparator.

# %%
e = Matrix(3, 3, sympy.symbols("e:3:3"))
D = Matrix(3, 3, sympy.symbols("d:3:3"))
c, x_center, y_center = sympy.symbols("c xco yco")
center = vector(*sympy.symbols("Xo Yo Zo"))
x, y = sympy.symbols("x y")

ray = e * (point - center)
picture_point = vector(over(-c * ray[0], ray[2]), over(-c * ray[1], ray[2]))


def comparator(picture: Matrix) -> Matrix:
    """Return the measured coordinates of a point of the picture: two rows of the rotation, and the origin."""
    return vector(x_center, y_center) + D[:2, :] * vector(*picture, -c)


device = Matrix(
    [
        [1, 0, 0],
        [x_center - c * D[0, 2], D[0, 0], D[0, 1]],
        [y_center - c * D[1, 2], D[1, 0], D[1, 1]],
    ]
)
section.identity(
    "2/comparator",
    "the comparator is an affine transformation of the picture",
    printed=device * vector(1, x, y),
    derived=homogeneous(comparator(vector(x, y))),
)
picture = vector(*sympy.symbols("v1 v2"))
picture_frame = Matrix(3, 2, sympy.symbols("g:3:2"))
section.identity(
    "2/comparator#affine",
    "the comparator does not change the affine coordinates of 1996",
    printed=coordinates(picture, picture_frame),
    derived=coordinates(comparator(picture), rows(*(comparator(picture_frame.row(n).T) for n in range(3)))),
)

# %% [markdown]
# **An example.**  A square in the picture, and what a comparator sees that is inclined about two axes.  Parallels stay
# parallel.

# %%
INCLINED = Matrix([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3
inclined = given((*D, x_center, y_center, c), (*INCLINED, 0, 0, sympy.Rational(1, 2)))
SQUARE = {"0": vector(0, 0), "1": vector(1, 0), "2": vector(0, 1), "3": vector(1, 1)}
SIDES = [vector(0, 1, 0), vector(0, 0, 1), vector(1, -1, 0), vector(1, 0, -1)]
ImageDrawing(
    "A square in the picture, and a parallelogram in the comparator.  The point 3 has the affine coordinates (1, 1) "
    "in both.",
    {
        "picture": (SQUARE, SIDES),
        "comparator": (
            {name: comparator(corner).xreplace(inclined) for name, corner in SQUARE.items()},
            [inverse(device.xreplace(inclined)).T.doit() * side for side in SIDES],
        ),
    },
    axes=("x", "y"),
)

# %% [markdown]
# **Result.**  (6) of Okamoto as a matrix; divided by its first element it is that of 2/collinearity.

# %%
L = Matrix([[0, 0, 1], [-c, 0, 0], [0, -c, 0]])
photogrammetric = device * L * e * columns(-center, Matrix.eye(3))
section.identity(
    "2/photogrammetric",
    "the collinearity equations from the photogrammetric parameters",
    printed=inhomogeneous(photogrammetric * homogeneous(point)),
    derived=comparator(picture_point),
)
