"""The author, title and year of each paper, from a file beside the derivations."""

import tomllib
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

from algebroproj_sym import papers


@dataclass(frozen=True)
class Publication:
    """What is known of a paper."""

    key: str
    title: str
    """Its title, or the key if nothing is known."""
    author: str = ""
    """Family name first; empty if not known."""
    year: int | None = None
    """None for what is not a paper."""
    published: str = ""
    """Where it was published; empty if not known."""

    @property
    def origin(self) -> str:
        """The author, given name first, the year, and where it was published, as far as they are known."""
        family, _, given = self.author.partition(", ")
        return ", ".join(filter(None, (f"{given} {family}".strip(), str(self.year or ""), self.published)))


@cache
def publication(paper: str) -> Publication:
    """Return what is known of a paper."""
    known = tomllib.loads((files(papers.PAPERS) / "papers.toml").read_text(encoding="utf-8"))
    return Publication(paper, **known.get(paper, {"title": paper}))


def bibtex(entry: Publication) -> str:
    r"""Return the BibTeX entry of a paper, in ASCII; nothing for what has no author.

    Examples
    --------
    >>> print(bibtex(Publication("demo1900", "Squares", "Müller, A.", 1900)))
    @misc{demo1900,
      author = {M{\"u}ller, A.},
      title = {{Squares}},
      year = {1900},
    }
    """
    if not entry.author:
        return ""
    fields = {
        "author": entry.author,
        "title": f"{{{entry.title}}}",
        "year": str(entry.year or ""),
        "howpublished": entry.published,
    }
    lines = [f"  {name} = {{{_ascii(value)}}}," for name, value in fields.items() if value]
    return "\n".join([f"@misc{{{entry.key},", *lines, "}"])


def _ascii(value: str) -> str:
    for letter, plain in zip("äöüÄÖÜ", "aouAOU", strict=True):
        value = value.replace(letter, f'{{\\"{plain}}}')
    return value.replace("ß", r"{\ss}")
