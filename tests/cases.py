"""Many short cases in one test: reporting a test of its own for each takes longer than running it."""

import inspect


def for_each(names, cases):
    """Run a test for all cases, as `pytest.mark.parametrize` does; the traceback shows the first one that fails."""
    names = [name.strip() for name in names.split(",")] if isinstance(names, str) else names

    def decorated(test):
        def every(**fixtures):
            for case in cases:
                test(**dict(zip(names, case if len(names) > 1 else [case], strict=True)), **fixtures)

        signature = inspect.signature(test)
        rest = [each for name, each in signature.parameters.items() if name not in names]
        every.__signature__ = signature.replace(parameters=rest)
        every.pytestmark = getattr(test, "pytestmark", [])
        return every

    return decorated
