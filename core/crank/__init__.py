"""The crank: bearings of the satellites, reactions and balance of the crankshaft.

Modules, in reading order (each may use those above it)
-------------------------------------------------------
bearing_life        life of a rolling bearing: equivalent load, rating life, reliability
envelope            largest load ratings that fit between bore and outside of a bearing
pin_rollers         bearings as rollers on the output pins: loads, ratings, life
ring_mesh           part of the ring's force on a satellite along the crank
balance             centrifugal forces of satellites and counterweights on the shaft
satellite_bearing   load of the satellites' bearings by pins and ring, and their life
crankshaft          reactions of the crankshaft's bearings, its balance included
"""
