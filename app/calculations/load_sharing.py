"""Load sharing with clearance, deviations and elasticity: request and answer."""

import math
from dataclasses import replace
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from app.calculations.both_meshes import RingTurnOut, ring_values
from app.calculations.document import FORCES, LOADED, TOUCHING, Needs
from app.calculations.fit import fit_notices
from app.calculations.ideal_forces import CurveFields
from app.calculations.load_sharing_answer import (
    LoadSharingResponse,
    OverTurnOut,
    PositionOut,
    RealCurvesOut,
    StiffnessCurveOut,
)
from app.calculations.load_sharing_figure import Drawn, load_sharing_figure
from app.calculations.mechanism import FitOut
from app.calculations.members_answer import at_output
from app.calculations.solved import Solved
from app.calculations.solved_design import LEFT_OUT, SolvedFields, lost_motion_torque_share
from app.model import LARGEST, Angle, Calculation, Maybe, Values, quantity, timed
from app.settings import Settings
from app.sources import HARRIS, JOHNSON_1985, YANCHEVSKIY_2021
from app.theme import Figure, Theme
from app.units import from_si, to_si
from app.worked import stated
from core.errors import ImpossibleMechanism
from core.output.alternating import WorseTurn, worse_curves, worse_position
from core.output.contact_force import drawing_angles, force_curves, force_peak
from core.output.elasticity import law_kind
from core.output.fit import Fit, solvable
from core.output.loaded_position import loaded_position
from core.output.over_turn import over_turn
from core.output.real_curves import RealCurves, StiffnessCurve, real_curves, stiffness_curve
from core.output.real_mechanism import RealMechanism
from core.ring.series import MeshesInSeries, series_position
from core.ring.series_turn import positions_in_series, series_over_turn

Section = Literal[
    "positions", "over_turn", "curves", "stiffness_curve", "pressure", "ideal", "worked"
]

MAX_TURN_PAIRS = 1000
"""Largest number of pairs over the turn, for which thousands of positions are solved in a
second."""

MAX_POSITIONS = 1000
"""Largest number of crank angles in a request."""

MAX_FORCES = 100_000
"""Largest number of forces of positions and of curves: angles times pairs."""

MAX_FORCES_IN_SERIES = 25_000
"""Largest number of forces of both meshes for positions and for curves: angles times pairs."""

MAX_TURN_IN_SERIES = 250_000
"""Largest number of forces of both meshes over all turns: angles times pairs."""

SHARES = (-1.0, -0.75, -0.5, -0.25, -0.1, -0.05, -0.02, 0.02, 0.05, 0.1, 0.25, 0.5, 0.75, 1.0)
"""Shares of the torque at which the lag curve is drawn, and answered if none are given."""

DIRECTIONS = "driving", "reverse"

DRAWN_SAMPLES, DRAWN_IN_SERIES = 361, 121
"""Number of crank angles of the figure's curves; for both meshes in series."""

Torque = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]


class LoadSharingRequest(CurveFields, SolvedFields, group="positions"):
    """Design document with a load and pins in holes, and the results that are wanted."""

    NEEDS: ClassVar[Needs] = (*LOADED, *TOUCHING)
    USES: ClassVar[frozenset[str]] = FORCES

    lost_motion_torque_share: float = lost_motion_torque_share()
    crank_angle_deg: list[Angle] = quantity(
        "Crank angles", "φ", default=[0.0], min_length=1, max_length=MAX_POSITIONS
    )
    """Crank angles of the section `positions`; the curve of the lag is calculated at the first
    one."""
    torques_Nm: Maybe[list[Torque]] = quantity(
        "Torques", "T", min_length=1, max_length=MAX_POSITIONS
    )
    """Torques of the curve of the lag, negative in reverse; shares of the load if not given."""
    include: list[Section] = Field(
        default=["positions"],
        min_length=1,
        max_length=7,
        description="Results; only those that are named are computed. `pressure` adds the "
        "pressure of every pair to positions and turn; `worked` adds the worked steps"
        " of these two, or of the positions if it is named alone.",
    )

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse inputs beyond the operator's limits or too slow, and lists of other lengths."""
        super().refuse_beyond(settings)
        times = self.times_as_long * (2 if self.alternating else 1)
        forces = MAX_FORCES // times
        for section, limit in (
            ("over_turn", MAX_TURN_PAIRS // times),
            ("positions", forces // len(self.crank_angle_deg)),
            ("stiffness_curve", forces // len(self.torques)),
            ("curves", forces // self.samples),
        ):
            if section in self.include:
                self.refuse_pairs(limit)
        if self.in_series:
            angles = {
                "positions": len(self.crank_angle_deg),
                "stiffness_curve": len(self.torques),
                "curves": 2 * self.samples,
            }
            most = max((angles[name] for name in self.include if name in angles), default=1)
            self.refuse_many_in_series(MAX_FORCES_IN_SERIES // times // most)
            if "over_turn" in self.include:
                lobes = self.design.lobes
                turns = positions_in_series(lobes=lobes, pitches=lobes * (lobes + 1))
                self.refuse_many_in_series(MAX_TURN_IN_SERIES // times // turns)

    @property
    def torques(self) -> list[float]:
        """Torques on the pins of the curve of the lag, N*m."""
        if self.torques_Nm is not None:
            return [torque * self.members.pin_share for torque in self.torques_Nm]
        return [share * abs(self.torque) for share in SHARES]

    @property
    def crank_angles(self) -> list[float]:
        """Crank angles of the positions, rad."""
        angles: list[float] = to_si("crank_angle_deg", self.crank_angle_deg)
        return angles

    @property
    def fit(self) -> Fit:
        """Fit of the pins; a misfit that makes forces impossible is refused."""
        return solvable(real=self.results.real, rooms=self.results.rooms)

    def solve_all(self) -> Solved:
        """Requested results."""
        fit = self.fit
        notices = fit_notices(self.design, fit.rooms)
        asked, solved = {*self.include} - {"worked"} or {"positions"}, Solved()
        solved.notices |= {each.code: each for each in notices}
        try:
            self.solve_sections(asked, solved)
        except ImpossibleMechanism as refusal:
            misfit = fit.rooms.room.least < 0 and not self.in_series
            raise (fit.refusal() if misfit else refusal) from refusal
        solved.values["fit"] = FitOut.values(fit.rooms)
        return solved

    def solve_sections(self, asked: set[Section], solved: Solved) -> None:
        """Requested sections of the answer."""
        pressed, real, stage = "pressure" in asked, self.results.real, self.results.stage

        def pressures(force: tuple[tuple[float, ...], ...]) -> Any:
            return from_si("pressure_MPa", real.pressures(force)) if pressed else None

        if "over_turn" in asked:
            turn, direction = self.turn(stage)
            found = OverTurnOut.values(
                turn,
                pressure_MPa=pressures(turn.pair_force),
                torque_direction=direction,
                ring=RingTurnOut.values(turn.ring) if self.in_series else None,
            )
            solved.values["over_turn"] = at_output(found, self.members)
            solved.take(turn.accuracy, turn.notices)
        if "positions" in asked or (pressed and "over_turn" not in asked):
            solved.values["positions"] = positions = []
            for angle in self.crank_angles:
                there, direction = self.position(stage, angle)
                solved.take(there.accuracy, there.notices)
                values = PositionOut.values(
                    there,
                    pressure_MPa=pressures(there.force),
                    torque_direction=direction,
                    ring=ring_values(there) if self.in_series else None,
                )
                positions.append(at_output(values, self.members))
        if "curves" in asked:
            curves, direction = self.curves(stage, 2 * math.pi, self.samples)
            solved.take(curves.accuracy)
            drives = self.members.input_torque(
                curves.input_torque, -self.torque if direction == "reverse" else self.torque
            )
            found = RealCurvesOut.values(
                replace(curves, input_torque=drives),
                pairs=self.pairs_of_curves(),
                torque_direction=direction,
            )
            solved.values["curves"] = at_output(found, self.members)
        if "stiffness_curve" in asked:
            lag = self.lag_curve(stage)
            solved.take(lag.accuracy)
            found = StiffnessCurveOut.values(lag)
            solved.values["stiffness_curve"] = at_output(found, self.members)
        if "ideal" in asked:
            ideal = force_peak(self.design.built, law_kind(real.law)[1])
            solved.take(ideal.accuracy)
            peak = ideal.peak_force_ratio * abs(self.torque) / real.pin_circle_radius
            solved.values["ideal"] = {"peak_force_N": peak}
            if "over_turn" in asked:
                solved.values["ideal"]["ratio"] = turn.peak_force / peak

    def pairs_of_curves(self) -> list[Values]:
        """Numbers of the pairs, satellite by satellite."""
        own = self.mechanism
        return [
            {"satellite": j + 1, "pin": n + 1}
            for j in range(own.satellites)
            for n in range(self.design.pin_count)
        ]

    def position(
        self, stage: RealMechanism | MeshesInSeries, angle: float
    ) -> tuple[Any, str | None]:
        """Position; for an alternating torque in the worse direction, with that direction."""
        solve: Any = series_position if self.in_series else loaded_position
        asked: dict[str, Any] = {"real": stage, "crank_angle": angle, "output_torque": self.torque}
        if not self.alternating:
            return solve(**asked), None
        found, reverse = worse_position(**asked, position=solve)
        return found, DIRECTIONS[reverse]

    def turn(self, stage: RealMechanism | MeshesInSeries) -> tuple[Any, str | None]:
        """Turn; for an alternating torque in the worse direction, with that direction."""
        share, torque = self.lost_motion_torque_share, self.torque
        ways = (1, -1) if self.alternating else (1,)
        solve: Any = series_over_turn if self.in_series else over_turn
        turn, *back = (
            solve(real=stage, output_torque=way * torque, lost_motion_share=share) for way in ways
        )
        if not back:
            return turn, None
        worse = WorseTurn(turn, *back)
        return worse, DIRECTIONS[worse.reverse]

    def curves(
        self, stage: RealMechanism | MeshesInSeries, end: float, samples: int
    ) -> tuple[RealCurves, str | None]:
        """Forces and lags at evenly spaced crank angles up to an end, rad."""
        angles = np.linspace(0.0, end, samples)
        asked: dict[str, Any] = {"real": stage, "crank_angle": angles, "output_torque": self.torque}
        if not self.alternating:
            return real_curves(**asked), None
        curves, reverse = worse_curves(**asked)
        return curves, DIRECTIONS[reverse]

    def lag_curve(self, stage: RealMechanism | MeshesInSeries) -> StiffnessCurve:
        """Lag over torque at the first crank angle."""
        return stiffness_curve(real=stage, crank_angle=self.crank_angles[0], torques=self.torques)

    def solve_for_drawing(self) -> Drawn:
        """All values that the figure shows."""
        real, stage, samples = self.results.real, self.results.stage, DRAWN_SAMPLES
        if self.in_series:
            samples = DRAWN_IN_SERIES
            self.refuse_many_in_series(MAX_FORCES_IN_SERIES // (2 * samples))
        assert self.fit  # refuses parts that cannot be put together
        angles, _ = drawing_angles(mechanism=self.design.built)
        curves, direction = self.curves(stage, float(angles[-1]), samples)
        hardest = [real.hardest(force.tolist()) for force in curves.force.T]
        # Pairs that drive in one direction brake in the other.
        turned = math.pi if self.torque < 0 or direction == "reverse" else 0.0
        start = self.design.built.initial_crank_angle + turned
        ideal = force_curves(
            mechanism=replace(self.design.built, initial_crank_angle=start),
            crank_angle=curves.crank_angle,
            reference=abs(self.torque) / real.pin_circle_radius,
            force_exponent=law_kind(real.law)[1],
        )
        members = self.members
        play = self.position(stage, self.crank_angles[0])[0].play
        return Drawn(
            curves=curves.at_output(members),
            ideal=ideal.force,
            pairs=[(pair.satellite, pair.pin) for pair in ideal.pairs],
            pressure=np.array([each.governing for each in hardest], float),
            lag_curve=self.lag_curve(stage).at_output(members),
            play=play and tuple(map(members.angle_at_output, play)),
        )


def solve(body: LoadSharingRequest) -> Values:
    """Forces, lag, play and stiffness of the output mechanism with clearance, deviations and
    elasticity, at crank angles and over the turn.
    """
    solved, run_time_us = timed(body.solve_all)
    values = solved.answer(run_time_us)
    if "worked" in body.include:
        steps = stated("over_turn", values.get("over_turn", {}), "solved")
        for position in values.get("positions", ()):
            steps += stated("positions", position, "solved")
        values["worked"] = steps
    return values


def figure(body: LoadSharingRequest, theme: Theme = "light") -> Figure:
    """Forces with the ideal ones behind them, lag, pressure and lag over torque, for Plotly.js."""
    body.mechanism.refuse_undrawable()
    drawn = body.solve_for_drawing()
    return load_sharing_figure(drawn, theme)


CALCULATION = Calculation(
    name="load-sharing",
    title="Load sharing with clearance and errors",
    tag="crank-planetary",
    request=LoadSharingRequest,
    answer=LoadSharingResponse,
    solve=solve,
    figure=figure,
    sources=(YANCHEVSKIY_2021, JOHNSON_1985, HARRIS),
    neglects=LEFT_OUT,
)
