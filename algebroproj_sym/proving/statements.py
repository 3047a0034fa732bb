"""The public way to decide: expressions or text, of bounded size."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import sympy

from algebroproj_sym.expressions import (
    NotRationalError,
    ParseError,
    free_symbols,
    names_in,
    over,
    parse,
    parse_zero,
    require_bounded,
)
from algebroproj_sym.expressions.walking import each_once
from algebroproj_sym.proving.proof import Conditions, Proof
from algebroproj_sym.proving.prove import Witness
from algebroproj_sym.proving.prove import prove as decided

RELATIONS = ("=", "!=", "<", "<=", ">", ">=")


class UnsupportedError(NotImplementedError):
    """A kind of statement that is not decided yet."""


def prove(
    lhs: Any,
    rhs: Any,
    *,
    relation: str = "=",
    constraints: Sequence[Any] = (),
    nonzero: Sequence[Any] = (),
    assumptions: Sequence[Any] = (),
    witness: Witness | None = None,
    engine: str = "flint",
    properties: Mapping[Any, Any] | None = None,
    letters: Mapping[str, str] | None = None,
    complex: Sequence[str] | None = None,
) -> Proof:
    """Decide whether a relation of two sides holds wherever both are defined and the hypotheses hold.

    Parameters
    ----------
    lhs, rhs : str, sympy.Expr, sympy matrix, int or Fraction
        Rational expressions over Q of equal shape, or text in the grammar of `algebroproj_sym.expressions.parsing`;
        matrices are compared entry by entry.  They may also have roots, rational powers, pi, derivatives, and
        elementary functions of real variables, with principal values; see `algebroproj_sym.replaying.reals.terms`.
    relation : {"=", "!=", "<", "<=", ">", ">="}
        Between the sides; with another one than equality they are scalars, and the symbols are real numbers.
    constraints : sequence of str, sympy.Expr or sympy.Eq
        Expressions that are zero, or equations; text may be an equation ``left = right``.
    nonzero : sequence of str or sympy.Expr
        Expressions that are not zero.
    assumptions : sequence of str or SymPy relation
        What holds beside them, such as ``x > 0`` or ``0 < x < pi``; then the symbols are real numbers.
    witness : mapping of Symbol, or name, to rational number, optional
        A point that satisfies constraints and hypotheses, where no search would find one; numbers may also be text.
    engine : {"flint", "sympy"}
        Which polynomial arithmetic to use.
    properties : mapping of MatrixSymbol, or name, to str or tuple of str, optional
        What letters are: rotation, orthogonal, symmetric, skew, unit, positive definite, diagonal, idempotent, or of a
        rank, such as rank 2.
    letters : mapping of name to str, optional
        The vectors and matrices in text, with their properties, such as ``{"R": "3x3 rotation", "t": "3x1"}``.
    complex : sequence of str, optional
        The names of complex variables; the others are real.  With it, be it empty, ``I`` in text is the imaginary unit.
        It is found without it in expressions of SymPy, and if text has ``re``, ``im``, ``conjugate`` or ``arg``.  A
        point has the parts ``z_re`` and ``z_im`` of a variable ``z``.

    Returns
    -------
    Proof
        Verdict ``"proved"`` (over the real numbers, and over every field of characteristic 0 if no squares are in the
        certificate), ``"refuted"`` (at a real point) or ``"open"``.
        What SymPy assumes of symbols is in `Proof.assumptions`: every point satisfies it.
        The hypotheses of a statement with functions are text: what must hold for both sides to be real.
        Those of a statement in letters that is text are text, too.

    Raises
    ------
    ParseError
        If a text is not in the grammar.
    TooLargeError
        If a SymPy expression is larger than a text may be.
    SymbolError
        If a symbol has a name that text cannot have, stands for no rational number, or is another one of the same name.
    TypeError
        If constraints or nonzero are not a sequence, or the witness is not a mapping.
    NotRationalError
        If an argument is not a rational expression over Q (floats are not).
    UndefinedError
        If a denominator is identically zero.
    UnsupportedError
        If the relation of a statement in letters is not an equality.
    LetterError
        If letters do not fit together, are not declared, or have a property that is unknown.
    ValueError
        If the shapes differ, the engine is unknown, a constraint is a matrix, or the witness violates a constraint or
        has a value for a symbol that does not occur.

    Examples
    --------
    >>> proof = prove("(x^2 - y^2)/(x - y)", "x + y")
    >>> proof.verdict, proof.hypotheses
    ('proved', (x - y,))
    >>> prove("a*(x + y) + b", "0", constraints=["a*x^2 + b*x + c", "a*y^2 + b*y + c"], nonzero=["x - y"]).verdict
    'proved'
    >>> prove("x", "0", constraints=["x^2"]).certificate["method"]
    'radical membership'
    >>> x, y = sympy.symbols("x y")
    >>> prove(x**2, y**2, constraints=[sympy.Eq(x, y)]).verdict
    'proved'
    >>> prove("x", "1", constraints=["x^2 = 2"]).counterexample
    {x: -sqrt(2)}
    >>> prove("sqrt(x^2)", "x", assumptions=["x >= 0"]).verdict, prove("sqrt(x^2)", "x").counterexample
    ('proved', {x: Fraction(-2, 1)})
    >>> prove("tan(x)*cos(x)", "sin(x)").hypotheses
    ('cos(x) != 0',)
    >>> prove("x + 1/x", "2", relation=">=", assumptions=["x > 0"]).verdict
    'proved'
    >>> prove("diff(log(x), x)", "1/x").hypotheses
    ('x > 0',)
    >>> prove("exp(I*x)", "cos(x) + I*sin(x)", complex=[]).verdict
    'proved'
    >>> prove("abs(z)^2", "z*conjugate(z)", complex=["z"]).verdict
    'proved'
    >>> R, t = sympy.MatrixSymbol("R", 3, 3), sympy.MatrixSymbol("t", 3, 1)
    >>> prove((R * t).T * (R * t), t.T * t, properties={R: "rotation"}).scope
    'for every size'
    """
    if relation not in RELATIONS:
        raise ValueError(f"relation: expected one of {', '.join(RELATIONS)}, got {relation!r}")
    for argument, given in {"constraints": constraints, "nonzero": nonzero, "assumptions": assumptions}.items():
        if isinstance(given, str) or not isinstance(given, Sequence):
            raise TypeError(f"{argument}: expected a sequence of expressions, got {_kind(given)}")
    constraints = [_difference(each) for each in constraints]
    forms = (lhs, rhs, *constraints, *nonzero)
    if letters is not None or properties or speaks_of_letters(forms):
        for argument, unused in {"assumptions": not assumptions, "witness": witness is None}.items():
            if not unused:
                raise ValueError(f"{argument}: expected none for a statement in letters")
        if relation != "=":
            raise UnsupportedError(f"relation: expected '=' for a statement in letters, got {relation!r}")
        return _of_letters(lhs, rhs, constraints, nonzero, properties, letters, engine)
    names = _complex_names(forms, complex)
    if names is None and relation == "=" and not assumptions and not any(map(_has_pi, forms)):
        try:
            return _rational(lhs, rhs, constraints, nonzero, witness, engine)
        except (ParseError, NotRationalError):
            if not any(map(has_functions, forms)):
                raise
    return _real(lhs, rhs, Conditions(constraints, nonzero, assumptions, witness, relation), names)


def _has_pi(form: Any) -> bool:
    return isinstance(form, str) and "pi" in form and "pi" in names_in(form)


def _difference(constraint: Any) -> Any:
    """Return what an equation says is zero; nothing is cancelled, since each side must be defined."""
    if not isinstance(constraint, sympy.Eq):
        return constraint
    left, right = constraint.args
    if isinstance(left, sympy.MatrixExpr):
        return sympy.MatAdd(left, sympy.MatMul(-1, right))
    return sympy.Add(left, sympy.Mul(-1, right, evaluate=False), evaluate=False)


def _complex_names(forms: Sequence[Any], given: Sequence[str] | None) -> frozenset[str] | None:
    """Return the names of the complex variables of a statement about complex numbers, or None."""
    if isinstance(given, str) or not isinstance(given, Sequence | None):
        raise TypeError(f"complex: expected a sequence of names, got {_kind(given)}")
    nodes = [*_distinct(forms)]
    names = {node.name for node in nodes if isinstance(node, sympy.Symbol) and node.is_complex and node.is_real is None}
    asked = given is not None or any(isinstance(form, str) and "(" in form and _has_parts(form) for form in forms)
    asked |= any(isinstance(node, _OF_COMPLEX_NUMBERS) for node in nodes)
    asked |= bool(names) and any(_is_function(node) for node in nodes)
    return frozenset([*(given or ()), *names]) if asked else None


def _has_parts(text: str) -> bool:
    from algebroproj_sym.replaying.reals.terms import has_parts

    return has_parts(text)


_OF_COMPLEX_NUMBERS = (type(sympy.I), sympy.re, sympy.im, sympy.conjugate, sympy.arg)


def _is_function(node: Any) -> bool:
    is_root = isinstance(node, sympy.Pow) and not isinstance(node.exp, sympy.Integer)
    calculus = isinstance(node, sympy.Derivative | sympy.Integral)
    return is_root or calculus or (isinstance(node, sympy.Function) and not isinstance(node, over))


def _distinct(values: Iterable[Any]) -> Iterator[Any]:
    """Yield each node of expressions once: some have more paths than could be walked."""
    given = [entry for value in values for entry in (value.flat() if isinstance(value, sympy.MatrixBase) else [value])]
    return each_once((value for value in given if isinstance(value, sympy.Basic)), lambda node: node.args)


def has_functions(form: Any) -> bool:
    """Whether a form that is not rational has functions, roots or powers."""
    from algebroproj_sym.replaying.reals import terms

    if isinstance(form, str):
        return terms.has_functions(form)
    if not isinstance(form, sympy.Expr | sympy.MatrixBase):
        return False
    return form.has(sympy.pi, sympy.E) or any(map(_is_function, _distinct([form])))


def _real(lhs: Any, rhs: Any, given: Conditions, complex_names: frozenset[str] | None) -> Proof:
    from algebroproj_sym.proving.reals.matrices import proof_of_matrix
    from algebroproj_sym.proving.reals.prove import proof_of, proof_of_complex
    from algebroproj_sym.proving.reals.reading import assumed_of, symbols_in
    from algebroproj_sym.replaying.reals.matrices import is_matrix

    if complex_names is not None:
        if any(isinstance(side, sympy.MatrixBase) for side in (lhs, rhs)):
            raise UnsupportedError("prove: expected scalars in a statement about complex numbers, got a matrix")
        return proof_of_complex(lhs, rhs, given, complex_names)
    if not any(isinstance(side, sympy.MatrixBase) or is_matrix(side) for side in (lhs, rhs)):
        return proof_of(lhs, rhs, given)
    if given.relation != "=":
        raise UnsupportedError(f"relation: expected '=' between matrices, got {given.relation!r}")
    given = given._replace(assumptions=[*given.assumptions, *assumed_of(symbols_in([lhs, rhs]))])
    return proof_of_matrix(lhs, rhs, lambda a, b: proof_of(a, b, given))


def _rational(
    lhs: Any, rhs: Any, constraints: Sequence[Any], nonzero: Sequence[Any], witness: Witness | None, engine: str
) -> Proof:
    left, right = _read(lhs, "lhs"), _read(rhs, "rhs")
    zeros = [_zero(constraint, f"constraints[{i}]") for i, constraint in enumerate(constraints)]
    units = [_read(unit, f"nonzero[{i}]") for i, unit in enumerate(nonzero)]
    if isinstance(witness, Mapping):
        _require_known(witness, (left, right, *zeros, *units))
    return decided(left, right, constraints=zeros, nonzero=units, witness=witness, engine=engine)


def speaks_of_letters(values: Iterable[Any]) -> bool:
    """Whether some expressions have matrices that are not written out."""
    return any(
        isinstance(node, sympy.MatrixExpr) and not isinstance(node, sympy.MatrixBase) for node in _distinct(values)
    )


def _of_letters(
    lhs: Any,
    rhs: Any,
    constraints: Sequence[Any],
    nonzero: Sequence[Any],
    properties: Mapping[Any, Any] | None,
    letters: Mapping[str, str] | None,
    engine: str,
) -> Proof:
    """Decide a statement in letters; what that needs is imported for it alone."""
    from algebroproj_sym.proving.letters import prove_letters, prove_texts

    if letters is None:
        return prove_letters(lhs, rhs, constraints=constraints, nonzero=nonzero, properties=properties, engine=engine)
    if properties:
        raise ValueError("properties: expected none beside letters, which have their own")
    return prove_texts(lhs, rhs, letters, constraints=constraints, nonzero=nonzero, engine=engine)


def _kind(given: Any) -> str:
    return f"the text {given!r}" if isinstance(given, str) else f"{type(given).__name__}"


def _read(value: Any, argument: str) -> Any:
    if isinstance(value, str):
        return parse(value, argument)
    require_bounded(value, argument)
    return value


def _zero(value: Any, argument: str) -> Any:
    return parse_zero(value, argument) if isinstance(value, str) else _read(value, argument)


def _require_known(witness: Mapping[Any, Any], forms: Sequence[Any]) -> None:
    symbols = (free_symbols(form) for form in forms if isinstance(form, sympy.Expr | sympy.MatrixBase))
    names = {symbol.name for found in symbols for symbol in found}
    for key, value in witness.items():
        name = getattr(key, "name", key)
        if isinstance(name, str) and name not in names:
            known = ", ".join(sorted(names)) or "none"
            raise ValueError(f"witness: expected values for symbols that occur ({known}), got one for {name!r:.120}")
        require_bounded(value, f"witness, {name}")
