# %% [markdown]
# # Notation of the paper
#
# Four object points $G_0, \dots, G_3$ are the unit points of an affine coordinate system of space; the images of
# $G_0, G_1, G_2$ are the unit points of an affine coordinate system of the image plane.  A point of space has the
# inhomogeneous coordinates $\mathbf y = (y_1, y_2, y_3)^T$, an image point $\mathbf u = (u_1, u_2)^T$; with a leading 1
# they become *quasihomogeneous*.

# %%
import sympy

from algebroproj_sym.expressions import Matrix, homogeneous, vector

mu0, mu1, mu2, mu3 = sympy.symbols("mu0 mu1 mu2 mu3")
u31, u32 = sympy.symbols("u31 u32")
y01, y02, y03 = sympy.symbols("y01 y02 y03")
u1, u2, u3 = sympy.symbols("u1 u2 u3")
y1, y2, y3 = sympy.symbols("y1 y2 y3")

mu = vector(mu1, mu2, mu3)
center = vector(y01, y02, y03)
fourth_image = vector(u31, u32)

# %% [markdown]
# The barycentric coordinates that belong to $G_0$ have symbols of their own in print, but they are no unknowns of their
# own: eliminated before any comparison, they cannot make a true identity look false.

# %%
y00, u30 = sympy.symbols("y00 u30")
BARYCENTRIC = {y00: 1 - y01 - y02 - y03, u30: 1 - u31 - u32}

# %% [markdown]
# The unit points of space, $\mathbf e_j$, and of the image plane, $\mathbf e'_j$.

# %%
e0, e1, e2, e3 = vector(0, 0, 0), vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)
image_e0, image_e1, image_e2 = (homogeneous(point) for point in (vector(0, 0), vector(1, 0), vector(0, 1)))
image_e3 = homogeneous(fourth_image)

# %% [markdown]
# $\mathbf U$ turns affine coordinates of the image plane into barycentric ones (section 1.1).

# %%
U = Matrix([[1, -1, -1], [0, 1, 0], [0, 0, 1]])
E3 = Matrix.eye(3)
E4 = Matrix.eye(4)

# %% [markdown]
# What the arguments of generated functions are.

# %%
ABOUT_MU = "Projective parameters (mu1, mu2, mu3) for mu0 = 1; dimensionless."
ABOUT_Y0 = "Center of projection (y01, y02, y03) in affine coordinates; dimensionless."
ABOUT_U3 = "Image (u31, u32) of the fourth basic point in affine coordinates; dimensionless."
