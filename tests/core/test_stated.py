"""Design of what a document states: what follows from it, and what contradicts itself."""

import math
from typing import Any

import pytest

from core.design.stated import design_of
from core.errors import InvalidInput
from core.material_table import MATERIALS
from core.output.elasticity import RingInSeries

STATED: dict[str, Any] = {
    "mechanism": {"pins": 6, "satellite_teeth": 29, "ring_teeth": 30},
    "load": {"input_torque": 5.0, "efficiency": 0.9, "pin_circle_radius": 0.034},
    "contact": {"pin_radius": 0.006, "contact_length": 0.0135, "eccentricity": 0.00125},
    "pin": {"contact_length": 0.0135},
    "gear": {"kind": "cycloid", "ring_pin_circle_radius": 0.0525, "ring_pin_radius": 0.0035},
    "bearing": {"name": "6805-2RS"},
}
"""Document of a drive without materials, torque of the output, diameter of the pins."""


def test_what_is_not_stated_follows_or_is_usual() -> None:
    design = design_of(STATED)
    assert (design.mechanism.ratio, design.mechanism.satellites) == (29, 2)
    assert design.load.output_torque == pytest.approx(5 * 29 * 0.9)
    assert (design.pin.diameter, design.pin.steel) == (0.012, True)
    assert design.pin.tensile_strength == MATERIALS["steel_bearing"].strength.tensile
    assert design.gear.of_ring.youngs_modulus == MATERIALS["steel_bearing"].material.youngs_modulus
    assert (design.bearing.bore_diameter, design.bearing.kind) == (0.025, "ball")
    assert design.gear.teeth_difference == 1
    assert isinstance(design.satellite_coupling, RingInSeries)


def test_sections_that_are_not_used_supply_what_follows_from_them() -> None:
    design = design_of(STATED, used=("mechanism", "pin"), pin_alone=True)
    assert design.pin.diameter == 0.012 and not design.contact
    assert not design_of(STATED, used=("mechanism", "pin")).pin


def test_a_coupling_has_one_disc_and_no_ratio() -> None:
    made = design_of({"mechanism": {"output": "coupling"}}).mechanism
    assert (made.satellites, made.ratio) == (1, math.inf)


@pytest.mark.parametrize(
    ("section", "values", "parameter", "code"),
    [
        ("mechanism", {"ring_teeth": 60}, "mechanism.ring_teeth", "ratio_of_teeth"),
        ("mechanism", {"crank_angles": (0.0,), "satellites": 2}, "mechanism.crank_angles",
         "different_length"),
        ("mechanism", {"output": "both"}, "load.ring_speed", "needed_beside"),
        ("mechanism", {"output": "coupling"}, "gear", "of_other_output"),
        ("load", {"ring_speed": 1.0}, "load.ring_speed", "of_other_output"),
        ("gear", {"disc_material": "steel_bearing"}, "gear.disc_material", "discs_disagree"),
        ("gear", {"span": 0.03}, "gear.span", "of_another_kind"),
        ("gear", {"pin_support": "fixed"}, "gear.span", "needed_beside"),
        ("bearing", {"name": "none"}, "bearing.name", "no_such_bearing"),
        ("rollers", {"name": "686", "friction_coefficient": 0.01}, "friction.coefficient",
         "only_one"),
    ],
)  # fmt: skip
def test_contradictions_are_refused(
    section: str, values: dict[str, Any], parameter: str, code: str
) -> None:
    driven = STATED["load"] | {"input_speed": 60.0}
    stated = STATED | {"load": driven, "friction": {"coefficient": 0.05}}
    stated |= {section: stated.get(section, {}) | values}
    with pytest.raises(InvalidInput) as refused:
        design_of(stated)
    assert (refused.value.parameter, refused.value.code) == (parameter, code)


@pytest.mark.parametrize(
    ("changes", "parameter", "code"),
    [
        ({"contact": {}, "rollers": {"name": "686"}}, "contact.pin_radius", "needed_beside"),
        ({"deviations": {"pin_radial": (0.0,)}}, "deviations.pin_radial", "different_length"),
        ({"deviations": {"hole_radius": ((0.0,) * 6, (0.0,))}}, "deviations.hole_radius[1]",
         "different_length"),
        ({"deviations": {"ring_pin_radius": (0.0,)}}, "deviations.ring_pin_radius",
         "different_length"),
        ({"satellite_coupling": {"kind": "shares", "shares": (1.0,)}},
         "satellite_coupling.shares", "different_length"),
        ({"contact": STATED["contact"] | {"fit": "f7/H7"}}, "contact.fit", "no_fit"),
    ],
)  # fmt: skip
def test_what_parts_of_a_document_lack_is_named(
    changes: dict[str, Any], parameter: str, code: str
) -> None:
    with pytest.raises(InvalidInput) as refused:
        design_of(STATED | changes)
    assert (refused.value.parameter, refused.value.code) == (parameter, code)


def test_a_section_that_is_not_used_is_checked_by_itself() -> None:
    with pytest.raises(InvalidInput, match="none of the bearings by name"):
        design_of(STATED | {"bearing": {"name": "none"}}, used=("mechanism",))
