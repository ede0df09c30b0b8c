"""Bearings by name: values that are not given come from the table of bearings."""

from collections.abc import Iterator
from typing import Any

from app.fields import SectionFields


class NamedBearingFields(SectionFields):
    """Bearing by its name, by values, or by both; a given value replaces that of the table."""

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with those of the table."""
        yield from super().assumed()
        yield from (((field,), value) for field, value in self.filled.items())
