"""Bearings by name: values that are not given come from the table of bearings."""

from collections.abc import Iterator
from functools import cached_property
from typing import Any, Self

from pydantic import model_validator

from app.fields import SectionFields
from app.model import RequestModel, present
from app.rules import field_error
from app.units import core_name, from_si
from core.bearings import BEARINGS, NamedBearing, named_bearing, names_like


class NamedBearingFields(SectionFields):
    """Bearing by its name, by values, or by both; a given value replaces that of the table."""

    @model_validator(mode="after")
    def _known_name(self) -> Self:
        if "name" in self.given and not self.named:
            near = ", ".join(names_like(self.given["name"]) or BEARINGS)
            raise field_error("name", "no_such_bearing", near=near)
        return self

    @cached_property
    def named(self) -> NamedBearing | None:
        """Bearing of the table."""
        return named_bearing(self.given.get("name", ""))

    @cached_property
    def filled(self) -> dict[str, Any]:
        """Fields that come from the table."""
        if not self.named:
            return {}
        said = {
            field: from_si(field, self.said(self.named, core_name(field)))
            for field in type(self).model_fields
            if field not in self.given
        }
        return present(said)

    def said(self, named: NamedBearing, quantity: str) -> Any:
        """Value of a quantity, by its core name, in the table, SI; None if there is none."""
        return getattr(named, quantity, None)

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with those of the table."""
        yield from super().assumed()
        yield from (((field,), value) for field, value in self.filled.items())

    def to_core(self) -> dict[str, Any]:
        """Given fields as the core's arguments, with values of the table."""
        return RequestModel.to_core(self.model_copy(update=self.filled))
