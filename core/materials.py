"""What is known of a material of the table, from where, or of one that is given by values."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal, TypedDict, Unpack, cast

from core.errors import InvalidInput
from core.hertz import ContactLimit, ElasticMaterial, Layers, Plastic, Spread

GROUPS = {
    "steel": "Steel",
    "cast_iron": "Cast iron",
    "aluminium": "Aluminium",
    "bronze": "Bronze",
    "brass": "Brass",
    "plastic": "Plastic",
    "plastic_printed": "Printed plastic",
}
"""Kinds of materials in English, by code."""

PLASTICS = ("plastic", "plastic_printed")
"""Groups that are judged by the rules of plastics."""

SOFT = 20e9
"""Young's modulus below which a material that is given by values is a plastic, Pa: metals of pins
and holes lie above 40 GPa, filled plastics below 15 GPa."""

Seen = Literal["one", "two"]
"""In how many independent sources a value was read."""

SEEN: dict[Seen, str] = {"one": "one source, for reference", "two": "two sources"}
"""The same in English."""


@dataclass(frozen=True, slots=True)
class Strength:
    """Strength of a material, as far as it is known."""

    tensile: float | None = None  # Rm, Pa
    yield_strength: float | None = None  # Re or Rp0.2, Pa; of a printed plastic in its layers
    # Largest diameter or wall that they hold for, m; None where their source names none.
    valid_diameter: float | None = None
    source: str = ""  # where they come from


@dataclass(frozen=True, slots=True)
class Fact:
    """A value of which there is one source only, or on which all agree."""

    value: float  # SI, temperatures in degrees Celsius
    source: str  # where it was seen
    seen: Seen = field(default="two", kw_only=True)  # one: for reference

    @property
    def spread(self) -> Spread:
        """It with its ends."""
        return Spread.of(self.value)


@dataclass(frozen=True, slots=True)
class Range(Fact):
    """A value whose sources differ."""

    low: float  # the least that was seen
    high: float  # the largest

    @property
    def spread(self) -> Spread:
        """It with its ends."""
        return Spread(self.value, self.low, self.high)


ELASTIC = ("youngs_modulus", "poissons_ratio")
"""Names of E and v."""


class Moduli(TypedDict, total=False):
    """E and v, as far as they are given."""

    youngs_modulus: float  # E, Pa
    poissons_ratio: float  # v


@dataclass(frozen=True)
class TableMaterial:
    """A material of the table."""

    name: str  # for programs, stable
    title: str  # name for people
    group: str  # a key of `GROUPS`
    moduli: Mapping[str, float] = field(hash=False)  # E, Pa, and v, as far as a source has them
    source: str  # where these come from
    limits: tuple[ContactLimit, ...] = ()  # of its contact pressure, at most one by each criterion
    strength: Strength = Strength()
    density: float | None = None  # kg/m^3
    density_source: str = ""  # where that comes from
    hardened: bool = False  # whether its strengths are those of the core
    layered: bool = False  # whether it is printed in layers
    facts: Mapping[str, Fact] = field(default_factory=dict, hash=False)  # by the name of the value

    @cached_property
    def reference(self) -> tuple[str, ...]:
        """Values that the material has from one source only."""
        used = ("youngs_modulus", "poissons_ratio", "density")
        return tuple(name for name in used if name in self.facts and self.facts[name].seen == "one")

    @property
    def missing(self) -> tuple[str, ...]:
        """Of E and v, what no source has."""
        return tuple(name for name in ELASTIC if name not in self.moduli)

    @cached_property
    def material(self) -> ElasticMaterial:
        """The material at room temperature, judged by its endurance limit where it has one.

        Raises
        ------
        InvalidInput
            If no source has its modulus or its Poisson's ratio.
        """
        return self.having()

    def having(self, **given: Unpack[Moduli]) -> ElasticMaterial:
        """The material with a modulus, Pa, or a Poisson's ratio that is given.

        Parameters
        ----------
        **given : float
            `youngs_modulus` or `poissons_ratio` instead of those of the table.

        Returns
        -------
        ElasticMaterial
            Where sources differ, its modulus is the largest.

        Raises
        ------
        InvalidInput
            If one is not given that no source has.
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
        )

    @property
    def _strengths(self) -> Spread | None:
        """Strength of a plastic by two sources that differ."""
        known = self.facts.get("strength_in_plane", self.facts.get("yield_strength"))
        sure = known is not None and known.seen == "two" and self.group in PLASTICS
        return known.spread if known and sure else None

    @property
    def _strength(self) -> float | None:
        """Yield strength; of a plastic of which none is known its tensile strength."""
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
"""A material that is given by values alone."""


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
    """A material by values.

    Parameters
    ----------
    base : TableMaterial
        Whose values are taken where none are given; of one that is not listed it is a plastic where
        its modulus is below `SOFT`.
    limit : ContactLimit, optional
        What its contact pressure is judged by.
    tensile_strength, yield_strength : float, optional
        Rm and Re, Pa; of a plastic the smaller one counts, in the direction that `layers` says.
    layers : {"flat", "upright"}, optional
        How the layers of a printed plastic lie.
    long_term_factor : float, optional
        Strength in the long run over that of a short test.
    **moduli : float
        `youngs_modulus` E, Pa, and `poissons_ratio` v.

    Returns
    -------
    ElasticMaterial

    Raises
    ------
    InvalidInput
        If E or v is not known.

    Examples
    --------
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
    return replace(
        made,
        limit=limit or made.limit,
        yield_strength=made.yield_strength if strength is None else strength,
        strengths=made.strengths if strength is None else None,
        plastic=plastic,
    )
