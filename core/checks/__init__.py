"""Checks of a design and its verdict: results against limits, each as data.

A check is a small function of a design, in the table of its machine element. Nothing passes by
absence: what is asked and not known is `not_checked` and leaves the verdict incomplete, what
nobody asked is `not_asked`.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
kinds               every check by code: title, formula, reasons, sources, what is left out
check               a value judged against its limit, and the verdict of all checks
design_check        a check as a function of a design and its results
pin_contact         pressure, shakedown and yield where pin and hole touch
pins                static strength, fatigue, deflection and slope of the pins
friction            efficiency, sliding speed, pv and wear
play                backlash and lost motion of the output
crank               bearings of the satellites, ring, crankshaft
crank_planetary     cranks, pins, holes and satellite; all checks of the reducer
largest_torque      the largest torque of the reducer as it is made
rollers             swinging rollers
shaft               the precessional gear and its shaft
"""
