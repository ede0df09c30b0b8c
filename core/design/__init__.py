"""The design of a crank-planetary reducer and what follows from it.

The document is plain data, nested as its JSON is; its results stand beside it, each worked out when
it is asked for, once, or why it is not known.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
sections            mechanism, load, contact, pin, ..., requirements: each as far as it is given
ring                its teeth or pins
document            the design of these, paths in it, and the design with other values
refusals            refusals of calculations with the section of the field
real_forces         forces with clearance, deviations and elasticity, in each direction
output_forces       what the results below take of the forces on the output's pins
pin_fatigue         what the fatigue of a pin is judged by
ring_results        what follows about the ring
losses              what follows about friction and wear of the pins
crank_results       what follows about bearings and crankshaft
results             what follows from a design: one property for each result
curves              results over crank angles
drawings            satellites and pins of their ring as they are drawn
"""
