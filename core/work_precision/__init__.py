"""Error against run time of the methods for one's own input.

A study compares the calculators' method with one or two others that an engineer might use: run time
(median of repeated runs) and error against a reference of 40 digits (12 of the real peak force).
Closed forms have one method, and no study.

Modules, in reading order
-------------------------
study          a table of methods, run, timed and compared with a reference
peaks          largest force over the turn, ideal and with clearance
precession     contact-line length, deflection of the shaft, by rules of quadrature
tolerance      percentiles over many pieces: their number against positions of each
"""
