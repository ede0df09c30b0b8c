"""Checks of a design and its verdict: results against limits, each as data.

A check is a small function of a design, in the module of its machine element, with a record of its
title, inputs, needs and limits. Similar elements such as rolling bearings are table rows with the
codes of their checks, so that each sort of check is written once. A required value that is not
known gives `not_checked` and leaves the verdict incomplete; a value without a requested limit gives
`not_asked`. No check passes because data are absent.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
inputs              inputs that checks of several elements depend on
check               record of a check, value against limit, verdict of parts and of all checks
teeth               geometry of teeth and lobes: contact, tips, undercut, roots, interference
contacts            contacts in holes and in the ring: pressure, shakedown, yield, plastics
pins                bending pins of output and ring: strength, fatigue, deflection, slope, bolts
demands             limits a user may request: play, evenness, efficiency, sliding, wear, seats
walls               fit of parts: room of pins in holes, walls and gaps, sleeves, space
bearings            bearings of satellites, crankshaft and rollers on pins: life, load, room, speed
balance             unbalance of the parts that turn with the crankshaft
crank_planetary     all checks of the reducer under its torque, and verdicts of its parts
reserve             final verdict with a tenth more torque, and the torque of the first failure
words               groups of checks, sources, subjects left out
shares              shares of the torque that satellites carry, and checks that depend on them
cold_yield          torque at which a plastic contact yields at once
usual_fit           verdict with a usual clearance where none is known
usual_modification  verdict with a usual disc modification and usual places of ring pins
plain               checks of swinging rollers, and of the precessional gear and its shaft
records             all checks, by code
"""
