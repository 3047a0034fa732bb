"""What is done to a letter, so that it is no longer what it was: "$n$ is normalised", "we replace $n$ by $n + 1$".

The words that leave a letter as it is are listed.  Any other one changes it: what is not heard costs a derivation.
"""

import re

from algebroproj_sym.reading.defining.phrases import symbols_in_list

NEAR = 200
"""How many characters on both sides of a letter are searched for what is done to it."""
_LETTERS = re.compile(r"(?:\$[^$=<>(]*\$(?:,? and |, ))*\$[^$=<>(]*\$")
_MEANWHILE = r"(?:(?:\w+ly|then|now|next|again|also|first|further|both|all|here|thus|hence|being|there) )*"
_DONE = re.compile(
    rf",? {_MEANWHILE}(?:is|are|was|were|gets?|has been|have been|will be) {_MEANWHILE}"
    r"(\w+(?:ed|wn|ken)|set|reset|put|cut|split|made|shrunk)\b(?! (?:as|in) \$)"
)
_DOES = re.compile(
    rf" {_MEANWHILE}([a-z]*[a-rt-z]s)(?=\s*(?:$|[.,;:]|(?:(?:its |the )?(?:sign|value|size|direction)|by|to|with|at|in|"
    r"after|during|every|each|from|until|when|whenever|while|over|as|once|twice|again|up|down|and|small|smaller|larger|"
    r"one|two|three|\w+ly)\b))"
)
_LET_DO = re.compile(r" (?!(?:be|denote|stand|represent|have|and|or|mean)\b)([a-z]+)\b")
_BEFORE_A_NOUN = r"(?!(?:of|in|to|for|with|at|on|by|from|first|last|all) )[\w-]+ "
_SUBJECT = re.compile(
    r"(?:^|\b(?:[Tt]hen|[Nn]ow|[Nn]ext|[Ww]hile|[Hh]ere|[Aa]nd|[Ss]o|[Hh]ence|[Ee]ach|[Ee]very),? "
    rf"|\b(?:[Tt]he|[Ii]ts|[Oo]ur|[Aa]n?) (?:[\w-]+ ){{0,2}}?{_BEFORE_A_NOUN})$"
)
_OF = (
    r"(?:(?:the|its|our|each|both) )?(?:(?!derivative|gradient|slope|rate|logarithm|norm|differential|variation)[\w-]+ "
    rf"(?:of|in) (?:the |its |our |both )?)?(?:{_BEFORE_A_NOUN})??"
)
_ORDERED = re.compile(
    rf"(?:\b(?:[Ww]e|[Yy]ou|[Oo]ne|us|[Tt]hen|[Nn]ow|[Nn]ext),? {_MEANWHILE}|^\W*)"
    rf"(?!(?:we|you|one|us|i|they|it) )([A-Za-z]+) {_OF}$"
)
_GOES_ON = re.compile(
    r"\s*(?:$|[.,;]|(?:by|to|with|into|onto|in|from|for|until|at|again|back|around|about|over|off|out|away|after|before|"
    r"and|so|up|down|once|twice|every|each|whenever|while)\b)"
)
_TAKES = re.compile(
    rf" {_MEANWHILE}(?:(?:takes?|assumes?) (?:on )?the values?\b"
    r"|(?:keeps?|retains?) the values? (?:it|they|of|from|that)\b)"
)
_STEPWISE = re.compile(
    r"\b(?:(?:each|every) (?:\w+ )?"
    r"(?:steps?|iterations?|iterates?|updates?|epochs?|rounds?|cycles?|time|of (?:them|these|the))|"
    r"schedules?|scheduled?|adaptive\w*|from \w+ to \w+)\b",
    re.IGNORECASE,
)
_REPLACED = re.compile(r"replac\w*$", re.IGNORECASE)
_BY_ITSELF = re.compile(r"\s*(?:by|with)\b")
_SAME = re.compile(r"\b(?:same|constant|fixed|equal|all)\b", re.IGNORECASE)
_PUT_IN = re.compile(r"(?:put|putting) in(?:to)?\b", re.IGNORECASE)
_ADDED = re.compile(
    r"\b(?:[Aa]dd|[Ss]ubtract|[Tt]ake)s? (?:one|two|three|\$\d+\$|\d+|(?:an? |some )?\w+) (?:to|from) (?:the \w+ )?$"
    r"|\b(?:is|are|was|were|gets?) (?:\w+ )?(?:applied|added|assigned|copied|written) (?:to|into|onto) (?:the \w+ )?$"
)
_HENCEFORTH = re.compile(
    r"\b(?:from (?:now|here|this point|there)(?: on(?:wards?)?)?|henceforth|hereafter|in place(?! of))\b", re.IGNORECASE
)
_STEMS = (
    # to say what it is
    "defin|describ|interpret|call|denot|nam|label|indicat|represent|mean|stand|abbreviat|explain|specif|stat|express|"
    "characteri[sz]|mention|discuss|present|report|list|tabulat|cit|tell|recall|introduc|refer|identif|recogni[sz]|"
    # to find it
    "comput|calculat|determin|estimat|measur|evaluat|obtain|deriv|observ|examin|compar|infer|check|verif|prov|solv|"
    "look|seek|learn|guess|generat|minimi[sz]|maximi[sz]|optimi[sz]|sampl|fit|"
    # to suppose it
    "assum|suppos|consider|requir|need|expect|desir|want|wish|ignor|neglect|omit|view|regard|treat|think|prescrib|choos|"
    "pick|select|fix|keep|let|allow|assign|guarantee|ensur|impos|demand|postulat|justif|conclud|not|notic|"
    # to use it
    "us|eliminat|substitut|insert|plug|integrat|differentiat|equat|factor|simplif|rewrit|rearrang|isolat|cancel|collect|"
    "sum|multipl|divid|add|subtract|appl|work|encod|realiz|build|construct|model|parametri[sz]|retain|plot|display|"
    "illustrat|associat|connect|link|attach|mount|locat|plac|includ|"
    # to be what it is
    "relat|provid|involv|situat|contain|bound|limit|restrict|constrain|distribut|cent(?:e?r)|clos|own|bas|contribut|exceed|"
    "equal|depend|differ|consist|satisf|obey|appear|occur|lie|act|exist|belong|correspond|point|serv|remain|stay|vanish|enter|"
    "cover|span|form|yield|impl|map|affect|govern|control|play|aris|compris|agree|coincid|match|hold|giv|tak|mak|rang|count|"
    "stud|run|show|see|find|writ|get|read|know|draw|go|do|try|understand"
)
_LEAVES = re.compile(
    rf"(?:{_STEMS})(?:[a-z]?(?:e|y|es|s|ed|d|ies|ied|n|en|wn|ing|ying))?"
    r"|found|shown|known|held|kept|done|said|sought|built|thought|understood|chosen|drawn|given|taken|written|"
    r"is|are|was|were|be|been|has|have|had|does|can|may|might|must|will|would|shall|should|cannot|and|or|of|in|at|on|to|by|"
    r"for|with|from|as|where|which|that|when|if|while|then|so|but|not|only|such|per|plus|minus|times|over|whose|into|about|"
    r"we|it|they|there|this|these|each|both|since|because|due|versus|vs|itself|themselves|independent\w*|constant|above|"
    r"below|here|again|also|hence|thus|now|the|an?",
    re.IGNORECASE,
)
"""The words by which a letter stays what it is."""


def acted_on(text: str, *, stepwise: bool = False) -> frozenset[str]:
    """Return the letters that words change; stepwise also those that a sentence names with each step.

    Examples
    --------
    >>> for words in ("Next, $n$ is normalised.", "We flip the sign of $n$.", "The rate $h$ decays.", "$b$ is given."):
    ...     print(sorted(acted_on(words)))
    ['n']
    ['n']
    ['h']
    []
    """
    found = set[str]()
    for sentence in re.split(r"(?<=[.!?;:])\s+|\n\s*\n|\f", text):
        words = " ".join(sentence.split())
        for letters in _LETTERS.finditer(words):
            start, end = letters.span()
            before, behind = words[max(0, start - NEAR) : start], words[end : end + NEAR]
            if _is_changed(before, behind) or (stepwise and _is_of_a_step(before, behind)):
                found.update(each for latex in letters.group().split("$")[1::2] for each in symbols_in_list(latex))
    return frozenset(found)


def is_acted_on(behind: str) -> bool:
    """Whether words right behind a formula change what it gives: "is then normalised"."""
    done = _DONE.match(f" {behind.lstrip()}")
    return done is not None and _LEAVES.fullmatch(done[1]) is None


def _is_of_a_step(before: str, behind: str) -> bool:
    """Whether a sentence with a letter speaks of each step, and not of all of them as the same."""
    sentence = f"{before} {behind}"
    return _STEPWISE.search(sentence) is not None and _SAME.search(sentence) is None


def _is_changed(before: str, behind: str) -> bool:
    """Whether the words of a sentence around a letter change it."""
    does = _DOES.match(behind) if _SUBJECT.search(before) else None
    does = does or (_LET_DO.match(behind) if before.endswith(("let ", "Let ")) else None)
    order = _ORDERED.search(before) if _GOES_ON.match(behind) else None
    verbs = [each[1] for each in (does, order) if each is not None and not _PUT_IN.match(f"{each[1]}{behind}")]
    verbs = [each for each in verbs if not _REPLACED.match(each) or _BY_ITSELF.match(behind)]
    changes = any(each == "gets" or _LEAVES.fullmatch(each) is None for each in verbs)
    changes = changes or _TAKES.match(behind) is not None
    changes = changes or _HENCEFORTH.search(f"{before} {behind}") is not None
    return changes or (behind[:1] in (" ", ",") and is_acted_on(behind)) or _ADDED.search(before) is not None
