"""Ring of a request: pins and discs of a cycloid, or other teeth that load the satellites."""

from collections.abc import Iterator
from typing import Any, ClassVar

from app.fields import SectionFields
from core.design.ring import RINGS

OF_SUPPORTS = ("span_mm", "satellite_positions_mm")
"""Fields of ring pins that bend."""


class RingFields(SectionFields, of=RINGS, group="gear"):
    """Teeth or pins of the ring, or the ratio of its forces."""

    RULES: ClassVar[tuple[dict[str, Any], ...]] = (
        {
            "if": {
                "properties": {"pin_support": {"enum": ["supported", "fixed"]}},
                "required": ["pin_support"],
            },
            "then": {"required": [*OF_SUPPORTS]},
            "else": {"not": {"anyOf": [{"required": [name]} for name in OF_SUPPORTS]}},
        },
    )

    def assumed(self) -> Iterator[tuple[tuple[str, ...], Any]]:
        """Assumed values, with the material of the ring if its mesh is judged."""
        if self.kind != "cycloid" or self.modification is not None:
            yield from super().assumed()
