"""Verdicts: what each equation of a document is, and what it rests on.

An equation *follows* if it is proved from the definitions and equations above it.  It *contradicts* only if it is
asserted of letters that are all given: see `_Reader._doubt`.  An equation that holds for some values and fails for
others is *independent*: it may be a new statement, a condition or another case.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import islice, pairwise
from typing import Any, Literal, get_args

import sympy
from lark import Token, Tree

from algebroproj_sym.expressions import TooLargeError, entries, evaluate, free_symbols, require_bounded, shape, text
from algebroproj_sym.proving import Outcome, Question, outcomes
from algebroproj_sym.proving.reals.prove import may_agree, often_agree
from algebroproj_sym.proving.reals.reading import term_of
from algebroproj_sym.reading.documents import Document
from algebroproj_sym.reading.grammar import Formula, Parsed, parsed, regrouped, symbols_in
from algebroproj_sym.reading.letters import has_shape, lettered
from algebroproj_sym.reading.lexing import UnreadableError, tokens_of
from algebroproj_sym.reading.phrases import properties_in, sizes_in
from algebroproj_sym.reading.premises import Premise, applicable, cited_in, crosses_in, derivatives_in, extended
from algebroproj_sym.reading.repairs import STRONG, Repair, repairs
from algebroproj_sym.reading.statements import Statement, inline_statements, statements
from algebroproj_sym.reading.symbols import SymbolsFile
from algebroproj_sym.reading.vocabulary import Definition, UnsizedError, Vocabulary
from algebroproj_sym.replaying.reals.terms import has_functions, written

Verdict = Literal["definition", "follows", "contradicts", "independent", "not decided", "not read"]
VERDICTS: tuple[Verdict, ...] = get_args(Verdict)

CASES = re.compile(
    r"\b(?:if|when|whenever|case|cases|assum\w+|suppose|approximat\w*|small|large|neglect\w*|limit\w*|either|roots?|wrong|"
    r"solutions?|otherwise|instead|special\w*|let|mod|modulo|convention|sign|opposite|alternative\w*|except|unless|"
    r"setting|choos\w+|solv\w+|equilibrium|condition\w*|requir\w+|impos\w+|vanish\w*|equation of)\b"
    r"|(?:for|with|at)\s+\$[^$]*=",
    re.IGNORECASE,
)
"""Words by which an equation may be about a case, so that it contradicts nothing."""
OTHERS = re.compile(r"\b(?:another|other|second|third|next|replac\w+|swap\w*|revers\w+|invers\w+)\b", re.IGNORECASE)
"""Words by which an equation may be about another thing than those above it."""
HENCE = re.compile(
    r"\b(?:hence|thus|therefore|so that|follows|consequently|we (?:get|obtain|find|have)|gives|yields|becomes|equals|"
    r"substituting|inserting|plugging|combining|rearranging|results? in|leads? to|simplif\w+|that is|in other words|"
    r"equivalently)\b",
    re.IGNORECASE,
)
"""Words by which an equation is said to follow from what is above it."""
DEFINES = re.compile(r"(?:\bwhere|\bwith|\bdefin\w+|\bdenot\w+|\blet|\bput|\bset|\bhere|\band|,)\W*$", re.IGNORECASE)
"""Words before an inline formula by which it is a definition."""
NOT_COMPUTED = "stands for is not computed"
MOST_REPAIRS = 8
MOST_REPAIRS_OF_LETTERS = 40
POINTS = (Fraction(3, 2), Fraction(-5, 3), Fraction(7, 5), Fraction(11, 4), Fraction(-13, 7))
NEAR = 250
"""How many characters beside a formula are searched for words about it."""
_LABELS = re.compile(r"\\(?:label|tag\*?)\s*\{[^{}]*\}")
_IMAGINARY = frozenset(("i", "j", r"\imath", r"\jmath", r"\mathbf{i}", r"\mathbf{j}"))
_E = Tree("symbol", [Token("SYMBOL", "e")])
_EQUALITIES = ("=", ":=", "=:", "≡")


Sides = tuple[Formula, Formula]


@dataclass(frozen=True)
class Link:
    """One relation of a chain.

    Attributes
    ----------
    verdict : str
        One of `VERDICTS`.
    reason : str
        Why it is not decided, or what else there is to say.
    rests_on : tuple of str
        Definitions, equations above it, derivatives, and words.
    hypotheses : tuple of str
        What is not zero where it holds.
    counterexample : mapping of str to str, or None
        A point at which the sides differ.
    suggestion : str
        The smallest change by which it would follow; empty for none.
    certificate : mapping or None
        The evidence.
    sides : tuple of str, or None
        Both sides as the prover had them, with all definitions put in, if a derivation can state them.
    corrected : str
        The right side with the suggested change, if it is one of the right side.
    """

    verdict: Verdict
    reason: str = ""
    rests_on: tuple[str, ...] = ()
    hypotheses: tuple[str, ...] = ()
    counterexample: Mapping[str, str] | None = None
    suggestion: str = ""
    certificate: Mapping[str, Any] | None = field(default=None, repr=False)
    sides: tuple[str, str] | None = field(default=None, repr=False)
    corrected: str = field(default="", repr=False)


@dataclass(frozen=True)
class Reading:
    """An equation of a document, what was understood, and its verdict.

    Attributes
    ----------
    line : int
        Where its display begins.
    number : str
        Its number, else its label, else empty.
    latex : str
        Its LaTeX.
    read : str or None
        What was understood.
    reason : str
        Where and why reading stopped, or why there is no decision.
    links : tuple of Link
        The relations, one after the other.
    statement : Statement
        Where it comes from.
    formula : Parsed or None
        What was parsed.
    """

    line: int
    number: str
    latex: str
    read: str | None
    reason: str
    links: tuple[Link, ...]
    statement: Statement
    formula: Parsed | None = None

    @property
    def verdict(self) -> Verdict:
        """The verdict: of several links, the one that matters most."""
        if self.read is None:
            return "not read"
        found = {link.verdict for link in self.links}
        order: tuple[Verdict, ...] = ("contradicts", "not decided", "independent", "definition", "follows")
        return next((verdict for verdict in order if verdict in found), "not decided")


@dataclass(frozen=True)
class _Way:
    """A way to take a link: its sides, what its letters stand for, and why it may not be meant if it fails so."""

    left: Formula
    right: Formula
    vocabulary: Vocabulary
    doubt: str = ""
    reads: str = ""

    @property
    def sides(self) -> Sides:
        return self.left, self.right


@dataclass
class _Asked:
    """A link that is yet to be decided: as it stands, and in other ways."""

    reading: int
    place: int
    ways: list[_Way]
    link: Link
    identity: bool
    certain: bool


def read_document(
    document: Document,
    given: SymbolsFile | None = None,
    *,
    seconds: float = 10.0,
    jobs: int = 1,
    lines: Collection[int] | None = None,
) -> list[Reading]:
    r"""Return the equations of a document, each with its verdict.

    Parameters
    ----------
    document : Document
        What was read from a file.
    given : SymbolsFile, optional
        What the user says of its letters.
    seconds : float
        How long the proof of one relation may take.
    jobs : int
        How many worker processes.
    lines : collection of int, optional
        The lines on which the equations begin that are to be decided; by default all are.

    Examples
    --------
    >>> from algebroproj_sym.reading import document_of
    >>> found = read_document(document_of(r"\[ s = a + b \] \[ s^2 = a^2 + 2ab + b^2 \]"))
    >>> [(each.read, each.verdict) for each in found]
    [('s = a + b', 'definition'), ('s**2 = a**2 + 2*a*b + b**2', 'follows')]
    """
    reader = _Reader(document, given or SymbolsFile())
    readings, asked = reader.first_pass()
    asked = [each for each in asked if lines is None or readings[each.reading].line in lines]
    _decide(asked, seconds, jobs)
    for each in asked:
        links = list(readings[each.reading].links)
        links[each.place] = each.link
        readings[each.reading] = replace(readings[each.reading], links=tuple(links))
    return _without_refuted_premises(readings)


def _without_refuted_premises(readings: Sequence[Reading]) -> list[Reading]:
    """Return readings in which nothing follows from an equation that contradicts."""
    found = list[Reading]()
    refuted = set[str]()
    for each in readings:
        links = tuple(
            replace(link, verdict="independent", reason=f"it follows only from {wrong[0]}, which contradicts")
            if link.verdict == "follows" and (wrong := [where for where in link.rests_on if where in refuted])
            else link
            for link in each.links
        )
        found.append(replace(each, links=links))
        if found[-1].verdict == "contradicts":
            number = each.statement.number or each.statement.label
            refuted.add(f"({number}), line {each.line}" if number else f"line {each.line}")
    return found


class _Reader:
    """Goes through a document once, and collects definitions and questions."""

    def __init__(self, document: Document, given: SymbolsFile) -> None:
        self.document = document
        self.given = given
        displayed = statements(document)
        inline = inline_statements(document)
        order = {id(each): place for place, each in enumerate(document.formulas)}
        self.all = sorted([*displayed, *inline], key=lambda each: order[id(each.display)])
        self.functions = self._functions()
        self.trees = {id(each): self._parsed(each) for each in self.all}
        sizes, properties = sizes_in(self.all), properties_in(self.all)
        self.vocabulary = Vocabulary(given.whole, sizes, self._matrices(), properties, euler=self._has_euler())
        self.seen: dict[str, int] = {}
        self.premises: list[Premise] = []
        self.occurring = frozenset(
            symbol
            for each in self.trees.values()
            if isinstance(each, Parsed)
            for side in each.sides
            for symbol in symbols_in(side)
        )
        words = (f"{each.before} {each.after}" for each in document.formulas)
        for definition in crosses_in(sorted(self.occurring), words):
            self.vocabulary.define(definition)

    # -- what is known of the whole document

    def _functions(self) -> frozenset[str]:
        """Return the letters that stand before a bracket with one letter, or with several values."""
        found = set[str]()
        for each in self.all:
            try:
                tokens, _ = tokens_of(each.pieces, lambda name: False, frozenset()) if each.pieces else ([], False)
            except UnreadableError:
                continue
            found |= {str(token) for token in tokens if token.type == "CALLEE"}
        return frozenset(found)

    def _parsed(self, statement: Statement) -> Parsed | UnreadableError:
        if not statement.pieces:
            return UnreadableError(statement.reason or "there is no formula")
        try:
            return parsed(statement.pieces, lambda name: name in self.given.whole.symbols, self.functions)
        except UnreadableError as error:
            return error

    def _matrices(self) -> frozenset[str]:
        """Return the symbols that have a mark of matrices somewhere, or of which there is a determinant or a trace."""
        found = set[str]()
        for formula in self.trees.values():
            for side in formula.sides if isinstance(formula, Parsed) else ():
                for tree in side.iter_subtrees() if isinstance(side, Tree) else ():
                    head = str(tree.children[-1 if tree.data == "marked" else 0]) if tree.children else ""
                    if tree.data == "marked" and not head.startswith("_"):
                        found |= {*_factors(tree.children[0])}
                    elif tree.data == "function" and head in ("det", "tr", "Tr", "trace", "adj"):
                        found |= {*_factors(tree.children[1])}
        return frozenset(found)

    def _has_euler(self) -> bool:
        """Whether e is Euler's number: the base of powers with letters, and nothing else."""
        powers, letters = list[bool](), 0
        for side in (side for each in self.trees.values() if isinstance(each, Parsed) for side in each.sides):
            letters += sum(1 for token in side.scan_values(lambda each: each == "e"))
            for power in side.find_data("power"):
                base, exponent = power.children
                if base == _E and isinstance(exponent, Tree):
                    powers.append(bool(symbols_in(exponent)))
        return len(powers) == letters and any(powers)

    # -- one statement after the other

    def first_pass(self) -> tuple[list[Reading], list[_Asked]]:
        readings: list[Reading] = []
        asked: list[_Asked] = []
        for statement in self.all:
            found = self.trees[id(statement)]
            if statement.display.environment == "inline":
                if isinstance(found, Parsed):
                    self._inline(statement, found)
                continue
            place = len(readings)
            reading, questions = self._displayed(statement, found, place)
            readings.append(reading)
            asked += questions
        return readings, asked

    def _where(self, statement: Statement) -> str:
        number = statement.number or statement.label
        line = f"line {statement.display.line}"
        return f"({number}), {line}" if number else line

    def _named(self, statement: Statement, names: frozenset[str]) -> bool:
        return bool(names & {statement.number, statement.label, f"line {statement.display.line}", "all"} - {""})

    def _inline(self, statement: Statement, formula: Parsed) -> None:
        symbols = [symbol for side in formula.sides for symbol in symbols_in(side)]
        if len(formula.sides) == 2 and formula.relations[0] in _EQUALITIES and DEFINES.search(statement.display.before):
            definition = self._definition(statement, formula, explicit=True, late=True)
            if definition is not None and definition.symbol not in self.vocabulary.definitions:
                self.vocabulary.define(definition)
        if len(formula.sides) > 1:
            for symbol in symbols:
                self.seen.setdefault(symbol, statement.display.line)

    def _displayed(
        self, statement: Statement, found: Parsed | UnreadableError, place: int
    ) -> tuple[Reading, list[_Asked]]:
        display = statement.display
        number = statement.number or statement.label
        if isinstance(found, UnreadableError):
            line = self.document.line_of(found.place) if found.place is not None else display.line
            reason = f"line {line}: {found}"
            return Reading(display.line, number, statement.latex, None, reason, (), statement), []
        sides = [self.vocabulary.text(side) for side in found.sides]
        read = sides[0] + "".join(
            f" {relation} {side}" for relation, side in zip(found.relations, sides[1:], strict=True)
        )
        links: list[Link] = []
        asked: list[_Asked] = []
        definition = self._definition(statement, found, explicit=False)
        for index, relation in enumerate(found.relations):
            if index == 0 and definition is not None:
                asked_of = _asked_of(self.vocabulary, definition.tree, definition.tree)
                both = _both(asked_of) if isinstance(asked_of, list) else None
                links.append(Link("definition", rests_on=self._rests(definition.tree), sides=both))
                continue
            link, question = self._link(statement, found, index, relation, place)
            links.append(link)
            if question is not None:
                asked.append(question)
        if not found.relations:
            links.append(Link("not decided", "it has no relation, so it states nothing"))
        if definition is not None:
            self.vocabulary.define(definition)
        else:
            self._assert(statement, found)
        for side in found.sides:
            for symbol in symbols_in(side):
                self.seen.setdefault(symbol, display.line)
        return Reading(display.line, number, statement.latex, read, "", tuple(links), statement, found), asked

    def _rests(self, *trees: Formula) -> tuple[str, ...]:
        return _rests_of(self.vocabulary, *trees)

    def _assert(self, statement: Statement, formula: Parsed) -> None:
        """Keep an equation with a lone letter as a premise of what stands behind it."""
        if not formula.relations or statement.condition or {*formula.relations} - {*_EQUALITIES}:
            return
        ends = (0, -1) if _defined(formula.sides[0])[0] else (-1, 0)
        symbol, parameters = _defined(formula.sides[ends[0]])
        if symbol and not parameters:
            value, display = formula.sides[ends[1]], statement.display
            given = Definition(symbol, (), value, self._where(statement), display.part, explicit=False)
            special = CASES.search(f"{display.before[-NEAR:]} {display.after[:NEAR]}") is not None
            names = frozenset((statement.number, statement.label)) - {""}
            self.premises.append(Premise(given, names, special))

    # -- definitions

    def _definition(
        self, statement: Statement, formula: Parsed, *, explicit: bool, late: bool = False
    ) -> Definition | None:
        """Return what a statement defines: a letter, or a function of letters, that was not used before."""
        if not formula.relations or formula.relations[0] not in _EQUALITIES:
            return None
        relation = formula.relations[0]
        left, right = formula.sides[:2] if relation != "=:" else (formula.sides[1], formula.sides[0])
        symbol, parameters = _defined(left)
        if not symbol or self._named(statement, self.given.statements) or symbol in self.given.whole.symbols:
            return None
        named = self._named(statement, self.given.definitions)
        explicit = explicit or relation in (":=", "=:") or named
        definition = self.vocabulary.definitions.get(symbol)
        used = symbol in self.seen and not late and not explicit
        if used or definition is not None or symbol in symbols_in(right):
            return None
        if any(each.symbol == symbol for each in self.vocabulary.used_in(right)):
            return None
        if symbol in self.vocabulary.letters_of(right):
            return None
        if not explicit and derivatives_in((left,), self.vocabulary, self.occurring):
            return None
        usable = not statement.condition and formula.relations[0] in _EQUALITIES
        where, part = self._where(statement), statement.display.part
        made = Definition(symbol, parameters, right, where, part, explicit, usable)
        return replace(made, usable=usable and self._computes(made))

    def _computes(self, definition: Definition) -> bool:
        if definition.parameters:
            return True
        try:
            require_bounded(self.vocabulary.value(definition.tree), definition.symbol)
        except (UnreadableError, ZeroDivisionError, TypeError, ValueError, RecursionError):
            return has_shape(self.vocabulary, definition.tree)
        return True

    # -- relations

    def _link(
        self, statement: Statement, formula: Parsed, index: int, relation: str, place: int
    ) -> tuple[Link, _Asked | None]:
        left, right = formula.sides[index], formula.sides[index + 1]
        rests = self._rests(left, right)
        if relation not in _EQUALITIES:
            return Link("not decided", f"the relation {relation} is read, and not decided", rests), None
        doubt = self._doubt(statement, formula, index)
        letters = self.vocabulary.letters_of(left) | self.vocabulary.letters_of(right)
        identity = self._named(statement, self.given.identities) or (relation == "≡" and bool(letters))
        certain = not letters and all(each.explicit for tree in (left, right) for each in self.vocabulary.used_in(tree))
        vocabulary = self.vocabulary.copied()
        others = [*_other_readings(left, right), *self._narrow(statement, formula, index)]
        ways = [
            _Way(left, right, vocabulary, doubt),
            *(_Way(*each, vocabulary, reads=" = ".join(map(vocabulary.text, each))) for each in others),
            *self._with_premises(statement, formula, index, vocabulary),
        ]
        asked = _Asked(place, index, ways, Link("not decided", rests_on=rests), identity, certain)
        return asked.link, asked

    def _with_premises(
        self, statement: Statement, formula: Parsed, index: int, vocabulary: Vocabulary
    ) -> Iterator[_Way]:
        """Yield the ways to take a relation that rest on equations above it, and on derivatives."""
        left, right = formula.sides[index], formula.sides[index + 1]
        found = [*applicable(self.premises, cited_in(statement.display.before))]
        seen = [tuple(map(id, _used(vocabulary, left, right)))]
        plain = frozenset(symbols_in(left)) if _defined(left)[0] else frozenset[str]()
        for premises in ([each for each in found if each.gives.symbol not in plain], found):
            known = extended(vocabulary, [each.gives for each in premises])
            for slopes in (False, True):
                if slopes:
                    made = derivatives_in((left, right), known, self.occurring)
                    known = extended(known, made)
                used = _used(known, left, right)
                if (ids := tuple(map(id, used))) not in seen:
                    seen.append(ids)
                    yield _Way(left, right, known, self._doubt_of_premises(statement, formula, index, known))

    def _doubt_of_premises(self, statement: Statement, formula: Parsed, index: int, vocabulary: Vocabulary) -> str:
        """Return why an equation that fails under its premises need not contradict them.

        It must follow from them by its own words, and they must be in the same section.
        """
        used = _used(vocabulary, formula.sides[index], formula.sides[index + 1])
        elsewhere = {id(each.gives) for each in self.premises if each.gives.part != statement.display.part}
        if any(id(each) in elsewhere for each in used):
            return "a letter may have another meaning where it was given"
        if HENCE.search(_last_sentence(statement.display.before)) is None:
            return "it is not said to follow"
        return self._doubt(statement, formula, index, vocabulary)

    def _narrow(self, statement: Statement, formula: Parsed, index: int) -> Iterator[tuple[Formula, Formula]]:
        """Yield a relation with the arguments of functions as short as possible, where LaTeX leaves that open."""
        if formula.chose:
            known = lambda name: name in self.given.whole.symbols  # noqa: E731
            narrow = parsed(statement.pieces, known, self.functions, wide_arguments=False)
            yield narrow.sides[index], narrow.sides[index + 1]

    def _doubt(self, statement: Statement, formula: Parsed, index: int, vocabulary: Vocabulary | None = None) -> str:
        """Return why a relation that fails for some values need not be a contradiction; empty if it must be one.

        It must be one if its letters are all given: by definitions above it or, in a chain, by the side before.  It may
        not stand beside words that speak of a case, and it may not be a new definition of a letter, or a condition.
        """
        vocabulary = vocabulary or self.vocabulary
        left, right = formula.sides[index], formula.sides[index + 1]
        before = statement.display.before[-NEAR:]
        ended = _LABELS.sub("", statement.display.latex).rstrip().endswith(".")
        behind = "" if ended else re.split(r"[.]\s", statement.display.after)[0][:NEAR]
        words = f"{before} {statement.condition} {behind}"
        symbols = {*symbols_in(left), *symbols_in(right)}
        used = [each for tree in (left, right) for each in vocabulary.used_in(tree)]
        if formula.relations[index] == "≡":
            return "it may be a congruence"
        if statement.condition:
            return "it stands beside a condition"
        if found := CASES.search(words):
            return f"the word {' '.join(found.group().split())[:20]!r} beside it may limit it to a case"
        if any("." in token for tree in (left, right) for token in _numbers(tree)):
            return "its decimals may be rounded"
        if any(_has_mixed_number(tree) for tree in (left, right)):
            return "a number before a fraction may be added to it"
        if any(_has_logarithm(tree) for tree in (left, right, *(each.tree for each in used))):
            return "log may have another base"
        if imaginary := sorted(symbols & _IMAGINARY):
            return f"{imaginary[0]} may be the imaginary unit"
        if formula.chose:
            return formula.chose
        unusable = sorted(s for s in symbols if s in vocabulary.definitions and not vocabulary.definitions[s].usable)
        if unusable:
            return f"what {vocabulary.name(unusable[0])} {NOT_COMPUTED}"
        if used and (found := OTHERS.search(words)):
            return f"the word {found.group()!r} beside it may speak of another thing"
        lone = [tree for tree in (left, right) if _defined(tree)[0]]
        for tree in lone:
            definition = vocabulary.definitions.get(_defined(tree)[0])
            if definition is not None and not self._is_meant(definition, statement, before):
                name = vocabulary.name(definition.symbol)
                return f"{name} is defined in {definition.where}; here it may mean something else"
        first = [vocabulary.definitions[each] for each in sorted(symbols) if each in vocabulary.definitions]
        said = re.search(r"[^\W\d_]{2}", _last_sentence(before))
        if said and not lone and first and not any(self._is_meant(each, statement, before) for each in first):
            name = vocabulary.name(first[0].symbol)
            return f"{name} is defined in {first[0].where}; here it may mean something else"
        ours, theirs = vocabulary.letters_of(left), vocabulary.letters_of(right)
        if bool(ours) != bool(theirs):
            return "it may be a condition"
        chained = len(formula.sides) > 2 and not lone
        if chained and theirs <= ours and (index > 0 or ours <= theirs):
            return ""
        base = frozenset(letter for each in used for letter in vocabulary.letters_of(each.tree))
        if not used and (ours or theirs):
            return "its letters are defined nowhere above it"
        if new := sorted((ours | theirs) - base):
            return f"{vocabulary.name(new[0])} is not given by the definitions above it"
        return ""

    def _is_meant(self, definition: Definition, statement: Statement, before: str) -> bool:
        """Whether a letter still has the meaning that it was given."""
        return definition.part == statement.display.part and (
            definition.explicit or HENCE.search(_last_sentence(before)) is not None
        )


def _used(vocabulary: Vocabulary, *trees: Formula) -> list[Definition]:
    return [each for tree in trees for each in vocabulary.used_in(tree)]


def _rests_of(vocabulary: Vocabulary, *trees: Formula) -> tuple[str, ...]:
    return tuple(dict.fromkeys(each.where for each in _used(vocabulary, *trees)))


def _last_sentence(words: str) -> str:
    return re.split(r"[.!?]\s+(?=[A-Z\\])|\n\s*\n", words.rstrip())[-1]


def _factors(tree: Any) -> Iterator[str]:
    """Yield the letters of a sum or product of letters alone."""
    if tree.data == "symbol":
        yield str(tree.children[0])
    elif tree.data in ("run", "product", "sum", "group") or (
        tree.data in ("bracket", "items") and len(tree.children) == 1
    ):
        for part in tree.children:
            if isinstance(part, Tree):
                yield from _factors(part)


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


def _numbers(tree: Formula) -> list[str]:
    return [str(each) for each in tree.scan_values(lambda each: isinstance(each, Token) and each.type == "NUMBER")]


def _defined(tree: Formula) -> tuple[str, tuple[str, ...]]:
    """Return the letter that is a side of its own, and its parameters if it is a function of letters."""
    if tree.data == "symbol":
        return str(tree.children[0]), ()
    if tree.data == "call":
        name, arguments = tree.children
        inside = arguments.children if isinstance(arguments, Tree) else []
        parameters = [_defined(each)[0] if isinstance(each, Tree) else "" for each in inside]
        if all(parameters) and len({*parameters}) == len(parameters):
            return str(name), tuple(parameters)
    return "", ()


def _other_readings(left: Formula, right: Formula) -> Iterator[tuple[Formula, Formula]]:
    """Yield a relation with the slash before a product as a factor of it, where it has one."""
    others = regrouped(left), regrouped(right)
    if others != (left, right):
        yield others


def questions_of(vocabulary: Vocabulary, left: Formula, right: Formula) -> list[Question]:
    """Return the question whether two sides are equal; of matrices with real functions, one for each entry.

    Raises
    ------
    UnreadableError
        If a side is no expression, or their shapes differ.
    """
    if any(vocabulary.properties_of(symbol) for tree in (left, right) for symbol in vocabulary.letters_of(tree)):
        raise UnsizedError("a property of a letter says more than its entries")
    values = [vocabulary.value(tree) for tree in (left, right)]
    shapes = [shape(value) for value in values]
    if shapes[0] != shapes[1]:
        for place, other in ((0, 1), (1, 0)):
            if values[place] == 0 and shapes[other]:
                values[place] = values[other].zeros(*values[other].shape)
            elif (
                shapes[place]
                and shapes[other]
                and values[place].shape == values[other].shape[::-1]
                and values[place].rows == 1
            ):
                values[place] = values[place].T
    if shape(values[0]) != shape(values[1]):
        raise UnreadableError(f"the sides have shapes {shapes[0] or 'of numbers'} and {shapes[1] or 'of numbers'}")
    for value in values:
        require_bounded(value, "the equation")
        if value.has(sympy.I, sympy.zoo, sympy.nan, sympy.oo, -sympy.oo):
            raise UnreadableError("a value is no real number")
    if shape(values[0]) and any(map(_is_elementary, values)):
        return [Question(_text(one), _text(other)) for one, other in zip(*map(entries, values), strict=True)]
    return [Question(_text(values[0]), _text(values[1]))]


def _is_elementary(value: Any) -> bool:
    """Whether an entry has a real function or number that is not rational."""
    return any(has_functions(text(entry)) or entry.atoms(sympy.NumberSymbol) for entry in entries(value))


def _text(value: Any) -> str:
    """Return text in which no number looks like a letter: exp(1) is no E."""
    return written(term_of(value, "the equation")) if value.atoms(type(sympy.E)) else text(value)


def _asked_of(vocabulary: Vocabulary, left: Formula, right: Formula) -> list[Question] | str:
    """Return the questions, or why there are none."""
    try:
        return questions_of(vocabulary, left, right)
    except UnreadableError as unread:
        try:
            return [lettered(vocabulary, left, right)]
        except (UnreadableError, RecursionError) as error:
            return str(error if isinstance(unread, UnsizedError) else unread).partition("\n")[0][:200]
    except (TooLargeError, ZeroDivisionError, TypeError, ValueError, RecursionError) as error:
        return str(error).partition("\n")[0][:200] or type(error).__name__


def _decide(asked: Sequence[_Asked], seconds: float, jobs: int) -> None:
    """Decide every link, first as it stands, then in other ways, then with single changes."""
    answers = _answers([way for each in asked for way in each.ways], seconds, jobs)
    failing: list[tuple[_Asked, _Way, Outcome]] = []
    for each in asked:
        answered = [answers.pop(0) for _ in each.ways]
        place = next((i for i, (_, answer) in enumerate(answered) if answer.verdict == "proved"), 0)
        question, outcome = answered[place]
        each.link = replace(_link_of(each, outcome, each.ways[place]), sides=question)
        if each.link.verdict != "follows":
            refuted = [(way, answer) for way, (_, answer) in zip(each.ways, answered, strict=True)]
            failing += [(each, way, answer) for way, answer in refuted if answer.verdict == "refuted" and not way.reads]
    candidates = [_likely_repairs(way) for _, way, _ in failing]
    answers = _answers([way for found in candidates for _, way in found], seconds, jobs)
    for (each, way, refutation), changes in zip(failing, candidates, strict=True):
        tried = [(repair, changed, *answers.pop(0)) for repair, changed in changes]
        best = next((found for found in tried if found[3].verdict == "proved"), None)
        link = _refuted(each, way, refutation, best[0] if best else None, best[1] if best else way)
        if best and best[2] and best[1].left is way.left:
            link = replace(link, corrected=best[2][1])
        if way is each.ways[0] or (link.verdict == "contradicts" != each.link.verdict):
            each.link = link


def _answers(ways: Sequence[_Way], seconds: float, jobs: int) -> list[tuple[tuple[str, str] | None, Outcome]]:
    """Return each pair of sides as text with its outcome; one that cannot be asked is open."""
    asked = [_asked_of(each.vocabulary, *each.sides) for each in ways]
    questions = [question for group in asked if isinstance(group, list) for question in group]
    decided = outcomes(questions, seconds=seconds, jobs=min(jobs, len(questions))) if questions else iter(())
    return [
        (_both(each), _with_letters(each[0], _of_entries([*islice(decided, len(each))])))
        if isinstance(each, list)
        else (None, Outcome("open", "none", 0.0, each))
        for each in asked
    ]


def _with_letters(question: Question, outcome: Outcome) -> Outcome:
    """Return an outcome with what its letters are taken for among its hypotheses."""
    taken = tuple(f"{name} is {text}" for name, text in (question.letters or {}).items())
    return replace(outcome, hypotheses=(*outcome.hypotheses, *taken))


def _both(questions: Sequence[Question]) -> tuple[str, str] | None:
    """Return the sides as a derivation states them; none if they have real functions, which it does not."""
    sides = questions[0].lhs, questions[0].rhs
    plain = len(questions) == 1 and questions[0].letters is None
    return sides if plain and not any(map(has_functions, sides)) else None


def _of_entries(found: Sequence[Outcome]) -> Outcome:
    """Return what the outcomes of all entries come to."""
    if len(found) == 1:
        return found[0]
    decisive = next((each for each in found if each.verdict == "refuted"), None)
    decisive = decisive or next((each for each in found if each.verdict != "proved"), None)
    if decisive is not None:
        return decisive
    hypotheses = tuple(dict.fromkeys(name for each in found for name in each.hypotheses))
    certificate = {"method": "entries", "entries": [each.certificate for each in found]}
    return Outcome("proved", "entries", sum(each.seconds for each in found), "", hypotheses, None, certificate)


def _likely_repairs(way: _Way) -> list[tuple[Repair, _Way]]:
    """Return the changes after which the sides agree at some points."""
    vocabulary, left, right = way.vocabulary, way.left, way.right
    used = _used(vocabulary, left, right)
    symbols = {symbol for tree in (left, right, *(each.tree for each in used)) for symbol in symbols_in(tree)}
    changes = [(each, replace(way, right=each.formula)) for each in repairs(right, symbols)]
    changes += [(each, replace(way, left=each.formula)) for each in repairs(left, symbols)]
    found = sorted(changes, key=lambda pair: pair[0].kind not in STRONG)
    changed = [pair for pair in found if pair[1].left != pair[1].right]
    if _is_lettered(way):
        return changed[:MOST_REPAIRS_OF_LETTERS]
    return [*islice((pair for pair in changed if _agree(vocabulary, pair[1].sides)), MOST_REPAIRS)]


def _is_lettered(way: _Way) -> bool:
    questions = _asked_of(way.vocabulary, *way.sides)
    return isinstance(questions, list) and questions[0].letters is not None


def _agree(vocabulary: Vocabulary, sides: Sides) -> bool:
    """Whether two sides agree at some points at which they are defined."""
    try:
        values = [vocabulary.value(side) for side in sides]
        if any(map(_is_elementary, values)):
            return all(may_agree(each.lhs, each.rhs) for each in questions_of(vocabulary, *sides))
        names = sorted({symbol for value in values for symbol in free_symbols(value)}, key=str)
        for seed in range(len(POINTS)):
            point = {name: POINTS[(seed + place) % len(POINTS)] + place for place, name in enumerate(names)}
            left, right = (evaluate(value, point) for value in values)
            if len(left) != len(right) or any(a != b for a, b in zip(left, right, strict=True)):
                return False
    except (UnreadableError, ZeroDivisionError, TypeError, ValueError, AttributeError, OverflowError):
        return False
    return True


def _doubt_of_refutation(way: _Way) -> str:
    """Return why sides that differ at a point may still be meant to be equal; empty for no reason."""
    questions = _asked_of(way.vocabulary, *way.sides)
    assert isinstance(questions, list)
    letters = questions[0].letters
    if letters is not None:
        if any(re.search(r"[a-z]x|x[a-z]", text.partition(" ")[0]) for text in letters.values()):
            return "the sizes of its letters are not stated"
        values = any("'" in text for _, text in questions[0].named_texts)
        return f"what a function, a sum or an integral in it {NOT_COMPUTED}" if values else ""
    elementary = [each for each in questions if has_functions(each.lhs) or has_functions(each.rhs)]
    positive = bool(elementary) and all(often_agree(each.lhs, each.rhs) for each in elementary)
    return "it holds where its letters are positive" if positive else ""


def _link_of(asked: _Asked, outcome: Outcome, way: _Way) -> Link:
    """Return the verdict of a link, as far as it is decided without changes."""
    link = asked.link
    if outcome.verdict == "proved":
        return replace(
            link,
            verdict="follows",
            reason=f"read as {way.reads}" if way.reads else "",
            rests_on=_rests_of(way.vocabulary, *way.sides),
            hypotheses=outcome.hypotheses,
            certificate=outcome.certificate,
        )
    return replace(link, reason=("the prover does not take it: " if outcome.unreadable else "") + outcome.reason)


def _holds_beside(way: _Way, repaired: _Way) -> bool:
    """Whether two entries with letters hold, and a change that makes all hold does not concern them."""
    if _is_lettered(way):
        return False
    before, after = ([*map(entries, map(way.vocabulary.value, each.sides))] for each in (way, repaired))
    same = [a for a, b, c, d in zip(*before, *after, strict=True) if (a, b) == (c, d) and free_symbols(a)]
    return len(same) >= 2


def _refuted(asked: _Asked, way: _Way, refutation: Outcome, repair: Repair | None, repaired: _Way) -> Link:
    """Return the verdict of a link that fails at a point, and of the smallest change by which it would follow."""
    suggestion = ""
    if repair is not None:
        now, before = (way.vocabulary.text(tree) for tree in (repair.now, repair.before))
        suggestion = f"{now} instead of {before}"
    doubt = _doubt_of_refutation(way)
    doubt = doubt if doubt.endswith(NOT_COMPUTED) else way.doubt or doubt
    plain = way is asked.ways[0]
    certain = (plain and asked.certain) or (
        repair is not None and (repair.kind in STRONG or (repair.kind == "letter" and _holds_beside(way, repaired)))
    )
    asserted = (certain and not doubt) or (plain and asked.identity and not (doubt and _is_lettered(way)))
    reason = "" if asserted else doubt or "it holds for some values of its letters, and not for all"
    undecided = doubt.endswith(NOT_COMPUTED)
    return replace(
        asked.link,
        verdict="contradicts" if asserted else "not decided" if undecided else "independent",
        reason=reason,
        rests_on=_rests_of(way.vocabulary, *way.sides),
        counterexample=refutation.counterexample,
        suggestion=suggestion,
        certificate=refutation.certificate,
    )
