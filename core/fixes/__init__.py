"""Fixes of a check: each input that it depends on, solved alone, with side effects on other checks.

A fix is solved numerically, as the required direction of an input is not obvious. The target lies
beyond the marginal band; the value is rounded to the safe side (pins to standard sizes), and all
checks are made again with it.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
fix                 one input solved, rounded, with its side effects
plain               fixes of rollers and the precessional gear
changes             crank-planetary reducer with another value of an input
shifts              profile shifts of involute teeth, chosen together
crank               fixes of a crank-planetary reducer
"""
