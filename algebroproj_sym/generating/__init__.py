"""Generating: from a kernel to a straight-line program to source.

graph (expressions without signs and repetitions) → sharing (common pairs) → lowering (a proved program)
→ compensation (twice the digits where sums may cancel) → choosing (among equal forms, on samples) → backends (a folder
each; expansion makes single numbers again for those that need it) → writing.  runtime has what the generated NumPy
package brings along.
"""
