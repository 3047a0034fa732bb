"""Checking that what a claim about entries, such as a rank, states in letters has these entries."""

from collections.abc import Mapping
from typing import Any

from algebroproj_sym.replaying.evaluation import evaluate
from algebroproj_sym.replaying.field import Element, Field
from algebroproj_sym.replaying.letters.matrices import Coordinates, Entries
from algebroproj_sym.replaying.letters.reading import NUMBER, Letter, Shape, declared, parts_of, read
from algebroproj_sym.replaying.rejection import require, require_keys
from algebroproj_sym.replaying.text import Form, parse, parse_factors, texts

FREE = {"symmetric", "skew", "diagonal", "rotation", "unit"}
"""Properties that leave all coordinates free; a rank does as well."""
_FORMS = ("printed", "derived", "corrected")


def require_expansion(record: Mapping[str, Any]) -> None:
    """Require that the forms and conditions that a claim states in letters are, written out, what the claim is about.

    Each letter must be written out so that its coordinates reach all matrices of its kind, and no others.
    """
    stated = record["setting"]["stated"]
    require_keys(stated, {"letters"}, {*_FORMS, "nonzero"})
    forms = {name: text for name, text in stated.items() if name != "letters"}
    require(bool(forms) and bool(stated["letters"]), "nothing is stated in letters")
    letters = {name: declared(text) for name, text in stated["letters"].items()}
    shapes = {name: letter.shape for name, letter in letters.items()}
    free = {name: _free(name, letter) for name, letter in letters.items()}
    own = {name: [read(text, shapes) for text in _listed(text)] for name, text in forms.items()}
    parts = {part for nodes in own.values() for node in nodes for part in parts_of(node)}
    require({part.value for part in parts if part.kind == "letter"} == letters.keys(), "a letter does not occur")
    numbers = [part.value for part in parts if part.kind == "symbol"]
    names = [*numbers, *letters, *(name for each in free.values() for name in each.names)]
    require(len({*names}) == len(names), "two numbers of one name")
    field = Field({*names} - letters.keys())
    entries = Entries(field.algebra, {name: each.matrix(field.algebra) for name, each in free.items()}, {})
    for name, nodes in own.items():
        given = _given(record, name)
        shown = [(_shape(node.shape), [x for row in entries.of(node) for x in row]) for node in nodes]
        require(len(shown) == len(given), f"{name}: another number of forms is stated in letters")
        for (shape, values), form in zip(shown, given, strict=True):
            require(shape == form.shape, f"{name}: what is stated in letters has another shape")
            same: list[Element] = evaluate(form, field.algebra)
            equal = all((a - b).is_zero for a, b in zip(values, same, strict=True))
            require(equal, f"{name}: the entries are not those of what is stated in letters")


def _listed(given: Any) -> list[str]:
    return texts(given) if isinstance(given, list) else texts([given])


def _given(record: Mapping[str, Any], name: str) -> list[Form]:
    """Return the entries that a claim is about, a form each."""
    if name == "nonzero":
        return [*map(parse, texts(record["setting"].get("nonzero", [])))]
    if record["kind"] != "vanishing" or name == "derived":
        return [parse(record[name])]
    factors = parse_factors(record[name])
    return [Form((), factors.operations, (place,)) for place in factors.entries]


def _free(name: str, letter: Letter) -> Coordinates:
    found = Coordinates(name, letter)
    properties = letter.properties - ({"orthogonal"} if "rotation" in letter.properties else set())
    require(properties <= FREE or found.rank is not None, f"{name} has no free coordinates")
    require(not found.signs and ("rotation" not in properties or found.turns), f"{name} has no free coordinates")
    return found


def _shape(shape: Shape) -> tuple[Any, ...]:
    return () if shape == NUMBER else shape
