"""The mesh of satellite and ring: teeth as they are made, what passes, what carries.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
line_of_action      where involute teeth touch, their path, tips that pass each other
involute            an involute satellite in its ring: sizes, backlash, interferences
possible_teeth      whether any teeth mesh, by module, teeth and eccentricity alone
shift_choice        profile shifts that keep the tips apart, with the most contact
involute_load       what a torque does to these teeth: force, pressure, root, friction
shared_pairs        which of their pairs really carry, for information
"""
