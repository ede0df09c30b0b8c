"""Output mechanism of a crank-planetary reducer: output pins in the holes of discs on eccentrics.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
mechanism           pins, discs, eccentrics: phases, members, fit and places of pins in holes
driving_set         pairs that drive together, segment by segment of the turn
force_bounds        bounds of the force over a stretch, from what is known at its ends
force_laws          force of the best placed pair under each law of load sharing
contact_force       pairs that drive and when, forces over the turn, the exact peak
pin_section         section of a pin, solid or bored, and the wall about the bore
pin_beam            a pin as a beam on several kinds of supports: moment, shear, deflection
pin_bolt            a bolt through a spacer as the pin: opening, slipping, bending alone
tie_ring            floating ring that joins the pins' ends: forces and movement
pin_fatigue         fatigue verdict on a cycle of stress of a pin
sampled_turn        forces over a turn at samples, and their largest values
ideal_turn          ideal forces over a turn, sampled
pin_circle_load     torque on a circle of pins, and the forces that balance it
losses              friction of the pins: sliding speed, loss, efficiency, pv, wear
worst_section       search along and around a pin for the place of a largest value
loaded_pin          a pin under the forces of a turn: largest stresses, worst cycle
tied_pin            pins that a tie ring joins, under the forces of a turn
edge_load           line load at the ends of contacts whose pins slope
pin_strength        bending, shear, static safety, fatigue and deflection of the pins
conformal_law       contact law of a pin that fits closely in its hole, as one curve
elasticity          elasticity of contacts, pins and satellite supports
room                deviations of parts, room of pins in their holes, assembly
drives              discs on output pins, as `core.drive` takes them
stage               solved positions of a stage whose discs share a torque
real_mechanism      mechanism as made: sizes, clearance, deviations, elasticity
fit                 part of a misfit that elasticity takes up
loaded_position     forces, angular deflection, play and stiffness at one position
real_curves         curves over the turn, and of the angular deflection over the torque
summits             summits of a function over the turn
turn                solved positions over the turn under a torque
real_cyclogram      pairs that carry under a torque, when, and how many together
real_turn           sampled forces on pins, discs and crank of the mechanism as made
over_turn           peak force, backlash, lost motion, transmission error of a turn
alternating         both directions of the torque, and the worse one
"""
