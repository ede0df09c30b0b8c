"""Exploration of designs: what an input has to be so that a result is what is wanted.

solve   one input solved for one result, with jumps, limits of existence and several solutions
"""
