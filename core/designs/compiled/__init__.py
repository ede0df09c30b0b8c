"""Loops over designs that are compiled, as no array operation can follow each to its own peak.

To import one of these modules is to import a compiler; what it makes is kept on disk.

compiling           compilation of functions, when they are first called
segments            phases of the pairs, segments of smooth peak force
linear_law          peaks of linear load sharing: roots of a cubic
power_law           peaks of any load sharing: bounds, halving, roots
peak_search         the search for peaks
"""
