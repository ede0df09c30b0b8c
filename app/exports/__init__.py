"""Files of a design for other programs, made from the design and its results alone.

Modules
-------
drawn       what the requests of files have in common
sheets      what stands on the drawing of each part
dxf         drawings of all parts as files
build123d   all parts as solids, by a script
step        all parts as a STEP file, by the script of build123d
xlsx        any calculation as a spreadsheet
plot        figures as SVG pictures
picture     drawings as SVG pictures
report      any calculation as a report
"""
