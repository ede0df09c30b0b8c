"""Bearings of the satellites: reference numbers, balance, arrays, refusals.

Some tests hold numbers beside those of other tools' rules: a load without the pins' resultant, a
ring's radial force of one sign, a speed of ``1 - 1/u``. They must not be those.
"""

import math

import numpy as np
import pytest

from core.crank.bearing_life import rating_life, reliability_factor, system_life
from core.crank.ring_mesh import RingMesh, cycloid_mesh, involute_mesh
from core.crank.satellite_bearing import bearing_curves
from core.errors import ImpossibleMechanism, InvalidInput, NotKnown
from core.output.mechanism import Mechanism, pin_geometry
from core.precision import CONVERGED, EXACT, SAME, SEARCHED
from tests.inputs.loads import satellite_bearings

LOAD = {"output_torque": 500.0, "pin_circle_radius": 0.05, "eccentricity": 2e-3}
INVOLUTE = involute_mesh(
    module=3.5e-3, teeth_difference=1, pressure_angle=math.radians(20), eccentricity=2e-3
)
REFERENCE = LOAD | {"mesh": INVOLUTE, "input_speed": 50 * math.pi, "kind": "ball"}


def spaced(pins: int, satellites: int) -> Mechanism:
    return Mechanism.evenly_spaced(pins=pins, satellites=satellites, ratio=20.0)


REF = REFERENCE | {"mechanism": spaced(6, 2)}


def test_the_reference_design() -> None:
    found = satellite_bearings(**REF)
    assert f"{math.degrees(INVOLUTE.operating_pressure_angle):.8f}" == "34.69124260"
    for satellite in (0, 1):
        assert f"{found.min_load[satellite]:.2f}" == "11877.22"
        assert f"{found.peak_load[satellite]:.2f}" == "12645.46"
        assert f"{found.equivalent_load[satellite]:.3f}" == "12390.148"
    rollers = satellite_bearings(**REF | {"kind": "roller"})
    assert f"{rollers.equivalent_load[0]:.3f}" == "12390.851"
    assert found.relative_speed / (math.pi / 30) == pytest.approx(1575, rel=CONVERGED)
    assert found.accuracy.relative_error == pytest.approx(SEARCHED, rel=SEARCHED)
    assert found.notices == ()


def test_three_pins() -> None:
    found = satellite_bearings(**REF | {"mechanism": spaced(3, 2)})
    assert f"{found.min_load[0]:.3f}" == "10420.176"
    assert f"{found.peak_load[1]:.3f}" == "14969.137"
    assert f"{found.equivalent_load[0]:.3f}" == "12632.488"
    rollers = satellite_bearings(**REF | {"mechanism": spaced(3, 2), "kind": "roller"})
    assert f"{rollers.equivalent_load[0]:.3f}" == "12669.085"


def test_the_ring_adds_to_the_pins_or_opposes_them() -> None:
    """12 391 N with an angle of 34.7°, 16 236 N with the 54° of teeth whose tips do not meet, 7350
    to 7990 N for rings of pins: a factor of life of 4 to 6.
    """
    sizes = {"pressure_angle": math.radians(20), "eccentricity": 2e-3}
    real = involute_mesh(module=2.5e-3, teeth_difference=1, **sizes)
    assert round(math.degrees(real.operating_pressure_angle)) == 54
    found = satellite_bearings(**REF | {"kind": "roller", "mesh": real})
    assert round(found.equivalent_load[0]) == 16236
    printed = {0.5: "-0.2241421", 0.6069: "-0.2803531", 1 / 1.4: "-0.3437463", 0.8: "-0.4023632"}
    involute = satellite_bearings(**REF | {"kind": "roller"}).equivalent_load[0]
    for k, ratio in printed.items():
        mesh = cycloid_mesh(eccentricity=2e-3, ratio=20.0, ring_pin_circle_radius=0.042 / k)
        assert f"{mesh.radial_force_ratio:.7f}" == ratio
        load = satellite_bearings(**REF | {"kind": "roller", "mesh": mesh}).equivalent_load[0]
        assert 7340 < load < 8000
        assert 4 < (involute / load) ** (10 / 3) < 6
        unsigned = RingMesh(-mesh.radial_force_ratio)
        wrong = satellite_bearings(**REF | {"kind": "roller", "mesh": unsigned})
        assert wrong.equivalent_load[0] > 1.2 * load


def test_teeth_by_their_base_circles() -> None:
    """cos(alpha_w) = a/a_w*cos(alpha) with the centre distance a of the reference circles."""
    for difference, module, distance in ((1, 3.5e-3, 2e-3), (3, 1e-3, 1.6e-3), (4, 1e-3, 2e-3)):
        mesh = involute_mesh(
            module=module,
            teeth_difference=difference,
            pressure_angle=math.radians(20),
            eccentricity=distance,
        )
        wider = math.acos(module * difference / 2 / distance * math.cos(math.radians(20)))
        assert mesh.operating_pressure_angle == pytest.approx(wider, rel=CONVERGED)
        assert mesh.radial_force_ratio == pytest.approx(math.tan(wider), rel=CONVERGED)
    teeth = {"module": 4e-3, "teeth_difference": 1, "eccentricity": 2e-3}
    assert involute_mesh(**teeth, pressure_angle=0.0).radial_force_ratio == 0
    for name in teeth:
        wrong = teeth | {name: 0.0}
        assert refusal(involute_mesh, **wrong, pressure_angle=0.3) == (name, "greater_than")


def test_the_ratio_of_a_cycloid_by_quadrature() -> None:
    """Radial over tangential of pins that share as linear contacts do, over half of the ring."""
    theta = (np.arange(200_000) + 0.5) * math.pi / 200_000
    for k in (1e-3, 0.1, 0.499, 0.501, 0.9):
        # arm l = sin(theta)/root of a pin's normal about the pitch point's centre, over e*(u + 1)
        root = np.sqrt(1 + k * k - 2 * k * np.cos(theta))
        arm, radial = np.sin(theta) / root, (np.cos(theta) - k) / root
        ratio = (arm * radial).sum() / (arm * arm).sum()
        mesh = cycloid_mesh(eccentricity=k, ratio=1.0, ring_pin_circle_radius=2.0)
        assert mesh.radial_force_ratio == pytest.approx(ratio, rel=EXACT, abs=1e-10)


def test_a_published_bearing_load() -> None:
    """kubakos: 1970.68 N with the pins' resultant of 1712.178 N, 1695.7 N without it."""
    across, along, pins = 1599.968, 561.667, 1712.178
    assert math.hypot(across, pins - along) == pytest.approx(1970.68, abs=0.01)
    assert math.hypot(across, along) == pytest.approx(1695.7, abs=0.05)
    assert along / across == pytest.approx(0.351049, abs=1e-6)
    mesh = cycloid_mesh(eccentricity=1.250025e-3, ratio=29.0, ring_pin_circle_radius=0.0525)
    assert mesh.radial_force_ratio == pytest.approx(-0.343755, abs=1e-6)


def test_the_pins_press_along_the_crank() -> None:
    """All normals of a satellite are parallel to its crank: their sum is a sum of sizes."""
    mechanism = spaced(5, 2)
    for angle in (0.1, 1.0, 2.5):
        positions = pin_geometry(
            mechanism=mechanism,
            crank_angle=angle,
            pin_circle_radius=0.05,
            pin_radius=0.008,
            hole_radius=0.010,
            eccentricity=0.002,
        )
        normals = positions.hole_centres - positions.pin_centres
        crank = np.array([math.sin(angle), math.cos(angle)])
        for satellite, sign in ((0, 1), (1, -1)):
            for normal in normals[satellite]:
                assert normal / 0.002 == pytest.approx(sign * crank, abs=1e-12)


def test_curves_are_the_loads() -> None:
    design = LOAD | {"mechanism": spaced(3, 2), "radial_force_ratio": -0.3}
    angles = np.linspace(0, 2 * math.pi, 20_001)
    curves = bearing_curves(**design, crank_angle=angles)
    found = satellite_bearings(**REFERENCE | {"mechanism": spaced(3, 2), "mesh": RingMesh(-0.3)})
    assert curves.load.max(axis=0) == pytest.approx(found.peak_load, rel=SEARCHED)
    assert curves.load.min(axis=0) == pytest.approx(found.min_load, rel=1e-3)
    torque = 2e-3 * 20 * curves.across.sum(axis=1)
    assert torque == pytest.approx(500.0, rel=SAME)


@pytest.mark.parametrize("rho", [0.7, -0.3, 3.0])
def test_the_error_of_the_ring_is_in_that_of_the_loads(rho: float) -> None:
    found = satellite_bearings(**REF | {"mesh": RingMesh(rho, error=1e-6)})
    moved = satellite_bearings(**REF | {"mesh": RingMesh(rho * (1 + 1e-6))})
    off = np.abs(moved.equivalent_load / found.equivalent_load - 1).max()
    assert max(off, 1e-6) <= found.accuracy.relative_error < 1e-5
    lasting = REF | {"mesh": RingMesh(rho, error=1e-6), "dynamic_rating": 60e3}
    lives = satellite_bearings(**lasting)
    assert lives.accuracy.relative_error == pytest.approx(
        3 * found.accuracy.relative_error, rel=SEARCHED
    )


def test_life() -> None:
    ratings = {"dynamic_rating": 60e3, "static_rating": 50e3}
    found = satellite_bearings(**REF, **ratings, weibull_slope=10 / 9)
    millions = (60e3 / found.equivalent_load[0]) ** 3
    assert found.basic_life[0] / 3600 == pytest.approx(millions * 1e6 / (60 * 1575), rel=CONVERGED)
    assert found.life.tolist() == found.basic_life.tolist()
    assert found.static_safety_factor[1] == pytest.approx(50e3 / found.peak_load[1], rel=CONVERGED)
    assert found.system_life == pytest.approx(found.basic_life[0] * 2 ** (-0.9), rel=CONVERGED)
    with pytest.raises(NotKnown) as unrated:  # before the slope is asked for
        _ = satellite_bearings(**REF).system_life
    assert unrated.value.missing == ("bearing.dynamic_rating",)
    surer = satellite_bearings(**REF, **ratings, reliability_percent=99.0)
    assert surer.life[0] == 0.25 * found.life[0]
    factor = satellite_bearings(**REF, **ratings, ring_factor=1.2)
    assert factor.life[0] == pytest.approx(found.life[0] / 1.2**3, rel=CONVERGED)
    assert factor.static_safety_factor[0] == found.static_safety_factor[0]
    with pytest.raises(NotKnown, match="rating_unknown"):
        _ = satellite_bearings(**REF).life
    still = satellite_bearings(**REF | {"input_speed": None}, **ratings)
    for name in ("relative_speed", "basic_life", "life"):
        with pytest.raises(NotKnown, match="speed_missing"):
            getattr(still, name)
    assert f"{91.1e3 / 10.279e3:.2f}" == "8.86"
    assert rating_life(load=10.279, rating=91.08767, kind="roller") == pytest.approx(
        1440, rel=SEARCHED
    )
    lives = np.array([[100.0, 200.0], [1.0, 1e9]])
    together = system_life(lives=lives, weibull_slope=1.5)
    assert together == pytest.approx([(100**-1.5 + 200**-1.5) ** (-1 / 1.5), 1.0], rel=SAME)
    slopes = system_life(lives=lives, weibull_slope=np.array([1.0, 3.0]))
    assert slopes == pytest.approx([200 / 3, 1.0], rel=SAME)
    # one that outlasts the other by far takes nothing from it
    assert system_life(lives=np.array([7.0, 1e200]), weibull_slope=2.0) == 7.0


def test_arrays_are_the_designs_one_by_one() -> None:
    torque = np.array([[100.0], [500.0], [900.0]])
    eccentricity = np.array([1.8e-3, 2e-3, 2.5e-3, 4e-3])
    rho = involute_mesh(
        module=3.5e-3,
        teeth_difference=1,
        pressure_angle=math.radians(20),
        eccentricity=eccentricity,
    )
    ring = cycloid_mesh(
        eccentricity=eccentricity, ratio=20.0, ring_pin_circle_radius=np.array([0.1, 0.2, 0.09, 1])
    )
    for mesh in (rho, ring):
        many = satellite_bearings(
            **REF
            | {"output_torque": torque, "eccentricity": eccentricity, "mesh": mesh}
            | {"dynamic_rating": np.array([3e4, 4e4, 5e4, 6e4]), "weibull_slope": 1.2}
        )
        assert many.peak_load.shape == (3, 4, 2)
        for i, j in np.ndindex(3, 4):
            one = satellite_bearings(
                **REF
                | {"output_torque": float(torque[i, 0]), "eccentricity": float(eccentricity[j])}
                | {"mesh": RingMesh(float(mesh.radial_force_ratio[j]))}
                | {"dynamic_rating": 1e4 * (j + 3), "weibull_slope": 1.2}
            )
            for name in ("peak_load", "min_load", "equivalent_load", "peak_ring_force"):
                assert getattr(many, name)[i, j] == pytest.approx(getattr(one, name), rel=CONVERGED)
            assert many.basic_life[i, j] == pytest.approx(one.basic_life, rel=SAME)
            assert many.system_life[i, j] == pytest.approx(one.system_life, rel=SAME)


def refusal(call, **change) -> tuple[str, str]:
    with pytest.raises(InvalidInput) as refused:
        call(**change)
    return refused.value.parameter, refused.value.code


def test_what_cannot_be_is_refused() -> None:
    teeth = {"module": 4.5e-3, "teeth_difference": 1, "pressure_angle": math.radians(20)}
    assert refusal(involute_mesh, **teeth, eccentricity=2e-3) == ("eccentricity", "no_mesh")
    least = 4.5e-3 * math.cos(math.radians(20)) / 2
    with pytest.raises(InvalidInput) as refused:
        involute_mesh(**teeth, eccentricity=np.array([3e-3, 2e-3]))
    assert refused.value.parameter == "eccentricity[1]"
    assert refused.value.params["limit"] == pytest.approx(least)
    involute_mesh(**teeth, eccentricity=least)
    with pytest.raises(InvalidInput) as refused:
        involute_mesh(**teeth | {"module": np.array([1e-3, 4.5e-3])}, eccentricity=2e-3)
    assert refused.value.params["limit"] == pytest.approx(least)
    ring = {"eccentricity": 2e-3, "ratio": 20.0}
    name = "ring_pin_circle_radius"
    assert refusal(cycloid_mesh, **ring, ring_pin_circle_radius=0.042) == (name, "no_cycloid")
    for size in (*ring, name):
        wrong = ring | {name: 0.1} | {size: 0.0}
        assert refusal(cycloid_mesh, **wrong) == (size, "greater_than")
    assert refusal(satellite_bearings, **REF | {"input_speed": -1.0}) == (
        "input_speed",
        "greater_than_equal",
    )
    for name in ("eccentricity", "peak_torque", "static_rating"):
        assert refusal(satellite_bearings, **REF | {name: 0.0}) == (name, "greater_than")
    odd = {"reliability_percent": 92.0}
    assert refusal(satellite_bearings, **REF | odd) == ("reliability_percent", "not_in_table")
    life = {"load": 1.0, "rating": 1.0, "kind": "ball"}
    for name in ("load", "rating"):
        assert refusal(rating_life, **life | {name: 0.0}) == (name, "greater_than")
    slope = {"lives": np.ones(2), "weibull_slope": 0.0}
    assert refusal(system_life, **slope) == ("weibull_slope", "greater_than")
    printed = {90.0: 1.0, 95.0: 0.64, 96.0: 0.55, 97.0: 0.47, 98.0: 0.37, 99.0: 0.25}
    assert {each: reliability_factor(percent=each) for each in printed} == printed
    with pytest.raises(ImpossibleMechanism):
        satellite_bearings(**REFERENCE, mechanism=spaced(2, 1))


def test_steep_teeth_are_noticed() -> None:
    teeth = {"module": 2e-3, "teeth_difference": 1, "pressure_angle": math.radians(20)}
    for eccentricity, codes in ((1.62e-3, []), (1.65e-3, ["steep_mesh"])):
        mesh = involute_mesh(**teeth, eccentricity=eccentricity)
        found = satellite_bearings(**REF | {"eccentricity": eccentricity, "mesh": mesh})
        assert [each.code for each in found.notices] == codes
