"""What tests and benchmarks know beforehand: exact answers, random cases, checks of any answer.

Both import from here, and never from each other.

Modules
-------
balls              between mpmath's numbers and Arb's balls, for long sums
crank_planetary    peak force, driving pairs and intervals by a search at 40 digits
hertz              line contact and Persson's conformal contact
rollers            compliance and load sharing of swinging rollers
precession         contact lines and meshing load by Carlson's integrals and quadrature
shaft              deflection by Mohr's integral
turns              what is largest over the turn of a mechanism as made, by bisection
cases              random mechanisms, gears and rollers, awkward ones well represented
hard_cases         stiff and extreme cases, each with its exact answer
fuzz               sends requests and checks every answer, with
fuzz_requests      random designs, hostile numbers and broken bodies, and
fuzz_invariants    what the mechanics demands of any answer
in_process         the service in this process, as a client sees it
answers            requests as people type them, and the exact value of every number of the answer
"""

from mpmath import mp

DIGITS = 40
mp.dps = DIGITS
