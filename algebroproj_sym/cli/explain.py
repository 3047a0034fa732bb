"""algebroproj explain: everything about a claim."""

import click

from algebroproj_sym.cli import options


@click.command()
@options.required_selectors
@options.output_as("text", "markdown", help="Format of the output. Markdown has formulas in LaTeX.")
@click.option("--full", is_flag=True, help="Show long forms and lists as a whole.")
@options.engine
def explain(selectors: tuple[str, ...], output: str, full: bool, engine: str) -> None:
    """Show one claim: the printed form, the derived form, the verdict and the evidence.

    SELECTOR names a claim, such as okamoto1981:24, or a section, module or folder, as for check.

    A long form is shown by the names of its parts, or by its beginning and its size. The option --full shows all of it.
    The exit status is 1 if a verdict is not the declared one.
    """
    from algebroproj_sym.cli.judging import require_as_declared
    from algebroproj_sym.cli.terminal import console, echo
    from algebroproj_sym.declaring import derivation_at, judge, kernels_on, located, quotations, split
    from algebroproj_sym.reporting.explaining import explanation
    from algebroproj_sym.reporting.findings import declared_consequence
    from algebroproj_sym.showing.display import markdown

    found = located(selectors)
    kernels = kernels_on((claim for _, claim in found), [split(selector)[0] for selector in selectors])
    judgements = []
    for derivation, claim in found:
        judgement = judge(claim, engine)
        judgements.append(judgement)
        if output == "markdown":
            echo(f"{markdown(judgement)}\n")
            continue
        functions = [k.qualified_name for k in kernels if k.paper == claim.paper and claim.number in k.claims]
        quote = quotations(derivation.path.parent).quotes.get(claim.number)
        paper = derivation_at(derivation.path.parent) if claim.follows else ()
        numbers = {other.number: other for module in paper for other in module.section.claims}
        follows = declared_consequence(claim, numbers)
        console().print(explanation(judgement, derivation.module, functions, quote, follows=follows, full=full))
    require_as_declared(judgements)
