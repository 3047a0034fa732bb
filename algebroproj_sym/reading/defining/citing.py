"""The equations that words name: those on which one rests, and those from which it is set apart."""

import re

_APART = re.compile(
    r"\b(?:unlike|contrary to|in contrast (?:to|with)|as opposed to|instead of|rather than|other than|"
    r"different(?:ly)? from|except(?: for)?|but not)\b[^.,;$]{0,40}",
    re.IGNORECASE,
)
"""Words that name an equation from which nothing follows."""
_CITED = re.compile(
    r"\\(?:eqref|ref|autoref|cref|Cref|labelcref)\s*\{([^{}]*)\}|\{(?:eq|numref)\}`([^`]*)`|\((\d+(?:\.\d+)*[a-z]?)\)"
)


def cited_in(words: str) -> frozenset[str]:
    r"""Return the labels and numbers of equations that words name.

    Examples
    --------
    >>> sorted(cited_in(r"Put (3) and Eq.~\eqref{eq:area} into \ref{a,b}"))
    ['3', 'a', 'b', 'eq:area']
    """
    return _names_in(_APART.sub(" ", words))


def apart_in(words: str) -> frozenset[str]:
    """Return likewise those of which words say that it is not so: "unlike in (3)"."""
    return _names_in(" ".join(each[0] for each in _APART.finditer(words)))


def _names_in(words: str) -> frozenset[str]:
    found = (match[1] or match[2] or match[3] for match in _CITED.finditer(words))
    return frozenset(name.strip() for names in found for name in names.split(","))
