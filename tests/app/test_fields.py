"""Models of sections made of dataclasses: names, limits, defaults, lists, kinds, rules."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar, Literal

import pytest
from pydantic import ValidationError

from app.fields import RequestField, SectionedFields, SectionFields, request_fields
from app.model import Maybe, quantity
from app.units import UNITS
from core.fields import Forms, Rule, Variants, optional_size, size
from core.fields import quantity as of_core


@dataclass(frozen=True, kw_only=True)
class Hole:
    """A hole."""

    radius: float = size("Radius", "r", "mm", step=0.5)
    """Radius of the hole."""


@dataclass(frozen=True, kw_only=True)
class Plate:
    """A plate."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("mass",), ("density",), ()),)
    BETWEEN: ClassVar[tuple[Rule, ...]] = (Rule("density", "needed_beside", "holes"),)

    turned: float = of_core("Turned", "φ", "deg", default=math.pi, ge=0, le=360)
    """Angle by which the plate
    is turned."""
    corners: int = of_core("Corners", ge=3, le=10)
    """Number of corners."""
    mass: float | None = optional_size("Mass", "m", "kg")
    """Mass of the plate."""
    density: float | None = optional_size("Density", "ρ", "kg_m3")
    """Density of the plate."""
    rows: tuple[tuple[float, ...], ...] = size(
        "Rows", "", "mm", default=(), lengths=((1, 2), (1, 3))
    )
    """Rows of places."""
    holes: tuple[Hole, ...] = of_core(default=(), lengths=((1, 2),))
    stiffness: float = size("Stiffness", "k", "N_per_mm", default=math.inf)
    """Stiffness of the plate, rigid if not given."""
    painted: bool = of_core("Painted", default=False, silent=True)
    """True if the plate is painted."""
    names: tuple[Literal["a", "b"], ...] = of_core("Names", default=("a",), lengths=((1, 2),))
    """Names of the plate."""


@dataclass(frozen=True, kw_only=True)
class Round:
    """A round plate."""

    radius: float = size("Radius", "r", "mm")
    """Radius of the plate."""


class PlateFields(SectionFields, of=Plate, group="plate"):
    """A plate of a request."""


class AnyPlateFields(SectionFields, of={"any": Plate, "round": Round}, group="plate"):
    """A plate of any kind."""

    kind: Maybe[Literal["any", "round"]] = quantity("Kind")
    """Kind of plate."""


COVERS = Variants({"round": Round}, title="Cover", help="Kind of cover.", about="A cover.")


class BoxFields(
    SectionedFields, sections={"base_plate": Round, "plate": Plate, "top_cover": COVERS}
):
    """A box of a request."""

    plate: PlateFields


GIVEN: dict[str, Any] = {"corners": 4.0, "density_kg_m3": 7850.0}
ALL: dict[str, Any] = {
    "turned_deg": 90.0,
    "rows_mm": [[1.0, 2.0], [3.0]],
    "holes": [{"radius_mm": 5.0}],
    "stiffness_N_per_mm": 2.0,
    "painted": True,
    "names": ["b"],
}


def test_a_section_is_the_dataclass_in_si() -> None:
    assert PlateFields.model_validate(GIVEN).section() == Plate(corners=4, density=7850.0)
    assert PlateFields.model_validate(GIVEN | ALL).section() == Plate(
        corners=4,
        density=7850.0,
        turned=math.pi / 2,
        rows=((0.001, 0.002), (0.003,)),
        holes=(Hole(radius=0.005),),
        stiffness=2000.0,
        painted=True,
        names=("b",),
    )


@pytest.mark.parametrize(
    ("given", "place"),
    [
        ({"corners": 2}, ("corners",)),
        ({"corners": 3.5}, ("corners",)),
        ({"turned_deg": 361.0}, ("turned_deg",)),
        ({"rows_mm": [[1.0] * 4]}, ("rows_mm", 0)),
        ({"rows_mm": [[-1.0]]}, ("rows_mm", 0, 0)),
        ({"holes": [{}]}, ("holes", 0, "radius_mm")),
        ({"names": ["c"]}, ("names", 0)),
        ({"painted": None}, ("painted",)),
    ],
)
def test_limits_hold_in_the_unit_of_the_document(given: dict[str, Any], place: Any) -> None:
    with pytest.raises(ValidationError) as refused:
        PlateFields.model_validate(GIVEN | given)
    assert [each["loc"] for each in refused.value.errors()] == [place]


@pytest.mark.parametrize(
    ("model", "given", "name", "code"),
    [
        (PlateFields, {"mass_kg": 1.0}, "density_kg_m3", "only_one"),
        (AnyPlateFields, {"kind": "round", "radius_mm": 1.0}, "corners", "of_another_kind"),
    ],
)
def test_rules_are_those_of_the_dataclass(model: Any, given: Any, name: str, code: str) -> None:
    with pytest.raises(ValidationError) as refused:
        model.model_validate(GIVEN | given)
    (error,) = refused.value.errors()
    assert (error["ctx"]["name"], error["ctx"]["code"]) == (name, code)


def test_the_schema_says_what_the_dataclass_says() -> None:
    schema = PlateFields.model_json_schema()
    assert schema["required"] == ["corners"]
    assert schema["properties"]["turned_deg"] == {
        "title": "Turned",
        "type": "number",
        "description": "Angle by which the plate is turned.",
        "default": 180.0,
        "minimum": 0,
        "maximum": 360,
        "x-symbol": "φ",
        "x-unit": "°",
        "x-group": "plate",
    }
    assert "default" not in schema["properties"]["painted"]


def test_a_document_has_the_sections_that_it_does_not_annotate() -> None:
    schema = BoxFields.model_json_schema()
    assert [*BoxFields.model_fields] == ["base_plate", "plate", "top_cover"]
    assert schema["required"] == ["plate"]
    made = {name: schema["$defs"][name] for name in ("BasePlateFields", "TopCoverFields")}
    assert [each["description"] for each in made.values()] == ["A round plate.", "A cover."]
    groups = [each["properties"]["radius_mm"]["x-group"] for each in made.values()]
    assert groups == ["base_plate", "top_cover"]
    read = BoxFields.model_validate({"plate": GIVEN, "base_plate": {"radius_mm": 1.0}})
    assert read.given["base_plate"].section() == Round(radius=0.001)
    assert "top_cover" not in read.given


def _sections(model: Any) -> Iterator[Any]:
    for each in model.__subclasses__():
        if each.__module__ != __name__:
            yield each
            yield from _sections(each)


def _all_fields() -> dict[tuple[Any, str], RequestField]:
    found = {}
    for model in _sections(SectionFields):
        of = vars(model).get("DOCUMENT", {})
        for kind in of.values() if isinstance(of, dict) else (of,):
            found |= {(kind, each.core): each for each in request_fields(kind)}
    return found


def test_every_field_of_the_document_has_its_words_and_a_unit() -> None:
    every = _all_fields()
    assert len(every) > 100
    for each in every.values():
        about = each.input
        assert not about.unit or about.unit in UNITS
        assert each.help or not about.title
        if isinstance(each.default, float):
            low, high = about.limits.get("ge", -math.inf), about.limits.get("le", math.inf)
            assert low <= each.default <= high


def test_a_unit_that_the_api_lacks_is_found_at_import() -> None:
    @dataclass(frozen=True, kw_only=True)
    class Place:
        altitude: float = size("Altitude", "h", "m")
        """Height above the sea."""

    with pytest.raises(KeyError, match="unit of altitude"):
        request_fields(Place)
