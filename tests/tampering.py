"""A record with one place changed: a sign, a number, a symbol or an operation."""

import copy
import re

from hypothesis import assume
from hypothesis import strategies as st

SWAPPED = {"+": ["-"], " - ": [" + "], "*": ["/", "+"], "/": ["*"]}
TOKEN = re.compile(r"(?<![\w.])\d+(?!\w)|\+|(?<=\S) - |\*(?!\*)(?<!\*\*)|/|(?<!\w)[A-Za-z_]\w*")


def leaves(node, path=()):
    """The paths of the texts and numbers in a record."""
    if isinstance(node, dict):
        for key, value in node.items():
            yield from leaves(value, (*path, key))
    elif isinstance(node, list):
        for place, value in enumerate(node):
            yield from leaves(value, (*path, place))
    elif isinstance(node, int | str) and not isinstance(node, bool):
        yield path


def at_path(record, path):
    for key in path:
        record = record[key]
    return record


def changes_of(value, names):
    """The texts, or numbers, that differ from a text, or number, in one place."""
    if isinstance(value, int):
        return [value + 1, value - 1]
    found = []
    for match in TOKEN.finditer(value):
        token = match.group()
        if token.isdecimal():
            news = [str(int(token) + 1).zfill(len(token))]
        else:
            news = SWAPPED.get(token) or [name for name in names if name != token][:2]
        found += [value[: match.start()] + new + value[match.end() :] for new in news]
    return found


def opposite(value):
    return f"-{value}".replace("--", "") if re.fullmatch(r"-?[\d/.]+", value) else f"-({value})"


def tampered(data, record, paths, names, *, opposites):
    """A copy of a record with one of the places changed, and its path; a text may become its opposite, too."""
    path = data.draw(st.sampled_from(paths))
    value = at_path(record, path)
    options = changes_of(value, sorted(names)) + ([opposite(value)] if opposites and isinstance(value, str) else [])
    options = [new for new in options if new != value]
    assume(options)
    changed = copy.deepcopy(record)
    at_path(changed, path[:-1])[path[-1]] = data.draw(st.sampled_from(options))
    return changed, path
