r"""The files of a document: what it includes, and the whole of which it is a chapter."""

import json

import pytest
from click.testing import CliRunner

from algebroproj_sym.cli import main
from algebroproj_sym.reading import document_at, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

WHOLE = r"""\documentclass{book}
\newcommand{\s}{x}
\newcommand{\t}{y}
\begin{document}
\newcommand{\t}{z}
\[ \s = 0 \]
\include{parts/one}
\end{document}
"""


def written(folder, **files):
    for name, text in files.items():
        path = folder / name.replace("__", "/").replace("_", ".")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def found_at(path):
    document = document_at(path)
    return document.whole, [(str(each.where), each.read) for each in read_document(document, seconds=30)]


@pytest.mark.parametrize(
    ("head", "whole"),
    [
        ("% !TEX root = ../main.tex\n", WHOLE),
        ("%!TeX root=../main\n", WHOLE),
        ("\\documentclass[../main.tex]{subfiles}\n", WHOLE),
        ("\n", WHOLE),
        ("\n", WHOLE.replace(r"\include{parts/one}", r"\import{parts/}{one.tex}")),
        ("\n", WHOLE.replace(r"\include{parts/one}", r"\subfile{parts/one.tex}")),
    ],
)
def test_a_chapter_has_the_macros_of_its_whole(tmp_path, head, whole):
    written(tmp_path, main_tex=whole, parts__one_tex=head + r"\[ \s = \t + 1 \]")
    assert found_at(tmp_path / "parts/one.tex") == ("../main.tex", [("line 2", "x = y + 1")])


@pytest.mark.parametrize(
    ("head", "whole"),
    [
        ("% the root = ../main.tex\n", WHOLE.replace("one", "two")),
        ("\\documentclass{book}\n", WHOLE),
        ("\n", WHOLE.replace(r"\include", r"% \include")),
        ("\n", WHOLE.replace(r"\documentclass{book}", "")),
        ("% !TEX root = one.tex\n", WHOLE),
        ("% !TEX root = ../none.tex\n", WHOLE),
        ("% !TEX root = ../other/main.tex\n", WHOLE),
        ("% !TEX root = ../main.sty\n", WHOLE),
    ],
)
def test_what_is_no_chapter_has_its_own_macros(tmp_path, head, whole):
    written(tmp_path, main_tex=whole, main_sty=whole, other__main_tex=whole, parts__one_tex=head + r"\[ a = b + 1 \]")
    assert found_at(tmp_path / "parts/one.tex") == ("", [("line 2", "a = b + 1")])


def test_a_whole_may_be_a_few_folders_above_and_not_further(tmp_path):
    written(tmp_path, main_tex=WHOLE.replace("parts/one", "a/b/c/one"), a__b__c__one_tex=r"\[ \s = 1 \]")
    assert found_at(tmp_path / "a/b/c/one.tex") == ("../../../main.tex", [("line 1", "x = 1")])
    written(tmp_path, main_tex=WHOLE.replace("parts/one", "a/b/c/d/one"), a__b__c__d__one_tex=r"\[ a = b \]")
    assert found_at(tmp_path / "a/b/c/d/one.tex") == ("", [("line 1", "a = b")])


def test_packages_and_classes_beside_a_document_define_macros(tmp_path):
    written(
        tmp_path,
        main_tex="\\documentclass[11pt]{own}\n\\usepackage{amsmath, mine,yours}\n\\[ \\p = \\q + \\r \\]",
        own_cls=r"\LoadClass{article}\RequirePackage{deep}",
        deep_sty=r"\newcommand{\p}{a}",
        mine_sty=r"\newcommand{\q}{b}",
        yours_sty=r"\newcommand{\r}{c}",
    )
    assert found_at(tmp_path / "main.tex") == ("", [("line 3", "a = b + c")])


def test_the_files_of_a_chapter_are_in_the_folder_of_its_whole(tmp_path):
    whole = WHOLE.replace(r"\newcommand{\s}{x}", r"\input{macros}")
    written(tmp_path, main_tex=whole, macros_tex=r"\newcommand{\s}{x}", parts__more_tex=r"\[ \s = 2 \]")
    written(tmp_path, parts__one_tex="\\input{parts/more}\n\\[ \\s = 3 \\]")
    assert found_at(tmp_path / "parts/one.tex") == (
        "../main.tex",
        [("line 1 of parts/more.tex", "x = 2"), ("line 2", "x = 3")],
    )


def test_the_command_names_the_whole(tmp_path):
    written(tmp_path, main_tex=WHOLE, parts__one_tex=r"\[ \s = \t + 1 \]")
    chapter = str(tmp_path / "parts/one.tex")
    shown = CliRunner().invoke(main, ["read", chapter]).output
    assert "its macros are those of ../main.tex, of which it is a part" in shown
    assert json.loads(CliRunner().invoke(main, ["read", "--format", "json", chapter]).output)["whole"] == "../main.tex"
