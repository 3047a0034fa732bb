"""Reading and deciding with a time limit: in worker processes that are killed when it is over.

A question that takes too long is open, and says so; a worker that fails or dies is an error, never a verdict.
"""

import queue
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from multiprocessing import get_context
from threading import Lock
from time import monotonic
from types import ModuleType
from typing import Any

STARTING_SECONDS = 120.0
MEMORY_BYTES = 4 * 2**30
_STARTING = Lock()


@dataclass(frozen=True)
class Question:
    """An identity as text."""

    lhs: str
    rhs: str
    """The two sides."""
    constraints: tuple[str, ...] = ()
    nonzero: tuple[str, ...] = ()
    """What is zero, and what is not."""
    witness: Mapping[str, str] | None = None
    """A point at which they hold."""
    variables: tuple[str, ...] | None = None
    """The names that may occur; None for any."""
    assumptions: tuple[str, ...] = ()
    """Comparisons that hold."""
    letters: Mapping[str, str] | None = None
    """The vectors and matrices among the names, such as ``3x3 rotation``."""
    relation: str = "="
    """Between the two sides."""
    complex: tuple[str, ...] | None = None
    """The complex variables of a statement about complex numbers."""

    @property
    def named_texts(self) -> Iterator[tuple[str, str]]:
        """All that is stated, with the name of each part."""
        yield from (("lhs", self.lhs), ("rhs", self.rhs))
        for name in ("constraints", "nonzero", "assumptions"):
            yield from ((f"{name}[{place}]", text) for place, text in enumerate(getattr(self, name)))


@dataclass(frozen=True)
class Outcome:
    """What became of a question."""

    verdict: str
    """``"error"`` if there is no decision because something failed."""
    method: str
    """How it was decided, ``"none"`` if it was not."""
    seconds: float
    """How long it took."""
    reason: str = ""
    """Why it is open or an error, else empty."""
    hypotheses: tuple[str, ...] = ()
    """What must not vanish, for a proof."""
    counterexample: Mapping[str, Any] | None = None
    """For a refutation."""
    certificate: Mapping[str, Any] | None = field(default=None, repr=False)
    """The evidence."""
    unreadable: bool = False
    """Whether the error is one of the text: the reason names what cannot be read."""


Ask = Callable[[Sequence[Question]], Iterable[Outcome]]
"""What decides questions, in their order."""


@contextmanager
def asking(*, seconds: float, engine: str = "flint", jobs: int = 1) -> Iterator[Ask]:
    """Give what decides questions in worker processes, each within some seconds; the processes end with the block."""
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
        yield lambda questions: threads.map(decide, questions)
    finally:
        threads.shutdown(cancel_futures=True)
        for worker in workers:
            worker.stop()


def outcomes(
    questions: Sequence[Question], *, seconds: float, engine: str = "flint", jobs: int = 1
) -> Iterator[Outcome]:
    """Decide questions likewise, and yield what became of each."""
    with asking(seconds=seconds, engine=engine, jobs=jobs) as ask:
        yield from ask(questions)


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
        connection, other = context.Pipe()
        process = context.Process(target=_serve, args=(other, self._engine), daemon=True)
        with suppress(EOFError, OSError):
            with _without_main():
                process.start()
            self._process, self._connection = process, connection
            other.close()
            if connection.poll(STARTING_SECONDS) and connection.recv() == "ready":
                return True
        self.stop()
        return False

    def _failed(self, seconds: float, reason: str) -> Outcome:
        self.stop()
        return Outcome("error", "none", seconds, reason)


@contextmanager
def _without_main() -> Iterator[None]:
    """Keep a process that is started from running the script of the user, which would ask everything again."""
    with _STARTING:
        main = sys.modules["__main__"]
        sys.modules["__main__"] = ModuleType("__main__")
        try:
            yield
        finally:
            sys.modules["__main__"] = main


def _serve(connection: Any, engine: str) -> None:
    import algebroproj_sym.proving.statements  # noqa: F401 - a slow import must not count as time of a question

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
    from algebroproj_sym.proving.points import point_record
    from algebroproj_sym.proving.proof import UndefinedError
    from algebroproj_sym.proving.statements import prove
    from algebroproj_sym.replaying.reals import METHODS

    start = monotonic()
    try:
        _require_variables(question)
        proof = prove(
            question.lhs,
            question.rhs,
            relation=question.relation,
            constraints=question.constraints,
            nonzero=question.nonzero,
            assumptions=question.assumptions,
            witness=question.witness,
            engine=engine,
            letters=question.letters,
            complex=question.complex,
        )
    except UndefinedError:
        raise
    except (ValueError, TypeError) as error:
        return Outcome("error", "none", monotonic() - start, str(error), unreadable=True)
    certificate = dict(proof.certificate or {})
    is_whole = question.letters is not None or certificate.get("method") in METHODS
    if not is_whole and "witness" in certificate:
        certificate["witness"] = _whole(certificate["witness"], question)
    point = certificate.pop("point", None) or (proof.counterexample and point_record(proof.counterexample))
    return Outcome(
        proof.verdict,
        str(certificate.get("method", "none")),
        monotonic() - start,
        str(certificate.get("reason", "")),
        tuple(map(str, proof.hypotheses)),
        _whole(point, question) if point is not None and not is_whole else point,
        certificate,
    )


def _require_variables(question: Question) -> None:
    if question.variables is None:
        return
    for argument, text in question.named_texts:
        for name in sorted(_symbols_in(text).difference({"I", *question.variables})):
            known = ", ".join(sorted(question.variables))
            raise ValueError(f"{argument}: expected one of the variables {known}, got {name!r}")


def _whole(point: Mapping[Any, Any], question: Question) -> dict[str, str]:
    """Return a point with a value also for names that cancel."""
    names = {name for _, text in question.named_texts for name in _symbols_in(text)}
    return dict.fromkeys(sorted(names), "1") | dict(point)


def _symbols_in(text: str) -> set[str]:
    """Return the names in a text that stand for numbers which are not further known."""
    from algebroproj_sym.expressions import names_in
    from algebroproj_sym.replaying.reals.terms import FUNCTIONS

    return names_in(text) - FUNCTIONS - {"pi"}
