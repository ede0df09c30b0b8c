"""Drive: bodies, contacts and springs in one plane, and their equilibrium.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
engine              equilibrium, backlash and read-outs at crank angles: all compiled functions
model               drive as the engine takes it, from sizes and deviations
by_pointer          arrays that compiled functions pass to each other by one pointer
compiled            compilation of the engine
"""
