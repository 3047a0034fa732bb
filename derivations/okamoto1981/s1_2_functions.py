# %% [markdown]
# # 1.2 Functions
#
# The correspondence of two spaces as a function.

# %%
from algebroproj_derivations.okamoto1981.s1_2_space_correspondence import B, mapped, second_point
from algebroproj_sym import Section

section = Section("okamoto1981", "1.2", "Central projective one-to-one correspondence between two spaces: functions")

# %%
section.kernel(
    "collinearity.space_map",
    "Image of a point under the general central projective one-to-one correspondence of two spaces.",
    arguments={"B": B, "X": second_point},
    derived=mapped,
    claims=["8#matrix"],
    describe={
        "B": "Coefficients (B1, ..., B15); their units follow from those of the coordinates of both spaces.",
        "X": "Point (X2, Y2, Z2) of the second space; any unit of length.",
    },
    example={
        "B": (
            *("1.25", "0.125", "-0.25", "3.5", "-0.125", "1.375", "0.0625", "-2.25"),
            *("0.375", "-0.0625", "1.125", "0.75", "0.0125", "-0.005", "0.0025"),
        ),
        "X": ("12.5", "-7.25", "31.75"),
    },
)
