"""The equations that words name: those on which one rests, and those from which it is set apart."""

import re

from algebroproj_sym.reading.devices import heard

_APART = heard(r"\b<unlike>\b[^.,;$]{0,40}")
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
