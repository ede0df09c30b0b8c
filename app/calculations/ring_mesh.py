"""Mesh of satellites with ring pins or involute ring teeth: request and answer."""

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar, Literal, Self, get_args

from pydantic import Field, model_validator

from app.calculations.document import Needs
from app.calculations.involute_mesh import drawn_path, pair_notices, solved_pair
from app.calculations.load_sharing_answer import StiffnessCurveOut
from app.calculations.members_answer import at_output
from app.calculations.ring_mesh_answer import (
    MeshPositionOut,
    MeshTurnOut,
    ProfileOut,
    RingEfficiencyOut,
    RingGeometryOut,
    RingIdealOut,
    RingMeshResponse,
)
from app.calculations.ring_mesh_figure import DrawnPath, ShownMesh, path_figure, ring_mesh_figure
from app.calculations.solved import Solved
from app.calculations.solved_design import SolvedFields, lost_motion_torque_share
from app.model import (
    Angle,
    Calculation,
    Maybe,
    Size,
    Values,
    quantity,
    timed,
)
from app.problems import refusal
from app.rules import field_error
from app.settings import Settings
from app.sources import ISO_6336, JOHNSON_1985
from app.theme import Figure, Theme
from app.units import to_si
from app.worked import Steps
from core.design.document import Design
from core.design.ring import CycloidRing, InvoluteRing
from core.design.stated import RING_MATERIAL, RING_PIN_MATERIAL
from core.errors import InvalidInput, Notice
from core.material_table import MATERIALS
from core.output.real_curves import stiffness_curve
from core.output.turn import Turn
from core.ring.involute import InvolutePair
from core.ring.loss import RingFriction, RingLoss, ring_loss, sliding_part
from core.ring.profile import CycloidDisc, Modification, outline_points
from core.ring.sharing import (
    CycloidMesh,
    MeshTurn,
    mesh_over_turn,
    mesh_position,
)
from core.worked.ring import (
    disc_steps,
    ideal_ring_steps,
    involute_steps,
    pressure_steps,
    ring_loss_steps,
)

OfCycloids = Literal["positions", "over_turn", "profile", "stiffness_curve", "ideal", "worked"]

OfInvolutes = Literal["stresses", "shared_pairs", "worked"]

Section = Literal[OfCycloids, OfInvolutes]

MAX_TURN_PAIRS = 1000
"""Largest number of pairs over the turn, for which thousands of positions are solved."""

MAX_POSITIONS = 1000
"""Largest number of crank angles in a request."""

MAX_FORCES = 100_000
"""Largest number of forces of positions: angles times pairs."""

MAX_DRAWN_PAIRS = 240
"""Largest number of pairs in a figure."""

TORQUES = (-1.0, -0.75, -0.5, -0.25, -0.1, -0.03, 0.03, 0.1, 0.25, 0.5, 0.75, 1.0)
"""Shares of the torque at which the lag curve is answered."""


MATERIALS_OF = {
    "cycloid": ("pin_material", "disc_material", RING_PIN_MATERIAL),
    "involute": ("ring_material", "satellite_material", RING_MATERIAL),
}
"""Fields of the materials of ring and satellite by the kind of teeth, and the ring's usual one."""

OF_HOLES = ("clearance_unknown", "perfect_parts")
"""Notices of pins in holes, which a ring alone does not have."""

OF_CYCLOIDS = ("lost_motion_torque_share", "chord_error_mm", "crank_angle_deg")
"""Fields of results that cycloid discs alone have."""

RING_ALONE = ("mechanism", "load", "contact", "gear")
"""Sections of a ring mesh; cycloid discs also have deviations and shares of the torque."""


class RingMeshRequest(SolvedFields, group="positions"):
    """Design document with a torque and the teeth of satellites and ring, without the output pins,
    and the results that are wanted.
    """

    NEEDS: ClassVar[Needs] = ("load/output_torque_Nm", "gear")

    lost_motion_torque_share: float = lost_motion_torque_share()
    chord_error_mm: Size = quantity("Chord error", "ε", default=0.01, step=0.001)
    """Largest distance of the outline from the polygon of its points."""
    crank_angle_deg: list[Angle] = quantity(
        "Crank angles", "φ", default=[0.0], min_length=1, max_length=MAX_POSITIONS
    )
    """Crank angles of the section `positions`; the curve of the lag is calculated at the first
    one."""
    include: Maybe[list[Section]] = Field(
        min_length=1,
        max_length=6,
        description="Results; only those that are named are computed. The geometry is always part"
        " of the answer; `worked` adds its worked steps and those of the named "
        "results. The default is the positions of cycloid discs or the stresses of "
        "involute teeth.",
    )

    @model_validator(mode="before")
    @classmethod
    def _law_is_of_the_gear(cls, given: Any) -> Any:
        """Refuse the ring's law in its older place, beside a contact without pins."""
        match given:
            case {"contact_law": _, "contact": {"pin_radius_mm": _}}:
                pass
            case {"contact_law": _}:
                raise field_error("contact_law", "moved_to", field="gear.contact_law")
        return given

    @model_validator(mode="after")
    def _of_the_kind(self) -> Self:
        kind, own = self.ring_kind, self.mechanism.teeth
        if kind not in ("cycloid", "involute"):
            raise field_error("gear/kind", "literal_error", expected="'cycloid' or 'involute'")
        sections = get_args(OfInvolutes if kind == "involute" else OfCycloids)
        for index, asked in enumerate(self.asked):
            if asked not in sections:
                raise field_error(f"include/{index}", "of_another_kind", kind=kind)
        for name in OF_CYCLOIDS if kind == "involute" else ():
            if name in self.model_fields_set:
                raise field_error(name, "of_another_kind", kind=kind)
        if kind == "cycloid" and own and own[1] != own[0] + 1:
            raise field_error("mechanism/ring_teeth", "not_this_cycloid", expected=own[0] + 1)
        return self

    def needs(self) -> Needs:
        """Fields that the kind of teeth needs."""
        of_cycloids = ("contact/eccentricity_mm", "gear/ring_pin_radius_mm")
        return (*super().needs(), *(of_cycloids if self.ring_kind == "cycloid" else ()))

    @property
    def uses(self) -> frozenset[str]:
        """Sections that teeth of this kind use."""
        of_cycloids = ("deviations", "satellite_coupling")
        return frozenset((*RING_ALONE, *(of_cycloids if self.ring_kind == "cycloid" else ())))

    @property
    def used(self) -> frozenset[str]:
        """Sections of the design; of the coupling only given shares of the torque."""
        shared = self.says("satellite_coupling/shares")
        return self.uses if shared else self.uses - {"satellite_coupling"}

    @cached_property
    def design(self) -> Design:
        """Ring in SI units without the output pins; an unknown modification is taken as none."""
        design, gear, contact = super().design, super().design.gear, super().design.contact
        if isinstance(gear, CycloidRing) and gear.modification is None:
            gear = replace(gear, modification=Modification())
        if isinstance(gear, InvoluteRing) and design.disc_material is None:
            gear = replace(gear, satellite_material=MATERIALS[RING_MATERIAL].material)
        if contact:
            contact = replace(contact, pin_radius=None, hole_radius=None)
        return replace(design, gear=gear, contact=contact)

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with the materials of the teeth."""
        yield from (each for each in super().assumed() if each[0][0] not in ("contact", "gear"))
        gear, contact = self.given["gear"], self.contact
        of_ring, of_disc, usual = MATERIALS_OF[gear.kind]
        if of_ring not in gear.given:
            yield ("gear", of_ring), usual
        if of_disc in gear.given:
            return
        if contact is None:
            yield ("gear", of_disc), RING_MATERIAL
        elif not contact.says("hole_material"):
            yield ("contact", "hole_material"), contact.hole_material

    def notices(self) -> tuple[Notice, ...]:
        """Notices without those of pins in holes."""
        return tuple(each for each in super().notices() if each.code not in OF_HOLES)

    @property
    def asks_for_discs(self) -> bool:
        """True for cycloid discs."""
        return self.ring_kind == "cycloid"

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse inputs beyond the operator's limits or too slow, and lists of other lengths."""
        super().refuse_beyond(settings)
        if self.ring_kind == "involute":
            return
        satellites, teeth = self.mechanism.satellites, self.design.ring_pins
        limits = [settings.max_pairs]
        limits += [MAX_TURN_PAIRS] if "over_turn" in self.asked else []
        limits += [MAX_FORCES // len(self.crank_angle_deg)] if "positions" in self.asked else []
        if teeth * satellites > min(limits):
            most = {"limit": min(limits) // satellites, "satellites": satellites}
            raise InvalidInput("ring_teeth", teeth, "too_many_pairs", **most)

    @property
    def asked(self) -> list[Section]:
        """Sections of the answer."""
        return self.include or ["stresses" if self.ring_kind == "involute" else "positions"]

    @property
    def pair(self) -> InvolutePair:
        """Involute satellite in its ring; without an eccentricity the one without backlash."""
        given = self.design.contact.eccentricity if self.contact else None
        return self.results.ring.pair_at(given)

    @property
    def loaded_teeth(self) -> dict[str, Any]:
        """Arguments of the stresses of involute teeth."""
        return self.results.ring.loaded_teeth(self.design.load_factor)

    @property
    def mesh(self) -> CycloidMesh:
        """Discs in their ring as they are made."""
        return self.results.ring.mesh

    @property
    def disc(self) -> CycloidDisc:
        """Discs of nominal size."""
        return self.mesh.disc

    @property
    def sliding(self) -> RingFriction:
        """Sliding contact of the ring; without a coefficient it is taken as 0."""
        ring = self.design.cycloid
        coefficient = ring.friction_coefficient or 0.0
        return RingFriction(coefficient, ring.sleeve_bore_radius, ring.rolling)

    def _loss(self, turn: MeshTurn) -> RingLoss | None:
        """Friction over the turn, if its coefficient is given."""
        if self.design.gear.friction_coefficient is None:
            return None
        speed = self.design.turning_speed
        return ring_loss(turn=turn, friction=self.sliding, input_speed=speed)

    def solve_all(self) -> Solved:
        """Requested results."""
        if self.ring_kind == "involute":
            return self._solve_pair()
        solved, asked = Solved(), {*self.asked}
        mesh, members = self.mesh, self.members
        solved.values |= {"kind": "cycloid", "geometry": RingGeometryOut.values(self.disc)}
        if "ideal" in asked:
            each = self.design.pin_torque / self.mechanism.satellites
            solved.values["ideal"] = at_output(RingIdealOut.of(self.disc, each), members)
        if "over_turn" in asked:
            turn = mesh_over_turn(
                mesh=mesh,
                output_torque=self.torque,
                lost_motion_share=self.lost_motion_torque_share,
            )
            solved.values["over_turn"] = at_output(MeshTurnOut.values(turn), members)
            solved.take(turn.accuracy, turn.notices)
            if loss := self._loss(turn):
                solved.values["efficiency"] = RingEfficiencyOut.values(loss)
        if "positions" in asked:
            solved.values["positions"] = [self._position(angle, solved) for angle in self.angles]
        if "stiffness_curve" in asked:
            torques = [share * self.design.pin_torque for share in TORQUES]
            lag = stiffness_curve(real=mesh, crank_angle=self.angles[0], torques=torques)
            solved.values["stiffness_curve"] = at_output(StiffnessCurveOut.values(lag), members)
            solved.take(lag.accuracy)
        if "profile" in asked:
            error = to_si("chord_error_mm", self.chord_error_mm)
            points = outline_points(disc=self.disc, chord_error=error)
            solved.values["profile"] = ProfileOut.of(points)
        if not solved.accuracies:
            solved.take(self.disc.accuracy)
        return solved

    def steps(self) -> Steps:
        """Worked steps of the geometry, and of requested sections."""
        if self.ring_kind == "involute":
            return {"geometry": involute_steps(self.pair)}
        asked, disc, torque = {*self.asked}, self.disc, self.design.pin_torque
        steps = {"geometry": disc_steps(disc)}
        if "ideal" in asked:
            own = self.mechanism.satellites
            steps["ideal"] = ideal_ring_steps(disc=disc, output_torque=torque, satellites=own)
        at: dict[str, Any] = {"mesh": self.mesh, "output_torque": self.torque}
        if "positions" in asked:
            first = mesh_position(**at, crank_angle=self.angles[0])
            steps["positions"] = pressure_steps(
                mesh=self.mesh,
                crank_angle=self.angles[0],
                force=first.force,
                pressure=first.max_pressure,
            )
        if "over_turn" in asked:
            turn = mesh_over_turn(**at)
            place = turn.hardest_place[1]
            steps["over_turn"] = pressure_steps(
                mesh=self.mesh,
                crank_angle=place,
                force=turn.forces_at(place),
                pressure=turn.max_pressure,
            )
            if loss := self._loss(turn):
                steps["efficiency"] = ring_loss_steps(
                    loss=loss,
                    coefficient=self.sliding.coefficient,
                    torque=torque,
                    teeth=disc.satellite_teeth,
                    input_speed=self.design.turning_speed,
                )
        return steps

    def _solve_pair(self) -> Solved:
        pair = self.pair
        return solved_pair(
            ring=self.design.involute,
            pair=pair,
            loaded=self.loaded_teeth,
            output_torque=self.design.pin_torque,
            input_speed=self.design.turning_speed,
            asked={*self.asked},
            notices=pair_notices(pair),
        )

    @property
    def angles(self) -> list[float]:
        """Crank angles of the positions, rad."""
        angles: list[float] = to_si("crank_angle_deg", self.crank_angle_deg)
        return angles

    def _position(self, angle: float, solved: Solved) -> Values:
        found = mesh_position(mesh=self.mesh, crank_angle=angle, output_torque=self.torque)
        solved.take(found.accuracy, found.notices)
        speed = self.design.turning_speed
        if speed is not None:
            speed *= found.sliding_distance / self.disc.satellite_teeth
        part = sliding_part(disc=self.disc, friction=self.sliding)
        values = MeshPositionOut.values(
            found,
            sliding_speed_m_per_s=speed,
            loss_per_friction=part * found.sliding_loss,
            pressed_without_load=True if found.play is None else None,
        )
        return at_output(values, self.members)

    def solve_path(self) -> DrawnPath:
        """Pressure along the path of contact."""
        return drawn_path(pair=self.pair, loaded=self.loaded_teeth)

    def solve_for_drawing(self) -> ShownMesh:
        """All values that the figure shows."""
        turn = MeshTurn(Turn(self.mesh, self.torque))
        return ShownMesh.at_angle(turn, self.angles[0])


def solve(body: RingMeshRequest) -> Values:
    """Geometry, forces, lag, play and stiffness of cycloid discs on the pins of their ring, with
    modification, deviations and elasticity, at crank angles and over the turn; or the path of
    contact, interferences and stresses of involute teeth.
    """
    solved, run_time_us = timed(body.solve_all)
    return solved.answer(run_time_us)


def figure(body: RingMeshRequest, theme: Theme = "light") -> Figure:
    """Forces and gaps over the ring pins at a crank angle, the largest force and the lag over the
    turn, and the disc on its pins; or the pressure along the path of contact of involute teeth, for
    Plotly.js.
    """
    if body.ring_kind == "involute":
        path = body.solve_path()
        return path_figure(path, theme)
    satellites = body.mechanism.satellites
    if body.design.ring_pins * satellites > MAX_DRAWN_PAIRS:
        most = {"limit": MAX_DRAWN_PAIRS // satellites, "satellites": satellites}
        raise refusal("/mechanism/ring_teeth", "too_many_pairs", **most)
    drawn = body.solve_for_drawing()
    return ring_mesh_figure(drawn, theme)


CALCULATION = Calculation(
    name="ring-mesh",
    title="Satellites in their ring: cycloid discs on pins, involute teeth",
    tag="crank-planetary",
    request=RingMeshRequest,
    answer=RingMeshResponse,
    solve=solve,
    figure=figure,
    sources=(JOHNSON_1985, ISO_6336),
    neglects=(
        "bodies_rigid",
        "edge_pressure",
        "friction_on_forces",
        "heat",
        "misalignment",
        "shaft_bearings",
    ),
)
