"""Documents with vectors and matrices as letters: what follows, what contradicts, and what may never be said."""

import pytest

from algebroproj_sym.reading import (
    Symbols,
    UnreadableDocumentError,
    document_at,
    document_of,
    read_document,
    symbols_file,
    symbols_for,
)
from algebroproj_sym.reporting.readings import reading_lines, reading_record

pytestmark = pytest.mark.usefixtures("decided_here")

ROTATION = r"Let $R \in SO(3)$, $\mathbf{a} \in \mathbb{R}^3$ and $\mathbf{b} \in \mathbb{R}^3$. Then "
UNIT = r"where $\mathbf{n}$ is a unit vector and $I$ is the identity matrix \[ P = I - \mathbf{n}\mathbf{n}^T \] "


def readings(latex, given=None):
    return read_document(document_of(latex), given, seconds=30)


def last(latex, given=None):
    return readings(latex, given)[-1]


@pytest.mark.parametrize(
    "latex",
    [
        ROTATION + r"\[ (R\mathbf{a})\cdot(R\mathbf{b}) = \mathbf{a}^T R^T R \mathbf{b} = \mathbf{a}\cdot\mathbf{b} \]",
        ROTATION + r"\[ R(\mathbf{a} \times \mathbf{b}) = (R\mathbf{a}) \times (R\mathbf{b}) \]",
        ROTATION + r"\[ \mathbf{c} = R\mathbf{a} \] \[ \mathbf{c}^T\mathbf{c} = \|\mathbf{a}\|^2 \]",
        UNIT + r"\[ P^2 = P \]",
        UNIT + r"\[ P\mathbf{n} = 0 \]",
        r"For $R \in SO(3)$ we have \[ R^T R = I \]",
        r"Here $P$ and $Q$ are symmetric matrices. \[ (P Q)^T = Q P \]",
        r"Here $P$, $Q$ and $S$ are symmetric positive definite matrices. \[ (P Q S)^T = S Q P \]",
        r"\newcommand{\R}{\mathbf{R}} Let $\R$ be a rotation matrix. \[ \R^T\R\mathbf{x} = \mathbf{x} \]",
        r"the unit vector $\mathbf{n}$ \[ [\mathbf{n}]_\times^3 = -[\mathbf{n}]_\times \]",
        r"\[ \mathbf{u} = (A^T A)^{-1} A^T \mathbf{y} \] \[ A^T A\mathbf{u} = A^T\mathbf{y} \]",
        r"\[ (\mathbf{A}\mathbf{B})^T = \mathbf{B}^T\mathbf{A}^T \]",
        r"\[ (AB){}^T C = B^T A^T C \]",
        r"\[ [I_{3\times3}]\mathbf{v} = \mathbf{v} \]",
        r"\[ \mathbf{x} + \sum_i a_i \mathbf{b}_i = \sum_i a_i \mathbf{b}_i + \mathbf{x} \]",
        r"\[ {}^{W}\mathbf{R}_{B} \, {}^{B}\mathbf{p} - {}^{W}\mathbf{R}_{B} {}^{B}\mathbf{p} = 0 \]",
    ],
)
def test_what_holds_for_letters_follows(latex):
    assert last(latex).verdict == "follows"


@pytest.mark.parametrize(
    ("before", "claim", "verdict"),
    [
        ("", r"\det(A - \lambda I) = \lambda^2 - 4 \lambda + 3", "follows"),
        ("", r"\det(\lambda I - A) = (\lambda - 1) (\lambda - 3)", "follows"),
        ("", r"\det(s I - A) = s^2 - 4 s + 5", "independent"),
        ("Let $I$ be the identity matrix. ", r"\det(A - \lambda I) = \lambda^2 - 4 \lambda + 3", "follows"),
        ("Let $I$ be the inertia matrix. ", r"\det(A - \lambda I) = \lambda^2 - 4 \lambda + 3", "independent"),
        ("All entries of the matrix $I$ are one. ", r"\det(A - s I) = s^2 - 4 s + 3", "independent"),
    ],
)
def test_a_letter_like_the_identity_has_the_size_of_what_it_is_added_to(before, claim, verdict):
    found = last(before + r"\[ A = \begin{bmatrix} 2 & 1 \\ 1 & 2 \end{bmatrix} \] Hence \[ " + claim + r" \]")
    assert found.verdict == verdict


def test_a_letter_like_the_identity_is_read_as_it_where_that_follows():
    latex = r"the unit vector $\mathbf{n}$ \[ P = %s - \mathbf{n}\mathbf{n}^T \] \[ P^2 %s= P \] \end{document}"
    proved = last(latex % ("I", ""))
    assert proved.verdict == "follows"
    assert proved.links[0].reason == "read as P**2 = P"
    assert "I is the identity" in proved.links[0].hypotheses
    for others in (("I", "+ P "), ("J", "")):
        assert last(latex % others).links[0].reason == "the shapes fit only if n is a number"
    given = latex.replace(r"\[ P =", r"\[ I = 3\mathbf{n}\mathbf{n}^T \] \[ P =")
    assert last(given % ("I", "")).verdict == "independent"


@pytest.mark.parametrize("letter", "nmkl")
def test_a_size_that_nothing_says_is_no_number_of_the_text(letter):
    latex = rf"where $I$ is the identity matrix \[ \operatorname{{tr}}(I) \mathbf{{A}}I = {letter}\mathbf{{A}} \]"
    assert last(latex).verdict == "independent"


def test_a_proof_says_what_its_letters_are_taken_for():
    (link,) = last(r"the rotation matrix $R$ \[ R^T R \mathbf{x} = \mathbf{x} \]").links
    assert link.hypotheses == ("R is nxn rotation", "x is nx1")


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ R^T R\mathbf{x} = \mathbf{x} \]",
        r"Let $R$ and $S$ be rotation matrices or not. \[ R^T R\mathbf{x} = \mathbf{x} \]",
        r"if $R$ is a rotation matrix. \[ R^T R\mathbf{x} = \mathbf{x} \]",
        r"$R$ is not a rotation matrix \[ R^T R\mathbf{x} = \mathbf{x} \]",
        r"the derivative of the rotation matrix $R$ \[ R^T R\mathbf{x} = \mathbf{x} \]",
        r"The square of $A$ is the identity matrix. \[ A\mathbf{x} = \mathbf{x} \]",
        r"The symmetric part of the matrix $A$ is a symmetric matrix. \[ A^T\mathbf{x} = A\mathbf{x} \]",
        r"The products of $A$ and $B$ are symmetric matrices. \[ B^T\mathbf{x} = B\mathbf{x} \]",
        r"Neither $A$ nor $B$ are symmetric matrices. \[ B^T\mathbf{x} = B\mathbf{x} \]",
        r"$R$ is a rotation matrix only if $s = 1$. \[ R^T R\mathbf{x} = \mathbf{x} \]",
        r"$R$ and $S$ are rotation matrices when $s = 1$. \[ R^T R\mathbf{x} = \mathbf{x} \]",
        r"There is no such $R \in SO(3)$. \[ R^T R\mathbf{x} = \mathbf{x} \]",
        r"That $R \in SO(3)$ is false. \[ R^T R\mathbf{x} = \mathbf{x} \]",
        r"$A$ is the identity matrix times two. \[ A\mathbf{x} = \mathbf{x} \]",
        r"Here $Q$ represents the rotation matrix $R$. \[ Q^T Q\mathbf{x} = \mathbf{x} \]",
        r"the symmetric part $A$ \[ A^T\mathbf{x} = A\mathbf{x} \]",
        r"the symmetric matrix $A$, and later $A$ is a rotation matrix \[ A^T\mathbf{x} = A\mathbf{x} \]",
        r"\[ \mathbf{A}\mathbf{B} = \mathbf{B}\mathbf{A} \]",
        r"\[ T^{\mu\nu} + x = T^{\nu\mu} + x \]",
        r"\[ g_\mu^\nu h = g_\nu^\mu h \]",
        r"\[ f(a) \mathbf{x} + y \mathbf{x} = f(b) \mathbf{x} + y \mathbf{x} \]",
        r"\[ x + \foo = x + \bar\foo \]",
        r"\[ \int_0^1 \mathbf{f} = \int_0^2 \mathbf{f} \]",
    ],
)
def test_what_no_phrase_says_is_not_assumed(latex):
    assert last(latex).verdict in ("independent", "not decided")


@pytest.mark.parametrize(
    ("latex", "suggestion"),
    [
        (
            ROTATION + r"\[ \mathbf{c} = R\mathbf{a} \] "
            r"\[ R(\mathbf{a} + \mathbf{b}) = R\mathbf{a} + R\mathbf{b} = R\mathbf{b} - R\mathbf{a} \]",
            "",
        ),
        (
            r"Let $\mathbf{a} \in \mathbb{R}^3$ and $\mathbf{b} \in \mathbb{R}^3$. "
            r"\[ \mathbf{c} := \mathbf{a} + \mathbf{b} \] "
            r"\[ \mathbf{c}^T\mathbf{c} = \mathbf{a}^T\mathbf{a} + 3\mathbf{a}^T\mathbf{b} + \mathbf{b}^T\mathbf{b} \]",
            "2 instead of 3",
        ),
    ],
)
def test_what_fails_for_letters_of_stated_sizes_contradicts(latex, suggestion):
    found = last(latex)
    assert found.verdict == "contradicts"
    link = found.links[-1]
    assert link.counterexample
    assert link.suggestion if not suggestion else link.suggestion == suggestion


def test_what_fails_for_letters_of_unknown_size_contradicts_nothing():
    found = last(r"\[ \mathbf{c} := \mathbf{a} + \mathbf{b} \] \[ \mathbf{c}^T = \mathbf{a}^T - \mathbf{b}^T \]")
    assert (found.verdict, found.links[0].reason) == (
        "independent",
        "the document does not state the sizes of its matrices",
    )


def test_properties_and_sizes_come_from_the_symbols_file(tmp_path):
    path = tmp_path / "symbols.toml"
    path.write_text("[[table]]\nsizes = { 'S' = [3, 3] }\nproperties = { 'S' = \"symmetric\" }\n")
    latex = r"\[ S^T\mathbf{x} = S\mathbf{x} \]"
    assert last(latex).verdict == "independent"
    assert last(latex, symbols_file(path)).verdict == "follows"
    assert symbols_for("1", "1.1", symbols_file(path).tables)("S").shape == (3, 3)
    path.write_text("[[table]]\nproperties = { 'S' = 'symetric' }\n")
    with pytest.raises(UnreadableDocumentError, match=r"properties, S: expected one of rotation, .* got 'symetric'"):
        symbols_file(path)


def test_no_table_no_symbol():
    assert Symbols(())(r"\mathbf{x}") is None


def test_a_redefined_macro_means_what_it_last_said():
    latex = r"\newcommand{\v}{a} \[ x := \v \] \renewcommand{\v}{b} \[ y := \v \] \[ x - y = a - b \]"
    assert [each.read for each in readings(latex)] == ["x := a", "y := b", "x - y = a - b"]
    assert last(latex).verdict == "follows"


def test_included_files_are_read_within_bounds(tmp_path):
    (tmp_path / "main.tex").write_text(
        "\\usepackage{own}\n\\input{part}\n% \\input{not}\n\\[ \\s = 2 \\]\n\\input{../up}"
    )
    (tmp_path / "own.sty").write_text(r"\newcommand{\s}{x}")
    (tmp_path / "part.tex").write_text("a\n\n\\[ y = 1 \\]\n\\input{main}\\input{part}")
    (tmp_path / "not.tex").write_text(r"\[ z = 0 \]")
    (tmp_path.parent / "up.tex").write_text(r"\[ z = 0 \]")
    document = document_at(tmp_path / "main.tex")
    found = read_document(document, seconds=30)
    assert [(str(each.where), each.read) for each in found] == [("line 3 of part.tex", "y = 1"), ("line 4", "x = 2")]
    assert document.missing == ("../up",)
    assert reading_record(found, document.missing)["equations"][0]["file"] == "part.tex"
    shown = [*reading_lines("main.tex", found, document.missing, full=False)]
    assert shown[0] == "definition: line 3 of part.tex; line 4"
    assert shown[1].startswith("the included file ../up is not in the folder")
    for place in range(102):
        (tmp_path / f"wide{place}.tex").write_text(f"\\input{{wide{place + 1}}} " * 200)
    with pytest.raises(UnreadableDocumentError, match="at most 100 included files, got more"):
        document_at(tmp_path / "wide0.tex")


@pytest.mark.parametrize(
    "latex",
    [
        r"\[ " + r"{}^".join("abc" * 2000) + r" = 1 \]",
        r"\[ \leftidx" * 500 + r" \]",
        r"\[ \mathbf{a}" + r"\times\mathbf{a}" * 3000 + r" = 0 \]",
        r"\[ \mathbf{A}^{99} = \mathbf{A} \]",
        r"\[ " + "{a " * 2000 + r"\over b}" * 2000 + r" = 1 \]",
        r"\[ \binom{999999999}{3} = 999999999! \]",
        "".join(rf"\[ E(X_{{{i + 1}}}) = 2 E(X_{{{i}}}) + E(Y_{{{i}}}) \]" for i in range(20)) + r"\[ E(X_{20}) = 1 \]",
        "".join(rf"\[ c_{{{i}}} - c_{{{i + 1}}} = k \]" for i in range(30)) + r"\[ \sum_{k=1}^n c_0 = n c_0 \]",
        "".join(rf"\[ \mathbf{{v}}_{{{i + 1}}} := \mathbf{{v}}_{{{i}}} + \mathbf{{v}}_{{{i}}}^T \]" for i in range(40)),
        "".join(rf"\[ \mathbf{{M}}_{{{i + 1}}} := \mathbf{{M}}_{{{i}}}\mathbf{{M}}_{{{i}}} \]" for i in range(60))
        + r"\[ \mathbf{M}_{60} = 0 \]",
    ],
)
def test_what_has_no_end_is_not_decided_within_bounds(latex):
    assert last(latex).verdict in ("not read", "not decided", "independent", "definition")


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"\[ P = (1 - K H) Q \] \[ P = Q - K H Q \]", "follows"),
        (r"\[ P = (1 - K H) Q \] \[ P = Q (1 - K H) \]", "independent"),
        (r"\[ P = (1 - K H) Q \] \[ P = Q - H K Q \]", "independent"),
        (r"\[ \mathbf{b} = (1 - A A^T) \mathbf{y} \] \[ \mathbf{b} = \mathbf{y} - A A^T\mathbf{y} \]", "follows"),
        (
            r"\[ s = 1 - \mathbf{u}^T\mathbf{u} \] \[ s \mathbf{y} = \mathbf{y} (1 - \mathbf{u}^T\mathbf{u}) \]",
            "follows",
        ),
        (r"\[ \mathbf{b} = \mathbf{y} + 1 \] \[ \mathbf{b} - \mathbf{y} = 1 \]", "not decided"),
        (r"\[ \mathbf{M} = 1 + \mathbf{A} \] \[ \mathbf{M}^2 = 1 + 2 \mathbf{A} + \mathbf{A}^2 \]", "follows"),
        (r"\[ \mathbf{M} = 1 + \mathbf{A B} \] \[ \mathbf{M}^T = 1 + \mathbf{A}^T \mathbf{B}^T \]", "independent"),
    ],
)
def test_one_beside_a_square_matrix_is_the_identity(latex, verdict):
    given = r"\[ \mathbf{x} = \mathbf{z} + K (\mathbf{y} - H \mathbf{z}) \] "
    assert read_document(document_of(given + latex))[-1].verdict == verdict


@pytest.mark.parametrize(
    ("latex", "verdict"),
    [
        (r"It has the phase function $g$. \[ a = b g. \] Hence \[ b = a/g. \]", "follows"),
        (
            r"It has the phase function $g$. \[ a = b g. \] \[ w = g(\mu). \] Hence \[ b = a/g. \]",
            None,
        ),
        (
            r"The kernel matrices are $K$ and $L$. \[ Q = K L^{-1} K^T \] Hence \[ Q + K = K (L^{-1} K^T + I) \]",
            "follows",
        ),
        (r"The map $T$ is not linear. \[ y = T x. \] \[ z = T u. \] Hence \[ y + z = T x + T u. \]", None),
        (r"Let $f$ and $g$ be functions. \[ h = f g. \] Hence \[ h = g f. \]", None),
    ],
)
def test_what_is_called_a_function_is_a_factor_if_it_has_no_argument_anywhere(latex, verdict):
    found = read_document(document_of(latex), seconds=5)[-1].verdict
    assert found == verdict if verdict else found != "follows"
