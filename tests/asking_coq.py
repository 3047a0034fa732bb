"""One run of Coq for many cases: starting it and reading the real numbers takes longer than most proofs."""

from algebroproj_sym.exporting.compiling import compiled
from algebroproj_sym.files import write_texts


def complaint(lemmas, header, accepted, refused=()):
    """What Coq says against a text; one run finds out, too, that it refuses each of some others.

    A refused file changes nothing: after the command that says that its loading fails all is as before.
    """
    others = {f"refused_{place}": text for place, text in enumerate(refused)}
    fails = "".join(f'Fail Load "{name}".\n' for name in others)
    texts = {"tried.v": header + fails + accepted, **{f"{name}.v": text for name, text in others.items()}}
    write_texts(texts, lemmas)
    (found,) = compiled(lemmas, ["tried"])
    return found.error
