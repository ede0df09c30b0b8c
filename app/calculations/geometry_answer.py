"""Answer about pins and holes at one crank angle."""

from app.calculations.mechanism import PairOut
from app.model import AccuracyOut, Maybe, ResponseModel, Values, WarningOut, result
from app.units import from_si
from core.arrays import FloatArray
from core.output.mechanism import PinGeometry


class PointOut(ResponseModel):
    """Pin with its centre."""

    pin: int = result("Number of the pin, from 1.", symbol="n")
    centre_mm: tuple[float, float] = result(
        "Centre of the pin, X and Y.", symbol="M_n", equation="2021, before eq. 6"
    )


class PairGeometryOut(PairOut):
    """Hole, contact point and pressure angle of one pair."""

    hole_centre_mm: tuple[float, float] = result(
        "Centre of the hole, X and Y.", symbol="B_jn", equation="2021, before eq. 6"
    )
    contact_point_mm: tuple[float, float] = result(
        "Contact point, X and Y.", symbol="E_jn", equation="2021, before eq. 6"
    )
    pressure_angle_deg: float = result(
        "Angle between the velocity of the pin and the force.",
        symbol="γ_jn",
        equation="2021, eq. 6",
    )
    driving: bool = result("True if the pair transmits force.")
    force_N: float = result("Force of the pair.", symbol="F_jn", equation="2021, eq. 10")


class GeometryOut(ResponseModel):
    """Pins and holes at a crank angle (Y up through pin 1 at crank angle 0, X right)."""

    clearance_mm: float = result(
        "Radius of the hole less that of the pin and less the eccentricity; negative for "
        "interference.",
        symbol="c",
    )
    pins: list[PointOut] = result("Pins in the order of their numbers.")
    pairs: list[PairGeometryOut] = result("Pairs of pins and holes, satellite by satellite.")
    accuracy: AccuracyOut
    warnings: Maybe[list[WarningOut]] = None

    @classmethod
    def values(
        cls,
        result: tuple[PinGeometry, FloatArray],
        run_time_us: float | None = None,
        **given: object,
    ) -> Values:
        """Values of the geometry and the forces of the pairs, N, satellite by satellite."""
        geometry, forces = result
        satellites, pins = geometry.driving.shape
        force = from_si("force_N", forces).tolist()
        centres = from_si("centre_mm", geometry.pin_centres).tolist()
        holes = from_si("hole_centre_mm", geometry.hole_centres).tolist()
        contacts = from_si("contact_point_mm", geometry.contact_points).tolist()
        angles = from_si("pressure_angle_deg", geometry.pressure_angles).tolist()
        driving = (forces > 0).tolist()
        return super().values(
            geometry,
            run_time_us,
            pins=[{"pin": n + 1, "centre_mm": centres[n]} for n in range(pins)],
            pairs=[
                {
                    "satellite": j + 1,
                    "pin": n + 1,
                    "hole_centre_mm": holes[j][n],
                    "contact_point_mm": contacts[j][n],
                    "pressure_angle_deg": angles[j][n],
                    "driving": driving[j][n],
                    "force_N": force[j][n],
                }
                for j in range(satellites)
                for n in range(pins)
            ],
            **given,
        )
