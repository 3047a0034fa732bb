"""Which letters words give another meaning from there on: "from here on $b$ is half of it", "$k$ is used for"."""

from algebroproj_sym.reading.defining.phrases import symbols_in_list
from algebroproj_sym.reading.devices import heard

_RENAMES = heard(r"\b<renames>|\$([^$=]*)\$ <renames-behind>")


def renamed_in(words: str) -> frozenset[str]:
    """Return the letters that words give another meaning.

    Examples
    --------
    >>> [sorted(renamed_in(each)) for each in ("Its error is also called $h$.", "From here on $b$ is half of it.")]
    [['h'], ['b']]
    """
    found = [each for match in _RENAMES.finditer(" ".join(words.split())) for each in match.groups() if each]
    return frozenset(symbol for each in found for symbol in symbols_in_list(each))


def letters_change(words: str) -> bool:
    """Whether words say that letters have other meanings, and do not name them.

    Examples
    --------
    >>> letters_change("Part II swaps the two names."), letters_change("We swap the two sides.")
    (True, False)
    """
    return heard(r"\b<letters-change>\b").search(" ".join(words.split())) is not None


def gives_its_name_away(words: str) -> bool:
    """Whether words between two displays say that another thing has the letter of the first one, and do not name it.

    Examples
    --------
    >>> gives_its_name_away("The same letter denotes its estimate."), gives_its_name_away("It has the same value.")
    (True, False)
    """
    return heard(r"\b<same-letter>\b").search(words) is not None
