"""Load of the precessional mesh: request, answer, figure."""

import numpy as np
from pydantic import field_validator

from app.calculations.contact_line import MOST_NAMED
from app.calculations.gear import Coordinate, GearFields
from app.model import (
    Calculation,
    Values,
    WorkedFields,
    WorkedResponse,
    no_dust,
    quantity,
    timed,
)
from app.sources import KHATETOVSKY_2020
from app.theme import Amount, Chart, Figure, Theme, text
from app.units import from_si, to_si
from app.worked import Steps
from core.errors import InvalidInput
from core.precession.meshing_load import MeshingLoad, line_load, meshing_load
from core.worked.precession import load_steps


class MeshFields(GearFields, group="load"):
    """A mesh and its torque."""

    torque_Nm: float = quantity("Torque", "M₁", step=1, ge=-1e12, le=1e12)
    """Torque on the central wheel; the sign chooses the loaded flanks."""
    reference_z_mm: Coordinate = quantity("Place of C", "l", step=1)
    """Position of the bearing C along the axis, from the centre of precession."""

    _sizes = field_validator("torque_Nm", "reference_z_mm")(no_dust)

    @property
    def loaded_by(self) -> dict[str, float]:
        """Torque, N*m, and place of C, m."""
        return {
            "torque": self.torque_Nm,
            "reference_z": to_si("reference_z_mm", self.reference_z_mm),
        }

    def solve_load(self) -> MeshingLoad:
        """Load of the mesh."""
        try:
            return meshing_load(
                **self.gear(),
                rollers=self.all_rollers(),
                **self.loaded_by,
            )
        except InvalidInput as error:
            raise self.about_the_wheel(error) from error


class MeshingLoadRequest(MeshFields, WorkedFields):
    """Mesh and its torque, with optional worked steps."""

    def steps(self) -> Steps:
        """Worked steps of the load."""
        return {
            "meshing_load": load_steps(gear=self.gear(), found=self.solve_load(), **self.loaded_by)
        }


class MeshingLoadResponse(WorkedResponse, of=MeshingLoad):
    """Resultants of the mesh, moment about the point C."""


def solve(body: MeshingLoadRequest) -> Values:
    """Line load, force and moment of the mesh."""
    return MeshingLoadResponse.values(*timed(body.solve_load))


def figure(body: MeshingLoadRequest, theme: Theme = "light") -> Figure:
    """Line load along every contact line."""
    load, chart = body.solve_load(), Chart(theme, height=340)
    chart.axis("x", "along_axis", "mm")
    chart.axis("y", "line_load", "N/mm", rangemode="tozero")
    shown = {"load": Amount("%{y:.4g}", "N/mm"), "place": Amount("%{x:.4g}", "mm")}
    for index, line in enumerate(load.lines):
        z = np.linspace(line.z_min, line.z_max, 61)
        name = text("roller_angle", angle=Amount(from_si("angle_deg", line.position_angle), "°"))
        chart.curve(
            name,
            from_si("z_mm", z),
            from_si("load_N_per_mm", line_load(load=load, line=line, z=z)),
            index,
            text("line_load_hover", name=name, **shown),
            showlegend=len(load.lines) <= MOST_NAMED,
        )
    return chart.figure


CALCULATION = Calculation(
    name="precession/meshing-load",
    title="Load of the precessional mesh",
    tag="precessional gear",
    request=MeshingLoadRequest,
    answer=MeshingLoadResponse,
    solve=solve,
    figure=figure,
    sources=(KHATETOVSKY_2020,),
    neglects=("deviations", "elasticity", "friction"),
)
