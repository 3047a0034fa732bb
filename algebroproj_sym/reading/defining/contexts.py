"""Where an equation holds, as far as its sentence begins with it: at the top, before the collision, in model A."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

_ARTICLE = r"(?:the\s+|an?\s+)"
_STEP = (
    r"(?:substitut|rearrang|simplif|insert|integrat|differentiat|multipl|divid|expan|cancel|collect|comput|algebra|some|"
    r"other|first|last|least|most|once|all|same|basis|contrary|hand|this|that|these|those|point|order|average|both)"
)
_ORDINAL = r"(?:old|new|first|second|third|other|another|explicit|implicit|forward|backward|original|modified|exact)"
_THING = (
    r"(?:method|model|case|experiment|medium|scheme|image|camera|approach|problem|lens|body|stage|phase|euler|setup|"
    r"system|example|variant|interval|region|version|edition|notation|convention|axis|branch|frame|run|trial|definition|one)"
)
_WORK = (
    r"(?:the|an?|we|you|it|few|squar|tak|solv|eliminat|regroup|replac|appl|us|perform|add|subtract|factor|evaluat|introduc|"
    r"complet|renam|transform|set|normali|linear|approxim|neglect|notic|defin|choos|writ|see|show|prov|deriv|discuss|"
    r"[a-z]+ing\s+(?:the|this|both|out|by|in|these|all|and|with|over))"
)
"""How words for a step of a derivation begin, besides those."""
_WORD_OF_A_TEXT = (
    r"(?:equations?|eqs?|sections?|sec|chapter|figures?|fig|tables?|theorems?|lemmas?|definitions?|propositions?|steps?|"
    r"corollary|parts?|lines?|rows?|columns?|pages?|paragraph|appendix|place|terms?|time|times|sum|integral|factors?|"
    r"order|instance|sight|glance|approximation|inequality|equality|identity|relation|expression|formula|law|derivatives?|"
    r"moment|components?|entry|argument|kind|sense|derivation|variables?|coordinates?|letter|side|slot|position|hand|"
    r"words?|two|three|few|at least|at most|remarks?|results?|dimensions?)"
)
"""What is numbered in a text, and no thing of which it speaks."""
_MANNER = (
    r"(?:form|notation|view|detail|particular|general|fact|summary|addition|contrast|practice|theory|turn|effect|following|"
    r"meantime|end|way|sequel|reverse|rule|language|principle|average|mean|limit|total|context|proof|text|paper|book|work|"
    r"article|thesis|tutorial|notebook|example|exercise|lecture|implementation|code|literature|beginning|moment|basis)"
)
"""The words of how something is said."""
_ARISES = (
    r"(?:case|terms|absence|presence|course|spite|instead|front|favou?r|need|lack|light|means|virtue|use|help|sake|sum|"
    r"product|number|set|choice|definition|linearity|symmetry|conservation|analogy|because|each|all|any|most|some|both|one|"
    r"either|none|rest|basis|center|centre|middle|top|bottom|level|value|values|purpose|purposes|range|function)"
)
"""The words of what is said or done, and of no thing that another one has as well."""
_AIM = (
    r"(?:simplicity|brevity|convenience|clarity|completeness|comparison|reference|definiteness|illustration|ease|short|"
    r"all|any|each|every|some|this|that|these|those|which|it|us|now|later|further|more|most|many|our|its|notational|"
    r"us|use|better|future|later|both|given|fixed|constant|\w+ing|\w+ly|arbitrary|general|instance|example)"
)
_KINDS = {
    "condition": (
        r"(?:(?:if|when|whenever)\b(?! (?:you|we|one) "
        r"(?:talks?|speaks?|thinks?|says?|looks?|wants?|wish|wishes|repeat|proceed|continue|do (?:so|this|the same))\b)"
        r"|unless\b|otherwise\b|else\b|in general\b|generally\b|provided\b(?! by)|in case\b|on condition\b|as soon as\b"
        r"|should (?:the|an?|it|there)\b"
        r"|with (?:(?:a|an|the|\w+) )?probability\b(?! (?:density|distribution|mass|measure|function|space|theory|of))"
        r"|most of the time\b|in most cases\b|sometimes\b|usually\b|typically\b|often\b|mostly\b|occasionally\b).*"
    ),
    "range": r"for\s+(?:very\s+|all\s+|sufficiently\s+)?"
    r"(?:small|large|low|high|weak|strong|even|odd|positive|negative)\s+(?:[a-z]+|\$[^$]*\$)|"
    r"(?:for|at)\s+\$[^$]*(?:=|<|>|\\[lg]eq?\b)[^$]*\$|in the limit\b.*",
    "state": r"(?:in|at|out of|away from|far from)\s+(?:thermal\s+)?equilibrium|in\s+(?:winter|summer|spring|autumn)"
    r"|in\s+(?:(?:the|an?)\s+)?(?:steady|stationary|transient|static|dynamic)\s+(?:state|case|regime)|during\s+the\s+transient"
    r"|at\s+rest|in\s+motion",
    "place": (
        r"at\s+(?:the\s+)?(?:points?|times?|instants?|positions?)\s+\$[^$=]*\$|"
        r"(?:(?:at|on|in)\s+)?(?:the\s+)?(?:left|right|upper|lower|inner|outer)\s+"
        r"(?:boundary|end|wall|edge|half|side(?! of))|"
        rf"(?:at|on|near|inside|outside)\s+(?!{_ARTICLE}?{_STEP}){_ARTICLE}?[a-z]+"
        r"|upstream|downstream|far\s+(?:away|from|upstream|downstream)\b|away\s+from\s+(?:the\s+|an?\s+)?[a-z]+"
    ),
    "time": rf"(?:before|after|during)\s+{_ARTICLE}(?!{_STEP})[a-z]+|initially|finally(?!,)|until\b"
    rf"|(?:before|after)\s+(?!{_STEP}|{_WORK})[a-z]+|(?:as|so)\s+long\s+as\b"
    r"|while\b(?!\s+(?:\$[^$=<>]*\$|[a-z])\s+(?:(?:is|are) the (?!(?:largest|smallest|only|same|first|last|larger|"
    r"smaller)\b)[a-z]|denotes?\b|represents?\b|stands? for\b))",
    "extent": r"(?:up to|beyond|past|below|above|under|over|within|less than|more than)\s+(?:the|an?|its|this|it|\$)"
    r"(?!\s+(?:assumptions?|conditions?|hypothes[ie]s|form|constraints?))[^,]*",
    "name": (
        r"(?:model|option|variant|version|method|scheme|exercise|problem|example|experiment|scenario|case|design)\s+"
        rf"(?:\d+|[a-z]|[ivx]+)\b|(?:(?:in|by|for|with|using)\s+)?(?:the\s+|an\s+)?{_ORDINAL}\s+{_THING}"
        rf"|(?:in|on|for|by|with|at|during)\s+(?:the\s+)?(?!(?:an?|{_WORD_OF_A_TEXT})\b)[a-z]+\s+(?:\d+|one|two|three|ii|iii)\b(?!-)"
    ),
    "sort": r"for\s+(?:an?|the\s+(?:left|right|first|second|upper|lower|inner|outer|other))\s+"
    r"(?!(?:terms?|factors?|parts?|equations?|integrals?|sums?|steps?|sides?|hand)\b)[a-z]+"
    r"|for\s+[a-z-]+\s+(?:flows?|fluids?|gas(?:es)?|media|materials?|particles?|bodies|motions?|light)\b"
    rf"|for\s+(?!{_AIM}\b)[a-z]+(?=\s*(?:,|:|$|(?:we|the|it|one|this|is)\b))",
    "presence": r"(?:with(?:out)?|in the (?:absence|presence) of|ignoring|neglecting|including|excluding|omitting)\s+"
    r"(?:the\s+|any\s+|an?\s+)?[a-z]+",
}
_COMMANDS = re.compile(
    r"(?:\s|[{}]|\\(?:begin|end|label|[vh]space|input|include)\*?(?:\[[^\]]*\]|\{[^{}]*\})+|\\[a-zA-Z]+\*?(?:\[[^\]]*\])?)*"
)
"""The commands with which a sentence may begin, and no words of them but those in brackets of a font."""
_BEGINS = re.compile(
    r"[^a-z$]*(?:(?:and|but|now|then|hence|thus|so|therefore|consequently)\W+)*(?:"
    + "|".join(f"(?P<{kind}>{words})" for kind, words in _KINDS.items())
    + ")",
    re.DOTALL,
)
_WHERE = re.compile(
    r"[^a-z$]*(?:(?:and|but|now|then|hence|thus|so|therefore|consequently)\W+)*"
    r"(?P<words>(?:in|on|at|for|near|under|during|along|across)\s+(?:the\s+|an?\s+)?(?:[a-z-]+\s+){1,2}?"
    rf"(?P<head>(?!(?:{_WORD_OF_A_TEXT}|{_MANNER})\b)[a-z-]+))"
    r"(?=\s*(?:,|:|$|\$|(?:the|we|it|its|one|this|that|an?|there|is|are|has|holds|hence|thus|then)\b))"
)
"""How a sentence begins with a place in a wide sense: one of which the last word is the same is another."""
_OF_ANOTHER = re.compile(
    r"[^a-z$]*(?:in|on|at|for|by|under|within|according to)\s+(?:the\s+|an?\s+)?"
    rf"(?P<words>(?P<head>(?!(?:{_WORD_OF_A_TEXT}|{_MANNER}|{_ARISES})\b)[a-z-]+)\s+of\s+(?:the\s+|an?\s+)?[a-z-]+)"
)
"""How a sentence begins with a thing of somebody: "In the model of Smith"."""
_PROPER = re.compile(
    r"\W*(?:And\s+|But\s+)?(?:[Ii]n|[Oo]n|[Aa]t|[Nn]ear)\s+(?:the\s+)?(?P<words>[A-Z][a-z]{2,})(?=\s*(?:,|:|$|(?:the|we|it|its|one|this|an?)\b))"
)
_SAID = (
    r"(?:finally|similarly|consequently|accordingly|equivalently|alternatively|explicitly|conversely|analogously|namely|"
    r"additionally|clearly|obviously|simply|importantly|interestingly|specifically|particularly|formally|mathematically|"
    r"subsequently|firstly|secondly|thirdly|lastly|intuitively|geometrically|algebraically|physically|notably|precisely|"
    r"correspondingly|immediately|directly|evidently|trivially|easily|readily|ultimately|essentially|basically|naturally|"
    r"fortunately|unfortunately|surprisingly|recursively|iteratively|inductively|concretely|briefly|certainly|surely|"
    r"actually|previously|concisely|compactly|effectively|necessarily|logically|multiply|apply|imply|reply|rely|supply|"
    r"only|early|family)"
)
"""How something is said; and words with the same ending."""
_FRONT = re.compile(
    r"[^a-z$]*(?:(?:and|but|now|then|hence|thus|so|therefore|consequently)\W+)*(?:(?P<sure>"
    rf"(?!{_SAID}\b)[a-z]{{2,}}ly|[a-z]+\s+\d+|for\s+(?!{_AIM}\b)[a-z]+\s+\$[^$]*\$|at\s+(?:time\s+)?\$[^$]*\$|(?:at|to)\s+[a-z]+\s+orders?"
    r"|in\s+(?:any|each|every)\s+case|in\s+all\s+cases)|(?P<words>"
    r"(?:in|on|at|under|within|among|amongst|near|inside|outside|beyond|along|across|during|except|unlike|according\s+to|"
    r"averaged\s+over|by\s+way\s+of|besides|throughout|around|between|only)\s+[^,;:]{1,80}))(?=\s*[,:])"
)
"""What stands before the first comma of a sentence, and says where it holds."""
_SOURCE = re.compile(
    r"\W*(?:And\s+|But\s+)?(?P<words>[A-Z][a-z]+(?:\s+and\s+[A-Z][a-z]+)?)\s+(?:found|finds|shows?|showed|prove[sd]?|claim(?:s|ed)?|"
    r"says?|said|argue[sd]?|measure[sd]|assume[sd]|uses?|used|reports?|reported|proposed?|proposes|suggests?|suggested)\b"
)
"""How a sentence says who says it."""
_SAID_BY = re.compile(
    r"\W*(?P<words>(?:an?|the|one of the|some|many|most)\s+(?:referees?|reviewers?|critics?|authors?|sceptics?|"
    r"skeptics?|students?|opponents?|colleagues?|textbooks?))\b",
    re.IGNORECASE,
)
_NOBODY = re.compile(
    r"We|You|One|It|This|That|These|They|He|She|Who|Which|Theory|Experiments?|Figures?|Tables?|Equations?"
)
_NO_PLACE = re.compile(
    rf"(?:{_WORD_OF_A_TEXT}|{_MANNER}|eqn|fig|cref|autoref|lemma|python|matlab|latex)", re.IGNORECASE
)
_OF_A_TEXT = re.compile(rf"\b(?:{_WORD_OF_A_TEXT}|{_MANNER}|{_ARISES}|{_STEP}\w*|eqn|fig|cref|autoref|eqref|ref)\b")
_OF_A_THING = re.compile(
    r"[^a-z$]*the\s+[a-z]+\s+(?:in|of|for)\s+(?:the\s+)?((?:frame|model|image|camera|system|case|observer|medium|scenario)"
    r"\s+\$?[a-z0-9]+\b)"
)
_LEADS = re.compile(r"(?:(?:in|on|at|for|by|with|using|during)\s+)?(?:(?:the|an?)\s+)?")
_ABSENT = re.compile(r"without|in the absence|ignoring|neglecting|excluding|omitting")
_WHILE = ("while", "as long as", "so long as", "until")
_THINGS = ("front", "source", "place", "name", "sort", "state", "time", "extent", "of several")
"""The kinds of contexts that a sentence of its own may begin."""
_BEHIND = re.compile(
    r"[\s,]*((?:(?:but )?only )?(?:if|when|whenever|unless|provided(?! by)|in case|as long as|so long as|until|while|"
    r"for (?:very |all |sufficiently )?(?:small|large|low|high|weak|strong|even|odd|positive|negative)|"
    r"with (?:\w+ )?probability)\b[^.;]*)"
)
"""How the words behind an equation say where it holds."""
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
        if "front" in kinds or kinds == {"time", "place"}:
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
            return Context(f"{place['head']} of several", _LEADS.sub("", " ".join(place["words"].split()), count=1))
        return Context("name", " ".join(thing[1].split())) if thing else _front_of(bare.lower())
    words = " ".join(found[found.lastgroup].split())
    return Context(found.lastgroup, _LEADS.sub("", words, count=1) if found.lastgroup in _THINGS else words)


def _front_of(sentence: str) -> Context:
    """Return where an equation holds by what stands before the first comma, if it is no word of a text or a step."""
    found = _FRONT.match(sentence)
    if found is None or (found["words"] and _OF_A_TEXT.search(found["words"])):
        return ANYWHERE
    return Context("front", " ".join((found["sure"] or found["words"]).split()))
