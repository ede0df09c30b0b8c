"""Worked steps: how each number of an answer follows from others, formula by formula.

A step holds what core has calculated; its formula is checked against that, and calculates nothing.

* `core.worked.step`: a step, and the sheet on which they follow each other
* `core.worked.words`: what steps say by code, in English
* `core.worked.turn`: where over a turn of the ideal forces a value is largest
* `core.worked.fatigue`, `core.worked.hertz`: a stress cycle, a contact
* `core.worked.mechanism`: cyclogram, contact force, clearance
* `core.worked.given`: what a crank-planetary design gives to the following
* `core.worked.sharing`: a pin under a unit force, and how bent pins share the load
* `core.worked.pins`, `core.worked.losses`, `core.worked.crank`: strength, friction, bearings and
  crankshaft
* `core.worked.rollers`, `core.worked.precession`: the other calculators
"""
