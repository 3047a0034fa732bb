"""The site: what was judged and generated as pages that open from disk, without a network or a script.

catalogue (what there is) → formulas, comparison, evidence, plots (as HTML) → pages → folder (written as a whole).
"""
