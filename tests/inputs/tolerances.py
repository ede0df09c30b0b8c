"""A run of tolerances that was calculated apart from this program, in first order."""

import math
from dataclasses import replace

from core.output.elasticity import LinearLaw
from core.output.mechanism import Mechanism
from core.output.real_mechanism import RealMechanism
from core.tolerance.draws import Spread
from core.tolerance.study import Evaluation, Study, ToleranceStudy, tolerance_study
from core.tolerance.tolerances import Tolerances
from tests.inputs.real_mechanisms import STEEL

ARCMIN = math.pi / 10800
REAL = RealMechanism(
    mechanism=Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0),
    pin_circle_radius=0.040,
    pin_radius=0.005,
    eccentricity=0.002,
    contact_length=0.012,
    clearance=2e-5,
    law=LinearLaw(1e8),
    pin_material=STEEL,
    hole_material=STEEL,
)
PHASE = math.radians(0.01)
TOLERANCES = Tolerances(
    pin_position=1e-5,
    hole_position=2e-5,
    pin_radius=Spread(3e-6, 7.5e-6),
    hole_radius=Spread(0.0, 9e-6),
    eccentricity=Spread(-5e-6, 5e-6),
    disc_phase=Spread(-PHASE, PHASE),
)
ASKED = Evaluation(quantities=("peak_force", "transmission_error"), output_torque=200.0)


def study(samples: int, *, exact: bool = False) -> Study:
    real = replace(REAL, exact=exact)
    return Study(real, TOLERANCES, ASKED, samples=samples, seed=7)


def run(samples: int, *, exact: bool = False) -> ToleranceStudy:
    return tolerance_study(study(samples, exact=exact))
