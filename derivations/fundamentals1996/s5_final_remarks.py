# %% [markdown]
# # 5 Final remarks
#
# What is gained, and what does it cost?  The section weighs advantages and drawbacks against those of conventional
# photogrammetry, and lists open problems.  What can be checked are linearity and counts.

# %%
import sympy

from algebroproj_derivations.fundamentals1996.notation import *
from algebroproj_derivations.fundamentals1996.s1_1_projection import quaternion, ratios
from algebroproj_derivations.fundamentals1996.s1_1_projection import rotation as scaled_rotation
from algebroproj_derivations.fundamentals1996.s1_3_properties_of_projection import M_star, center_equations
from algebroproj_derivations.fundamentals1996.s1_4_orthonormalized_systems import coordinates, g, v
from algebroproj_derivations.fundamentals1996.s1_5_space_to_space import factors, fifth_equations
from algebroproj_derivations.fundamentals1996.s2_2_correlation import (
    Z_general,
    equation,
    h_left,
    h_right,
    unknowns,
    up1,
    up2,
    upp1,
    upp2,
)
from algebroproj_derivations.fundamentals1996.s2_4_relative_orientation import axis_equations, forms_of_point, point
from algebroproj_derivations.fundamentals1996.s3_1_normal_case_transformation import T, mapped_u, tau1, tau2
from algebroproj_derivations.fundamentals1996.s3_2_normal_case import (
    flat_correlation,
    left_condition,
    left_fourth,
)
from algebroproj_derivations.fundamentals1996.s3_3_less_complicated_transformation import Z, border, parameters, product
from algebroproj_derivations.inserting import given
from algebroproj_sym import Section
from algebroproj_sym.expressions import Matrix, columns, diff, homogeneous, over, vector

section = Section("fundamentals1996", "5", "Final remarks")

# %% [markdown]
# ## Linearity
#
# **Is every step linear?**  In each step the results of the steps before are given.  An equation is linear exactly if
# it is its value at the origin plus the unknowns times their slopes there.
#
# All steps are.  The condition $\det \mathbf Z = 0$, which no step uses, is not linear.  2.2/beyond/first-equation
# tells what it is needed for.

# %%
steps = (
    ("center", "center of projection", center_equations, center),
    ("parameters", "parameters of a projection", center_equations, mu),
    ("fifth-point", "parameters of a projectivity of space", fifth_equations, factors),
    ("correlation", "matrix of correlation", [equation(Z_general)], unknowns),
    ("epipole-left", "epipole of the left image", h_right, (up1, up2)),
    ("epipole-right", "epipole of the right image", h_left, (upp1, upp2)),
    ("orientation", "relative orientation", axis_equations, mu),
    ("model", "relative model", forms_of_point, point),
    ("fourth-point", "fourth point of the normal case", [left_condition], left_fourth),
    ("normal-case", "transformation to the normal case", [product[p] - Z[p] for p in border], parameters),
)
for slug, title, equations, sought in steps:
    forms = vector(*equations)
    origin = dict.fromkeys(sought, sympy.S.Zero)
    linear_part = sum((diff(forms, unknown).xreplace(origin) * unknown for unknown in sought), forms.xreplace(origin))
    section.identity(
        f"5/linear#{slug}",
        f"linear equations: {title}",
        printed=linear_part,
        derived=forms,
    )

# %% [markdown]
# ## Interior orientation
#
# **Must it be known?**  No.  Principal point and normal distance, three parameters, are an affine transformation of the
# image.  The coordinates that refer to the basic points do not notice it.

# %%
c, principal_point = sympy.Symbol("c"), vector(*sympy.symbols("xC yC"))


def calibrated(image_point: Matrix) -> Matrix:
    return (image_point - principal_point).applyfunc(lambda component: over(component, c))


section.identity(
    "5/interior-orientation",
    "the interior orientation need not be known",
    printed=coordinates(v, g),
    derived=coordinates(calibrated(v), Matrix.vstack(*(calibrated(g.row(n).T).T for n in range(3)))),
)

# %% [markdown]
# ## Unknowns and control points
#
# **What does it cost?**  More unknowns.  Absolute orientation by a projectivity of space has fifteen, by a similarity
# seven.  The similarity here has an unnormalised quaternion, whose norm is the scale.  For one image see 1.1/general,
# for two images 2.2/beyond/seven-parameters and 2.2/conventional.

# %%
H = Matrix(4, 4, sympy.symbols("h:4:4"))
translation = vector(*sympy.symbols("t1 t2 t3"))
control_points = [vector(*sympy.symbols(f"x{k}1 x{k}2 x{k}3")) for k in range(1, 6)]
seven = (*quaternion, *translation)


def projected(control_point: Matrix) -> Matrix:
    first, *others = H * homogeneous(control_point)
    return vector(*(over(component, first) for component in others))


def moved(control_point: Matrix) -> Matrix:
    return translation + scaled_rotation * control_point


section.count(
    "5/unknowns",
    "absolute orientation by a projectivity has fifteen unknowns",
    printed=15,
    derived=ratios(H),
    variables=tuple(H),
    kernel=[vector(*H)],
)
section.count(
    "5/unknowns#conventional",
    "absolute orientation by a similarity has seven unknowns",
    printed=7,
    derived=columns(translation, scaled_rotation),
    variables=seven,
)

# %% [markdown]
# And more control points.  Fifteen unknowns need five points, seven need three.

# %%
for slug, title, printed, images in (
    ("", "five points determine the projectivity", 15, [projected(x) for x in control_points]),
    (
        "#four",
        "four points leave three parameters of the projectivity open",
        12,
        [projected(x) for x in control_points[:4]],
    ),
):
    section.count(
        f"5/control-points{slug}",
        title,
        printed=printed,
        derived=vector(*(component for image in images for component in image)),
        variables=tuple(H),
        kernel=[vector(*H)],
    )
for slug, title, printed, images in (
    ("conventional", "three points determine the similarity", 7, [moved(x) for x in control_points[:3]]),
    ("two", "two points leave one parameter of the similarity open", 6, [moved(x) for x in control_points[:2]]),
):
    section.count(
        f"5/control-points#{slug}",
        title,
        printed=printed,
        derived=vector(*(component for image in images for component in image)),
        variables=seven,
    )

# %% [markdown]
# ## Open problems
#
# The list is no statement that could be checked.  Two of its items are decided by a short derivation.
#
# **A plane object.**  There is no relative orientation without knowledge of the cameras.  By 3.2/flat-model its
# images leave all matrices $\mathbf M'^{-T} \mathbf S \mathbf M''^{-1}$ with a skew-symmetric $\mathbf S$ as matrices
# of correlation.

# %%
axis = vector(*sympy.symbols("s1 s2 s3"))
left_undetermined = flat_correlation(axis)
section.count(
    "5/beyond/plane-object",
    "the images of a plane object leave two parameters of the correlation undetermined",
    printed=2,
    derived=left_undetermined.applyfunc(lambda element: over(element, left_undetermined[1, 0])),
    variables=tuple(axis),
    kernel=[axis],
)

# %% [markdown]
# **Relative orientation from the normal case.**  (3.3.8) and (3.3.9) give the parameters $\mu_{Nj}$ of the normal case;
# by $\tau_j = \mu_{Nj} / \mu_j$ they give those of the original bundles, with $\tau_3$ from
# $\mathbf T \mathbf u_3 = \tau_3 \mathbf u_{N3}$.

# %%
mu_normal = sympy.symbols("muN1 muN2 muN3")
tau3 = (T * homogeneous(fourth_image))[0]
fourth_of_normal = mapped_u.xreplace({u1: u31, u2: u32})
original = {m: over(m_normal, tau) for m, m_normal, tau in zip(mu, mu_normal, (tau1, tau2, tau3), strict=True)}
of_normal_case = given((*mu, *fourth_image), (*mu_normal, *fourth_of_normal))
section.identity(
    "5/beyond/orientation-from-normal-case",
    "the bundle of the normal case is the original one with its parameters divided by tau",
    printed=T * M_star[:3, :].xreplace(original),
    derived=M_star[:3, :].xreplace(of_normal_case),
)

# %% [markdown]
# **The others.**  Critical configurations are treated in section 2.3.  On stability there are the claims that say
# where a system is singular, such as 2.4/beyond/singular and 2.4/beyond/D'', and rounding errors of the generated
# functions are measured against the exact derivation.  Not treated are image triangulation, the propagation of errors
# of measurement, and optical distortion.
