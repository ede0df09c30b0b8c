"""All calculation of KHV Calc: plain functions over frozen dataclasses, no web and no plotting.

Conventions
-----------
Units are SI throughout: metre, newton, pascal, radian. Whoever needs millimetres or degrees
converts outside. Arguments are keyword-only. Indices that users see (satellite, pin, roller)
start at 1.

Crank-planetary reducer: the Y axis points up from the reducer's centre through pin 1 at crank
angle 0, X to the right; the crank turns clockwise (the direction of growing ``crank_angle``),
the pins turn the other way, ``ratio`` times slower.

Precessional gear: z along the axis of the central wheel, measured from the precession centre.

Start with `core.output.contact_force`, the forces and their peak, and `core.hertz`, what they do to
pin and hole; everything else is beside or below them.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
codes               what is refused, strained, not known: a code for each fact, its words
precision           what methods promise, and what is one number but for rounding
errors              what is refused, and why; what is worked out once, or not known; how wrong a
                    result may be, and what it strains
arrays              one function for a number and for arrays of designs; types
contact_life        how the limit of a pressure falls with the number of loads
bearings            rolling bearings by name, with the ratings of several makers
numerics            tools that know nothing of their use: quadrature, extremes, the inverse
load_sharing        one displacement shared by many unilateral contacts
fatigue             endurance limit by named factors, criteria, finite life
conformal           a pin in a hole that fits closely, of any two materials
hertz               elastic bodies in line contact, narrow or conformal, against their limits
drive               one planar network of bodies, contacts and springs in equilibrium
materials           what is known of a material, from where
material_table      a small table of them, and by which names they are found
output              the output mechanism: pins in the holes of satellites on cranks
tolerance           what tolerances of the output mechanism do
rollers             swinging rollers: stiffness, load sharing, bending stress, and their curves
precession          contact lines, meshing load and shaft deflection of the precessional gear
crank               bearings of the satellites, reactions and balance of the crankshaft
ring                teeth of satellite and ring: what passes, what carries
design              the design of a reducer as its JSON is nested, and what follows from it
checks              results against limits: checks of each machine element and their verdict
fixes               what cures a check
worked              how each number follows from others, formula by formula
work_precision      error against run time of the methods above
"""
