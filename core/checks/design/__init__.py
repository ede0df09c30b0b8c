"""A crank-planetary reducer as its checks look at it, one step over the other; the last one is
`core.checks.crank_design.CrankDesign`.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
refusals            refusals of calculations in terms of a design's sections
given               the inputs, and what follows from them alone
forces              of the ideal mechanism, or of the one that is made
pins                how bending pins share the forces, and how strong they are
contact             the contact of pin and hole with the largest pressure
losses              friction and wear of the pins
"""
