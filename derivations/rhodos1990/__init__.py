"""G. Brandstätter, On the importance of projective geometry for photogrammetric restitution, 1990: the first page."""
