"""Drives whose forces are solved: what their calculations share."""

from functools import cached_property, partial

from app.calculations.document import DocumentFields
from app.model import quantity
from app.problems import refusal
from app.settings import Settings
from core.design.results import Results
from core.errors import InvalidInput, Notice, NotKnown

TIMES_AS_LONG, TIED_AS_LONG = 4, 10
"""Factors on the time of a position with elastic satellites, and with pins joined by a tie ring."""

GIVES_AS_LONG, FLOATS_AS_LONG = 2, 16
"""Factors on the time of a turn in series: if bearings are elastic or a tie ring joins the pins
(twice as much for both), and for pieces of a study whose discs float in bearings with clearance."""

MOST_TIED = 100
"""Largest number of pairs with a tie ring, as all pins deflect under the force on each."""

LEFT_OUT = (
    "bodies_rigid",
    "edge_pressure",
    "friction",
    "heat",
    "misalignment",
    "shaft_bearings",
)
"""Effects that the model leaves out."""

lost_motion_torque_share = partial(
    quantity,
    "Torque of the lost motion",
    group="load",
    default=0.03,
    step=0.01,
    advanced=True,
    ge=1e-6,
    le=1,
    help="Share of the torque, in both directions, under which the lost motion is measured.",
)


class SolvedFields(DocumentFields):
    """Document whose forces are solved, with limits by the time that this takes."""

    @cached_property
    def results(self) -> Results:
        """Results of the design, for any number of pairs within the limits here."""
        return Results(self.design, bounded=False)

    @property
    def in_series(self) -> bool:
        """True if both meshes are solved in series."""
        return self.results.in_series

    @property
    def asks_for_discs(self) -> bool:
        """True if cycloid discs in their ring are asked for: by both meshes in series."""
        coupling = self.given.get("satellite_coupling")
        return coupling is not None and coupling.kind == "ring" and "gear" in self.uses

    def notices(self) -> tuple[Notice, ...]:
        """Notices, also of an unknown modification of discs that are asked for."""
        unknown = self.asks_for_discs and not self.says("gear/modification")
        return super().notices() + ((Notice("modification_unknown"),) if unknown else ())

    @property
    def times_as_long(self) -> int:
        """Time to solve a position over the time with rigid satellites."""
        tied, gives = self.design.tied, self.design.support.gives
        if self.in_series:
            return int(GIVES_AS_LONG ** (tied + gives))
        if tied:
            return TIED_AS_LONG
        return TIMES_AS_LONG if gives else 1

    @property
    def alternating(self) -> bool:
        """True if both directions of the torque are solved."""
        return bool(self.design.load.torque_direction == "alternating")

    @property
    def torque(self) -> float:
        """Torque on the pins with the sign of its direction, N*m."""
        reverse = self.design.load.torque_direction == "reverse"
        return -self.design.pin_torque if reverse else self.design.pin_torque

    @property
    def pairs_in_series(self) -> int:
        """Number of pairs of output and ring."""
        ring: int = self.mechanism.satellites * self.design.ring_pins
        return self.mechanism.pairs + ring

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more pairs than the operator allows or a tie ring may join."""
        super().refuse_beyond(settings)
        if self.design.touching and self.design.contact.distribution_factor > 1:
            raise InvalidInput("contact.distribution_factor", None, "with_real_forces")
        if self.design.tied:
            self.refuse_pairs(MOST_TIED)
        if self.design.in_series:
            self._refuse_impossible_ring()
        if self.in_series:
            self.refuse_many_in_series(settings.max_pairs + self.mechanism.pairs)

    def _refuse_impossible_ring(self) -> None:
        """Refuse a ring in series that cannot exist, or is asked for and not solved; another one is
        left out, as in the whole design.
        """
        asked = self.says("satellite_coupling/kind")
        try:
            assert self.results.ring.mesh
        except NotKnown as error:
            if error.refusal or (asked and not error.missing):
                raise

    def refuse_pairs(self, limit: int) -> None:
        """Refuse more than `limit` pairs of pins and holes."""
        own = self.mechanism
        if own.pairs > limit:
            raise InvalidInput("pins", own.pins, "too_many_pairs", **own.most_pins(limit))

    def refuse_many_in_series(self, limit: int) -> None:
        """Refuse more than `limit` pairs of both meshes, in terms of the ring's teeth."""
        own = self.mechanism
        if self.pairs_in_series > limit:
            most = max((limit - own.pairs) // own.satellites, 0)
            more = {"limit": most, "satellites": own.satellites}
            raise refusal("/mechanism/ring_teeth", "too_many_pairs", **more)
