"""A cycloid disc as it is cut, on the pins of its ring: its outline is points that lie close, and a
pin presses it wherever it is nearer to one of them than to those beside it, and than its radius.

Nothing is shared with ``core``, and no path of pins is looked at: a pin over a narrow valley, whose
centre may be as near to both flanks, is a circle and an outline as any other. One disc, linear
contacts.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

POINTS = 6001
"""Points of the outline about each pin, over two pitches of its lobes."""

Floats = NDArray[np.float64]


class Contacts(NamedTuple):
    """Contacts of pins and disc at a lag."""

    pin: NDArray[np.int64]
    approach: Floats
    lever: Floats  # of the force about the disc's centre, as the lag is counted
    way: NDArray[np.complex128]  # direction of the force on the pin, from the crank's


class CutDisc:
    """A disc and the pins of its ring at a crank angle; a mesh as `Distances` takes it."""

    def __init__(self, mesh: Any, crank_angle: float) -> None:
        disc, own = mesh.disc, mesh.deviations
        self.lobes, self.pins = disc.satellite_teeth, disc.satellite_teeth + 1
        self.tool = disc.ring_pin_radius + disc.modification.equidistant
        self.circle = disc.ring_pin_circle_radius + disc.modification.pin_circle
        self.eccentricity = disc.eccentricity

        def errors(values: Any) -> Floats:
            return np.array(values or (0.0,) * self.pins, dtype=float)

        self.radius = disc.ring_pin_radius + errors(own.pin_radius)
        place = disc.ring_pin_circle_radius + errors(own.pin_radial)
        place = place + 1j * errors(own.pin_tangential)
        self.crank = 1j * np.exp(-1j * crank_angle)
        self.turned = crank_angle / self.lobes
        self.centres = 1j * np.exp(2j * np.pi * np.arange(self.pins) / self.pins) * place
        self.centres = self.centres - disc.eccentricity * self.crank

    def outline(self, t: Any) -> Any:
        """Points of the disc: of the path of the tool's centre, a radius inward."""
        e, pins = self.eccentricity, self.pins
        path = 1j * (self.circle * np.exp(-1j * t) - e * np.exp(-1j * pins * t))
        along = self.circle * np.exp(-1j * t) - e * pins * np.exp(-1j * pins * t)
        return path - 1j * self.tool * along / np.abs(along)

    def contacts(self, lag: float) -> Contacts:
        """All places at which pins press at a lag."""
        back = np.exp(1j * (lag - self.turned))
        points = self.centres * back
        step = 4 * np.pi / self.lobes / (POINTS - 1)
        t = (np.pi / 2 - np.angle(points))[:, None] + step * (np.arange(POINTS) - POINTS // 2)
        apart = np.abs(self.outline(t) - points[:, None])
        here, before, after = apart[:, 1:-1], apart[:, :-2], apart[:, 2:]
        near = (here < before) & (here <= after) & (here < self.radius[:, None] + 10 * step)
        pin, place = near.nonzero()
        place += 1
        foot = t[pin, place]
        for width in (step, step / 50):  # of parabolas
            low, most, high = (
                np.abs(self.outline(foot + k * width) - points[pin]) for k in (-1, 0, 1)
            )
            foot = foot + width / 2 * (low - high) / (low - 2 * most + high)
        between = points[pin] - self.outline(foot)
        approach = self.radius[pin] - np.abs(between)
        press = approach > 0
        way = (between / np.abs(between))[press]
        pin, lever = pin[press], -(np.conj(way) * 1j * points[pin[press]]).real
        return Contacts(pin, approach[press], lever, way / back / self.crank)
