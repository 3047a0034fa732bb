"""The pytest plugin: ``pytest --claims`` makes each claim of the derivation modules a test.

    pytest derivations/ --claims
    pytest derivations/ --claims -k "misprint and 1.3"
    pytest derivations/mypaper/s1_lines.py::1.3.8 --claims

A test is named by the number of its claim, and `-k` finds it also by paper, kind, declared verdict and title.  Without
``--claims`` the plugin does nothing, and nothing of the project is imported.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from _pytest._code.code import ExceptionInfo, TerminalRepr

    from algebroproj_sym.declaring import Claim


class ClaimFailure(AssertionError):  # noqa: N818 - a failed test, not an error
    """A claim is not as declared."""


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the options of the plugin."""
    group = parser.getgroup("claims", "claims of derivation modules")
    group.addoption("--claims", action="store_true", help="collect the claims of derivation modules as tests")
    group.addoption(
        "--claims-engine",
        choices=("flint", "sympy"),
        default="flint",
        help="polynomial arithmetic of the proofs (default: flint)",
    )


@pytest.hookimpl(wrapper=True)
def pytest_collect_file(
    file_path: Path, parent: pytest.Collector
) -> Generator[None, list[pytest.Collector], list[pytest.Collector]]:
    """Collect a derivation module as claims alone: importing it as a test module too would take its time twice."""
    collectors = yield
    if not parent.config.getoption("claims") or file_path.suffix != ".py":
        return collectors
    from algebroproj_sym.papers import makes_section

    return [DerivationModule.from_parent(parent, path=file_path)] if makes_section(file_path) else collectors


class DerivationModule(pytest.File):
    """A derivation module, a collection of claims."""

    def collect(self) -> Iterator[ClaimItem]:
        """Import the module and return its claims, in the order of their declaration.

        Numbers and references are held against all modules of the folder; a neighbour that cannot be imported is an
        error of its own.
        """
        from algebroproj_sym.declaring import BrokenModuleError, DeclarationError, UnknownSelectorError, derivation_at

        try:
            found = derivation_at(self.path)
        except BrokenModuleError as error:
            if error.path == self.path.resolve():
                raise self.CollectError(str(error)) from None
            found = derivation_at(self.path, alone=True)
        except (DeclarationError, UnknownSelectorError) as error:
            raise self.CollectError(f"{self.path}: {error}") from None
        for claim in found[0].section.claims:
            yield ClaimItem.from_parent(self, name=claim.number, claim=claim)


class ClaimItem(pytest.Item):
    """A claim, which passes if its verdict is the declared one."""

    def __init__(self, *, claim: Claim, **arguments: Any) -> None:
        super().__init__(**arguments)
        self.claim = claim
        self.extra_keyword_matches |= {claim.paper, claim.kind, claim.expected, claim.title}

    def runtest(self) -> None:
        """Judge the claim."""
        from algebroproj_sym.declaring import judge
        from algebroproj_sym.reporting.explaining import failure_text

        judgement = judge(self.claim, self.config.getoption("claims_engine"))
        self.user_properties += [("verdict", judgement.verdict), ("declared", self.claim.expected)]
        if not judgement.as_declared:
            raise ClaimFailure(failure_text(judgement))

    def repr_failure(self, excinfo: ExceptionInfo[BaseException], style: Any = None) -> str | TerminalRepr:
        """Return the two forms and where they differ; for an unexpected error, its traceback."""
        if isinstance(excinfo.value, ClaimFailure):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        """Return the file and the heading of a failure."""
        return self.path, None, f"({self.claim.number}) {self.claim.title}"
