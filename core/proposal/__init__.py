"""Whole reducers from a requirement: torque, ratio and space.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
shop        what a shop makes and buys: materials, clearances, pins and bearings
screen      closed formulas over arrays of designs, and reasons of those that cannot be
search      the best of the screen, judged by the whole calculation
"""
