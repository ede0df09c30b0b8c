"""Loads of satellites at many angles, straight from the law."""

from typing import Any

import numpy as np


def forces(mechanism: Any, exponent: float, psi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Sum of a satellite's forces and of their moments over F0 and T, from the law itself."""
    pins = 2 * np.pi * np.arange(mechanism.pins) / mechanism.pins
    cranks = np.array(mechanism.crank_angles) + mechanism.initial_crank_angle
    cosine = np.maximum(-np.sin(psi + np.add.outer(cranks, pins)[..., None]), 0)
    powers = np.where(cosine > 0, cosine**exponent, 0)
    force = powers / (powers * cosine).sum(axis=(0, 1))
    return force.sum(axis=1), (force * cosine).sum(axis=1)
