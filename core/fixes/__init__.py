"""Fixes of a check: each input that it depends on, solved alone, and what else that changes.

A fix is found, not looked up: which way an input has to go is not obvious. It aims beyond the
marginal band, is rounded to the safe side (pins to standard sizes), and all checks are made again
with it.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
fix                 one input solved, rounded, with its side effects
plain               designs whose inputs do not hang on each other
changes             a crank-planetary reducer with another value of an input
shifts              profile shifts of involute teeth, chosen together
crank               fixes of a crank-planetary reducer
"""
