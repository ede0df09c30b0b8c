"""Precessional gear with a roller wheel: from the contact lines to the shaft's deflection.

The rollers of the central wheel stand parallel to its axis z at the radius R_C; z is measured from
the precession centre. In the roller frame y points from the axis through the roller's axis, z along
the axis, and x completes the frame; the polar angle phi of a contact point on the roller counts
from the side that faces the axis. The wheel's frame is that of a roller with position angle phi1 =
0.

Modules, in reading order
-------------------------
rollers           rollers, given one by one or as a wheel
contact_curve     points at which one roller can touch the satellite, and quadrature along them
contact_line      contact lines between their limits, lengths, points for drawing
meshing_load      line load, and the force and moment that the satellite passes on
line_contact      Hertz pressure along the lines, where the tooth's curvature is given
shaft             sections of the input shaft, its reactions and diagrams
shaft_deflection  deflection of the shaft at its bearings
shaft_strength    bending stress of the shaft, its static safety and fatigue
"""
