"""Tolerances: what parts are made to, and the effect on the mechanism.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
iso286          limits of ISO 286 classes of pins and holes
processes       usual tolerances of manufacturing processes
draws           random deviations, each part with its own stream
tolerances      tolerances of the parts, and pieces drawn from them
quantiles       percentiles and yield with intervals
study           quantities of many pieces
contributions   share of each tolerance in the variance
"""
