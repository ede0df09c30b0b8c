"""Swinging rollers of the output mechanism.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
roller_curves       stiffness, load non-uniformity and stress over the dimensionless design
roller_strength     stiffness, load sharing and bending stress of a design
"""
