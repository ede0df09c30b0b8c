"""Mesh of satellite and ring: cycloid disc on ring pins, or involute planet in an involute ring.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
profile             cycloid disc as it is cut: outline, curvature, undercut
drives              ring and both meshes in series as `core.drive` takes them
sharing             forces, angular deflection, backlash, stiffness of the ring mesh
series              both meshes in series at one crank angle
series_turn         both meshes in series over the turns of one period
series_samples      forces of both meshes on pins, discs and eccentric over the turn
series_teeth        teeth of the discs as they work in series
series_study        tolerance study of both meshes in series
mesh_curves         curves of forces, angular deflections and gaps for drawings
loss                sliding on the ring pins: loss, efficiency, pv
bent_pins           forces on ring pins that bend between two supports
line_of_action      line of action of involute teeth, path of contact, tips
involute            involute planet in its ring: sizes, backlash, interferences
tooth_outline       outlines of involute teeth with their root fillets
possible_teeth      search for involute teeth that mesh at a given eccentricity
shift_choice        profile shifts that keep tips apart, with the most contact
involute_load       force, pressure, root stress and friction of involute teeth
shared_pairs        number of involute pairs that carry, for information
"""
