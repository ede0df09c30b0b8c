"""Numerical tools that know nothing of what they are used for.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
extremes     the second look for the highest summit over a turn
"""
