"""Ring mesh and output mechanism in series: fields of the ring in a request, and the answer."""

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import BeforeValidator, Field, model_validator

from app.calculations.design import DeviationsFields, SatelliteCouplingFields
from app.calculations.mechanism import PairOut
from app.calculations.real_design import RealDesignFields
from app.calculations.ring import RING_PIN_LISTS as OF_RING
from app.calculations.ring import RingPinDeviationsFields
from app.calculations.ring_parts import CycloidRingFields
from app.model import Maybe, ResponseModel, Values, quantity, result
from app.problems import refusal
from app.rules import field_error
from app.settings import Settings
from app.units import from_si, to_si
from core.design.ring import CycloidRing
from core.errors import InvalidInput
from core.output.elasticity import COUPLINGS
from core.output.real_mechanism import RealMechanism
from core.output.room import Deviations, Rooms
from core.ring.series import MeshesInSeries, SeriesPosition, in_their_ring
from core.ring.sharing import CycloidMesh, RingDeviations

MAX_FORCES_IN_SERIES = 25_000
"""Largest number of forces of both meshes for positions and for curves: angles times pairs."""

GIVES_AS_LONG, FLOATS_AS_LONG = 2, 16
"""Factors on the time of a turn in series: if bearings are elastic or a tie ring joins the pins
(twice as much for both), and for pieces of a study whose discs float in bearings with clearance."""

MAX_TURN_IN_SERIES = 250_000
"""Largest number of forces of both meshes over all turns: angles times pairs."""


def _no_involute(given: Any) -> Any:
    """Refuse involute teeth."""
    if isinstance(given, dict) and given.get("kind") == "involute":
        raise field_error("kind", "outside_method")
    return given


class SeriesDeviationsFields(DeviationsFields, RingPinDeviationsFields, group="deviations"):
    """Deviations of a piece from its nominal sizes: of each pin, of each hole satellite by
    satellite, of each crank or disc, and of each pin of a ring in series. Positive means outward,
    in the driving sense, larger, ahead.
    """

    def section(self, around: Any = None) -> Deviations:
        """Deviations of the output mechanism in SI units."""
        made: Deviations = super().section()
        return made.of_output

    def of_ring(self) -> RingDeviations:
        """Deviations of the ring in SI units."""
        own = self.to_core()
        named = {
            name: f"ring_{name}" if "pin" in name else name for name in RingDeviations.__slots__
        }
        return RingDeviations(**{name: tuple(own.get(each, ())) for name, each in named.items()})

    def _lengths(self, pins: int, satellites: int) -> Iterator[tuple[str, int, int]]:
        every = super()._lengths(pins, satellites)
        return (each for each in every if each[0] not in OF_RING)


class SeriesCouplingFields(SatelliteCouplingFields, of=COUPLINGS, group="satellite_coupling"):
    """Sharing of the torque between the satellites."""

    kind: Literal["rigid", "elastic", "shares", "ring"] = quantity(  # type: ignore[assignment]
        "Coupling of the satellites", default="rigid"
    )
    """Rigid: all satellites turn as one; elastic: each satellite gives in its mesh with the ring;
    shares: each satellite carries a given share; ring: each satellite finds its place between the
    ring of `gear` and the pins, so that both meshes are in series."""


class DesignCouplingFields(SeriesCouplingFields, group="satellite_coupling"):
    """Sharing of the torque between the satellites of a design."""


def of_the_ring(section: str, names: Sequence[str]) -> tuple[dict[str, Any], ...]:
    """JSON schema of a ring in series, and of section fields that belong to the ring."""
    return (
        {
            "if": {
                "properties": {
                    "satellite_coupling": {
                        "properties": {"kind": {"const": "ring"}},
                        "required": ["kind"],
                    }
                },
                "required": ["satellite_coupling"],
            },
            "then": {
                "required": ["gear"],
                "properties": {"mechanism": {"required": ["satellite_teeth", "ring_teeth"]}},
            },
            "else": {
                "not": {"required": ["gear"]},
                "properties": {
                    section: {"not": {"anyOf": [{"required": [name]} for name in names]}}
                },
            },
        },
    )


class RingInSeriesFields(RealDesignFields):
    """Mechanism, load and contact, alone or in series with the mesh of discs and ring."""

    OF_A_RING: ClassVar[tuple[str, ...]] = ()
    """Paths of fields that only a ring in series has."""

    gear: Annotated[Maybe[CycloidRingFields], BeforeValidator(_no_involute)] = Field(
        default=None, description="Ring and discs, where both meshes are in series."
    )
    satellite_coupling: SeriesCouplingFields = Field(default_factory=SeriesCouplingFields)

    @property
    def in_series(self) -> bool:
        """True if the mesh with the ring is in series."""
        return self.satellite_coupling.kind == "ring"

    @model_validator(mode="after")
    def _ring_in_series(self) -> Self:
        if not self.in_series:
            for path in ("gear", *self.OF_A_RING):
                if self.says(path):
                    raise field_error(path, "of_another_kind", kind=self.satellite_coupling.kind)
            return self
        if self.gear is None:
            raise field_error("gear", "needed_beside", field="satellite_coupling")
        if self.mechanism.teeth is None:
            raise field_error("mechanism/satellite_teeth", "needed_beside", field="gear")
        satellite, ring = self.mechanism.teeth
        if ring != satellite + 1:
            more = {"expected": satellite + 1}
            raise field_error("mechanism/ring_teeth", "not_this_cycloid", **more)
        return self

    @property
    def times_as_long(self) -> int:
        """Time to solve a position over the time with rigid satellites."""
        if not self.in_series:
            return super().times_as_long
        return int(GIVES_AS_LONG ** (self.tied + self.support.gives))

    @property
    def pairs_in_series(self) -> int:
        """Number of pairs of output and ring."""
        return self.mechanism.satellites * (self.mechanism.pins + (self.mechanism.ring_teeth or 0))

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more pairs of the ring than the operator allows."""
        super().refuse_beyond(settings)
        if self.in_series:
            self.refuse_many_in_series(settings.max_pairs + self.mechanism.pairs)

    def refuse_many_in_series(self, limit: int) -> None:
        """Refuse more than `limit` pairs of both meshes, in terms of the ring's teeth."""
        own = self.mechanism
        if self.pairs_in_series > limit:
            most = max(limit // own.satellites - own.pins, 0)
            more = {"limit": most, "satellites": own.satellites}
            raise refusal("/mechanism/ring_teeth", "too_many_pairs", **more)

    def in_ring(self, output: RealMechanism) -> MeshesInSeries:
        """Output mechanism in series with the mesh of its discs with the ring, in SI units."""
        try:
            ring = self._ring
            assert ring.drive  # refuses a ring without sizes
        except InvalidInput as error:
            for section in ("gear.contact_law", "gear"):
                if (name := f"{section}.{error.parameter}") in self.core_paths:
                    raise InvalidInput(name, error.value, error.code, **error.params) from error
            raise
        return MeshesInSeries(ring, output)

    def rooms_in_ring(self, output: RealMechanism) -> Rooms:
        """Positions of the pins in the holes of discs that turn in their ring."""
        return in_their_ring(rooms=output.rooms, ring=self.in_ring(output).ring)

    @property
    def ring_deviations(self) -> RingDeviations:
        """Deviations of the ring, in SI units."""
        return RingDeviations()

    @cached_property
    def _ring(self) -> CycloidMesh:
        ring: CycloidRing = self.given["gear"].section()
        return ring.cycloid_mesh(
            disc=ring.disc(
                satellite_teeth=self.mechanism.given["satellite_teeth"],
                eccentricity=to_si("eccentricity_mm", self.contact.eccentricity_mm),
            ),
            crank_angles=self.built.crank_angles,
            contact_length=ring.contact_length,
            disc_material=ring.disc_material,
            law=ring.law,
            deviations=self.ring_deviations,
        )


class SeriesFields(RingInSeriesFields):
    """Mechanism, load and contact of parts as they are made, alone or in series with the ring."""

    deviations: SeriesDeviationsFields = Field(default_factory=SeriesDeviationsFields)

    OF_A_RING: ClassVar[tuple[str, ...]] = tuple(f"deviations/{name}" for name in OF_RING)
    RULES: ClassVar[tuple[dict[str, Any], ...]] = of_the_ring("deviations", OF_RING)

    @property
    def ring_deviations(self) -> RingDeviations:
        """Deviations of the ring, in SI units."""
        return self.deviations.of_ring()

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse also lists that do not fit the ring."""
        super().refuse_beyond(settings)
        if self.in_series:
            self.deviations.refuse_other_ring(self.mechanism.ring_teeth)


class RingPartOut(ResponseModel):
    """Ring mesh at a crank angle, if both meshes are in series."""

    BESIDE = ("crank_load_N",)

    rotation_arcmin: list[float] = result(
        "Lag of each disc's holes behind their ideal angle: the part of the output's lag that "
        "the teeth cause. The rest is the lag of the pins.",
        symbol="λ_j",
    )
    force_N: list[list[float]] = result(
        "Force of each pin of the ring, a list for each satellite.", symbol="F_jk"
    )
    disc_torque_Nm: list[float] = result(
        "Torque of the forces about each disc's centre.", symbol="T_j", equation="ΣF·h"
    )
    crank_across_N: list[float] = result(
        "Force of the ring on each disc against the turning of its crank.", symbol="W_j"
    )
    crank_along_N: list[float] = result(
        "Force of the ring on each disc along its crank, to the axis."
    )
    crank_load_N: list[float] = result(
        "Magnitude of the resultant force of ring and pins on each crank."
    )
    loaded_pairs: int = result("Number of pairs with a force.")
    max_pressure_MPa: Maybe[float] = result(
        "Largest Hertz pressure of the pairs.", symbol="p_0", equation="Johnson 4.2"
    )
    play_arcmin: list[list[float]] = result(
        "Angles between which each disc can turn in the ring alone; if its pins press without "
        "load, twice the lag at which they exert no torque on it.",
        symbol="λ₋, λ₊",
    )


class RingTurnOut(ResponseModel):
    """Ring mesh over all turns, if both meshes are in series."""

    peak_force_N: float = result("Largest force of a pin of the ring.", symbol="F_max")
    peak_crank_angle_deg: float = result(
        "Crank angle of the largest force, of all turns; any of them if several peaks are equal.",
        symbol="φ",
    )
    peak_pair: PairOut = result("Satellite and ring pin with the largest force.")
    max_pressure_MPa: Maybe[float] = result(
        "Largest Hertz pressure.", symbol="p_0", equation="Johnson 4.2"
    )
    loaded_pairs_min: int = result("Least number of pairs with a force.")
    loaded_pairs_max: int = result("Largest number of pairs with a force.")


def ring_values(position: SeriesPosition) -> Values:
    """Values of the ring mesh at a position."""
    return RingPartOut.values(
        position.ring, crank_load_N=from_si("crank_load_N", position.crank_force)
    )
