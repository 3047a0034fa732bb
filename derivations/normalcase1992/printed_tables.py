# %% [markdown]
# # 4 Numerical example: the tables, as printed
#
# Nothing is computed here, and what is printed is not typed again: the digits are those of the quotes.
#
# The eight points, in millimeters, and the matrix of correlation.

# %%
from pathlib import Path

from algebroproj_sym.declaring import quotations

quotes = quotations(Path(__file__).parent)
coordinates = quotes.decimals("4/coordinates#left")
LEFT = tuple(zip(coordinates[:8], coordinates[8:16], strict=True))
RIGHT_X, RIGHT_Y = coordinates[16:23], coordinates[23:]
z = quotes.decimals("4/Z#z11")
Z_PRINTED = tuple(zip(z[:3], z[3:6], z[6:], strict=True))

# %% [markdown]
# The error equations: five coefficients, parallax and weight.  Then the definitive rotations in gon.

# %%
TABLE = (*quotes.rows("4/errors", "phip", "kappap", "omega", "phipp", "kappapp", "deltap", "g").values(),)
ANGLES = ("phip", "kappap", "omega", "phipp", "kappapp")
DEFINITIVE = dict(zip(ANGLES, quotes.decimals("4/definitive#phip"), strict=True))

# %% [markdown]
# Not in the paper: what the definitive rotations leave, and the adjustment without the slips.

# %%
LEFT_OVER = ("0.350", "0.386", "0.336", "0.290", "0.318", "0.233", "0.507", "0.255")
BY_WEIGHTS = ("-0.0006", "-0.0006", "0.0001", "-0.0007", "-0.0005")
ADJUSTED = {
    "phip": ("-16.7281", "0.0223"),
    "kappap": ("-0.4617", "0.0099"),
    "omega": ("-0.8698", "0.0015"),
    "phipp": ("17.5613", "0.0343"),
    "kappapp": ("-0.1824", "0.0093"),
}
ADJUSTED_RESIDUALS = ("0.0069", "0.0968", "-0.0486", "-0.0006", "-0.0294", "-0.0422", "0.1272", "-0.1034")
