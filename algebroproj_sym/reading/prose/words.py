"""What the words beside an equation say of it: that it follows, or that it may be of a case or of another thing."""

import re
from collections.abc import Collection
from dataclasses import dataclass
from functools import cached_property

from algebroproj_sym.reading.documents.displays import Display
from algebroproj_sym.reading.documents.statements import Statement
from algebroproj_sym.reading.lexing.names import bare_name
from algebroproj_sym.reading.prose.contexts import without_steps
from algebroproj_sym.reading.prose.devices import heard, says
from algebroproj_sym.reading.prose.phrases import symbols_in_list, symbols_of
from algebroproj_sym.reading.prose.sentences import (
    FORMULA,
    IN_THIS_CASE,
    last_sentence,
    main_clause,
    sentences_of,
    strange_word,
    without_formulas,
    without_laws,
    words_of,
)

NEAR = 250
"""How many characters beside a formula are searched for words about a case."""
CASES = heard(r"\b<case>\b|\b(?:for|with|at|in which|where|such that)\s+\$[^$]*=")
CONDITIONAL = heard(r"\b<condition>\b")
_DENIED = heard(r"\b<rejects denies>\b|\A\W*<unreal>\b|\b<wanted>(?: that)?\W*$")
_OF_IT = heard(r"\s*(?:(?:but|however|yet|and),? )?<of-it>\b")
_ONLY_SOMETIMES = heard(r"\b<condition partly>\b")
_FORM = re.compile(r"\b(?:assum\w+|suppos\w+)\b.*\b(?:form|given by|as)\W*$", re.IGNORECASE | re.DOTALL)
"""What is assumed to have a form is given by it."""
_NO_CASE = re.compile(
    r"\b(?:if|when) (?:we|one) (?:now |then )?(?:let|define|denote|introduce|write|rewrite|express)\b"
    r"|\b(?:as|is|are) (?:an? )?(?:special|particular|limiting) cases? of\b",
    re.IGNORECASE,
)
"""Words that give a name, or say what something is a case of: what they speak of is no condition."""
_ASIDE = re.compile(r"\((?:[^()$]|\$[^$]*\$)*\)")
"""A remark in brackets, which says nothing of the equation behind it."""
HENCE = heard(r"\b<hence>\b")
DEFINES = heard(r"(?:\b<defines>|(?:^|[.,;])\s*in which|,)\W*$")
_FORBIDS = re.compile(r"\b(?:not|never|cannot|don['’]t)(?: \w+){0,2}\W*$", re.IGNORECASE)
SAYS = heard(r"(?:\b<says>|:)\W*$")

ASKS = heard(r"\W*<asks>\b")


@dataclass(frozen=True)
class Beside:
    """The words beside an equation."""

    sentence: str
    """Its own sentence, up to it."""
    before: str
    behind: str
    """The words near it, before it, and behind it up to the full stop."""
    condition: str
    """The words in its display."""
    implied: bool
    """Whether an arrow leads to it."""
    part: int
    """How many headings come before it."""
    place: int
    """Where its display begins, in characters."""
    ends: bool
    """Whether its sentence ends before the next equation."""

    def case(self, given: Collection[str] = ()) -> str:
        """Return a word by which the equation may be of a case; empty for none.

        "Let $s = a + b$" is none if the letter is given by it.
        """
        words = f"{self.before} {self.sentence} {self.condition} {self.behind}"
        bare = {bare_name(each) for each in given}
        kept = lambda match: "" if not match[1] or bare_name(match[1]) in bare else match[0]  # noqa: E731
        return _case_in(_LET.sub(kept, words))

    @property
    def case_of_premise(self) -> str:
        """Return a word by which the equation may serve a case alone; empty for none.

        It stands in its own sentence, or in the one before it where the sentence goes on from it.  A sentence near it
        that supposes something, or neglects it, speaks of what stands behind it as well: "We neglect the wind".
        """
        *above, _ = sentences_of(self.before)
        own = f"{self.sentence} {self.condition} {self.behind}"
        if above and _LEANS.match(without_formulas(self.sentence)):
            own = f"{above[-1]} {own}"
        found = next(filter(None, map(_CARRIES.search, above)), None)
        return _case_in(own) or (found.group() if found else "")

    @property
    def case_within(self) -> str:
        """Likewise, in the words that do not speak of the whole display."""
        return _case_in(f"{self.condition} {self.behind}")

    @property
    def case_of_sentence(self) -> str:
        """Return a word of its own sentence by which the equation gives no letter; empty for none.

        It may be a condition, or hold but roughly.  What a letter is in a case gives the letter, if the case stands in
        a clause of its own: "If the orbit is closed, its period is".
        """
        behind = "" if _begins_anew(self.behind) else self.behind
        clause = main_clause(self.sentence)
        found = heard(r"\b<roughly>\b").search(f"{self.sentence} {self.condition} {behind}")
        found = found or _ONLY_SOMETIMES.search(f"{'' if _FORM.search(clause) else clause} {self.condition} {behind}")
        return found.group() if found else ""

    @property
    def is_condition(self) -> bool:
        """Whether the equation is the condition itself of which its sentence speaks: "If" stands in its own clause."""
        clause = _NO_CASE.sub(" ", IN_THIS_CASE.sub(" then ", main_clause(_ASIDE.sub(" ", self.sentence))))
        return _FORM.search(clause) is None and _ONLY_SOMETIMES.search(clause) is not None

    @property
    def is_supposed(self) -> bool:
        """Whether a word of a condition stands right before it, or almost: "if, say,"."""
        words = FORMULA.sub(" ", self.sentence).split()[-3:]
        return _ONLY_SOMETIMES.search(" ".join(words)) is not None

    @property
    def names(self) -> bool:
        """Whether its own sentence says what something is or stands for."""
        return says(r"\b<names>\b|\b<names-last>\W*$", self.sentence)

    @property
    def tells(self) -> bool:
        """Whether its own sentence ends by saying what something is, and speaks of no equation or condition."""
        own = without_formulas(self.sentence)
        return says(r"\b<tells>\W*$", own) and not (
            _EQUATIONS.search(own) or says(r"\b<laws>\b", own) or self.case_of_sentence
        )

    @property
    def defines(self) -> bool:
        """Whether its last clause says that it is a definition, whatever was said of its letter before."""
        return says(r"\b<defined>\b", main_clause(self.sentence)) and not self.case_of_sentence

    @property
    def speaks_of_a_length(self) -> bool:
        """Whether its own sentence speaks of a quantity that is never negative, such as a speed."""
        return says(r"\b<length>\b", self.sentence) and "negative" not in without_formulas(self.sentence)

    @property
    def speaks_of_a_root(self) -> bool:
        """Whether its own sentence speaks of a root, or of what is positive."""
        return says(r"\b<root>\b", self.sentence) and "negative" not in without_formulas(self.sentence)

    @property
    def lists(self) -> bool:
        """Whether its own sentence speaks of several things, as in "The bounds are", and not of equations."""
        return _SEVERAL.search(without_formulas(self.sentence)) is not None and not _EQUATIONS.search(self.sentence)

    @property
    def renews(self) -> bool:
        """Whether its own sentence speaks of another thing than the text before it."""
        return says(r"\b<renews>\b", without_laws(self.sentence))

    @property
    def is_conditional(self) -> bool:
        """Whether its own sentence speaks of a condition, or denies it."""
        return self.is_denied or CONDITIONAL.search(self._whole) is not None

    @property
    def _whole(self) -> str:
        """Its own sentence, to its end."""
        return f"{self.sentence} {self.condition} {self.behind}"

    @property
    def supposes(self) -> bool:
        """Whether its own sentence supposes it."""
        return says(r"\b<supposes>\b", self.sentence)

    @property
    def is_denied(self) -> bool:
        """Whether its own sentence says that it does not hold."""
        return is_denied(self._whole)

    @property
    def is_rejected(self) -> bool:
        """Whether its own sentence says flatly that it does not hold."""
        return says(r"\b<rejects>\b", self._whole)

    @property
    def words(self) -> frozenset[str]:
        """All words near the equation, but for those that lead to the next one."""
        return words_of(f"{self.before} {self.sentence} {self.behind if self.ends else ''}")

    @property
    def follows(self) -> bool:
        """Whether the equation is said to follow from what is above it."""
        return self.implied or HENCE.search(self.sentence) is not None

    @property
    def introduces(self) -> bool:
        """Whether words such as "where" stand right before the equation, and none of a case."""
        return DEFINES.search(self.sentence) is not None and not self.case()

    @property
    def renamed(self) -> frozenset[str]:
        """The formulas of which the words before say what they are."""
        return frozenset(bare_name(each) for each in _RENAMED.findall(self.before))

    @property
    def variables(self) -> frozenset[str]:
        """The letters of which its own sentence says that functions depend on them, or that they are held."""
        found = [each for names in _VARIABLES.findall(self.sentence) for each in FORMULA.findall(names)]
        return frozenset(symbol for each in found for symbol in symbols_in_list(each.strip("$")))

    @property
    def dropped(self) -> frozenset[str]:
        """The marks that letters lose from there on, as in "we drop the tilde": what had none was another letter."""
        found = frozenset(each.lower() for each in heard(r"\b<drops>\b").findall(self.before))
        return frozenset("'" if each == "prime" else rf"\{each}" for each in found)

    def amount(self, known: Collection[str]) -> str:
        """Return a word of its own sentence that speaks of another amount than words that are known; empty for none."""
        found = (each.lower() for each in _AMOUNTS.findall(without_formulas(self.sentence)))
        return next((each for each in found if each not in known), "")

    def wider(self, known: Collection[str]) -> str:
        """Return a word of its own sentence by which it holds where it was not said to hold; empty for none."""
        found = (each.lower() for each in heard(r"\b(<wider>)\b").findall(without_formulas(self._whole)))
        return next((each for each in found if each not in known), "")

    @cached_property
    def quantified(self) -> frozenset[str]:
        """The letters of which its own sentence says that they are any, as in "for any $n$": no number is theirs."""
        return frozenset(symbol for each in _ANY.findall(self.sentence) for symbol in symbols_in_list(each))

    @property
    def exchanged(self) -> frozenset[str]:
        """The letters that are not what they were in its own sentence, as in "replacing $x$ by $-x$"."""
        found = [each for match in heard(r"\b<reverses>").finditer(self.sentence) for each in symbols_of(match[1])]
        found += [
            each for pair in heard(r"<swapped>").findall(self.sentence) for one in pair for each in symbols_of(one)
        ]
        for verb in heard(r"\b<exchanges>").finditer(self.sentence):
            one, other = (frozenset(symbols_of(each)) for each in verb.groups())
            found += [*(one | other)] if one & other or _SWAPS.match(verb[0]) else []
        for arrow in _BECOMES.finditer(self.sentence):
            one, other = (frozenset(symbols_of(arrow[name])) for name in ("what", "into"))
            found += [*(one | other)] if one & other or arrow["both"] else []
        return frozenset(found)

    def strange(self, known: Collection[str]) -> str:
        """Return a word of the sentence that is none of a derivation, and that is not known; empty for none."""
        behind = "" if _NEW_SENTENCE.match(self.behind) else _CLAUSE.split(self.behind)[0]
        return strange_word(f"{self.sentence} {behind}", known)


def beside(statement: Statement, carried: str) -> Beside:
    """Return the words beside a statement; its sentence may have begun before the equation above it."""
    display = statement.display
    last = last_sentence(display.before)
    sentence = f"{carried} {last}" if last == display.before.rstrip() else last
    behind, *rest = [""] if has_ended(display) else re.split(r"[.]\s", display.after)
    own, before, after = map(without_steps, (sentence, display.before[-NEAR:], behind[:NEAR]))
    place = display.part, display.place, bool(rest)
    tag = statement.number if is_denied(statement.number) or _case_in(statement.number) else ""
    condition = f"{statement.condition} {tag}".strip()
    return Beside(own, before, after, condition, statement.implied, *place)


def is_given_within(words: str, *, number: bool) -> bool:
    """Whether words before an inline formula say that it is a definition.

    Where it gives a number, they begin the sentence: "where $b = 0$", and not "lines with $b = 0$".
    """
    sentence = last_sentence(words)
    if _FORBIDS.search(sentence) or (
        number
        and not (heard(r"\W*(?!defines)(?:<defines>|in which)\b").match(sentence) or says(r"\b<lets>\W*$", words))
    ):
        return False
    return DEFINES.search(words) is not None and not CONDITIONAL.search(sentence)


def is_example(sentence: str, after: str) -> bool:
    """Whether a formula within the text gives an example: "with $a = 10$, for example".

    Examples
    --------
    >>> is_example("With ", ", for example:"), is_example("Say, with ", ","), is_example("With ", ", we say that")
    (True, True, False)
    """
    return _EXAMPLE.search(without_formulas(sentence)) is not None or _EXAMPLE.match(after) is not None


def is_item(before: str, after: str) -> bool:
    r"""Whether an inline formula is an item of a list, and stands there alone; the words before it speak of no case.

    Examples
    --------
    >>> [is_item(before, "\n") for before in ("They are\n* ", "They are\n* with ", "If so, they are\n* ")]
    [True, False, False]
    """
    lead, *items = _ITEM.split(before)
    leading = last_sentence(lead).strip()
    ends = re.match(r"[.,;]?[ \t]*(?:\n|$)", after) is not None
    return ends and bool(items and leading) and not items[-1] and "?" not in leading and not CASES.search(leading)


_EXAMPLE = heard(r"[\s,(]*\b<example>")
_ITEM = re.compile(r"\n\s*(?:[*+-]|\d+[.)]|\\item)[ \t]+")


def takes_back(words: str) -> bool:
    """Whether the words between two displays begin with a sentence by which the first one does not hold.

    Examples
    --------
    >>> takes_back("This is wrong. We have"), takes_back("It cannot be that"), takes_back("This is $s$.")
    (True, False, False)
    """
    remark = re.match(r"\W*([^.!]*)[.!](?=\s|$)", words)
    said = remark[1] if remark else ""
    of_it = _OF_IT.match(said) and (is_denied(said) or says(r"\b<corrects>", said))
    return bool(of_it) or says(r"\b<undoes>\b", said)


def is_denied(sentence: str) -> bool:
    """Whether a sentence says that what it leads to does not hold."""
    return _DENIED.search(sentence) is not None


def denies(words: str) -> bool:
    """Whether a title, or the words before a list, say that nothing behind them is asserted.

    Examples
    --------
    >>> [denies(each) for each in ("A myth", "Which is right?", "What if it is longer?", "Sums", "How long is it?")]
    [True, True, True, False, False]
    """
    said = last_sentence(words.rstrip(" \n{}.:"))
    asks = words.rstrip(" \n{}.").endswith("?") and not says(r"\b<answered>\b", words)
    return asks or says(r"\b<untrue>\b", said)


def has_ended(display: Display) -> bool:
    """Whether a sentence ends with a display: a full stop stands there, or a new one begins behind it."""
    stop = _LABELS.sub("", display.latex).rstrip().endswith(".") or display.after.lstrip().startswith(".")
    stop = stop or _NEW_ITEM.match(display.after) is not None
    return stop or _CAPITAL.match(display.after) is not None or _begins_anew(display.after.partition(".")[0])


_NEW_ITEM = re.compile(r"\s*\\item\b|\s*\n[ ]{0,3}(?:[*+-]|\d+[.)]) ")
_CAPITAL = re.compile(
    r"\s*(?!(?:Eqs?|Equation|I|If|When|Whenever|Where|With|For(?! (?:all|any|every|each))|"
    r"Unless|Provided|While|Here|As|In|On|At|These|This|From)\b)"
    r"[A-Z][a-z]+\s"
)
"""How a new sentence begins, though no full stop stands before it; not those that may speak of the formula."""


def ends_clause(display: Display) -> bool:
    """Whether a comma, a full stop or the like follows a formula, and no word that speaks of it."""
    return re.match(r"\s*[.,;:](?!\s*(?:if|unless|when|but|at least|which|where)\b)", display.after) is not None


def _begins_anew(behind: str) -> bool:
    """Whether the words behind an equation are a new sentence, though no full stop ends the one before it."""
    return _NEW_SENTENCE.match(behind) is not None and re.search(r",\s*[a-z]|\bthen\b", behind) is not None


def _case_in(words: str) -> str:
    found = CASES.search(words)
    return " ".join(found.group().split())[:20] if found else ""


_LEANS = heard(
    r"\W*(?:$|(?:and |so )?(?:<concludes>|then|this|that|these|here|its?|they|there|now|so|in (?:this|that|such))\b)"
)
"""How a sentence begins that goes on from the one before it."""
_CARRIES = heard(r"\b<roughly partly supposes>\b|\A\W*<condition>\b")
"""A word by which the sentences behind it may be of a case as well."""
_SEVERAL = re.compile(r"\b(?:are|were|have|give|read|become|follow|equal)\b(?![^.]*\b(?:we|you|it)\b)", re.IGNORECASE)
_EQUATIONS = heard(r"\b<equations>\b")
_AMOUNTS = heard(r"\b(<amount>)\b(?! (?:equations?|relations?|sides?|terms?|expressions?|formula\w*|steps?|numbers?$))")
_VARIABLES = re.compile(
    r"\b(?:functions? of|at (?:fixed|constant)|(?:holding|keeping)) ((?:\$[^$=]*\$(?:, and |, | and )?)+)",
    re.IGNORECASE,
)
_ANY = re.compile(r"\b(?:any|all|every|each|arbitrary)\b (?:[a-z]+ ){0,2}\$([^$=<>]*)\$", re.IGNORECASE)


def arithmetic_in(words: str) -> str:
    """Return the words that speak of another arithmetic than that of real numbers; empty for none.

    Examples
    --------
    >>> arithmetic_in("In interval arithmetic, we have"), arithmetic_in("The sum is")
    ('interval arithmetic', '')
    """
    found = _ARITHMETIC.search(words)
    return " ".join(found.group().split()) if found else ""


_ARITHMETIC = heard(
    r"\b<arithmetic>\b|\$[^$]*[-+*/][^$]*\$ (?:stands for|denotes|means) the (?!sum|difference|product|quotient|ratio)"
)
_LET = re.compile(r"\b[Ll]et\s+\$(?:([^$=:]*):?=[^$]*|[^$]*\\in\s*\\mathbb\{?R\}?(?:\^[^$]*)?)\$")
_LABELS = re.compile(r"\\(?:label|tag\*?)\s*\{[^{}]*\}")
_RENAMED = re.compile(r"\$([^$]*)\$\s*(?:now\s+)?(?:is|are|denotes?|stands?|means?|becomes?|represents?)\b")
_BECOMES = re.compile(
    r"\$(?P<what>[^$=]*?)\\(?:to|mapsto|longmapsto|(?:long)?rightarrow|(?P<both>(?:long)?leftrightarrow))(?![a-zA-Z])"
    r"(?P<into>[^$=]*)\$"
)
"""How a formula says that a letter becomes something with it, as in "x to x + 1", and no limit."""
_SWAPS = re.compile(r"\b(?:ex|inter)?chang\w* |swap|switch", re.IGNORECASE)
_NEW_SENTENCE = re.compile(r"\s*[A-Z][a-z]* ")
_CLAUSE = re.compile(r"\b(?:where|with|which)\b")
