"""Random mechanisms, and what their satellites do at many angles, straight from the law."""

import math

import numpy as np
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


def forces(mechanism: Mechanism, exponent: float, psi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Sum of a satellite's forces and of their moments over F0 and T, from the law itself."""
    pins = 2 * np.pi * np.arange(mechanism.pins) / mechanism.pins
    cranks = np.array(mechanism.crank_angles) + mechanism.initial_crank_angle
    cosine = np.maximum(-np.sin(psi + np.add.outer(cranks, pins)[..., None]), 0)
    powers = np.where(cosine > 0, cosine**exponent, 0)
    force = powers / (powers * cosine).sum(axis=(0, 1))
    return force.sum(axis=1), (force * cosine).sum(axis=1)
