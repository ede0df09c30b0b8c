"""What is not known is never judged milder: values of a material typed within their range, and some
of them taken away.
"""

from dataclasses import dataclass, replace
from random import Random
from typing import Any

import pytest

from core.checks.check import Verdict
from core.checks.crank_planetary import crank_verdict
from core.design.results import Results
from core.design.sections import DesignPin, Friction
from core.hertz import ContactLimit, Layers
from core.material_table import MATERIALS
from core.materials import NOT_LISTED, PLASTICS, Range, TableMaterial, by_values
from core.precision import EXACT
from tests.inputs.checks import REF, having
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
    """What is typed of a material, and of the friction on it; None is taken away."""

    base: TableMaterial
    youngs_modulus: float | None = None
    yield_strength: float | None = None
    friction: float | None = None
    allowable: float | None = None
    layers: Layers | None = None
    body: str = "hole"

    @property
    def verdict(self) -> Verdict:
        """Of pins and holes under the torque of the case."""
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
                "coefficient" if name == "friction" else name for name in removed
            }, (each, removed)


@pytest.mark.parametrize("name", SOFT)
@pytest.mark.parametrize("seed", seeds(20, 42))
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
@pytest.mark.parametrize("seed", seeds(20, 42))
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
        return crank_verdict(Results(design))

    whole = judged(yield_strength=strength, layers="flat")
    named, upright = judged(layers="flat"), judged(layers="upright")
    given = whole["pin_static"]
    assert whole.torque_reserve and named.torque_reserve
    assert named.torque_reserve <= whole.torque_reserve * (1 + EXACT)
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
    names = random.sample(["yield_strength", "friction"], random.randint(1, 2))
    reserve = whole.verdict.torque_reserve
    assert reserve is not None
    holds(monkeypatch, whole, names, FITTED.load.output_torque * reserve * random.uniform(0.7, 1.3))
