"""Design that is drawn: what the requests of its files have in common."""

from collections.abc import Mapping
from typing import ClassVar, NoReturn, Self

from pydantic import Field, model_validator

from app import VERSION
from app.calculations.crank_planetary_sections import CrankPlanetaryRequest
from app.calculations.document import Needs
from app.model import RequestModel, pointer
from app.problems import nested, refusal
from app.rules import field_error
from app.settings import Settings
from core.design.diameters import Sizes
from core.errors import InvalidInput, NotKnown

MADE_BY = f"KHV Calc {VERSION}"

DIAMETERS: dict[Sizes, str] = {"nominal": "nominal", "mean": "the middle of their limits"}
"""Words for the diameters that are drawn."""

MOST_CIRCLES = 1000
"""Largest number of holes, and of ring pins, as a file of so many takes a second."""


class DrawnDesign(CrankPlanetaryRequest):
    """Request of `/crank-planetary`, which needs only what is drawn."""

    NEEDS: ClassVar[Needs] = ()
    NEEDED_OF: ClassVar[dict[str, Needs]] = {}


class DrawnRequest(RequestModel, group="drawing"):
    """Design whose shapes are known."""

    design: DrawnDesign = Field(
        description="Request of /crank-planetary with a ring of pins whose modification is given,"
        " or with involute teeth whose profile shifts and heights are given, as "
        "unknown shapes are not drawn. Satellites have holes if pins are given. Deviations are "
        "not drawn, and the results that the request names are not calculated."
    )
    sizes: Sizes = Field(
        default="nominal",
        description="Diameters of pins and holes whose limits are known by a fit, tolerances or a"
        " process: the nominal ones, or the middle of their limits.",
    )

    @model_validator(mode="after")
    def _no_lobe_left_out(self) -> Self:
        lobes, pins = self.design.mechanism.teeth or (0, 1)
        if self.design.ring_kind == "cycloid" and pins != lobes + 1:
            more = {"expected": lobes + 1}
            raise field_error("design/mechanism/ring_teeth", "not_this_cycloid", **more)
        return self

    def refuse_beyond(self, settings: Settings) -> None:
        """Refuse inputs that the design's own request refuses, and too many circles."""
        with nested("/design", self.design):
            self.design.refuse_beyond(settings)
        own = self.design.mechanism
        if own.pairs > MOST_CIRCLES:
            raise InvalidInput("pins", own.pins, "too_many_pairs", **own.most_pins(MOST_CIRCLES))

    @property
    def involute(self) -> bool:
        """True if satellites and ring have involute teeth."""
        return self.design.ring_kind == "involute"

    def lacking(self, left_out: Mapping[str, str]) -> dict[str, str]:
        """Words for what each part that is left out lacks, by its name."""
        return {
            name: ".".join(map(str, self.path_of(path))) if path else "its shape"
            for name, path in left_out.items()
        }

    def refuse_unknown(self, why: NotKnown) -> NoReturn:
        """Raise the refusal of a design in which a size that is drawn is not known."""
        missing = why.missing[0] if why.missing else "gear"
        raise refusal(pointer(self.path_of(missing)), "needed_to_draw") from why


def refuse_many_pins(count: int) -> None:
    """Raise InvalidInput for more ring pins than are drawn."""
    if count > MOST_CIRCLES:
        raise InvalidInput("mechanism.ring_teeth", count, "less_than_equal", limit=MOST_CIRCLES)
