# %% [markdown]
# # 6 Frames and homographies
#
# The matrix of projection of 1996 is a camera matrix in special frames, and the matrix $\mathbf T$ of the normal case
# is a homography of rectification.

# %%
import sympy

from algebroproj_derivations.bridges.s4_fundamental_matrix import matrix_of
from algebroproj_derivations.figures import ImageDrawing
from algebroproj_derivations.fundamentals1996.notation import BARYCENTRIC, U, mu0, mu1, mu2, mu3, u1, u2, u30, u31, u32
from algebroproj_derivations.fundamentals1996.s1_2_determination_of_projection import M_star
from algebroproj_derivations.fundamentals1996.s3_1_normal_case_transformation import T, tau1, tau2
from algebroproj_derivations.fundamentals1996.s3_2_normal_case import Z_N, z_n
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, adjugate, columns, cross, homogeneous, inverse, vector

section = Section("bridges", "6", "Frames and homographies")

# %% [markdown]
# ## What is the matrix of projection in a projective frame?
#
# **Definition.**  In barycentric coordinates the basic points are the unit vectors, in the image as in space.  With the
# image of the fourth point as unit point of the image, the frame is projective, and the camera is the *reduced camera
# matrix* of Hartley and Zisserman: four parameters, but for a factor.

# %%
U_space = Matrix([[1, -1, -1, -1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
barycentric = U * M_star[:3, :] * inverse(U_space)
fourth = vector(u30, u31, u32).xreplace(BARYCENTRIC)
a, b, c, d = sympy.symbols("ra rb rc rd")


# %% [markdown]
# **Result.**  The columns are the images of the four basic points.  The sign of the last column makes the center $(1/a,
# 1/b, 1/c, 1/d)$.  No three of the images may be collinear: $u_{30} u_{31} u_{32}$ is not zero.

# %%
section.identity(
    "6/barycentric",
    "the matrix of projection in barycentric coordinates",
    printed=Matrix([[mu0, 0, 0, mu3 * u30], [0, mu1, 0, mu3 * u31], [0, 0, mu2, mu3 * u32]]),
    where=BARYCENTRIC,
    derived=barycentric,
)
section.identity(
    "6/reduced-camera",
    "the matrix of projection in a projective frame",
    printed=Matrix([[a, 0, 0, -d], [0, b, 0, -d], [0, 0, c, -d]]),
    where={a: mu0 / fourth[0], b: mu1 / fourth[1], c: mu2 / fourth[2], d: -mu3},
    derived=inverse(Matrix.diag(*fourth)) * barycentric,
)
section.identity(
    "6/reduced-camera#center",
    "the center of the reduced camera",
    printed=vector(0, 0, 0),
    derived=barycentric * vector(fourth[0] / mu0, fourth[1] / mu1, fourth[2] / mu2, -1 / mu3),
)

# %% [markdown]
# ## Which homography rectifies?
#
# **Definition.**  $\mathbf T$ maps points, $\mathbf u_N \sim \mathbf T \mathbf u$.  Three points it leaves alone, the
# images of the basic points; with the pair of fourth points they determine it (3.1.2#fourth-points of 1996).  Lines are
# mapped by the inverse transposed, and so is the matrix of correlation.
#
# With $\mathbf C = \mathbf T'^T \mathbf Z_N \mathbf T''$ of (3.3.3), $\mathbf F_N = \mathbf H''^{-T} \mathbf F \mathbf
# H'^{-1}$ up to a factor.

# %%
taup1, taup2, taupp1, taupp2 = sympy.symbols("taup1 taup2 taupp1 taupp2")
H_left, H_right = T.xreplace({tau1: taup1, tau2: taup2}), T.xreplace({tau1: taupp1, tau2: taupp2})
units = columns(*map(homogeneous, (vector(0, 0), vector(1, 0), vector(0, 1))))

section.identity(
    "6/homography",
    "the transformation leaves the images of the basic points alone",
    printed=units * Matrix.diag(1, tau1, tau2),
    derived=T * units,
)
C_original = H_left.T * Z_N * H_right
section.identity(
    "6/rectified",
    "the fundamental matrix of the rectified images",
    printed=inverse(H_right).T * C_original.T * inverse(H_left),
    derived=Z_N.T,
)

# %% [markdown]
# **An example.**  The left image before and after $\mathbf T$.  The right image gives the same three lines.

# %%
FACTORS = {taup1: 3, taup2: 2, taupp1: sympy.Rational(5, 4), taupp2: 1}
T_left, T_right = (transformation.xreplace(FACTORS) for transformation in (H_left, H_right))
Z_normal = Z_N.xreplace({z_n: sympy.Rational(1, 4)})
GRID = {"G0": vector(0, 0), "G1": vector(1, 0), "G2": vector(0, 1), "P": vector(1, 1)}
RIGHT = [vector(0, 0), vector(sympy.Rational(1, 2), sympy.Rational(1, 2)), vector(0, 1)]


def transformed(seen: Matrix) -> Matrix:
    image = T_left * homogeneous(seen)
    return (image / image[0])[1:, :]


ImageDrawing(
    "The lines of three points of the right image meet in the epipole.  After the transformation they are parallel; "
    "the images of the basic points are where they were.",
    {
        "original": (GRID, [T_left.T * Z_normal * T_right * homogeneous(seen) for seen in RIGHT]),
        "rectified": (
            {name: transformed(seen) for name, seen in GRID.items()},
            [Z_normal * T_right * homogeneous(seen) for seen in RIGHT],
        ),
    },
)

# %% [markdown]
# **After it?**  In rectified images the textbook has $\mathbf F = [\mathbf i]_\times$ with the epipoles at infinity,
# $\mathbf i$ the direction of the base.
#
# The leading component of the direction is 0: it is the point at infinity in which all epipolar lines meet.

# %%
direction = vector(0, -z_n, 1)
section.identity(
    "6/rectified#skew",
    "the matrix of the normal case is the matrix of a vector product",
    printed=matrix_of(direction).T,
    derived=Z_N.T,
)
section.identity(
    "6/rectified#epipoles",
    "both epipoles are the point at infinity of the base",
    printed=Matrix.zeros(3, 2),
    derived=columns(Z_N * direction, Z_N.T * direction),
)
line = matrix_of(direction) * homogeneous(vector(u1, u2))
section.up_to_scale(
    "6/rectified#lines",
    "epipolar lines of the normal case are parallel",
    printed=direction,
    derived=cross(line, vector(1, 0, 0)),
)
section.up_to_scale(
    "6/line-map",
    "lines are mapped by the inverse transposed homography",
    printed=adjugate(H_left).T * cross(homogeneous(vector(u1, u2)), vector(1, 0, 0)),
    derived=cross(H_left * homogeneous(vector(u1, u2)), H_left * vector(1, 0, 0)),
)
