"""Error against run time of the methods for one's own input.

Each study runs the methods that an engineer might use at several settings, measures the run time
of each (median of repeated runs) and its error against a reference of 40 digits (12 with
clearance), and marks the method that the calculators use. What cannot be had on the input is left
out.

Modules, in reading order
-------------------------
study          points, timing, choice
rules          quadrature rules with a setting each
turn_mean      means over the turn: equal steps, and rules between switching angles
peak_force     sampling, polished sampling, segment-exact, the papers' approximations
total_force    of the total force
satellite_bearing  of powers of the load of a satellite's bearing
crankshaft     of powers of the reaction of a crankshaft's bearing
pin_strength   largest bending stress or slope: equal steps against the search by arcs
mesh           contact-line length and meshing load, in phi as printed and in z
rollers        load sharing by sorting, bisection, Newton
shaft          Mohr's integral in closed form and by quadrature
load_sharing   peak with clearance and errors: sampling against narrowed summits
tolerance      percentiles over many pieces: their number against positions of each
"""
