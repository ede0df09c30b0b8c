"""Missing knowledge never makes a judgement milder: material values typed within their range,
values removed; inputs that a whole reducer can do without."""

import math
from dataclasses import dataclass, replace
from random import Random
from typing import Any

import pytest

from core.checks.check import Verdict
from core.checks.reserve import NEAR, crank_verdict
from core.contact_life import CURVES, LifeCurve
from core.design.results import Results
from core.design.ring import CycloidRing
from core.design.sections import PART_NAMES, DesignPin, Friction, RollingBearing, SeatedBearing
from core.hertz import ContactLimit, Layers
from core.material_table import MATERIALS
from core.materials import NOT_LISTED, PLASTICS, Range, TableMaterial, by_values
from core.precision import EXACT, SEARCHED
from core.ring.profile import Modification
from tests.inputs.checks import REF, WHOLE, having
from tests.oracles.seeds import seeds

STEEL = replace(
    MATERIALS["steel_bearing"].material, limit=ContactLimit("given", 5e9), yield_strength=3e9
)
FITTED = having(REF, pin_material=STEEL, scope=("contact",))
"""Pins in holes without clearance, whose forces are the ideal ones."""

SOFT = [name for name, each in MATERIALS.items() if each.group in PLASTICS]

RATIO = 0.36
"""Poisson's ratio where no source has it, and where sources differ: of 2 % of the torque."""


@dataclass(frozen=True)
class Typed:
    """Typed values of a material and of its friction; None removes one."""

    base: TableMaterial
    youngs_modulus: float | None = None
    yield_strength: float | None = None
    friction: float | None = None
    allowable: float | None = None
    layers: Layers | None = None
    body: str = "hole"

    @property
    def verdict(self) -> Verdict:
        """Verdict of pins and holes under the torque of the case."""
        own: dict[str, Any] = {"yield_strength": self.yield_strength, "layers": self.layers}
        ratio = self.base.moduli.get("poissons_ratio", RATIO)
        if self.youngs_modulus is not None:
            own["youngs_modulus"] = self.youngs_modulus
        if self.allowable is not None:
            own["limit"] = ContactLimit("given", self.allowable)
        made = by_values(base=self.base, poissons_ratio=ratio, **own)
        friction = None if self.friction is None else Friction(coefficient=self.friction)
        design = having(FITTED, friction=friction, **{f"{self.body}_material": made})
        return crank_verdict(Results(design))


def spread(entry: TableMaterial, *names: str) -> tuple[float, float] | None:
    """From where to where sources of a value go that is used; None where they are not two."""
    for name in names:
        known = entry.facts.get(name)
        if isinstance(known, Range) and known.seen == "two":
            return known.low, known.high
        if known and (known.seen == "two" or name == "friction"):
            return known.value, known.value
    return None


NAMED = {"friction": "coefficient", "allowable": "allowable_pressure"}
"""Fields of what is taken away, where they have another name."""


def holds(monkeypatch: pytest.MonkeyPatch, whole: Typed, removed: list[str], torque: float) -> None:
    """The rule, of one case, under a torque."""
    own = having(FITTED, output_torque=torque)
    monkeypatch.setitem(globals(), "FITTED", own)
    given, less = whole.verdict, replace(whole, **dict.fromkeys(removed)).verdict
    known = {
        "yield_strength": spread(whole.base, "strength_in_plane", "yield_strength"),
        "youngs_modulus": whole.base.moduli.get("youngs_modulus"),
        "friction": spread(whole.base, "friction") or (whole.base is NOT_LISTED and (0, 0.1)),
    }
    assert less.verdict != "pass" or given.verdict == "pass", (whole, removed)
    if all(known.get(name) for name in removed):
        assert given.torque_reserve is not None
        assert less.torque_reserve is not None
        assert less.torque_reserve <= given.torque_reserve * (1 + EXACT), (whole, removed)
    else:
        assert less.torque_reserve is None and not less.largest_torque_known, (whole, removed)
    failing = {each.code for each in given.checks if each.status == "fail"}
    for each in less.checks:
        if each.status == "fail":
            assert each.code in failing, (whole, removed)
        elif each.code in failing:  # the answer names what decides
            assert {name.rpartition(".")[2] for name in each.missing} & {
                NAMED.get(name, name) for name in removed
            }, (each, removed)


@pytest.mark.parametrize("name", SOFT)
@pytest.mark.parametrize("seed", seeds(8, 42))
def test_a_plastic_of_which_less_is_known_is_judged_no_milder(
    monkeypatch: pytest.MonkeyPatch, name: str, seed: int
) -> None:
    random, entry = Random(f"{name} {seed}"), MATERIALS[name]
    strength = spread(entry, "strength_in_plane", "yield_strength")
    friction = spread(entry, "friction")
    modulus = entry.facts.get("youngs_modulus")
    ends = (modulus.low, modulus.high) if isinstance(modulus, Range) else None
    whole = Typed(
        base=entry,
        youngs_modulus=random.uniform(*ends) if ends else entry.moduli["youngs_modulus"],
        yield_strength=random.uniform(*(strength or (10e6, 90e6))),
        friction=random.uniform(*(friction or (0.1, 0.5))),
    )
    names = [*random.sample(["youngs_modulus", "yield_strength", "friction"], random.randint(1, 3))]
    reserve = whole.verdict.torque_reserve
    assert reserve is not None
    torque = FITTED.load.output_torque * reserve * 10 ** random.uniform(-0.7, 0.7)
    holds(monkeypatch, whole, names, torque)


LAYERED = [name for name in SOFT if spread(MATERIALS[name], "strength_in_plane")]


@pytest.mark.parametrize("name", LAYERED)
@pytest.mark.parametrize("seed", seeds(5, 42))
def test_a_plastic_pin_that_bends_is_judged_no_milder(name: str, seed: int) -> None:
    random, entry = Random(f"bent {name} {seed}"), MATERIALS[name]
    strength = random.uniform(*spread(entry, "strength_in_plane"))  # type: ignore[misc]
    torque = 10 ** random.uniform(-1, 2)

    def judged(**own: Any) -> Verdict:
        pin = DesignPin(
            support="cantilever",
            diameter=0.016,
            satellite_positions=(0.015, 0.037),
            material=by_values(base=entry, **own),
        )
        design = having(FITTED, pin=pin, scope=("pins",), output_torque=torque)
        return crank_verdict(Results(design), largest=True)

    whole = judged(yield_strength=strength, layers="flat")
    named, upright = judged(layers="flat"), judged(layers="upright")
    given = whole["pin_static"]
    assert whole.torque_reserve and named.torque_reserve
    assert named.torque_reserve <= whole.torque_reserve * NEAR  # each is within that of its own
    for less in (named, upright):
        found = less["pin_static"]
        assert found.status in ("fail", "marginal", "not_checked") and less.verdict != "pass"
        assert given.status == "fail" or found.status != "fail"
        if given.status == "fail" and found.status != "fail":
            assert "pin.material.yield_strength" in found.missing
    if entry.layered:  # across its layers it is weaker by what nobody knows
        assert upright.torque_reserve is None
    assert upright["pin_static"].status == "fail" or named["pin_static"].status != "fail"


@pytest.mark.parametrize("seed", seeds(20, 42))
def test_a_metal_of_which_less_is_known_is_judged_no_milder(
    monkeypatch: pytest.MonkeyPatch, seed: int
) -> None:
    random = Random(seed)
    whole = Typed(
        base=NOT_LISTED,
        youngs_modulus=random.uniform(60e9, 210e9),
        yield_strength=random.uniform(100e6, 600e6),
        friction=random.uniform(0.0, 0.1),
        allowable=random.uniform(400e6, 1500e6),
    )
    names = random.sample(["yield_strength", "friction", "allowable"], random.randint(1, 2))
    reserve = whole.verdict.torque_reserve
    assert reserve is not None
    holds(monkeypatch, whole, names, FITTED.load.output_torque * reserve * random.uniform(0.7, 1.3))


LASTING = ContactLimit("given", 1.5e9, curve="hardened")
SMOOTH = replace(STEEL, limit=LASTING, yield_strength=600e6)
CATALOGUE = {
    "kind": "roller",
    "dynamic_rating": 40e3,
    "bore_diameter": 0.03,
    "outer_diameter": 0.062,
    "width": 0.016,
}
BEARING = RollingBearing(**CATALOGUE, static_rating=30e3)
REDUCER = having(
    WHOLE,
    distribution_factor=1.05,
    pin_material=SMOOTH,
    hole_material=SMOOTH,
    gear=CycloidRing(
        ring_pin_circle_radius=0.1,
        ring_pin_radius=0.004,
        modification=Modification(equidistant=5e-6),
        pin_material=SMOOTH,
        friction_coefficient=0.02,
    ),
    bearing=BEARING,
    crankshaft=replace(WHOLE.crankshaft, bearings=(SeatedBearing(**CATALOGUE),) * 2),
    satellite_body=replace(REF.satellite_body, root_radius=0.09, bore_radius=0.0325),
    min_efficiency=0.5,
    scope=tuple(part for part in PART_NAMES if part != "teeth"),
)
"""All of a reducer with ideal forces on its pins, but for its teeth, which take long."""

OPTIONAL: dict[str, dict[str, Any]] = {
    # what is taken away: its values
    "speed": {"input_speed": None},
    "modification": {"gear.modification": None},
    "clearance": {"clearance_stated": False},
    "friction": {"friction": None},
    "fatigue": {"fatigue": None},
    "rating": {"bearing.dynamic_rating": None},
    "static rating": {"bearing.static_rating": None},
    "ratings of the crank": {"crankshaft.bearings": ()},
    "limit of the holes": {"hole_material": replace(SMOOTH, limit=None)},
    "yield of the pins' surface": {"pin_material": replace(SMOOTH, yield_strength=None)},
    "yield of the pins": {"pin.material": replace(WHOLE.pin.material, yield_strength=None)},
    "bearing": {"bearing": None},
    "body": {"satellite_body": None},
}


@pytest.mark.slow
@pytest.mark.parametrize("seed", seeds(20, 500))
def test_a_reducer_of_which_less_is_known_is_judged_no_milder(seed: int) -> None:
    """The head's reserve is of the parts that it names: of these it is no larger than where all of
    them is known.
    """
    random = Random(f"whole {seed}")
    design = having(
        REDUCER,
        output_torque=10 ** random.uniform(1.3, 2.8),
        input_speed=10 ** random.uniform(1.3, 3.3),  # 6e7 to 6e9 loads
        life=5000 * 3600.0,
        **{
            "friction.coefficient": random.uniform(0.0, 0.1),
            "bearing.dynamic_rating": 10 ** random.uniform(4, 5),
            "contact.hole_radius": 0.010,
        },
    )
    name = [*OPTIONAL][seed % len(OPTIONAL)]
    less, said = crank_verdict(Results(having(design, **OPTIONAL[name]))), (seed, name)
    given = crank_verdict(Results(design))
    failing = {each.code for each in given.checks if each.status == "fail"}
    assert less.verdict != "pass" or given.verdict == "pass", said
    assert not {each.code for each in less.checks if each.status == "pass"} & failing, said
    assert (less.torque_reserve is not None) == less.largest_torque_known, said
    if less.largest_torque_known:
        scope = having(design, scope=less.largest_torque_of)
        known = crank_verdict(Results(scope)).torque_reserve
        assert known is not None and less.torque_reserve is not None, said
        assert less.torque_reserve <= known * (1 + SEARCHED), said


@pytest.mark.parametrize("curve", CURVES)
@pytest.mark.parametrize("seed", seeds(20, 500))
def test_a_contact_of_which_no_speed_is_known_is_judged_no_milder(
    curve: LifeCurve, seed: int
) -> None:
    """By any number of loads between the knee of its curve and 1e10."""
    random = Random(f"{curve} {seed}")
    loads = 10 ** random.uniform(math.log10(CURVES[curve].knee), 10)
    hole = replace(STEEL, limit=ContactLimit("given", random.uniform(5e8, 2e9), curve=curve))
    turning = having(FITTED, hole_material=hole, life=5000 * 3600.0, input_speed=1.0)
    turning = having(turning, input_speed=loads / turning.loads_over(5000 * 3600.0))
    reserve = crank_verdict(Results(turning)).torque_reserve
    assert reserve is not None
    torque = turning.load.output_torque * reserve * random.uniform(0.7, 1.3)
    given, less = (
        crank_verdict(Results(having(turning, output_torque=torque, **speed)))
        for speed in ({}, {"input_speed": None})
    )
    assert less.torque_reserve is not None and given.torque_reserve is not None
    assert less.torque_reserve <= given.torque_reserve * (1 + 1e-3)  # of rounded exponents
    assert less.verdict != "pass" or given.verdict == "pass"
    found = less["contact_pressure_hole"]
    assert given["contact_pressure_hole"].status == "fail" or found.status != "fail"
    assert found.missing == ("load.input_speed",)
    if given.verdict == "fail":
        assert less.verdict == "fail" or found.reason == "range_decides"
