"""Swinging rollers of the output mechanism.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
roller_strength     stiffness, load sharing and bending stress of a design
roller_curves       curves of stiffness, load sharing and stress for figures
"""
