"""Error against run time of the methods for one's own input.

Each study runs the methods that an engineer might use at several settings, measures the run time
of each (median of repeated runs) and its error against a reference of 40 digits (12 of the real
peak force), and marks the method that the calculators use. What cannot be had on the input is left
out. Closed forms have one method, and no study.

Modules, in reading order
-------------------------
study          a table of methods, run, timed and compared with a reference
peaks          largest force over the turn, ideal and with clearance
precession     contact-line length, deflection of the shaft, by rules of quadrature
tolerance      percentiles over many pieces: their number against positions of each
"""
