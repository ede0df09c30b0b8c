"""Inputs of tests and benchmarks of core and the service: known or random designs, and callers.

Modules
-------
checks             a design whose checks are known by hand, and what a check says
satellites         random mechanisms
loads              functions on a load of pins, called with the fields of the load
real_mechanisms    mechanisms with clearance, deviations and elasticity
misfits            mechanisms with misfits, for core and for plain distances
cases              random mechanisms, gears and rollers, awkward ones well represented
hard_cases         stiff and extreme cases, each with its exact answer
outcome            a random case asked of the service, and held against its exact answer
fuzz               sends requests and checks every answer, with
fuzz_requests      random designs, hostile numbers and broken bodies
in_process         the service in this process, as a client sees it
"""
