"""Deriving: what else an equation says: its derivatives, at another index, solved for a letter, with numbers put in."""
