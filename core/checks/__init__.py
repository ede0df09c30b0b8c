"""Checks of a design and its verdict: results against limits, each as data.

A check is a small function of a design in the module of its machine element, with its record: what
it is called, depends on, needs, asks. Nothing passes by absence: what is asked and not known is
`not_checked` and leaves the verdict incomplete, what nobody asked is `not_asked`.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
inputs              inputs that checks of several elements depend on
check               a check and its record, a value against its limit, the verdict of parts and all
contact             pins in holes: room and play, walls and gaps, pressure, shakedown, yield
plastics            plastic pins and holes: what is necessary, and never enough
pins                static strength, fatigue, deflection and slope of the pins
friction            efficiency, sliding speed, pv and wear
body                what the holes leave of a satellite to rim and bore, the room that it takes
crank               ring, bearings of the satellites, crankshaft
ring_pins           cycloid discs on the pins of a ring: what geometry alone says
involute_mesh       involute teeth: path of contact, tips, undercut, roots
ring_load           satellites in their ring under load: pressure, play, bending
bearings            bearings as they are bought: ratings that can be, room, speed, least load
pin_rollers         bearings as rollers on the pins: life, load, speed, room, tilt
balance             what turns with the crankshaft and is not balanced
crank_planetary     all checks of the reducer under its torque, its parts, what they come to
reserve             its verdict: whether it holds a tenth more, the torque at which it first fails
words               groups of checks, sources, what is left out
shares              which satellite carries how much, and what hangs on it
cold_yield          the torque at which a plastic contact yields at once
usual_fit           the reducer with a usual clearance, where none is known
usual_modification  with a usual ring, where its modification or its pins' places are not
rollers             swinging rollers
shaft               the precessional gear and its shaft
records             all checks, by code
"""
