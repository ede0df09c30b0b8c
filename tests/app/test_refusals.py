"""Refusals of requests: the field by its pointer, and a code."""

import pytest

from app.examples import REQUESTS
from tests.inputs.bodies import changed
from tests.inputs.involute import CASES

pytestmark = pytest.mark.anyio


def row(pointer, code, /, **changes):
    """A refusal and the changes of a body that cause it."""
    return pointer, code, changes


PINS = REQUESTS["pin-strength"]["pin"]
POWER = {"kind": "power", "exponent": 0.4, "reference_force_N": 1, "reference_approach_mm": 1}
BENT = {"support": "fixed", "satellite_positions_mm": [9.0, 23.0], "span_mm": 34.0}
TIED = {"support": "tie_ring", "satellite_positions_mm": [15.0, 37.0], "span_mm": 52.0}
SHORT = {"support": "fixed", "span_mm": 45.0}
PERCENT = {"surface": "ground", "fatigue_notch_factor": 1.0, "reliability_percent": 93}
HELD = {"pin_support": "fixed", "span_mm": 40.0}
LONE = {"pins": 2, "satellites": 1}
ELASTIC = {"kind": "elastic", "stiffness_Nm_per_arcmin": 30.0}
DEEP = {"kind": "hertz", "reference_depth_mm": 11.0}
SHALLOW = {"kind": "hertz", "reference_depth_mm": 2.0}

WHOLE = REQUESTS["output-efficiency"] | {
    "pin": {name: PINS[name] for name in ("satellite_positions_mm", "material")},
    "fatigue": {"endurance_limit_MPa": 300.0},
    "gear": {"kind": "involute", "module_mm": 1.75, "teeth_difference": 2},
    "bearing": {"kind": "ball", "dynamic_rating_N": 60000.0, "static_rating_N": 40000.0},
    "crankshaft": REQUESTS["crankshaft"]["crankshaft"],
}
"""Design with all sections of strength and life."""

RING = changed(
    REQUESTS["ring-mesh"],
    mechanism={"pins": 6},
    load={"pin_circle_radius_mm": 32.0},
    contact={"pin_radius_mm": 5.0, "contact_length_mm": 12.0, "hole_clearance_mm": 0.02},
    deviations=None,
    include=["checks"],
)
"""The ring of the example with pins of an output."""

ROUND = CASES[1]["body"]
"""Involute teeth, 40 in 42."""

STATED = changed(
    REQUESTS["load-sharing"], contact__hole_clearance_mm=None, deviations=None, include=None
)
"""Design without a clearance, whose shares may be stated."""

FITTED = changed(REQUESTS["crank-planetary"], contact__hole_radius_mm=None, contact__fit="H7/f7")
NONE = dict.fromkeys(REQUESTS["ring-mesh"]["gear"])
WEIGHT = {"unbalance_kg_mm": 3.0, "position_mm": 31.0}
STUDY = changed(REQUESTS["tolerance-study"], tolerances=None)
RING_STUDY = changed(
    RING,
    include=None,
    tolerances={"ring_pin_position_mm": 0.008},
    quantities=["ring_peak_force_N"],
    samples=6,
    crank_angles=12,
    percentiles=[50],
)


def of_study(rows):
    """Rows of tolerances alone."""
    for pointer, code, tolerances in rows:
        yield pointer, code, {"tolerances": tolerances}


NUMBERS = [
    row("/pins", "greater_than_equal", pins=0),
    row("/pins", "int_type", pins=2.5),
    row("/pins", "int_type", pins="5"),
    row("/pins", "int_type", pins=True),
    row("/ratio", "not_zero", ratio=0),
    row("/ratio", "needed", ratio=None),
    row("/crank_angles_deg", "different_length", crank_spacing_deg=None, crank_angles_deg=[0]),
    row("/crank_angles_deg", "only_one", crank_angles_deg=[0, 90]),
    row("/crank_angles_deg/1", "float_type", crank_spacing_deg=None, crank_angles_deg=[0, "90"]),
    row("/satellite_teeth", "only_one", satellite_teeth=40),
    row("/ring_teeth", "needed_beside", ratio=None, satellite_teeth=40),
    row("/ring_teeth", "larger_than", ratio=None, satellite_teeth=40, ring_teeth=40),
    row("/force_exponent", "greater_than_equal", force_exponent=-1),
    row("/input_torque_Nm", "only_one", input_torque_Nm=1),
    row("/efficiency", "needed_beside", output_torque_Nm=None, input_torque_Nm=1),
    row("/output_torque_Nm", "needed", output_torque_Nm=None),
    row("/pin_circle_radius_mm", "greater_than_equal", pin_circle_radius_mm=0),
    row("/include/1", "literal_error", include=["curves", "nonsense"]),
    row("/samples", "greater_than_equal", include=["curves"], samples=1),
    row("/a~1b", "extra_forbidden", **{"a/b": 1}),
]

SECTIONS = [
    row("/pin", "needed_for", pin=None, include=["pin_strength"]),
    row("/friction", "needed_for", friction=None, include=["output_efficiency"]),
    row("/gear", "needed_for", gear=None, include=["satellite_bearing"]),
    row("/bearing", "needed_for", bearing=None, include=["satellite_bearing"]),
    row("/crankshaft", "needed_for", crankshaft=None, include=["crankshaft"]),
    row("/load/input_speed_rpm", "needed_for", load__input_speed_rpm=None, include=["crankshaft"]),
    row(
        "/contact/eccentricity_mm",
        "needed_for",
        contact__eccentricity_mm=None,
        contact__hole_radius_mm=10.0,
        include=["output_efficiency"],
    ),
    row("/load/torque_direction", "literal_error", load__torque_direction="both"),
    row(
        "/load/application_factor",
        "only_one",
        load__application_factor=1.2,
        contact__dynamic_factor=1.0,
    ),
    row(
        "/contact/eccentricity_mm",
        "needed_beside",
        contact__eccentricity_mm=None,
        contact__hole_clearance_mm=0.03,
    ),
    row("/contact/hole_radius_mm", "needed", contact__eccentricity_mm=None),
    row("/contact/hole_radius_mm", "larger_than", contact__hole_radius_mm=7.9),
    row("/contact/eccentricity_mm", "no_mesh", gear__module_mm=5.0),
    row("/pin", "needed_beside", pin=None, friction__sleeve=True),
    row("/pin/diameter_mm", "no_sleeve", friction__sleeve=True),
    row("/pin/diameter_mm", "too_thick", pin__diameter_mm=16.001, include=["crankshaft"]),
    row("/pin/satellite_positions_mm", "different_length", pin__satellite_positions_mm=[15.0]),
    row("/pin/satellite_positions_mm/1", "in_carrier", pin__satellite_positions_mm=[31.0, 9.0]),
    row(
        "/pin/satellite_positions_mm/1",
        "too_near",
        pin__satellite_positions_mm=[15.0, 16.0],
        include=["cyclogram"],
    ),
    row(
        "/crankshaft/satellite_positions_mm",
        "different_length",
        crankshaft__satellite_positions_mm=[20.0],
    ),
    row(
        "/crankshaft/satellite_positions_mm/1",
        "too_near",
        pin=None,
        crankshaft__satellite_positions_mm=[31.0, 31.0],
    ),
    row(
        "/crankshaft/satellite_positions_mm/1",
        "other_pitch",
        crankshaft__satellite_positions_mm=[20.0, 45.0],
    ),
    row(
        "/crankshaft/bearings/1/name",
        "no_such_bearing",
        crankshaft__bearings=[{"name": "6205"}, {"name": "none"}],
    ),
    row("/bearing/reliability_percent", "not_in_table", bearing__reliability_percent=92),
    row(
        "/fatigue/reliability_percent",
        "not_in_table",
        fatigue=PERCENT | {"endurance_limit_MPa": None},
    ),
    row("/gear/module_mm", "of_another_kind", gear__kind="none"),
    row(
        "/mechanism/pins",
        "too_many_pairs",
        mechanism__pins=251,
        load__pin_circle_radius_mm=2000.0,
        include=["pin_strength"],
    ),
]

RINGS = [
    row("/contact/distribution_factor", "with_real_forces", contact__distribution_factor=1.5),
    row("/gear/disc_material", "discs_disagree", gear__disc_material="steel_structural"),
    row(
        "/gear/satellite_positions_mm/1",
        "too_near",
        gear=HELD | {"satellite_positions_mm": [20.0, 31.0]},
    ),
    row("/gear", "needed_beside", gear=None, deviations={"ring_pin_radial_mm": [0.001] * 20}),
    row("/gear", "needed_beside", gear=None, satellite_coupling={"kind": "ring"}),
]

MESHES = [
    row("/mechanism/ring_teeth", "not_this_cycloid", mechanism__ring_teeth=21),
    row("/gear/module_mm", "of_another_kind", gear__module_mm=2.5),
    row("/include/1", "of_another_kind", include=["ideal", "stresses"]),
    row("/gear/ring_pin_radius_mm", "undercut", gear__ring_pin_radius_mm=14.0),
    row("/gear/ring_pin_circle_radius_mm", "no_cycloid", contact__eccentricity_mm=3.0),
    row(
        "/gear/modification/pin_circle_mm", "less_than_equal", gear__modification__pin_circle_mm=0.6
    ),
    row("/gear/span_mm", "of_another_kind", gear__span_mm=40.0),
    row("/gear/span_mm", "needed_beside", gear__pin_support="fixed"),
    row(
        "/gear/satellite_positions_mm",
        "different_length",
        gear=HELD | {"satellite_positions_mm": [20.0]},
    ),
    row("/gear/sleeve_bore_radius_mm", "smaller_than", gear__sleeve_bore_radius_mm=5.0),
    row("/deviations/ring_pin_radial_mm", "different_length", deviations__ring_pin_radial_mm=[0.0]),
    row("/deviations/crank_phase_deg", "different_length", deviations__crank_phase_deg=[0.0]),
    row("/gear/contact_law/reference_depth_mm", "less_than_equal", gear__contact_law=DEEP),
    row("/gear/contact_law/reference_depth_mm", "greater_than_equal", gear__contact_law=SHALLOW),
    row(
        "/satellite_coupling/shares",
        "different_length",
        satellite_coupling={"kind": "shares", "shares": [1.0]},
    ),
    row(
        "/satellite_coupling/stiffness_Nm_per_arcmin",
        "needed_beside",
        satellite_coupling={"kind": "elastic"},
    ),
    row("/chord_error_mm", "greater_than_equal", include=["profile"], chord_error_mm=1e-10),
    row("/contact/eccentricity_mm", "missing", contact=None),
]

TEETH = [
    row("", "outside_method", mechanism__ring_teeth=49),
    row("/mechanism/ring_teeth", "larger_than", mechanism__ring_teeth=40),
    row("/contact/eccentricity_mm", "no_mesh", contact__eccentricity_mm=2.0),
    row("/gear/ring_pin_radius_mm", "of_another_kind", gear__ring_pin_radius_mm=5.0),
    row("/gear/modification", "of_another_kind", gear__modification={}),
    row("/gear/nothing", "extra_forbidden", gear__nothing=1.0),
    row("/gear/cutter_teeth", "less_than", gear__cutter_teeth=42),
    row("/gear/satellite_tip_radius_mm", "only_one", gear__satellite_tip_radius_mm=62.4),
    row(
        "/gear/dedendum",
        "less_than_equal",
        gear={"dedendum": 1.6, "reference_pressure_angle_deg": 30.0},
    ),
    row("/crank_angle_deg", "of_another_kind", crank_angle_deg=[0.0]),
    row("/geometry", "always_exact", geometry="exact"),
    row("/contact_law", "moved_to", contact_law={"kind": "hertz"}),
    row("/include/1", "of_another_kind", include=["stresses", "over_turn"]),
]

FORCES = [
    row("/contact/hole_radius_mm", "hole_disagrees", contact__hole_radius_mm=7.02),
    row("/contact/distribution_factor", "with_real_forces", contact__distribution_factor=1.2),
    row("/contact_law/stiffness_N_per_mm", "needed_beside", contact_law={"kind": "linear"}),
    row("/contact_law/exponent", "of_another_kind", contact_law={"exponent": 1.5}),
    row("/contact_law/exponent", "greater_than_equal", contact_law=POWER),
    row(
        "/contact_law/reference_depth_mm",
        "of_another_kind",
        contact_law={"kind": "conformal", "reference_depth_mm": 4},
    ),
    row("/deviations/pin_radius_mm", "different_length", deviations__pin_radius_mm=[0.0]),
    row(
        "/deviations/hole_radius_mm/1",
        "different_length",
        deviations__hole_radius_mm=[[0.0] * 6, [0.0] * 5],
    ),
    row("/deviations/disc_phase_deg", "different_length", deviations__disc_phase_deg=[0.0]),
    row(
        "/pin/span_mm", "needed_beside", pin={"support": "fixed", "satellite_positions_mm": [9, 23]}
    ),
    row(
        "/pin/satellite_positions_mm/1",
        "smaller_than",
        pin=BENT | {"satellite_positions_mm": [9, 40]},
    ),
    row("/pin/satellite_positions_mm/1", "smaller_than", pin=TIED | {"span_mm": 36.0}),
    row(
        "/pin/ring_joint",
        "of_another_kind",
        pin={"satellite_positions_mm": [15, 37], "ring_joint": "clamped"},
    ),
    row("/mechanism/pins", "too_many_pairs", pin=TIED, mechanism__pins=51, deviations=None),
    row(
        "/satellite_coupling/shares",
        "of_another_kind",
        satellite_coupling=ELASTIC | {"shares": [0.5, 0.5]},
    ),
    row(
        "/satellite_coupling/shares",
        "sum_not_one",
        satellite_coupling={"kind": "shares", "shares": [0.5, 0.4]},
    ),
    row(
        "/crank_support/radial_clearance_mm",
        "greater_than_equal",
        crank_support={"radial_clearance_mm": -0.01},
    ),
    row("/torques_Nm/1", "not_zero", torques_Nm=[1, 0], include=["stiffness_curve"]),
    row("/contact/hole_radius_mm", "no_mechanism", contact__hole_clearance_mm=14),
    row("", "no_room_in_hole", contact__hole_clearance_mm=-2),
    row("/contact/hole_radius_mm", "cannot_assemble", contact__hole_clearance_mm=-1),
    row("/deviations", "cannot_assemble", deviations__disc_phase_deg=[0, 5]),
    row("", "not_stable", contact_law={"kind": "linear", "stiffness_N_per_mm": 1}),
    row("/geometry", "always_exact", geometry="first_order"),
    row("", "beyond_hertz", load__output_torque_Nm=1e6),
]

SERIES = [
    row("", "outside_method", mechanism__ring_teeth=22, satellite_coupling={"kind": "ring"}),
    row("/mechanism/ring_teeth", "too_many_pairs", crank_angle_deg=[0.0] * 900),
    row(
        "/mechanism/ring_teeth",
        "too_many_pairs",
        mechanism__pins=100,
        load__pin_circle_radius_mm=300.0,
        include=["over_turn"],
    ),
]

KINDS = [
    row("/gear/kind", "outside_method", gear={"kind": "involute", "module_mm": 3.0}),
    row("/gear/kind", "outside_method", gear={"kind": "none"}),
]

STRENGTHS = [
    row("/pin/satellite_positions_mm/0", "in_carrier", pin__satellite_positions_mm=[9.0, 37.0]),
    row("/pin/satellite_positions_mm/1", "beyond_support", pin=SHORT),
    row("/pin/span_mm", "needed_for", include=["support_bounds"]),
    row(
        "/pin/satellite_positions_mm/1",
        "beyond_support",
        pin__span_mm=45.0,
        include=["support_bounds"],
    ),
    row("/pin/contact_length_mm", "needed", pin__contact_length_mm=None),
    row("/fatigue/surface_factor", "only_one", fatigue__surface_factor=0.9),
    row("/contact", "missing", contact_law={}),
    row("", "dead_centre", mechanism=LONE, pin__satellite_positions_mm=[15.0]),
    row("/mechanism/pins", "too_many_pairs", mechanism__pins=400),
]

LOSSES = [
    row("/friction/coefficient", "greater_than_equal", friction__coefficient=-0.1),
    row("/friction/coefficient", "dust", friction__coefficient=1e-13),
    row("/samples", "service_limit", mechanism__pins=5000, include=["curves"]),
]

LOADS = [
    row("/gear/teeth_difference", "needed_beside", gear={"kind": "involute", "module_mm": 3.5}),
    row(
        "/gear/teeth_difference",
        "teeth_disagree",
        mechanism={"ratio": None, "satellite_teeth": 40, "ring_teeth": 42},
        gear={"kind": "involute", "module_mm": 1.9, "teeth_difference": 1},
    ),
    row("/contact/pin_radius_mm", "missing", gear={"radial_force_ratio": 0.7}, deviations={}),
    row(
        "/contact/eccentricity_mm",
        "smaller_than",
        gear={"radial_force_ratio": 0.7},
        contact={
            "eccentricity_mm": 55.0,
            "hole_clearance_mm": 60.0,
            "pin_radius_mm": 8.0,
            "contact_length_mm": 20.0,
        },
    ),
]

SHAFTS = [
    row(
        "/crankshaft/bearing_positions_mm/1",
        "greater_than",
        crankshaft__bearing_positions_mm=[62.0, 0.0],
    ),
    row(
        "/crankshaft/satellite_positions_mm/1",
        "float_type",
        crankshaft__satellite_positions_mm=[20.0, "x"],
    ),
    row("/contact/pin_radius_mm", "needed_beside", contact__hole_clearance_mm=0.1),
    row(
        "/crankshaft/satellite_mass_kg",
        "needed_beside",
        crankshaft__counterweights=[WEIGHT],
        crankshaft__satellite_mass_kg=None,
    ),
    row(
        "/crankshaft/counterweights/0/unbalance_kg_mm",
        "greater_than_equal",
        crankshaft__counterweights=[WEIGHT | {"unbalance_kg_mm": -3.0}],
    ),
    row(
        "/crankshaft/counterweights/0/position_mm",
        "missing",
        crankshaft__counterweights=[{"unbalance_kg_mm": 3.0}],
    ),
    row("/crankshaft/counterweights", "too_long", crankshaft__counterweights=[WEIGHT] * 21),
    row("/crankshaft/rotor_mass_kg", "greater_than_equal", crankshaft__rotor_mass_kg=0),
]

FITS = [
    row("/contact/fit", "no_fit", contact__fit="H7"),
    row("/contact/fit", "no_fit", contact__fit="f7/H7"),
    row("/contact/hole_radius_mm", "only_one", contact__hole_radius_mm=10.0),
    row("/contact/hole_clearance_mm", "only_one", contact__hole_clearance_mm=0.0),
    row("/contact/fit", "no_class_of_size", contact__pin_radius_mm=300.0),
]

SHARES = [
    row("/contact/distribution_factor", "more_than_whole", contact__distribution_factor=2.1),
    row(
        "/contact/distribution_factor",
        "more_than_whole",
        mechanism__satellites=1,
        contact={"distribution_factor": 2, "distribution_of": "discs"},
    ),
    row("/contact/distribution_factor", "greater_than_equal", contact__distribution_factor=0.9),
]

TOLERANCES = [
    row("/tolerances/pin_diameter/class", "no_class", pin_diameter={"class": "H7"}),
    row("/tolerances/hole_diameter/class", "no_class", hole_diameter={"class": "h7"}),
    row("/tolerances/hole_diameter/class", "no_class", hole_diameter={"class": "H4"}),
    row("/tolerances/hole_diameter/class", "needed", hole_diameter={}),
    row("/tolerances/hole_diameter/lower_mm", "needed_beside", hole_diameter={"upper_mm": 1}),
    row("/tolerances/hole_diameter/upper_mm", "needed_beside", hole_diameter={"lower_mm": 0}),
    row(
        "/tolerances/pin_diameter/lower_mm", "only_one", pin_diameter={"class": "m6", "lower_mm": 0}
    ),
    row(
        "/tolerances/pin_diameter/lower_mm",
        "at_most",
        pin_diameter={"lower_mm": 0.01, "upper_mm": 0},
    ),
    row(
        "/tolerances/disc_phase_deg/lower_deg",
        "at_most",
        disc_phase_deg={"lower_deg": 1, "upper_deg": 0},
    ),
    row("/tolerances/crank_phase_deg/upper_deg", "missing", crank_phase_deg={"lower_deg": 0}),
    row("/tolerances/crank_phase_deg", "greater_than_equal", crank_phase_deg=-1),
    row("/tolerances/pin_position_mm", "greater_than_equal", pin_position_mm=-0.01),
    row("/tolerances/ring_pin_position_mm", "of_another_kind", ring_pin_position_mm=0.01),
    row("/tolerances/ring_pin_diameter", "of_another_kind", ring_pin_diameter={"class": "h6"}),
    row("/tolerances/equidistant_mm", "of_another_kind", equidistant_mm=0.01),
]

RING_TOLERANCES = [
    row(
        "/tolerances/equidistant_mm/common",
        "extra_forbidden",
        equidistant_mm={"lower_mm": 0, "upper_mm": 0.01, "common": True},
    ),
    row(
        "/tolerances/equidistant_mm/lower_mm",
        "at_most",
        equidistant_mm={"lower_mm": 0.02, "upper_mm": 0.01},
    ),
    row(
        "/tolerances/equidistant_mm", "greater_than", equidistant_mm={"lower_mm": -6, "upper_mm": 0}
    ),
    row("/gear/ring_pin_radius_mm", "undercut", equidistant_mm={"lower_mm": 0, "upper_mm": 40}),
]

RING_STUDIES = [
    row(
        "/quantities/0",
        "of_another_kind",
        gear=None,
        tolerances={"pin_position_mm": 0.01, "ring_pin_position_mm": None},
    ),
    row(
        "/limits/ring_max_pressure_MPa",
        "of_another_kind",
        gear=None,
        tolerances={"pin_position_mm": 0.01, "ring_pin_position_mm": None},
        quantities=["peak_force_N"],
        limits={"ring_max_pressure_MPa": 900},
    ),
    row(
        "/tolerances/ring_pin_position_mm", "of_another_kind", satellite_coupling={"kind": "rigid"}
    ),
    row("/samples", "service_limit", samples=100_000),
]

REFUSED = {
    "numbers": ("contact-force", REQUESTS["contact-force"], NUMBERS),
    "sections": ("crank-planetary", WHOLE, SECTIONS),
    "ring": ("crank-planetary", RING, RINGS),
    "meshes": ("ring-mesh", REQUESTS["ring-mesh"], MESHES),
    "teeth": ("ring-mesh", ROUND, TEETH),
    "forces": ("load-sharing", REQUESTS["load-sharing"], FORCES),
    "no ring": (
        "ring-mesh",
        REQUESTS["ring-mesh"],
        [row("/gear/kind", "literal_error", gear=NONE | {"kind": "none"})],
    ),
    "series": ("load-sharing", RING | {"include": ["positions"]}, SERIES),
    "kinds": (
        "load-sharing",
        changed(RING, gear=None, include=None, satellite_coupling={"kind": "ring"}),
        KINDS,
    ),
    "strength": ("pin-strength", REQUESTS["pin-strength"], STRENGTHS),
    "losses": ("output-efficiency", REQUESTS["output-efficiency"], LOSSES),
    "loads": ("satellite-bearing", changed(REQUESTS["satellite-bearing"], gear=None), LOADS),
    "shafts": ("crankshaft", REQUESTS["crankshaft"], SHAFTS),
    "fits": ("crank-planetary", FITTED, FITS),
    "shares": ("crank-planetary", STATED, SHARES),
    "tolerances": ("tolerance-study", STUDY, [*of_study(TOLERANCES)]),
    "tolerances of a ring": ("tolerance-study", RING_STUDY, [*of_study(RING_TOLERANCES)]),
    "studies": ("tolerance-study", RING_STUDY, RING_STUDIES),
}


@pytest.mark.parametrize(
    ("path", "body", "pointer", "code"),
    [
        pytest.param(path, changed(body, **changes), pointer, code, id=f"{name} {pointer} {code}")
        for name, (path, body, rows) in REFUSED.items()
        for pointer, code, changes in rows
    ],
)
async def test_what_is_refused_is_named(api, path, body, pointer, code):
    response = await api.post(path, json=body)
    problem = response.json()
    assert response.status_code == 422, problem
    assert response.headers["content-type"] == "application/problem+json"
    assert {"type", "title", "status", "detail", "errors"} <= {*problem}
    assert [(each["pointer"], each["code"]) for each in problem["errors"]] == [(pointer, code)]
