"""Why a relation that fails for some values need not be a contradiction.

It must be one if its letters are all given: by definitions above it or, in a chain, by the side before.  It may not
stand beside words that speak of a case, and it may not be a new definition of a letter, or a condition.  Words before a
display say nothing of an equation in it that rests on other equations of the display alone: they speak of all of them.
"""

from collections.abc import Iterable
from itertools import pairwise
from typing import Any

from lark import Token, Tree

from algebroproj_sym.expressions import text
from algebroproj_sym.proving.reals.prove import may_agree
from algebroproj_sym.reading.asking.refusing import taken_at_other_letters
from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.recognising import defined_by
from algebroproj_sym.reading.defining.vocabulary import UNCOMPUTED, Vocabulary
from algebroproj_sym.reading.deriving.special import doubt_of_special
from algebroproj_sym.reading.lexing.names import bare_name
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, symbols_in, tokens_in, trees_in
from algebroproj_sym.reading.prose.sentences import strange_word, words_of
from algebroproj_sym.reading.prose.words import Beside

NOT_COMPUTED = "has a value that is not computed"
NOT_GIVEN = "nothing above it defines its letters"
A_CONDITION = "it may be a condition that holds in some cases only"
_MINUS_ONE = Tree("sum", [Token("SIGN", "-"), Tree("number", [Token("NUMBER", "1")])])
_IMAGINARY = frozenset(("i", "j", r"\imath", r"\jmath", r"\mathbf{i}", r"\mathbf{j}"))


def doubt_of_premises(beside: Beside, formula: Parsed, index: int, vocabulary: Vocabulary) -> str:
    """Return why an equation that fails under its premises need not contradict them.

    It must follow from them by its own words, or in a chain from definitions, and they must be in the same section.
    """
    for each in vocabulary.used_in(formula.sides[index], formula.sides[index + 1]):
        if each.role != "definition" and each.part != beside.part:
            return "a letter was given in another section, where it may mean something else"
    defined = all(each.role == "definition" for each in vocabulary.used_in(*formula.sides[index : index + 2]))
    if not (_is_said(beside, formula) or (index > 0 and defined)):
        return "no word says that it follows"
    return doubt_of(beside, formula, index, vocabulary)


def doubt_of(beside: Beside, formula: Parsed, index: int, vocabulary: Vocabulary) -> str:
    """Return why a relation that fails for some values need not be a contradiction; empty if it must be one."""
    left, right = formula.sides[index], formula.sides[index + 1]
    symbols = {*symbols_in(left), *symbols_in(right)}
    used = vocabulary.used_in(left, right)
    if formula.relations[index] == "≡":
        return "≡ may be a congruence or a condition"
    if formula.relations[index] in (":=", "=:"):
        return "it defines its letter again"
    if cases := [each.where for each in used if each.role == "case"]:
        return f"it rests on {cases[0]}, which may hold in one case only"
    if beside.condition:
        return "a condition stands beside it"
    lone = [tree for tree in (left, right) if defined_by(tree)[0]]
    within = bool(used) and not lone and all(each.place == beside.place for each in used)
    given = [each.symbol for each in used if each.explicit]
    if case := beside.case_within if within else beside.case(given):
        return f"the word {case!r} beside it may limit it to a case"
    if doubt := _doubt_of_reading((left, right, *(each.tree for each in used)), symbols):
        return doubt
    if doubt := _doubt_of_products(left, right, vocabulary) or doubt_of_special(left, right, vocabulary):
        return doubt
    if not any(map(vocabulary.letters_of, (left, right))):
        if _is_turned(left, right, vocabulary):
            return "its sides may be angles that differ by full turns"
        if word := strange_word(f"{beside.before} {beside.sentence} {beside.behind}", ()):
            return f"the word {word!r} beside it may mean another arithmetic, such as that of a clock"
    if others := [each.symbol for each, _ in taken_at_other_letters(vocabulary, left, right)]:
        return f"{vocabulary.name(others[0])} with other arguments may be another function"
    if formula.chose:
        return formula.chose
    unusable = sorted(s for s in symbols if s in vocabulary.definitions and not vocabulary.definitions[s].usable)
    if unusable:
        excess = vocabulary.excess_of(unusable[0])
        return f"{excess}{', so ' if excess else ''}{vocabulary.name(unusable[0])} {NOT_COMPUTED}"
    if within:
        return _doubt_of_letters(formula, index, vocabulary, used, chained=len(formula.sides) > 2)
    if used and (word := beside.strange(_operators(formula).union(*(each.words for each in used)))):
        return f"the word {word!r} beside it is new, so the equation may be about something else"
    for tree in lone:
        definition = vocabulary.definitions.get(defined_by(tree)[0])
        if definition is not None and not _is_meant(definition, beside, formula):
            return _other_meaning(definition, vocabulary)
    first = [vocabulary.definitions[each] for each in sorted(symbols) if each in vocabulary.definitions]
    if renamed := [each for each in first if bare_name(each.symbol) in beside.renamed]:
        return _other_meaning(renamed[0], vocabulary)
    if words_of(beside.sentence) and not lone and first and not any(_is_meant(each, beside, formula) for each in first):
        return _other_meaning(first[0], vocabulary)
    return _doubt_of_letters(formula, index, vocabulary, used, chained=len(formula.sides) > 2 and not lone)


def _doubt_of_reading(trees: tuple[Formula, ...], symbols: Iterable[str]) -> str:
    """Return what print may mean otherwise."""
    if not {"±", "∓"}.isdisjoint(token for tree in trees for token in tokens_in(tree)):
        return "± stands for two statements"
    if any("." in token for tree in trees[:2] for token in tokens_in(tree, "NUMBER")):
        return "its decimals may be rounded"
    if any(_has_mixed_number(tree) for tree in trees[:2]):
        return "a number before a fraction may be added to it, as in 1 1/2"
    if any(_has_logarithm(tree) for tree in trees):
        return "log may have another base than e"
    if any(_has_plain_angle(tree) for tree in trees[:2]):
        return "angles may be in degrees"
    imaginary = sorted(_IMAGINARY.intersection(symbols))
    return f"{imaginary[0]} may be the imaginary unit" if imaginary else ""


def _doubt_of_products(left: Formula, right: Formula, vocabulary: Vocabulary) -> str:
    """Return whether a product may be one in which the order matters: that of vectors, or of what anticommutes."""
    for tree in (left, right):
        for product in tree.find_data("product"):
            signs = [each for each in product.children if isinstance(each, Token)]
            letters = [each for factor in trees_in(product) for each in symbols_in(factor)]
            if r"\times" in signs and letters and not any(map(vocabulary.is_matrix, letters)):
                return "× may be the cross product of vectors"
    one, other = ([*symbols_in(each)] for each in (left, right))
    is_single = all(sum(1 for _ in each.find_data("sum")) <= 1 and _terms(each) == 1 for each in (left, right))
    return "the order of the factors may matter" if is_single and one != other and sorted(one) == sorted(other) else ""


def _terms(tree: Formula) -> int:
    return len(trees_in(tree)) if tree.data == "sum" else 1


def _is_turned(left: Formula, right: Formula, vocabulary: Vocabulary) -> bool:
    """Whether two numbers are not seen to differ but by full turns."""
    try:
        ours, theirs = (text(vocabulary.value(each)) for each in (left, right))
    except UNCOMPUTED:
        return False
    return may_agree(f"cos(({ours}) - ({theirs}))", "1")


def _doubt_of_letters(
    formula: Parsed, index: int, vocabulary: Vocabulary, used: list[Definition], *, chained: bool
) -> str:
    """Return whether letters are not given, so that an equation may be a condition or a new statement."""
    ours, theirs = map(vocabulary.letters_of, formula.sides[index : index + 2])
    if bool(ours) != bool(theirs):
        return A_CONDITION
    if chained and theirs <= ours and (index > 0 or ours <= theirs):
        return ""
    base = vocabulary.letters_of(*(each.tree for each in used))
    if not used and (ours or theirs):
        return NOT_GIVEN
    if new := sorted((ours | theirs) - base):
        return f"{vocabulary.name(new[0])} is not given by the definitions above it"
    return ""


def _is_meant(definition: Definition, beside: Beside, formula: Parsed) -> bool:
    """Whether a letter still has the meaning that it was given."""
    return definition.part == beside.part and (definition.explicit or _is_said(beside, formula))


def _is_said(beside: Beside, formula: Parsed) -> bool:
    """Whether an equation is said to follow, or its sentence names what is computed in it, as "its determinant"."""
    return beside.follows or bool(_operators(formula) & words_of(beside.sentence))


_NAMED = {
    "det": ("determinant",),
    "tr": ("trace",),
    "marked": ("transpose", "transposed"),
    "inverse": ("inverse",),
    "norm": ("norm", "length", "magnitude"),
    "'": ("derivative", "derivatives"),
}
"""The words that name what is computed."""


def _operators(formula: Parsed) -> frozenset[str]:
    """Return the words that name what is computed in a formula."""
    found = set[str]()
    for tree in (each for side in formula.sides for each in side.iter_subtrees()):
        head = str(tree.children[0]) if tree.children else ""
        if tree.data == "power" and tree.children[1] == _MINUS_ONE:
            found.add("inverse")
        found.add("'" if tree.data == "call" and "'" in head else head if tree.data == "function" else str(tree.data))
    return frozenset(word for each in found for word in _NAMED.get(each, ()))


def _other_meaning(definition: Definition, vocabulary: Vocabulary) -> str:
    return f"{vocabulary.name(definition.symbol)} is defined in {definition.where}; here it may mean something else"


def _has_mixed_number(tree: Formula) -> bool:
    r"""Whether a number stands before a fraction of numbers, as in ``1\frac12``."""
    return any(
        _is_number(one) and other.data == "fraction" and all(map(_is_number, other.children))
        for run in tree.find_data("run")
        for one, other in pairwise(run.children)
        if isinstance(other, Tree)
    )


def _is_number(tree: Any) -> bool:
    while tree.data == "group":
        (tree,) = tree.children
    return bool(tree.data == "number")


def _has_logarithm(tree: Formula) -> bool:
    functions = (*tree.find_data("function"), *tree.find_data("raised_function"))
    return any(each.children[0] == "log" for each in functions)


def _has_plain_angle(tree: Formula) -> bool:
    r"""Whether a number alone is an angle, as in ``\sin 30``."""
    functions = (*tree.find_data("function"), *tree.find_data("raised_function"))
    arguments = [trees_in(each)[-1] for each in functions if each.children[0] in ("sin", "cos", "tan", "cot")]
    return any(_is_number(part) for each in arguments for part in (each, *each.children[:1] * (each.data == "items")))
