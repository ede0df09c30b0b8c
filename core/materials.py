"""Properties and sources of a material of the table, or of a material given by values."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal, TypedDict, Unpack, cast

from core.errors import InvalidInput
from core.hertz import BulkStrength, ContactLimit, ElasticMaterial, Layers, Plastic, Spread

GROUPS = {
    "steel": "Steel",
    "cast_iron": "Cast iron",
    "aluminium": "Aluminium",
    "bronze": "Bronze",
    "brass": "Brass",
    "plastic": "Plastic",
    "plastic_printed": "Printed plastic",
}
"""Groups of materials in English, by code."""

PLASTICS = ("plastic", "plastic_printed")
"""Groups that are judged by the rules of plastics."""

SOFT = 20e9
"""Young's modulus below which a material given by values counts as a plastic, Pa: metals of pins
and holes lie above 40 GPa, filled plastics below 15 GPa."""

Seen = Literal["one", "two"]
"""Number of independent sources in which a value was read."""

SEEN: dict[Seen, str] = {"one": "one source, for reference", "two": "two sources"}
"""English words of the number of sources."""


@dataclass(frozen=True, slots=True)
class Strength:
    """Strength of a material, as far as it is known."""

    tensile: float | None = None  # Rm, Pa
    yield_strength: float | None = None  # Re or Rp0.2, Pa; of a printed plastic in its layers
    # Largest diameter or wall for these strengths, m; None where the source names none.
    valid_diameter: float | None = None
    source: str = ""  # source of the strengths


@dataclass(frozen=True, slots=True)
class Fact:
    """Property with a single source, or with sources that agree."""

    value: float  # SI, temperatures in degrees Celsius
    source: str  # source of the value
    seen: Seen = field(default="two", kw_only=True)  # "one" is for reference only

    @property
    def spread(self) -> Spread:
        """Spread of the single value."""
        return Spread.of(self.value)


@dataclass(frozen=True, slots=True)
class Range(Fact):
    """Property with sources that differ."""

    low: float  # least value read
    high: float  # largest value read

    @property
    def spread(self) -> Spread:
        """Value with the least and the largest that were read."""
        return Spread(self.value, self.low, self.high)


ELASTIC = ("youngs_modulus", "poissons_ratio")
"""Names of E and v."""


class Moduli(TypedDict, total=False):
    """E and v, as far as they are given."""

    youngs_modulus: float  # E, Pa
    poissons_ratio: float  # v


@dataclass(frozen=True)
class TableMaterial:
    """Material of the table."""

    name: str  # for programs, stable
    title: str  # name for people
    group: str  # a key of `GROUPS`
    moduli: Mapping[str, float] = field(hash=False)  # E, Pa, and v, as far as a source has them
    source: str  # source of the moduli
    limits: tuple[ContactLimit, ...] = ()  # limits of contact pressure, one at most by criterion
    strength: Strength = Strength()
    density: float | None = None  # kg/m^3
    density_source: str = ""  # source of the density
    hardened: bool = False  # True if the strengths are those of the core
    layered: bool = False  # True if it is printed in layers
    facts: Mapping[str, Fact] = field(default_factory=dict, hash=False)  # by name of the property

    @cached_property
    def reference(self) -> tuple[str, ...]:
        """Names of E, v and density that have one source only."""
        used = ("youngs_modulus", "poissons_ratio", "density")
        return tuple(name for name in used if name in self.facts and self.facts[name].seen == "one")

    @property
    def missing(self) -> tuple[str, ...]:
        """Names of E and v that no source has."""
        return tuple(name for name in ELASTIC if name not in self.moduli)

    @cached_property
    def material(self) -> ElasticMaterial:
        """Material at room temperature with its endurance limit; `InvalidInput` without E or v."""
        return self.having()

    def having(self, **given: Unpack[Moduli]) -> ElasticMaterial:
        """Material with E, Pa, or v given instead of the values of the table. `InvalidInput` is
        raised if E or v has no source and is not given. If sources differ, E is the largest.
        """
        known, least = {**self.moduli}, {}
        match self.facts.get("youngs_modulus"):
            case Range(low=low, high=high) if "youngs_modulus" not in given:
                known["youngs_modulus"], least = high, {"least_modulus": low}
        known |= cast(dict[str, float], given)
        for name in ELASTIC:
            if name not in known:
                raise InvalidInput(name, None, "not_sourced", material=self.name)
        static = [float(each.pressure) for each in self.limits if each.criterion == "static"]
        return ElasticMaterial(
            **known,
            limit=next((each for each in self.limits if each.criterion != "static"), None),
            yield_strength=None if self.hardened else self._strength,
            yield_governs=not self.hardened and self.group != "bronze",
            static_pressure=next(iter(static), None),
            **least,
            plastic=self._plastic if self.group in PLASTICS else None,
            strengths=self._strengths,
            bulk=BulkStrength(
                self.strength.tensile,
                self.strength.yield_strength,
                self.group == "steel",
                self.strength.valid_diameter,
            ),
            density=self.density,
        )

    @property
    def _strengths(self) -> Spread | None:
        """Spread of the strength of a plastic, if two sources give it."""
        known = self.facts.get("strength_in_plane", self.facts.get("yield_strength"))
        sure = known is not None and known.seen == "two" and self.group in PLASTICS
        return known.spread if known and sure else None

    @property
    def _strength(self) -> float | None:
        """Yield strength, Pa; of a plastic without one the tensile strength."""
        if self.group in PLASTICS and self.strength.yield_strength is None:
            return self.strength.tensile
        return self.strength.yield_strength

    @property
    def _plastic(self) -> Plastic:
        values = {name: each.spread for name, each in self.facts.items()}
        sure = {name: each.spread for name, each in self.facts.items() if each.seen == "two"}
        return Plastic(
            layered=self.layered, friction=values.get("friction"), softening=sure.get("softening")
        )


NOT_LISTED = TableMaterial("", "", "", {}, "", layered=True)
"""Material that is given by values alone."""


STEELS = 190e9, 220e9
"""Range of Young's moduli of steels, for which alone a rule of the endurance limit exists, Pa."""


def like_steel(youngs_modulus: Any) -> bool:
    """True if a material given by values counts as a steel."""
    return bool(STEELS[0] <= youngs_modulus <= STEELS[1])


def in_bending(material: ElasticMaterial) -> dict[str, Any]:
    """Material of a part that bends and its strengths, by the names of `DesignPin`."""
    bulk = material.bulk
    yields = bulk.yield_strength or material.yield_strength
    return {
        "material": replace(material, yield_strength=yields),
        "tensile_strength": bulk.tensile_strength,
        "steel": bulk.steel,
        "valid_diameter": bulk.valid_diameter,
    }


def by_values(
    *,
    base: TableMaterial = NOT_LISTED,
    limit: ContactLimit | None = None,
    tensile_strength: float | None = None,
    yield_strength: float | None = None,
    layers: Layers | None = None,
    long_term_factor: float | None = None,
    **moduli: Unpack[Moduli],
) -> ElasticMaterial:
    """Material by values; `InvalidInput` if E or v is unknown.

    The base supplies the values not given; an unlisted one with a modulus below `SOFT` is a
    plastic. Of the strengths Rm and Re of a plastic, Pa, the smaller one counts, in the direction
    that `layers` names. `moduli` are Young's modulus E, Pa, and Poisson's ratio v.

    >>> own = by_values(youngs_modulus=2.5e9, poissons_ratio=0.38, tensile_strength=44e6)
    >>> own.loaded_strength("hole"), own.loaded_strength("pin")
    (44000000.0, None)
    """
    made = base.having(**moduli)
    plastic = made.plastic
    if base is NOT_LISTED and made.youngs_modulus < SOFT:
        plastic = Plastic()
    strength = yield_strength
    if plastic is not None:
        given = [each for each in (yield_strength, tensile_strength) if each is not None]
        strength = min(given, default=None)
        plastic = replace(
            plastic,
            layers=layers,
            strength_across=strength if layers == "upright" else None,
            long_term_factor=long_term_factor,
        )
    bulk = made.bulk
    if base is NOT_LISTED or tensile_strength or yield_strength:
        bulk = BulkStrength(tensile_strength, steel=like_steel(made.youngs_modulus))
    return replace(
        made,
        bulk=bulk,
        limit=limit or made.limit,
        yield_strength=made.yield_strength if strength is None else strength,
        strengths=made.strengths if strength is None else None,
        plastic=plastic,
    )
