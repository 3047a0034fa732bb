"""Two pictures: whether the correlation (fundamental) matrix that pairs of points determine can be trusted.

`normalising` puts the pixels to scale, `estimating` finds the matrix of rank 2 by least squares and its covariance,
`critical` bounds the distance to the nearest critical configuration, `explaining` says why it is near and what helps,
and `judging` puts this together.  The convention is x2' F x1 = 0 for pixels x1 of the left and x2 of the right picture.
"""
