"""Curves of the mechanism as made, over the crank angle and over the torque."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, check_single
from core.errors import Accuracy, InvalidInput
from core.fields import answer
from core.output.mechanism import Members
from core.output.stage import Stage
from core.precision import EXACT


@dataclass(frozen=True, slots=True, kw_only=True)
class RealCurves:
    """Mechanism under load at crank angles."""

    crank_angle: FloatArray = answer("deg", "φ")
    """Crank angles of the curves."""
    force: FloatArray = answer("N", "F_jn", depth=2)
    """Forces over the crank angles, as one list per pair."""
    rotation: FloatArray = answer("arcmin", "θ")
    """Lag of the output under the torque."""
    reverse_rotation: FloatArray = answer("arcmin", "θ")
    """Lag of the output under the torque in the opposite direction."""
    play_from: FloatArray = answer("arcmin", "θ₋")
    """Least lag of the unloaded output."""
    play_to: FloatArray = answer("arcmin", "θ₊")
    """Largest lag of the unloaded output."""
    stiffness: FloatArray = answer("Nm_per_arcmin", "dT/dθ")
    """Torsional stiffness: slope of the torque over the rotation."""
    input_torque: FloatArray = answer("Nm", "T₁")
    """Torque that turns the crank, without friction."""
    accuracy: Accuracy  # error of the forces over the largest

    def at_output(self, members: Members) -> "RealCurves":
        """Curves with the angles and the stiffness of the output member."""
        angle = members.angle_at_output
        return replace(
            self,
            rotation=angle(self.rotation),
            reverse_rotation=angle(self.reverse_rotation),
            play_from=angle(self.play_from),
            play_to=angle(self.play_to),
            stiffness=members.stiffness_at_output(self.stiffness),
        )


def real_curves(*, real: Stage, crank_angle: FloatArray, output_torque: float) -> RealCurves:
    """Forces, angular deflections, play, stiffness and input torque at M crank angles, rad.

    The torque T on the output link, N*m, is not 0 and negative in reverse; ImpossibleMechanism is
    raised as by `Stage.solved`. Without friction the crank's torque carries the load and the energy
    that the contacts store, ``T_in = T/u + (1 + 1/u)*sum F*d(approach)/d(psi)``; the second part
    has the mean 0 over a turn.
    """
    check_single(output_torque=output_torque)
    direction, waves = math.copysign(1.0, output_torque), [*map(real.wave, crank_angle.tolist())]
    back, there = (real.solved(waves, way * output_torque) for way in (-1, 1))
    ends = np.sort(direction * there.play, axis=1) + 0.0
    middle = np.where(np.isfinite(ends).all(axis=1), ends.mean(axis=1), 0.0)
    ends = np.where(there.jammed[:, None], middle[:, None], ends)
    force = there.forces[:, there.contacts(real.kind)].T
    unsure = float(there.error.max() / force.max())
    return RealCurves(
        crank_angle=crank_angle,
        force=force,
        rotation=direction * there.lag,
        reverse_rotation=-direction * back.lag,
        play_from=ends[:, 0],
        play_to=ends[:, 1],
        stiffness=there.stiffness,
        input_torque=there.input_torque,
        accuracy=Accuracy("newton_bracket", unsure, there.steps + back.steps),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class StiffnessCurve:
    """Angular deflection over torque at one crank angle."""

    crank_angle: float = answer("deg", "φ")
    """Crank angle of the curve."""
    torque: tuple[float, ...] = answer("Nm", "T")
    """Torques of the curve, negative in reverse."""
    rotation: tuple[float, ...] = answer("arcmin", "θ")
    """Lag of the output under each torque."""
    stiffness: tuple[float, ...] = answer("Nm_per_arcmin", "dT/dθ")
    """Torsional stiffness at each torque."""
    accuracy: Accuracy  # error of the rotations over the largest

    def at_output(self, members: Members) -> "StiffnessCurve":
        """Curve with the torques, angles and stiffness of the output member."""
        return replace(
            self,
            torque=tuple(map(members.torque_at_output, self.torque)),
            rotation=tuple(map(members.angle_at_output, self.rotation)),
            stiffness=tuple(map(members.stiffness_at_output, self.stiffness)),
        )


def stiffness_curve(*, real: Stage, crank_angle: float, torques: Sequence[float]) -> StiffnessCurve:
    """Angular deflection under several torques, N*m, at one crank angle, rad.

    No torque may be 0, under which the output lies anywhere within its play. The curve has no
    hysteresis, as there is no friction. ImpossibleMechanism is raised as by `Stage.solved`.
    """
    check_single(crank_angle=crank_angle)
    psi, found = real.wave(crank_angle), []
    for index, torque in enumerate(torques):
        if torque == 0:
            raise InvalidInput(f"torques[{index}]", torque, "not_zero")
        found.append(real.solved([psi], torque))
    lags = np.array([float(each.lag[0]) for each in found])
    return StiffnessCurve(
        crank_angle=crank_angle,
        torque=tuple(torques),
        rotation=tuple((np.sign(torques) * lags).tolist()),
        stiffness=tuple(float(each.stiffness[0]) for each in found),
        accuracy=Accuracy("newton_bracket", EXACT, sum(each.steps for each in found)),
    )
