"""Checks of a design and its verdict: results against limits, each as data.

A check is a small function of a design in the module of its machine element, with its record: its
name, what it depends on, needs, asks. Elements of a sort, as rolling bearings, are rows with the
codes of their checks; each sort of check is written once. Nothing passes by absence: a value that
is asked and not known is `not_checked` and leaves the verdict incomplete, one that nobody asked is
`not_asked`.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
inputs              inputs that checks of several elements depend on
check               a check and its record, a value against its limit, the verdict of parts and all
teeth               teeth and lobes by geometry alone: contact, tips, undercut, roots, interference
contacts            what presses, in holes and in the ring: pressure, shakedown, yield, plastics
pins                pins that bend, of output and ring: strength, fatigue, deflection, slope, bolts
demands             what somebody may ask: play, evenness, efficiency, sliding, wear, seats
walls               what goes together: room of pins in holes, walls and gaps, sleeves, space
bearings            of satellites and crankshaft, and as rollers on pins: life, load, room, speed
balance             what turns with the crankshaft and is not balanced
crank_planetary     all checks of the reducer under its torque, its parts, what they come to
reserve             its verdict: whether it holds a tenth more, the torque at which it first fails
words               groups of checks, sources, what is left out
shares              which satellite carries how much, and what hangs on it
cold_yield          the torque at which a plastic contact yields at once
usual_fit           the reducer with a usual clearance, where none is known
usual_modification  with a usual ring, where its modification or its pins' places are not
plain               swinging rollers; the precessional gear and its shaft
records             all checks, by code
"""
