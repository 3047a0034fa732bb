r"""Index notation: what stands twice in a term as an index is summed, and every other index is any of 1 to 3."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

HOOKE = (
    r"With the summation convention the stress is "
    r"\[ \sigma_{ij} = \lambda \varepsilon_{kk} \delta_{ij} + 2 \mu \varepsilon_{ij}. \] "
)
DEVIATOR = (
    HOOKE + r"The deviator is \[ s_{ij} = \sigma_{ij} - \frac13 \sigma_{kk} \delta_{ij} \] and "
    r"\[ J = \frac12 s_{ij} s_{ij}. \] Hence "
)
STIFFNESS = (
    r"With the summation convention, "
    r"\[ C_{ijkl} = \lambda \delta_{ij} \delta_{kl} + \mu (\delta_{ik} \delta_{jl} + \delta_{il} \delta_{jk}) \] and "
    r"\[ e_{ij} = \frac12 (u_{i,j} + u_{j,i}). \] Hence "
)
FLUID = (
    r"The stress tensor is, summed over repeated indices, \[ \sigma_{ij} = -p \delta_{ij} + 2 \mu S_{ij} \] with the "
    r"strain rate \[ S_{ij} = \frac12 \left( \frac{\partial u_i}{\partial x_j} + \frac{\partial u_j}{\partial x_i} "
    r"\right). \] Hence "
)
STRAIN = (
    r"With the summation convention, \[ e_{ij} = \frac12 (u_{i,j} + u_{j,i}). \] "
    r"It is symmetric: \[ e_{ij} = e_{ji}. \] The rotation is \[ w_{ij} = \frac12 (u_{i,j} - u_{j,i}). \] Hence "
)
SOLID = (
    r"Summation over repeated indices is understood. Let $e_{ij}$ be the strain tensor. With the stiffness "
    r"\[ C_{ijkl} = \lambda \delta_{ij} \delta_{kl} + \mu (\delta_{ik} \delta_{jl} + \delta_{il} \delta_{jk}) \] "
    r"the stress is \[ s_{ij} = C_{ijkl} e_{kl}. \] Hence "
)
SIGNS = r"With the permutation symbol $\epsilon_{ijk}$ and the summation convention, "
CROSS = SIGNS + r"\[ w_i = \epsilon_{ijk} u_j v_k. \] Hence "


def last(latex):
    return read_document(document_of(latex))[-1]


@pytest.mark.parametrize(
    ("above", "claim"),
    [
        (HOOKE + "Hence ", r"\sigma_{kk} = (3 \lambda + 2 \mu) \varepsilon_{kk}"),
        (DEVIATOR, r"s_{kk} = 0"),
        (DEVIATOR, r"s_{ij} = 2 \mu \left( \varepsilon_{ij} - \frac13 \varepsilon_{kk} \delta_{ij} \right)"),
        (DEVIATOR, r"J = \frac12 \sigma_{ij} \sigma_{ij} - \frac16 \sigma_{kk}^2"),
        (STIFFNESS, r"C_{ijkl} e_{kl} = \lambda e_{kk} \delta_{ij} + 2 \mu e_{ij}"),
        (STIFFNESS, r"C_{ijkl} e_{kl} = C_{ijkl} u_{k,l}"),
        (STIFFNESS, r"C_{ijkl} = C_{klij}"),
        (FLUID, r"\sigma_{kk} = -3 p + 2 \mu S_{kk}"),
        (FLUID, r"\sigma_{ij} = \sigma_{ji}"),
        (FLUID, r"\sigma_{ij} S_{ij} = - p S_{kk} + 2 \mu S_{ij} S_{ij}"),
        (STRAIN, r"u_{i,j} = e_{ij} + w_{ij}"),
        (STRAIN, r"e_{kk} = u_{k,k}"),
        (SOLID, r"s_{ij} = \lambda e_{kk} \delta_{ij} + \mu (e_{ij} + e_{ji})"),
        (r"With the summation convention, \[ u_{i,j} = a_{ij}. \] Hence ", r"u_i u_i a_{jj} = u_j u_j a_{ii}"),
        (SIGNS, r"\epsilon_{ijk} \epsilon_{imn} = \delta_{jm} \delta_{kn} - \delta_{jn} \delta_{km}"),
        (CROSS, r"w_i u_i = 0"),
        (r"With the summation convention, \[ s = a_{ii} b. \] Let \[ a_{ij} = c_i d_j. \] Hence ", r"s = c_i d_i b"),
    ],
)
def test_what_follows_by_components(above, claim):
    assert last(rf"{above}\[ {claim} \]").verdict == "follows"


@pytest.mark.parametrize(
    ("above", "claim"),
    [
        (HOOKE + "Hence ", r"\sigma_{kk} = (2 \lambda + 2 \mu) \varepsilon_{kk}"),
        (HOOKE + "Hence ", r"\sigma_{kk} = (\lambda + 2 \mu) \varepsilon_{kk}"),
        (DEVIATOR, r"J = \frac12 \sigma_{ij} \sigma_{ij} - \frac13 \sigma_{kk}^2"),
        (DEVIATOR, r"J = \frac12 \sigma_{ij} \sigma_{ij} + \frac16 \sigma_{kk}^2"),
        (STIFFNESS, r"C_{ijkl} e_{kl} = \lambda e_{kk} \delta_{ij} + \mu e_{ij}"),
        (STIFFNESS, r"C_{ijkl} = C_{ikjl}"),
        (STRAIN, r"u_{i,j} = e_{ij} - w_{ij}"),
        (STRAIN, r"w_{ij} = w_{ji}"),
        (SOLID, r"s_{ij} = \lambda e_{kk} \delta_{ij} + 2 \mu e_{ij}"),
        (FLUID, r"\sigma_{kk} = -p + 2 \mu S_{kk}"),
        (SIGNS, r"\epsilon_{ijk} \epsilon_{imn} = \delta_{jm} \delta_{kn} + \delta_{jn} \delta_{km}"),
        (CROSS, r"w_i u_j = 0"),
    ],
)
def test_a_misprint_does_not_follow(above, claim):
    assert last(rf"{above}\[ {claim} \]").verdict != "follows"


@pytest.mark.parametrize(
    "latex",
    [
        r"With the summation convention, \[ c_i = a_{ij} b_j. \] Hence \[ b_j = c_i / a_{ij} \]",
        r"With the summation convention, \[ c_i = a_{ij} b_j. \] Hence \[ c_i c_i = a_{ij} b_j a_{ij} b_j \]",
        r"With the summation convention, \[ c_i = a_{ij} b_j. \] Hence \[ c_j = a_{ij} b_j \]",
        r"In two dimensions, with the summation convention, \[ t = \delta_{kk}. \] Hence \[ t = 3 \]",
        r"In two dimensions, with the summation convention, \[ s_{ij} = a_{ij} - \frac13 a_{kk} \delta_{ij}. \] "
        r"Hence \[ s_{kk} = 0 \]",
        r"With the summation convention, \[ w_i = \epsilon_{ijk} u_j v_k. \] Hence \[ w_i u_i = 0 \]",
        r"With the summation convention, \[ \delta_{ij} = x_i y_j. \] Hence \[ \delta_{ij} a_j = a_i \]",
        r"With the summation convention, \[ \delta_{ij} a_j = a_i. \] Hence \[ \delta_{ij,k} \delta_{ij,k} = 9 \]",
        r"The graph has the weights \[ L_{ij} = d_i \delta_{ij} - a_{ij}. \] Hence \[ L_{ii} = 3 d_i - a_{ii} \]",
    ],
)
def test_what_is_not_said_by_the_convention_does_not_follow(latex):
    assert last(latex).verdict not in ("follows", "contradicts")


def test_the_sums_are_said():
    (link,) = last(HOOKE + r"Hence \[ \sigma_{kk} = (3 \lambda + 2 \mu) \varepsilon_{kk} \]").links
    assert link.reason.endswith("with sums from 1 to 3 over what stands twice in a term as an index")
