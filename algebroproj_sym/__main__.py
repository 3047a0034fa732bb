"""Running the package as a module: ``python -m algebroproj_sym``."""

from algebroproj_sym.cli import main

main(prog_name="algebroproj")
