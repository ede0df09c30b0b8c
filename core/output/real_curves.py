"""Curves of the mechanism as it is made: over the crank angle, and of the lag over the torque."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray, check_single
from core.errors import Accuracy, InvalidInput
from core.output.mechanism import Members
from core.output.stage import Stage
from core.precision import EXACT


@dataclass(frozen=True, slots=True)
class RealCurves:
    """The mechanism under load at crank angles."""

    crank_angle: FloatArray  # rad, shape (M,)
    force: FloatArray  # N, shape (K*N, M), satellite by satellite
    rotation: FloatArray  # lag of the output under the torque, rad, shape (M,)
    reverse_rotation: FloatArray  # under the same torque the other way, rad, shape (M,)
    # Limits of the play of the unloaded output, rad, shape (M,); the middle between them, twice,
    # where pairs press without load.
    play_from: FloatArray
    play_to: FloatArray  # rad, shape (M,)
    stiffness: FloatArray  # torque over rotation, N*m/rad, shape (M,)
    input_torque: FloatArray  # of the crank, without friction, N*m, shape (M,)
    accuracy: Accuracy  # of the forces, over the largest

    def at_output(self, members: Members) -> "RealCurves":
        """The same with the angles of the output.

        Parameters
        ----------
        members : Members
            Which is the output.

        Returns
        -------
        RealCurves
        """
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
    """Forces, lags, play, stiffness and input torque at crank angles.

    Parameters
    ----------
    real : Stage
        The mechanism.
    crank_angle : array, M
        Crank angles, rad.
    output_torque : float
        Torque T on the output link, N*m, not 0; negative in reverse.

    Returns
    -------
    RealCurves

    Raises
    ------
    ImpossibleMechanism
        See `Stage.solved`.

    Notes
    -----
    Without friction the crank's torque carries the load and what the contacts store:
    ``T_in = T/u + (1 + 1/u)*sum F*d(approach)/d(psi)``; over a turn the second part is nothing on
    the mean.
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


@dataclass(frozen=True, slots=True)
class StiffnessCurve:
    """Lag over torque at one crank angle."""

    crank_angle: float  # rad
    torque: tuple[float, ...]  # N*m, shape (M,)
    rotation: tuple[float, ...]  # lag under each, rad, shape (M,)
    stiffness: tuple[float, ...]  # slope of the torque over the lag at each, N*m/rad, shape (M,)
    accuracy: Accuracy  # of the lags, over the largest

    def at_output(self, members: Members) -> "StiffnessCurve":
        """The same with torques and angles of the output.

        Parameters
        ----------
        members : Members
            Which is the output.

        Returns
        -------
        StiffnessCurve
        """
        return replace(
            self,
            torque=tuple(map(members.torque_at_output, self.torque)),
            rotation=tuple(map(members.angle_at_output, self.rotation)),
            stiffness=tuple(map(members.stiffness_at_output, self.stiffness)),
        )


def stiffness_curve(*, real: Stage, crank_angle: float, torques: Sequence[float]) -> StiffnessCurve:
    """Lag under several torques at one crank angle; there is no hysteresis without friction.

    Parameters
    ----------
    real : Stage
        The mechanism.
    crank_angle : float
        Crank angle, rad.
    torques : sequence of float
        Torques on the output link, N*m, none 0: there the output lies anywhere within its play.

    Returns
    -------
    StiffnessCurve

    Raises
    ------
    InvalidInput
        If a torque is 0.
    ImpossibleMechanism
        See `Stage.solved`.
    """
    check_single(crank_angle=crank_angle)
    psi, found = real.wave(crank_angle), []
    for index, torque in enumerate(torques):
        if torque == 0:
            raise InvalidInput(f"torques[{index}]", torque, "not_zero")
        found.append(real.solved([psi], torque))
    lags = np.array([float(each.lag[0]) for each in found])
    return StiffnessCurve(
        crank_angle,
        tuple(torques),
        tuple((np.sign(torques) * lags).tolist()),
        tuple(float(each.stiffness[0]) for each in found),
        Accuracy("newton_bracket", EXACT, sum(each.steps for each in found)),
    )
