"""The command line: one file a command."""

import click

from algebroproj_sym.cli.group import Group

SUMMARIES = {
    "new": "Write a folder DIR/NAME to start from.",
    "check": "Judge claims, and compare each verdict with the declared one.",
    "read": "Read the equations of a document, and judge each.",
    "explain": "Show one claim: the printed form, the derived form, the verdict and the evidence.",
    "generate": "Generate the functions, and write them to DIR/NAME.",
    "verify": "Prove the source of generated functions, and measure their errors.",
    "build": "Prove everything, generate and verify the functions, write ledger and report.",
    "report": "Prove everything, generate and verify the functions, write a site to DIR.",
    "study": "Run a numerical study, and write a dataset, figures and a short report.",
    "replay": "Check the verdicts of a LEDGER again, without the prover.",
    "audit": "Compare what claims say is printed with the LaTeX that they quote.",
    "export": "Write claims and error bounds as theorems for a proof assistant.",
    "mutate": "Change claims and functions in single places, and test whether the checks notice.",
}
"""The commands, each of a module of its own, and the first sentences of their help."""

EPILOG = """
\b
Typical commands:
  algebroproj read paper.tex            judge the equations of your own document
  algebroproj explain okamoto1981:24    show one formula, its verdict and the evidence
  algebroproj check                     judge all installed papers
  algebroproj new mypaper               write a folder to start from
  algebroproj check mypaper             judge its claims
  algebroproj build --derivations mypaper --name myfunctions
                                        prove, generate and verify; writes out/
  algebroproj report mypaper            do the same, and write a site to site/

\b
To complete commands with the Tab key in bash (zsh and fish are similar):
  eval "$(_ALGEBROPROJ_COMPLETE=bash_source algebroproj)"

Exit status: 0 if everything is as declared. 1 if a claim or a check fails. 2 if the command is wrong. 130 after Ctrl-C.
There are no colors in a pipe, or if the environment variable NO_COLOR is set.
"""


@click.group(cls=Group, summaries=SUMMARIES, epilog=EPILOG, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="algebroproj-sym")
@click.option("-q", "--quiet", "verbosity", flag_value="quiet", help="Print only what is wrong, and JSON.")
@click.option("-v", "--verbose", "verbosity", flag_value="verbose", help="Also print how long each step takes.")
@click.pass_context
def main(context: click.Context, verbosity: str | None) -> None:
    """Check the printed formulas of papers, and compile the proved ones to NumPy functions.

    A derivation module states what a paper prints, and computes the same from the definitions.  Each such claim is
    proved or refuted, with exact evidence.  Proved formulas can become NumPy functions, whose source is proved too.
    """
    context.obj = verbosity or "normal"
