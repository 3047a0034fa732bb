"""The command line: one file a command."""

from __future__ import annotations

import click

from algebroproj_sym.cli.build import build
from algebroproj_sym.cli.check import check
from algebroproj_sym.cli.explain import explain
from algebroproj_sym.cli.generate import generate
from algebroproj_sym.cli.mutate import mutate
from algebroproj_sym.cli.replay import replay_command
from algebroproj_sym.cli.report import report
from algebroproj_sym.cli.verify import verify


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="algebroproj-sym")
def main() -> None:
    """Judge the formulas of photogrammetry papers, and compile what is proved to NumPy.

    Exit status: 0 if everything is as declared, 1 if a claim or a check is not, 2 for wrong usage.
    """


for command in (build, check, explain, generate, mutate, replay_command, report, verify):
    main.add_command(command)
