"""What equations above one say at another index, as ``x_2 = a x_1`` where ``x_{k+1} = a x_k`` was said."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from algebroproj_sym.reading.defining.definition import Definition
from algebroproj_sym.reading.defining.premises import Premise, letter_of
from algebroproj_sym.reading.defining.recognising import defined_by
from algebroproj_sym.reading.defining.vocabulary import Vocabulary
from algebroproj_sym.reading.deriving.indices import Indices, Item, excludes, indices_in, is_moved, told
from algebroproj_sym.reading.parsing.grammar import Formula, symbols_in

MOST_INSTANCES = 6
"""How many equations at other indices are put in, one into the other."""


def instances(
    sources: Sequence[Definition], vocabulary: Vocabulary, indices: Indices, sides: Sequence[Formula]
) -> Iterator[tuple[Definition, str]]:
    """Yield what equations say at another index of the letters of some sides, each with what is put for the index.

    Where a letter stands alone on a side, only it is given, and what it is given by in turn.
    """
    symbols = [symbol for side in sides for symbol in symbols_in(side)]
    waiting = [symbol for side in sides if (symbol := defined_by(side)[0])] or symbols
    lone, seen, left = {*waiting}, {*symbols} - {*waiting}, MOST_INSTANCES
    while waiting and left:
        symbol = waiting.pop(0)
        if symbol in seen:
            continue
        seen.add(symbol)
        if (known := vocabulary.definitions.get(symbol)) is not None:
            waiting += known.symbols
            if symbol not in lone:
                continue
        for source in reversed(sources):
            put = indices.put_for(source.symbol, symbol)
            if put is None or not is_moved(put):
                continue
            if (tree := _at(source.tree, letter_of(source.symbol), put, vocabulary, indices)) is not None:
                yield replace(source, symbol=symbol, tree=tree, role="case"), told(put, vocabulary.name)
                waiting += symbols_in(tree)
                left -= 1
                break


def instance_of(
    premise: Premise, vocabulary: Vocabulary, indices: Indices, symbols: Collection[str]
) -> tuple[Premise, str] | None:
    """Return an equation at another index, of some symbols alone, with what is put for it; None if there is none."""
    ours = sorted(symbol for symbol in premise.symbols if indices_in([symbol], indices))
    for symbol in sorted(symbols) if ours else ():
        put = indices.put_for(ours[0], symbol)
        if put is None or not is_moved(put):
            continue
        left, right = (
            _at(side, other, put, vocabulary, indices)
            for side, other in ((premise.left, premise.right), (premise.right, premise.left))
        )
        if left is not None and right is not None and {*symbols_in(left), *symbols_in(right)} <= {*symbols}:
            return replace(premise, left=left, right=right), told(put, vocabulary.name)
    return None


def sources_of(
    premises: Sequence[Premise], vocabulary: Vocabulary, indices: Indices, part: int, cited: frozenset[str]
) -> tuple[list[Definition], list[Premise]]:
    """Return what may hold at other indices, of a section or cited: what gives a letter with one, and the rest."""
    names = tuple(f"({name})" for name in cited)
    definitions = [
        each
        for each in vocabulary.definitions.values()
        if each.usable
        and each.role != "case"
        and not (each.parameters or each.context.kind or excludes(each.words))
        and (each.part == part or each.where.startswith(names))
    ]
    asserted = [
        each
        for each in premises
        if not (each.special or each.context.kind or excludes(each.words)) and (each.part == part or each.names & cited)
    ]
    given = [each.gives for each in asserted if each.gives is not None and not each.gives.parameters]
    others = [each for each in asserted if each.gives is None or not indices_in([each.gives.symbol], indices)]
    return [*definitions, *given], others


def _at(
    tree: Formula, other: Formula, put: dict[str, Item], vocabulary: Vocabulary, indices: Indices
) -> Formula | None:
    """Return a side at other indices; None if the document keeps it from holding there."""
    both: Formula = type(tree)("items", [tree, other])
    moved = {letter: item for letter, item in put.items() if item != (letter, 0)}
    fixed = [each for each in symbols_in(both) if each not in moved and not indices_in([each], indices) & {*moved}]
    hidden = indices_in(frozenset().union(*map(vocabulary.hidden_in, fixed)), indices) & {*moved}
    if hidden or any(vocabulary.depends(fixed, letter) for letter in moved) or not indices.allows(put, both):
        return None
    return indices.at(tree, put)
