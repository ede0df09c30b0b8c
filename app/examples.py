"""The papers' figures and numbers as ready requests, and a design that works to begin with.

The papers print no torque and no sizes for the figures that show ratios; where a request needs
them, the example takes round numbers and its title says what to look at. With these sizes a
through-hardened satellite does not stand the pressure; the opening example case-hardens it.
"""

from typing import Any

from app.sources import (
    KHATETOVSKY_2020,
    OVSYANNIKOV_2019,
    YANCHEVSKIY_2021,
    YANCHEVSKY_2018,
    ZYL,
)

_CONTACT = {
    "contact_length_mm": 20.0,
    "pin_radius_mm": 8.0,
    "hole_radius_mm": 10.0,
    "pin_material": "steel_bearing",
    "hole_material": "steel_through_hardened",
}
_LOAD = {"output_torque_Nm": 280.0, "pin_circle_radius_mm": 28.0}


def _crank_planetary(
    name: str,
    title: str,
    source: str,
    mechanism: dict[str, Any],
    load: dict[str, Any] | None = None,
    contact: dict[str, Any] | None = None,
) -> dict[str, Any]:
    """One example of the crank-planetary calculator."""
    return {
        "id": name,
        "title": title,
        "source": source,
        "calculation": "crank-planetary",
        "input": {
            "mechanism": mechanism,
            "load": _LOAD | (load or {}),
            "contact": _CONTACT | {"eccentricity_mm": 2.0} | (contact or {}),
        },
    }


def _figure_6(letter: str, title: str, **mechanism: float) -> dict[str, Any]:
    """A cyclogram of fig. 6 of the 2021 paper (u = 20)."""
    return _crank_planetary(
        f"yanchevskiy-2021-fig-6{letter}",
        f"{title} (2021, fig. 6 {letter})",
        f"{YANCHEVSKIY_2021}, fig. 6 {letter}",
        {"ratio": 20.0, **mechanism},
    )


def _rollers(name: str, title: str, figure: str, **change: float | None) -> dict[str, Any]:
    """An example of the 2019 paper's rollers: d = 10 mm, T = 0.001*E*d^3."""
    design: dict[str, float | None] = {
        "output_torque_Nm": 210.0,
        "hole_circle_radius_mm": 30.0,
        "rollers": 4,
        "position_tolerance_mm": 0.002,
        "diameter_mm": 10.0,
        "cylinder_length_mm": 20.0,
        "sphere_width_mm": 8.0,
        "sphere_diameter_mm": 15.0,
        "friction_coefficient": 0.16,
        "youngs_modulus_GPa": 210.0,
        "poissons_ratio": 0.3,
        "stress_concentration": 2.0,
    }
    design.update(change)
    return {
        "id": name,
        "title": title,
        "source": f"{OVSYANNIKOV_2019}, {figure}",
        "calculation": "roller-strength",
        "input": {key: value for key, value in design.items() if value is not None},
    }


def _precession(name: str, title: str, **change: Any) -> dict[str, Any]:
    """An example of the precessional gear."""
    design = {
        "roller_circle_radius_mm": 50.0,
        "roller_radius_mm": 4.0,
        "nutation_angle_deg": 6.0,
        "ratio_u12": 0.96,
        "torque_Nm": 10.0,
        "reference_z_mm": 20.0,
        "bearing_distance_mm": 30.0,
        "overhang_mm": 40.0,
        "shaft_diameter_mm": 20.0,
        "youngs_modulus_GPa": 210.0,
    } | change
    return {
        "id": name,
        "title": title,
        "source": KHATETOVSKY_2020,
        "calculation": "precession/shaft-deflection",
        "input": {key: value for key, value in design.items() if value is not None},
    }


EXAMPLES: list[dict[str, Any]] = [
    _crank_planetary(
        "opening",
        "To begin with: 3 pins, 2 satellites, case-hardened",
        f"{YANCHEVSKIY_2021}, fig. 6 a",
        {"pins": 3, "satellites": 2, "crank_spacing_deg": 180.0, "ratio": 20.0},
        contact={"hole_material": "steel_case_hardened"},
    ),
    _figure_6(
        "a",
        "3 pins, 2 satellites at 180°: always 3 pairs",
        pins=3,
        satellites=2,
        crank_spacing_deg=180.0,
    ),
    _figure_6(
        "b",
        "3 pins, 2 satellites at 120°: 2 or 4 pairs",
        pins=3,
        satellites=2,
        crank_spacing_deg=120.0,
    ),
    _figure_6(
        "c",
        "3 pins, 2 satellites at 90°: 2, 3 or 4 pairs",
        pins=3,
        satellites=2,
        crank_spacing_deg=90.0,
    ),
    _figure_6(
        "d",
        "3 pins, 3 satellites at 120°: 3 or 6 pairs",
        pins=3,
        satellites=3,
        crank_spacing_deg=120.0,
    ),
    _figure_6(
        "e",
        "4 pins, 3 satellites at 120°: always 6 pairs",
        pins=4,
        satellites=3,
        crank_spacing_deg=120.0,
    ),
    _figure_6(
        "f",
        "3 pins, 4 satellites at 90°: always 6 pairs",
        pins=3,
        satellites=4,
        crank_spacing_deg=90.0,
    ),
    _crank_planetary(
        "yanchevskiy-2021-fig-7",
        "Force curve of 3 satellites: complex over the turn (2021, fig. 7)",
        f"{YANCHEVSKIY_2021}, fig. 7",
        {"pins": 3, "satellites": 3, "crank_spacing_deg": 120.0, "ratio": 20.0},
    ),
    _crank_planetary(
        "yanchevsky-2018-fig-4a",
        "3 pins, 1 satellite: 1 or 2 pairs (2018, fig. 4 a and 6 a)",
        f"{YANCHEVSKY_2018}, fig. 4 a, 6 a",
        {"pins": 3, "satellites": 1, "ratio": 20.0, "initial_crank_angle_deg": 180.0},
    ),
    _crank_planetary(
        "yanchevsky-2018-fig-4b",
        "3 pins, 2 satellites: always 3 pairs (2018, fig. 4 b and 6 b)",
        f"{YANCHEVSKY_2018}, fig. 4 b, 6 b",
        {"pins": 3, "satellites": 2, "ratio": 20.0, "initial_crank_angle_deg": 180.0},
    ),
    _crank_planetary(
        "zyl-6-pins",
        "Equal sharing, 6 pins: 888.2 N (Zyl)",
        f"{ZYL}, text",
        {"pins": 6, "satellites": 1, "ratio": 30.0},
        {"output_torque_Nm": 50.0, "pin_circle_radius_mm": 32.5, "force_exponent": 0.0},
    ),
    _crank_planetary(
        "zyl-4-pins",
        "Equal sharing, 4 pins: 1538 N (Zyl)",
        f"{ZYL}, text",
        {"pins": 4, "satellites": 1, "ratio": 30.0},
        {"output_torque_Nm": 50.0, "pin_circle_radius_mm": 32.5, "force_exponent": 0.0},
    ),
    _crank_planetary(
        "clearance",
        "0.03 mm of clearance: fewer pins carry, each more",
        f"{YANCHEVSKIY_2021}, without clearance",
        {"pins": 6, "satellites": 2, "ratio": 20.0},
        {"output_torque_Nm": 400.0, "pin_circle_radius_mm": 50.0},
        {"hole_radius_mm": 10.03},
    ),
    {
        "id": "whole",
        "title": "A whole reducer of 400 N·m: pins, losses, bearings and crankshaft",
        "source": "docs/tutorial.md",
        "calculation": "crank-planetary",
        "input": {
            "mechanism": {"pins": 8, "satellites": 2, "satellite_teeth": 40, "ring_teeth": 42},
            "load": {
                "output_torque_Nm": 400.0,
                "pin_circle_radius_mm": 38.0,
                "input_speed_rpm": 720.0,
            },
            "contact": {
                "contact_length_mm": 22.0,
                "pin_radius_mm": 8.0,
                "hole_radius_mm": 11.68,
                "eccentricity_mm": 3.68,
                "dynamic_factor": 1.25,
                "pin_material": "steel_case_hardened",
                "hole_material": "steel_case_hardened",
            },
            "pin": {
                "support": "fixed",
                "span_mm": 50.0,
                "satellite_positions_mm": [13.0, 37.0],
                "material": "steel_through_hardened",
            },
            "fatigue": {
                "surface": "ground",
                "fatigue_notch_factor": 1.5,
                "reliability_percent": 99.0,
            },
            "friction": {"coefficient": 0.08},
            "gear": {"kind": "involute", "module_mm": 3.0, "teeth_difference": 2},
            "bearing": {
                "kind": "roller",
                "dynamic_rating_N": 50000.0,
                "static_rating_N": 52000.0,
            },
            "crankshaft": {
                "satellite_positions_mm": [30.0, 54.0],
                "bearing_positions_mm": [0.0, 84.0],
                "bearings": [{"kind": "ball", "dynamic_rating_N": 14000.0}] * 2,
            },
            "requirements": {"life_h": 1500.0},
        },
    },
    _rollers("ovsyannikov-2019-fig-6", "4 rollers, l/d = 2, χ/d = 2·10⁻⁴ (2019, fig. 6)", "fig. 6"),
    _rollers(
        "ovsyannikov-2019-fig-4",
        "Stiffness over length, G = 78 GPa (2019, fig. 4)",
        "fig. 4",
        poissons_ratio=None,
        shear_modulus_GPa=78.0,
        cylinder_length_mm=10.0,
    ),
    _rollers(
        "ovsyannikov-2019-fig-5",
        "Beyond the limit one roller carries all (2019, fig. 5)",
        "fig. 5",
        position_tolerance_mm=0.05,
    ),
    _precession(
        "khatetovsky-2020-four-rollers",
        "4 rollers in mesh, shaft of one diameter (2020)",
        rollers=[
            {"position_angle_deg": angle, "z_min_mm": 15.0, "z_max_mm": 25.0}
            for angle in (30.0, 60.0, 90.0, 120.0)
        ],
    ),
    _precession(
        "khatetovsky-2020-wheel",
        "Wheel of 24 rollers, 9 in mesh, stepped shaft (2020)",
        wheel={
            "rollers_total": 24,
            "rollers_in_mesh": 9,
            "position_angle_deg": 30.0,
            "z_min_mm": 15.0,
            "z_max_mm": 25.0,
        },
        shaft_diameter_mm=None,
        shaft_sections=[
            {"length_mm": 30.0, "diameter_mm": 20.0},
            {"length_mm": 40.0, "diameter_mm": 25.0},
        ],
    ),
]
"""Ready requests in the order of the page, which opens with the first of a calculation."""


def _of(name: str) -> dict[str, Any]:
    """Request of an example."""
    return dict(next(each for each in EXAMPLES if each["id"] == name)["input"])


def _without(request: dict[str, Any], *names: str) -> dict[str, Any]:
    return {name: value for name, value in request.items() if name not in names}


_JOB = _of("yanchevskiy-2021-fig-6a")
_SHAFT = _of("khatetovsky-2020-four-rollers")
_MESH = _without(
    _SHAFT, "bearing_distance_mm", "overhang_mm", "shaft_diameter_mm", "youngs_modulus_GPa"
)
_FORCE = _JOB["mechanism"] | _JOB["load"]
_RING = {"kind": "cycloid", "ring_pin_circle_radius_mm": 84.0, "ring_pin_radius_mm": 5.0}

REQUESTS: dict[str, dict[str, Any]] = {
    "cyclogram": _JOB["mechanism"],
    "contact-force": _FORCE,
    "hertz": {"force_N": 6667.0} | _CONTACT,
    "crank-planetary": _JOB,
    "output-efficiency": {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
        "load": {
            "output_torque_Nm": 500.0,
            "pin_circle_radius_mm": 50.0,
            "input_speed_rpm": 1500.0,
        },
        "contact": {"contact_length_mm": 20.0, "pin_radius_mm": 8.0, "eccentricity_mm": 2.0},
        "friction": {"coefficient": 0.08, "wear_rate_mm3_per_Nm": 1e-8, "life_h": 3000.0},
    },
    "load-sharing": {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
        "load": {"output_torque_Nm": 200.0, "pin_circle_radius_mm": 40.0},
        "contact": {
            "contact_length_mm": 12.0,
            "pin_radius_mm": 5.0,
            "eccentricity_mm": 2.0,
            "hole_clearance_mm": 0.03,
        },
        "deviations": {"pin_tangential_mm": [-0.02, 0.0, 0.0, 0.0, 0.0, 0.0]},
        "include": ["positions", "over_turn", "ideal"],
    },
    "pin-strength": {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
        "load": {
            "output_torque_Nm": 500.0,
            "pin_circle_radius_mm": 50.0,
            "input_speed_rpm": 1500.0,
        },
        "pin": {
            "diameter_mm": 16.0,
            "contact_length_mm": 20.0,
            "satellite_positions_mm": [15.0, 37.0],
            "material": {
                "youngs_modulus_GPa": 210.0,
                "poissons_ratio": 0.3,
                "tensile_strength_MPa": 1000.0,
                "yield_strength_MPa": 800.0,
            },
        },
        "fatigue": {"surface": "ground", "reliability_percent": 99.0, "fatigue_notch_factor": 1.2},
        "include": ["deflection"],
    },
    "satellite-bearing": {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
        "load": {
            "output_torque_Nm": 500.0,
            "pin_circle_radius_mm": 50.0,
            "input_speed_rpm": 1500.0,
        },
        "contact": {"eccentricity_mm": 2.0},
        "gear": _RING,
        "bearing": {"kind": "roller", "dynamic_rating_N": 60000.0, "static_rating_N": 50000.0},
    },
    "crankshaft": {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
        "load": {
            "output_torque_Nm": 500.0,
            "pin_circle_radius_mm": 50.0,
            "input_speed_rpm": 1500.0,
        },
        "contact": {"eccentricity_mm": 2.0},
        "gear": _RING,
        "crankshaft": {
            "satellite_positions_mm": [20.0, 42.0],
            "bearing_positions_mm": [0.0, 62.0],
            "satellite_mass_kg": 1.5,
            "bearings": [{"kind": "ball", "dynamic_rating_N": 30000.0}] * 2,
        },
    },
    "tolerance-study": {
        "mechanism": {"pins": 6, "satellites": 2, "ratio": 20.0},
        "load": {"output_torque_Nm": 200.0, "pin_circle_radius_mm": 40.0},
        "contact": {
            "contact_length_mm": 12.0,
            "pin_radius_mm": 5.0,
            "eccentricity_mm": 2.0,
            "hole_clearance_mm": 0.02,
        },
        "tolerances": {
            "pin_position_mm": 0.01,
            "hole_position_mm": 0.02,
            "pin_diameter": {"class": "m6"},
            "hole_diameter": {"class": "H7"},
            "eccentricity_mm": 0.005,
            "disc_phase_deg": 0.01,
        },
        "samples": 40,
        "crank_angles": 24,
        "percentiles": [50.0, 90.0],
        "limits": {"peak_force_N": 3200.0},
    },
    "roller-strength": _of("ovsyannikov-2019-fig-6"),
    "precession/contact-line": _without(_MESH, "torque_Nm", "reference_z_mm") | {"torque_sign": 1},
    "precession/meshing-load": _MESH,
    "precession/shaft-deflection": _SHAFT,
    "batch": {
        "calculation": "hertz",
        "requests": [{"force_N": force} | _CONTACT for force in (5000.0, 6667.0)],
    },
    "solve": {
        "calculation": "crank-planetary",
        "input": _JOB,
        "variable": {"pointer": "/contact/pin_radius_mm", "from": 2.0, "to": 20.0},
        "target": {"pointer": "/hertz/safety_factor", "at_least": 1.5},
    },
    "work-precision": {"calculation": "contact-force", "input": _FORCE},
}
"""One request for each endpoint, for the API's description; its chart takes the same."""
