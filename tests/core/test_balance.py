"""Balance of the crankshaft: reference numbers, point masses, what bearings feel, the checks."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.checks.reserve import crank_verdict
from core.crank.balance import Balance, Counterweight, balance
from core.crank.crankshaft import reaction_curves
from core.crank.ring_mesh import RingMesh
from core.crank.satellite_bearing import bearing_curves
from core.design.curves import design_bearings, design_reactions
from core.design.document import Design
from core.design.results import Results
from core.design.sections import SeatedBearing, Shaft
from core.errors import InvalidInput, NotKnown
from core.output.mechanism import Mechanism
from core.output.room import Deviations
from core.output.sampled_turn import SampledTurn
from core.precision import EXACT, SAME
from tests.inputs.checks import WHOLE, check_of, having, says
from tests.inputs.loads import crankshaft, satellite_bearings
from tests.inputs.satellites import mechanisms
from tests.oracles.satellites import forces

SPEED = 50 * math.pi
PLACE = {"bearing_positions": (0.0, 0.062), "input_speed": SPEED}


def opposite(unbalance: float, position: float, degrees: float = 180.0) -> Counterweight:
    return Counterweight(unbalance * 1e-3, position * 1e-3, math.radians(degrees))


def of(degrees: tuple[float, ...], places: tuple[float, ...], **changes: Any) -> Balance:
    """Satellites of 1.5 kg on cranks of 2 mm at 1500 rpm, their places in mm."""
    given: dict[str, Any] = PLACE | {
        "satellite_mass": 1.5,
        "eccentricity": 2e-3,
        "crank_angles": tuple(map(math.radians, degrees)),
        "satellite_positions": tuple(each * 1e-3 for each in places),
    }
    return balance(**given | changes)


REFERENCE: dict[str, tuple[Balance, float, float, tuple[float, float]]] = {
    "one disc": (of((0,), (31,)), 74.0220330081702, 0.0, (37.0110165040851, 37.0110165040851)),
    "a weight opposite": (
        of((0,), (31,), counterweights=(opposite(3.0, 31),)), 0.0, 0.0, (0.0, 0.0)
    ),
    "two weights beside it": (
        of((0,), (31,), counterweights=(opposite(1.4, 10), opposite(1.4, 50))),
        4.934802200544684,
        0.06908723080762558,
        (1.353090925955804, 3.58171127458888),
    ),
    "two discs": (
        of((0, 180), (20, 42)), 0.0, 1.6284847261797442, (26.265882680318455, 26.265882680318455)
    ),
    "three discs and two weights": (
        of(
            (0, 120, 240),
            (15, 30, 45),
            satellite_mass=1.2,
            eccentricity=2.5e-3,
            bearing_positions=(0.0, 0.060),
            input_speed=1800 * math.pi / 30,
            counterweights=(opposite(1.0, 5, 30), opposite(1.0, 55, 210)),
        ),
        0.0,
        4.545863108469415,
        (75.76438514115692, 75.76438514115692),
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", REFERENCE)
def test_reference_numbers(case: str) -> None:
    """Computed apart from this program, by point masses that move."""
    found, force, couple, bearings = REFERENCE[case]
    assert found.force == pytest.approx(force, rel=SAME, abs=1e-12)
    assert found.couple == pytest.approx(couple, rel=SAME, abs=1e-12)
    assert found.bearing_force == pytest.approx(bearings, rel=SAME, abs=1e-12)
    if not force:
        assert found.force == 0.0 == found.unbalance == found.grade


weights = st.lists(
    st.tuples(st.floats(0, 5), st.floats(-40, 120), st.floats(-360, 360)), max_size=3
)


@given(mechanism=mechanisms, some=weights, rotor=st.none() | st.floats(0.1, 50))
def test_it_is_that_of_point_masses(
    mechanism: Mechanism, some: list[tuple[float, float, float]], rotor: float | None
) -> None:
    """Accelerations by differences of places in the fixed frame, moments by cross products."""
    count, first, last = mechanism.satellites, -0.01, 0.09
    places = tuple(0.01 + 0.022 * j for j in range(count))
    added = tuple(opposite(*each) for each in some)
    found = balance(
        satellite_mass=1.5,
        eccentricity=2e-3,
        crank_angles=mechanism.crank_angles,
        satellite_positions=places,
        bearing_positions=(first, last),
        counterweights=added,
        input_speed=SPEED,
        rotor_mass=rotor,
    )
    masses = [(1.5, 2e-3, a, z) for a, z in zip(mechanism.crank_angles, places, strict=True)]
    masses += [(each.unbalance, 1.0, each.angle, each.position) for each in added]
    step = 1e-4 / SPEED
    force, moment, scale = np.zeros(3), np.zeros(3), 0.0
    for m, r, angle, z in masses:
        at = [
            r * np.array([math.cos(angle + turned), math.sin(angle + turned)])
            for turned in (-SPEED * step, 0.0, SPEED * step)
        ]
        pull = np.append(-m * (at[0] - 2 * at[1] + at[2]) / step**2, 0.0)
        force += pull
        moment += np.cross([0, 0, z - (first + last) / 2], pull)
        scale += np.linalg.norm(pull)
    rough = 1e-6 * scale
    assert found.force == pytest.approx(np.linalg.norm(force), abs=rough)
    assert found.couple == pytest.approx(np.linalg.norm(moment), abs=rough)
    assert found.unbalance * SPEED**2 == pytest.approx(found.force, rel=SAME)
    mass = rotor or 1.5 * count
    assert found.grade * SPEED * mass == pytest.approx(found.force, rel=SAME)
    # the bearings hold force and moment: R_A + R_B + F = 0
    held = [np.array([each.real, each.imag, 0.0]) for each in found.reaction]
    assert held[0] + held[1] == pytest.approx(-force, abs=rough)
    half = (last - first) / 2
    turned = np.cross([0, 0, -half], held[0]) + np.cross([0, 0, half], held[1])
    assert turned == pytest.approx(-moment, abs=rough)
    assert found.bearing_force == pytest.approx([np.linalg.norm(each) for each in held], abs=rough)


def test_what_cannot_be_is_refused() -> None:
    for changes, name in (
        ({"counterweights": (opposite(-1.0, 31),)}, "counterweights[0].unbalance"),
        ({"rotor_mass": 0.0}, "rotor_mass"),
        ({"satellite_mass": 0.0}, "satellite_mass"),
        ({"bearing_positions": (0.1, 0.0)}, "bearing_positions[1]"),
    ):
        with pytest.raises(InvalidInput) as refused:
            of((0,), (31,), **changes)
        assert refused.value.parameter == name
    with pytest.raises(InvalidInput) as refused:
        of((0, 180), (31,))
    assert refused.value.code == "different_length"


def test_the_centrifugal_force_relieves_the_bearing_of_a_satellite() -> None:
    """W 6250 and S 6000 N, rho 0.692127, of 1.5 kg at 3000 rpm: 296.088 N of 11 818 N."""
    across, along, arm = 6250.0, 6000.0, 0.04
    wave = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    turn = SampledTurn(
        wave=wave,
        on_pins=np.full((1, 1, 12), 1000.0 + 0j),
        on_satellites=np.full((1, 12), along + 0j),
        total=np.full(12, 1000.0),
        couple=np.full((1, 12), across * arm),
        crank_angles=(0.0,),
        error=0.0,
        evaluations=12,
        unlike=1,
    )
    pull = 1.5 * 2e-3 * (100 * math.pi) ** 2
    assert pull == pytest.approx(296.0881320326808, rel=SAME)
    found = satellite_bearings(
        mechanism=Mechanism.evenly_spaced(pins=6, satellites=1, ratio=20.0),
        output_torque=across * arm,
        pin_circle_radius=0.05,
        eccentricity=2e-3,
        mesh=RingMesh(0.692127),
        centrifugal=pull,
        kind="ball",
        static_rating=40e3,
        made=lambda torque: turn,
    )
    assert found.peak_load[0] == pytest.approx(11817.677216064298, rel=SAME)
    assert found.equivalent_load[0] == pytest.approx(11817.677216064298, rel=SAME)
    at_rest = math.hypot(across, 0.692127 * across + along)
    assert found.static_safety_factor[0] == pytest.approx(40e3 / at_rest, rel=SAME)


LOAD = {"output_torque": 500.0, "pin_circle_radius": 0.05, "eccentricity": 2e-3}


@given(
    mechanism=mechanisms,
    mass=st.floats(0.1, 200),
    some=weights,
    rho=st.floats(-1.5, 1.5),
    factor=st.floats(0, 1),
)
def test_bearings_by_brute_force(
    mechanism: Mechanism,
    mass: float,
    some: list[tuple[float, float, float]],
    rho: float,
    factor: float,
) -> None:
    """Forces and moments with vectors, at many angles; the satellites' own bearings too."""
    count, first, last = mechanism.satellites, -0.01, 0.09
    z = 0.01 + 0.022 * np.arange(count)
    added = tuple(opposite(*each) for each in some)
    more = 1 + factor * (count - 1)
    places = {"satellite_positions": tuple(z.tolist()), "bearing_positions": (first, last)}
    spun = balance(
        satellite_mass=mass,
        eccentricity=2e-3,
        crank_angles=mechanism.crank_angles,
        **places,
        counterweights=added,
        input_speed=SPEED,
    )
    shaft = crankshaft(
        **LOAD,
        **places,
        mechanism=mechanism,
        mesh=RingMesh(rho),
        distribution_factor=more,
        balance=spun,
    )
    psi = (np.arange(4_000) + 0.5) * 2 * np.pi / 4_000
    pins, shares = forces(mechanism, 1.0, psi)
    pull = mass * 2e-3 * SPEED**2
    weight, other = [], []
    peak = np.zeros(2)
    for one in range(count):
        carries = np.full(count, (count - more) / (count - 1) if count > 1 else 1.0)
        carries[one] = more
        force, moment = np.zeros((len(psi), 3)), np.zeros((len(psi), 3))
        for j, angle in enumerate(mechanism.crank_angles):
            out = np.array([math.cos(angle), math.sin(angle), 0.0])
            w, s = carries[j] * 12_500 * shares[j], carries[j] * 10_000 * pins[j]
            own = -np.outer(w, np.cross([0, 0, 1], out)) - np.outer(rho * w + s - pull, out)
            force += own
            moment += np.cross([0, 0, z[j] - first], own)
            (weight if j == one else other).append(np.linalg.norm(own, axis=1))
        for each in added:
            way = np.array([math.cos(each.angle), math.sin(each.angle), 0.0])
            own = each.unbalance * SPEED**2 * way
            force += own
            moment += np.cross([0, 0, each.position - first], own)
        at_last = np.cross([0, 0, 1], moment) / (last - first)
        held = np.linalg.norm([-force - at_last, at_last], axis=2)
        peak = np.maximum(peak, held.max(axis=1))
    rough = 2e-3 * (12_500 + 10_000 + pull)
    assert shaft.peak_reaction == pytest.approx(peak, abs=rough)
    found = satellite_bearings(
        **LOAD,
        mechanism=mechanism,
        mesh=RingMesh(rho),
        distribution_factor=more,
        centrifugal=pull,
        kind="ball",
        dynamic_rating=60e3,
        static_rating=40e3,
        input_speed=SPEED,
        weibull_slope=1.2,
    )
    for row, loads in enumerate(weight):
        assert found.peak_load[row] == pytest.approx(loads.max(), rel=1e-3, abs=rough)
        mean = (loads**3).mean() ** (1 / 3)
        assert found.equivalent_load[row] == pytest.approx(mean, rel=1e-3, abs=rough)
    if more == 1:
        return
    assert found.min_load.min() == pytest.approx(min(map(np.min, other)), abs=rough)
    assert found.system_life <= found.life.min() * (1 + 1e-12)


def test_curves_are_what_is_judged() -> None:
    angles = np.linspace(0, 2 * math.pi * 20, 20_001)
    heavy = replace(
        WHOLE.crankshaft, satellite_mass=30.0, counterweights=(opposite(20.0, 5.0, 40.0),)
    )  # type: ignore[type-var]
    for design in (
        having(WHOLE, crankshaft=heavy, pin=None, fatigue=None),
        having(WHOLE, crankshaft=heavy, pin=None, fatigue=None, distribution_factor=1.4),
        having(WHOLE, crankshaft=heavy),
    ):
        results = Results(design)
        curves = design_bearings(results=results, crank_angle=angles)
        peak = results.crank.bearings.peak_load
        assert curves.load.max(axis=0) == pytest.approx(peak, rel=1e-4)
        reactions = np.abs(design_reactions(results=results, crank_angle=angles).reaction)
        peak = results.crank.shaft.peak_reaction
        assert reactions.max(axis=0) == pytest.approx(peak, rel=1e-4)


def test_curves_of_a_shaft_of_which_nothing_is_known_are_not_known() -> None:
    still = having(WHOLE, pin=None, fatigue=None, input_speed=None)
    with pytest.raises(NotKnown) as raised:
        design_reactions(results=Results(still), crank_angle=np.zeros(1))
    assert raised.value.missing == ("load.input_speed",)


def test_curves_of_loads_have_no_balance_of_their_own() -> None:
    mechanism = Mechanism.evenly_spaced(pins=6, satellites=2, ratio=20.0)
    angles = np.array([0.1, 0.7])
    loads = bearing_curves(**LOAD, mechanism=mechanism, radial_force_ratio=0.7, crank_angle=angles)
    places = {"satellite_positions": (0.02, 0.042), "bearing_positions": (0.0, 0.062)}
    own = {"loads": loads, "crank_angles": mechanism.crank_angles, **places}
    spun = of((0, 180), (20, 42))
    added = (
        reaction_curves(**own, unbalanced=np.array(spun.reaction)).reaction
        - reaction_curves(**own).reaction
    )
    assert added == pytest.approx(np.broadcast_to(spun.reaction, added.shape), rel=EXACT)


SIZES = {"bore_diameter": 0.03, "outer_diameter": 0.09, "width": 0.023}


def single(*counterweights: Counterweight, **changes: Any) -> Design:
    """One satellite of 1.5 kg in the middle of the bearings."""
    shaft = Shaft(
        satellite_positions=(0.031,),
        bearing_positions=(0.0, 0.062),
        satellite_mass=changes.pop("satellite_mass", 1.5),
        counterweights=counterweights,
        rotor_mass=changes.pop("rotor_mass", None),
        bearings=(SeatedBearing(kind="ball", dynamic_rating=40e3, **SIZES),) * 2,
    )
    pin = replace(WHOLE.pin, satellite_positions=(0.015,))  # type: ignore[type-var]
    return having(WHOLE, satellites=1, output_torque=250.0, crankshaft=shaft, pin=pin, **changes)


def test_without_a_demand_the_usual_grade_is_a_guide() -> None:
    """G 16 of 1.5 kg at 1500 rpm: 16e-3*1.5*w = 3.77 N, of 74.02; of 29.5 kg it is enough."""
    limit = 16e-3 * 1.5 * SPEED
    found = check_of("unbalance_force", single())
    says(
        found,
        status="marginal",
        value=74.0220330081702,
        limit=limit,
        utilisation=74.0220330081702 / limit,
        warning=True,
        reason="unbalanced",
    )
    assert found.limit_source == "balance_guide" and found.torque_reserve is None
    enough = 74.0220330081702 / 16e-3 / SPEED
    for mass, status in ((enough * 1.001, "pass"), (enough * 0.999, "marginal")):
        assert check_of("unbalance_force", single(rotor_mass=mass)).status == status
    assert check_of("unbalance_force", single(opposite(3.0, 31))).status == "pass"


def test_a_couple_has_no_guide() -> None:
    for design in (WHOLE, having(WHOLE, balance_grade=0.2)):
        couple = check_of("unbalance_couple", design)
        assert couple.value == pytest.approx(1.6284847261797442, rel=EXACT)
        assert (couple.status, couple.reason) == ("not_asked", "no_limit")
    for most, status in ((1.63, "pass"), (1.62, "fail")):
        asked = having(WHOLE, max_unbalance_couple=most)
        assert check_of("unbalance_couple", asked).status == status


@pytest.mark.parametrize(
    ("demands", "status", "limit"),
    [
        ({"max_unbalance": 75.0}, "pass", 75.0),
        ({"max_unbalance": 70.0}, "fail", 70.0),
        ({"balance_grade": 0.32}, "pass", 0.32 * 1.5 * SPEED),
        ({"balance_grade": 0.31}, "fail", 0.31 * 1.5 * SPEED),
        ({"max_unbalance": 75.0, "balance_grade": 0.31}, "fail", 0.31 * 1.5 * SPEED),
        ({"max_unbalance": 70.0, "balance_grade": 0.32}, "fail", 70.0),
    ],
)
def test_what_is_asked_is_judged(demands: dict[str, float], status: str, limit: float) -> None:
    found = check_of("unbalance_force", single(**demands))
    assert (found.status, found.limit_source) == (status, "user")
    assert found.limit == pytest.approx(limit, rel=SAME)
    assert not found.warning


def test_a_share_of_what_the_mechanism_does_may_be_asked() -> None:
    """The worst bearing decides: force and couple have equal parts of their limits."""
    still = Results(single(satellite_mass=None)).crank.shaft.peak_reaction
    own = 74.0220330081702 / 2 / still.max()
    for share, status in ((own * 1.001, "pass"), (own * 0.999, "fail")):
        found = check_of("unbalance_force", single(max_unbalance_share=share))
        assert found.status == status
        assert found.utilisation == pytest.approx(own / share, rel=EXACT)
    two = having(WHOLE, crankshaft=replace(WHOLE.crankshaft, satellite_mass=None))  # type: ignore[type-var]
    still = Results(two).crank.shaft.peak_reaction
    most = (26.265882680318455 / still).max()
    asked = having(WHOLE, max_unbalance_share=most * 1.01)
    couple = check_of("unbalance_couple", asked)
    assert couple.utilisation == pytest.approx(1 / 1.01, rel=EXACT) and couple.status == "pass"
    assert check_of("unbalance_force", asked).status == "pass"
    failing = having(WHOLE, max_unbalance_share=most * 0.99)
    assert check_of("unbalance_couple", failing).status == "fail"


def test_what_is_not_known_is_not_asked_unless_it_is() -> None:
    deviating = having(WHOLE, deviations=Deviations(crank_phase=(1e-3, 0.0)))
    for design, reason, missing in (
        (single(satellite_mass=None), "mass_unknown", ("crankshaft.satellite_mass",)),
        (having(WHOLE, crankshaft=None), "mass_unknown", ("crankshaft.satellite_mass",)),
        (single(input_speed=None), "speed_missing", ("load.input_speed",)),
        (deviating, "cranks_deviate", ()),
    ):
        for code in ("unbalance_force", "unbalance_couple"):
            found = check_of(code, design)
            says(found, status="not_asked", value=None, reason=reason, missing=missing)
        for demand in ({"max_unbalance": 1.0}, {"max_unbalance_share": 0.1}):
            asked = check_of("unbalance_force", having(design, **demand))
            assert (asked.status, asked.reason) == ("not_checked", reason) and asked.opens
    even = Deviations(pin_radius=(1e-6,) * 6, crank_phase=(0.0, 0.0))
    assert check_of("unbalance_force", having(WHOLE, deviations=even)).value == 0.0


def test_a_single_disc_with_a_counterweight_passes() -> None:
    """Alone its bearings are marginal, by their balance."""
    scope = ("crank_bearings",)
    for weights, status in (((), "marginal"), ((opposite(3.0, 31),), "pass")):
        verdict = crank_verdict(Results(single(*weights, scope=scope, life=3600.0)))
        assert verdict.verdict == status
        assert {each.code: each.status for each in verdict.parts}["crank_bearings"] == status
    opposite_forces = Results(single(opposite(3.0, 31))).crank.shaft
    alone = Results(single(satellite_mass=None)).crank.shaft
    assert opposite_forces.peak_reaction == pytest.approx(alone.peak_reaction, rel=EXACT)
