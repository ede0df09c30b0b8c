"""Random requests as people type them, and the exact value of every number of the answer."""

from tests.oracles.answers.bearings import SATELLITE_BEARING
from tests.oracles.answers.calculation import Calculation
from tests.oracles.answers.crank_planetary import CONTACT_FORCE, CYCLOGRAM, GEOMETRY
from tests.oracles.answers.crankshaft import CRANKSHAFT
from tests.oracles.answers.envelope import ENVELOPE
from tests.oracles.answers.fit import FIT
from tests.oracles.answers.hertz import HERTZ
from tests.oracles.answers.load_sharing import LOAD_SHARING
from tests.oracles.answers.losses import OUTPUT_EFFICIENCY
from tests.oracles.answers.mass import MASS
from tests.oracles.answers.pins import PIN_STRENGTH
from tests.oracles.answers.precession import (
    CONTACT_LINE,
    LINE_CONTACT,
    MESHING_LOAD,
    SHAFT_DEFLECTION,
    SHAFT_STRENGTH,
)
from tests.oracles.answers.ring_mesh import RING_MESH
from tests.oracles.answers.rollers import ROLLER_FATIGUE, ROLLER_STRENGTH

CALCULATIONS: tuple[Calculation, ...] = (
    CONTACT_FORCE,
    CYCLOGRAM,
    GEOMETRY,
    ENVELOPE,
    MASS,
    HERTZ,
    OUTPUT_EFFICIENCY,
    LOAD_SHARING,
    FIT,
    RING_MESH,
    PIN_STRENGTH,
    SATELLITE_BEARING,
    CRANKSHAFT,
    ROLLER_STRENGTH,
    ROLLER_FATIGUE,
    CONTACT_LINE,
    MESHING_LOAD,
    SHAFT_DEFLECTION,
    SHAFT_STRENGTH,
    LINE_CONTACT,
)
