"""Arrays of designs against the same designs one by one."""

import math
import uuid
from dataclasses import fields
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.contact_force import force_ratios
from core.designs.compiled import compiling
from core.designs.hertz import Solids, hertz_contacts
from core.designs.peak_force import peak_forces
from core.designs.roller_strength import roller_strengths
from core.errors import InvalidInput
from core.hertz import hertz
from core.materials import ElasticMaterial
from core.mechanism import Mechanism
from core.peak_force import peak_force
from core.roller_strength import roller_strength

settings.register_profile("no deadline", deadline=None)
settings.load_profile("no deadline")

GENERATOR = np.random.default_rng

EXPONENTS = (0.0, 0.06, 0.3, 1.0, 1.001, 1.02, 10 / 9, 1.5, 3.0, 4.01, 30.0)


def mechanisms(seed: int, count: int = 60) -> dict[str, Any]:
    """Random designs; some with cranks on a grid of 15 degrees, where phases coincide."""
    random = GENERATOR(seed)
    pins, satellites = int(random.integers(3, 13)), int(random.integers(1, 6))
    angles = random.uniform(-7, 7, (count, satellites))
    angles[::3] = random.integers(0, 24, angles[::3].shape) * math.pi / 12
    angles[1::6] = np.arange(satellites) * 2 * math.pi / satellites
    return {
        "pins": pins,
        "crank_angles": angles,
        "ratio": random.uniform(0.1, 100, count),
        "force_exponent": random.choice(EXPONENTS, count),
        "initial_crank_angle": random.choice([0.0, math.pi, 1.2345], count),
    }


def each_of(designs: dict[str, Any]) -> list[Mechanism]:
    return [
        Mechanism(
            pins=designs["pins"],
            crank_angles=tuple(angles.tolist()),
            ratio=float(designs["ratio"][i]),
            initial_crank_angle=float(designs["initial_crank_angle"][i]),
        )
        for i, angles in enumerate(designs["crank_angles"])
    ]


@pytest.mark.parametrize("seed", range(40))
def test_peaks_of_arrays_are_those_of_each_design(seed: int) -> None:
    designs = mechanisms(seed)
    found = peak_forces(**designs)
    for i, mechanism in enumerate(each_of(designs)):
        exponent = float(designs["force_exponent"][i])
        one = peak_force(mechanism=mechanism, force_exponent=exponent)
        error = found.relative_error[i] + one.accuracy.relative_error
        assert found.peak_force_ratio[i] == pytest.approx(one.peak_force_ratio, rel=error, abs=0)
        assert found.relative_error[i] < 1e-11
        assert found.peak_crank_angle[i] == pytest.approx(one.peak_crank_angle, abs=1e-6)
        assert (found.peak_satellite[i], found.peak_pin[i]) == (one.peak_satellite, one.peak_pin)
        assert found.evaluations[i] > 0


@pytest.mark.parametrize("seed", range(40, 50))
def test_no_sampled_force_exceeds_the_peak(seed: int) -> None:
    designs = mechanisms(seed, count=20)
    found = peak_forces(**designs)
    for i, mechanism in enumerate(each_of(designs)):
        period = mechanism.crank_angle_per_wave
        forces = force_ratios(
            mechanism=mechanism,
            crank_angles=np.linspace(0, period, 4001),
            force_exponent=float(designs["force_exponent"][i]),
        )
        assert forces.max() <= found.peak_force_ratio[i] * (1 + 1e-12)
        assert forces.max() >= found.peak_force_ratio[i] * 0.95


def test_large_exponents_are_right_to_their_stated_error() -> None:
    for exponent in (1e3, 1e5, 1e6):
        angles = GENERATOR(3).uniform(0, 6, (50, 3))
        found = peak_forces(
            pins=5,
            crank_angles=angles,
            ratio=np.full(50, 20.0),
            force_exponent=np.full(50, exponent),
            initial_crank_angle=np.zeros(50),
        )
        for i, cranks in enumerate(angles.tolist()):
            one = peak_force(
                mechanism=Mechanism(pins=5, crank_angles=tuple(cranks), ratio=20.0),
                force_exponent=exponent,
            )
            error = found.relative_error[i] + one.accuracy.relative_error
            assert error < 1e-7
            ratio = one.peak_force_ratio
            assert found.peak_force_ratio[i] == pytest.approx(ratio, rel=error, abs=0)


def test_arrays_of_two_pins_and_wrong_exponents_are_refused() -> None:
    one = {"ratio": np.ones(1), "initial_crank_angle": np.zeros(1), "crank_angles": np.ones((1, 1))}
    with pytest.raises(InvalidInput, match="pins"):
        peak_forces(pins=2, force_exponent=np.ones(1), **one)
    for exponent in (-0.1, 1.1e6, math.nan):
        with pytest.raises(InvalidInput, match=r"force_exponent\[0\]"):
            peak_forces(pins=3, force_exponent=np.full(1, exponent), **one)
    for name, value in (("ratio", 0.0), ("crank_angles", math.nan), ("ratio", math.inf)):
        wrong = one | {name: np.full_like(one[name], value)}
        with pytest.raises(InvalidInput, match=rf"{name}\[0\]"):
            peak_forces(pins=3, force_exponent=np.ones(1), **wrong)


@pytest.mark.parametrize("fewest", [1, 7, 30, 60])
def test_shared_out_designs_are_the_same(monkeypatch: pytest.MonkeyPatch, fewest: int) -> None:
    designs = mechanisms(3)
    alone = peak_forces(**designs)
    monkeypatch.setattr("core.designs.peak_force.FEWEST_A_THREAD", fewest)
    monkeypatch.setattr("os.cpu_count", lambda: 5)
    shared = peak_forces(**designs)
    for field in fields(alone):
        assert (getattr(shared, field.name) == getattr(alone, field.name)).all()


def test_no_designs_are_no_answers() -> None:
    none = np.zeros(0)
    found = peak_forces(
        pins=3,
        crank_angles=np.zeros((0, 2)),
        ratio=none,
        force_exponent=none,
        initial_crank_angle=none,
    )
    assert found.peak_force_ratio.shape == (0,)


@settings(max_examples=50)
@given(st.integers(0, 2**32))
def test_contacts_of_arrays_are_those_of_each_design(seed: int) -> None:
    random, count = GENERATOR(seed), 20
    pin_radius = 10.0 ** random.uniform(-5, 1, count)
    sizes = {
        "force": 10.0 ** random.uniform(-3, 9, count)
        * random.choice([0.0, 1.0], count, p=[0.1, 0.9]),
        "contact_length": 10.0 ** random.uniform(-4, 0, count),
        "pin_radius": pin_radius,
        "hole_radius": pin_radius * (1 + 10.0 ** random.uniform(-9, 3, count)),
        "dynamic_factor": random.uniform(0.5, 3, count),
        "distribution_factor": random.uniform(0.5, 3, count),
    }
    pins, holes = (
        Solids(
            youngs_modulus=random.choice([70e9, 210e9], count),
            poissons_ratio=random.choice([0.3, 0.33], count),
            allowable_pressure=random.choice([math.nan, 1.1e9, 1.5e9], count),
        )
        for _ in range(2)
    )
    found = hertz_contacts(**sizes, pin_material=pins, hole_material=holes)
    for i in range(count):
        one = hertz(
            **{name: float(values[i]) for name, values in sizes.items()},
            pin_material=material(pins, i),
            hole_material=material(holes, i),
        )
        for field in fields(one):
            value = getattr(one, field.name)
            if field.name not in ("accuracy", "notices"):
                expected = math.nan if value is None else value
                got = getattr(found, field.name)[i]
                assert got == pytest.approx(expected, rel=4e-15, abs=0, nan_ok=True), field.name
        assert found.relative_error[i] == pytest.approx(one.accuracy.relative_error)
        assert abs(found.evaluations[i] - one.accuracy.evaluations) <= 1


def material(solids: Solids, i: int) -> ElasticMaterial:
    allowable = float(solids.allowable_pressure[i])
    return ElasticMaterial(
        youngs_modulus=float(solids.youngs_modulus[i]),
        poissons_ratio=float(solids.poissons_ratio[i]),
        allowable_pressure=None if math.isnan(allowable) else allowable,
    )


def test_wrong_entries_of_arrays_are_named() -> None:
    one = np.ones(3)
    steel = Solids(210e9 * one, 0.3 * one, math.nan * one)
    good = {
        "force": one,
        "contact_length": one,
        "pin_radius": one,
        "hole_radius": 2 * one,
        "dynamic_factor": one,
        "distribution_factor": one,
    }
    for name, value in (("force", -1.0), ("pin_radius", 0.0), ("hole_radius", 1.0)):
        wrong = good[name].copy()
        wrong[1] = value
        with pytest.raises(InvalidInput, match=rf"{name}\[1\]"):
            hertz_contacts(**(good | {name: wrong}), pin_material=steel, hole_material=steel)


@settings(max_examples=50)
@given(st.integers(0, 2**32))
def test_rollers_of_arrays_are_those_of_each_design(seed: int) -> None:
    random, count = GENERATOR(seed), 20
    rollers = int(random.integers(1, 9))
    sizes = {
        "output_torque": 10.0 ** random.uniform(-2, 4, count),
        "hole_circle_radius": random.uniform(0.01, 1, count),
        "cylinder_length": random.uniform(0.001, 0.1, count),
        "sphere_width": random.uniform(0.001, 0.03, count),
        "sphere_diameter": random.uniform(0.001, 0.03, count),
        "diameter": random.uniform(0.001, 0.03, count),
        "friction_coefficient": random.uniform(0, 1, count),
        "youngs_modulus": random.uniform(1e9, 3e11, count),
        "stress_concentration": random.uniform(1, 3, count),
    }
    gaps = 10.0 ** random.uniform(-8, -4) * random.integers(0, 6, (count, rollers))
    ratio = random.uniform(0.0, 0.49, count)
    found = roller_strengths(**sizes, modulus_ratio=2 * (1 + ratio), gaps=gaps)
    for i in range(count):
        one = roller_strength(
            **{name: float(values[i]) for name, values in sizes.items()},
            rollers=rollers,
            poissons_ratio=float(ratio[i]),
            gaps=gaps[i].tolist(),
        )
        largest = one.max_force
        for field in fields(one):
            if field.name in ("accuracy", "notices"):
                continue
            got, expected = getattr(found, field.name)[i], getattr(one, field.name)
            room = 1e-14 * largest if field.name == "forces" else 0.0
            assert got == pytest.approx(expected, rel=1e-14, abs=room), field.name
        assert found.relative_error[i] == pytest.approx(one.accuracy.relative_error)


def made_of(what: str) -> Any:
    @compiling.whole
    def one_more(number: float) -> float:
        what  # noqa: B018
        return number + 1

    return one_more


def test_what_is_compiled_is_kept_until_its_sources_change() -> None:
    first, second = str(uuid.uuid4()), str(uuid.uuid4())
    for what, hits in ((first, 0), (first, 1), (second, 0)):
        function = made_of(what)
        assert function(1.0) == 2.0
        assert sum(function.stats.cache_hits.values()) == hits


def test_without_a_place_on_disk_it_is_compiled_all_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    njit = compiling.numba.njit

    def nowhere(*args: object, cache: bool = False, **options: object) -> object:
        if cache:
            raise RuntimeError("no locator available")
        return njit(*args, **options)

    monkeypatch.setattr(compiling.numba, "njit", nowhere)
    assert made_of("anything")(1.0) == 2.0
