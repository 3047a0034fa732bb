"""Files that are damaged in any way give an error that names the place, or verdicts: never a traceback."""

import json
import random

import pytest
from click.testing import CliRunner
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from algebroproj_sym.cli import main
from algebroproj_sym.declaring import MalformedFileError, identities

VALID = [
    {"name": "square", "lhs": "(a + b)^2", "rhs": "a^2 + 2*a*b + b^2", "expected": "proved", "variables": ["a", "b"]},
    {"lhs": "x^3", "rhs": "x", "constraints": ["x^2 = 1"], "nonzero": ["x"], "witness": {"x": "1"}, "source": "mine"},
    {"lhs": "[[x, 0], [0, y]]", "rhs": "[[x, 0], [0, x/y]]", "expected": "refuted"},
]
TEXT = json.dumps(VALID, indent=1).encode()
OTHERS = [
    None,
    True,
    0,
    -1.5,
    1e400,
    "",
    "x",
    "\x1b[31m",
    "\ud800",
    "x" * 300_000,
    [],
    {},
    [[]],
    [None],
    {"x": 1},
    {"": ""},
]


@pytest.fixture(scope="module")
def check(tmp_path_factory):
    folder = tmp_path_factory.mktemp("files")

    def run(content):
        path = folder / "mine.json"
        path.write_bytes(content)
        result = CliRunner().invoke(main, ["check", str(path), "--seconds", "5"])
        assert result.exit_code in (0, 1, 2), result.exception
        assert result.exception is None or isinstance(result.exception, SystemExit)
        assert "Traceback" not in result.output
        if result.exit_code == 2:
            assert str(path) in result.output
            assert len(result.output) < 2_000
        return result

    return run


def message(path):
    """Return why a file is refused, or nothing."""
    try:
        return identities(path) and ""
    except MalformedFileError as error:
        return str(error)


def test_the_valid_file(check):
    assert check(TEXT).exit_code == 0


BROKEN = {
    "empty": b"",
    "blank": b" \n",
    "no list": b"{}",
    "an empty list": b"[]",
    "null": b"null",
    "a number": b"17",
    "not a number": b"NaN",
    "not a number inside": b'[{"lhs": "x", "rhs": "x", "tolerance": NaN}]',
    "infinity": b'[{"lhs": "x", "rhs": "x", "tolerance": -Infinity}]',
    "cut off": TEXT[:100],
    "a long integer": b"[" + b"7" * 5_000 + b"]",
    "deeply nested": b"[" * 100_000,
    "deeply nested objects": b'{"a":' * 100_000,
    "not UTF-8": TEXT.replace(b"square", b"\xff\xfe"),
    "UTF-16": TEXT.decode().encode("utf-16"),
    "a byte order mark": b"\xef\xbb\xbf" + TEXT,
    "a key twice": b'[{"lhs": "x", "lhs": "y", "rhs": "x"}]',
    "a name twice in a witness": b'[{"lhs": "x", "rhs": "x", "witness": {"x": "1", "x": "2"}}]',
    "half a surrogate": b'[{"lhs": "x", "rhs": "x", "name": "\\ud800"}]',
    "half a surrogate as a side": b'[{"lhs": "\\ud800", "rhs": "x"}]',
    "half a surrogate in a witness": b'[{"lhs": "x", "rhs": "x", "witness": {"\\ud800": "1"}}]',
    "another witness": b'[{"lhs": "x", "rhs": "x", "witness": {"y": "1"}}]',
    "a witness that is no number": b'[{"lhs": "x", "rhs": "x", "witness": {"x": "y"}}]',
    "a witness that is a matrix": b'[{"lhs": "x", "rhs": "x", "witness": {"x": "[[1]]"}}]',
    "a witness that is a number": b'[{"lhs": "x", "rhs": "x", "witness": {"x": 1}}]',
    "a matrix that is not zero": b'[{"lhs": "x", "rhs": "x", "nonzero": ["[[x]]"]}]',
    "an equation that is not zero": b'[{"lhs": "x", "rhs": "x", "nonzero": ["x = y"]}]',
    "zero bytes": TEXT.replace(b"square", b"\x00"),
    "too large": b"[" + b" " * 20_000_001 + b"]",
}


@pytest.mark.usefixtures("decided_here")
@pytest.mark.parametrize("content", BROKEN.values(), ids=BROKEN)
def test_a_broken_file_is_wrong_usage(check, content):
    assert check(content).exit_code == 2


def test_a_folder_and_a_missing_file_are_wrong_usage(tmp_path):
    (tmp_path / "folder.json").mkdir()
    for name in ("folder.json", "missing.json"):
        result = CliRunner().invoke(main, ["check", str(tmp_path / name)])
        assert result.exit_code == 2
        assert name in result.output


@given(st.data())
@settings(
    max_examples=5 * settings.default.max_examples,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
def test_damaged_bytes_are_read_or_refused(tmp_path, data):
    content = bytearray(TEXT)
    for _ in range(data.draw(st.integers(1, 4))):
        place = data.draw(st.integers(0, len(content) - 1))
        end = place + data.draw(st.integers(0, 12))
        content[place:end] = data.draw(
            st.binary(max_size=6) | st.sampled_from([b'"', b"{", b"]", b"\\u", b"NaN", b"9" * 60])
        )
    path = tmp_path / "mine.json"
    path.write_bytes(bytes(content))
    said = message(path)
    assert said == "" or str(path) in said
    assert len(said) < 2_000


def damaged(generator):
    """Return the valid items with one value somewhere replaced, removed, or under another key."""
    items = json.loads(TEXT)
    item = generator.choice(items)
    key = generator.choice([*item, "lhs", "rhs", "constraints", "nonzero", "witness", "name", "expected", "variables"])
    match generator.randrange(4):
        case 0:
            item[key] = generator.choice(OTHERS)
        case 1:
            item.pop(key, None)
        case 2:
            item[key + "s"] = item.pop(key, None)
        case 3 if isinstance(item.get(key), list) and item[key]:
            item[key][generator.randrange(len(item[key]))] = generator.choice(OTHERS)
        case _:
            text = str(item.get(key, ""))
            place = generator.randrange(len(text) + 1)
            item[key] = (
                text[:place] + generator.choice(["(", "^", "/0", "=", "x'", "10^10^10", "\u202e", ";"]) + text[place:]
            )
    return json.dumps(items).encode()


@pytest.mark.whole
def test_damaged_values_are_decided_or_refused(check):
    generator = random.Random(7)
    statuses = {check(damaged(generator)).exit_code for _ in range(40)}
    assert {0, 2} <= statuses <= {0, 1, 2}
