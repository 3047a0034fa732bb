"""Generated functions that compute in another way: they keep their names, parameters and documentation."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

__all__ = ["Wrapped"]


@dataclass(frozen=True)
class Wrapped:
    """A generated function, changed by one of the functions of this package.

    Attributes
    ----------
    by : callable
        What changed it, such as `dd`.
    function : callable
        The generated function.
    summary : str
        What the changed function does, for its documentation.
    compute : function
        What is called.
    """

    by: Callable[..., Any]
    function: Callable[..., Any]
    summary: str = field(repr=False, compare=False)
    compute: Callable[..., Any] = field(repr=False, compare=False)

    def __post_init__(self) -> None:
        signature = inspect.signature(self.function)
        if self.by.__name__ != "plain":
            kept = [parameter for name, parameter in signature.parameters.items() if name != "out"]
            signature = signature.replace(parameters=kept, return_annotation=signature.empty)
        told = {
            "__name__": self.function.__name__,
            "__qualname__": self.function.__qualname__,
            "__module__": self.function.__module__,
            "__signature__": signature,
            "__globals__": self.compute.__globals__,
            "__doc__": f"{self.summary}\n\n    The function itself: {self.function.__doc__}",
        }
        for name, value in told.items():
            object.__setattr__(self, name, value)

    def __call__(self, *arguments: Any, **named: Any) -> Any:
        """Compute."""
        return self.compute(*arguments, **named)

    def __repr__(self) -> str:
        """Return how it was made.

        >>> import algebroproj
        >>> algebroproj.dd(algebroproj.optics.scale)
        dd(optics.scale)
        """
        inner = self.function
        name = f"{inner.__module__.rpartition('.')[2]}.{inner.__name__}"
        return f"{self.by.__name__}({inner if isinstance(inner, Wrapped) else name})"

    def __reduce__(self) -> tuple[Any, ...]:
        return self.by, (self.function,)
