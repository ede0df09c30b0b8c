"""The drive: bodies, contacts and springs in one plane, and what holds them in equilibrium.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
engine              equilibrium, play and read-outs of a drive at crank angles: all that is compiled
model               a drive as the engine takes it, of sizes and deviations
compiled            the engine compiled
"""
