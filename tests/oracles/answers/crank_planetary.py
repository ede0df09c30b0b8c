"""Output mechanism: peak force, cyclogram, geometry; angles in degrees and turns."""

from itertools import pairwise
from typing import Any

from mpmath import mp, mpf

from tests.oracles.answers.calculation import (
    GIVEN,
    Body,
    Calculation,
    Draw,
    Number,
    Numbers,
    typed,
)
from tests.oracles.crank_planetary import peak

EXPONENTS = (0.0, 1.0, 1.0, 1.11, 1.5)
EXTREME_EXPONENTS = (0.0, 1e-9, 0.3, 1.0, 1.0, 1.01, 10 / 9, 1.5, 3.0, 20.0, 120.0, 500.0)


def mechanism(r: Draw) -> Body:
    """Evenly spaced cranks in half of all cases; extremes coincide nearly, or nearly stop."""
    pins = r.choice((1, 2, 2, 3, 4, 5, 6, r.randint(3, 20))) if r.extreme else r.randint(3, 12)
    satellites = r.randint(1, 5 if r.extreme else 3)
    body: Body = {"pins": pins, "satellites": satellites}
    if r.chance(0.3):
        teeth = r.randint(10, 100)
        body |= {"satellite_teeth": teeth, "ring_teeth": teeth + r.randint(1, 4)}
    else:
        body["ratio"] = r.power(1, 1e6) if r.extreme else r.decimal(5, 100)
    kind = r.random()
    if kind > 0.75:
        body["crank_spacing_deg"] = r.choice((90.0, 120.0, 180.0, r.decimal(1, 359)))
    elif kind > 0.5 and not r.extreme:
        body["crank_angles_deg"] = [r.decimal(0, 360) for _ in range(satellites)]
    elif kind > 0.2 and r.extreme:
        body["crank_angles_deg"] = cranks(r, pins, satellites)
    if r.chance(0.3):
        body["initial_crank_angle_deg"] = r.choice((180.0, r.decimal(-3600, 3600)))
    return body


def cranks(r: Draw, pins: int, satellites: int) -> list[float]:
    """Crank angles a trifle from a place where something changes, some of them turns away; with one
    or two pins mostly beside a dead centre.
    """
    step = 180 / pins
    base = r.choice((0.0, r.decimal(-360, 360)))
    opposite = [base, base + 180, base + 90, base + 180, base][:satellites]
    places = (
        opposite
        if pins < 3 and r.chance(0.6)
        else r.choice(
            (
                [step * r.randint(0, 2 * pins) for _ in range(satellites)],
                [base] * satellites,
                [base + 360 * j / satellites for j in range(satellites)],
                opposite,
                [15 * r.randrange(24) for _ in range(satellites)],
                [r.decimal(0, 360) for _ in range(satellites)],
            )
        )
    )
    trifle = r.choice((0.0, 10 ** r.uniform(-12, -1)))
    far = r.choice((0, 0, 0, 360, -3240))
    return [place + far * r.randint(0, 1) + trifle * r.uniform(-1, 1) for place in places]


def angles(body: Body) -> list[mpf]:
    """Crank angles, degrees."""
    if "crank_angles_deg" in body:
        return [typed(angle) for angle in body["crank_angles_deg"]]
    spacing = body.get("crank_spacing_deg")
    step = mpf(360) / body["satellites"] if spacing is None else typed(spacing)
    return [step * j for j in range(body["satellites"])]


def ratio(body: Body) -> mpf:
    """u, as such or by the teeth."""
    if "ratio" in body:
        return typed(body["ratio"])
    return mpf(body["satellite_teeth"]) / (body["ring_teeth"] - body["satellite_teeth"])


def contact_force(r: Draw) -> Body:
    body = mechanism(r)
    body["pin_circle_radius_mm"] = r.size(10, 200)
    if r.chance(0.6):
        body["output_torque_Nm"] = r.size(1, 1e4)
    else:
        body |= {"input_torque_Nm": r.size(1, 1e3), "efficiency": r.decimal(0.5, 1)}
    body["force_exponent"] = r.choice(EXPONENTS)
    if r.extreme:
        body["force_exponent"] = r.choice((*EXTREME_EXPONENTS, r.power(1e-3, 500)))
    asked = ("equal_sharing", "approximation")
    return body | {"include": [name for name in asked if r.chance(0.3)]}


def forces(body: Body, answer: Any) -> Numbers:
    """The peak by a search at 40 digits over the turn."""
    torque = (
        typed(body["output_torque_Nm"])
        if "output_torque_Nm" in body
        else (typed(body["input_torque_Nm"]) * ratio(body) * typed(body["efficiency"]))
    )
    reference = 1000 * torque / typed(body["pin_circle_radius_mm"])
    cranks = [mp.radians(angle) for angle in angles(body)]
    exponent = typed(body["force_exponent"])
    exact = peak(body["pins"], cranks, exponent, screened=True).ratio
    found = {
        "/reference_force_N": Number(answer["reference_force_N"], reference),
        "/peak_force_N": Number(answer["peak_force_N"], reference * exact),
        "/peak_force_ratio": Number(answer["peak_force_ratio"], exact),
    }
    if "equal_sharing" in body["include"]:
        equal = exact if exponent == 0 else peak(body["pins"], cranks, mpf(0), screened=True).ratio
        found["/equal_sharing_peak_N"] = Number(answer["equal_sharing_peak_N"], reference * equal)
    if "approximation" in body["include"]:
        pins, satellites = body["pins"], body["satellites"]
        near = (mpf("0.8") + mpf("0.05") * pins) ** (2 - satellites) * 4 / (satellites * pins)
        found["/approximate_peak_N"] = Number(answer["approximate_peak_N"], reference * near)
        error = answer["approximate_peak_error"]
        found["/approximate_peak_error"] = Number(error, near / exact - 1, mpf(1))
    return found


def cyclogram(r: Draw) -> Body:
    body = mechanism(r)
    pairs, waves = body["pins"] * body["satellites"], 1 + 1 / float(ratio(body))
    turns = r.power(1e-3, 10) if r.extreme else r.choice((1.0, 1.0, 2.0, 0.5))
    longest = r.rounded(300 / pairs / waves)
    return body | ({} if turns == 1 < longest else {"revolutions": min(turns, longest)})


def phases(body: Body, answer: Any) -> Numbers:
    """Every angle against the nearest at which its pair, or any, starts or stops to drive.

    A pair at ``p`` turns of the wave drives while the fraction of p lies above 1/2. The sum of its
    driving phases is held against the exact one, so that none may be missing.
    """
    wave = 360 / (1 + 1 / ratio(body))
    end = 360 * typed(body.get("revolutions", 1.0))
    start = typed(body.get("initial_crank_angle_deg", 0.0)) / 360
    pins = body["pins"]
    places = [
        [start + angle / 360 + mpf(pin) / pins for pin in range(pins)] for angle in angles(body)
    ]

    def beside(angle: float, phase: mpf) -> mpf:
        """The angle nearest to this one at which a pair of this phase changes."""
        return (mp.nint(2 * (angle / wave + phase)) / 2 - phase) * wave

    def bounded(angle: float, *own: mpf) -> Number:
        if angle == 0:
            return Number(angle, mpf(0), end)
        changes = [beside(angle, phase) for phase in own]
        return Number(angle, min((*changes, end), key=lambda change: abs(change - angle)), end)

    def driven(phase: mpf) -> mpf:
        """Angle through which a pair drives, in all: of each whole turn of the wave half."""
        total = mpf(0)
        for place, sign in ((end / wave + phase, 1), (phase, -1)):
            whole = mp.floor(place)
            total += sign * (whole / 2 + max(place - whole - mpf("0.5"), 0))
        return total * wave

    def driving(angle: mpf) -> int:
        return sum(
            (position := angle / wave + phase) - mp.floor(position) > 0.5
            for row in places
            for phase in row
        )

    found = {
        "/working_phase_deg": Number(answer["working_phase_deg"], wave / 2, end),
        "/period_deg": Number(answer["period_deg"], wave, end),
        "/mean_driving": Number(answer["mean_driving"], mpf(pins * len(places)) / 2),
    }
    repeats = mp.nint(wave / pins / answer["pattern_period_deg"])
    found["/pattern_period_deg"] = Number(answer["pattern_period_deg"], wave / pins / repeats, end)
    for index, pair in enumerate(answer["pairs"]):
        phase, total = places[pair["satellite"] - 1][pair["pin"] - 1], mpf(0)
        for place, ends in enumerate(pair["driving_deg"]):
            total += mpf(ends[1]) - mpf(ends[0])
            for side, angle in enumerate(ends):
                found[f"/pairs/{index}/driving_deg/{place}/{side}"] = bounded(angle, phase)
        found[f"/pairs/{index}/total"] = Number(total, driven(phase), end)
    different = {phase - mp.floor(phase) for row in places for phase in row}
    for index, each in enumerate(answer["driving_count"]):
        for side in ("from_deg", "to_deg"):
            found[f"/driving_count/{index}/{side}"] = bounded(each[side], *different)
        # not in the middle, where often one pair takes over from another
        width = mpf(each["to_deg"]) - mpf(each["from_deg"])
        inside = mpf(each["from_deg"]) + width / mp.e
        # both ends may be off by what is stated
        known = width > 4 * answer["accuracy"]["relative_error"] * end
        exact = mpf(driving(inside)) if known else mpf(each["pairs"])
        found[f"/driving_count/{index}/pairs"] = Number(each["pairs"], exact, mpf(1))
    for index, angle in enumerate(answer["dead_centres_deg"]):
        found[f"/dead_centres_deg/{index}"] = bounded(angle, *different)
    for index, zone in enumerate(answer.get("dead_zones_deg", ())):
        for side, angle in enumerate(zone):
            found[f"/dead_zones_deg/{index}/{side}"] = bounded(angle, *different)
    return found | _extremes(answer, pins, different, driving, wave)


def _extremes(answer: Any, pins: int, phases: set[mpf], driving: Any, wave: mpf) -> Numbers:
    """Fewest and most driving pairs over a sector, where parts of it narrower than 1e-11 turns may
    count or not.
    """
    sector = mpf(1) / pins
    edges = sorted({(side - phase) % sector for phase in phases for side in (mpf(0), mpf("0.5"))})
    edges.append(edges[0] + sector)
    parts = [
        (b - a, driving((a + b) / 2 * wave)) for a, b in pairwise(edges) if b - a > mpf(10) ** -30
    ]
    wide = [count for width, count in parts if width > 1e-11]
    every = [count for _, count in parts]
    found = {}
    for name, least, most in (
        ("min_driving", min(every), min(wide)),
        ("max_driving", max(wide), max(every)),
    ):
        exact = mpf(max(least, min(answer[name], most)))
        found[f"/{name}"] = Number(answer[name], exact, mpf(1))
    return found


def geometry(r: Draw) -> Body:
    body = mechanism(r)
    pin = r.size(2, 20)
    e = r.size(0.5, 5)
    limit = 3600 if r.extreme else 360
    return {
        "mechanism": body,
        "load": {"output_torque_Nm": 100.0, "pin_circle_radius_mm": r.size(20, 200)},
        "contact": {
            "contact_length_mm": 10.0,
            "pin_radius_mm": pin,
            "hole_radius_mm": float(f"{pin + e:.15g}"),
            "eccentricity_mm": e,
        },
        "crank_angle_deg": r.decimal(-limit, limit),
        "include": ["geometry"],
    }


def coordinates(body: Body, answer: Any) -> Numbers:
    """Centres of pins and holes, contact points: over the size of the figure."""
    given, contact = body["mechanism"], body["contact"]
    circle, pin = typed(body["load"]["pin_circle_radius_mm"]), typed(contact["pin_radius_mm"])
    e = typed(contact["eccentricity_mm"])
    size = circle + pin + e
    turned = typed(body["crank_angle_deg"])
    start = typed(given.get("initial_crank_angle_deg", 0.0))
    found = {}

    def put(pointer: str, sent: list[float], exact: tuple[mpf, mpf]) -> None:
        for axis in (0, 1):
            found[f"{pointer}/{axis}"] = Number(sent[axis], exact[axis], size)

    cranks = angles(given)
    centres = []
    for index, each in enumerate(answer["pins"]):
        angle = mp.radians(turned / ratio(given) + mpf(360) * (each["pin"] - 1) / given["pins"])
        centres.append((-circle * mp.sin(angle), circle * mp.cos(angle)))
        put(f"/pins/{index}/centre_mm", each["centre_mm"], centres[-1])
    for index, pair in enumerate(answer["pairs"]):
        x, y = centres[pair["pin"] - 1]
        crank = mp.radians(turned + start + cranks[pair["satellite"] - 1])
        dx, dy = mp.sin(crank), mp.cos(crank)
        put(f"/pairs/{index}/hole_centre_mm", pair["hole_centre_mm"], (x + e * dx, y + e * dy))
        touch = (x - pin * dx, y - pin * dy)
        put(f"/pairs/{index}/contact_point_mm", pair["contact_point_mm"], touch)
    return found


NUMBERS = {"/pairs/*/satellite": GIVEN, "/pairs/*/pin": GIVEN}

CONTACT_FORCE = Calculation(
    "Contact force",
    "contact-force",
    contact_force,
    forces,
    unbounded={
        "/peak_crank_angle_deg": "where the peak is; known to the root of its error",
        "/peak_pair/satellite": GIVEN,
        "/peak_pair/pin": GIVEN,
    },
)
CYCLOGRAM = Calculation(
    "Cyclogram",
    "cyclogram",
    cyclogram,
    phases,
    unbounded=NUMBERS
    | {
        "/assembly/*/satellite": GIVEN,
        "/assembly/*/hole_rotation_deg": "no bound is stated",
    },
)
GEOMETRY = Calculation(
    "Pin geometry",
    "crank-planetary",
    geometry,
    coordinates,
    part=("geometry",),
    unbounded=NUMBERS
    | {
        "/pins/*/pin": GIVEN,
        "/pairs/*/force_N": "no bound is stated",
        "/pairs/*/pressure_angle_deg": "no bound is stated",
        "/clearance_mm": "no bound is stated",
    },
)
