"""The parallel-crank mechanism as a request gives it."""

from typing import Annotated, Any, Self

from pydantic import Field, model_validator

from app.schemas.base import RequestModel, field_error, quantity
from app.settings import Settings
from app.units import to_si
from core.errors import InvalidInput
from core.output.mechanism import Mechanism, ratio_from_teeth

MAX_PAIRS = 10_000
"""Most pairs (pins times satellites) of one mechanism."""

MAX_SATELLITES = 100
"""Most satellites of one mechanism."""

MAX_DRAWN_PAIRS = 240
"""Most pairs that a figure shows."""

Angle = Annotated[float, Field(ge=-3600, le=3600)]


class MechanismFields(RequestModel):
    """Pins, satellites, cranks and ratio."""

    pins: int = quantity(
        "Pins",
        symbol="N",
        group="mechanism",
        ge=1,
        le=MAX_PAIRS,
        step=1,
        help="Number of pins of the output link, evenly spaced on the pin circle.",
    )
    satellites: int = quantity(
        "Satellites",
        symbol="K",
        group="mechanism",
        default=2,
        ge=1,
        le=MAX_SATELLITES,
        step=1,
        help="Number of satellites, each on its own crank.",
    )
    crank_spacing_deg: Angle | None = quantity(
        "Crank spacing",
        symbol="α",
        group="mechanism",
        default=None,
        step=15,
        help="Angle between neighbouring cranks; 360°/K where not given.",
    )
    crank_angles_deg: list[Angle] | None = quantity(
        "Crank angles",
        symbol="α₁ … α_K",
        group="mechanism",
        default=None,
        max_length=MAX_SATELLITES,
        help="Angle of each crank, one for each satellite, instead of an even spacing.",
    )
    ratio: float | None = quantity(
        "Ratio",
        symbol="u",
        group="mechanism",
        default=None,
        ge=1e-6,
        le=1e9,
        step=1,
        help="Speed of the crank over speed of the output, u = z₂/(z₃ − z₂).",
    )
    satellite_teeth: int | None = quantity(
        "Satellite teeth",
        symbol="z₂",
        group="mechanism",
        default=None,
        ge=1,
        le=10**6,
        step=1,
        help="Number of teeth of a satellite; gives the ratio and the assembly angles.",
    )
    ring_teeth: int | None = quantity(
        "Ring teeth",
        symbol="z₃",
        group="mechanism",
        default=None,
        ge=2,
        le=10**6,
        step=1,
        help="Number of teeth of the ring, more than the satellite has.",
    )
    initial_crank_angle_deg: Angle = quantity(
        "Initial wave angle",
        symbol="φ₀",
        group="mechanism",
        default=0.0,
        step=15,
        advanced=True,
        help="0° is the sign of Yanchevskiy 2021; 180° that of Yanchevsky 2018, and also what "
        "reversing the torque does.",
    )

    @model_validator(mode="before")
    @classmethod
    def _count_satellites(cls, data: Any) -> Any:
        """A list of crank angles says how many satellites there are."""
        if isinstance(data, dict) and "satellites" not in data:
            angles = data.get("crank_angles_deg")
            if isinstance(angles, list) and angles:
                return {**data, "satellites": len(angles)}
        return data

    @model_validator(mode="after")
    def _one_form_each(self) -> Self:
        if self.crank_angles_deg is not None:
            if self.crank_spacing_deg is not None:
                raise field_error(
                    "crank_angles_deg", "give either crank_angles_deg or crank_spacing_deg"
                )
            if len(self.crank_angles_deg) != self.satellites:
                raise field_error(
                    "crank_angles_deg",
                    f"must have one angle for each of the {self.satellites} satellites, "
                    f"has {len(self.crank_angles_deg)}",
                )
        teeth = (self.satellite_teeth, self.ring_teeth)
        if self.ratio is not None and any(value is not None for value in teeth):
            raise field_error("ratio", "give either ratio or satellite_teeth and ring_teeth")
        if self.ratio is None:
            if teeth == (None, None):
                raise field_error("ratio", "is needed: ratio, or satellite_teeth and ring_teeth")
            for name, value in zip(("satellite_teeth", "ring_teeth"), teeth, strict=True):
                if value is None:
                    raise field_error(name, "is needed beside the other number of teeth")
        if self.pins * self.satellites > MAX_PAIRS:
            raise field_error(
                "pins",
                f"must be at most {MAX_PAIRS // self.satellites} for "
                f"{self.satellites} satellites ({MAX_PAIRS} pairs)",
            )
        return self

    @property
    def pairs(self) -> int:
        """Number of pin/hole pairs."""
        return self.pins * self.satellites

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse more pairs than the operator allows.

        Raises
        ------
        InvalidInput
            If there are.
        """
        if self.pairs > settings.max_pairs:
            raise InvalidInput(
                "pins",
                self.pins,
                f"must be at most {settings.max_pairs // self.satellites} for {self.satellites} "
                f"satellites: this service takes {settings.max_pairs} pairs",
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
                "pins",
                self.pins,
                f"must be at most {MAX_DRAWN_PAIRS // self.satellites} for {self.satellites} "
                f"satellites to be drawn ({MAX_DRAWN_PAIRS} pairs)",
            )

    def ratio_given(self) -> float:
        """Ratio u, as such or by the numbers of teeth.

        Raises
        ------
        InvalidInput
            If no ratio has such teeth.
        """
        if self.ratio is not None:
            return self.ratio
        assert self.satellite_teeth is not None and self.ring_teeth is not None
        return ratio_from_teeth(satellite_teeth=self.satellite_teeth, ring_teeth=self.ring_teeth)

    def mechanism(self) -> Mechanism:
        """The mechanism in SI units."""
        ratio = self.ratio_given()
        start = to_si("initial_crank_angle_deg", self.initial_crank_angle_deg)
        if self.crank_angles_deg is not None:
            return Mechanism(
                pins=self.pins,
                crank_angles=tuple(to_si("crank_angles_deg", self.crank_angles_deg)),
                ratio=ratio,
                initial_crank_angle=start,
            )
        spacing = self.crank_spacing_deg
        return Mechanism.evenly_spaced(
            pins=self.pins,
            satellites=self.satellites,
            ratio=ratio,
            crank_spacing=None if spacing is None else to_si("crank_spacing_deg", spacing),
            initial_crank_angle=start,
        )
