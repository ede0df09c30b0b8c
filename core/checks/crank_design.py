"""A crank-planetary reducer as its checks look at it: ring, bearings, shaft over all the rest."""

from typing import Any

import numpy as np

from core.arrays import FloatArray, IntArray
from core.checks.design.losses import DesignLosses
from core.checks.design.refusals import named
from core.crank.crankshaft import (
    Crankshaft,
    ReactionCurves,
    crankshaft,
    moved_reactions,
    reaction_curves,
)
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import (
    BearingCurves,
    SatelliteBearings,
    bearing_curves,
    made_parts,
    moved_loads,
    satellite_bearings,
)
from core.derived import derived
from core.errors import NotKnown
from core.output.sampled_turn import WAYS

MOST_BEARING_PAIRS = 2000
"""Most pairs of which the forces on the satellites are integrated over the turn."""

MISSED_OF_PEAK = 0.01
"""Part of a peak that samples of a curve may miss."""


class CrankDesign(DesignLosses):
    """A crank-planetary reducer, as far as it is given; SI units. Inputs: `GivenDesign`."""

    @derived
    def mesh(self) -> RingMesh:
        """The ring's force on a satellite."""
        gear = self.gear
        if gear is None:
            raise NotKnown("section_missing", "gear")
        eccentricity, ratio = self.known_eccentricity, self.mechanism.ratio
        return named(
            section="gear",
            calculation=lambda: gear.mesh(eccentricity=eccentricity, ratio=ratio),
        )

    @derived
    def bearings(self) -> SatelliteBearings:
        """Load and life of the satellites' bearings under the torque, their static safety under the
        peak torque, of at most `MOST_BEARING_PAIRS`. Without a speed there is no life.
        """
        bearing = self.bearing
        if bearing is None:
            raise NotKnown("section_missing", "bearing")
        mesh, made = self.mesh, self.made
        if made is None and self.pairs > MOST_BEARING_PAIRS:
            raise self.too_many(MOST_BEARING_PAIRS)
        return named(
            section="bearing",
            calculation=lambda: satellite_bearings(
                **self._turning,
                mesh=mesh,
                kind=bearing.kind,
                dynamic_rating=bearing.dynamic_rating,
                static_rating=bearing.static_rating,
                reliability_percent=bearing.reliability_percent,
                ring_factor=bearing.ring_factor,
                weibull_slope=bearing.weibull_slope,
                peak_torque=self.static_torque,
                static_stiffness=self.static_stiffness,
            ),
        )

    @derived
    def shaft(self) -> Crankshaft:
        """Reactions and balance of the crankshaft under the torque, of at most
        `MOST_BEARING_PAIRS`.
        """
        own = self.crankshaft
        if own is None:
            raise NotKnown("section_missing", "crankshaft")
        mesh, speed, made = self.mesh, self.known_speed, self.made
        if made is None and self.pairs > MOST_BEARING_PAIRS:
            raise self.too_many(MOST_BEARING_PAIRS)
        given = self._turning | {"input_speed": speed}
        if own.bearings is not None:
            given |= {
                "kinds": tuple(each.kind for each in own.bearings),
                "dynamic_ratings": tuple(each.dynamic_rating for each in own.bearings),
            }
        return named(
            section="crankshaft",
            calculation=lambda: crankshaft(
                **given,
                mesh=mesh,
                satellite_positions=own.satellite_positions,
                bearing_positions=own.bearing_positions,
                satellite_mass=own.satellite_mass,
            ),
        )

    @property
    def centrifugal(self) -> float:
        """Centrifugal force of a satellite, N, which the loads of bearings leave out; 0 where mass
        or speed is not known.
        """
        mass = None if self.crankshaft is None else self.crankshaft.satellite_mass
        if mass is None or self.input_speed is None or self.eccentricity is None:
            return 0.0
        return mass * self.eccentricity * self.input_speed**2

    def _moved(self, factors: FloatArray) -> dict[str, Any]:
        """What loads follow from under so many times the torque, as arguments."""
        assert self.pin_circle_radius is not None
        return {
            "sharing": self.sharing,
            "factors": factors,
            "radial_force_ratio": float(self.mesh.radial_force_ratio),
            "arm": self.known_eccentricity * self.mechanism.ratio / self.pin_circle_radius,
        }

    def moved_loads(self, factors: FloatArray, exponent: float | None = None) -> FloatArray:
        """Largest, or equivalent, loads of the satellites' bearings under so many times the torque
        against each other, shape (n, K), where the sharing moves with it.
        """
        return moved_loads(**self._moved(factors), exponent=exponent)

    def moved_reactions(self, factors: FloatArray) -> FloatArray:
        """Equivalent reactions of the crankshaft's bearings likewise, shape (n, 2)."""
        own = self.crankshaft
        assert own is not None and own.bearings is not None
        return moved_reactions(
            **self._moved(factors),
            satellite_positions=own.satellite_positions,
            bearing_positions=own.bearing_positions,
            kinds=(own.bearings[0].kind, own.bearings[1].kind),
            torque_direction=self.torque_direction,
        )

    def _load_curves(self, crank_angle: FloatArray) -> list[BearingCurves]:
        """Load of the satellites' bearings at crank angles in each direction of the torque and, of
        ideal forces, in each way in which the satellites may share them.
        """
        eccentricity, rho = self.known_eccentricity, float(self.mesh.radial_force_ratio)
        assert self.output_torque is not None and self.pin_circle_radius is not None
        ways = WAYS[self.torque_direction]
        if self.made is None:
            return [
                bearing_curves(
                    mechanism=self.mechanism,
                    force_exponent=self.force_exponent,
                    output_torque=self.output_torque,
                    pin_circle_radius=self.pin_circle_radius,
                    eccentricity=eccentricity,
                    radial_force_ratio=rho,
                    crank_angle=crank_angle,
                    torque_direction="driving" if way > 0 else "reverse",
                    pair_stiffness=stiffness,
                )
                for stiffness in dict.fromkeys((None, self.pair_stiffness))
                for way in ways
            ]
        arm = eccentricity * self.mechanism.ratio
        wave = self.mechanism.wave_angle(crank_angle)
        curves = []
        for way in ways:
            turn = self.made(way * self.output_torque)
            parts = made_parts(turn=turn, arm=arm, radial_force_ratio=rho)
            load = turn.at(wave=wave, values=parts.load).T
            curves.append(BearingCurves(crank_angle, load.imag, load.real, np.abs(load)))
        return curves

    def bearing_curves(self, crank_angle: FloatArray) -> BearingCurves:
        """Load of the satellites' bearings at crank angles: of each as `bearings` judges it, in the
        worst direction and sharing.

        Parameters
        ----------
        crank_angle : array, shape (n,)
            Crank angles, rad.

        Returns
        -------
        BearingCurves
        """
        cases = self._load_curves(crank_angle)
        worst = _worst([each.load for each in cases])
        across, along, load = (
            np.choose(worst, [getattr(each, name) for each in cases])
            for name in ("across", "along", "load")
        )
        return BearingCurves(crank_angle, across, along, load)

    def reaction_curves(self, crank_angle: FloatArray) -> ReactionCurves:
        """Reactions of the crankshaft's bearings to the same, each in its worst case.

        Parameters
        ----------
        crank_angle : array, shape (n,)
            Crank angles, rad.

        Returns
        -------
        ReactionCurves
        """
        own, cranks = self.crankshaft, self.mechanism.crank_angles
        assert own is not None and self.output_torque is not None
        if self.made is not None:
            cranks = self.made(WAYS[self.torque_direction][0] * self.output_torque).crank_angles
        cases = [
            reaction_curves(
                loads=each,
                crank_angles=cranks,
                satellite_positions=own.satellite_positions,
                bearing_positions=own.bearing_positions,
            ).reaction
            for each in self._load_curves(crank_angle)
        ]
        worst = _worst([np.abs(each) for each in cases])
        return ReactionCurves(crank_angle, np.choose(worst, cases))


def _worst(sizes: list[FloatArray]) -> IntArray:
    """The case in which each column is largest; the first of those that differ by less than
    samples of a curve may miss of its peak.
    """
    peaks = np.max(sizes, axis=1)
    worst: IntArray = np.argmax(peaks >= (1 - MISSED_OF_PEAK) * peaks.max(axis=0), axis=0)
    return worst
