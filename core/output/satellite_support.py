"""Satellites that give: elastic crank bearings, an elastic mesh, or given shares of the torque.

First order only. What bearings and meshes give is solved in `core.output.giving_kernel`; with
given shares every satellite is solved for itself.
"""

import math
from dataclasses import dataclass

from core.arrays import check_positive
from core.errors import InvalidInput
from core.precision import SAME


@dataclass(frozen=True, slots=True)
class CrankSupport:
    """Bearing of each satellite on its crank."""

    stiffness: float = math.inf  # k_b of one bearing, radial, N/m; infinite where not given
    radial_clearance: float = 0.0  # G, m: the inner ring moves by G/2 to either side of its middle


@dataclass(frozen=True, slots=True)
class ElasticMesh:
    """Mesh of each satellite with the ring, which lets the disc turn under its torque."""

    stiffness: float  # torque over rotation k_D of one disc, N*m/rad


@dataclass(frozen=True, slots=True)
class Shares:
    """Torque that is shared as given, whatever the discs need to turn for it."""

    shares: tuple[float, ...]  # w_j of each of the K satellites, > 0, of sum 1


@dataclass(frozen=True, slots=True)
class RingInSeries:
    """Each disc finds its place between the pins of its ring and those of the output, as both
    meshes give: it is no support of the one alone.
    """


SatelliteSupport = CrankSupport | ElasticMesh | Shares


def check_support(*, support: SatelliteSupport | None, satellites: int, exact: bool) -> None:
    """Refuse what a support cannot be.

    Parameters
    ----------
    support : SatelliteSupport or None
        How the satellites are held.
    satellites : int
        Their number K.
    exact : bool
        Whether the geometry is exact.

    Raises
    ------
    InvalidInput
        If a size is out of range, shares are not one each or do not add up to 1, or the geometry is
        exact.
    """
    if support is None:
        return
    if exact:
        raise InvalidInput("exact", exact, "first_order_only", field="support")
    if isinstance(support, Shares):
        check_shares(shares=support.shares, satellites=satellites)
        return
    check_positive(stiffness=support.stiffness)
    if isinstance(support, CrankSupport) and not 0 <= support.radial_clearance < math.inf:
        given_clearance = support.radial_clearance
        raise InvalidInput("radial_clearance", given_clearance, "greater_than_equal", limit=0)


def check_shares(*, shares: tuple[float, ...], satellites: int) -> None:
    """Refuse shares that are not one each, or do not add up to 1.

    Parameters
    ----------
    shares : tuple of float
        Shares w_j of the torque.
    satellites : int
        Number K of the satellites.

    Raises
    ------
    InvalidInput
        If they are such.
    """
    if len(shares) != satellites:
        counts = {"expected": satellites, "actual": len(shares)}
        raise InvalidInput("shares", shares, "different_length", **counts)
    for j, share in enumerate(shares):
        check_positive(**{f"shares[{j}]": share})
    if not abs(math.fsum(shares) - 1) <= SAME:
        raise InvalidInput("shares", shares, "sum_not_one", sum=math.fsum(shares))
