"""The output mechanism of a crank-planetary reducer: pins in the holes of satellites on cranks.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
mechanism           pins, satellites, cranks: phases, output; how pins fit, where they are
driving_set         the pairs that drive together, segment by segment of the turn
force_bounds        bounds of the force over a stretch, from what is known at its ends
force_laws          the force of the best placed pair under each law of load sharing
contact_force       which pairs drive, when, how many; their forces over the turn, the exact peak
losses              friction of the pins: sliding speed, loss, efficiency, pv, wear
pin_section         its section, solid or bored, and the wall about a bore
pin_beam            a pin as a beam on three kinds of supports: moment, shear, deflection, slope
pin_bolt            a bolt through a spacer as the pin: when it opens, slips or bends alone
tie_ring            a floating ring that joins the pins' ends: its forces, how it moves
pin_fatigue         what the fatigue of a pin is judged by, and the verdict on a cycle of stress
sampled_turn        forces over a turn at samples, and what is largest of them
ideal_turn          the ideal forces over a turn, sampled
worst_section       where along a pin and around it something is largest
loaded_pin          a pin under the forces of a turn: its largest stresses, its worst cycle
tied_pin            the same of pins that a tie ring joins
edge_load           line load at the ends of contacts whose pins slope
pin_strength        bending, shear, static safety, fatigue and deflection of the pins
conformal_law       the law of contact of a pin that wraps, as one curve
elasticity          what gives: contact of a pair, by its law; its pin; the satellites
room                what parts deviate, the room of pins in their holes, whether they go together
drives              discs on output pins, as `core.drive` takes them
stage               what shares a torque: positions as the engine solves them
real_mechanism      the mechanism as it is made: sizes, clearance, deviations, elasticity
fit                 what of a misfit elasticity takes up
loaded_position     its forces, lag, play and stiffness at one position
real_curves         curves of these over the turn, and of the lag over the torque
summits             summits of a function over the turn
turn                positions over the turn
real_cyclogram      which pairs really carry, when, how many together
real_turn           forces on pins, satellites and crank over the turn, sampled
over_turn           the same over the turn: peak, backlash, lost motion, transmission error
alternating         both directions of the torque, and the worse
"""
