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

Modules, in reading order (each may use those above it)
-------------------------------------------------------
errors              what a calculation refuses, and why
results             accuracy and validity notices that every result carries
materials           elastic materials, effective modulus, a small table with sources
quadrature          integration rules with honest error estimates
load_sharing        one displacement shared by many unilateral contacts
mechanism           pins, satellites and cranks: phases of the pairs, dead centres, assembly
cyclogram           which pin/hole pairs drive, when, how many together
contact_force       force of each pair over the turn; the approximation of its peak
driving_set         the pairs that drive together, segment by segment of the turn
force_bounds        bounds of the force over a stretch, from what is known at its ends
force_laws          the force of the best placed pair under each law of load sharing
peak_force          the exact peak of the contact force
crank_planetary     forces, peak and approximations as one job
pin_geometry        pin and hole centres, contact points, clearance
hertz               line contact of pin and hole, and where Hertz stops being valid
roller_curves       roller stiffness, non-uniformity and stress as curves
roller_strength     stiffness, load non-uniformity and stress of swinging rollers
precession          contact lines, meshing load and shaft deflection of the precessional gear
work_precision      error against run time of the methods above
designs             the peak force, Hertz and rollers for arrays of designs
"""
