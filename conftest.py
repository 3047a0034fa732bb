"""What a run of the tests includes: by default what is quick, with ``--whole`` everything, as in CI."""

from functools import cache
from importlib.metadata import PackageNotFoundError, distribution, requires
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings
from packaging.requirements import Requirement

from algebroproj_sym.declaring import kernels
from algebroproj_sym.generating import lower

PROJECT = "algebroproj-sym"
# The extra that the modules of a file or folder import.  A test that needs one is marked with `extra`.
IMPORTS = {
    "algebroproj_sym/study": "study",
    "derivations/studies": "study",
    "tests/test_browser.py": "dev",
    "tests/test_docs.py": "docs",
    "tests/test_notebooks.py": "report",
    "tests/test_site.py": "report",
    "tests/test_study_": "study",
}
REPEATABLE = settings(derandomize=True, deadline=None, print_blob=True, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("quick", REPEATABLE, max_examples=20)
settings.register_profile("whole", REPEATABLE)


def pytest_addoption(parser):
    parser.addoption("--whole", action="store_true", help="Run every test and every example; no extra may be absent.")
    parser.addoption("--site", type=Path, help="Check every page of this site in the browser, not of a small one.")


def pytest_configure(config):
    config.addinivalue_line("markers", "whole: what takes long, such as a build; it runs with --whole.")
    config.addinivalue_line("markers", "extra(name): the test needs this extra.")
    settings.load_profile("whole" if config.getoption("whole") else "quick")


def pytest_collection_modifyitems(config, items):
    if not config.getoption("whole"):
        config.hook.pytest_deselected(items=[item for item in items if item.get_closest_marker("whole")])
        items[:] = [item for item in items if not item.get_closest_marker("whole")]


@pytest.hookimpl(tryfirst=True)
def pytest_make_collect_report(collector):
    if not isinstance(collector, pytest.File):
        return None
    extras = {extra for beginning, extra in IMPORTS.items() if collector.nodeid.startswith(beginning)}
    reason = next(filter(None, map(absent, sorted(extras))), None)
    if reason is None or collector.config.getoption("whole"):
        return None
    return pytest.CollectReport(collector.nodeid, "skipped", (collector.nodeid, 0, reason), [])


def pytest_runtest_setup(item):
    for mark in item.iter_markers("extra"):
        reason = absent(*mark.args)
        if reason and not item.config.getoption("whole"):
            pytest.skip(reason)


@cache
def absent(extra):
    """Return a sentence on what is not installed of what an extra requires, or None."""
    names = sorted(name for name in required(extra) if not is_installed(name))
    return f"needs the extra {extra}, of which {names[0]} is not installed" if names else None


def required(extra):
    """Return the names of the distributions that an extra requires and the core does not."""
    every = [Requirement(text) for text in requires(PROJECT)]
    for requirement in every:
        if requirement.marker and requirement.marker.evaluate({"extra": extra}):
            if requirement.name == PROJECT:
                yield from (name for inner in requirement.extras for name in required(inner))
            else:
                yield requirement.name


def is_installed(name):
    try:
        return distribution(name) is not None
    except PackageNotFoundError:
        return False


@pytest.fixture(scope="session")
def repository() -> Path:
    return Path(__file__).resolve().parent


@pytest.fixture(scope="session")
def lowered():
    """Return a function from the name of a kernel of the papers to its program; each is lowered once."""
    declared = {kernel.qualified_name: kernel for kernel in kernels()}
    return cache(lambda name: lower(declared[name]))
