"""Files of a design for other programs, made from the design and its results alone.

Modules
-------
drawn       what the requests of files have in common
dxf         satellites and ring as drawings for cutting
build123d   all parts as solids, by a script
"""
