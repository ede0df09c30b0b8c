"""Sections of the design document in a request: load, deviations, supports, friction, bearings."""

from app.calculations.hertz import of_load_factor
from app.calculations.ideal_forces import LoadFields
from app.fields import SectionFields
from core.design.sections import (
    CatalogueBearing,
    Friction,
    Load,
    Rollers,
    RollingBearing,
    SatelliteBody,
    SeatedBearing,
    Shaft,
    Temperatures,
)
from core.errors import Notice
from core.output.elasticity import COUPLINGS, CrankSupport
from core.output.room import Deviations


class CrankSupportFields(SectionFields, of=CrankSupport, group="crank_support"):
    """Bearings of the satellites on their cranks. The force of the ring on them is left out."""


class SatelliteCouplingFields(SectionFields, of=COUPLINGS, group="satellite_coupling"):
    """Sharing of the torque between the satellites."""


class DeviationsFields(SectionFields, of=Deviations, group="deviations"):
    """Deviations of a piece from its nominal sizes: of each pin, of each hole satellite by
    satellite, of each crank or disc, of each ring pin. Positive means outward, in the driving
    sense, larger, ahead.
    """


class DesignLoadFields(LoadFields, of=Load, group="load"):
    """Load with the direction of its torque, its speed and its variation."""

    def notices(self) -> tuple[Notice, ...]:
        """Notices, also of an application factor below 1."""
        return super().notices() + of_load_factor(self.application_factor)


class SatelliteBodyFields(SectionFields, of=SatelliteBody, group="satellite_body"):
    """Body of a satellite, as far as it is given."""


class TemperaturesFields(SectionFields, of=Temperatures, group="temperatures"):
    """Temperatures of the parts at work, by which plastics are judged."""


class FrictionFields(SectionFields, of=Friction, group="friction"):
    """Friction and wear of pin and hole, or of pin and sleeve."""


class RollersFields(SectionFields, of=Rollers, group="rollers"):
    """Rolling bearings on the pins, whose outer rings roll in the holes."""


class ShaftBearingFields(SectionFields, of=CatalogueBearing, group="bearing"):
    """A bearing of the crankshaft."""


class BearingFields(ShaftBearingFields, of=RollingBearing, group="bearing"):
    """A rolling bearing as its catalogue gives it."""


class SeatedBearingFields(ShaftBearingFields, of=SeatedBearing, group="crankshaft"):
    """Bearing of the crankshaft, and the part that holds it."""


class CrankshaftFields(SectionFields, of=Shaft, group="crankshaft"):
    """Crankshaft with the places of its loads and bearings."""
