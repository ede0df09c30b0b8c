"""Design of a crank-planetary reducer and the results that follow from it.

The document is plain data, nested as its JSON is. Each result is calculated once, on first access,
or raises `NotKnown` with the reason why it is not known.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
tolerances          tolerances of the parts, by values, classes, a fit or a process
contact             pins in holes: sizes, clearance or fit, materials
sections            mechanism, load, pin, ..., requirements: each as far as it is given
ring                teeth or pins of the ring
layout              places along the axis, outer sizes, usual sizes of carrier and housing
document            the design made of these sections, paths in it, copies with other values
stated              the design of what a document states, with usual values and those of tables
refusals            refusals of calculations that name the field with its section
real_forces         forces with clearance, deviations and elasticity, in each direction
output_forces       forces on the output pins as the results below use them
pin_fatigue         fatigue strength of an output pin or ring pin
ring_results        results about the ring
losses              results about friction and wear of the output pins
crank_results       results about bearings and crankshaft
results             results of a design, one property each
curves              results over crank angles
diameters           diameters of pins and holes with their limits
drawings            satellites, ring pins and ring as they are drawn
mass                mass of each part, and inertia at the input
solids              parts as solids, by outlines and stretches of the axis
"""
