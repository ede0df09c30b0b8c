"""Files of a design for other programs: each of the design and its results, of nothing else.

Modules
-------
dxf     satellites and the pins of their ring, for drawing and cutting
"""
