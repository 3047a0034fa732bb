"""The command line: one file a command."""

from __future__ import annotations

import click

from algebroproj_sym.cli.audit import audit_command
from algebroproj_sym.cli.build import build
from algebroproj_sym.cli.check import check
from algebroproj_sym.cli.explain import explain
from algebroproj_sym.cli.export import export_group
from algebroproj_sym.cli.generate import generate
from algebroproj_sym.cli.group import Group
from algebroproj_sym.cli.mutate import mutate
from algebroproj_sym.cli.new import new
from algebroproj_sym.cli.replay import replay_command
from algebroproj_sym.cli.report import report
from algebroproj_sym.cli.study import study_group
from algebroproj_sym.cli.verify import verify

EPILOG = """
\b
Typical commands, in order:
  algebroproj new mypaper               a folder to start from
  algebroproj check mypaper             judge its claims
  algebroproj explain mypaper:1.2       printed, derived, verdict and evidence
  algebroproj build --derivations mypaper --name myfunctions
                                        prove, generate, verify, report; to out/
  algebroproj report mypaper            the same as a static site; to site/
  algebroproj check                     judge all installed papers

\b
Completion of commands and options by the Tab key, for bash (zsh and fish likewise):
  eval "$(_ALGEBROPROJ_COMPLETE=bash_source algebroproj)"

Exit status: 0 if everything is as declared, 1 if a claim or a check is not, 2 for wrong usage, 130 after Ctrl-C.
Colors are left out in a pipe, and where the environment variable NO_COLOR is set.
"""


@click.group(cls=Group, epilog=EPILOG, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="algebroproj-sym")
@click.option("-q", "--quiet", "verbosity", flag_value="quiet", help="Say nothing but what is wrong, and JSON.")
@click.option("-v", "--verbose", "verbosity", flag_value="verbose", help="Say also how long each step takes.")
@click.pass_context
def main(context: click.Context, verbosity: str | None) -> None:
    """Judge the formulas of papers, and compile what is proved to NumPy.

    A derivation module states what a paper prints and derives the same from the definitions.  Each claim gets a
    verdict with exact evidence; each kernel becomes a numeric function whose source is proved.
    """
    context.obj = verbosity or "normal"


for command in (
    *(new, check, explain, generate, verify, build, report, study_group),
    *(replay_command, audit_command, export_group, mutate),
):
    main.add_command(command)
