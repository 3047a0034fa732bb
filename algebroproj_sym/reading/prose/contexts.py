"""Where an equation holds, as far as its sentence begins with it: at the top, before the collision, in model A."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from algebroproj_sym.reading.prose.devices import heard

_KINDS = ("condition", "range", "state", "place", "time", "extent", "name", "sort", "presence")
_AND = r"[^a-z$]*(?:(?:and|but|now|then|hence|thus|so|therefore|consequently)\W+)*"
"""The words before those of a context."""
_COMMANDS = re.compile(
    r"(?:\s|[{}]|\\(?:begin|end|label|[vh]space|input|include)\*?(?:\[[^\]]*\]|\{[^{}]*\})+|\\[a-zA-Z]+\*?(?:\[[^\]]*\])?)*"
)
"""The commands with which a sentence may begin, and no words of them but those in brackets of a font."""
_BEGINS = heard(_AND + "(?:" + "|".join(f"(?P<{kind}><begins-{kind}>)" for kind in _KINDS) + ")", re.DOTALL)
_WHERE = heard(
    _AND + r"(?P<words>(?:in|on|at|for|near|under|during|along|across)\s+"
    r"(?:(?<!for )the\s+|(?<=\bin )|(?:the\s+|an?\s+)?(?:(?!(?:the|an?|we|it|one)\b)[a-z-]+\s+){1,2}?)"
    r"(?P<head>(?!(?:<of-a-text manner arises>|the|an?|of|we|it|one)\b)[a-z-]+\b))"
    r"(?=\s*(?:,|:|$|\$|(?:the|we|it|its|one|this|that|an?|there|is|are|has|holds|hence|thus|then)\b))"
)
"""How a sentence begins with a place in a wide sense: one of which the last word is the same is another."""
_OF_ANOTHER = heard(
    r"[^a-z$]*(?:in|on|at|for|by|under|within|according to)\s+(?:the\s+|an?\s+)?"
    r"(?P<words>(?P<head>(?!<of-a-text manner arises>\b)[a-z-]+)\s+of\s+(?:the\s+|an?\s+)?[a-z-]+)"
)
"""How a sentence begins with a thing of somebody: "In the model of Smith"."""
_PROPER = re.compile(
    r"\W*(?:And\s+|But\s+)?(?:[Ii]n|[Oo]n|[Aa]t|[Nn]ear|[Ff]or)\s+(?:the\s+)?(?P<words>[A-Z][a-z]{2,})"
    r"(?=\s*(?:,|:|$|(?:the|we|it|its|one|this|an?)\b))"
)
_FRONT = heard(
    _AND + r"(?:(?P<sure>(?!<adverb>\b)[a-z]{2,}ly|[a-z]+\s+\d+|for\s+(?!<aim>\b)[a-z]+\s+\$[^$]*\$|"
    r"at\s+(?:time\s+)?\$[^$]*\$|(?:at|to)\s+[a-z]+\s+orders?|in\s+(?:any|each|every)\s+case|in\s+all\s+cases)|(?P<words>"
    r"(?:in|on|at|under|within|among|amongst|near|inside|outside|beyond|along|across|during|except|unlike|according\s+to|"
    r"averaged\s+over|by\s+way\s+of|besides|throughout|around|between|only)\s+[^,;:]{1,80}))(?=\s*[,:])"
)
"""What stands before the first comma of a sentence, and says where it holds."""
_SOURCE = heard(r"\W*(?:And\s+|But\s+)?(?P<words>[A-Z][a-z]+(?:\s+and\s+[A-Z][a-z]+)?)\s+<reports>\b", re.NOFLAG)
"""How a sentence says who says it."""
_SAID_BY = heard(r"\W*(?P<words>(?:an?|the|one of the|some|many|most)\s+<speaker>)\b")
_NOBODY = re.compile(
    r"We|You|One|It|This|That|These|They|He|She|Who|Which|Theory|Experiments?|Figures?|Tables?|Equations?"
)
_NO_PLACE = heard(r"<of-a-text manner>|eqn|fig|cref|autoref|lemma|python|matlab|latex")
_OF_A_TEXT = heard(r"\b(?:<of-a-text manner arises>|<step>\w*|eqn|fig|cref|autoref|eqref|ref)\b")
_OF_A_THING = re.compile(
    r"[^a-z$]*the\s+[a-z]+\s+(?:in|of|for)\s+(?:the\s+)?((?:frame|model|image|camera|system|case|observer|medium|scenario)"
    r"\s+\$?[a-z0-9]+\b)"
)
_LEADS = re.compile(r"(?:(?:in|on|at|for|by|with|using|during)\s+)?(?:(?:the|an?)\s+)?")
_ABSENT = re.compile(r"without|in the absence|ignoring|neglecting|excluding|omitting")
_WHILE = ("while", "as long as", "so long as", "until")
_THINGS = ("front", "source", "place", "name", "sort", "state", "time", "extent", "of several")
"""The kinds of contexts that a sentence of its own may begin."""
_ELSEWHERE = {"time", "place", "range", "extent", "sort"}
"""The kinds of contexts of which one is elsewhere than any other; but "for even" may be short for a range."""
_BEHIND = heard(
    r"[\s,]*((?:(?:but )?only )?(?:<if>|while|with (?:\w+ )?probability|"
    r"for (?:very |all |sufficiently )?(?:small|large|low|high|weak|strong|even|odd|positive|negative))\b[^.;]*)",
    re.NOFLAG,
)
"""How the words behind an equation say where it holds."""
_ONLY = re.compile(r"[\s,]*((?:but )?only (?:in|at|on|for|under|within|near|with|during)\b[^.;]*)", re.IGNORECASE)
_INNER = re.compile(r"\((with(?:out)? [^()$]*)\)")
"""A bracket that says in which presence something holds."""
_FIXED = re.compile(r"\$\s*([a-z])\s*=\s*\d+\s*\$")
_STEPS = re.compile(
    r"\b(?:if|when|once)\s+(?:we|you|one)\s+(?=(?:now\s+|then\s+)?(?:substitut|insert|plug|replac|put|multipl|divid|add|"
    r"subtract|combin|rearrang|differentiat)\w*\b[^.,;=]*?(?:\(\d+[a-z]?\)|ref\s*\{|\b(?:equations?|eqs?)\b))"
    r"|\blet(?:['’]s|\s+us)\s+(?=(?:now\s+|also\s+|first\s+)?(?:substitut|insert|plug|multipl|divid|subtract|combin|rearrang|"
    r"differentiat|comput|calculat|expand|simplif|write|rewrite|see|look|start|begin|find|check|verify|show)\w*\b)",
    re.IGNORECASE,
)
"""Words before a step of a derivation, which are no condition: "if we put (3) into (4)", "let us divide"."""


@dataclass(frozen=True)
class Context:
    """Where an equation holds."""

    kind: str = ""
    """What its words speak of, such as a place; empty for none."""
    words: str = ""

    @property
    def is_of_things(self) -> bool:
        """Whether a sentence of its own may begin it, and others go on with it."""
        return self.kind.endswith(_THINGS)

    @property
    def fixed(self) -> str:
        """The letter to which it gives a number, as in "at $i = 1$"; empty for none."""
        found = _FIXED.search(self.words) if self.kind == "range" else None
        return found[1] if found else ""

    def excludes(self, other: Context) -> bool:
        """Whether an equation may hold in the one and not in the other.

        Examples
        --------
        >>> context_of("At the top,").excludes(context_of("At the bottom")), Context().excludes(context_of("If so"))
        (True, False)
        """
        if not self.kind or self.words == other.words:
            return False
        if self.words.startswith(("in general", "generally")):
            return bool(other.kind)
        kinds = {self.kind, other.kind}
        if "front" in kinds or (len(kinds & _ELSEWHERE) == 2 and kinds != {"range", "sort"}):
            return bool(other.kind)
        if self.kind != other.kind:
            return other.kind == "condition" or other.words.startswith(_WHILE)
        return self.kind != "presence" or bool(_ABSENT.match(self.words)) != bool(_ABSENT.match(other.words))

    @property
    def is_case(self) -> bool:
        """Whether it is a condition or a while, which may be over when another thing is spoken of."""
        return self.kind == "condition" or self.words.startswith(_WHILE)


ANYWHERE = Context()


def without_steps(words: str) -> str:
    """Return words in which a step of a derivation does not look like a condition.

    Examples
    --------
    >>> without_steps("If we put (3) into (4), let's expand, if we put the lid on the box")
    'put (3) into (4), expand, if we put the lid on the box'
    """
    return _STEPS.sub("", words)


def last_context(sentences: Sequence[str], behind: str) -> Context:
    """Return where an equation holds, by the last sentence before it that says it.

    Only the last one may say it by a condition, or by a range.

    Examples
    --------
    >>> last_context(["The right half is free.", "Hence"], "")
    Context(kind='place', words='right half')
    """
    own = context_of(sentences[-1], behind)
    above = (found for each in sentences[-2::-1] if (found := context_of(each)).is_of_things)
    return own if own.kind else next(above, ANYWHERE)


def context_behind(behind: str) -> Context:
    """Return where an equation holds by the words right behind it, as in "provided that the lid is shut".

    Examples
    --------
    >>> context_behind("for even $n$. For odd"), context_behind("If so,")
    (Context(kind='range', words='for even $n$'), Context(kind='', words=''))
    """
    if only := _ONLY.match(behind):
        return Context("condition", only[1].lower())
    found = _BEHIND.match(behind)
    return context_of(re.sub(r"^(?:but )?only ", "", found[1])) if found else ANYWHERE


def context_of(sentence: str, behind: str = "") -> Context:
    """Return where an equation holds, by the words with which its sentence begins, and perhaps goes on behind it.

    Examples
    --------
    >>> context_of("At the top, the speed is"), context_of("After some algebra, we get")
    (Context(kind='place', words='top'), Context(kind='', words=''))
    """
    step = _STEPS.search(f"{sentence} {behind}")
    bare = sentence if step is None else sentence[: step.start()] + sentence[step.end() :]
    bare = _COMMANDS.sub("", bare, count=1)
    if inner := _INNER.search(bare):
        return context_of(inner[1])
    found = _BEGINS.match(bare.lower())
    if found is None or found.lastgroup is None:
        proper = _PROPER.match(bare)
        if proper is not None and not _NO_PLACE.fullmatch(proper["words"]):
            return Context("place", proper["words"].lower())
        source = _SOURCE.match(bare) or _SAID_BY.match(bare)
        if source is not None and not _NOBODY.fullmatch(source["words"]):
            return Context("source", source["words"].lower())
        thing = _OF_A_THING.match(bare.lower())
        place = _OF_ANOTHER.match(bare.lower()) or _WHERE.match(bare.lower())
        if thing is None and place is not None:
            where = _LEADS.sub("", " ".join(place["words"].split()), count=1)
            return Context(f"{place['head']} of several" if " " in where else "place", where)
        return Context("name", " ".join(thing[1].split())) if thing else _front_of(bare.lower())
    words = " ".join(found[found.lastgroup].split())
    return Context(found.lastgroup, _LEADS.sub("", words, count=1) if found.lastgroup in _THINGS else words)


def _front_of(sentence: str) -> Context:
    """Return where an equation holds by what stands before the first comma, if it is no word of a text or a step."""
    found = _FRONT.match(sentence)
    if found is None or (found["words"] and _OF_A_TEXT.search(found["words"])):
        return ANYWHERE
    return Context("front", " ".join((found["sure"] or found["words"]).split()))
