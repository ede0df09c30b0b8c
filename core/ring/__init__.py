"""The mesh of satellite and ring: teeth as they are made, what passes, what carries.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
profile             a cycloid disc as it is cut: outline, curvature, undercut, points
drives              a ring on its discs, and both meshes in series, as `core.drive` takes them
sharing             forces, lag, play and stiffness at a position and over the turn
series              both meshes in series: forces, lags, play and stiffness at a position
series_turn         the same over the turns after which all repeats
series_samples      forces of both on pins, satellites and crank over the turn, at samples
series_teeth        the teeth as they work in series
series_study        what tolerances do to these
mesh_curves         forces, lags and gaps of the teeth over the turn, as they are drawn
loss                sliding on the pins: loss, efficiency, pv
bent_pins           forces on the pins, by which those bend that are held at both ends
line_of_action      where involute teeth touch, their path, tips that pass each other
involute            an involute satellite in its ring: sizes, backlash, interferences
tooth_outline       outlines of both, with the roots that hob and cutter leave
possible_teeth      whether any teeth mesh, by module, teeth and eccentricity alone
shift_choice        profile shifts that keep the tips apart, with the most contact
involute_load       what a torque does to these teeth: force, pressure, root, friction
shared_pairs        which of their pairs really carry, for information
"""
