"""Mechanisms with clearance, deviations and elasticity, as tests draw them."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache

from hypothesis import strategies as st

from core.hertz import ElasticMaterial
from core.output.elasticity import (
    RIGID_PINS,
    ConformalLaw,
    ContactLaw,
    CrankSupport,
    ElasticMesh,
    HertzLaw,
    LinearLaw,
    PalmgrenLaw,
    Pins,
    PinSupport,
    PowerLaw,
    Shares,
)
from core.output.loaded_position import LoadedPosition, loaded_position
from core.output.mechanism import Mechanism
from core.output.pin_fatigue import FatigueStrength
from core.output.real_mechanism import RealMechanism
from core.output.real_turn import sampled
from core.output.room import Deviations
from core.output.sampled_turn import SampledTurn
from core.output.turn import Turn

STEEL = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3)
LAWS: list[ContactLaw] = [
    LinearLaw(1e8),
    PowerLaw(0.5, 1000.0, 1e-5),
    PowerLaw(10 / 9, 1000.0, 1e-5),
    PowerLaw(3.0, 1000.0, 1e-5),
    PalmgrenLaw(),
    HertzLaw(),
    ConformalLaw(),
]
SPAN = 0.05


def real_turn(*, real: RealMechanism, output_torque: float) -> SampledTurn:
    """The forces of a mechanism under a torque, N*m."""
    return sampled(Turn(real, output_torque))


def made(real: RealMechanism) -> Callable[[float], SampledTurn]:
    """Forces on the mechanism as made under any torque, each sampled once."""
    return cache(lambda torque: real_turn(real=real, output_torque=torque))


@st.composite
def reals(draw: st.DrawFn, exact: bool | None = None, powers: bool = False) -> RealMechanism:
    """Three pins or more with toleranced errors, clearance and any law."""
    pins, satellites = draw(st.integers(3, 7)), draw(st.integers(1, 3))
    size = st.floats(-1e-5, 1e-5)
    row = st.tuples(*[size] * pins)
    table = st.tuples(*[row] * satellites)
    each = st.tuples(*[size] * satellites)
    angles = st.tuples(*[st.floats(-5e-4, 5e-4)] * satellites)
    deviations = Deviations(
        *(draw(row) for _ in range(3)),
        *(draw(table) for _ in range(3)),
        draw(each),
        draw(angles),
        draw(angles),
    )
    pin: Pins = RIGID_PINS
    if not powers and satellites == 1 and draw(st.booleans()):
        places = tuple(SPAN * (j + 1) / (satellites + 1) for j in range(satellites))
        support = draw(st.sampled_from(["cantilever", "supported", "fixed"]))
        pin = PinSupport(support, 0.010, places, STEEL, SPAN)
    return RealMechanism(
        mechanism=Mechanism.evenly_spaced(
            pins=pins, satellites=satellites, ratio=draw(st.floats(2.0, 90.0))
        ),
        pin_circle_radius=0.040,
        pin_radius=0.005,
        eccentricity=0.002,
        contact_length=0.012,
        law=draw(st.sampled_from(LAWS[:5] if powers else LAWS)),
        clearance=draw(st.sampled_from([0.0, 1e-6, 3e-5, 2e-4, -1e-5])),
        pin_material=STEEL,
        hole_material=STEEL,
        pin=pin,
        deviations=draw(st.sampled_from([deviations, Deviations()])),
        exact=draw(st.booleans()) if exact is None else exact,
    )


@st.composite
def held(draw: st.DrawFn) -> RealMechanism:
    """Satellites that give, from stiff to soft, or given shares of the torque."""
    real = draw(reals())
    kind = draw(st.sampled_from([CrankSupport, ElasticMesh, Shares]))
    if kind is CrankSupport:
        loose = draw(st.sampled_from([0.0, 1e-6, 2e-5]))
        return replace(real, support=CrankSupport(10.0 ** draw(st.floats(8, 18)), loose))
    if kind is ElasticMesh:
        return replace(real, support=ElasticMesh(10.0 ** draw(st.floats(4, 15))))
    weights = [draw(st.floats(0.2, 1.0)) for _ in range(real.mechanism.satellites)]
    return replace(real, support=Shares(tuple(weight / sum(weights) for weight in weights)))


crank_angles = st.floats(0.0, 6.28)
torques = st.sampled_from([1e-4, 1.0, 200.0, -1.0, -200.0])


def solved(real: RealMechanism, angle: float, torque: float) -> LoadedPosition:
    return loaded_position(real=real, crank_angle=angle, output_torque=torque)


def flat(position: LoadedPosition) -> list[float]:
    return [force for row in position.force for force in row]


def design(**changes: object) -> RealMechanism:
    kept: dict = {
        "mechanism": Mechanism.evenly_spaced(pins=8, satellites=1, ratio=18.0),
        "pin_circle_radius": 0.020,
        "pin_radius": 0.003,
        "eccentricity": 0.0015,
        "contact_length": 0.010,
        "clearance": 2e-5,
        "law": LinearLaw(5e7),
        "pin_material": STEEL,
        "hole_material": STEEL,
    }
    return RealMechanism(**kept | changes)


PIN_STEEL = ElasticMaterial(youngs_modulus=210e9, poissons_ratio=0.3, yield_strength=800e6)
STRENGTH = FatigueStrength(endurance_limit=300e6, tensile_strength=1000e6)
PIN = {
    "output_torque": 500.0,
    "pin_circle_radius": 0.05,
    "diameter": 0.016,
    "contact_length": 0.02,
    "material": PIN_STEEL,
    "fatigue": STRENGTH,
}
REFERENCE = PIN | {
    "mechanism": Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0),
    "satellite_positions": (0.015, 0.037),
}
"""Pins of a reference design, as arguments of `pin_strength`."""

UNLIKE = RealMechanism(
    mechanism=Mechanism.evenly_spaced(pins=4, satellites=2, ratio=20.0),
    pin_circle_radius=0.05,
    pin_radius=0.008,
    eccentricity=2e-3,
    contact_length=0.02,
    law=LinearLaw(1e8),
    pin_material=PIN_STEEL,
    hole_material=PIN_STEEL,
    clearance=1e-5,
    exact=True,
    deviations=Deviations(
        pin_radial=(4e-6, -2e-6, 5e-6, 0.0),
        pin_tangential=(-6e-6, 3e-6, 0.0, 2e-6),
        pin_radius=(1e-6, 0.0, -2e-6, 1e-6),
        hole_radial=((3e-6, 0.0, -4e-6, 2e-6), (-1e-6, 5e-6, 2e-6, 0.0)),
        hole_tangential=((-5e-6, 1e-6, 0.0, 2e-6), (0.0, -3e-6, 4e-6, 1e-6)),
        hole_radius=((1e-6, 2e-6, 0.0, -1e-6), (0.0, 1e-6, -2e-6, 1e-6)),
        eccentricity=(4e-6, -3e-6),
        crank_phase=(-3e-4, 2e-4),
        disc_phase=(5e-5, -8e-5),
    ),
)
"""Pins and holes, cranks and discs, none as the next."""
