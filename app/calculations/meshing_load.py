"""Load of the precessional mesh: request, answer, figure."""

from collections.abc import Sequence

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
from app.theme import Amount, Figure, Theme, axis, curve, layout, text
from app.units import from_si, to_si
from app.worked import Steps
from core.arrays import FloatArray
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

    def solve_curves(self) -> list[tuple[float, FloatArray, FloatArray]]:
        """Line load of every roller: position angle, rad, places z, m, load there, N/m."""
        load = self.solve_load()
        curves = []
        for line in load.lines:
            z = np.linspace(line.z_min, line.z_max, 61)
            curves.append((line.position_angle, z, line_load(load=load, line=line, z=z)))
        return curves


class MeshingLoadRequest(MeshFields, WorkedFields):
    """Mesh and its torque, with optional worked steps."""

    def steps(self) -> Steps:
        """Worked steps of the load."""
        return {
            "meshing_load": load_steps(gear=self.gear(), found=self.solve_load(), **self.loaded_by)
        }


class MeshingLoadResponse(WorkedResponse, of=MeshingLoad):
    """Resultants of the mesh, moment about the point C."""


def meshing_load_figure(
    curves: Sequence[tuple[float, FloatArray, FloatArray]], theme: Theme
) -> Figure:
    """Line load of every roller along the axis; `curves` as in `MeshFields.solve_curves`."""
    data = []
    for index, (angle, z, load) in enumerate(curves):
        name = text("roller_angle", angle=Amount(from_si("angle_deg", angle), "°"))
        data.append(
            curve(
                name,
                from_si("z_mm", z),
                from_si("load_N_per_mm", load),
                index,
                theme,
                text(
                    "line_load_hover",
                    name=name,
                    load=Amount("%{y:.4g}", "N/mm"),
                    place=Amount("%{x:.4g}", "mm"),
                ),
                showlegend=len(curves) <= MOST_NAMED,
            )
        )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=340,
            xaxis=axis(theme, text("along_axis"), "mm"),
            yaxis=axis(theme, text("line_load"), "N/mm", rangemode="tozero"),
        ),
    }


def solve(body: MeshingLoadRequest) -> Values:
    """Line load, force and moment of the mesh."""
    return MeshingLoadResponse.values(*timed(body.solve_load))


def figure(body: MeshingLoadRequest, theme: Theme = "light") -> Figure:
    """Line load along every contact line."""
    curves = body.solve_curves()
    return meshing_load_figure(curves, theme)


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
