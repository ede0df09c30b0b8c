"""Mesh of satellites with ring pins or involute ring teeth: request and answer."""

from functools import cached_property
from typing import Annotated, Any, ClassVar, Literal, Self, get_args

from pydantic import BeforeValidator, Field, model_validator

from app.calculations.involute_mesh import (
    InvoluteRingFields,
    drawn_path,
    pair_notices,
    solved_pair,
)
from app.calculations.load_sharing_answer import StiffnessCurveOut
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
from app.calculations.ring_parts import (
    CycloidRingFields,
    MeshCouplingFields,
    RingCrankFields,
    RingDeviationsFields,
    RingLoadFields,
    RingTeethFields,
)
from app.calculations.solved import Solved
from app.model import (
    UNION_TAGS,
    Angle,
    Calculation,
    Maybe,
    RequestModel,
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
from app.worked import worked
from core.design.ring import CycloidRing, InvoluteRing
from core.errors import InvalidInput
from core.output.elasticity import HertzLaw, SatelliteSupport, Shares
from core.output.real_curves import stiffness_curve
from core.output.turn import Turn
from core.ring.involute import InvolutePair, involute_pair
from core.ring.loss import RingFriction, RingLoss, ring_loss, sliding_part
from core.ring.profile import CycloidDisc, outline_points
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


def _of_its_kind(given: Any) -> Any:
    """Refuse fields of a ring of the other kind."""
    kinds = (("cycloid", InvoluteRingFields), ("involute", CycloidRingFields))
    own = {"cycloid": CycloidRingFields.model_fields, "involute": InvoluteRingFields.model_fields}
    for kind, other in kinds:
        if isinstance(given, dict) and given.get("kind") == kind:
            for name in given:
                if name in other.model_fields and name not in own[kind]:
                    raise field_error(name, "of_another_kind", kind=kind)
    return given


UNION_TAGS.update(("cycloid", "involute"))

OF_CYCLOIDS = (
    "deviations",
    "satellite_coupling",
    "lost_motion_torque_share",
    "chord_error_mm",
    "crank_angle_deg",
)
"""Fields of cycloid discs only."""


class RingMeshRequest(RequestModel, group="positions"):
    """Satellites, ring and load as the parts are made, and the results that are wanted."""

    RULES: ClassVar[tuple[dict[str, Any], ...]] = (
        {
            "if": {"properties": {"gear": {"properties": {"kind": {"const": "involute"}}}}},
            "then": {
                "not": {"anyOf": [{"required": [name]} for name in OF_CYCLOIDS]},
                "properties": {"include": {"items": {"enum": [*get_args(OfInvolutes)]}}},
            },
            "else": {
                "required": ["contact"],
                "properties": {
                    "include": {"items": {"enum": [*get_args(OfCycloids)]}},
                    "load": {"not": {"required": ["application_factor"]}},
                },
            },
        },
    )

    mechanism: RingTeethFields
    load: RingLoadFields
    contact: Maybe[RingCrankFields] = None
    gear: Annotated[
        CycloidRingFields | InvoluteRingFields,
        Field(discriminator="kind", description="Teeth of satellites and ring, by their kind."),
        BeforeValidator(_of_its_kind),
    ]
    deviations: RingDeviationsFields = Field(default_factory=RingDeviationsFields)
    satellite_coupling: MeshCouplingFields = Field(default_factory=MeshCouplingFields)
    lost_motion_torque_share: float = quantity(
        "Torque of the lost motion",
        group="load",
        default=0.03,
        step=0.01,
        advanced=True,
        ge=1e-6,
        le=1,
    )
    """Share of the torque, in both directions, under which the lost motion is measured."""
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
        if isinstance(given, dict) and "contact_law" in given:
            raise field_error("contact_law", "moved_to", field="gear.contact_law")
        return given

    @model_validator(mode="after")
    def _of_the_kind(self) -> Self:
        kind, own, named = self.gear.kind, self.mechanism, self.model_fields_set
        for name in OF_CYCLOIDS if kind == "involute" else ():
            if name in named:
                raise field_error(name, "of_another_kind", kind=kind)
        sections = get_args(OfInvolutes if kind == "involute" else OfCycloids)
        for index, name in enumerate(self.asked):
            if name not in sections:
                raise field_error(f"include/{index}", "of_another_kind", kind=kind)
        if kind == "involute":
            return self
        if own.ring_teeth != own.satellite_teeth + 1:
            more = {"expected": own.satellite_teeth + 1}
            raise field_error("mechanism/ring_teeth", "not_this_cycloid", **more)
        if self.contact is None:
            raise field_error("contact", "needed_beside", field="gear")
        if self.load.application_factor is not None:
            raise field_error("load/application_factor", "of_another_kind", kind=kind)
        return self

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse inputs beyond the operator's limits or too slow, and lists of other lengths."""
        super().refuse_beyond(settings)
        if self.gear.kind == "involute":
            return
        own = self.mechanism
        limits = [settings.max_pairs]
        limits += [MAX_TURN_PAIRS] if "over_turn" in self.asked else []
        limits += [MAX_FORCES // len(self.crank_angle_deg)] if "positions" in self.asked else []
        if own.pairs > min(limits):
            most = {"limit": min(limits) // own.satellites, "satellites": own.satellites}
            raise InvalidInput("ring_teeth", own.ring_teeth, "too_many_pairs", **most)
        self.deviations.refuse_other_lengths(own.ring_teeth, own.satellites)
        if isinstance(self.support, Shares) and len(self.support.shares) != own.satellites:
            counts = {"expected": own.satellites, "actual": len(self.support.shares)}
            raise refusal("/satellite_coupling/shares", "different_length", **counts)

    @property
    def asked(self) -> list[Section]:
        """Sections of the answer."""
        return self.include or ["stresses" if self.gear.kind == "involute" else "positions"]

    @property
    def cycloid(self) -> CycloidRingFields:
        """The ring of cycloid discs."""
        assert isinstance(self.gear, CycloidRingFields)
        return self.gear

    @property
    def eccentricity(self) -> float | None:
        """Eccentricity of the cranks, m; None if involute teeth determine it."""
        if self.contact is None:
            return None
        given: float = to_si("eccentricity_mm", self.contact.eccentricity_mm)
        return given

    @property
    def pair(self) -> InvolutePair:
        """Involute satellite in its ring, in SI units."""
        own = self.mechanism
        teeth = self.involute.involute_teeth(
            satellite_teeth=own.satellite_teeth, ring_teeth=own.ring_teeth
        )
        return involute_pair(teeth=teeth, eccentricity=self.eccentricity)

    @cached_property
    def involute(self) -> InvoluteRing:
        """The ring of involute teeth, in SI units."""
        assert isinstance(self.gear, InvoluteRingFields)
        difference = self.mechanism.ring_teeth - self.mechanism.satellite_teeth
        return InvoluteRing(**self.gear.to_core() | {"teeth_difference": difference})

    @property
    def loaded_teeth(self) -> dict[str, Any]:
        """Arguments of the stresses of involute teeth."""
        factor = self.load.application_factor or 1.0
        return {
            "torque": self.load.output_torque_Nm / self.mechanism.satellites,
            "contact_length": self.involute.contact_length,
            "satellite_material": self.involute.satellite_material,
            "ring_material": self.involute.ring_material,
            "load_factor": factor * self.involute.face_load_factor,
        }

    @property
    def support(self) -> SatelliteSupport:
        """Given shares of the torque."""
        made: SatelliteSupport = self.satellite_coupling.section()
        return made

    @cached_property
    def torque(self) -> float:
        """Torque with the sign of its direction, N*m."""
        way = -1.0 if self.load.torque_direction == "reverse" else 1.0
        return way * self.load.output_torque_Nm

    @cached_property
    def disc(self) -> CycloidDisc:
        """The discs, in SI units."""
        eccentricity = self.given["contact"].eccentricity_mm  # cycloids need it
        ring: CycloidRing = self.cycloid.section()
        return ring.disc(
            satellite_teeth=self.mechanism.satellite_teeth,
            eccentricity=to_si("eccentricity_mm", eccentricity),
        )

    @cached_property
    def mesh(self) -> CycloidMesh:
        """The mesh as it is made, in SI units."""
        ring: CycloidRing = self.cycloid.section()
        return ring.cycloid_mesh(
            disc=self.disc,
            contact_length=ring.contact_length,
            disc_material=ring.disc_material,
            crank_angles=self.mechanism.crank_angles,
            law=ring.contact_law or HertzLaw(),
            deviations=self.deviations.section(),
            support=self.support,
        )

    @property
    def friction(self) -> RingFriction:
        """Sliding contact of the ring; without a coefficient it is taken as 0."""
        ring: CycloidRing = self.cycloid.section()
        coefficient = ring.friction_coefficient or 0.0
        return RingFriction(coefficient, ring.sleeve_bore_radius, ring.rolling)

    @property
    def input_speed(self) -> float | None:
        """Speed of the crank, rad/s."""
        given: float | None = to_si("input_speed_rpm", self.load.input_speed_rpm)
        return given

    def _loss(self, turn: MeshTurn) -> RingLoss | None:
        """Friction over the turn, if its coefficient is given."""
        if self.cycloid.friction_coefficient is None:
            return None
        return ring_loss(turn=turn, friction=self.friction, input_speed=self.input_speed)

    def solve_all(self) -> Solved:
        """Requested results."""
        if self.gear.kind == "involute":
            return self._solve_pair()
        solved, asked = Solved(), {*self.asked}
        mesh = self.mesh
        solved.values |= {"kind": "cycloid", "geometry": RingGeometryOut.values(self.disc)}
        if "ideal" in asked:
            each = self.load.output_torque_Nm / self.mechanism.satellites
            solved.values["ideal"] = RingIdealOut.of(self.disc, each)
        if "over_turn" in asked:
            turn = mesh_over_turn(
                mesh=mesh,
                output_torque=self.torque,
                lost_motion_share=self.lost_motion_torque_share,
            )
            solved.values["over_turn"] = MeshTurnOut.values(turn)
            solved.take(turn.accuracy, turn.notices)
            if loss := self._loss(turn):
                solved.values["efficiency"] = RingEfficiencyOut.values(loss)
        if "positions" in asked:
            solved.values["positions"] = [self._position(angle, solved) for angle in self.angles]
        if "stiffness_curve" in asked:
            torques = [share * self.load.output_torque_Nm for share in TORQUES]
            lag = stiffness_curve(real=mesh, crank_angle=self.angles[0], torques=torques)
            solved.values["stiffness_curve"] = StiffnessCurveOut.values(lag)
            solved.take(lag.accuracy)
        if "profile" in asked:
            error = to_si("chord_error_mm", self.chord_error_mm)
            points = outline_points(disc=self.disc, chord_error=error)
            solved.values["profile"] = ProfileOut.of(points)
        if not solved.accuracies:
            solved.take(self.disc.accuracy)
        return solved

    def solve_steps(self) -> list[Values]:
        """Worked steps of the requested sections."""
        if isinstance(self.gear, InvoluteRingFields):
            return worked(geometry=involute_steps(self.pair))
        asked, disc, torque = {*self.asked}, self.disc, self.load.output_torque_Nm
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
                    coefficient=self.friction.coefficient,
                    torque=torque,
                    teeth=disc.satellite_teeth,
                    input_speed=self.input_speed,
                )
        return worked(**steps)

    def _solve_pair(self) -> Solved:
        pair = self.pair
        return solved_pair(
            ring=self.involute,
            pair=pair,
            loaded=self.loaded_teeth,
            output_torque=self.load.output_torque_Nm,
            input_speed=self.input_speed,
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
        speed = None
        if self.input_speed is not None:
            speed = found.sliding_distance * self.input_speed / self.disc.satellite_teeth
        part = sliding_part(disc=self.disc, friction=self.friction)
        return MeshPositionOut.values(
            found,
            sliding_speed_m_per_s=speed,
            loss_per_friction=part * found.sliding_loss,
            pressed_without_load=True if found.play is None else None,
        )

    def solve_path(self) -> DrawnPath:
        """Pressure along the path of contact."""
        return drawn_path(pair=self.pair, loaded=self.loaded_teeth)

    def solve_for_drawing(self) -> ShownMesh:
        """All values that the figure shows."""
        turn = MeshTurn(Turn(self.mesh, self.torque))
        return ShownMesh.at_angle(turn, self.angles[0])


def work(body: RingMeshRequest) -> list[Values]:
    """Worked steps of the geometry, and of requested sections."""
    return body.solve_steps()


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
    if body.gear.kind == "involute":
        path = body.solve_path()
        return path_figure(path, theme)
    own = body.mechanism
    if own.pairs > MAX_DRAWN_PAIRS:
        most = {"limit": MAX_DRAWN_PAIRS // own.satellites, "satellites": own.satellites}
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
    worked=work,
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
