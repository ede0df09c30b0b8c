"""Results about bearings of the satellites, and reactions and balance of the crankshaft."""

from dataclasses import replace
from typing import Any

import numpy as np

from core.arrays import FloatArray
from core.crank.balance import Balance, balance
from core.crank.crankshaft import Crankshaft, crankshaft
from core.crank.satellite_bearing import SatelliteBearings, satellite_bearings
from core.design.output_forces import OutputForces
from core.design.refusals import named
from core.design.ring_results import RingResults
from core.errors import NotKnown, derived, if_known
from core.output.pin_circle_load import PinCircleLoad
from core.output.room import Deviations

MOST_BEARING_PAIRS = 2000
"""Largest number of pairs whose forces on the satellites are integrated over the turn."""


class CrankResults:
    """Results of a design about its crank in SI units."""

    def __init__(self, output: OutputForces, ring: RingResults) -> None:
        self.design, self.output, self.ring = output.design, output, ring

    @property
    def uneven_growth(self) -> bool:
        """True if bearing loads are not proportional to the torque, as for solved forces."""
        return self.output.solved or self.centrifugal > 0

    @derived
    def bearings(self) -> SatelliteBearings:
        """Load and life of the satellite bearings under the working torque, static safety under the
        peak torque, for at most `MOST_BEARING_PAIRS` pairs. Without a speed there is no life.
        """
        bearing = self.design.bearing
        if not bearing:
            raise NotKnown("section_missing", "bearing")
        mesh = self.ring.on_crank
        self.output.limit_pairs(MOST_BEARING_PAIRS)
        return named(
            self.design,
            "bearing",
            lambda: satellite_bearings(
                load=self.output.pin_load,
                eccentricity=self.design.contact.eccentricity,
                mesh=mesh,
                input_speed=self.design.speeds and self.design.speeds.turning,
                distribution_factor=self.design.disc_factor,
                centrifugal=self.centrifugal,
                kind=bearing.kind,
                dynamic_rating=bearing.dynamic_rating,
                static_rating=bearing.static_rating,
                reliability_percent=bearing.reliability_percent,
                ring_factor=bearing.ring_factor,
                weibull_slope=bearing.weibull_slope,
            ),
        )

    @derived
    def shaft(self) -> Crankshaft:
        """Reactions and balance of the crankshaft, for at most `MOST_BEARING_PAIRS` pairs."""
        return self._shaft(if_known(lambda: self._balance), self.output.pin_load)

    @derived
    def still_shaft(self) -> Crankshaft:
        """Reactions of the crankshaft without centrifugal forces of the satellites."""
        return self._shaft(None, self.output.pin_load)

    @derived
    def static_reactions(self) -> FloatArray:
        """Largest reaction of each bearing of the crankshaft under the peak torque, turning and at
        rest, N, shape (2,).
        """
        load = self.output.pin_load
        turning, still = self.shaft, self.still_shaft
        if load.static_torque != load.output_torque:
            peak = replace(load, output_torque=load.static_torque)
            turning, still = self._shaft(turning.balance, peak), self._shaft(None, peak)
        return np.maximum(turning.peak_reaction, still.peak_reaction)

    def _shaft(self, balance: Balance | None, load: PinCircleLoad[Any]) -> Crankshaft:
        design, own = self.design, self.design.crankshaft
        if not own:
            raise NotKnown("section_missing", "crankshaft")
        mesh, speeds = self.ring.on_crank, design.known_speeds
        self.output.limit_pairs(MOST_BEARING_PAIRS)
        bearings: dict[str, Any] = {}
        if own.bearings:
            bearings = {
                "bearing_speeds": tuple(speeds.against(each.seat) for each in own.bearings),
                "kinds": tuple(each.kind for each in own.bearings),
                "dynamic_ratings": tuple(each.dynamic_rating for each in own.bearings),
            }
        return named(
            design,
            "crankshaft",
            lambda: crankshaft(
                load=load,
                eccentricity=design.known_eccentricity,
                mesh=mesh,
                distribution_factor=design.disc_factor,
                **own.places,
                balance=balance,
                **bearings,
            ),
        )

    @derived
    def balance(self) -> Balance:
        """Balance of the crankshaft at its speed, which needs no forces."""
        made = self.design.deviations or Deviations()
        _ = self.design.satellite_mass
        if any((*made.eccentricity, *made.crank_phase)):
            raise NotKnown("cranks_deviate")
        return self._balance

    @derived
    def _balance(self) -> Balance:
        """Balance of the crankshaft with its cranks as they are meant."""
        design, own = self.design, self.design.crankshaft
        return named(
            design,
            "crankshaft",
            lambda: balance(
                satellite_mass=design.satellite_mass,
                eccentricity=design.known_eccentricity,
                crank_angles=design.built.crank_angles,
                **own.places,
                counterweights=own.counterweights,
                input_speed=design.known_speed,
                rotor_mass=own.rotor_mass,
            ),
        )

    @property
    def centrifugal(self) -> float:
        """Centrifugal force of a satellite, N, which relieves its bearing; 0 if not known."""
        return if_known(self._pull) or 0.0

    def _pull(self) -> float:
        """Centrifugal force of a satellite, N; `NotKnown` if an input is not given."""
        design = self.design
        return design.satellite_mass * design.known_eccentricity * design.known_speed**2
