"""Numerical tools that know nothing of mechanics.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
quadrature   integration rules whose error is known beforehand
extremes     search for the largest value over a period
inverse      search for the input at which a result meets a target
"""
