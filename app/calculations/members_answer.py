"""Crank, pins and ring in answers: speeds, torques, powers, and values as the output has them."""

from typing import Any

from app.model import AccuracyOut, Maybe, ResponseModel, Values, result
from app.units import from_si, suffix
from core.output.mechanism import MemberLoads, Members, Output

SPEEDS = {
    "crank_speed_rpm": "crank",
    "carrier_speed_rpm": "carrier",
    "ring_speed_rpm": "ring",
    "relative_speed_rpm": "relative",
    "crank_to_ring_speed_rpm": "crank_to_ring",
}

TORQUES = ("torque_Nm", "satellite_torque_Nm")
"""Torques of the output; the crank's torque does not depend on the choice of output."""


class MembersOut(ResponseModel, of=MemberLoads):
    """Crank, pins and ring under the torque in its driving sense, without losses.

    Speeds and torques are positive in the sense of the crank; torques act on a member from outside;
    a power is negative if it leaves. Speeds and powers are absent if no speed is given. In a
    coupling the line of centres takes the place of the crank, and the disc with the holes that of
    the ring.
    """

    BESIDE = ("output", *SPEEDS)

    output: Output = result("Output link.")
    crank_speed_rpm: Maybe[float] = result("Speed of the crank.", symbol="n₁")
    carrier_speed_rpm: Maybe[float] = result(
        "Speed of the pins, and of the satellites, which turn with them.",
        symbol="n_c",
        equation="n₁ + u·n_c = (u + 1)·n_r",
    )
    ring_speed_rpm: Maybe[float] = result("Speed of the ring.", symbol="n_r")
    relative_speed_rpm: Maybe[float] = result(
        "Speed of the crank relative to the pins, which is the speed of the satellites' "
        "bearings, of sliding and of load cycles.",
        symbol="n",
    )
    crank_to_ring_speed_rpm: Maybe[float] = result(
        "Speed of the crank relative to the ring, by which the mechanism is calculated.",
        symbol="n₁ − n_r",
    )
    accuracy: AccuracyOut

    @classmethod
    def values(cls, result: MemberLoads, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of the core's loads; `output` is given."""
        speeds = {
            name: from_si(name, getattr(found, each))
            for name, each in SPEEDS.items()
            if (found := result.given_speeds)
        }
        return super().values(result, run_time_us, **speeds, **given)


def factor_at_output(name: str, members: Members) -> float:
    """Factor that converts a quantity of the pins, by its API name, to the output."""
    unit = suffix(name)
    if unit == "arcmin":
        return float(members.angle_at_output(1.0))
    if unit == "Nm_per_arcmin":
        return float(members.stiffness_at_output(1.0))
    return float(members.torque_at_output(1.0)) if name in TORQUES else 1.0


def at_output(values: Values, members: Members) -> Values:
    """Values of an answer with angles, torques and stiffness as the output has them."""
    if members.pin_share == 1:
        return values
    return {name: _times(value, factor_at_output(name, members)) for name, value in values.items()}


def _times(value: Any, factor: float) -> Any:
    if factor == 1 or value is None:
        return value
    return (
        [_times(each, factor) for each in value]
        if isinstance(value, (list, tuple))
        else value * factor
    )
