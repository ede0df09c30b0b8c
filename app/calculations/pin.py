"""Pin as a section of a design: beam and material."""

from app.fields import SectionFields
from core.design.sections import DesignPin
from core.errors import Notice
from core.output.pin_beam import Support
from core.output.pin_bolt import PinBolt


class PinBoltFields(SectionFields, of=PinBolt, group="pin"):
    """Bolt through the pin, which is a spacer then."""

    def notices(self) -> tuple[Notice, ...]:
        """Notice of a preload that is estimated from a tightening torque."""
        if self.tightening_torque_Nm is None:
            return ()
        return (Notice("nut_factor", {"preload": self.made.preload}),)


class PinFields(SectionFields, of=DesignPin, group="pin"):
    """Pin with its support, bending and strength."""

    support: Support = "cantilever"
