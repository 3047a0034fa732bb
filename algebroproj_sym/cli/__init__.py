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
Typical commands:
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


@click.group(cls=Group, epilog=EPILOG, context_settings={"help_option_names": ["-h", "--help"]})
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


for command in (
    *(new, check, explain, generate, verify, build, report, study_group),
    *(replay_command, audit_command, export_group, mutate),
):
    main.add_command(command)
