"""Published statements with real functions, most beside a false one: verdicts, and evidence that is replayed."""

import json

import pytest
from real_corpora import fails_somewhere, items, names, question

from algebroproj_sym.proving.reals import decided
from algebroproj_sym.replaying.reals import require_real
from algebroproj_sym.replaying.reals.statement import statement_of

# How many are true, false, and not decided.
LISTED = {
    "functions": (290, 290, 0),
    "inequalities": (148, 138, 3),
    "elementary": (275, 275, 1),
    "derivatives": (72, 72, 0),
    "integrals": (40, 40, 0),
    "expansions": (38, 38, 0),
}
ITEMS = [(name, place, item) for name in LISTED for place, item in enumerate(items(name))]


def is_quick(name, place, item):
    return "slow" not in item and (place % 20 == 0 or (name == "functions" and place % 10 == 1))


CASES = [
    pytest.param(item, id=f"{name}: {item['name']}", marks=() if is_quick(name, place, item) else pytest.mark.whole)
    for name, place, item in ITEMS
]


@pytest.mark.parametrize("item", CASES)
def test_every_verdict_is_the_declared_one_or_open_where_that_is_listed(item):
    found = decided(question(item))
    assert found["verdict"] == item.get("found", item["expected"])
    if found["verdict"] != "open":
        require_real(json.loads(json.dumps(found)))


@pytest.mark.parametrize("name", LISTED)
def test_nearly_all_are_decided(name):
    expected = [item["expected"] for item in items(name)]
    found = [item["found"] for item in items(name) if "found" in item]
    assert (expected.count("proved"), expected.count("refuted"), found.count("open")) == LISTED[name]
    assert len(expected) == sum(LISTED[name][:2])
    assert {*found} <= {"open"}


STATED = [item for name, _, item in ITEMS if name in ("functions", "inequalities")]
TRUE = [item for item in STATED if item["expected"] == "proved"]


@pytest.mark.sampled(4)
@pytest.mark.parametrize("item", TRUE[::6], ids=names(TRUE[::6]))
def test_the_oracle_agrees_with_what_is_true(item):
    assert not fails_somewhere(statement_of(question(item)))


@pytest.mark.whole
def test_the_oracle_sees_what_is_false():
    seen = [fails_somewhere(statement_of(question(item))) for item in STATED if item["expected"] == "refuted"]
    assert sum(seen) > 0.95 * len(seen)
