"""Request and answer of the load of the mesh."""

import numpy as np
from pydantic import field_validator

from app.schemas.base import AccuracyOut, ResponseModel, WarningOut, no_dust, quantity
from app.schemas.precession.gear import Coordinate, GearFields
from app.units import to_si
from core.arrays import FloatArray, Vector
from core.errors import InvalidInput
from core.precession.meshing_load import MeshingLoad, line_load, meshing_load


class MeshingLoadRequest(GearFields):
    """A mesh and its torque."""

    torque_Nm: float = quantity(
        "Torque",
        symbol="M₁",
        group="load",
        ge=-1e12,
        le=1e12,
        step=1,
        help="Torque on the central wheel; its sign chooses the loaded flanks.",
    )
    reference_z_mm: Coordinate = quantity(
        "Place of C",
        symbol="l",
        group="load",
        step=1,
        help="Place of the bearing C along the axis, from the precession centre.",
    )

    _sizes = field_validator("torque_Nm", "reference_z_mm")(no_dust)

    def solve_load(self) -> MeshingLoad:
        """Load of the mesh."""
        try:
            return meshing_load(
                **self.gear(),
                rollers=self.all_rollers(),
                torque=self.torque_Nm,
                reference_z=to_si("reference_z_mm", self.reference_z_mm),
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


class MeshingLoadResponse(ResponseModel):
    """Resultants of the mesh, moment about the point C."""

    force_N: Vector
    moment_Nm: Vector
    max_line_load_N_per_mm: float
    total_length_mm: float
    accuracy: AccuracyOut
    warnings: list[WarningOut] | None = None
