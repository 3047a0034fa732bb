"""Lines of text for a terminal.

Text from files and derivations may have characters that a terminal obeys or hides: escape sequences, or marks that
change the direction of writing.  Every output passes through `visible`, which writes them as JSON does.
"""

import json
import re
from typing import Any, Literal

import click

Verbosity = Literal["quiet", "normal", "verbose"]

_HIDDEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\xad\u0600-\u0605\u061c\u06dd\u070f\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f"
    "\ud800-\udfff\ufeff\ufff9-\ufffb\U000e0000-\U000e007f]"
)


def visible(text: str, *, line: bool = False) -> str:
    r"""Return a text with JSON escapes for the characters that a terminal obeys or hides; on one line if `line`.

    Examples
    --------
    >>> print(visible("a\x1b[31m b\u202e"))
    a\u001b[31m b\u202e
    >>> print(visible("two\nlines", line=True))
    two\nlines
    """
    shown = _HIDDEN.sub(lambda found: json.dumps(found.group())[1:-1], text)
    return shown.replace("\n", "\\n").replace("\t", "\\t") if line else shown


def echo(text: str, *, err: bool = False) -> None:
    """Write a text."""
    click.echo(visible(text), err=err)


def echo_json(record: Any) -> None:
    """Write plain data as JSON on standard output."""
    echo(json.dumps(record, indent=1, ensure_ascii=False))


def verbosity() -> Verbosity:
    """Return how much the running command says."""
    context = click.get_current_context(silent=True)
    chosen: Verbosity | None = context.find_root().obj if context else None
    return chosen or "normal"
