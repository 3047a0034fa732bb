"""Reading and deciding with a time limit: in worker processes that are killed when it is over.

A question that takes too long is open, and says so; a worker that fails or dies is an error, never a verdict.
"""

from __future__ import annotations

import queue
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing import get_context
from time import monotonic
from typing import Any

STARTING_SECONDS = 120.0
MEMORY_BYTES = 4 * 2**30


@dataclass(frozen=True)
class Question:
    """An identity as text.

    Attributes
    ----------
    lhs, rhs : str
        The two sides.
    constraints, nonzero : tuple of str
        What is zero, and what is not.
    witness : mapping of name to text of a rational number, or None
        A point at which they hold.
    variables : tuple of str, or None
        The names that may occur; None for any.
    assumptions : tuple of str
        Comparisons that hold.
    """

    lhs: str
    rhs: str
    constraints: tuple[str, ...] = ()
    nonzero: tuple[str, ...] = ()
    witness: Mapping[str, str] | None = None
    variables: tuple[str, ...] | None = None
    assumptions: tuple[str, ...] = ()

    @property
    def texts(self) -> tuple[str, ...]:
        """All that is stated."""
        return (self.lhs, self.rhs, *self.constraints, *self.nonzero, *self.assumptions)


@dataclass(frozen=True)
class Outcome:
    """What became of a question.

    Attributes
    ----------
    verdict : {"proved", "refuted", "open", "error"}
        ``"error"`` if there is no decision because something failed.
    method : str
        How it was decided, ``"none"`` if it was not.
    seconds : float
        How long it took.
    reason : str
        Why it is open or an error, else empty.
    hypotheses : tuple of str
        What must not vanish, for a proof.
    counterexample : mapping of name to text, or None
        For a refutation.
    certificate : mapping or None
        The evidence.
    unreadable : bool
        Whether the error is one of the text: the reason names what cannot be read.
    """

    verdict: str
    method: str
    seconds: float
    reason: str = ""
    hypotheses: tuple[str, ...] = ()
    counterexample: Mapping[str, str] | None = None
    certificate: Mapping[str, Any] | None = field(default=None, repr=False)
    unreadable: bool = False


def outcomes(
    questions: Sequence[Question], *, seconds: float, engine: str = "flint", jobs: int = 1
) -> Iterator[Outcome]:
    """Decide questions, in order, each within a time limit.

    Parameters
    ----------
    questions : sequence of Question
        As text.
    seconds : float
        How long each may take.
    engine : {"flint", "sympy"}
        Which polynomial arithmetic to use.
    jobs : int
        How many worker processes.

    Yields
    ------
    Outcome
    """
    workers = [_Worker(engine) for _ in range(jobs)]
    free: queue.Queue[_Worker] = queue.Queue()
    for worker in workers:
        free.put(worker)

    def decide(question: Question) -> Outcome:
        worker = free.get()
        try:
            return worker.decide(question, seconds)
        finally:
            free.put(worker)

    threads = ThreadPoolExecutor(jobs)
    try:
        yield from threads.map(decide, questions)
    finally:
        threads.shutdown(cancel_futures=True)
        for worker in workers:
            worker.stop()


class _Worker:
    """A process that decides one question after the other, started again after it was killed."""

    def __init__(self, engine: str) -> None:
        self._engine = engine
        self._process: Any = None
        self._connection: Any = None

    def decide(self, question: Question, seconds: float) -> Outcome:
        if self._process is None and not self._start():
            return self._failed(0.0, "the worker process did not start")
        start = monotonic()
        try:
            self._connection.send(question)
            if self._connection.poll(seconds):
                outcome = self._connection.recv()
                return outcome if isinstance(outcome, Outcome) else self._failed(monotonic() - start, str(outcome))
        except (EOFError, OSError):
            self._process.join(5)
            status = self._process.exitcode
            return self._failed(monotonic() - start, f"the worker process ended with exit status {status}")
        self.stop()
        return Outcome("open", "none", monotonic() - start, f"no decision within {seconds:g} s")

    def stop(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.join()
            self._connection.close()
        self._process = self._connection = None

    def _start(self) -> bool:
        context = get_context("spawn")
        self._connection, other = context.Pipe()
        self._process = context.Process(target=_serve, args=(other, self._engine), daemon=True)
        self._process.start()
        other.close()
        try:
            if self._connection.poll(STARTING_SECONDS):
                return bool(self._connection.recv() == "ready")
        except (EOFError, OSError):
            pass
        self.stop()
        return False

    def _failed(self, seconds: float, reason: str) -> Outcome:
        self.stop()
        return Outcome("error", "none", seconds, reason)


def _serve(connection: Any, engine: str) -> None:
    import algebroproj_sym.proving.prove  # noqa: F401 - what takes long to import is no part of the time of a question

    with suppress(ImportError, ValueError, OSError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    connection.send("ready")
    with suppress(EOFError, KeyboardInterrupt):
        while True:
            question = connection.recv()
            try:
                connection.send(_decided(question, engine))
            except Exception as error:  # anything that fails is reported as a failure, never as a verdict
                connection.send(f"{type(error).__name__}: {str(error)[:500]}")


def _decided(question: Question, engine: str) -> Outcome:
    from algebroproj_sym.expressions import ParseError
    from algebroproj_sym.proving.prove import prove

    start = monotonic()
    try:
        if _has_pi(question) or question.assumptions:
            return _real(question, start)
        try:
            statement = _read(question)
        except ParseError:
            from algebroproj_sym.replaying.reals.terms import has_functions

            if not any(map(has_functions, question.texts)):
                raise
            return _real(question, start)
    except (ParseError, _UnreadableError) as error:
        return Outcome("error", "none", monotonic() - start, str(error), unreadable=True)
    proof = prove(**statement, engine=engine)
    certificate = dict(proof.certificate or {})
    point = certificate.pop("point", proof.counterexample)
    if "witness" in certificate:
        certificate["witness"] = _whole(certificate["witness"], question)
    return Outcome(
        proof.verdict,
        str(certificate.get("method", "none")),
        monotonic() - start,
        str(certificate.get("reason", "")),
        tuple(map(str, proof.hypotheses)),
        None if point is None else _whole(point, question),
        certificate,
    )


def _has_pi(question: Question) -> bool:
    from algebroproj_sym.expressions import names_in

    return any("pi" in text and "pi" in names_in(text) for text in question.texts)


def _real(question: Question, start: float) -> Outcome:
    from algebroproj_sym.expressions import ParseError, names_in
    from algebroproj_sym.proving.reals.prove import proof_of
    from algebroproj_sym.replaying.reals.terms import FUNCTIONS

    names = {name for text in question.texts for name in names_in(text)} - FUNCTIONS - {"pi"}
    variables = names if question.variables is None else {*question.variables}
    for name in sorted(names - variables):
        raise _UnreadableError(f"expected one of the variables {', '.join(sorted(variables))}, got {name!r}")
    try:
        proof = proof_of(
            question.lhs, question.rhs, question.constraints, question.nonzero, question.assumptions, question.witness
        )
    except ParseError as error:
        raise _UnreadableError(f"key {error}") from None
    certificate = dict(proof.certificate or {})
    point = proof.counterexample
    return Outcome(
        proof.verdict,
        str(certificate.get("method", "none")),
        monotonic() - start,
        str(certificate.get("reason", "")),
        proof.hypotheses,
        None if point is None else {str(symbol): str(value) for symbol, value in point.items()},
        certificate,
    )


def _whole(point: Mapping[Any, Any], question: Question) -> dict[str, str]:
    """Return a point as text, with a value also for names that cancel."""
    from algebroproj_sym.expressions import names_in

    texts = (question.lhs, question.rhs, *question.constraints, *question.nonzero)
    names = sorted({name for text in texts for name in names_in(text)})
    return dict.fromkeys(names, "1") | {str(symbol): str(value) for symbol, value in point.items()}


class _UnreadableError(ValueError):
    pass


def _read(question: Question) -> dict[str, Any]:
    """Return the arguments of `prove`."""
    from algebroproj_sym.expressions import parse, parse_zero, shape, symbols_of

    names = question.variables
    left, right = (parse(getattr(question, key), f"key {key!r}", names) for key in ("lhs", "rhs"))
    if shape(left) != shape(right):
        raise _UnreadableError(f"key 'rhs': expected the shape of 'lhs', got {shape(left)} and {shape(right)}")
    zeros = [parse_zero(text, f"key 'constraints', entry {i}", names) for i, text in enumerate(question.constraints)]
    units = [parse(text, f"key 'nonzero', entry {i}", names) for i, text in enumerate(question.nonzero)]
    for place, unit in enumerate(units):
        if shape(unit) != ():
            raise _UnreadableError(f"key 'nonzero', entry {place}: expected a scalar, got a matrix")
    point = None
    if question.witness is not None:
        point = {name: parse(value, f"key 'witness', entry {name!r}") for name, value in question.witness.items()}
        known = {symbol.name for symbol in symbols_of((left, right, *zeros, *units))}
        for name, value in point.items():
            if name not in known:
                raise _UnreadableError(f"key 'witness': expected names that occur, got {name!r}")
            if not value.is_Rational:
                raise _UnreadableError(
                    f"key 'witness', entry {name!r}: expected a rational number as text, got {value}"
                )
    return {"lhs": left, "rhs": right, "constraints": zeros, "nonzero": units, "witness": point}
