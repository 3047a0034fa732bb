"""The elementary functions of kernels, each a module of this folder, which nothing else has to name."""

from importlib import import_module
from pkgutil import iter_modules

from algebroproj_sym.declaring.primitive import Primitive
from algebroproj_sym.declaring.stage import LINEAR

ELEMENTARY: dict[str, Primitive] = {
    primitive.name: primitive
    for module in sorted(info.name for info in iter_modules(__path__))
    for primitive in vars(import_module(f"{__name__}.{module}")).values()
    if isinstance(primitive, Primitive)
}
"""The elementary functions by their names."""

PRIMITIVES = ("let", *ELEMENTARY, *LINEAR)
"""The names of all that a stage may do."""
