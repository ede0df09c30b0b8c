"""The same calculations for arrays of designs: a million at a time, a few operations each.

Every function takes arrays, one entry for each design, and gives arrays under the names of the
calculation for one design; where that one has nothing to give, these have NaN.

peak_force          the exact peak of the contact force
hertz               line contact of pin and hole
roller_strength     stiffness, load non-uniformity and stress of swinging rollers
"""
