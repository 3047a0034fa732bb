# %% [markdown]
# # 0 Cross-references
#
# Does each reference of the paper lead to the formula, figure, table or subsection that it names?  The numbers follow
# from the places: headings are counted, and so are the formulas of a subsection from the number of its first one.  A
# caption has the number of the subsection that refers to it first.  Nothing of this is typed; it is counted in the
# outline of the paper.
#
# That a formula is the one that the sentence needs cannot be counted.  All references were read for that.  Those that
# lead to another formula are claims of their own in their sections, such as 2.2/ref-1.3.5.  Citations of the literature
# and items such as "item c" are not judged, and the caption of Fig. 1.6/1 is lost.

# %%
from algebroproj_sym import Section
from algebroproj_sym.declaring.quotes import counted, quotations
from algebroproj_sym.papers import paper_folders

section = Section("fundamentals1996", "0", "Cross-references")
(folder,) = paper_folders("fundamentals1996")

# %% [markdown]
# Three captions have the number of another subsection: two of 2.4 have that of 2.3, as its formulas do, and one of
# section 4 belongs to a subsection 3.5 that there is not.

# %%
SAME_FINDING = {"2.3": "2.4/ref-2.3", "3.5": "3.3/ref-3.5"}
for mark, place in counted(folder, quotations(folder).quotes.values()):
    section.reference(
        mark.claim,
        f"{mark.kind} {mark.number}, line {mark.line}",
        printed=mark.number,
        meant=place,
        same_as="" if mark.number == place else SAME_FINDING[mark.number],
    )
