"""Numerical tools that know nothing of what they are used for.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
quadrature   integration rules with honest error estimates
extremes     the second look for the highest summit over a turn
inverse      one input solved for one result, with jumps and several solutions
"""
