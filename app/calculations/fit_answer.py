"""Answer of the fit: pins in their holes by geometry, before any force."""

import math
from typing import Any, Literal

from app.calculations.mechanism import FitOut
from app.model import (
    AccuracyOut,
    DocumentResponse,
    Maybe,
    ResponseModel,
    Values,
    WarningOut,
    result,
)
from app.units import from_si
from core.arrays import FloatArray
from core.output.mechanism import Members
from core.output.room import DiscRoom, Rooms

ALL_ROUND = math.pi
"""Lag to either side of a pin that its hole does not bound, rad."""


class DiscOut(ResponseModel, of=DiscRoom):
    """Fit of one satellite by itself."""


class ElasticOut(ResponseModel):
    """Misfit that rigid pins in elastic contact with their holes take up."""

    limit_mm: Maybe[float] = result(
        "Largest approach that a pair takes up elastically; absent if the limit of neither "
        "material is known."
    )
    limit_force_N: Maybe[float] = result(
        "Force of a pair at that approach, at which the pressure is the static limit of the "
        "weaker body."
    )
    force_without_load_N: Maybe[float] = result(
        "Largest force of a pair at the place of the least room, if parts press without load "
        "and an elastic state is not ruled out."
    )
    pressure_without_load_MPa: Maybe[float] = result(
        "Largest pressure of a pair under that force.", symbol="p_0", equation="Johnson 4.2"
    )


class WholeFitOut(FitOut):
    """Fit of pins in their holes, and the consequence of a misfit."""

    BESIDE = (
        *("largest_hole_radius_mm", "greatest_room_mm", "least_room_arcmin"),
        *("greatest_room_arcmin", "blocked_share", "misfit", "discs", "elastic"),
    )

    largest_hole_radius_mm: Maybe[float] = result(
        "Hole radius below which the holes bound their pins, if they do not.",
        equation="min(R, √(r_in² + R²·sin²(π/N)))",
    )
    greatest_room_mm: Maybe[float] = result("Greatest room over the turn.")
    least_room_arcmin: Maybe[float] = result(
        "Least angle over the turn through which the unloaded output can turn. A negative angle"
        " says by how much pairs miss each other; the value is absent if a pin fits its hole at"
        " no lag.",
        symbol="θ₊ − θ₋",
    )
    greatest_room_arcmin: Maybe[float] = result(
        "Largest angle over the turn through which the unloaded output can turn, which is the "
        "backlash.",
        symbol="θ₊ − θ₋",
    )
    blocked_share: Maybe[float] = result("Share of the turn in which the parts jam.")
    misfit: Maybe[
        Literal[
            "fits_by_bearing_clearance",
            "pressed_without_load",
            "jams",
            "discs_out_of_phase",
            "cannot_assemble",
        ]
    ] = result(
        "Consequence of parts that do not fit; absent if they fit, and if holes do not bound "
        "their pins."
    )
    discs: Maybe[list[DiscOut]] = result("Fit of each satellite by itself, if requested.")
    elastic: Maybe[ElasticOut] = result("Misfit that elasticity takes up, if requested.")

    @classmethod
    def values(cls, result: Rooms, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of a fit."""
        found = super().values(result)
        if result.state == "no_bound":
            limit = from_si("radius_mm", result.largest_hole_radius)
            return found | {"largest_hole_radius_mm": limit}
        found["greatest_room_mm"] = from_si("greatest_room_mm", result.greatest())
        play = result.play()
        for name in ("least", "greatest"):
            if math.isfinite(angle := getattr(play, name)):
                found[f"{name}_room_arcmin"] = from_si("room_arcmin", angle)
        if blocked := found.get("blocked_crank_deg"):
            turn = from_si("angle_deg", result.mechanism.crank_angle_per_wave)
            found["blocked_share"] = math.fsum(end - start for start, end in blocked) / turn
        return found


class FitPositionOut(ResponseModel):
    """Pins in their holes at one crank angle."""

    crank_angle_deg: float = result("Crank angle.", symbol="φ")
    room_mm: float = result(
        "Amount by which all pins might grow in radius until the parts just fit; negative if "
        "they have to shrink.",
        equation="max over θ of min(C − |P·exp(−iθ) − H|)",
    )
    window_arcmin: Maybe[list[float]] = result(
        "Least and largest lag of the unloaded output; absent where there is no room.",
        symbol="θ₋, θ₊",
    )
    pairs: list[list[list[float]]] = result(
        "Least and largest lag, ′, at which each pin is in its hole, as one list per satellite;"
        " empty if the pin fits at no lag, half a turn to either side if its hole does not "
        "bound it."
    )

    @classmethod
    def all_values(cls, rooms: Rooms, members: Members, crank_angle: FloatArray) -> list[Values]:
        """Values of pins in their holes at crank angles, rad, shape (M,)."""
        wave, pins = rooms.mechanism.wave_angle(crank_angle), rooms.mechanism.pins
        found = []
        for angle, room, low, high in zip(
            crank_angle.tolist(),
            rooms.rooms(wave)[0].tolist(),
            *map(members.angle_at_output, rooms.arcs(wave)),
            strict=True,
        ):
            arcs = [*map(_arc, low.tolist(), high.tolist())]
            values = {
                "crank_angle_deg": from_si("angle_deg", angle),
                "room_mm": from_si("room_mm", room),
                "pairs": [arcs[start : start + pins] for start in range(0, len(arcs), pins)],
            }
            if room >= 0:  # rounding may make both ends cross
                values["window_arcmin"] = sorted(_arc(float(low.max()), float(high.min())))
            found.append(values)
        return found


def _arc(low: float, high: float) -> list[float]:
    """Lags from and to, arcmin: none where the first is infinitely above the second."""
    if low == math.inf:
        return []
    ends = (max(low, -ALL_ROUND), min(high, ALL_ROUND)) if math.isinf(low) else (low, high)
    return [from_si("lag_arcmin", each) for each in ends]


class FitResponse(DocumentResponse):
    """Fit of pins in holes, freedom to turn, and the room that is left."""

    fit: WholeFitOut = result("Fit of the pins in their holes.")
    positions: Maybe[list[FitPositionOut]] = result(
        "Pins in their holes at the crank angles, if requested and if the holes bound their pins."
    )
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None
