"""The table of the words that are heard: what it says of itself, and what the page on judging lists of it."""

import re

import pytest

from algebroproj_sym.reading.devices import DEVICES, EFFECTS, heard

PLAIN = re.compile(r"([a-z][a-z' -]*)(\\w[*+]|s\?)?")


def phrases(device):
    """Return the phrases of a row: what stands between bars outside of brackets."""
    found, depth = [""], 0
    for each in re.findall(r"\\.|\[(?:\\.|[^\]])*\]|.", device.words):
        depth += {"(": 1, ")": -1}.get(each, 0)
        if each == "|" and depth == 0:
            found.append("")
        else:
            found[-1] += each
    return found


def listed():
    """Return the lines of the page: each effect with an example of each row, and its plain words."""
    lines = ["| what the words do | for example | words |", "|---|---|---|"]
    for name, meaning in EFFECTS.items():
        rows = [each for each in DEVICES if name in each.effects]
        plain = [match for row in rows for each in phrases(row) if (match := PLAIN.fullmatch(each))]
        words = ", ".join(sorted(match[1] + ("..." if (match[2] or "").startswith("\\") else "") for match in plain))
        lines.append(f"| {meaning} | {'; '.join(f'*{row.example}*' for row in rows)} | {words} |")
    return "\n".join(lines)


def test_the_page_lists_what_is_heard(repository):
    assert listed() in (repository / "docs" / "explanation" / "reading.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("device", DEVICES, ids=lambda each: each.example)
def test_an_example_has_a_phrase_of_its_row(device):
    assert all(heard(f"<{each}>").search(device.example) for each in device.effects)
    assert heard(device.words).search(device.example)


def test_no_phrase_stands_twice():
    place = next(place for place, each in enumerate(DEVICES) if each.effects == ("neutral",))
    found = [phrase for each in DEVICES[:place] for phrase in phrases(each)]
    assert sorted({each for each in found if found.count(each) > 1}) == []


def test_every_effect_is_asked_for_and_explained(repository):
    code = "".join(each.read_text() for each in (repository / "algebroproj_sym" / "reading").rglob("*.py"))
    rows = "".join(each.words for each in DEVICES)
    asked = {name for names in re.findall(r"<([a-z -]+)>", code + rows) for name in names.split()}
    assert {each for row in DEVICES for each in row.effects} == EFFECTS.keys()
    assert [each for each in EFFECTS if each not in asked and not each.startswith(("is-", "begins-"))] == []
