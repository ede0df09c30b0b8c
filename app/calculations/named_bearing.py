"""Bearings by name: what of one is not typed, the table of bearings says."""

from collections.abc import Iterator
from functools import cached_property, partial
from typing import Any, ClassVar, Self

from pydantic import model_validator

from app.model import RequestModel, present, quantity
from app.rules import Forms, field_error
from app.units import core_name, from_si
from core.bearings import BEARINGS, NamedBearing, named_bearing, names_like

bearing_name = partial(
    quantity,
    "Bearing",
    schema={"x-options": [*BEARINGS]},
    max_length=40,
    help="A name of the table of bearings, as 686: it says the sizes and the lowest load ratings "
    "of its makers; what is typed beside it counts instead.",
)


class NamedBearingFields(RequestModel):
    """A bearing by its name, by values, or by both: a value that is typed counts."""

    ALTERNATIVES: ClassVar[tuple[Forms, ...]] = ((("kind",), ("name",), ("kind", "name")),)

    @model_validator(mode="after")
    def _known_name(self) -> Self:
        if "name" in self.given and not self.named:
            near = ", ".join(names_like(self.given["name"]) or BEARINGS)
            raise field_error("name", "no_such_bearing", near=near)
        return self

    @cached_property
    def named(self) -> NamedBearing | None:
        """The bearing that its name says."""
        return named_bearing(self.given.get("name", ""))

    @cached_property
    def filled(self) -> dict[str, Any]:
        """Fields that the name says, as they are not typed."""
        if not self.named:
            return {}
        said = {
            field: from_si(field, self.said(self.named, core_name(field)))
            for field in type(self).model_fields
            if field not in self.given
        }
        return present(said)

    def said(self, named: NamedBearing, quantity: str) -> Any:
        """What a bearing of the table says of a quantity, in SI units.

        Parameters
        ----------
        named : NamedBearing
            The bearing.
        quantity : str
            Its name in core.

        Returns
        -------
        object or None
            None where it says nothing of it.
        """
        return getattr(named, quantity, None)

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Also what the name says."""
        yield from super().assumed()
        yield from (((field,), value) for field, value in self.filled.items())

    def to_core(self) -> dict[str, Any]:
        """The given fields as the core's arguments, with what the name says instead of it."""
        own = RequestModel.to_core(self.model_copy(update=self.filled))
        own.pop("name", None)
        return own
