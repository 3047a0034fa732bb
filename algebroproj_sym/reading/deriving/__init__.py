"""Deriving: what else an equation says.

By its derivatives, its integrals (`integrating`), at another index (`indexed`), solved for a letter (`solving`), and
with numbers put in (`instances`).  Vectors and tensors are read by components (`crossed`, `summation`), and quaternions
as matrices (`quaternions`).

`derivatives` lists the rules of calculus.  They differentiate by letters of a formula (`slopes`) with others `fixed`,
from known rates (`totals`), in sums (`summed`), by components (`jacobians`), what an equation ties (`implicit`), and
through other letters (`chains`, `through`).  Operators are worked out (`operating`), and derivatives are taken at
`places` and along directions (`gradients`).
"""
