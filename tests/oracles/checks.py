"""Contact of the reference design of the checks, by hand.

500 Nm over two satellites and six pins at 50 mm; pins of 8 mm in holes of 10 mm over 20 mm, steel.
"""

import math
from typing import Any

import numpy as np

# the peak is 4/(2*6) of 10 kN; E* = 210 GPa/(2*0.91); 1/r - 1/R = 25 per metre
LINE_LOAD, MODULUS = 1e4 / 3 / 0.02, 210e9 / 1.82
PRESSURE = math.sqrt(LINE_LOAD * MODULUS * 25 / math.pi)
RATIO = math.sqrt(4 * LINE_LOAD / (math.pi * MODULUS * 25)) / 0.008


def compliance(force: Any) -> Any:
    """Approach over force of its contact, m/N, Hertz as in the theory: to the pin's axis, and the
    hole's radius deep.
    """
    softness, pin, hole, length = 0.91 / 210e9, 0.008, 0.010, 0.02
    half_width = np.sqrt(4 * force * pin * hole / (hole - pin) * 2 * softness / (np.pi * length))
    inner = 2 * np.log(4 * pin / half_width) - 1
    outer = 2 * np.log(2 * hole / half_width) - 0.3 / 0.7
    return softness * (inner + outer) / (np.pi * length)
