"""Exact answers, found another way than in core, of which nothing is imported here.

Tests and benchmarks import from here and from ``tests.inputs``, and never from each other.

Modules
-------
balls              between mpmath's numbers and Arb's balls, for long sums
crank_planetary    peak force, driving pairs and intervals by a search at 40 digits
load_sharing       the mechanism with clearance and errors by false position
room               pins in their holes by plain distances
pin, pin_turn      a pin as finite elements, and what it feels over the turn
tie_ring           pins and the ring that joins them as a frame of finite elements
satellites         what satellites do at many angles, with
satellite_turn     their sums and shares over the turn
turns              what is largest over the turn of a mechanism as made, by bisection
stored             where the energy of all that gives at once is least, at 30 digits
losses, teeth      friction in pins and holes; whether teeth can exist
hertz, dissimilar  line contact and Persson's conformal contact
rims               what the load as a whole moves at a hole and a disc, by finite elements
involute           involute teeth by points and circles, their outlines, the rack that cuts them
checks             the contact of the reference design of the checks, by hand
rollers            compliance and load sharing of swinging rollers
precession         contact lines and meshing load by Carlson's integrals and quadrature
shaft              deflection by Mohr's integral
condition, work    what rounding of the input may do to a result, and what work something is
seeds              how many random cases are tried
answers            requests as people type them, and the exact value of every number of the answer
"""

from mpmath import mp

DIGITS = 40
mp.dps = DIGITS
