"""Worked steps: how each number of an answer follows from others, formula by formula.

A step holds what core has calculated; a closed formula is held against that by a test, and
calculates nothing. A sum over pairs, a search, an equilibrium says its method and the numbers that
go in. A function of steps fills a sheet in the order in which one reads it.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
step                a step, and the sheet on which steps follow each other
words               what steps say by code, in English
members             crank, pins and ring: ratio, torques, speeds, powers
fatigue             a stress cycle: its limit by factors, its safety
hertz               the contact of pin and hole
mechanism           cyclogram, contact force, clearance
pins                strength of the pins
losses              friction and wear of the pins
crank               bearings of the satellites, crankshaft, balance
pin_rollers         rolling bearings as rollers on the pins
precession          the precessional gear and its shaft
ring                satellites in their ring: cycloid discs on pins, involute teeth
rollers             swinging rollers
"""
