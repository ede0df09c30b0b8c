"""The parallel-crank mechanism as a request gives it."""

import math
from functools import cached_property
from typing import Any, ClassVar, Literal, Self, cast

from pydantic import model_validator

from app.model import Angle, Maybe, RequestModel, ResponseModel, Whole, quantity, result
from app.rules import Forms, Kinds, field_error
from app.settings import Settings
from app.units import to_si
from core.design.sections import MechanismSection
from core.errors import InvalidInput
from core.output.mechanism import Mechanism, Members, Output, ratio_from_teeth
from core.results import Notice

MAX_PAIRS = 10_000
"""Most pairs (pins times satellites) of one mechanism."""

MAX_SATELLITES = 100
"""Most satellites of one mechanism."""

MAX_DRAWN_PAIRS = 240
"""Most pairs that a figure shows."""


PAIR_POINTS = 240
"""Points of a pair, whose forces are searched and integrated over the turn."""


OF_RINGS = ("ratio", "satellite_teeth", "ring_teeth", "crank_spacing_deg", "crank_angles_deg")
"""Fields of a mechanism that has a ring, and cranks."""


def count_satellites(fields: Any) -> None:
    """Let crank angles say the number of satellites where it is not given.

    Parameters
    ----------
    fields : RequestModel
        Satellites and crank angles, one for each.

    Raises
    ------
    PydanticCustomError
        If there is another number of them.
    """
    angles = fields.crank_angles_deg
    if angles is None:
        return
    if "satellites" not in fields.model_fields_set:
        fields.satellites = len(angles)
    if len(angles) != fields.satellites:
        count = {"expected": fields.satellites, "actual": len(angles)}
        raise field_error("crank_angles_deg", "different_length", **count)


class MechanismFields(RequestModel, group="mechanism"):
    """Pins, satellites, cranks and ratio."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = (
        (("ratio",), ("output_ratio",), ("satellite_teeth", "ring_teeth"), ()),
        (("crank_spacing_deg",), ("crank_angles_deg",), ()),
    )
    KIND: ClassVar[str] = "output"
    KINDS: ClassVar[Kinds] = {
        "pins": ((), OF_RINGS),
        "ring": ((), (*OF_RINGS, "output_ratio")),
        "both": ((), OF_RINGS),
        "coupling": ((), ()),
        "crankshafts": ((), OF_RINGS),
    }
    RULES: ClassVar[tuple[dict[str, Any], ...]] = (
        {
            "if": {"properties": {"output": {"const": "coupling"}}, "required": ["output"]},
            "then": {"properties": {"satellites": {"maximum": 1}}},
            "else": {
                "anyOf": [
                    {"required": ["ratio"]},
                    {"required": ["output_ratio"]},
                    {"required": ["satellite_teeth", "ring_teeth"]},
                ]
            },
        },
    )

    pins: Whole = quantity("Pins", "N", step=1, ge=1, le=MAX_PAIRS)
    """Number of pins of the output link, evenly spaced on the pin circle."""
    satellites: Whole = quantity("Satellites", "K", default=2, step=1, ge=1, le=MAX_SATELLITES)
    """Number of satellites, each on its own crank."""
    crank_spacing_deg: Maybe[Angle] = quantity("Crank spacing", "α", step=15)
    """Angle between neighbouring cranks; 360°/K where not given."""
    crank_angles_deg: Maybe[list[Angle]] = quantity(
        "Crank angles", "α₁ … α_K", min_length=1, max_length=MAX_SATELLITES
    )
    """Angle of each crank, one for each satellite, instead of an even spacing."""
    ratio: Maybe[float] = quantity(
        "Ratio", "u", step=1, schema={"anyOf": [{"minimum": 1}, {"maximum": -1}]}, ge=-1e9, le=1e9
    )
    """Speed of the crank over that of the pins while the ring stands still, u = z₂/(z₃ − z₂), at
    least 1; a sign is that of the pins, which turn the other way."""
    output_ratio: Maybe[float] = quantity("Ratio of the output", "i", step=1, ge=2, le=1e9)
    """Where the ring is the output: speed of the crank over that of the ring, i = u + 1."""
    satellite_teeth: Maybe[Whole] = quantity("Satellite teeth", "z₂", step=1, ge=1, le=10**6)
    """Number of teeth of a satellite; gives the ratio and the assembly angles."""
    ring_teeth: Maybe[Whole] = quantity("Ring teeth", "z₃", step=1, ge=2, le=10**6)
    """Number of teeth of the ring, more than the satellite has."""
    output: Literal["pins", "ring", "both", "coupling", "crankshafts"] = quantity(
        "Output", default="pins", advanced=True
    )
    """The pins while the ring stands still, the ring while the pins do, or both; or two shafts an
    eccentricity apart that the pins couple, without a ring. A reducer whose crankshafts drive the
    output, as an RV, is another mechanism, which is not calculated."""
    initial_crank_angle_deg: Angle = quantity(
        "Initial wave angle", "φ₀", default=0.0, step=15, advanced=True
    )
    """0° is the sign of Yanchevskiy 2021; 180° that of Yanchevsky 2018, and also what reversing the
    torque does."""

    ASSUMED: ClassVar[tuple[str, ...]] = ("satellites",)

    @model_validator(mode="after")
    def _by_pins(self) -> Self:
        if self.output == "crankshafts":
            raise field_error("output", "not_this_mechanism")
        return self

    @model_validator(mode="after")
    def _reduces(self) -> Self:
        match self.given:
            case {"ratio": ratio}:
                self._refuse_ratio(ratio)
            case {"satellite_teeth": satellite, "ring_teeth": ring} if ring > 2 * satellite:
                more = {"limit": 2 * satellite, "field": "satellite_teeth"}
                raise field_error("ring_teeth", "ratio_of_teeth", **more)
            case {"output_ratio": _} | {"ring_teeth": _} | {"output": "coupling"}:
                pass
            case _:
                raise field_error("ratio", "needed", field="satellite_teeth")
        return self

    def _refuse_ratio(self, ratio: float) -> None:
        if ratio == 0:
            raise field_error("ratio", "not_zero")
        if abs(ratio) < 1:
            raise field_error("ratio", "ratio_below_one", limit=1, offered=1 / ratio)
        if ratio < 0 and self.output == "ring":
            raise field_error("ratio", "sign_of_ring", offered=-ratio)

    @model_validator(mode="after")
    def _counts(self) -> Self:
        count_satellites(self)
        if self.output == "coupling":
            if "satellites" in self.model_fields_set and self.satellites > 1:
                raise field_error("satellites", "one_of_coupling", limit=1)
            self.satellites = 1
        if self.pairs > MAX_PAIRS:
            raise field_error("pins", "too_many_pairs", **self.most_pins(MAX_PAIRS))
        return self

    @property
    def pairs(self) -> int:
        """Number of pin/hole pairs."""
        return self.pins * self.satellites

    def points(self, *, exponent: float = 1.0, samples: int = 0, revolutions: float = 1.0) -> float:
        """Points over the turn: each satellite has a driving set of its own, which meets those of
        all others. Forces by an exponent above 1 are as much sharper, and are looked at in as many
        more places; a curve with more samples has as many.
        """
        of_each = max(PAIR_POINTS * max(1.0, exponent), samples) * max(1.0, revolutions)
        teeth = (self.ring_teeth or 1) / (self.satellite_teeth or 1)
        return of_each * self.pins * self.satellites**2 * teeth

    def cyclogram_given(self) -> dict[str, Any]:
        """The mechanism as the worked steps of the cyclogram take it."""
        return {
            "mechanism": self.mechanism(),
            "teeth": self.teeth,
            "satellite_teeth": self.satellite_teeth,
        }

    def most_pins(self, pairs: int) -> dict[str, int]:
        """Most pins that so many pairs allow, for a refusal."""
        return {"limit": pairs // self.satellites, "satellites": self.satellites}

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more pairs than the operator allows.

        Raises
        ------
        InvalidInput
            If there are.
        """
        if self.pairs > settings.max_pairs:
            raise InvalidInput(
                "pins", self.pins, "too_many_pairs", **self.most_pins(settings.max_pairs)
            )
        super().refuse_beyond(settings)

    def refuse_undrawable(self) -> None:
        """Refuse a figure of more pairs than anyone can tell apart.

        Raises
        ------
        InvalidInput
            If there are more than `MAX_DRAWN_PAIRS`.
        """
        if self.pins * self.satellites > MAX_DRAWN_PAIRS:
            raise InvalidInput(
                "pins", self.pins, "too_many_pairs", **self.most_pins(MAX_DRAWN_PAIRS)
            )

    @property
    def teeth(self) -> tuple[int, int] | None:
        """Teeth of a satellite and of the ring, where they are given."""
        match self.given:
            case {"satellite_teeth": satellite, "ring_teeth": ring}:
                return satellite, ring
        return None

    @property
    def teeth_difference(self) -> int | None:
        """Teeth of the ring less those of a satellite, where they are given."""
        match self.given:
            case {"satellite_teeth": satellite, "ring_teeth": ring}:
                return int(ring - satellite)
        return None

    def notices(self) -> tuple[Notice, ...]:
        """A ratio with the sign of the output."""
        signed = (self.ratio or 0) < 0
        return (Notice("ratio_sign", {"ratio": self.ratio_given()}),) if signed else ()

    def ratio_given(self) -> float:
        """Ratio u, as such, by that of the ring or by the numbers of teeth; infinite of a coupling.

        Raises
        ------
        InvalidInput
            If no ratio has such teeth.
        """
        match self.given:
            case {"ratio": ratio}:
                return float(abs(ratio))
            case {"output_ratio": ratio}:
                return float(ratio - 1)
            case {"satellite_teeth": satellite, "ring_teeth": ring}:
                return ratio_from_teeth(satellite_teeth=satellite, ring_teeth=ring)
        return math.inf

    @cached_property
    def in_si(self) -> MechanismSection:
        """The same in SI units."""
        angles = to_si("crank_angles_deg", self.crank_angles_deg)
        return MechanismSection(
            pins=self.pins,
            satellites=self.satellites,
            ratio=self.ratio_given(),
            output=cast(Output, self.output),
            crank_spacing=to_si("spacing_deg", self.crank_spacing_deg),
            crank_angles=tuple(angles or ()),
            initial_crank_angle=to_si("initial_crank_angle_deg", self.initial_crank_angle_deg),
            satellite_teeth=self.satellite_teeth,
        )

    def section(self, _: Any) -> MechanismSection:
        """The same in SI units."""
        return self.in_si

    def mechanism(self) -> Mechanism:
        """The mechanism in SI units."""
        return self.in_si.built

    @property
    def members(self) -> Members:
        """Crank, pins and ring, one of which is the output."""
        return self.in_si.members


class PairOut(ResponseModel):
    """A pair of hole and pin by number."""

    satellite: int = result("Number of the satellite, from 1.", symbol="j")
    pin: int = result("Number of the pin, from 1.", symbol="n")
