"""Error against run time of the methods for one's own input.

Each study runs the methods that an engineer might use at several settings, measures the run time
of each (median of repeated runs) and its error against a reference of 40 digits (12 with clearance,
and of the line load at the ends of contacts, 11 of the pressure of contacts), and marks the method
that the calculators use. What cannot be had on the input is left out.

Modules, in reading order
-------------------------
study          a table of methods, run, timed and compared with a reference
rules          quadrature rules with a setting each
exact          ideal forces in multiple precision
peaks          largest force over the turn, ideal and with clearance; bending and slope of pins
means          mean total force, equivalent loads and reactions of bearings
turns          least room of pins in their holes, ends of what carries
contact        largest pressure of pin in hole
precession     contact-line length, meshing load, deflection of the shaft
rollers        load sharing by sorting, bisection, Newton
tolerance      percentiles over many pieces: their number against positions of each
"""
