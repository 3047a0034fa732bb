"""Sections: a derivation module declares its claims and kernels through one of these."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Unpack

from algebroproj_sym.declaring.claim import Claim, DeclarationError, Kind, Options, decimal, declared, reference
from algebroproj_sym.declaring.driver import Driver, declared_driver
from algebroproj_sym.declaring.jacobian import jacobian_parts
from algebroproj_sym.declaring.kernel import Kernel, KernelParts, declared_kernel
from algebroproj_sym.declaring.notebook import show_in_notebook
from algebroproj_sym.declaring.source import calling
from algebroproj_sym.expressions import provenance


class Section:
    """A section of a paper, which collects the claims and kernels in the order of their declaration.

    Parameters
    ----------
    paper : str
        The paper key.
    number : str
        The number of the section.
    title : str
        What the section is about.

    Examples
    --------
    >>> from sympy.abc import x
    >>> section = Section("demo", "1", "Squares")
    >>> claim = section.identity("1.1", "binomial", printed=x**2 + 2*x + 1, derived=(x + 1)**2)
    >>> claim.kind, len(section.claims)
    ('identity', 1)
    """

    def __init__(self, paper: str, number: str, title: str) -> None:
        self.paper = paper
        self.number = number
        self.title = title
        self.claims: list[Claim] = []
        self.kernels: list[Kernel] = []
        self.drivers: list[Driver] = []
        show_in_notebook(self)

    def identity(self, number: str, title: str, *, printed: Any, derived: Any, **options: Unpack[Options]) -> Claim:
        """Declare that two scalars, vectors or matrices are equal, wherever the constraints hold."""
        kind: Kind = "identity under constraints" if options.get("constraints") else "identity"
        return self._declare(kind, number, title, printed, derived, **options)

    def up_to_scale(self, number: str, title: str, *, printed: Any, derived: Any, **options: Unpack[Options]) -> Claim:
        """Declare that two vectors or matrices are equal but for a common factor."""
        return self._declare("identity up to scale", number, title, printed, derived, **options)

    def structure(self, number: str, title: str, *, printed: Any, derived: Any, **options: Unpack[Options]) -> Claim:
        """Declare where a matrix has zeros, equal entries and opposite entries: `printed` is a pattern of symbols."""
        return self._declare("structure", number, title, printed, derived, **options)

    def vanishing(self, number: str, title: str, *, printed: Any, derived: Any, **options: Unpack[Options]) -> Claim:
        """Declare that an expression is zero exactly where one of the factors `printed` is."""
        return self._declare("vanishing", number, title, tuple(printed), derived, **options)

    def rank(self, number: str, title: str, *, printed: int, derived: Any, **options: Unpack[Options]) -> Claim:
        """Declare the rank that a matrix has in general; `kernel` are independent vectors that it takes to zero."""
        return self._declare("rank", number, title, printed, derived, **options)

    def count(self, number: str, title: str, *, printed: int, derived: Any, **options: Unpack[Options]) -> Claim:
        """Declare how many of the functions `derived` of `variables` are independent.

        `kernel` are independent directions, in the variables, along which no function changes.
        """
        return self._declare("count", number, title, printed, derived, **options)

    def limit(self, number: str, title: str, *, printed: Any, derived: Any, **options: Unpack[Options]) -> Claim:
        """Declare the limit of an expression where `variable` goes to zero."""
        return self._declare("limit", number, title, printed, derived, **options)

    def numeric(self, number: str, title: str, *, printed: str, derived: Any, **options: Unpack[Options]) -> Claim:
        """Declare that a printed decimal number is the derived rational number, rounded as `rounding` says."""
        where = f"claim {self.paper}:{number}"
        if "corrected" in options:
            options["corrected"] = decimal(options["corrected"], f"{where}, corrected")
        return self._declare("numeric", number, title, decimal(printed, f"{where}, printed"), derived, **options)

    def reference(self, number: str, title: str, *, printed: str, meant: str, **options: Unpack[Options]) -> Claim:
        """Declare what a reference within the paper, such as "2.3.3", must point to; a wrong one is a misprint."""
        where = f"claim {self.paper}:{number}"
        right = reference(meant, f"{where}, meant")
        if printed != meant:
            options = {"expect": "misprint", "corrected": right, **options}
        return self._declare("reference", number, title, reference(printed, f"{where}, printed"), right, **options)

    def definition(self, number: str, title: str, *, printed: Any, **options: Unpack[Options]) -> Claim:
        """Declare a notation."""
        return self._declare("definition", number, title, printed, None, **options)

    def kernel(
        self, qualified_name: str, summary: str, *, jacobian: bool = False, **parts: Unpack[KernelParts]
    ) -> Kernel:
        """Declare a function to be generated, and with `jacobian` another one for its derivatives.

        See `Kernel` for the parts.
        """
        kernel = declared_kernel(self.paper, self.number, qualified_name, summary, **parts)
        self.kernels.append(kernel)
        if jacobian:
            about = f"Derivatives of the entries of `{kernel.name}`, row by row, by those of its arguments, in order."
            slopes = jacobian_parts(kernel)
            self.kernels.append(declared_kernel(self.paper, self.number, f"{qualified_name}_jacobian", about, **slopes))
        return kernel

    def driver(self, qualified_name: str, function: Callable[..., Any]) -> None:
        """Declare a hand-written function that calls generated ones and is shipped with them."""
        self.drivers.append(declared_driver(qualified_name, function))

    def _declare(self, kind: Kind, number: str, title: str, printed: Any, derived: Any, **options: Any) -> Claim:
        if any(claim.number == number for claim in self.claims):
            raise DeclarationError(f"claim {self.paper}:{number}: expected a number of its own, it is declared twice")
        source = calling(depth=2)
        derived = provenance.declare((self.paper, number), derived)
        claim = declared(self.paper, self.number, number, title, kind, printed, derived, source=source, **options)
        self.claims.append(claim)
        return claim
