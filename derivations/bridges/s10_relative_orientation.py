# %% [markdown]
# # 10 From an essential matrix to points
#
# An essential matrix is known, and the rays of homologous points.  Where are the points, which of the four orientations
# is the real one, and how far are the rays from meeting?

# %%
import sympy

from algebroproj_derivations.cameras import skew
from algebroproj_derivations.figures import SpaceDrawing
from algebroproj_derivations.fundamentals1996.s1_4_orthonormalized_systems import rotation
from algebroproj_derivations.inserting import given
from algebroproj_derivations.poses import poses
from algebroproj_sym import Section
from algebroproj_sym.declaring import let
from algebroproj_sym.expressions import Matrix, cross, diff, dot, linear_system, over, solve, vector

section = Section("bridges", "10", "From an essential matrix to points")

# %% [markdown]
# ## Where is the point?
#
# **Definition.**  A point is $\lambda' \mathbf u'$ in the left system and $\lambda'' \mathbf u''$ in the right one,
# with $\mathbf u = (x, y, 1)^T$.  In the left system the right ray begins at the base $\mathbf b$ and has the direction
# $\mathbf v = \mathbf R \mathbf u''$: $\mathbf X = \mathbf b + \lambda'' \mathbf v$.  Measured rays do not meet.
#
# **Question.**  Which points of both rays are nearest to each other?
#
# **Derivation.**  What joins them is at right angles to both rays: two linear equations.
#
# **Result.**  The depths are triple products with the normal $\mathbf n = \mathbf u' \times \mathbf v$.  Rays that are
# nearly parallel have a small normal.  Its elements are small differences, and lose digits once; the determinant of the
# equations, $\mathbf n^T \mathbf n$, would lose them twice.

# %%
left = vector(*sympy.symbols("xp yp"), 1)
right = vector(*sympy.symbols("xpp ypp"), 1)
base = vector(*sympy.symbols("b:3"))
turn = Matrix(3, 3, sympy.symbols("r:3:3"))
ray = vector(*sympy.symbols("v:3"))
normal = vector(*sympy.symbols("n:3"))
depth_left, depth_right = depths = sympy.symbols("lamp lampp")

gap = depth_left * left - base - depth_right * ray
nearest = vector(*solve(*linear_system([dot(left, gap), dot(ray, gap)], depths)))
by_normal = vector(*(over(dot(normal, cross(base, other)), dot(normal, normal)) for other in (ray, left)))
of_normal = given(normal, cross(left, ray))

section.identity(
    "10/depths",
    "depths of the nearest points of two rays",
    printed=by_normal.xreplace(of_normal),
    derived=nearest,
)

# %% [markdown]
# **An example.**  The left ray goes along the third axis, the right one past it at a distance of 1.

# %%
NEAREST = {"P'": vector(0, 0, 4), "P''": vector(0, 1, 4), "P": vector(0, sympy.Rational(1, 2), 4)}
SpaceDrawing(
    "Two rays that do not meet.  What joins their nearest points is at right angles to both; P is in the middle.",
    {"C'": vector(0, 0, 0), "C''": vector(3, 1, 0), **NEAREST},
    segments=[("C'", "C''"), ("C'", "P'"), ("C''", "P''"), ("P'", "P''")],
    axes=("X_1", "X_2", "X_3"),
)

# %% [markdown]
# **Result.**  If the rays meet, the point in the middle is the point itself.

# %%
middle = (by_normal[0] * left + base + by_normal[1] * ray) / 2
they_meet = given(base, depth_left * left - depth_right * ray)
section.identity(
    "10/middle",
    "the point in the middle is the object point if the rays meet",
    printed=depth_left * left,
    derived=middle.xreplace(of_normal).xreplace(they_meet),
)

# %% [markdown]
# ## Which orientation is the real one?
#
# **Definition.**  A point is in front of an image where its depth is positive.  An essential matrix, up to its sign,
# has two bases $\pm \mathbf b$ and two rotations.  The second rotation is the first one and half a turn about the base.
#
# **Question.**  What are the depths in the other orientations, if the rays meet?
#
# **Derivation.**  With $-\mathbf b$ both depths change their signs.  After half a turn the rays meet again, and both
# depths have a factor $k$, but one of them also a minus.
#
# **Result.**  The four orientations have the four pairs of signs: each point is in front of both images in exactly one
# of them.  A point as far from one center as from the other has parallel rays after half a turn, and no depths.

# %%
half_turn = over(2, dot(base, base)) * base * base.T - Matrix.eye(3)
section.identity(
    "10/twisted",
    "half a turn about the base changes the sign of the essential matrix",
    printed=-skew(base),
    derived=skew(base) * half_turn,
)
factor = over(dot(base, base), depth_left**2 * dot(left, left) - depth_right**2 * dot(ray, ray))
section.identity(
    "10/twisted#depths",
    "depths after half a turn about the base",
    printed=(factor * vector(depth_left, -depth_right)).xreplace(they_meet),
    derived=by_normal.xreplace(of_normal).xreplace(given(ray, half_turn * ray)).xreplace(they_meet),
)

# %% [markdown]
# ## How far are the images from those of a point?
#
# **Definition.**  The left image of $\mathbf X$ is $(X/Z, Y/Z)$; the right one that of $\mathbf R^T (\mathbf X -
# \mathbf b)$.

# %%
point = vector(*sympy.symbols("X Y Z"))


def image(seen: Matrix) -> Matrix:
    return vector(over(seen[0], seen[2]), over(seen[1], seen[2]))


residuals = {
    "left": vector(*left[:2]) - image(point),
    "right": vector(*right[:2]) - image(turn.T * (point - base)),
}
on_both_rays = given(point, depth_left * left) | given(turn, rotation)
section.identity(
    "10/residuals",
    "a point on both rays has no residuals",
    printed=Matrix.zeros(4, 1),
    derived=vector(*residuals["left"], *residuals["right"])
    .xreplace(given(base, point - depth_right * turn * right))
    .xreplace(on_both_rays),
)

# %% [markdown]
# ## Sampson's distance
#
# **Question.**  Without a point: by how much must a pair move to satisfy $\mathbf u'^T \mathbf C \mathbf u'' = 0$?
#
# **Derivation.**  To the first order the equation is $e + \mathbf g^T \mathbf d = 0$, with the gradient $\mathbf g$.
# The shortest solution is along the gradient.

# %%
C = Matrix(3, 3, sympy.symbols("c:3:3"))
coordinates = (*left[:2], *right[:2])
error = dot(left, C * right)
gradient = vector(*sympy.symbols("g:4"))
of_gradient = given(gradient, vector(*(diff(error, coordinate) for coordinate in coordinates)))
epipolar_left, epipolar_right = C * right, C.T * left
correction = over(-error, dot(gradient, gradient)) * gradient

section.identity(
    "10/gradient",
    "the gradient has elements of both epipolar lines",
    printed=vector(*epipolar_left[:2], *epipolar_right[:2]),
    derived=gradient.xreplace(of_gradient),
)
section.identity(
    "10/sampson",
    "the correction satisfies the linear equation",
    printed=-error,
    derived=dot(gradient, correction),
)

# %% [markdown]
# **Meaning.**  The square of the length of the correction is the square of Sampson's distance, $e^2 / \mathbf g^T
# \mathbf g$.

# %%
section.identity(
    "10/sampson#distance",
    "the square of Sampson's distance",
    printed=over(error**2, dot(gradient, gradient)),
    derived=dot(correction, correction),
)

# %% [markdown]
# ## Functions

# %%
ABOUT_BASE = "Base in the system of the left image; its unit is that of the points."
ABOUT_TURN = "Rotation from the right system to the left one."
ABOUT_LEFT = "Left image point (x', y'), divided by the principal distance."
ABOUT_RIGHT = "Right image point (x'', y''), divided by the principal distance."
EXAMPLE_TURN = (("0.96", "0", "0.28"), ("0", "1", "0"), ("-0.28", "0", "0.96"))
of_two_rays = {
    "arguments": {"R": turn, "b": base, "x_left": vector(*left[:2]), "x_right": vector(*right[:2])},
    "describe": {"R": ABOUT_TURN, "b": ABOUT_BASE, "x_left": ABOUT_LEFT, "x_right": ABOUT_RIGHT},
    "example": {"R": EXAMPLE_TURN, "b": ("1", "0", "0.25"), "x_left": ("0.25", "0.125"), "x_right": ("-0.25", "0.125")},
}
with_normal = {**of_two_rays, "through": [let(given(ray, turn * right)), let(of_normal)]}

section.kernel(
    "stereo.depths",
    "Depths of the nearest points of two rays: third coordinates in both systems; negative behind an image.",
    **with_normal,
    derived={"left": by_normal[0], "right": by_normal[1]},
    claims=["10/depths"],
)
section.kernel(
    "stereo.triangulate",
    "Object point in the middle of the nearest points of two rays, in the left system.",
    **with_normal,
    derived=middle,
    claims=["10/depths", "10/middle"],
)
section.kernel(
    "stereo.residuals",
    "Measured image points less those of an object point, in both images.",
    arguments={"X": point, **of_two_rays["arguments"]},
    describe={"X": "Object point in the left system, in the unit of the base.", **of_two_rays["describe"]},
    derived=residuals,
    claims=["10/residuals"],
    example={"X": ("0.5", "0.25", "2"), **of_two_rays["example"]},
)
section.kernel(
    "stereo.sampson",
    "Square of Sampson's distance, and the least change (x', y', x'', y'') that meets the condition to first order.",
    arguments={"C": C, "x_left": vector(*left[:2]), "x_right": vector(*right[:2])},
    describe={
        "C": "Matrix of correlation, u'^T C u'' = 0 for homologous points (x, y, 1), up to a factor.",
        "x_left": "Left image point (x', y'); any unit.",
        "x_right": "Right image point (x'', y''); the same unit.",
    },
    through=[let(of_gradient)],
    derived={"distance2": over(error**2, dot(gradient, gradient)), "correction": correction},
    claims=["10/gradient", "10/sampson", "10/sampson#distance"],
    example={
        "C": (("0", "-0.25", "0"), ("0.52", "0", "-0.89"), ("0", "1", "0")),
        "x_left": ("0.25", "0.125"),
        "x_right": ("-0.25", "0.125"),
    },
)
section.driver("stereo.poses", poses)
