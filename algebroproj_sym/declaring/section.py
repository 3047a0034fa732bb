"""Sections: a derivation module declares its claims and kernels through one of these."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Unpack

from algebroproj_sym.declaring.claim import Claim, DeclarationError
from algebroproj_sym.declaring.declaration import declared
from algebroproj_sym.declaring.driver import Driver, declared_driver
from algebroproj_sym.declaring.jacobian import jacobian_parts
from algebroproj_sym.declaring.kernel import Kernel, KernelParts, declared_kernel
from algebroproj_sym.declaring.kind import QUOTED, Kind
from algebroproj_sym.declaring.kinds import KINDS
from algebroproj_sym.declaring.source import calling
from algebroproj_sym.expressions import provenance


class Section:
    """A section of a paper, which collects the claims and kernels in the order of their declaration.

    Each kind of claims has a method, such as `identity`, `rank` and `limit`.  It takes the number and the title of the
    claim, what is ``printed`` and what is ``derived``, and `Options`.  Without ``printed``, the quote of the number in
    the files of quotes beside the module is read.

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

    def kernel(
        self, qualified_name: str, summary: str, *, jacobian: bool = False, **parts: Unpack[KernelParts]
    ) -> Kernel:
        """Declare a function to be generated, and with `jacobian` another one for its derivatives.

        See `Kernel` for the parts.
        """
        kernel = declared_kernel(self.paper, self.number, qualified_name, summary, **parts)
        self.kernels.append(kernel)
        if jacobian:
            about = f"Derivatives of `{kernel.name}`: rows are entries of the result, columns of the arguments."
            slopes = jacobian_parts(kernel)
            self.kernels.append(declared_kernel(self.paper, self.number, f"{qualified_name}_jacobian", about, **slopes))
        return kernel

    def driver(self, qualified_name: str, function: Callable[..., Any]) -> None:
        """Declare a hand-written function that calls generated ones and is shipped with them."""
        self.drivers.append(declared_driver(qualified_name, function))

    def declare(self, kind: Kind, number: str, title: str, printed: Any, derived: Any, **options: Any) -> Claim:
        """Declare a claim of a kind, for the caller of the caller."""
        if any(claim.number == number for claim in self.claims):
            raise DeclarationError(f"claim {self.paper}:{number}: expected each number once, got this one twice")
        source = calling(depth=2)
        if printed is QUOTED:
            try:
                printed = kind.transcribe(source.folder, self.number, number, derived)
            except DeclarationError as error:
                raise DeclarationError(f"claim {self.paper}:{number}, printed: {error}") from error
        derived = provenance.declare((self.paper, number), derived)
        claim = declared(self.paper, self.number, number, title, kind.name, printed, derived, source=source, **options)
        self.claims.append(claim)
        return claim

    if TYPE_CHECKING:

        def __getattr__(self, method: str) -> Callable[..., Claim]: ...


for _kind in KINDS.values():
    setattr(Section, _kind.declare.__name__, _kind.declare)
