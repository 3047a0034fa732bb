"""All that is asked of a generated function."""

from __future__ import annotations

from dataclasses import dataclass
from types import ModuleType
from typing import Any

from algebroproj_sym.expressions import Scalar
from algebroproj_sym.generating import Lowered
from algebroproj_sym.verifying.accuracy import BOUND, Accuracy, accuracy, as_record
from algebroproj_sym.verifying.proof_of_source import source_is_proved
from algebroproj_sym.verifying.singular_input import silent_factors


@dataclass(frozen=True)
class Verification:
    """The three things that are asked of a generated function.

    Attributes
    ----------
    accuracy : Accuracy
        Its errors on stratified samples.
    source_proved : bool
        Whether its source, run on rational functions, gives the derivation.
    silent : tuple of sympy.Expr
        Factors on whose zeros it stays finite.
    """

    accuracy: Accuracy
    source_proved: bool
    silent: tuple[Scalar, ...]

    @property
    def passed(self) -> bool:
        """Whether all three are as they must be."""
        return self.source_proved and not self.silent and self.accuracy.within_bound


def verify(lowered: Lowered, package: ModuleType, size: int, engine: str = "flint") -> Verification:
    """Verify the generated function of a kernel.

    Parameters
    ----------
    lowered : Lowered
        The kernel and its program.
    package : module
        Where the generated function is.
    size : int
        Samples in each stratum.
    engine : {"flint", "sympy"}
        The polynomial arithmetic for the proof of the source.
    """
    return Verification(
        accuracy=accuracy(lowered, package, size),
        source_proved=source_is_proved(lowered.kernel, package, engine),
        silent=silent_factors(lowered, package),
    )


def verification_record(verifications: list[Verification]) -> dict[str, Any]:
    """Return the figures of all functions as plain data."""
    functions = [
        {
            **as_record(v.accuracy),
            "source_proved": v.source_proved,
            "silent_factors": [str(factor) for factor in v.silent],
            "passed": v.passed,
        }
        for v in verifications
    ]
    return {"schema": 1, "bound": BOUND, "functions": functions}
