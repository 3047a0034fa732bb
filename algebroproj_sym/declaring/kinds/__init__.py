"""The kinds of claims, each a module of this folder, which nothing else has to name."""

from importlib import import_module
from pkgutil import iter_modules

from algebroproj_sym.declaring.kind import Kind

KINDS: dict[str, Kind] = {
    kind.name: kind
    for module in sorted(info.name for info in iter_modules(__path__))
    for kind in vars(import_module(f"{__name__}.{module}")).values()
    if isinstance(kind, Kind)
}
"""The kinds by their names."""
