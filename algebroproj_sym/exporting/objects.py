"""Objects of derivations as Coq definitions, made step by step as the derivation makes them.

Each operation occurs twice: as the call of a function of ``Linear.v``, and as what this function computes of formulas,
part by part in the same order.  Coq compares the two; if they differ, it rejects the theorem.
"""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, TypeAlias

import sympy

from algebroproj_sym.exporting.gallina import formula, identifier, listed
from algebroproj_sym.exporting.points import values
from algebroproj_sym.exporting.rational_functions import in_lowest_terms
from algebroproj_sym.exporting.refusal import NotExportable
from algebroproj_sym.exporting.terms import (
    Term,
    applied,
    in_rows,
    integer,
    name,
    names,
    negative,
    number,
    power,
    product,
    quotient,
    size,
    substituted,
    total,
)
from algebroproj_sym.exporting.theorems import Goal, Hypotheses, universal_of_matrix
from algebroproj_sym.expressions import over
from algebroproj_sym.expressions.provenance import Made
from algebroproj_sym.expressions.walking import parts_first

Rows: TypeAlias = tuple[tuple[Term, ...], ...]
LARGE, LARGE_NUMBER = 200_000, 1_000
"""From how many parts on a step has a lemma of its own, which later steps rest on."""
LONG_TEXT = 500
"""From how many characters on a step has a name."""
MOST_PARTS, MOST_UNKNOWNS = 1_000_000, 6


@dataclass(frozen=True)
class Definition:
    """A definition of Coq: its name, its variables, its type, and its text.

    There may be a lemma that says what it is: its statement and proof.  What has such a lemma, and no variables, is a
    parameter of the definitions that rest on it, so that the lemma can be used without unfolding them.
    """

    name: str
    parameters: tuple[str, ...]
    variables: tuple[str, ...]
    type: str
    text: str
    lemma: tuple[str, str] | None = None

    @property
    def command(self) -> str:
        """The commands that make it, and prove the lemma."""
        bound = f" ({' '.join(map(identifier, self.variables))} : R)" if self.variables else ""
        made = f"Definition {' '.join([self.name, *self.parameters])}{bound} : {self.type} :=\n  {self.text}."
        if self.lemma is None:
            return made
        statement, proof = self.lemma
        return f"{made}\nLemma {self.name}_is :\n{statement}.\nProof.\n{proof}\nQed."


@dataclass(frozen=True)
class Piece:
    """A value: as Coq's text, as formulas, and with the variables that occur in the text."""

    text: str
    """In parentheses, or a single word."""
    rows: Rows
    """The entries; of a scalar one."""
    variables: frozenset[str]
    scalar: bool
    made: bool
    """Whether some operation made it, other than writing its entries down."""
    needs: tuple[Term, ...] = ()
    """What must not be zero for the lemmas about its parts."""


@dataclass(frozen=True)
class Object:
    """What a claim is about: its definitions in order, the derived form in their terms, and how lemmas rewrite it."""

    definitions: tuple[Definition, ...]
    piece: Piece
    rewriting: str


class Workshop:
    """The objects of a section, which the derivation calls by some names."""

    def __init__(self, called: Mapping[Made, str]) -> None:
        self.called = called
        self.pieces: dict[Made, Piece] = {}
        self.defined: dict[Made, Definition] = {}
        self.operands: dict[Made, list[Made]] = {}
        self.bound: dict[Made, bool] = {}
        self.first: dict[tuple[str | None, str], Made] = {}
        self.taken: set[str] = set()
        self.closed: set[str] = set()

    def object(self, made: Made) -> Object | None:
        """Return what a claim is about, None if nothing but its entries is known."""
        piece = self.piece(made)
        if not piece.made:
            return None
        order = dict.fromkeys(self.defined[step] for step in self._steps([made]))
        return Object(tuple(order), piece, self._rewriting([made]))

    def _steps(self, roots: Sequence[Made], behind_lemmas: bool = True) -> list[Made]:
        """Return the definitions of some values, those that others use before them."""

        def used(made: Made) -> list[Made]:
            is_lemma = made in self.defined and self.defined[made].lemma is not None
            return [] if is_lemma and not behind_lemmas else self._operands(made)

        return [made for made in parts_first(roots, used) if made in self.defined]

    def _rewriting(self, roots: Sequence[Made]) -> str:
        """Return the tactic that puts values into a text that lemmas have for its parts."""
        steps = self._steps(roots, behind_lemmas=False)
        lemmas = dict.fromkeys(self.defined[step].name for step in steps if self.defined[step].lemma is not None)
        if not lemmas:
            return ""
        inner = [step for step in steps if self.defined[step].lemma is None and self._is_bound(step)]
        unfolded = " ".join(dict.fromkeys(self.defined[step].name for step in inner))
        opened = f"cbv beta delta [{unfolded}].\n" if inner else ""
        used = ", ".join(f"?{called}_is" for called in lemmas)
        return f"name_right_side.\n{opened}rewrite {used} by assumption."

    def _is_bound(self, made: Made) -> bool:
        """Whether a value rests on a lemma with variables, to which it must be unfolded."""
        if made not in self.bound:
            definition = self.defined.get(made)
            if definition is not None and definition.lemma is not None:
                return bool(definition.variables)
            self.bound[made] = any(map(self._is_bound, self._operands(made)))
        return self.bound[made]

    def _operands(self, made: Made) -> list[Made]:
        return self.operands.get(made) or _operands(made)

    def piece(self, made: Made) -> Piece:
        """Return a value, after defining it if it has a name, or is large."""
        if made not in self.pieces:
            found = self._made(made)
            first = self.first.setdefault((self.called.get(made), found.text), made)
            if first is not made:
                return self._again(made, first)
            known = [self.pieces[part] for part in self._operands(made) if part in self.pieces]
            needs = dict.fromkeys(need for part in known for need in part.needs)
            found = replace(found, needs=tuple(needs))
            large = found.made and _size(found) > (LARGE if found.variables else LARGE_NUMBER)
            if large or made.operation == "chosen" or self._at_other_places(made):
                found = self._with_lemma(made, found)
            if _size(found) > MOST_PARTS:
                raise NotExportable("the steps are too many to be written out")
            named = made in self.called or len(found.text) > LONG_TEXT
            if named and made not in self.defined and (found.made or not found.variables):
                found = self._named(made, found)
            self.pieces[made] = found
        return self.pieces[made]

    def _again(self, made: Made, first: Made) -> Piece:
        """Return a value that was made before by the same steps."""
        if first in self.defined:
            self.defined[made] = self.defined[first]
        self.pieces[made] = self.pieces[first]
        return self.pieces[made]

    def _unfolded(self, made: Made) -> list[Made]:
        """Return the operands of a value that have a name and no lemma."""
        return [part for part in self._operands(made) if part in self.defined and self.defined[part].lemma is None]

    def _at_other_places(self, made: Made) -> bool:
        """Whether lemmas about the parts of a value assume something of other values of its variables."""
        return made.operation == "substituted" and bool(self.pieces[self._operands(made)[0]].needs)

    def _named(self, made: Made, piece: Piece, wanted: str = "step", lemma: bool = False) -> Piece:
        """Return a value after defining it; there may be a lemma to come."""
        wanted = self.called.get(made, wanted)
        called, count = identifier(f"the_{wanted}"), 1
        while called in self.taken:
            called, count = identifier(f"the_{wanted}_{count + 1}"), count + 1
        self.taken.add(called)
        variables, text = tuple(sorted(piece.variables)), piece.text.removeprefix("(").removesuffix(")")
        parameters = () if lemma else tuple(sorted(self.closed & {*re.findall(r"[\w']+", text)}))
        found = Definition(called, parameters, variables, "R" if piece.scalar else "matrix", text)
        self.defined[made] = found
        if lemma and not variables:
            self.closed.add(called)
        return replace(piece, text=_applied(found, map(identifier, variables)))

    def _with_lemma(self, made: Made, piece: Piece) -> Piece:
        """Return a value after defining it, with a lemma that has shorter formulas for it, if there are any."""
        required, rewriting = piece.needs, [self._rewriting(self._operands(made))]
        sides: tuple[Term, ...] = ()
        if self._at_other_places(made):
            whole, pairs = self._operands(made)[0], made.operands[1]
            values = {old: self.pieces[new].rows[0][0] for old, new in pairs if old in self.pieces[whole].variables}
            required = sides = tuple(substituted(self.pieces[whole].needs, values))
            rewriting = [self._rewriting([new for old, new in pairs if old in values])]
            required += tuple(need for old, new in pairs if old in values for need in self.pieces[new].needs)
        found = _shorter(piece, required)
        if found is None or (
            made.operation not in ("substituted", "same", "chosen") and size(_flat(found[0])) > _size(piece)
        ):
            return piece
        rows, divisors = found
        named = self._named(made, piece, lemma=True)
        definition = self.defined[made]
        goals = [[Goal(a, b) for a, b in zip(*pair, strict=True)] for pair in zip(piece.rows, rows, strict=True)]
        given = Hypotheses(definition.variables, divisors)
        opened = [definition.name]
        if made.operation == "chosen":
            opened += [self.defined[part].name for part in self._unfolded(made)]
        first = "\n".join(filter(None, [f"unfold {', '.join(opened)}.", *rewriting]))
        statement, proof = universal_of_matrix(
            given,
            goals,
            named.text,
            scalar=piece.scalar,
            first=first,
            required=required,
            lemma=f"{self.defined[self._operands(made)[0]].name}_is" if sides else "",
            sides=len(sides),
        )
        lemma = statement, f"{first}\nchoose." if made.operation == "chosen" else proof
        self.defined[made] = replace(definition, lemma=lemma)
        return replace(named, rows=rows, needs=divisors)

    def _made(self, made: Made) -> Piece:
        operation = made.operation
        if operation == "scalar":
            return self._scalar(made)
        if operation == "entries":
            return self._entries(made)
        if operation == "substituted":
            return self._substituted(made)
        if operation.startswith("system"):
            return self._system(made)
        if operation == "part":
            return self._part(made)
        parts = [
            self.piece(operand if isinstance(operand, Made) else Made("scalar", (), sympy.sympify(operand)))
            for operand in made.operands
        ]
        if operation == "same":
            return parts[0]
        if operation == "chosen":
            return self._chosen(self._operands(made)[0], *parts)
        if operation in _OF_SCALARS and all(part.scalar for part in parts):
            return _scalar(operation, *parts)
        if operation == "solve" and len(parts[0].rows) > MOST_UNKNOWNS and not parts[0].variables | parts[1].variables:
            return self._entries(Made("entries", (made.value.shape, *map(_literal, made.value.flat())), made.value))
        return _OPERATIONS[operation](*parts)

    def _chosen(self, made: Made, conditions: Piece, table: Piece) -> Piece:
        """Rows of a table where conditions hold; a lemma says of each whether it does."""
        if conditions.made and made not in self.defined:
            conditions = self.pieces[made] = self._with_lemma(made, conditions)
        flags = values({}, {}, _flat(conditions.rows)) or []
        kept = tuple(row for row, flag in zip(table.rows, flags, strict=True) if flag)
        return Piece(f"(chosen {conditions.text} {table.text})", kept, frozenset(), scalar=False, made=True)

    def _scalar(self, made: Made) -> Piece:
        known: dict[Any, Term] = {}
        parts = {}
        for place, (value, reference) in enumerate(made.operands):
            piece = self.piece(reference)
            if piece.made:
                known[value] = name(f"part{place}_")
                parts[f"part{place}_"] = piece
        term = _term(made.value, known)
        text = formula(term)
        for called in sorted(parts, key=len, reverse=True):
            text = text.replace(identifier(called), parts[called].text)
        (entry,) = substituted([term], {called: piece.rows[0][0] for called, piece in parts.items()})
        variables = frozenset(names([term])) - parts.keys()
        for piece in parts.values():
            variables |= piece.variables
        return Piece(f"({text})", ((entry,),), variables, True, bool(parts))

    def _entries(self, made: Made) -> Piece:
        (height, width), *operands = made.operands
        if not height or not width:
            raise NotExportable("a matrix has no entries")
        parts = [self.piece(operand) for operand in operands]
        texts = [part.text.removeprefix("(").removesuffix(")") for part in parts]
        text = listed([*map(listed, in_rows(texts, width))])
        return Piece(
            text,
            tuple(map(tuple, in_rows([part.rows[0][0] for part in parts], width))),
            _variables(parts),
            scalar=False,
            made=any(part.made for part in parts),
        )

    def _substituted(self, made: Made) -> Piece:
        whole, pairs = made.operands
        piece = self.piece(whole)
        values = {old: self.piece(new) for old, new in pairs if old in piece.variables}
        if not values:
            return piece
        if piece.needs and (whole not in self.defined or self.defined[whole].lemma is None):
            same = Made("same", (whole,), None)
            self.operands[made] = [same, *(new for _, new in pairs)]
            self.pieces[same] = piece = self._with_lemma(same, piece)
            whole = same
        elif whole not in self.defined:
            self.pieces[whole] = piece = self._named(whole, piece, "step" if piece.made else "entries")
        definition = self.defined[whole]
        arguments = [values[v].text if v in values else identifier(v) for v in definition.variables]
        variables = (piece.variables - values.keys()).union(*(value.variables for value in values.values()))
        return Piece(
            _applied(definition, arguments),
            _replaced(piece.rows, {old: value.rows[0][0] for old, value in values.items()}),
            frozenset(variables),
            piece.scalar,
            made=True,
        )

    def _system(self, made: Made) -> Piece:
        """Linear equations at zero and at units."""
        forms, unknowns = made.operands
        self.piece(forms)

        def at(unknown: str | None) -> Made:
            values = ((v, Made("scalar", (), sympy.Integer(int(v == unknown)))) for v in unknowns)
            return Made("substituted", (forms, tuple(values)), None)

        self.operands[made] = [at(None), *map(at, unknowns)]
        at_zero, *at_units = map(self.piece, self.operands[made])
        if made.operation == "system right side":
            return _OPERATIONS["negated"](at_zero)
        columns = [_flat(_difference(unit.rows, at_zero.rows)) for unit in at_units]
        text = f"(system_matrix {at_zero.text} {listed([unit.text for unit in at_units])})"
        return Piece(text, _transposed(tuple(columns)), at_zero.variables, False, True)

    def _part(self, made: Made) -> Piece:
        whole, key = made.operands
        piece = self.piece(whole)
        height, width = len(piece.rows), len(piece.rows[0])
        if not isinstance(key, tuple):
            key = divmod(range(height * width)[int(key)], width)
        rows, columns = (
            [*range(count)[k]] if isinstance(k, slice) else k for k, count in zip(key, (height, width), strict=True)
        )
        if not isinstance(rows, list) and not isinstance(columns, list):
            i, j = range(height)[int(rows)], range(width)[int(columns)]
            entry = piece.rows[i][j]
            if not piece.made:
                return Piece(f"({formula(entry)})", ((entry,),), frozenset(names([entry])), True, False)
            return Piece(f"(entry {piece.text} {i} {j})", ((entry,),), piece.variables, True, True)
        rows = [range(height)[int(k)] for k in (rows if isinstance(rows, list | tuple) else [rows])]
        columns = [range(width)[int(k)] for k in (columns if isinstance(columns, list | tuple) else [columns])]
        chosen = tuple(tuple(piece.rows[i][j] for j in columns) for i in rows)
        places = " ".join(f"{listed([*map(str, part)])}%nat" for part in (rows, columns))
        return Piece(f"(part {piece.text} {places})", chosen, piece.variables, False, piece.made)


def _size(piece: Piece) -> int:
    return size(_flat(piece.rows))


def _shorter(piece: Piece, required: Sequence[Term]) -> tuple[Rows, tuple[Term, ...]] | None:
    """Return shorter formulas for the entries, and what they and other formulas divide by; None if there are none."""
    entries = _flat(piece.rows)
    if piece.variables:
        shorter, divisors = in_lowest_terms(tuple(sorted(piece.variables)), entries, required)
    else:
        numbers = values({}, {}, entries)
        shorter, divisors = [] if numbers is None else [*map(number, numbers)], ()
    if not shorter:
        return None
    return tuple(map(tuple, in_rows(shorter, len(piece.rows[0])))), divisors


def _operands(made: Made) -> list[Made]:
    found: list[Made] = []
    waiting: list[Any] = [*made.operands]
    while waiting:
        value = waiting.pop(0)
        if isinstance(value, Made):
            found.append(value)
        elif isinstance(value, tuple):
            waiting = [*value, *waiting]
    return found


def _literal(value: Any) -> Made:
    return Made("scalar", (), sympy.sympify(value).doit())


def _applied(definition: Definition, arguments: Iterable[str]) -> str:
    spelled = " ".join([definition.name, *definition.parameters, *arguments])
    return f"({spelled})" if " " in spelled else spelled


def _variables(parts: Iterable[Piece]) -> frozenset[str]:
    return frozenset().union(*(part.variables for part in parts))


def _term(value: Any, known: Mapping[Any, Term]) -> Term:
    """Return an expression of SymPy as a term."""
    if value in known:
        return known[value]
    if isinstance(value, sympy.Rational):
        return number(Fraction(int(value.p), int(value.q)))
    if isinstance(value, sympy.Symbol):
        return name(value.name)
    if isinstance(value, sympy.Pow) and value.exp.is_Integer:
        return power(_term(value.base, known), int(value.exp))
    parts = [_term(part, known) for part in value.args]
    if isinstance(value, sympy.Add):
        return total(parts)
    if isinstance(value, sympy.Mul):
        return negative(product(parts[1:])) if value.args[0] == -1 else product(parts)
    if isinstance(value, over):
        return quotient(*parts)
    raise NotExportable("an operation has no counterpart")


def _replaced(rows: Rows, values: Mapping[str, Term]) -> Rows:
    return tuple(map(tuple, in_rows(substituted(_flat(rows), values), len(rows[0]))))


def _flat(rows: Rows) -> tuple[Term, ...]:
    return tuple(entry for row in rows for entry in row)


def _transposed(rows: Rows) -> Rows:
    return tuple(zip(*rows, strict=True))


def _zipped(join: Callable[[Term, Term], Term], a: Rows, b: Rows) -> Rows:
    return tuple(tuple(join(x, y) for x, y in zip(u, v, strict=True)) for u, v in zip(a, b, strict=True))


def _difference(a: Rows, b: Rows) -> Rows:
    return _zipped(lambda x, y: total([x, negative(y)]), a, b)


def dot(u: Sequence[Term], v: Sequence[Term]) -> Term:
    """Return the sum of products as the lemmas compute it."""
    found = integer(0)
    for a, b in reversed([*zip(u, v, strict=True)]):
        found = total([product([a, b]), found])
    return found


def _without(k: int, items: Sequence[Any]) -> tuple[Any, ...]:
    return (*items[:k], *items[k + 1 :])


def _determinant(rows: Rows) -> Term:
    if not rows:
        return integer(1)
    if len(rows) > MOST_UNKNOWNS:
        raise NotExportable("the steps are too many to be written out")
    first, *rest = rows
    found = integer(0)
    for k in reversed(range(len(first))):
        term = product([first[k], _determinant(tuple(_without(k, row) for row in rest))])
        found = total([negative(term) if k % 2 else term, found])
    return found


def _adjugate(rows: Rows) -> Rows:
    def cofactor(i: int, j: int) -> Term:
        minor = _determinant(tuple(_without(j, row) for row in _without(i, rows)))
        return minor if (i + j) % 2 == 0 else negative(minor)

    return tuple(tuple(cofactor(i, j) for i in range(len(rows))) for j in range(len(rows)))


def _solution(rows: Rows, right: Sequence[Term]) -> Rows:
    below = _determinant(rows)

    def above(j: int) -> Term:
        return _determinant(tuple((*row[:j], x, *row[j + 1 :]) for row, x in zip(rows, right, strict=True)))

    return tuple((quotient(above(j), below),) for j in range(len(rows)))


def _cross(a: Sequence[Term], b: Sequence[Term]) -> Rows:
    def entry(i: int, j: int) -> tuple[Term]:
        return (total([product([a[i], b[j]]), negative(product([a[j], b[i]]))]),)

    return entry(1, 2), entry(2, 0), entry(0, 1)


def _called(function: str, compute: Callable[..., Any], scalar: bool = False) -> Callable[..., Piece]:
    def make(*parts: Piece) -> Piece:
        found = compute(*(part.rows for part in parts))
        text = f"({function} {' '.join(part.text for part in parts)})"
        rows = ((found,),) if scalar else found
        return Piece(text, rows, _variables(parts), scalar, made=True)

    return make


def _scalar(operation: str, *parts: Piece) -> Piece:
    texts, compute = _OF_SCALARS[operation]
    row = (compute(*(part.rows[0][0] for part in parts)),)
    text = f"({texts.format(*(part.text for part in parts))})"
    return Piece(text, (row,), _variables(parts), scalar=True, made=True)


def _power(base: Term, exponent: Term) -> Term:
    if exponent.kind != "int":
        raise NotExportable("an exponent is not a natural number")
    return power(base, int(exponent.value))


def _times(a: Piece, b: Piece) -> Piece:
    if a.scalar or b.scalar:
        k, m = (a, b) if a.scalar else (b, a)
        return _called("scaled", lambda u, v: tuple(tuple(product([u[0][0], x]) for x in row) for row in v))(k, m)
    return _called("product", lambda u, v: tuple(tuple(dot(row, column) for column in _transposed(v)) for row in u))(
        a, b
    )


def _columns(*parts: Piece) -> Piece:
    *others, found = parts
    for other in reversed(others):
        found = _OPERATIONS["beside"](other, found)
    return found


_OF_SCALARS: Mapping[str, tuple[str, Callable[..., Term]]] = {
    "plus": ("{} + {}", lambda a, b: total([a, b])),
    "minus": ("{} - {}", lambda a, b: total([a, negative(b)])),
    "times": ("{} * {}", lambda a, b: product([a, b])),
    "divided": ("{} / {}", quotient),
    "power": ("{} ^ {}", _power),
    "negated": ("- {}", negative),
    "absolute": ("Rabs {}", lambda a: applied("Rabs", a)),
    "floor": ("floor {}", lambda a: applied("floor", a)),
    "at most": ("at_most {} {}", lambda a, b: applied("at_most", a, b)),
}
_OPERATIONS: Mapping[str, Callable[..., Piece]] = {
    "plus": _called("sum", lambda a, b: _zipped(lambda x, y: total([x, y]), a, b)),
    "minus": _called("difference", _difference),
    "negated": _called("negated", lambda a: tuple(tuple(map(negative, row)) for row in a)),
    "times": _times,
    "divided": _called("divided", lambda a, k: tuple(tuple(quotient(x, k[0][0]) for x in row) for row in a)),
    "transposed": _called("transposed", _transposed),
    "beside": _called("beside", lambda a, b: tuple((*u, *v) for u, v in zip(a, b, strict=True))),
    "above": _called("stacked", lambda a, b: (*a, *b)),
    "columns": _columns,
    "dot": _called("scalar_product", lambda a, b: dot(_flat(a), _flat(b)), scalar=True),
    "cross": _called("cross_product", lambda a, b: _cross(_flat(a), _flat(b))),
    "determinant": _called("determinant", _determinant, scalar=True),
    "adjugate": _called("adjugate", _adjugate),
    "inverse": _called(
        "inverse", lambda a: tuple(tuple(quotient(x, _determinant(a)) for x in row) for row in _adjugate(a))
    ),
    "solve": _called("solution", lambda a, b: _solution(a, _flat(b))),
}
