"""Tolerances: what the parts are made to, and what becomes of the mechanism.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
iso286          limits of the classes of pins and holes
processes       what ways of making parts usually come to
draws           random deviations, each part a stream of its own
tolerances      what the parts are made to, and pieces drawn from it
quantiles       percentiles and yield with intervals
study           quantities of many pieces
contributions   which tolerance does most
"""
