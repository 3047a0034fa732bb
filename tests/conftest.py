from functools import cache
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from algebroproj_sym.declaring import kernels
from algebroproj_sym.generating import lower

settings.register_profile(
    "repeatable", derandomize=True, deadline=None, print_blob=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("repeatable")


def pytest_addoption(parser):
    parser.addoption("--site", type=Path, help="Check every page of this site in the browser, not of a small one.")


@pytest.fixture(scope="session")
def repository() -> Path:
    return Path(__file__).resolve().parent.parent


@pytest.fixture(scope="session")
def lowered():
    """Return a function from the name of a kernel of the papers to its program; each is lowered once."""
    declared = {kernel.qualified_name: kernel for kernel in kernels()}
    return cache(lambda name: lower(declared[name]))
