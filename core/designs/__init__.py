"""The same calculations for arrays of designs: a million at a time, a few operations each.

Every function takes arrays, one entry for each design, and gives arrays under the names of the
calculation for one design; where that one has nothing to give, these have NaN. For instance, the
crank spacing that loads three pins on each of two satellites least, for a nearly linear contact:

>>> import numpy as np
>>> from core.designs.peak_force import peak_forces
>>> spacing = np.radians(np.arange(1, 181))
>>> found = peak_forces(pins=3, crank_angles=np.stack((0*spacing, spacing), axis=1),
...                     ratio=np.full(180, 20.0), force_exponent=np.full(180, 10/9),
...                     initial_crank_angle=np.zeros(180))
>>> int(np.argmin(found.peak_force_ratio)) + 1, float(found.peak_force_ratio.min().round(4))
(120, 0.6318)

checks              refusals that name the entry
room                records that are filled in design by design
compiled            the search for peaks, in compiled loops
peak_force          the exact peak of the contact force
hertz               line contact of pin and hole
roller_strength     stiffness, load non-uniformity and stress of swinging rollers
"""
