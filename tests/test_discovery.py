"""Selectors name the claims of the contract, and derivations that refer to nothing are refused."""

import itertools
import subprocess
import sys
from pathlib import Path

import pytest

from algebroproj_sym import papers
from algebroproj_sym.declaring import (
    DeclarationError,
    Section,
    UnknownSelectorError,
    derivation_at,
    derivations,
    derivations_of,
    discovery,
    installed_papers,
    kernels,
    kernels_on,
    select,
)
from algebroproj_sym.pipeline import claims_of

PAPER = "fundamentals1996"
names = itertools.count()

MODULE = """
import sympy
from algebroproj_sym import Section
x = sympy.Symbol("x")
section = Section("{paper}", "{section}", "A title")
section.identity("{section}.1", "square", printed=x**2, derived=x * x)
{more}
"""
KERNEL = (
    'section.kernel("{name}", "F.", arguments={{"x": x}}, derived=x, claims=["{claim}"], '
    'example={{"x": "1"}}, describe={{"x": "A number."}})'
)


def numbers(*selectors):
    return [claim.number for claim in select(selectors)]


def module_text(section="9", more="", paper="mypaper"):
    return MODULE.format(paper=paper, section=section, more=more)


@pytest.fixture
def installed(monkeypatch, tmp_path):
    """Return a function that installs a package of papers of its own and returns the key of its paper."""

    def install(**modules):
        package, paper = f"papers_{next(names)}", f"paper{next(names)}"
        folder = tmp_path / package / paper
        folder.mkdir(parents=True)
        (tmp_path / package / "__init__.py").touch()
        (folder / "__init__.py").touch()
        for name, text in modules.items():
            (folder / f"{name}.py").write_text(text.replace("mypaper", paper))
        monkeypatch.syspath_prepend(tmp_path)
        monkeypatch.setattr(papers, "PAPERS", package)
        return paper

    yield install
    for name in [name for name in sys.modules if name.startswith("papers_")]:
        del sys.modules[name]


def test_the_paper_is_installed():
    assert PAPER in installed_papers()


def test_without_a_selector_every_claim_of_every_paper_is_selected():
    assert numbers() == numbers(*installed_papers())
    assert {claim.paper for claim in select()} == set(installed_papers())


def test_a_paper_key_selects_all_its_claims():
    assert numbers(PAPER) == [c.number for d in derivations(PAPER) for c in d.section.claims]
    assert len(numbers(PAPER)) > 300


def test_a_section_selects_its_claims_and_no_others():
    assert {claim.section for claim in select([f"{PAPER}:1.3"])} == {"1.3"}
    assert numbers(f"{PAPER}:1.3") == [claim.number for claim in select([PAPER]) if claim.section == "1.3"]


def test_a_section_contains_its_subsections():
    sections = {claim.section for claim in select([f"{PAPER}:1"])}
    assert sections == {claim.section for claim in select([PAPER]) if claim.section.startswith("1.")}
    assert len(sections) >= 6


def test_a_number_selects_one_claim():
    assert numbers(f"{PAPER}:1.3.8") == ["1.3.8"]
    assert numbers(f"{PAPER}:1.3/y03") == ["1.3/y03"]
    assert numbers(f"{PAPER}:1.3.5#mu1") == ["1.3.5#mu1"]


def test_a_number_selects_its_parts():
    selected = numbers(f"{PAPER}:1.3.5")
    assert {"1.3.5#mu1", "1.3.5#mu2", "1.3.5#mu3"} <= set(selected)
    assert all(number.startswith("1.3.5") for number in selected)


def test_a_number_is_no_prefix():
    assert numbers(f"{PAPER}:1.3.1") == ["1.3.1"]
    assert not any(claim.number.startswith("1.3.1") for claim in select([f"{PAPER}:1.3.2"]))


def test_several_selectors_name_each_claim_once():
    selected = numbers(f"{PAPER}:1.3.8", f"{PAPER}:1.3", f"{PAPER}:1.3.8")
    assert selected[0] == "1.3.8"
    assert sorted(selected) == sorted(numbers(f"{PAPER}:1.3"))


def test_the_path_of_an_installed_module_selects_its_claims(repository):
    path = repository / "derivations" / PAPER / "s1_3_properties_of_projection.py"
    assert select([str(path)]) == select([f"{PAPER}:1.3"])


def test_the_path_may_be_relative(repository, monkeypatch):
    monkeypatch.chdir(repository / "derivations")
    assert numbers(f"{PAPER}/s1_3_properties_of_projection.py") == numbers(f"{PAPER}:1.3")


def test_a_module_outside_is_selected_by_its_path(tmp_path):
    path = tmp_path / "my_derivation.py"
    path.write_text(module_text())
    (claim,) = select([str(path)])
    assert (claim.paper, claim.section, claim.number) == ("mypaper", "9", "9.1")
    assert [derivation.module for derivation in derivation_at(path)] == ["my_derivation"]


def test_a_module_outside_may_stand_beside_installed_claims(tmp_path):
    path = tmp_path / "my_derivation.py"
    path.write_text(module_text())
    assert numbers(f"{PAPER}:1.3.8", str(path)) == ["1.3.8", "9.1"]


@pytest.mark.parametrize("selector", ["nopaper", "nopaper:1.3", "", ":1.3", "Fundamentals1996", "1.3.8"])
def test_an_unknown_paper_is_refused(selector):
    with pytest.raises(UnknownSelectorError, match=rf"expected one of the papers .*{PAPER}") as raised:
        select([selector])
    assert repr(selector) in str(raised.value)


@pytest.mark.parametrize("part", ["9.9", "1.3.99", "1.3.5#mu9", "1.", "nonsense"])
def test_an_unknown_section_or_number_is_refused(part):
    with pytest.raises(UnknownSelectorError, match=rf"expected a section or number of {PAPER}") as raised:
        select([f"{PAPER}:{part}"])
    assert repr(part) in str(raised.value)


def test_one_unknown_selector_among_good_ones_is_refused():
    with pytest.raises(UnknownSelectorError):
        select([PAPER, f"{PAPER}:9.9"])


def test_a_path_that_does_not_exist_is_refused(tmp_path):
    missing = tmp_path / "missing.py"
    with pytest.raises(UnknownSelectorError, match="expected an existing derivation module") as raised:
        select([str(missing)])
    assert str(missing) in str(raised.value)


def test_a_module_without_a_section_is_refused(tmp_path):
    path = tmp_path / "empty.py"
    path.write_text("x = 1\n")
    with pytest.raises(UnknownSelectorError, match="expected a module that makes a Section") as raised:
        select([str(path)])
    assert str(path) in str(raised.value)


def test_papers_and_modules_are_found_in_a_package(installed):
    paper = installed(s2=module_text("2"), s1=module_text("1"), notation="y = 1\n")
    assert installed_papers() == (paper,)
    assert numbers() == numbers(paper) == ["1.1", "2.1"]


def test_an_imported_section_is_not_declared_again(installed):
    paper = installed(s1=module_text("1"), s2=module_text("2", more="from math import pi as other"))
    assert [derivation.module.rpartition(".")[2] for derivation in derivations(paper)] == ["s1", "s2"]
    assert all(isinstance(derivation.section, Section) for derivation in derivations(paper))


def test_kernels_are_sorted_by_module_and_keep_their_order(installed):
    lines = "\n".join(KERNEL.format(name=name, claim="1.1") for name in ("b.second", "a.last", "b.first", "a.early"))
    installed(s1=module_text("1", more=lines))
    assert [kernel.qualified_name for kernel in kernels()] == ["a.last", "a.early", "b.second", "b.first"]


def test_the_functions_that_rest_on_a_claim_are_named_in_the_text_of_a_module_with_its_number():
    """So importing the modules that name a number finds them."""
    for derivation in derivations_of():
        text = derivation.path.read_text("utf-8")
        for kernel in derivation.section.kernels:
            assert all(papers.may_name(text, number) for number in kernel.claims), kernel.qualified_name
            assert kernel in kernels_on(claims_of([kernel]))


def test_a_function_is_found_whose_name_is_computed(installed):
    computed = KERNEL.format(name="a.first", claim="1.1").replace('"a.first"', 'chr(97) + ".first"')
    last = KERNEL.format(name="a.last", claim="2.1")
    installed(s1=module_text("1", more=computed), s2=module_text("2", more=last), s3="section = Section(1/0)")
    assert [kernel.name for kernel in kernels(["a"])] == ["first", "last"]
    assert [claim.number for claim in claims_of(kernels(["a"]))] == ["1.1", "2.1"]


def test_a_false_claim_refers_to_a_declared_one(installed):
    more = 'section.identity("1.2", "", printed=x, derived=x + 1, expect="false", instead="1.3")'
    paper = installed(s1=module_text("1", more=more))
    with pytest.raises(DeclarationError, match=r"^1\.2: expected a reference to a declared claim, got 1\.3$"):
        derivations(paper)


def test_a_kernel_refers_to_a_declared_claim(installed):
    paper = installed(s1=module_text("1", more=KERNEL.format(name="m.f", claim="7.7")))
    with pytest.raises(DeclarationError, match=r"^m\.f: expected a reference to a declared claim, got 7\.7$"):
        derivations(paper)


def test_a_reference_may_lead_to_another_section(installed):
    more = 'section.identity("1.2", "", printed=x, derived=x + 1, expect="false", instead="2.1")'
    paper = installed(s1=module_text("1", more=more), s2=module_text("2", more=KERNEL.format(name="m.f", claim="1.1")))
    assert len(derivations(paper)) == 2


def test_a_number_is_declared_in_one_section_only(installed):
    paper = installed(s1=module_text("1"), s2=module_text("1"))
    with pytest.raises(DeclarationError, match=r"expected numbers that are declared once, got \['1\.1'\] twice"):
        derivations(paper)


def test_every_derivation_module_of_the_papers_declares_a_section(repository):
    found = {derivation.module.rpartition(".")[2] for derivation in derivations(PAPER)}
    files = {path.stem for path in Path(repository / "derivations" / PAPER).glob("s[0-9]*.py")}
    assert found == files - {"s4_example"}


@pytest.mark.parametrize("step", [20, pytest.param(4, marks=pytest.mark.whole)])
@pytest.mark.parametrize("paper", installed_papers())
def test_what_a_selector_names_is_found_in_the_modules_that_name_it(paper, step):
    """Importing the modules whose text may declare it finds all or nothing; after nothing, all modules are imported."""
    texts = {derivation.path: derivation.path.read_text("utf-8") for derivation in derivations(paper)}
    claims = [(d.path, claim) for d in derivations(paper) for claim in d.section.claims]
    parts = {claim.number for _, claim in claims} | {claim.number.partition("#")[0] for _, claim in claims}
    parts |= {claim.section[:end] for _, claim in claims for end in range(1, len(claim.section) + 1)}
    tried, found_at_once = sorted(parts)[::step], 0
    for part in tried:
        declaring = {path for path, claim in claims if discovery._names(part, claim)}
        imported = {path for path, text in texts.items() if papers.may_name(text, part)}
        assert declaring <= imported or not declaring & imported, part
        found_at_once += declaring <= imported
    assert found_at_once > 0.3 * len(tried), found_at_once


def found_alone(asked):
    """What a new process finds, and which modules of the papers it imports."""
    script = (
        "import sys; from algebroproj_sym import pipeline; from algebroproj_sym.declaring import kernels, select\n"
        f"{asked}\nprint(*(n for n in sys.modules if n.startswith('algebroproj_derivations.') and '.s' in n))"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    *found, modules = map(str.split, done.stdout.splitlines())
    return *found, [module.removeprefix("algebroproj_derivations.") for module in modules]


def test_a_number_is_found_without_importing_the_other_modules():
    found, modules = found_alone(f"print(*(c.number for c in select(['{PAPER}:2.1.9'])))")
    assert found == numbers(f"{PAPER}:2.1.9")
    assert len(found) > 3
    assert modules == ["fundamentals1996.s2_1_spatial_intersection"]


def test_functions_and_their_claims_are_found_without_importing_the_other_modules():
    asked = "found = kernels(['optics']); print(*(k.name for k in found))"
    functions, claims, modules = found_alone(f"{asked}; print(*(c.number for c in pipeline.claims_of(found)))")
    found = [kernel for kernel in kernels() if kernel.module == "optics"]
    assert functions == [kernel.name for kernel in found]
    assert {*claims} == {number for kernel in found for number in kernel.claims}
    assert modules == ["fundamentals1996.s1_6_optical_projection", "fundamentals1996.s1_6_functions"]


def test_the_functions_of_a_module_and_their_claims_are_those_of_all_modules():
    for module in {kernel.module for kernel in kernels()}:
        found = [kernel for kernel in kernels() if kernel.module == module]
        wanted = {(kernel.paper, number) for kernel in found for number in kernel.claims}
        assert [*kernels([module])] == found
        assert [*kernels([found[-1].qualified_name])] == found[-1:]
        assert [*claims_of(found)] == [claim for claim in select() if (claim.paper, claim.number) in wanted]
