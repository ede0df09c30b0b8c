"""Outlines of involute teeth against the tools that cut them, and teeth that are put together."""

import math
from dataclasses import replace

import numpy as np
import pytest

from core.arrays import ComplexArray, FloatArray
from core.design.drawings import drawn_ring, drawn_satellites
from core.design.results import Results
from core.design.ring import InvoluteRing
from core.errors import ImpossibleMechanism, InvalidInput
from core.precision import SAME
from core.ring.involute import Cutter, InvolutePair, InvoluteTeeth, Rack, involute_pair
from core.ring.tooth_outline import ring_outline, satellite_outline
from tests.inputs.checks import design_of

TEETH = InvoluteTeeth(
    satellite_teeth=40,
    ring_teeth=42,
    module=3e-3,
    satellite_profile_shift=0.1,
    ring_profile_shift=0.46,
    satellite_addendum=0.8,
    ring_addendum=0.8,
    cutter=Cutter(20, 0.1, 1.2),
)
SHAPES = [
    TEETH,
    replace(TEETH, rack=Rack(math.radians(25), 1.2, 0.2), satellite_profile_shift=-0.2),
    replace(TEETH, rack=Rack(math.radians(20), 1.25, 0.0), satellite_profile_shift=1.3,
            ring_profile_shift=1.66),
]  # fmt: skip
FINE = 1e-8


def pair_of(teeth: InvoluteTeeth) -> InvolutePair:
    return involute_pair(teeth=teeth)


def points_of(outline: FloatArray) -> ComplexArray:
    found: ComplexArray = outline @ np.array([1, 1j])
    return found


def off_rack(points: ComplexArray, teeth: InvoluteTeeth, rolled: FloatArray) -> FloatArray:
    """How far points of a satellite are from a tooth of the rack that rolls on it, m, shape
    (points, places): that is what lies so near to a smaller one.
    """
    rack, m = teeth.rack, teeth.module
    pitch, alpha = m * teeth.satellite_teeth / 2, rack.pressure_angle
    deep = (rack.dedendum - rack.tip_radius) * m
    half = math.pi / 4 * m - deep * math.tan(alpha) - rack.tip_radius * m / math.cos(alpha)
    there = points[:, None] * np.exp(-1j * rolled)
    x = np.abs(there.real - pitch * rolled) - half
    u = teeth.satellite_profile_shift * m + pitch - there.imag - deep
    beside = x * math.cos(alpha) + u * math.sin(alpha)
    along = x * math.sin(alpha) - u * math.cos(alpha)
    found = np.where(along >= 0, beside, np.where(x <= 0, u, np.hypot(x, u)))
    return found - rack.tip_radius * m


@pytest.mark.parametrize("teeth", SHAPES)
def test_a_satellite_is_what_its_rack_leaves(teeth: InvoluteTeeth) -> None:
    """No point lies in the rack, and all but those at the tips touch it somewhere."""
    pair = pair_of(teeth)
    points = points_of(satellite_outline(pair=pair, chord_error=1e-6).points)
    half = points[: len(points) // 2]
    off = off_rack(half, teeth, np.linspace(-0.35, 0.35, 20001)).min(axis=1)
    cut = np.abs(half) < teeth.satellite_tip * (1 - 1e-12)
    assert off.min() > -1e-12 and cut.sum() > 15
    assert off[cut].max() < 2e-8
    assert np.abs(half).max() == pytest.approx(teeth.satellite_tip, rel=SAME)


@pytest.mark.parametrize("teeth", SHAPES[:2])
def test_a_ring_is_what_its_cutter_leaves(teeth: InvoluteTeeth) -> None:
    """The cutter has the flanks of a satellite with its number of teeth and a deep enough rack."""
    pair, cutter = pair_of(teeth), teeth.cutter
    assert cutter is not None
    own = replace(
        teeth,
        satellite_teeth=cutter.teeth,
        ring_teeth=cutter.teeth + 2,
        satellite_profile_shift=cutter.profile_shift,
        satellite_addendum=cutter.addendum,
        ring_profile_shift=cutter.profile_shift + 0.5,
        ring_addendum=0.5,
        cutter=None,
    )
    tool = points_of(satellite_outline(pair=pair_of(own), chord_error=FINE).points)
    tool = tool * np.exp(1j * math.pi / cutter.teeth)  # a tooth is up
    ends = np.append(tool, tool[0] * np.exp(-2j * math.pi / cutter.teeth))
    half = points_of(ring_outline(pair=pair, chord_error=2e-6).points)
    half = half[: len(half) // 2]
    distance = pair.ring_root_radius - own.satellite_tip
    nearest = np.full(len(half), np.inf)
    for turned in np.linspace(-0.35, 0.35, 1501):
        ring = half * np.exp(-1j * turned * cutter.teeth / teeth.ring_teeth) - 1j * distance
        near, side = apart(ring * np.exp(1j * turned), ends)
        assert not ((side > 0) & (near > 1e-8)).any()
        nearest = np.minimum(nearest, near)
    cut = np.abs(half) > teeth.ring_tip * (1 + 1e-12)
    assert cut.sum() > 10 and nearest[cut].max() < 3e-7


def apart(points: ComplexArray, line: ComplexArray) -> tuple[FloatArray, FloatArray]:
    """How far points are from an open line, and on which side of it they lie: 1 to the right, where
    a clockwise outline has its inside, -1 to the left, 0 off its corners.
    """
    sides, away = np.diff(line), points[:, None] - line[:-1]
    along = np.clip((away / sides).real, 0, 1)
    off = np.abs(away - along * sides)
    rows, best = np.arange(len(points)), off.argmin(axis=1)
    there = along[rows, best]
    side = -np.sign((away[rows, best] / sides[best]).imag)
    return off[rows, best], np.where((there > 0) & (there < 1), side, 0.0)


@pytest.mark.parametrize("teeth", SHAPES)
def test_teeth_and_spaces_are_as_wide_as_their_shifts_say(teeth: InvoluteTeeth) -> None:
    """On the reference circles: a tooth of the satellite, a space of the ring."""
    pair, tangent = pair_of(teeth), math.tan(teeth.rack.pressure_angle)
    for outline, count, shift in (
        (satellite_outline, teeth.satellite_teeth, teeth.satellite_profile_shift),
        (ring_outline, teeth.ring_teeth, teeth.ring_profile_shift),
    ):
        points = points_of(outline(pair=pair, chord_error=FINE).points)
        half, reference = points[: len(points) // 2], teeth.module * count / 2
        if not np.abs(half).min() < reference < np.abs(half).max():
            continue
        order = np.argsort(np.abs(half))
        turned = np.arctan2(half.real, half.imag)[order]
        at = float(np.interp(reference, np.abs(half)[order], turned))
        wide = teeth.module * (math.pi / 2 + 2 * shift * tangent)
        space = 2 * reference * at
        pitch = math.pi * teeth.module
        known = space if outline is ring_outline else pitch - space
        assert known == pytest.approx(wide, abs=1e-7)


@pytest.mark.parametrize("teeth", [TEETH, replace(TEETH, cutter=None)])
def test_the_stated_error_is_that_of_the_polygon(teeth: InvoluteTeeth) -> None:
    """A much finer one is as far from it, and no farther."""
    for outline in (satellite_outline, ring_outline):
        rough, fine = (outline(pair=pair_of(teeth), chord_error=each) for each in (5e-6, FINE))
        line = points_of(rough.points)
        line = np.append(line, line[0] * np.exp(-2j * math.pi / rough.teeth))
        off, _ = apart(points_of(fine.points), line)
        assert 0.5 * rough.chord_error < off.max() <= rough.chord_error <= 5.001e-6


def test_teeth_that_are_put_together_do_not_cross() -> None:
    """Satellites stand in the ring so that half of the backlash is on either side."""
    angles = (0.0, 2.0, 4.1)
    design = design_of(
        pins=8,
        satellites=3,
        crank_angles=angles,
        initial_crank_angle=0.3,
        ratio=20.0,
        output_torque=200.0,
        pin_circle_radius=0.037,
        contact_length=0.022,
        pin_radius=0.007,
        hole_radius=0.0107,
        eccentricity=0.00368,
        gear=InvoluteRing(
            module=3e-3,
            teeth_difference=2,
            reference_pressure_angle=math.radians(20),
            satellite_profile_shift=0.1,
            ring_profile_shift=0.48,
            satellite_addendum=0.75,
            ring_addendum=0.8,
            cutter_teeth=20,
        ),
    )
    backlash = Results(design).ring.pair.normal_backlash
    ring = points_of(drawn_ring(design=design, chord_error=1e-7).outline)
    for each, angle in zip(
        drawn_satellites(design=design, numbers=(1, 2, 3), chord_error=1e-7), angles, strict=True
    ):
        own = points_of(each.outline) + complex(*each.centre)
        crank = 1j * np.exp(-1j * (angle + 0.3))
        about = np.roll(ring, -int((ring / crank).real.argmin()))
        near, about = (
            points[np.abs(np.angle(points / crank)) < wide]
            for points, wide in ((own, 0.6), (about, 0.7))
        )
        off, side = apart(near, about)
        assert side.min() >= 0 and side.max() == 1
        assert 2 * off.min() == pytest.approx(backlash, abs=3e-7)


def test_what_has_no_outline_is_refused() -> None:
    undercut = replace(
        TEETH, satellite_teeth=12, ring_teeth=14, satellite_profile_shift=0.0, cutter=None
    )
    pointed = replace(TEETH, satellite_profile_shift=1.5, ring_profile_shift=1.9,
                      satellite_addendum=1.2)  # fmt: skip
    for teeth in (undercut, pointed):
        with pytest.raises(ImpossibleMechanism, match="no outline"):
            satellite_outline(pair=pair_of(teeth), chord_error=1e-6)
    with pytest.raises(InvalidInput) as caught:
        satellite_outline(pair=pair_of(TEETH), chord_error=1e-12)
    limit = float(caught.value.params["limit"])  # type: ignore[arg-type]
    found = satellite_outline(pair=pair_of(TEETH), chord_error=limit)
    assert len(found.points) * 40 <= 200_000
