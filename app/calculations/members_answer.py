"""Crank, pins and ring in answers: speeds, torques, powers, and values as the output has them."""

from typing import Any

from app.model import ResponseModel, Values, result
from app.units import suffix
from core.output.mechanism import MemberLoads, Members, Output

TORQUES = ("torque_Nm", "satellite_torque_Nm")
"""Torques of the output; the crank's torque does not depend on the choice of output."""


class MembersOut(ResponseModel, of=MemberLoads):
    """Crank, pins and ring under the torque in its driving sense, without losses.

    Speeds and torques are positive in the sense of the crank; torques act on a member from outside;
    a power is negative if it leaves. Speeds and powers are absent if no speed is given. In a
    coupling the line of centres takes the place of the crank, and the disc with the holes that of
    the ring.
    """

    BESIDE = ("output",)

    output: Output = result("Output link.")


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
