"""Deriving: what else an equation says.

By its derivatives (`derivatives`, `gradients`, `jacobians`), its integrals (`integrating`), at another index
(`indexed`), solved for a letter (`solving`), and with numbers put in (`instances`).  Vectors and tensors are read by
components (`crossed`, `summation`), and quaternions as matrices (`quaternions`).
"""
