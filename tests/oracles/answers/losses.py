"""Friction of the pins: mm, N, W, and rpm."""

from typing import Any

from mpmath import mp, mpf

from tests.oracles.answers.calculation import Body, Calculation, Draw, Number, Numbers, typed
from tests.oracles.answers.crank_planetary import (
    EXPONENTS,
    EXTREME_EXPONENTS,
    angles,
    mechanism,
    ratio,
)
from tests.oracles.crank_planetary import peak
from tests.oracles.losses import total

USUAL_LIFE = 5000.0
"""Life of a design that requires none, hours."""

HAIR = 1e-9
"""Cranks that differ from a place of coincident switching by less than this, degrees, but not by
nothing, are not asked: which ranges are too short to count is not what is tested here."""


def request(r: Draw) -> Body:
    """A design, with sleeves in a third of all cases, with wear in half."""
    own = mechanism(r)
    while by_a_hair(own):
        own = mechanism(r)
    load: Body = {"pin_circle_radius_mm": r.size(10, 200), "input_speed_rpm": r.size(10, 3000)}
    if r.chance(0.6):
        load["output_torque_Nm"] = r.size(1, 1e4)
    else:
        load |= {"input_torque_Nm": r.size(1, 1e3), "efficiency": r.decimal(0.5, 1)}
    load["force_exponent"] = r.choice(EXTREME_EXPONENTS if r.extreme else EXPONENTS)
    contact = {
        "contact_length_mm": r.size(5, 50),
        "pin_radius_mm": r.size(3, 20),
        "eccentricity_mm": r.size(0.5, 5),
    }
    if r.chance(0.3):
        radius = contact["pin_radius_mm"] + contact["eccentricity_mm"] * r.uniform(0.9, 1.0)
        if contact["pin_radius_mm"] < radius < 1e12:
            contact["hole_radius_mm"] = radius
    friction: Body = {"coefficient": r.choice((0.0, 0.08, r.decimal(0.001, 0.3)))}
    if r.chance(0.5):
        friction |= {"wear_rate_mm3_per_Nm": r.size(1e-9, 1e-5), "life_h": r.size(100, 2e4)}
    body: Body = {"mechanism": own, "load": load, "contact": contact, "friction": friction}
    if r.chance(0.3):
        friction["sleeve"] = True
        inner = max(contact["pin_radius_mm"] * r.uniform(0.5, 1.9), 1e-12)
        body["pin"] = {"diameter_mm": inner}
    if "life_h" in friction and r.chance(0.5):
        del friction["life_h"]
        if r.chance(0.5):
            body["requirements"] = {"life_h": r.size(100, 2e4)}
    return body


def by_a_hair(body: Body) -> bool:
    """True if pairs of two satellites switch at almost, but not just, one place."""
    step = mpf(180) / body["pins"]
    places = [angle % step for angle in angles(body)]
    return any(
        0 < min(off := abs(one - other), step - off) < HAIR for one in places for other in places
    )


def numbers(body: Body, answer: Any) -> Numbers:
    """By definition, with the sum of the forces integrated and searched."""
    own, load, contact, friction = (
        body[name] for name in ("mechanism", "load", "contact", "friction")
    )
    u = ratio(own)
    torque = (
        typed(load["output_torque_Nm"])
        if "output_torque_Nm" in load
        else typed(load["input_torque_Nm"]) * u * typed(load["efficiency"])
    )
    cranks = [mp.radians(angle) for angle in angles(own)]
    exponent = typed(load["force_exponent"])
    sums = total(own["pins"], cranks, exponent)
    radius, length, eccentricity = (
        typed(contact[name]) for name in ("pin_radius_mm", "contact_length_mm", "eccentricity_mm")
    )
    reference = 1000 * torque / typed(load["pin_circle_radius_mm"])
    largest = reference * peak(own["pins"], cranks, exponent, screened=True).ratio
    speed = typed(load["input_speed_rpm"])
    relative = speed * (1 + 1 / u)
    rolling = eccentricity * relative * mp.pi / 30 / 1000  # m/s
    sleeve = friction.get("sleeve", False)
    slows = typed(body["pin"]["diameter_mm"]) / (2 * radius) if sleeve else mpf(1)
    power = torque * speed * mp.pi / 30 / u
    mu = typed(friction["coefficient"])

    def loss(ratio: mpf) -> mpf:
        return mu * rolling * slows * reference * ratio

    mean_force = reference * sums.mean / (own["pins"] * len(cranks))
    exact = {
        "relative_speed_rpm": relative,
        "sliding_speed_m_per_s": rolling * slows,
        "output_power_W": power,
        "peak_force_N": largest,
        "mean_total_force_ratio": sums.mean,
        "mean_loss_W": loss(sums.mean),
        "efficiency": power / (power + loss(sums.mean)),
        "min_efficiency": power / (power + loss(sums.largest)),
        "max_efficiency": power / (power + loss(sums.least)),
        "peak_pv_MPa_m_per_s": largest / (2 * radius * length) * rolling,
        "mean_pv_MPa_m_per_s": mean_force / (2 * radius * length) * rolling,
        "friction_couple": mu * slows * radius * reference * sums.mean / 1000 / torque,
    }
    if sleeve:
        exact["sleeve_speed_rpm"] = relative * eccentricity / radius
    if "wear_rate_mm3_per_Nm" in friction:
        # volume k*F*2*pi*e over the area 2*pi*r*b that a relative turn sweeps
        required = body.get("requirements", {}).get("life_h", USUAL_LIFE)
        turns = relative * 60 * typed(friction.get("life_h", required))
        swept = typed(friction["wear_rate_mm3_per_Nm"]) * largest * eccentricity / 1000 / length
        exact["pin_wear_mm"] = swept / radius * turns
        if not sleeve:
            hole = contact.get("hole_radius_mm")
            hole = radius + eccentricity if hole is None else typed(hole)
            exact["hole_wear_mm"] = swept / hole * turns
    return {f"/{name}": Number(answer[name], value) for name, value in exact.items()}


OUTPUT_EFFICIENCY = Calculation(
    "Efficiency of the output", "output-efficiency", request, numbers, one_in=10
)
