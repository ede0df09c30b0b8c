"""The mesh of a satellite's teeth with the ring.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
profile             a cycloid disc as it is cut: outline, curvature, undercut, points
approach            its approach to the ring's pins, in the place of that of pins in holes
sharing             forces, lag, play and stiffness at a position and over the turn
loss                sliding on the pins: loss, efficiency, pv
"""
