# %% [markdown]
# # 7 Vocabulary
#
# What the papers call things, and what Hartley and Zisserman, *Multiple View Geometry*, call them.  The last column
# names the claims that make a line of the table a statement; without a paper key they are claims of these bridges.
#
# | papers | textbook | claim |
# |---|---|---|
# | quasihomogeneous vector, 1 first | homogeneous vector, 1 last | 7/order |
# | singular projective matrix $\mathbf M^*$ | camera matrix $\mathrm P$ | 2/core, 2/collinearity |
# | collinearity equations, $A_1, \dots, A_{11}$ | projective camera, 11 degrees of freedom | 2/eleven |
# | center of projection $\mathbf y_0$ | camera center, null vector of $\mathrm P$ | 4/center, 2/center |
# | affine frames $\mathbf A_v$, $\mathbf A_X$ | change of coordinates of image, world | 2/core, 3/image-frame |
# | interior orientation, $(x, y, -c)$ | calibration matrix $\mathrm K$ | 1/image-vector |
# | four basic points | projective frame, reduced camera matrix | 6/reduced-camera |
# | basic points and unit point | projective basis | rhodos1990:1.1/beyond/general-position |
# | matrix of correlation $\mathbf C$ | fundamental matrix $\mathrm F = \mathbf C^T$ | 4/F, 4/pseudo-inverse |
# | parameters of stereo correlation | 7 degrees of freedom of $\mathrm F$ | critical1996:0/beyond/seven-parameters |
# | matrix of correlation, calibrated | essential matrix $\mathrm E = \mathbf C^T$ | 5/E, 5/singular-values, 5/trace |
# | usual set of relative orientation | 5 of $\mathrm E$ | critical1996:0/introduction-usual-set |
# | coplanarity, $(\mathbf p' \times \mathbf b) \cdot \mathbf p'' = 0$ | epipolar constraint | 4/F#homologous |
# | Okamoto's determinant | minors of two stacked cameras | 3/okamoto-factor |
# | dual transformation, $\mathbf C^T \mathbf u'$ | epipolar line $\mathrm F \mathbf x'$ | 4/epipolar-line |
# | epipole $\mathbf u_0$ | epipole, null vector of $\mathrm F$ | 4/epipoles |
# | eight equations, $\mathbf A_8 \mathbf z = \mathbf a$ | eight-point algorithm | 4/eight-points#1996 |
# | relative model | projective reconstruction | 4/canonical#model, 4/projective-ambiguity |
# | regular projective transformation | homography of space, 15 parameters | rhodos1990:1.1/parameters |
# | matrix $\mathbf T$ of the normal case | rectifying homography | 1/rectification, 6/homography, 6/rectified |
# | normal case | rectified pair, $\mathrm F = [\mathbf i]_\times$ | 1/normal-case, 6/rectified#skew |
# | critical configuration | critical surface, a quadric | 7/critical-surface |

# %%
import sympy

from algebroproj_derivations.bridges.s3_coplanarity import M_left, M_right, minors
from algebroproj_derivations.bridges.s4_fundamental_matrix import center_left, center_right
from algebroproj_derivations.figures import QuadricDrawing
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, dot, vector

section = Section("bridges", "7", "Vocabulary")

# %% [markdown]
# ## Does the order of components matter?
#
# **No.**  A permutation $\boldsymbol\Pi$ puts the 1 last.  Cameras become $\boldsymbol\Pi \mathbf M
# \boldsymbol\Pi_4^T$, the matrix of correlation $\boldsymbol\Pi \mathbf C \boldsymbol\Pi^T$.
#
# Equation, rank and null vectors do not depend on it.

# %%
u_left, u_right = (vector(*sympy.symbols(f"{name}:3")) for name in ("up", "upp"))
C = Matrix(3, 3, sympy.symbols("c:3:3"))
last = Matrix([[0, 1, 0], [0, 0, 1], [1, 0, 0]])
section.identity(
    "7/order",
    "the order of components",
    printed=dot(last * u_left, (last * C * last.T) * (last * u_right)),
    derived=dot(u_left, C * u_right),
)

# %% [markdown]
# ## What is a critical surface?
#
# **Definition.**  If a second matrix $\mathbf G$ explains the same homologous points, their object points lie on a
# quadric.  With symmetric $\mathbf Q$ it is $2 \mathbf Q = \mathbf M'^T \mathbf G \mathbf M'' + \mathbf M''^T \mathbf
# G^T \mathbf M'$.
#
# The matrix of correlation itself gives zero for all points.  Which quadrics are critical for eight and for five points
# is told in section 0 of critical1996.

# %%
G = Matrix(3, 3, sympy.symbols("h:3:3"))
y = vector(*sympy.symbols("y:4"))
doubled_quadric = M_left.T * G * M_right + M_right.T * G.T * M_left

section.identity(
    "7/critical-surface",
    "points with a second solution lie on a quadric",
    printed=dot(y, doubled_quadric * y),
    derived=2 * dot(M_left * y, G * (M_right * y)),
)
# %% [markdown]
# **An example.**  Both image vectors are the differences of the point and the center, the base is the first unit
# vector, and $\mathbf G$ is a diagonal matrix.

# %%
SHIFTED = given((*M_left, *M_right), (*Matrix.eye(4)[1:, :], *Matrix([[-1, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])))
SECOND = given(G, Matrix.diag(2, 1, -1))
QuadricDrawing(
    "Points of this quadric have two matrices of correlation.  It contains both centers.",
    doubled_quadric.xreplace(SHIFTED | SECOND),
    {"C'": vector(0, 0, 0), "C''": vector(1, 0, 0), "1": vector(-1, 0, 2), "2": vector(2, 0, -2), "3": vector(1, 2, 2)},
)

# %% [markdown]
# Both centers lie on every such quadric, and $\mathbf C$ itself gives none.

# %%
section.identity(
    "7/critical-surface#centers",
    "the quadric contains both centers",
    printed=vector(0, 0),
    derived=vector(*(dot(M_left * center, G * (M_right * center)) for center in (center_left, center_right))),
)
elements = given(G, minors(M_left, M_right))
section.identity(
    "7/critical-surface#trivial",
    "the matrix of correlation itself gives no quadric",
    printed=0,
    derived=dot(M_left * y, G.xreplace(elements) * (M_right * y)),
)
