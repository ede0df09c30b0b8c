"""Satellites that give: elastic crank bearings, an elastic mesh, or given shares of the torque.

First order only. What bearings and meshes give is solved in `core.output.giving_kernel`; with
given shares every satellite is solved for itself.
"""

import math
from dataclasses import dataclass
from typing import ClassVar

from core.arrays import check_positive
from core.errors import InvalidInput
from core.output.loop_rows import CRANK, MESH, RIGID, SHARES
from core.precision import SAME


@dataclass(frozen=True, slots=True)
class SatelliteSupport:
    """How the satellites are held: rigidly, where no kind of it says what gives."""

    first_order: ClassVar[bool] = False  # whether it is known in first order only
    turning: ClassVar[bool] = False  # whether satellites turn against each other

    @property
    def kind(self) -> int:
        """What gives, as the loops know it: see `core.output.loop_rows`."""
        return RIGID

    @property
    def gives(self) -> float:
        """Compliance at one satellite, m/N, of a mesh rad/(N*m)."""
        return 0.0

    @property
    def loose(self) -> float:
        """How far a satellite moves freely to either side of its middle, m."""
        return 0.0

    @property
    def given_shares(self) -> tuple[float, ...]:
        """Shares of the torque; none where they follow from what gives."""
        return ()

    def check(self, satellites: int) -> None:
        """Refuse what a support cannot be.

        Parameters
        ----------
        satellites : int
            Their number K.

        Raises
        ------
        InvalidInput
            If a size is out of range, or shares are not one each or do not add up to 1.
        """


RIGID_SUPPORT = SatelliteSupport()


@dataclass(frozen=True, slots=True)
class CrankSupport(SatelliteSupport):
    """Bearing of each satellite on its crank."""

    stiffness: float = math.inf  # k_b of one bearing, radial, N/m; infinite where not given
    radial_clearance: float = 0.0  # G, m: the inner ring moves by G/2 to either side of its middle

    first_order = True

    @property
    def kind(self) -> int:
        """The bearings, where they are elastic."""
        return CRANK if self.gives > 0 else RIGID

    @property
    def gives(self) -> float:
        """Of one bearing, m/N."""
        return 1 / self.stiffness

    @property
    def loose(self) -> float:
        """Half of its clearance, m."""
        return self.radial_clearance / 2

    def check(self, satellites: int) -> None:
        """Refuse a stiffness or a clearance out of range."""
        check_positive(stiffness=self.stiffness)
        if not 0 <= self.radial_clearance < math.inf:
            clearance = self.radial_clearance
            raise InvalidInput("radial_clearance", clearance, "greater_than_equal", limit=0)


@dataclass(frozen=True, slots=True)
class ElasticMesh(SatelliteSupport):
    """Mesh of each satellite with the ring, which lets the disc turn under its torque."""

    stiffness: float  # torque over rotation k_D of one disc, N*m/rad

    first_order = turning = True

    @property
    def kind(self) -> int:
        """The meshes with the ring."""
        return MESH

    @property
    def gives(self) -> float:
        """Of one mesh, rad/(N*m)."""
        return 1 / self.stiffness

    def check(self, satellites: int) -> None:
        """Refuse a stiffness out of range."""
        check_positive(stiffness=self.stiffness)


@dataclass(frozen=True, slots=True)
class Shares(SatelliteSupport):
    """Torque that is shared as given, whatever the discs need to turn for it."""

    shares: tuple[float, ...]  # w_j of each of the K satellites, > 0, of sum 1

    first_order = turning = True

    @property
    def kind(self) -> int:
        """Each satellite turns for itself."""
        return SHARES

    @property
    def given_shares(self) -> tuple[float, ...]:
        """The shares."""
        return self.shares

    def check(self, satellites: int) -> None:
        """Refuse shares that are not one each, or do not add up to 1."""
        if len(self.shares) != satellites:
            counts = {"expected": satellites, "actual": len(self.shares)}
            raise InvalidInput("shares", self.shares, "different_length", **counts)
        for j, share in enumerate(self.shares):
            check_positive(**{f"shares[{j}]": share})
        if not abs(math.fsum(self.shares) - 1) <= SAME:
            raise InvalidInput("shares", self.shares, "sum_not_one", sum=math.fsum(self.shares))


@dataclass(frozen=True, slots=True)
class RingInSeries(SatelliteSupport):
    """Each disc finds its place between the pins of its ring and those of the output, as both
    meshes give: of the one alone it is rigid.
    """
