"""Published statements with real functions, each beside a false one: verdicts, and evidence that is replayed."""

import json
from pathlib import Path

import pytest

from algebroproj_sym.proving.reals import decided
from algebroproj_sym.replaying.reals import require_real

ITEMS = json.loads((Path(__file__).resolve().parent / "corpus" / "elementary.json").read_text(encoding="utf-8"))
CASES = [
    pytest.param(item, id=item["name"], marks=() if place % 12 < 2 and "slow" not in item else pytest.mark.whole)
    for place, item in enumerate(ITEMS)
]


@pytest.mark.parametrize("item", CASES)
def test_every_verdict_is_the_declared_one_or_open_where_that_is_listed(item):
    question = {key: item[key] for key in ("lhs", "rhs", "relation", "assumptions")}
    found = decided({**question, "constraints": [], "nonzero": []})
    assert found["verdict"] in {item["expected"], item.get("found", item["expected"])}
    if found["verdict"] != "open":
        require_real(json.loads(json.dumps(found)))


def test_most_of_what_is_true_is_proved_and_nearly_all_that_is_false_refuted():
    assert [item["expected"] for item in ITEMS] == ["proved", "refuted"] * (len(ITEMS) // 2)
    assert not {item["found"] for item in ITEMS if "found" in item} - {"open"}
    for expected, share in {"proved": 0.95, "refuted": 0.98}.items():
        items = [item for item in ITEMS if item["expected"] == expected]
        assert len(items) >= 250
        assert sum("found" not in item for item in items) >= share * len(items)
