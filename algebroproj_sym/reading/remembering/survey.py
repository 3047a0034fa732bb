"""What is known of a whole document before its equations are read in order."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

from lark import Token, Tree

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.dependence import (
    Dependence,
    Tie,
    index_of,
    letters_in,
    letters_of_symbol,
    ties_of,
)
from algebroproj_sym.reading.defining.kinds import Kinds
from algebroproj_sym.reading.defining.labels import (
    E,
    has_euler,
    has_gamma_integral,
    iterates_in,
    labels_in,
    lone_letter,
    without_above,
)
from algebroproj_sym.reading.defining.premises import crosses_in
from algebroproj_sym.reading.defining.recognising import EQUALITIES, defined_by, introduced_by
from algebroproj_sym.reading.defining.symbols import SymbolsFile
from algebroproj_sym.reading.defining.tensors import speaks_of_tensors, with_traces
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.arguments import lone_arguments, omits_arguments, with_plain_arguments
from algebroproj_sym.reading.deriving.crossed import crossed_in
from algebroproj_sym.reading.deriving.entries import entries_in
from algebroproj_sym.reading.deriving.indices import Indices
from algebroproj_sym.reading.deriving.quaternions import quaternions_in
from algebroproj_sym.reading.deriving.summation import indices_in, is_in_index_notation
from algebroproj_sym.reading.documents.displays import Document
from algebroproj_sym.reading.documents.naming import named
from algebroproj_sym.reading.documents.statements import Statement, inline_statements, statements
from algebroproj_sym.reading.documents.underlining import are_tensors, in_bold
from algebroproj_sym.reading.lexing.commands import MARKS, RELATIONS
from algebroproj_sym.reading.lexing.names import OF_CHANCE, OFTEN_FUNCTION, split_symbol
from algebroproj_sym.reading.lexing.pieces import UnreadableError, bare, split_pieces
from algebroproj_sym.reading.lexing.tokens import tokens_of
from algebroproj_sym.reading.parsing.grammar import Formula, Parsed, Sides, lone, parsed, put_in, symbols_in
from algebroproj_sym.reading.parsing.operators import Applied, Operators, operators_in, with_operators
from algebroproj_sym.reading.parsing.tildes import crossed_by_tildes, with_crosses
from algebroproj_sym.reading.parsing.transposes import are_transposes, with_rows_apart, with_transposes
from algebroproj_sym.reading.prose.acting import acted_on
from algebroproj_sym.reading.prose.describing import described
from algebroproj_sym.reading.prose.devices import heard, says
from algebroproj_sym.reading.prose.inner import is_given
from algebroproj_sym.reading.prose.meanings import (
    Meanings,
    axes_turn,
    dependences,
    functions_called,
    has_superscripts,
    prose_of,
)
from algebroproj_sym.reading.prose.numbers import has_gamma_function, wholes_in
from algebroproj_sym.reading.prose.phrases import (
    called,
    complexes_in,
    constants_in,
    properties_in,
    reals_in,
    sizes_in,
)
from algebroproj_sym.reading.prose.words import beside
from algebroproj_sym.reading.remembering.sections import kinds_by_section, kinds_in


@dataclass(frozen=True)
class Survey:
    """A document, and what the user says of its letters."""

    document: Document
    """What was read from a file."""
    given: SymbolsFile
    """What the user says."""

    @cached_property
    def statements(self) -> tuple[Statement, ...]:
        """All statements in the order of the document, also those within the text."""
        order = {id(each): place for place, each in enumerate(self.document.formulas)}
        every = named([*statements(self.document), *inline_statements(self.document)])
        if speaks_of_tensors(prose_of(every)) and are_tensors(every):
            every = [replace(each, pieces=in_bold(each.pieces)) for each in every]
        return tuple(sorted(every, key=lambda each: order[id(each.display)]))

    @cached_property
    def _prose(self) -> str:
        return prose_of(self.statements)

    def says(self, form: str) -> bool:
        """Whether the text has words of a form, as for `says`."""
        return says(form, self._prose)

    @cached_property
    def functions(self) -> frozenset[str]:
        r"""The letters that stand before a bracket with one letter, a zero, or several values.

        ``\delta`` before any bracket is among them if it stands nowhere alone.

        So are letters with nothing but the value of a function in their brackets, as f and g in ``f(g(h(x)))``, if they
        stand nowhere alone.

        Where ``x[n]`` or ``x[0]`` has an index in square brackets, all letters before these brackets are among them.
        """
        found, nested, before, lone, indexed = set[str](), set[str](), set[str](), set[str](), False
        for each in self.statements:
            try:
                tokens, _ = tokens_of(each.pieces, lambda name: False, frozenset()) if each.pieces else ([], False)
            except UnreadableError:
                continue
            found |= {str(token) for token in tokens if token.type == "CALLEE"}
            pairs = [(one, other) for one, other in pairwise([*tokens, None]) if one]
            found |= {
                str(one) for one, other in pairs if other and other.type == "LP" and OFTEN_FUNCTION.fullmatch(one)
            }
            nested |= {*_nested(tokens)}
            nested |= {str(one) for one, other in pairs if other and other.type == "LS" and one.startswith("P_")}
            lone |= {str(one) for one, other in pairs if not (other and other.type in ("LP", "LS"))}
            squared = [(one.type, str(one)) for one, other in pairwise(tokens) if other.type == "LS"]
            before |= {letter for kind, letter in squared if kind in ("SYMBOL", "CALLEE")}
            called = [letter for kind, letter in squared if kind == "CALLEE" and letter not in "EPV"]
            indexed = indexed or not all(map(OF_CHANCE.fullmatch, called))
        found = {each for each in found if not (each in lone and OFTEN_FUNCTION.fullmatch(each))} | (nested - lone)
        return functions_called(self.statements).union(found, before if indexed else ())

    def is_parameter(self, statement: Statement) -> bool:
        """Whether a statement gives a letter a number, as others of its display do: a list of parameters."""
        return self._numbers.get(id(statement.display), 0) > 1 and not statement.condition

    @cached_property
    def _numbers(self) -> dict[int, int]:
        found: dict[int, int] = {}
        for each in self.statements:
            formula = self.formulas[id(each)]
            if isinstance(formula, Parsed) and formula.relations == ("=",):
                one, other = formula.sides
                if defined_by(one)[0] and not defined_by(one)[1] and not [*symbols_in(other)]:
                    found[id(each.display)] = found.get(id(each.display), 0) + 1
        return found

    def has_one_argument(self, function: str) -> bool:
        """Whether a function is taken at one argument in the whole document, and stands nowhere without it.

        A derivative is no function of its own.
        """
        return (
            "'" not in function
            and len(self._arguments.get(function, ())) == 1
            and function not in self._without_arguments
        )

    def are_variables(self, letters: Collection[str]) -> bool:
        """Whether letters stand for any value: several functions are taken at each, or one is the rate of another."""
        if any(rf"\dot{{{each}}}" in letters for each in letters):
            return True
        bare = all(re.fullmatch(r"\\?[a-zA-Z]+", each) for each in letters)
        return bool(letters) and bare and all(len(self._taken_at.get(each, ())) > 1 for each in letters)

    @cached_property
    def _taken_at(self) -> dict[str, set[str]]:
        """The functions that are taken at each letter."""
        found: dict[str, set[str]] = {}
        for function, calls in self._arguments.items():
            for letter in (each for call in calls for each in defined_by(call)[1]):
                found.setdefault(letter, set()).add(function.replace("'", ""))
        return found

    @cached_property
    def _without_arguments(self) -> frozenset[str]:
        return frozenset(str(tree.children[0]) for side in self._sides for tree in side.find_data("symbol"))

    @cached_property
    def _arguments(self) -> dict[str, set[Formula]]:
        found: dict[str, set[Formula]] = {}
        for side in self._sides:
            for call in side.find_data("call"):
                found.setdefault(str(call.children[0]), set()).add(call)
        return found

    @cached_property
    def lone_arguments(self) -> Mapping[str, str]:
        """The functions that may be the same with and without their arguments, with these, separated by spaces."""
        return lone_arguments((each.sides for each in self._read), self._prose)

    @cached_property
    def omits_arguments(self) -> bool:
        """Whether words say that functions are written without their arguments."""
        return omits_arguments(self._prose)

    @cached_property
    def _first(self) -> dict[int, Parsed | UnreadableError]:
        return {id(each): self._parsed(each, frozenset(), plain=True) for each in self.statements}

    @cached_property
    def _has_transposes(self) -> bool:
        """Whether primes transpose."""
        return are_transposes(self._first_equations, self._prose)

    @cached_property
    def _tildes(self) -> Mapping[str, str]:
        """The letters with a tilde that are matrices of cross products, with the vectors."""
        return crossed_by_tildes(self._first_equations)

    @cached_property
    def operators(self) -> Operators | None:
        """Which operators there are that are applied to something."""
        return operators_in(self._first_equations)

    @cached_property
    def applied(self) -> Mapping[str, Applied]:
        """The letters of operators with what these are applied to."""
        return self.operators.applied if self.operators and self.formulas else {}

    @cached_property
    def labels(self) -> frozenset[str]:
        r"""The letters with a label above: ``p^h`` with one that stands nowhere else, and iterates ``x^{k+1}``."""
        return labels_in(self._first_equations)

    @property
    def _first_equations(self) -> list[Sides]:
        return [each.sides for each in self._first.values() if isinstance(each, Parsed)]

    @cached_property
    def formulas(self) -> Mapping[int, Parsed | UnreadableError]:
        """What was parsed of each statement, by its id."""
        found = self._first
        if self.labels or self._has_transposes or self._tildes or self.operators:
            found = {id(each): self._parsed(each, self.labels) for each in self.statements}
        plain = with_plain_arguments([each.sides for each in found.values() if isinstance(each, Parsed)])
        if not plain:
            return found
        return {
            each: replace(formula, sides=tuple(put_in(side, plain) for side in formula.sides))
            if isinstance(formula, Parsed)
            else formula
            for each, formula in found.items()
        }

    @cached_property
    def _read(self) -> list[Parsed]:
        """The statements that were parsed."""
        return [each for each in self.formulas.values() if isinstance(each, Parsed)]

    @property
    def _sides(self) -> Iterator[Formula]:
        """The sides of these."""
        return (side for each in self._read for side in each.sides if isinstance(side, Tree))

    def _parsed(self, statement: Statement, labels: frozenset[str], *, plain: bool = False) -> Parsed | UnreadableError:
        if not statement.pieces:
            return UnreadableError(statement.reason or "there is no formula")
        try:
            return self.parsed(statement, labels, plain=plain)
        except UnreadableError as error:
            return error

    def parsed(
        self, statement: Statement, labels: frozenset[str] | None = None, *, wide: bool = True, plain: bool = False
    ) -> Parsed:
        """Parse a statement; a plain one keeps primes that transpose.  What is no formula is an `UnreadableError`."""
        own = self.labels if labels is None else labels
        known = self.given.whole.symbols
        named = self._has_superscripts
        is_name = lambda name: name in known or name in own or (named and _has_index(name))  # noqa: E731
        found = parsed(statement.pieces, is_name, self.functions, wide)
        found = with_traces(found) if self.has_tensors_of_three_rows else found
        found = with_rows_apart(found if plain or not self._has_transposes else with_transposes(found))
        if not plain and self._tildes:
            found = with_crosses(found, self._tildes)
        if not plain and self.operators:
            found = with_operators(found, self.operators)
        return found

    def left_of(self, statement: Statement) -> frozenset[str]:
        """Return the letters on the left of a statement that cannot be read: it may give them."""
        relations = tuple(sign for sign, meaning in RELATIONS.items() if meaning in EQUALITIES)
        left, *right = split_pieces(statement.pieces, relations)
        try:
            found = self.parsed(replace(statement, pieces=tuple(left))) if right and left else None
        except UnreadableError:
            return frozenset()
        return introduced_by(found.sides[0]) if found else frozenset()

    @cached_property
    def _has_superscripts(self) -> bool:
        return has_superscripts(self._prose)

    @cached_property
    def occurring(self) -> frozenset[str]:
        """The symbols of the document."""
        return frozenset(symbol for side in self._sides for symbol in symbols_in(side))

    @cached_property
    def dependence(self) -> Dependence:
        """What the document says of the letters that may depend on each other."""
        ties: list[Tie] = []
        before = set[str]()
        for formula in self._read:
            if not {*EQUALITIES}.isdisjoint(formula.relations):
                sides = formula.sides if formula.relations[0] != "=:" else formula.sides[::-1]
                ties += ties_of(*defined_by(sides[0]), sides, before)
        ties += (Tie(letter, frozenset((other,)), True) for letter, other in dependences(self._prose))
        steps = self.indices.counted
        ties += (Tie(letter, steps, True) for letter in sorted(acted_on(self._prose, stepwise=True)) if steps)
        ties += (
            Tie(letter, frozenset(of), True)
            for each in self._read
            if len(each.sides) == 1
            for letter, of in (defined_by(each.sides[0]),)
            if of
        )
        by_time = "t" in called(self.statements, "time") or any(each.endswith("/dt") for each in self.occurring)
        by_time = by_time or "t" in {symbol for each in self._read for symbol in _turning(each)}
        own = {name: defined_by(next(iter(of)))[1] for name, of in self._arguments.items() if len(of) == 1}
        time = ("t",) if self.says("<of-time>") else ()
        arguments = {name: of + time if of and "t" not in of else of for name, of in own.items()}
        return Dependence(tuple(ties), by_time, constants_in(self.statements), arguments, axes_turn(self._prose))

    @cached_property
    def indices(self) -> Indices:
        """What the document says of its indices."""
        formulas = (each.display.latex for each in self.statements)
        return Indices(f"{self._prose} {' '.join(formulas)}", self.occurring)

    @cached_property
    def meanings(self) -> Meanings:
        """What words say of letters and signs."""
        given = frozenset(tie.given for tie in self.dependence.ties)
        iterated = frozenset(map(without_above, iterates_in(self._first_equations)))
        equations = [each.sides for each in self._read]
        return Meanings(self.statements, self._prose, equations, given, iterated, is_given(equations))

    @cached_property
    def restricted(self) -> frozenset[str]:
        r"""The letters that are said to be in a set or an interval, as in ``x \in \{0, 1\}``."""
        return frozenset(match[1] for each in self.document.formulas for match in _IN_A_SET.finditer(each.latex))

    @cached_property
    def special(self) -> str:
        """A word by which values or products may be others than those of real numbers; empty for none."""
        found = heard(r"\b<special>\b").search(self._prose)
        return found.group() if found else ""

    @cached_property
    def crossed(self) -> tuple[Definition, ...]:
        """What printed matrices of cross products that hold say of vectors and of functions, if they say it once."""
        held = (each for each in self.statements if not beside(each, "").is_conditional)
        parsed = ((each.display.place, self.formulas[id(each)]) for each in held)
        sides = ((place, each.sides) for place, each in parsed if isinstance(each, Parsed))
        found = {replace(one, place=place): one for place, each in sides for one in crossed_in([each], self.occurring)}
        symbols = [each.symbol for each in dict.fromkeys(found.values())]
        return tuple(each for each in found if symbols.count(each.symbol) == 1)

    @cached_property
    def entries(self) -> tuple[Definition, ...]:
        """What printed matrices that hold say of letters for their entries, unless these were given before."""
        found, alone = list[Definition](), set[str]()
        for each in self.statements:
            formula = self.formulas[id(each)]
            if not isinstance(formula, Parsed) or not {*formula.relations} <= {*EQUALITIES}:
                continue
            if not beside(each, "").is_conditional:
                given = entries_in(formula.sides, self.occurring, str(each.display.where), each.display.place)
                found += (entry for entry in given if entry.symbol not in alone)
            alone |= {defined_by(side)[0] for side in formula.sides}
        return tuple(found)

    def shows_components(self, left: Formula, right: Formula, place: int) -> bool:
        """Whether a relation at a place is the first one that says what the components of a vector are."""
        told = {each.symbol for each in self.crossed if each.place < place}
        return any(each.symbol not in told for each in crossed_in([(left, right)], self.occurring))

    @cached_property
    def quaternions(self) -> frozenset[str]:
        """The letters that are quaternions, multiplied in a circle; none where words speak of Kronecker's product."""
        if not self.says(r"\b<quaternions>\b") or self.says(r"\b<no-quaternions>\b"):
            return frozenset()
        return quaternions_in(each.sides for each in self._read)

    @cached_property
    def speaks_of_rotations(self) -> bool:
        """Whether words speak of rigid motions, where R is a rotation, and say nothing of R."""
        said = {split_symbol(symbol)[0] for symbol, _ in described(self._prose) if " " not in symbol}
        named = re.search(r"\$\\?(?:mathbf\{)?R\}?\$", self._prose)
        return self.says(r"\b<rotations>\b") and not (named or said & {"R", r"\mathbf{R}"})

    @cached_property
    def speaks_of_covariances(self) -> bool:
        """Whether words speak of covariances, which are symmetric, and of no factors that are called likewise."""
        return self.says(r"\b<covariances>\b") and not self.says(r"\b<no-covariances>\b")

    @cached_property
    def named_otherwise(self) -> frozenset[str]:
        """The letters, whatever their scripts are, that words call something else than covariances."""
        nouns = [(symbol, said) for symbol, said in described(self._prose) if " " not in symbol]
        return frozenset(split_symbol(symbol)[0] for symbol, said in nouns if said and not said & _OF_NOISE)

    @cached_property
    def has_tensors_of_three_rows(self) -> bool:
        """Whether words speak of tensors, and of no other number of dimensions."""
        return self.says(r"\b<tensors>\b") and not self.is_flat

    @cached_property
    def is_flat(self) -> bool:
        """Whether words speak of another number of dimensions than three."""
        return self.says(r"(?<![a-z])<flat>")

    @cached_property
    def sums_over_indices(self) -> bool:
        """Whether sums over repeated indices are not written: words say so, or letters look so beside no sum."""
        sums = any(index_of(str(big.children[0])) for side in self._sides for big in side.find_data("big"))
        unsaid = not sums and self.says(r"\b<tensors>\b")
        return self.meanings.has_convention or (unsaid and is_in_index_notation(self.occurring, self.tensor_indices))

    @cached_property
    def tensor_indices(self) -> frozenset[str]:
        """The letters that are indices of tensors."""
        return indices_in(self.occurring)

    @cached_property
    def imaginary(self) -> str:
        """The letter that is the imaginary unit; empty for none.

        It is said to be a root of -1, or a document that speaks of complex numbers has it in an exponent of e.
        """
        spoken = bool(complexes_in(self.statements)) or any(
            says(r"\b<complex-numbers>\b", f"{each.before} {each.after}") for each in self.document.formulas
        )
        return next((each for each in sorted(self._units) if spoken or self._is_root(each)), "")

    @cached_property
    def _units(self) -> frozenset[str]:
        """The letters i and j that may be the imaginary unit: roots of -1, said to be it, or in an exponent of e."""
        trees = [tree for side in self._sides for tree in side.iter_subtrees()]
        names = [str(each.children[0]) for each in trees if each.data == "big"]
        raised = {symbol for each in trees if _is_exponential(each) for symbol in symbols_in(each)}
        alone = {lone_letter(each.children[-1]) for each in trees if each.data == "function"}
        given = {tie.given for tie in self.dependence.ties if tie.others}
        indices = frozenset().union(*map(letters_in, names), *map(letters_of_symbol, self.occurring - {"i", "j"}))
        named = called(self.statements, "imaginary unit")
        found = {each for each in ("i", "j") if each in raised or each in named or self._is_root(each)}
        otherwise = {
            symbol for symbol, nouns in described(self._prose) if nouns and nouns.isdisjoint(("imaginary", "root"))
        }
        return frozenset(found - alone - given - indices - (otherwise - named))

    @property
    def _equated_with_units(self) -> Iterator[str]:
        """Yield the letters that are a side of an equation in which the imaginary unit may stand."""
        for formula in self._read if self._units else ():
            if self._units & {x for side in formula.sides for x in symbols_in(side)}:
                yield from (symbol for side in formula.sides if (symbol := defined_by(side)[0]))

    @property
    def _compared(self) -> Iterator[str]:
        """Yield the letters that are a side of an inequality: they are real."""
        for formula in self._read:
            if not _LESS.isdisjoint(formula.relations):
                yield from (symbol for side in formula.sides if (symbol := defined_by(side)[0]))

    def _is_root(self, letter: str) -> bool:
        root = re.compile(rf"{letter}(?:\^2=-1|=\\sqrt-1)")
        return any(root.fullmatch(bare(each.pieces)) for each in self.statements)

    def vocabulary(self) -> Vocabulary:
        """Return what is known of the letters before the first equation."""
        sizes, properties = sizes_in(self.statements), properties_in(self.statements)
        found = Vocabulary(
            self.given.whole,
            sizes,
            self.kinds,
            properties,
            dependence=self.dependence,
            euler=self._has_euler,
            complexes=complexes_in(self.statements) | self._units | {*self._equated_with_units},
            imaginary=self.imaginary,
            reals=reals_in(self.statements) | {*self._compared},
            wholes=wholes_in(self._prose),
            gamma=has_gamma_function(self._prose) or has_gamma_integral(each.sides for each in self._read),
        )
        hats = frozenset(each.symbol for each in self.crossed if each.tree.data == "marked" and not each.parameters)
        given = {defined_by(each.sides[0])[0] for each in self._read if len(each.sides) > 1}
        for definition in crosses_in(sorted(self.occurring), hats):
            if definition.symbol not in given or lone(definition.tree.children[0]) == "":
                found.define(definition)
        return found

    @cached_property
    def kinds(self) -> Kinds:
        """Which letters are vectors or matrices."""
        return kinds_in(self.statements, self.formulas)

    def kinds_in(self, part: int) -> tuple[Kinds, frozenset[str]]:
        """Return what letters are in a section, and which are numbers there that are none elsewhere."""
        return self._kinds_by_section.get(part, (self.kinds, frozenset()))

    @cached_property
    def _has_euler(self) -> bool:
        return has_euler(self._sides)

    @cached_property
    def _kinds_by_section(self) -> dict[int, tuple[Kinds, frozenset[str]]]:
        given = self.given.whole
        told = {*given.symbols, *given.sizes, *given.properties}
        return kinds_by_section(self.statements, self.formulas, self.kinds, told, euler=self._has_euler)


_OF_NOISE = frozenset(("covariance", "covariances", "noise", "innovation", "uncertainty"))
_LESS = frozenset(("<", ">", "<=", ">=", "≪", "≫", "≲", "≳"))
_IN_A_SET = re.compile(r"(\\?[a-zA-Z]+(?:_\w)?)\s*\\in\s*(?:\\left\s*)?(?:\\\{|\\lbrace|[\[(]|\\mathbb\s*\{?[ZN])")


def _nested(tokens: Sequence[Token]) -> Iterator[str]:
    """Yield the letters that have nothing but the value of a function in their brackets."""
    kinds = {"SYMBOL": "s", "CALLEE": "c", "LP": "(", "RP": ")"}
    line = "".join(kinds.get(each.type, "o") for each in tokens)
    for match in re.finditer(r"((?:s\()+)c\([^()]*(\)+)", line):
        count = min(len(match[1]) // 2, len(match[2]) - 1)
        yield from map(str, tokens[match.end(1) - 2 * count : match.end(1) : 2])


def _turning(formula: Parsed) -> Iterator[str]:
    r"""Yield the letters in an angle, as t in ``\sin(\omega t)``."""
    for side in formula.sides:
        for tree in side.find_data("function"):
            if tree.children[0] in ("sin", "cos"):
                yield from symbols_in(tree)


def _is_exponential(tree: Formula) -> bool:
    return tree.children[:1] == [E] if tree.data == "power" else tree.data == "function" and tree.children[0] == "exp"


def _has_index(name: str) -> bool:
    """Whether what stands above a letter may be an index: no mark of matrices, and no inverse."""
    above = split_symbol(name)[3]
    return bool(above) and above not in MARKS and not above.startswith(("-1", "*", r"\dagger", r"\circ"))
