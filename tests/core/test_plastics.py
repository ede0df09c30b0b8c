"""Plastic pins and holes: they fail by what is known, and pass by nothing."""

import math
from dataclasses import replace
from random import Random
from typing import Any

import pytest

from core.checks.cold_yield import cold_yield
from core.checks.contacts import PLASTICS
from core.checks.crank_planetary import crank_check
from core.checks.reserve import crank_verdict
from core.design.document import Design
from core.design.results import Results
from core.design.ring import CycloidRing
from core.design.sections import DesignPin, Friction, SatelliteBody, Temperatures
from core.errors import InvalidInput, if_known
from core.hertz import ContactLimit, ElasticMaterial, hertz
from core.material_table import ALIASES, ELASTOMERS, MATERIALS, NAMES, SEVERAL, plain_name
from core.materials import by_values
from core.precision import EXACT, SAME
from core.ring.profile import Modification
from tests.inputs.checks import REF, check_of, fixes_of, having
from tests.oracles.seeds import seeds

STEEL = MATERIALS["steel_bearing"].material
NAMED = MATERIALS["plastic_pla_printed"].material
PLA = by_values(base=MATERIALS["plastic_pla_printed"], youngs_modulus=3.6e9, yield_strength=23e6)
SOFT = having(
    REF,
    pin_material=STEEL,
    hole_material=PLA,
    output_torque=20.0,
    friction=Friction(coefficient=0.76),
)
"""A disc of printed PLA on pins of steel, all of it given, whose forces are the ideal ones."""

HELD = [
    # modulus, Poisson's ratio, strength, f; pressure, MPa, force, N, half-width, mm
    (3.64, 0.36, 23, 42.7, 134, 0.25),
    (2.5, 0.38, 44, 82.5, 712, 0.69),
    (1.8, 0.43, 43, 82.0, 926, 0.90),
    (7.5, 0.35, 90, 166, 1013, 0.49),
    (2.66, 0.363, 61, 113.5, 1285, 0.90),
]
"""Steel pin d 6 in a hole d 8, 8 wide, without friction: when a plastic hole yields. By hand."""


@pytest.mark.parametrize(("modulus", "ratio", "strength", "pressure", "force", "width"), HELD)
def test_a_plastic_hole_yields_at_the_pressure_calculated_by_hand(
    modulus: float, ratio: float, strength: float, pressure: float, force: float, width: float
) -> None:
    hole = by_values(
        youngs_modulus=modulus * 1e9, poissons_ratio=ratio, yield_strength=strength * 1e6
    )
    design = having(
        REF,
        pin_material=ElasticMaterial(210e9, 0.3),
        hole_material=hole,
        pin_radius=0.003,
        hole_radius=0.004,
        eccentricity=0.001,
        contact_length=0.008,
        friction=Friction(coefficient=0.0),
        output_torque=1e-6,
    )
    results = Results(design)
    narrow = results.cold_limit("hole", results.static_contact)
    assert narrow / 1e6 == pytest.approx(pressure, rel=3e-3)
    pressed = hertz(
        **design.nominal_pair._asdict(),
        force=force,
        pin_material=design.contact.pin_material,  # type: ignore[arg-type]
        hole_material=hole,
    )
    assert float(pressed.max_pressure) / 1e6 == pytest.approx(pressure, rel=5e-3)
    assert float(pressed.half_width) * 1e3 == pytest.approx(width, rel=0.02)


def test_dry_friction_takes_three_quarters_of_the_force() -> None:
    """PLA at a friction of 0.6: 21.1 MPa instead of 42.7, and 33 N instead of 134."""
    hole = by_values(youngs_modulus=3.64e9, poissons_ratio=0.36, yield_strength=23e6)
    dry = having(REF, hole_material=hole, friction=Friction(coefficient=0.6), output_torque=1e-6)
    results = Results(dry)
    limit = results.cold_limit("hole", results.static_contact) / 1e6
    assert limit == pytest.approx(21.1, abs=0.05)
    assert (limit / 42.7) ** 2 * 134 == pytest.approx(33, abs=0.5)


@pytest.mark.parametrize(("angle", "factor"), [(12, 1.65), (20, 1.59), (30, 1.52), (40, 1.41)])
def test_a_hole_that_wraps_around_its_pin_yields_under_less(angle: float, factor: float) -> None:
    """Reference: finite elements of pin and hole, Poisson's ratio 0.36, without friction."""
    hole = by_values(youngs_modulus=3e9, poissons_ratio=0.36, yield_strength=23e6)
    soft = having(SOFT, hole_material=hole, friction=Friction(coefficient=0.0))
    wrapped = {"conformal_pressure": 1.0, "conformal_half_length": 1.0}
    contact = Results(soft).static_contact._replace(
        conformal_half_angle=math.radians(angle), **wrapped
    )
    assert Results(soft).cold_limit("hole", contact) / 23e6 == pytest.approx(factor, abs=0.012)
    dry = having(soft, friction=Friction(coefficient=0.6))
    assert Results(dry).cold_limit("hole", contact) / 23e6 == pytest.approx(0.918, abs=2e-3)


def test_what_is_necessary_fails_or_stays_open() -> None:
    cold = check_of("contact_static_cold", SOFT)
    assert cold.status == "not_checked" and cold.reason == "necessary_only" and cold.opens
    results = Results(SOFT)
    expected = results.cold_limit("hole", results.static_contact)
    assert cold.limit == pytest.approx(expected, rel=SAME)
    assert cold.value is not None and cold.utilisation == pytest.approx(cold.value / cold.limit)  # type: ignore[operator]
    reserve = cold.torque_reserve
    assert reserve is not None
    at_limit = check_of("contact_static_cold", having(SOFT, output_torque=20.0 * reserve))
    assert at_limit.utilisation == pytest.approx(1, rel=EXACT)
    beyond = check_of("contact_static_cold", having(SOFT, output_torque=20.2 * reserve))
    assert beyond.status == "fail" and beyond.torque_reserve == pytest.approx(1 / 1.01, rel=EXACT)
    at_peak = having(SOFT, peak_torque=40.4 * reserve)
    assert check_of("contact_static_cold", at_peak).status == "fail"


def test_a_plastic_has_no_shakedown_and_no_pitting() -> None:
    for name in ("contact_shakedown_hole", "contact_yield_hole"):
        assert check_of(name, SOFT).reason == "plastic_rules"
        assert check_of(name, SOFT).status == "not_applicable"
    assert check_of("contact_static_hole", having(SOFT, peak_torque=40.0)).reason == "plastic_rules"
    assert check_of("contact_pressure_hole", SOFT).reason == "plastic_limit_unknown"


def test_a_limit_of_an_own_test_passes_its_criterion_and_no_other() -> None:
    own = by_values(
        base=MATERIALS["plastic_pla_printed"], limit=ContactLimit("given", 100e6), layers="flat"
    )
    design = having(SOFT, hole_material=own)
    assert check_of("contact_pressure_hole", design).status == "pass"
    found = crank_verdict(Results(design))
    assert {part.code: part.status for part in found.parts}["contact"] == "open"
    assert [each.code for each in found.checks if each.code == "temperature" and each.opens]


@pytest.mark.parametrize(
    ("material", "body", "layers", "known"),
    [
        ("plastic_pla_printed", "hole", None, 23e6),
        ("plastic_pla_printed", "hole", "upright", None),
        ("plastic_pla_printed", "pin", None, None),
        ("plastic_pla_printed", "pin", "flat", 23e6),
        ("plastic_pa12_sintered", "pin", None, 43e6),
        ("plastic_pom", "pin", None, 61e6),
        ("plastic_peek", "hole", None, 97e6),
        ("plastic_pc_printed", "hole", None, None),
    ],
)
def test_the_strength_is_that_of_the_direction_that_is_loaded(
    material: str, body: Any, layers: Any, known: float | None
) -> None:
    made = by_values(base=MATERIALS[material], layers=layers)
    assert made.loaded_strength(body) == known
    design = having(SOFT, friction=Friction(coefficient=0.3), **{f"{body}_material": made})
    if body == "pin":
        design = having(design, hole_material=STEEL)
    check = check_of("contact_static_cold", design)
    if known is None:
        assert check.reason in ("direction_unknown", "yield_unknown") and not check.only_needed
    else:
        assert check.limit is not None and check.limit > 0


def test_a_typed_strength_holds_in_the_direction_that_is_said() -> None:
    values: Any = {"youngs_modulus": 2.1e9, "poissons_ratio": 0.38, "tensile_strength": 25e6}
    assert by_values(**values, layers="upright").loaded_strength("pin") == 25e6
    assert (
        by_values(**values, layers="upright", yield_strength=20e6).loaded_strength("hole") == 20e6
    )
    assert by_values(**values).loaded_strength("pin") is None
    stiff = by_values(youngs_modulus=210e9, poissons_ratio=0.3, tensile_strength=900e6)
    assert stiff.plastic is None and stiff.yield_strength is None


def test_friction_that_is_not_known_fails_only_what_fails_without() -> None:
    quiet = by_values(youngs_modulus=2.1e9, poissons_ratio=0.38, yield_strength=44e6)
    design = having(SOFT, hole_material=quiet, friction=None)
    check = check_of("contact_static_cold", design)
    assert (check.status, check.reason) == ("not_checked", "friction_unknown")
    assert check.missing == ("friction.coefficient",)
    judged = crank_verdict(Results(design))
    assert if_known(lambda: cold_yield(results=Results(design), found=judged)) is None
    weak = having(design, hole_material=replace(quiet, yield_strength=1e6))
    assert check_of("contact_static_cold", weak).status == "fail"
    named = having(SOFT, hole_material=NAMED, friction=None)
    assert named.hole_friction == (0.2, 0.15, 0.35) and SOFT.hole_friction.high == 0.76
    sleeved = having(design, friction=Friction(coefficient=0.2, sleeve=True))
    assert sleeved.hole_friction.high == 0.0


def test_temperature_creep_and_solid_depth() -> None:
    def at(**values: Any) -> Design:
        return having(SOFT, **values)

    assert check_of("temperature", SOFT).reason == "temperature_unknown"
    warm = check_of("temperature", at(temperatures=Temperatures(satellite=50.0)))
    assert warm.reason == "necessary_only" and warm.limit == 51.0
    assert check_of("temperature", at(temperatures=Temperatures(satellite=55.0))).status == "fail"
    other = at(
        temperatures=Temperatures(satellite=50.0), hole_material=MATERIALS["plastic_pom"].material
    )
    assert check_of("temperature", other).reason == "softening_unknown"
    assert check_of("creep", SOFT).reason == "creep_unknown"
    half = by_values(
        base=MATERIALS["plastic_pla_printed"],
        youngs_modulus=3.6e9,
        yield_strength=23e6,
        long_term_factor=0.5,
    )
    lasting = at(hole_material=half)
    cold, creep = check_of("contact_static_cold", lasting), check_of("creep", lasting)
    assert creep.limit == pytest.approx(cold.limit / 2, rel=SAME)  # type: ignore[operator]
    assert creep.torque_reserve == pytest.approx(cold.torque_reserve / 4, rel=EXACT)  # type: ignore[operator]
    width = float(Results(SOFT).hertz.half_width)
    assert check_of("contact_solid_depth", SOFT).reason == "solid_wall_unknown"
    for wall, reason in ((3.01 * width, "necessary_only"), (2.99 * width, "")):
        body = at(satellite_body=SatelliteBody(solid_wall=wall))
        assert check_of("contact_solid_depth", body).reason == reason
    solid = at(hole_material=MATERIALS["plastic_pom"].material)
    assert check_of("contact_solid_depth", solid).reason == "not_printed"


def test_a_plastic_pin_is_bent_across_its_layers() -> None:
    pin = DesignPin(
        support="cantilever",
        diameter=0.016,
        satellite_positions=(0.015, 0.037),
        material=PLA,
    )
    assert check_of("pin_static", having(SOFT, pin=pin)).reason == "direction_unknown"
    across = by_values(base=MATERIALS["plastic_pla_printed"], yield_strength=12e6, layers="upright")
    bent = check_of(
        "pin_static", having(SOFT, output_torque=0.1, pin=replace(pin, material=across))
    )
    assert bent.reason == "necessary_only" and bent.limit == pytest.approx(12e6 / 1.5)
    broken = having(SOFT, output_torque=40.0, pin=replace(pin, material=across))
    assert check_of("pin_static", broken).status == "fail"


def test_cold_yield_is_the_torque_at_which_the_check_fails() -> None:
    for design in (SOFT, having(SOFT, hole_radius=0.0102)):
        results = Results(design)
        cold = cold_yield(results=results, found=crank_verdict(results))
        assert cold is not None and cold.quarter == cold.torque / 4
        assert (cold.strength, cold.friction, cold.body) == (23e6, 0.76, "hole")
        assert cold.open == (
            "contact_solid_depth",
            "temperature",
            "creep",
            "fatigue_plastic",
            "wear",
        )
        near = check_of("contact_static_cold", having(design, output_torque=cold.torque))
        assert near.utilisation == pytest.approx(1, rel=1e-3)
    misfit = having(SOFT, hole_radius=0.0095)
    assert cold_yield(results=Results(misfit), found=crank_verdict(Results(misfit))) is None
    steel = having(SOFT, hole_material=STEEL)
    assert cold_yield(results=Results(steel), found=crank_verdict(Results(steel))) is None


def test_a_plastic_has_no_largest_torque() -> None:
    found = crank_verdict(Results(SOFT))
    assert found.verdict == "incomplete" and not found.largest_torque_known
    cold = found["contact_static_cold"]
    assert found.torque_reserve == cold.torque_reserve


def test_a_fix_cures_what_fails_at_once() -> None:
    design = having(SOFT, output_torque=200.0)
    assert check_of("contact_static_cold", design).status == "fail"
    fixes = fixes_of(design, ["contact_static_cold"])
    assert any(fix.status == "solved" for fix in fixes)
    assert all(fix.verdict != "pass" for fix in fixes)


def test_a_fix_leaves_a_reducer_that_can_be_made() -> None:
    """Discs of 46 mm in a ring of 41.5, pins in holes that overlap, or on a circle beyond the ring
    would cure it too.
    """
    design = having(
        SOFT,
        ratio=11.0,
        pin_circle_radius=0.02605,
        pin_radius=0.0045,
        hole_radius=0.006525,
        eccentricity=0.002025,
        contact_length=0.01,
        output_torque=60.0,
        satellite_body=SatelliteBody(bore_radius=0.016),
        gear=CycloidRing(ring_pin_circle_radius=0.0415, ring_pin_radius=0.0045),
        friction=Friction(coefficient=0.2),
    )
    found = {fix.variable: fix for fix in fixes_of(design, ["contact_static_cold"])}
    assert found.keys() == {"load.output_torque", "mechanism.satellites"}
    less = having(design, output_torque=30.0)
    longer = {fix.variable: fix for fix in fixes_of(less, ["contact_static_cold"])}
    assert longer["contact.contact_length"].status == "solved"


def test_deflections_are_those_of_the_softest_material() -> None:
    design = having(SOFT, max_lost_motion=1.0, hole_radius=0.0102, hole_material=NAMED)
    soft = having(design, hole_material=replace(NAMED, youngs_modulus=1.6e9, least_modulus=None))
    lost, softer = check_of("lost_motion", design), check_of("lost_motion", soft)
    assert lost.value == softer.value
    stiff = having(design, hole_material=replace(NAMED, least_modulus=None))
    assert lost.value > check_of("lost_motion", stiff).value  # type: ignore[operator]
    assert Results(having(SOFT, hole_material=STEEL)).softest.design.contact.hole_material == STEEL


def random_design(random: Random) -> Design:
    """A drive with a plastic hole, pin or both, and much or little that is known of it."""
    names = [name for name, each in MATERIALS.items() if each.group.startswith("plastic")]
    known = [name for name in names if not MATERIALS[name].missing]

    def plastic() -> ElasticMaterial:
        own: dict[str, Any] = {}
        if random.random() < 0.5:
            own["yield_strength"] = random.uniform(5e6, 100e6)
            own["layers"] = random.choice(["flat", "upright", None])
        if random.random() < 0.3:
            own["long_term_factor"] = random.uniform(0.1, 1)
        if random.random() < 0.5:
            return by_values(base=MATERIALS[random.choice(known)], **own)
        ratio = random.uniform(0.3, 0.45)
        return by_values(youngs_modulus=random.uniform(1e9, 15e9), poissons_ratio=ratio, **own)

    bodies = random.choice([("hole",), ("pin",), ("pin", "hole")])
    pin, gap = random.uniform(1e-3, 8e-3), random.uniform(3e-4, 3e-3)
    loose = random.choice([0.0, 1e-4])
    return having(
        REF,
        pins=random.randint(4, 8),
        satellites=random.randint(1, 2),
        output_torque=10 ** random.uniform(-2, 2),
        pin_circle_radius=random.uniform(0.02, 0.06),
        contact_length=random.uniform(3e-3, 2e-2),
        pin_radius=pin,
        eccentricity=gap,
        hole_radius=pin + gap + loose,
        pin_material=plastic() if "pin" in bodies else STEEL,
        hole_material=plastic() if "hole" in bodies else STEEL,
        friction=random.choice([None, Friction(coefficient=random.uniform(0, 1))]),
        temperatures=random.choice([None, Temperatures(satellite=random.uniform(20, 100))]),
        satellite_body=SatelliteBody(solid_wall=random.choice([None, random.uniform(1e-4, 5e-3)])),
        peak_torque=random.choice([None, 200.0]),
    )


@pytest.mark.parametrize("seed", seeds(20))
def test_no_check_of_a_plastic_contact_passes(seed: int) -> None:
    design = random_design(Random(seed))
    found = crank_verdict(Results(design))
    of_plastic = {kind.code for kind in PLASTICS}
    for body in design.plastics:
        of_plastic |= {
            f"contact_{name}_{body}" for name in ("pressure", "static", "yield", "shakedown")
        }
    judged = {each.code: each.status for each in found.checks if each.code in of_plastic}
    assert judged and not {
        code for code, status in judged.items() if status in ("pass", "marginal")
    }
    assert found.verdict in ("incomplete", "fail") and not found.largest_torque_known
    contact = next(part for part in found.parts if part.code == "contact")
    assert contact.status in ("open", "fail")


def test_names_are_found_whatever_their_case() -> None:
    assert {NAMES[plain_name(each)] for each in ("4140", "GCr15", "SUJ2", "52100", "Onyx")} == {
        "steel_through_hardened",
        "steel_bearing",
        "plastic_pa_cf_printed",
    }
    assert NAMES[plain_name("6061 t6")] == "aluminium_6061_t6" and {*ALIASES} <= {*MATERIALS}
    assert len(NAMES) == len(MATERIALS) + sum(map(len, ALIASES.values()))
    vague = {plain_name(each) for each in (*SEVERAL, *ELASTOMERS)}
    assert not vague & {*NAMES} and {name for each in SEVERAL.values() for name in each} <= {
        *MATERIALS
    }


def test_what_no_source_has_is_asked_for() -> None:
    with pytest.raises(InvalidInput) as refusal:
        MATERIALS["plastic_petg_printed"].material  # noqa: B018
    assert (refusal.value.parameter, refusal.value.code) == ("poissons_ratio", "not_sourced")
    given = MATERIALS["plastic_petg_printed"].having(poissons_ratio=0.38)
    assert (given.youngs_modulus, given.least_modulus) == (3.0e9, 2.0e9)
    assert given.yield_strength is None  # of one source only: for reference
    own = MATERIALS["bronze_c93200"].having(youngs_modulus=100e9, poissons_ratio=0.34)
    assert own.yield_strength == 138e6 and own.plastic is None


@pytest.mark.parametrize(
    ("name", "strength", "first", "shakedown"),
    [
        ("aluminium_6061_t6", 241, 441, 557),
        ("aluminium_6082_t6", 250, 457, 578),
        ("aluminium_7075_t6", 430, 786, 993),
    ],
)
def test_aluminium_is_judged_by_its_least_yield_strength(
    name: str, strength: float, first: float, shakedown: float
) -> None:
    """First yield, shakedown without friction, and that at 0.1: 2.06 times."""
    none = Friction(coefficient=0.0)
    design = having(REF, pin_material=STEEL, hole_material=MATERIALS[name].material, friction=none)
    assert design.contact.hole_material.yield_strength == strength * 1e6  # type: ignore[union-attr]
    limits = Results(design).pressure_limits
    assert limits["contact_yield_hole"] / 1e6 == pytest.approx(first, abs=0.7)
    assert limits["contact_shakedown_hole"] / 1e6 == pytest.approx(shakedown, abs=0.7)
    sliding = Results(having(design, friction=Friction(coefficient=0.1))).pressure_limits
    assert sliding["contact_shakedown_hole"] == pytest.approx(2.06 * strength * 1e6, rel=SAME)
    dry = Results(having(design, friction=Friction(coefficient=0.5))).pressure_limits
    assert dry["contact_yield_hole"] / strength / 1e6 == pytest.approx(1.057, abs=6e-4)


def test_with_much_friction_shakedown_is_known_at_its_ends_only() -> None:
    aluminium = MATERIALS["aluminium_7075_t6"].material
    dry = having(
        REF, pin_material=STEEL, hole_material=aluminium, friction=Friction(coefficient=0.3)
    )
    pressure = check_of("contact_shakedown_hole", dry).value
    assert pressure is not None
    for aim, status, reason in (
        (1.5, "pass", ""),
        (1.65, "marginal", "shakedown_unknown"),
        (2.0, "marginal", "shakedown_unknown"),
        (2.1, "fail", ""),
    ):
        torque = 500.0 * (aim * 430e6 / pressure) ** 2
        check = check_of("contact_shakedown_hole", having(dry, output_torque=torque))
        assert (check.status, check.reason) == (status, reason), aim
        assert check.limit == pytest.approx(2.06 * 430e6) and math.isfinite(
            check.torque_reserve or 0
        )
    says_so = crank_verdict(Results(having(dry, output_torque=500.0 * (2 * 430e6 / pressure) ** 2)))
    assert says_so["contact_shakedown_hole"].status == "marginal"


@pytest.mark.parametrize(
    ("friction", "changes", "part", "factor"),
    [
        (0.0, {}, "teeth", 1.858),  # f of the table in the theory, v 0.36
        (0.3, {}, "teeth", 1.626),
        (0.3, {"peak_torque": 40.0}, "teeth", 1.626),
        (0.0, {"hole_radius": 0.0102}, "contact", None),
    ],
)
def test_plastic_teeth_may_yield_before_the_holes(
    friction: float | None, changes: dict[str, float], part: str, factor: float | None
) -> None:
    teeth = CycloidRing(
        ring_pin_circle_radius=0.12,
        ring_pin_radius=0.005,
        modification=Modification(equidistant=6e-5),
        friction_coefficient=friction,
        disc_material=PLA,
        pin_material=STEEL,
    )
    design = having(SOFT, gear=teeth, **changes)
    results = Results(design)
    cold = cold_yield(results=results, found=crank_verdict(results))
    assert cold is not None and cold.part == part
    assert "ring_pressure_disc" in cold.open
    unmade = Results(
        having(design, gear=replace(teeth, modification=None))
    )  # its teeth may be worse
    assert cold_yield(results=unmade, found=crank_verdict(unmade)) is None
    times = cold.torque / 20.0
    near = having(design, output_torque=cold.torque)
    if "peak_torque" in changes:
        near = having(near, peak_torque=40.0 * times)
    pressure = Results(near).ring.static.max_pressure
    if factor is None:
        assert check_of("contact_static_cold", near).utilisation == pytest.approx(1, rel=1e-3)
        assert pressure < 1.858 * 23e6
    else:
        assert (cold.friction, cold.strength) == (friction or 0.0, 23e6)
        assert pressure == pytest.approx(factor * 23e6, rel=5e-4)
        below, above = (
            crank_check("ring_static_cold", Results(near).under(each)) for each in (0.99, 1.01)
        )
        assert below.only_needed and above.status == "fail"


def test_of_two_plastics_the_weaker_one_and_the_hotter_one_are_judged() -> None:
    pom = replace(MATERIALS["plastic_pom"].material, plastic=replace(PLA.plastic, layered=False))  # type: ignore[type-var]
    both = having(SOFT, pin_material=pom, friction=Friction(coefficient=0.3))
    results = Results(both)
    contact = results.static_contact
    weaker = results.cold_limit("hole", contact)
    assert weaker < results.cold_limit("pin", contact)
    assert check_of("contact_static_cold", both).limit == weaker
    cold = cold_yield(results=results, found=crank_verdict(results))
    assert cold is not None and (cold.body, cold.strength) == ("hole", 23e6)
    printed = Results(having(both, pin_material=NAMED))  # across layers: not known
    found = crank_verdict(printed)
    assert found["contact_static_cold"].reason == "direction_unknown"
    assert found.torque_reserve is None and cold_yield(results=printed, found=found) is None
    hot = having(both, temperatures=Temperatures(satellite=40.0, pins=60.0))
    assert check_of("temperature", hot).status == "fail"
    warm = check_of("temperature", having(both, temperatures=Temperatures(satellite=40, pins=50)))
    assert warm.only_needed and warm.value == 50
    half = having(both, temperatures=Temperatures(satellite=40.0))
    assert check_of("temperature", half).missing == ("temperatures.pins",)


def test_values_below_20_gpa_are_those_of_a_plastic() -> None:
    for modulus, plastic in ((19.9e9, True), (20.1e9, False)):
        made = by_values(youngs_modulus=modulus, poissons_ratio=0.3, yield_strength=100e6)
        assert (made.plastic is not None) == plastic
