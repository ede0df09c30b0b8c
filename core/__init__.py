"""All calculations of KHV Calc: plain functions over frozen dataclasses, without web and plotting.

Units are SI throughout: metre, newton, pascal, radian; callers convert millimetres and degrees.
Arguments are keyword-only. Indices that users see (satellite, pin, roller) start at 1.

In the crank-planetary reducer the Y axis points up from the reducer's centre through pin 1 at crank
angle 0, and X points to the right. The crank turns clockwise, the direction of growing
``crank_angle``, and the pins turn the other way, ``ratio`` times slower. In the precessional gear z
runs along the axis of the central wheel and counts from the precession centre.

Start with `core.output.contact_force`, which has the forces and their peak, and with `core.hertz`,
which has the stress of pin and hole under them.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
codes               codes of refusals, notices and unknown results, with their texts
fields              inputs of the design document: their words, units and limits
precision           relative errors that methods promise, and tolerances of equality
errors              exceptions, results that may be unknown, stated errors and notices
arrays              functions that take a number or an array of designs; array types
contact_life        fall of the allowable contact pressure with the number of loads
bearings            rolling bearings by name, with load ratings of several makers
numerics            general tools: quadrature, extremes, inverse functions
load_sharing        one displacement shared by many unilateral contacts
fatigue             endurance limit by factors, fatigue criteria, finite life
conformal           conformal contact of a pin in a closely fitting hole, of any two materials
hertz               line contact of pin and hole, Hertzian or conformal, against its limits
drive               equilibrium of a planar network of bodies, contacts and springs
materials           properties of materials and their sources
material_table      the table of materials and the names by which they are found
output              the output mechanism: pins in the holes of satellites on cranks
tolerance           effect of tolerances on the output mechanism
rollers             swinging rollers: stiffness, load sharing, bending stress, curves
precession          contact lines, meshing load and shaft deflection of the precessional gear
crank               bearings of the satellites, reactions and balance of the crankshaft
ring                teeth of satellite and ring: geometry, meshing and load
design              the design of a reducer, nested as its JSON, and the results that follow
checks              results against limits: checks of each machine element and their verdict
fixes               changes of the inputs that make a failed check pass
proposal            whole reducers from a requirement, of parts that can be bought
worked              worked steps: each number derived from others, formula by formula
work_precision      error against run time of the methods above
"""
