"""Random mechanisms."""

import math

from hypothesis import strategies as st

from core.output.mechanism import Mechanism

mechanisms = st.builds(
    lambda pins, degrees, start: Mechanism(
        pins=pins,
        crank_angles=tuple(math.radians(each) for each in degrees),
        ratio=20.0,
        initial_crank_angle=math.radians(start),
    ),
    pins=st.integers(3, 8),
    degrees=st.lists(st.integers(0, 359), min_size=1, max_size=3),
    start=st.integers(0, 359),
)
exponents = st.sampled_from([0.0, 0.5, 1.0, 10 / 9, 1.5, 6.0])
