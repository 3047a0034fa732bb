"""Gradients of what has functions that nothing gives: their derivatives are those that the document writes."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

LAGRANGE = r"The Lagrangian is \[ L(x, \lambda) = f(x) + \lambda^T c(x) \] It has "
LINEAR = (
    r"The Lagrangian is \[ L(\mathbf x, \boldsymbol\lambda) = f(\mathbf x) "
    r"+ \boldsymbol\lambda^T (\mathbf A \mathbf x - \mathbf b) \] It has "
    r"\[ \nabla_{\mathbf x} L(\mathbf x, \boldsymbol\lambda) = "
)
BOLD = (
    r"The Lagrangian is \[ L(\mathbf x, \boldsymbol\lambda) = f(\mathbf x) "
    r"+ \boldsymbol\lambda^T \mathbf c(\mathbf x) \] It has "
)
COST = (
    r"The cost is \[ F(\mathbf x) = \frac12 \mathbf r(\mathbf x)^T \mathbf r(\mathbf x) \] with the Jacobian "
    r"\[ \mathbf J = \frac{\partial\mathbf r}{\partial\mathbf x} \] Hence "
)
LENGTH = r"The cost is \[ F(\mathbf x) = \frac12 \|\mathbf r(\mathbf x)\|^2 \] Hence "
OF_R = r"\left(\frac{\partial\mathbf r(\mathbf x)}{\partial\mathbf x}\right)"
FOLLOWS = {
    "by the multipliers": LAGRANGE + r"\[ \nabla_\lambda L(x, \lambda) = c(x) \]",
    "by bold multipliers": BOLD
    + r"\[ \nabla_{\boldsymbol\lambda} L(\mathbf x, \boldsymbol\lambda) = \mathbf c(\mathbf x) \]",
    "by what is beside them": (LINEAR + r"\nabla f(\mathbf x) + \mathbf A^T \boldsymbol\lambda \]"),
    "rows": BOLD + r"\[ \frac{\partial L}{\partial\mathbf x} = \frac{\partial f}{\partial\mathbf x} "
    r"+ \boldsymbol\lambda^T \frac{\partial\mathbf c}{\partial\mathbf x} \]",
    "Gauss and Newton": COST + r"\[ \nabla F(\mathbf x) = \mathbf J^T \mathbf r(\mathbf x) \]",
    "Gauss and Newton in a row": COST
    + r"\[ \frac{\partial F}{\partial\mathbf x} = \mathbf r(\mathbf x)^T \mathbf J \]",
    "a length": LENGTH + rf"\[ \nabla F(\mathbf x) = {OF_R}^T \mathbf r(\mathbf x) \]",
}
MISLEADING = {
    "the other function": LAGRANGE + r"\[ \nabla_\lambda L(x, \lambda) = f(x) \]",
    "a factor": LAGRANGE + r"\[ \nabla_\lambda L(x, \lambda) = 2 c(x) \]",
    "at another place": LAGRANGE + r"\[ \nabla_\lambda L(x, \lambda) = c(y) \]",
    "no transpose": (LINEAR + r"\nabla f(\mathbf x) + \mathbf A \boldsymbol\lambda \]"),
    "another function's gradient": (LINEAR + r"\nabla g(\mathbf x) + \mathbf A^T \boldsymbol\lambda \]"),
    "a gradient elsewhere": (LINEAR + r"\nabla f(\mathbf y) + \mathbf A^T \boldsymbol\lambda \]"),
    "a gradient by another letter": (
        LINEAR + r"\nabla_{\mathbf b} f(\mathbf x) "
        r"+ \mathbf A^T \boldsymbol\lambda \]"
    ),
    "the other layout": BOLD + r"\[ \frac{\partial L}{\partial\mathbf x} = \frac{\partial f}{\partial\mathbf x} "
    r"+ \frac{\partial\mathbf c}{\partial\mathbf x} \boldsymbol\lambda \]",
    "without a transpose": COST + r"\[ \nabla F(\mathbf x) = \mathbf J \mathbf r(\mathbf x) \]",
    "twice": COST + r"\[ \nabla F(\mathbf x) = 2 \mathbf J^T \mathbf r(\mathbf x) \]",
    "a length without a transpose": LENGTH + rf"\[ \nabla F(\mathbf x) = {OF_R} \mathbf r(\mathbf x) \]",
    "by another letter": COST.replace(r"{\partial\mathbf x}", r"{\partial\mathbf y}")
    + r"\[ \nabla F(\mathbf x) = \mathbf J^T \mathbf r(\mathbf x) \]",
    "a function of two": (
        r"The cost is \[ F(\mathbf x) = \mathbf r(\mathbf x, \mathbf x)^T \mathbf b \] Hence "
        r"\[ \nabla F(\mathbf x) = \frac{\partial\mathbf r}{\partial\mathbf x}^T \mathbf b \]"
    ),
    "an inner function": (
        r"The cost is \[ F(\mathbf x) = \mathbf r(2 \mathbf x)^T \mathbf b \] Hence "
        r"\[ \frac{\partial F}{\partial\mathbf x} = \mathbf b^T \frac{\partial\mathbf r}{\partial\mathbf x} \]"
    ),
    "a weight that changes": (
        r"The cost is \[ F(\mathbf x) = \mathbf r(\mathbf x)^T \mathbf W \mathbf r(\mathbf x) \] where $\mathbf W$ "
        r"depends on $\mathbf x$. Hence \[ \frac{\partial F}{\partial\mathbf x} = 2 \mathbf r(\mathbf x)^T \mathbf W "
        r"\frac{\partial\mathbf r}{\partial\mathbf x} \]"
    ),
}


@pytest.mark.parametrize("document", FOLLOWS.values(), ids=FOLLOWS)
def test_follows(document):
    assert read_document(document_of(document))[-1].verdict == "follows"


@pytest.mark.parametrize("document", MISLEADING.values(), ids=MISLEADING)
def test_does_not_follow(document):
    assert read_document(document_of(document))[-1].verdict not in ("follows", "contradicts")
