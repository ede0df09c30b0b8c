"""Sections of the design document of which requests know more than core: load, bearings."""

from app.calculations.hertz import of_load_factor
from app.calculations.ideal_forces import LoadFields
from app.fields import SectionFields
from core.design.sections import CatalogueBearing, Load, SeatedBearing
from core.errors import Notice


class DesignLoadFields(LoadFields, of=Load, group="load"):
    """Load with the direction of its torque, its speed and its variation."""

    def notices(self) -> tuple[Notice, ...]:
        """Notices, also of an application factor below 1."""
        return super().notices() + of_load_factor(self.application_factor)


class ShaftBearingFields(SectionFields, of=CatalogueBearing, group="bearing"):
    """A bearing of the crankshaft."""


class SeatedBearingFields(ShaftBearingFields, of=SeatedBearing, group="crankshaft"):
    """Bearing of the crankshaft, and the part that holds it."""
