"""Files of a design for other programs, made from the design and its results alone.

Modules
-------
dxf         satellites and ring as drawings for cutting
"""
