"""Exploration of designs: what an input has to be so that a result is what is wanted.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
solve               one input solved for one result, with jumps and several solutions
"""
