"""Requests for the fuzz: random designs over all that is allowed, hostile numbers, broken bodies.

Limits come from the service's own OpenAPI description; what belongs together (a ratio or numbers
of teeth, one gap for each roller) is written here.
"""

import gzip
import json
import math
import random
from collections.abc import Callable
from copy import deepcopy
from dataclasses import dataclass, field
from itertools import accumulate
from typing import Any

from app.examples import EXAMPLES
from app.main import app
from core.material_table import MATERIALS

DESCRIPTION: dict[str, Any] = app.openapi()
MODELS: dict[str, Any] = DESCRIPTION["components"]["schemas"]
TYPICAL = {"mm": (0.5, 100), "Nm": (1, 1e4), "N": (1, 1e5), "GPa": (1, 300), "MPa": (10, 3e3)}
"""Usual sizes, by the last part of a name."""

Body = dict[str, Any]


@dataclass(slots=True)
class Request:
    """One request; `json` is its body where that is meant to be read as JSON."""

    endpoint: str
    json: Body | None = None
    content: bytes = b""
    headers: dict[str, str] = field(default_factory=lambda: {"content-type": "application/json"})
    query: str = ""
    method: str = "POST"

    def body(self) -> bytes:
        """The bytes that are sent."""
        return self.content if self.json is None else json.dumps(self.json).encode()


class Draw(random.Random):
    """Random values of the fields of the request models."""

    wide = 0.0
    """Probability that a number comes from the whole allowed range, not from the usual one."""

    def chance(self, probability: float) -> bool:
        return self.random() < probability

    def log_uniform(self, low: float, high: float) -> float:
        return min(high, max(low, math.exp(self.uniform(math.log(low), math.log(high)))))

    def number(self, model: str, name: str, usual: tuple[float, float] | None = None) -> float:
        """Value of a field within its limits, evenly over the logarithm where it is positive."""
        schema = MODELS[model]["properties"][name]
        kinds = [s for s in schema.get("anyOf", ()) if s.get("type", "null") != "null"]
        schema = kinds[0] if kinds else schema
        schema = schema.get("items", schema)
        low = schema.get("minimum", schema.get("exclusiveMinimum"))
        high = schema.get("maximum", schema.get("exclusiveMaximum"))
        if not self.chance(self.wide):
            usual = usual or TYPICAL.get(name.rsplit("_", 1)[-1], (0.1, 10))
            low, high = max(low, usual[0]), min(high, usual[1])
        elif self.chance(0.1):
            edge = self.choice((low, high))
            within = "exclusiveMinimum" in schema and edge == low
            within |= "exclusiveMaximum" in schema and edge == high
            return math.nextafter(edge, (low + high) / 2) if within else edge
        if low < 0 < high and self.chance(0.5):
            return self.choice((-1, 1)) * self.log_uniform(1e-12, min(high, -low))
        if low <= 0:
            return self.choice((self.uniform(low, high), self.log_uniform(1e-15, high)))
        return self.log_uniform(low, high)

    def count(self, most: int) -> int:
        return round(self.log_uniform(1, most))


def mechanism(r: Draw) -> Body:
    """Pins, satellites, cranks, ratio; seldom many pairs."""
    most = r.choices((30, 300, 10_000), (97, 2.7, 0.3))[0]
    satellites = r.count(min(100, most // 3))
    body: Body = {"pins": r.count(most // satellites), "satellites": satellites}
    if body["pins"] * satellites == 1 and r.chance(0.8):
        body["pins"] = 3
    if r.chance(0.7):
        body["ratio"] = abs(r.number("CyclogramRequest", "ratio", (1, 100)))
        if r.chance(0.5):
            body["ratio"] = float(math.ceil(body["ratio"]) or 1)
    else:
        teeth = [r.randint(10, 200) if r.chance(0.8) else r.count(10**6 - 1) for _ in range(2)]
        body |= {"satellite_teeth": min(teeth), "ring_teeth": max(teeth) + 1}
    angles = r.random()
    if angles < 0.3:
        body["crank_spacing_deg"] = r.choice(
            (90.0, 120.0, 180.0, r.uniform(0, 360), r.uniform(-3600, 3600), r.log_uniform(1e-15, 1))
        )
    elif angles < 0.6:
        del body["satellites"]
        body["crank_angles_deg"] = [r.uniform(-360, 360) for _ in range(satellites)]
        if r.chance(0.2):
            near = body["crank_angles_deg"][0]
            body["crank_angles_deg"][-1] = math.nextafter(near, 9e9)
    if r.chance(0.3):
        body["initial_crank_angle_deg"] = r.choice((180.0, r.uniform(-3600, 3600)))
    return body


def range_shown(r: Draw, body: Body) -> Body:
    """The mechanism with a number of turns that keeps the answer small."""
    if r.chance(0.3):
        pairs = body["pins"] * len(body.get("crank_angles_deg", ())) or body["pins"]
        turns = 1 + 1 / body.get("ratio", 1.0)
        body["revolutions"] = r.log_uniform(1e-12, max(1e-3, 300 / pairs / turns))
    return body


def load(r: Draw) -> Body:
    """Torque, lever, force exponent."""
    number = r.number
    body: Body = {"pin_circle_radius_mm": number("DesignLoadFields", "pin_circle_radius_mm")}
    if r.chance(0.7):
        body["output_torque_Nm"] = number("DesignLoadFields", "output_torque_Nm")
    else:
        body["input_torque_Nm"] = number("DesignLoadFields", "input_torque_Nm")
        body["efficiency"] = r.log_uniform(1e-3, 1)
    if r.chance(0.5):
        body["force_exponent"] = r.choice(
            (
                0,
                10 / 9,
                1.5,
                number("DesignLoadFields", "force_exponent", (0, 3)),
                r.uniform(0.9, 1.2),
            )
        )
    wanted = ("curves", "equal_sharing", "approximation")
    body["include"] = [each for each in wanted if r.chance(0.3)]
    if r.chance(0.9):
        body["samples"] = r.randint(2, 40)
    return body


def material(r: Draw) -> Body | str:
    """A name, or values."""
    if r.chance(0.7):
        return r.choice(list(MATERIALS))
    number = r.number
    body: Body = {
        "youngs_modulus_GPa": number("MaterialFields", "youngs_modulus_GPa"),
        "poissons_ratio": number("MaterialFields", "poissons_ratio", (0, 0.49)),
    }
    if r.chance(0.5):
        body["allowable_pressure_MPa"] = number("MaterialFields", "allowable_pressure_MPa")
    return body


def contact(r: Draw) -> Body:
    """Pin and hole, nearly alike at times."""
    number = r.number
    pin = number("HertzRequest", "pin_radius_mm")
    wider = r.choice((number("HertzRequest", "hole_radius_mm"), pin * r.log_uniform(1e-15, 1)))
    body: Body = {
        "contact_length_mm": number("HertzRequest", "contact_length_mm"),
        "pin_radius_mm": pin,
        "hole_radius_mm": min(1e12, pin + wider),
    }
    for name in ("pin_material", "hole_material"):
        if r.chance(0.5):
            body[name] = material(r)
    for name in ("dynamic_factor", "distribution_factor"):
        if r.chance(0.2):
            body[name] = number("HertzRequest", name, (1, 3))
    return body


def hertz(r: Draw) -> Body:
    return contact(r) | {"force_N": r.number("HertzRequest", "force_N", (1, 1e5))}


def crank_planetary(r: Draw) -> Body:
    body: Body = {"mechanism": range_shown(r, mechanism(r)), "load": load(r), "contact": contact(r)}
    sections = ["cyclogram", "contact_force", "hertz", "geometry"]
    body["include"] = r.sample(sections, r.randint(1, 4))
    if r.chance(0.1):
        as_made(r, body)
    elif r.chance(0.4):
        whole(r, body)
    if r.chance(0.5):
        body["crank_angle_deg"] = r.uniform(-3600, 3600)
    return body


def whole(r: Draw, body: Body) -> None:
    """Sections of strength and life in a design, what each needs, and what is asked of it."""
    strong, turning = pin_strength(r), crankshaft(r)
    load, contact = body["load"], body["contact"]
    body["mechanism"] = strong["mechanism"]
    load["input_speed_rpm"] = turning["load"]["input_speed_rpm"]
    load["torque_direction"] = r.choice(("driving", "reverse", "alternating"))
    if "dynamic_factor" not in contact and r.chance(0.3):
        load["application_factor"] = r.number("DesignLoadFields", "application_factor", (0.5, 2))
    if r.chance(0.3):
        load["peak_torque_Nm"] = r.number("DesignLoadFields", "peak_torque_Nm")
    contact["eccentricity_mm"] = max(1e-12, contact["hole_radius_mm"] - contact["pin_radius_mm"])
    count = len(strong["pin"]["satellite_positions_mm"])
    first, last = turning["crankshaft"]["bearing_positions_mm"]
    turning["crankshaft"]["satellite_positions_mm"] = [r.uniform(first, last)] * count
    friction = output_efficiency(r)["friction"]
    friction.pop("sleeve", None)
    given = {
        "pin": strong["pin"],
        "fatigue": strong.get("fatigue", {"surface": "ground"}),
        "friction": friction,
        "gear": turning["gear"],
        "bearing": satellite_bearing(r)["bearing"],
        "crankshaft": turning["crankshaft"],
    }
    body |= {name: section for name, section in given.items() if r.chance(0.7)}
    needs = {
        "pin_strength": {"pin"},
        "output_efficiency": {"friction"},
        "satellite_bearing": {"gear", "bearing"},
        "crankshaft": {"gear", "crankshaft"},
    }
    possible = [name for name, sections in needs.items() if sections <= {*body}]
    asked = [name for name in (*possible, "hertz", "checks") if r.chance(0.5)]
    body["include"] = asked or ["checks"]
    limits = MODELS["RequirementsFields"]["properties"]
    body["requirements"] = {
        name: r.number("RequirementsFields", name)
        for name in limits
        if r.chance(0.3) and "lost_motion" not in name
    }


def as_made(r: Draw, body: Body) -> None:
    """Clearance, deviations and elasticity in a design; few pairs, as they take a turn."""
    real = load_sharing(r)
    if real["mechanism"]["pins"] > 4:
        real["mechanism"] = {"pins": r.randint(1, 4), "ratio": 20.0}
        real.pop("deviations", None)
    body["mechanism"] = real["mechanism"]
    body["contact"] |= real["contact"]
    del body["contact"]["hole_radius_mm"]
    body |= {name: real[name] for name in ("contact_law", "deviations") if name in real}
    body["load"]["torque_direction"] = r.choice(("driving", "reverse", "alternating"))
    if r.chance(0.5):
        body["include"].append("load_sharing")


def output_efficiency(r: Draw) -> Body:
    """Friction of the pins, with sleeves and wear at times."""
    number = r.number
    torque = load(r)
    include = ["curves"] if torque.pop("include") else []
    body: Body = {"mechanism": mechanism(r), "load": torque, "include": include}
    if "samples" in torque:
        body["samples"] = torque.pop("samples")
    torque["input_speed_rpm"] = number("DesignLoadFields", "input_speed_rpm", (10, 3000))
    sizes = ("contact_length_mm", "pin_radius_mm", "eccentricity_mm")
    contact = {name: number("PinContactFields", name) for name in sizes}
    if r.chance(0.3):
        wider = contact["eccentricity_mm"] * r.uniform(0.5, 2)
        contact["hole_radius_mm"] = min(1e12, contact["pin_radius_mm"] + wider)
    friction: Body = {
        "coefficient": r.choice((0.0, r.uniform(0.01, 0.3), r.log_uniform(1e-12, 10)))
    }
    if r.chance(0.5):
        for name, usual in (("wear_rate_mm3_per_Nm", (1e-9, 1e-5)), ("life_h", (1, 1e5))):
            friction[name] = number("FrictionFields", name, usual)
    if r.chance(0.4):
        friction["sleeve"] = True
        body["pin"] = {"diameter_mm": max(1e-12, contact["pin_radius_mm"] * r.uniform(0.5, 2.05))}
    return body | {"contact": contact, "friction": friction}


def satellite_bearing(r: Draw) -> Body:
    """Any ring and bearing; teeth that do not mesh at times."""
    number = r.number
    torque = load(r)
    for name in ("include", "samples"):
        torque.pop(name, None)
    torque["input_speed_rpm"] = number("DesignLoadFields", "input_speed_rpm", (10, 3000))
    if r.chance(0.3):
        torque["torque_direction"] = r.choice(("reverse", "alternating"))
    gear: Body = r.choice(
        (
            {"kind": "none"},
            {"radial_force_ratio": r.uniform(-2, 2)},
            {"kind": "involute", "module_mm": r.uniform(1, 5), "teeth_difference": r.randint(1, 4)},
            {"kind": "cycloid", "ring_pin_circle_radius_mm": r.uniform(10, 500)},
        )
    )
    bearing: Body = {"kind": r.choice(("ball", "roller"))}
    if r.chance(0.5):
        bearing["dynamic_rating_N"] = number("BearingFields", "dynamic_rating_N", (1e3, 1e6))
    contact = {"eccentricity_mm": number("PinContactFields", "eccentricity_mm", (1, 5))}
    body = {"mechanism": mechanism(r), "load": torque, "contact": contact}
    if gear.get("kind") == "cycloid" and r.chance(0.5):
        gear["ring_pin_radius_mm"] = number("RingFields", "ring_pin_radius_mm", (1, 10))
    return body | {"gear": gear, "bearing": bearing}


def crankshaft(r: Draw) -> Body:
    """Satellites anywhere along the shaft."""
    body = satellite_bearing(r)
    bearing = body.pop("bearing")
    own = body["mechanism"]
    count = len(own["crank_angles_deg"]) if "crank_angles_deg" in own else own.get("satellites", 1)
    first = r.uniform(-100, 100)
    last = first + r.choice((r.uniform(1, 200), r.log_uniform(1e-9, 1e6)))
    places = [r.choice((first, last, r.uniform(-300, 300))) for _ in range(count)]
    shaft: Body = {"satellite_positions_mm": places, "bearing_positions_mm": [first, last]}
    if r.chance(0.5):
        shaft["satellite_mass_kg"] = r.number("CrankshaftFields", "satellite_mass_kg", (0.1, 10))
    if r.chance(0.5):
        shaft["bearings"] = [bearing, {"kind": "roller"}]
    return body | {"crankshaft": shaft}


def real_design(r: Draw) -> Body:
    """Clearance, any law, and satellites that give at times."""
    number = r.number
    torque = load(r)
    del torque["include"]
    torque.pop("samples", None)
    body: Body = {"mechanism": mechanism(r), "load": torque}
    torque["torque_direction"] = r.choice(("driving", "reverse", "alternating"))
    sizes = ("contact_length_mm", "pin_radius_mm", "eccentricity_mm")
    contact = {name: number("PinContactFields", name) for name in sizes}
    contact["hole_clearance_mm"] = contact["eccentricity_mm"] * r.choice(
        (0.0, r.uniform(-0.02, 0.1), r.log_uniform(1e-9, 1))
    )
    law: Body = {"kind": r.choice(("hertz", "palmgren", "linear", "power"))}
    if law["kind"] == "linear":
        law["stiffness_N_per_mm"] = number("ContactLawFields", "stiffness_N_per_mm", (1e4, 1e6))
    if law["kind"] == "power":
        law["exponent"] = r.choice((0.5, 1, 10 / 9, 3))
        law["reference_force_N"] = number("ContactLawFields", "reference_force_N", (100, 1e4))
        usual = (1e-3, 0.1)
        law["reference_approach_mm"] = number("ContactLawFields", "reference_approach_mm", usual)
    body |= {"contact": contact, "contact_law": law}
    if r.chance(0.3):
        body |= giving(r, body["mechanism"])
    return body


def giving(r: Draw, mechanism: Body) -> Body:
    """Random elasticity of the satellites."""
    number, kind = r.number, r.choice(("bearings", "elastic", "shares"))
    if kind == "bearings":
        bearings = {"radial_clearance_mm": r.choice((0.0, r.log_uniform(1e-6, 0.1)))}
        if r.chance(0.7):
            stiff = number("CrankSupportFields", "stiffness_N_per_mm", (1e4, 1e7))
            bearings["stiffness_N_per_mm"] = stiff
        return {"crank_support": bearings}
    coupling: Body = {"kind": kind}
    if kind == "elastic":
        stiff = number("SatelliteCouplingFields", "stiffness_Nm_per_arcmin", (1, 1e3))
        coupling["stiffness_Nm_per_arcmin"] = stiff
    else:
        count = mechanism.get("satellites", len(mechanism.get("crank_angles_deg", ())))
        weights = [r.uniform(0.5, 1) for _ in range(count)]
        coupling["shares"] = [weight / math.fsum(weights) for weight in weights]
    return {"satellite_coupling": coupling}


def load_sharing(r: Draw) -> Body:
    """A real design with deviations at times; a turn where it is short."""
    body = real_design(r) | {"crank_angle_deg": [r.uniform(-360, 360)]}
    pins = body["mechanism"]["pins"]
    if r.chance(0.4) and pins <= 1000:
        size = r.choice((1e-3, 0.02, 1.0))
        body["deviations"] = {"pin_radial_mm": [r.uniform(-size, size) for _ in range(pins)]}
    body["include"] = ["positions"] + [each for each in ("ideal", "pressure") if r.chance(0.2)]
    if pins <= 4 and r.chance(0.1):
        body["include"].append("over_turn")
    return body


def fit(r: Draw) -> Body:
    """Pins in holes of any size, with deviations at times that are as large as the parts."""
    design = real_design(r)
    design["mechanism"]["pins"] = min(design["mechanism"]["pins"], 60)
    body = {name: design[name] for name in ("mechanism", "contact")}
    radius = design["load"]["pin_circle_radius_mm"]
    body["load"] = {"pin_circle_radius_mm": radius}
    pins = body["mechanism"]["pins"]
    if r.chance(0.6):
        size = r.choice((1e-3, 0.1, 1.0, radius if radius < 1e6 else 1.0))
        row = [r.uniform(-size, size) for _ in range(pins)]
        body["deviations"] = {r.choice(("pin_radial_mm", "pin_tangential_mm")): row}
    if r.chance(0.2):
        body["crank_support"] = {"radial_clearance_mm": r.choice((0.0, 0.01, 1.0))}
    body["crank_angle_deg"] = [r.uniform(-360, 360)]
    body["include"] = ["positions"] + [each for each in ("discs", "elastic") if r.chance(0.3)]
    return body


def pin_strength(r: Draw) -> Body:
    """Strength of the pins on their supports, with all ways to judge its fatigue."""
    torque = load(r)
    torque.pop("include")
    torque.pop("samples", None)
    if r.chance(0.5):
        torque["input_speed_rpm"] = r.number("DesignLoadFields", "input_speed_rpm", (10, 3000))
    for name, usual in (("application_factor", (0.5, 3)), ("peak_torque_Nm", (10, 1e4))):
        if r.chance(0.2):
            torque[name] = r.number("DesignLoadFields", name, usual)
    if r.chance(0.3):
        torque["torque_direction"] = r.choice(("reverse", "alternating"))
    own = mechanism(r)
    angles = own.get("crank_angles_deg")
    satellites = own.get("satellites", 2) if angles is None else len(angles)
    length = r.number("PinFields", "contact_length_mm")
    steps = accumulate((r.uniform(1, 1.5) for _ in range(satellites)), initial=0.51)
    places = [min(1e12, length * each) for _, each in zip(range(satellites), steps, strict=False)]
    pin: Body = {
        "diameter_mm": r.number("PinFields", "diameter_mm"),
        "contact_length_mm": length,
        "satellite_positions_mm": places,
        "support": r.choice(("cantilever", "supported", "fixed")),
        "rotates": r.chance(0.2),
        "material": r.choice([*MATERIALS]),
    }
    if pin["support"] != "cantilever":
        pin["span_mm"] = min(1e12, max(places) + length * r.uniform(0.4, 2))
    if r.chance(0.6):
        model = "MaterialFields"
        names = ("youngs_modulus_GPa", "tensile_strength_MPa", "yield_strength_MPa")
        pin["material"] = {name: r.number(model, name) for name in names}
        pin["material"]["poissons_ratio"] = r.number(model, "poissons_ratio", (0, 0.49))
    body: Body = {"mechanism": own, "load": torque, "pin": pin}
    if r.chance(0.8):
        body["fatigue"] = {
            "endurance_limit_MPa": r.number("FatigueFields", "endurance_limit_MPa"),
            "criterion": r.choice(("goodman", "gerber", "soderberg", "fkm_haigh")),
        }
    return body | {"include": [each for each in ("deflection", "locus") if r.chance(0.3)]}


def with_forces(make: Callable[[Draw], Body]) -> Callable[[Draw], Body]:
    """A calculation of strength or life, at times with all that its forces may follow from."""

    def made(r: Draw) -> Body:
        body = make(r)
        own, torque = body["mechanism"], body["load"]
        angles = own.get("crank_angles_deg")
        satellites = own.get("satellites", 2) if angles is None else len(angles)
        few = own["pins"] * satellites <= 6
        sizes = body.get("contact", {})
        if not few and "hole_radius_mm" in sizes:  # solved over the turn it takes long
            fits = sizes["pin_radius_mm"] + sizes["eccentricity_mm"]
            sizes["hole_radius_mm"] = min(sizes["hole_radius_mm"], fits)
        if not r.chance(0.3):
            return body
        given = contact(r)
        del given["hole_radius_mm"]
        if "application_factor" in torque:
            given.pop("dynamic_factor", None)
        given["eccentricity_mm"] = r.number("PinContactFields", "eccentricity_mm")
        body["contact"] = given | sizes
        torque["torque_direction"] = r.choice(("driving", "reverse", "alternating"))
        if "peak_torque_Nm" not in torque and r.chance(0.2):
            torque["peak_torque_Nm"] = r.number("DesignLoadFields", "peak_torque_Nm")
        if few and r.chance(0.3):
            body["contact"].pop("hole_radius_mm", None)
            body["contact"]["hole_clearance_mm"] = given["eccentricity_mm"] * r.uniform(-0.02, 0.1)
            if r.chance(0.3):
                size = r.choice((1e-3, 0.02))
                errors = [r.uniform(-size, size) for _ in range(own["pins"])]
                body["deviations"] = {"pin_radial_mm": errors}
            if r.chance(0.2):
                body["contact_law"] = {"kind": r.choice(("hertz", "palmgren"))}
            if r.chance(0.1):
                body |= giving(r, {"satellites": satellites})
        return body

    return made


def fitting(make: Callable[[Draw], Body]) -> Callable[[Draw], Body]:
    """A design whose parts mostly agree with each other: what is too small is made larger."""

    def made(r: Draw) -> Body:
        body = make(r)
        if r.chance(0.9):
            peak_of_all(body)
            side_by_side(body)
            if "ring_teeth" in body["mechanism"]:
                body.get("gear", {}).pop("teeth_difference", None)
        return body

    return made


def side_by_side(body: Body) -> None:
    """No satellite within another, and the same distances on pins and crankshaft."""
    pin, shaft = body.get("pin", {}), body.get("crankshaft")
    on_pins = pin.get("satellite_positions_mm")
    width = pin.get("contact_length_mm", body.get("contact", {}).get("contact_length_mm"))
    if shaft is None:
        return
    places = shaft["satellite_positions_mm"]
    if on_pins is not None and len(on_pins) == len(places):
        shaft["satellite_positions_mm"] = [places[0] + z - on_pins[0] for z in on_pins]
    elif width is not None:
        shaft["satellite_positions_mm"] = [
            places[0] + 1.01 * width * index for index, _ in enumerate(places)
        ]


def peak_of_all(body: Body) -> None:
    """No peak torque below the working one."""
    load = body["load"]
    if "peak_torque_Nm" not in load:
        return
    torque = load.get("output_torque_Nm")
    if torque is None:
        own = body["mechanism"]
        ratio = own.get("ratio")
        if ratio is None:
            ratio = own["satellite_teeth"] / (own["ring_teeth"] - own["satellite_teeth"])
        torque = load["input_torque_Nm"] * load["efficiency"] * ratio
    factor = body.get("contact", {}).get("dynamic_factor", 1.0)
    working = torque * load.get("application_factor", factor)
    load["peak_torque_Nm"] = min(1e12, max(load["peak_torque_Nm"], working))


def tolerance_study(r: Draw) -> Body:
    """A few pieces of a real design."""
    body = real_design(r)
    if body["load"]["torque_direction"] == "alternating" and r.chance(0.9):
        body["load"]["torque_direction"] = "driving"
    size = r.choice((1e-3, 0.02, 0.3))
    tolerances: Body = {
        "pin_position_mm": size,
        "hole_position_mm": size / 2,
        "pin_diameter": r.choice(({"class": "m6"}, {"lower_mm": -size, "upper_mm": 0.0})),
        "hole_diameter": {"lower_mm": 0.0, "upper_mm": size, "distribution": "uniform"},
        "eccentricity_mm": {"lower_mm": -size, "upper_mm": size, "common": True},
        "disc_phase_deg": size,
    }
    kept = {name: each for name, each in tolerances.items() if r.chance(0.5)}
    samples = r.count(30)
    body |= {"tolerances": kept, "samples": samples, "crank_angles": 12, "seed": r.count(10**6)}
    names = [each for each in MODELS["LimitsFields"]["properties"] if "ring" not in each]
    body["quantities"] = r.sample(names, r.randint(1, 3))
    body["percentiles"] = [50.0] if samples >= 6 else []
    if r.chance(0.3):
        limited = r.choice(names)
        body["limits"] = {limited: r.number("LimitsFields", limited, (0.1, 1e4))}
    if r.chance(0.1):
        body["include"] = ["histogram"]
    if r.chance(0.02) and kept:
        body |= {"samples": 4, "include": ["contributions"], "percentiles": []}
    return in_ring(r, body, size) if r.chance(0.2) else body


def in_ring(r: Draw, body: Body, size: float) -> Body:
    """Random request with discs in a ring of pins, which has tolerances too."""
    number, lobes = r.number, 1 + r.count(24)
    own = {"satellite_teeth": lobes, "ring_teeth": lobes + 1}
    for name, each in body["mechanism"].items():
        if "teeth" not in name and "ratio" not in name:
            own[name] = each
    circle = body["contact"]["eccentricity_mm"] * (lobes + 1) / r.uniform(0.3, 1.02)
    body |= {
        "mechanism": own,
        "satellite_coupling": {"kind": "ring"},
        "gear": {
            "kind": "cycloid",
            "ring_pin_circle_radius_mm": circle,
            "ring_pin_radius_mm": circle * r.uniform(0.1, 2) / (lobes + 1),
            "contact_length_mm": number("RingFields", "contact_length_mm", (1, 40)),
            "modification": {"equidistant_mm": r.choice((0.0, 2 * size, -size / 2))},
        },
    }
    body.pop("crank_support", None)
    tolerances: Body = {
        "ring_pin_position_mm": size,
        "ring_pin_diameter": r.choice(({"class": "h6"}, {"lower_mm": -size, "upper_mm": 0.0})),
        "equidistant_mm": {"lower_mm": -size, "upper_mm": size, "distribution": "uniform"},
        "modification_pin_circle_mm": size,
    }
    body["tolerances"] |= {name: each for name, each in tolerances.items() if r.chance(0.7)}
    body["quantities"] += r.sample(("ring_peak_force_N", "ring_max_pressure_MPa"), r.randint(0, 2))
    return body


def roller_strength(r: Draw) -> Body:
    """Rollers with a tolerance or with gaps."""
    model = "RollerStrengthRequest"
    needed = MODELS[model]["required"]
    body: Body = {name: r.number(model, name) for name in needed if name != "rollers"}
    rollers = r.count(r.choices((12, 1000), (98, 2))[0])
    body["rollers"] = rollers
    if r.chance(0.5):
        body["position_tolerance_mm"] = r.number(model, "position_tolerance_mm", (1e-4, 0.1))
    else:
        spread = r.number(model, "position_tolerance_mm", (1e-4, 0.1))
        body["gaps_mm"] = [r.uniform(-spread, spread) for _ in range(rollers)]
    if r.chance(0.5):
        body["poissons_ratio"] = r.number(model, "poissons_ratio", (0, 0.49))
    else:
        body["shear_modulus_GPa"] = r.number(model, "shear_modulus_GPa")
    for name, usual in (("friction_coefficient", (0.0, 0.3)), ("stress_concentration", (1.0, 5.0))):
        if r.chance(0.3):
            body[name] = r.number(model, name, usual)
    return body


def interval(r: Draw) -> tuple[float, float]:
    """A working length, beside the precession centre more often than across it."""
    start = r.number("RollerFields", "z_min_mm", (5, 50))
    length = r.log_uniform(1e-9, 1e3) if r.chance(r.wide) else r.uniform(1, 20)
    return (start, start + length) if start > 0 or r.chance(0.2) else (start - length, start)


def gear(r: Draw) -> Body:
    """A mesh: geometry, and rollers or a wheel."""
    number = r.number
    body: Body = {
        name: number("ContactLineRequest", name)
        for name in ("roller_circle_radius_mm", "roller_radius_mm")
    }
    body["nutation_angle_deg"] = number("ContactLineRequest", "nutation_angle_deg", (0.5, 20))
    body["ratio_u12"] = number("ContactLineRequest", "ratio_u12", (0.8, 1.2))
    place = r.uniform(-360, 360) if r.chance(0.5) else r.uniform(5, 170)
    if r.chance(0.3):
        low, high = interval(r)
        total = r.count(r.choices((40, 500), (98, 2))[0])
        wheel: Body = {"rollers_total": total, "position_angle_deg": place}
        wheel |= {"z_min_mm": low, "z_max_mm": high}
        if r.chance(0.7):
            wheel["rollers_in_mesh"] = r.randint(1, total)
        return body | {"wheel": wheel}
    rollers = []
    for _ in range(r.count(8)):
        roller: Body = {"position_angle_deg": place}
        if r.chance(0.7):
            roller["z_min_mm"], roller["z_max_mm"] = interval(r)
        else:
            start = -place + r.uniform(1, 170)
            roller["phi_min_deg"] = start
            roller["phi_max_deg"] = start + r.uniform(-5, 5)
        rollers.append(roller)
        place = (place + r.choice((15, 30, 1e-9, 77))) % 360
    return body | {"rollers": rollers}


def contact_line(r: Draw) -> Body:
    body = gear(r)
    if r.chance(0.3):
        body["torque_sign"] = r.choice((-1, 1))
    if r.chance(0.3):
        body |= {"include": ["points"], "samples": r.randint(2, 20)}
    return body


def meshing_load(r: Draw) -> Body:
    names = ("torque_Nm", "reference_z_mm")
    return gear(r) | {name: r.number("MeshingLoadRequest", name) for name in names}


def shaft_deflection(r: Draw) -> Body:
    """A mesh on a plain or a stepped shaft."""
    model = "ShaftDeflectionRequest"
    body = meshing_load(r)
    names = ("bearing_distance_mm", "overhang_mm", "youngs_modulus_GPa")
    body |= {name: r.number(model, name) for name in names}
    if r.chance(0.6):
        return body | {"shaft_diameter_mm": r.number(model, "shaft_diameter_mm")}
    total = body["bearing_distance_mm"] + body["overhang_mm"]
    cuts = [total * each for each in sorted(r.random() for _ in range(r.randint(0, 4)))]
    lengths = [b - a for a, b in zip([0.0, *cuts], [*cuts, total], strict=True)]
    return body | {
        "shaft_sections": [
            {"length_mm": length, "diameter_mm": r.number("ShaftSectionFields", "diameter_mm")}
            for length in lengths
        ]
    }


def tired(r: Draw, body: Body, model: str) -> Body:
    """Random request with strengths, and at times all ways to judge fatigue."""
    for name in ("tensile_strength_MPa", "yield_strength_MPa"):
        if r.chance(0.5):
            body[name] = r.number(model, name)
    if r.chance(0.5):
        own: Body = {"criterion": r.choice(("goodman", "gerber", "soderberg", "fkm_haigh"))}
        if r.chance(0.5):
            own["endurance_limit_MPa"] = r.number("FatigueFields", "endurance_limit_MPa")
        else:
            own["surface"] = r.choice(("ground", "machined", "hot_rolled", "forged"))
        if r.chance(0.5):
            own["fatigue_notch_factor"] = r.number("FatigueFields", "fatigue_notch_factor", (1, 3))
        body["fatigue"] = own
    return body


def judged_rollers(r: Draw) -> Body:
    body = tired(r, roller_strength(r), "RollerStrengthRequest")
    return body | {"roller_rotates": r.chance(0.3)}


def judged_shaft(r: Draw) -> Body:
    body = tired(r, shaft_deflection(r), "ShaftDeflectionRequest")
    body["load_rotates_with_shaft"] = r.chance(0.3)
    if r.chance(0.3):
        radius = r.number("LineContactFields", "mating_radius_mm", (5, 500))
        names = {f"{each}_material": r.choice([*MATERIALS]) for each in ("roller", "mating")}
        body["line_contact"] = names | {"mating_radius_mm": radius * r.choice((-1, 1))}
    return body


def contact_force(r: Draw) -> Body:
    return mechanism(r) | load(r)


DESIGNS: dict[str, Callable[[Draw], Body]] = {
    "cyclogram": lambda r: range_shown(r, mechanism(r)),
    "contact-force": contact_force,
    "hertz": hertz,
    "crank-planetary": fitting(crank_planetary),
    "output-efficiency": fitting(with_forces(output_efficiency)),
    "fit": fit,
    "load-sharing": load_sharing,
    "pin-strength": fitting(with_forces(pin_strength)),
    "tolerance-study": tolerance_study,
    "satellite-bearing": fitting(with_forces(satellite_bearing)),
    "crankshaft": fitting(with_forces(crankshaft)),
    "roller-strength": judged_rollers,
    "precession/contact-line": contact_line,
    "precession/meshing-load": meshing_load,
    "precession/shaft-deflection": judged_shaft,
}
STUDIES = {
    "peak_force": contact_force,
    "contact_line_length": gear,
    "shaft_deflection": shaft_deflection,
    "load-sharing": load_sharing,
}

HOSTILE: tuple[Any, ...] = (
    1e-320, -0.0, 0, -1, 1e308, -1e308, 1.7976931348623157e308, 5e-324, 1e-12, 1e12, 1e15,
    math.nan, math.inf, -math.inf, 10**400, -(10**400), 2**53 + 1, 2**63, 2**64, 1.5, "5", "",
    "NaN", "\ud800", "\x00", "constructor", True, False, None, [], {}, [None], [[[[1]]]],
    {"a": {"b": {}}}, [1e300] * 50, "x" * 1000,
)  # fmt: skip

OTHER_TYPES = (
    "text/plain", "application/x-www-form-urlencoded", "multipart/form-data", "a/b", "", "\xff",
    "application/json; charset=utf-7", "application/vnd.api+json",
)  # fmt: skip


def places(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Paths of everything inside a body."""
    parts = value.items() if isinstance(value, dict) else enumerate(value)
    found = []
    for key, inner in parts:
        found.append((*path, key))
        if isinstance(inner, (dict, list)):
            found += places(inner, (*path, key))
    return found


def mutated(r: Draw, body: Body) -> Body:
    """A body with one to three things put wrong, or only moved."""
    body = deepcopy(body)
    for _ in range(r.choice((1, 1, 2, 3))):
        paths = places(body)
        if not paths:
            break
        *way, key = r.choice(paths)
        holder: Any = body
        for part in way:
            holder = holder[part]
        change = r.random()
        if change < 0.5:
            holder[key] = deepcopy(r.choice(HOSTILE))
        elif change < 0.6:
            del holder[key]
        elif change < 0.7 and isinstance(holder, dict):
            name = r.choice(("color", "a~b/c", "ratio", "rollers", "gaps_mm", ""))
            holder[name] = deepcopy(r.choice(HOSTILE))
        elif type(holder[key]) is float:
            holder[key] *= r.choice((2, 0.5, -1, 1 + 1e-15, r.log_uniform(1e-6, 1e6)))
        elif type(holder[key]) is int:
            holder[key] *= r.choice((2, -1, r.count(1000)))
        elif isinstance(holder[key], list):
            holder[key] = holder[key] * r.choice((0, 2, 3, 200))
    return body


def broken(r: Draw, request: Request) -> Request:
    """A body that is not what it says: cut, doubled, nested, packed, of another type."""
    good = request.body()
    kind = r.randrange(14)
    if kind < 3:
        request.content = good[: r.randrange(len(good))]
    elif kind == 3:
        request.content = b"[" * r.choice((1, 500, 100_000)) + good
    elif kind == 4:
        request.content = b'{"pins":' * 5000 + b"1" + b"}" * 5000
    elif kind == 5:
        request.content = good[:-1] + b"," + good[1:]
    elif kind == 6:
        request.content = gzip.compress(good)
        request.headers |= {"content-encoding": "gzip"} if r.chance(0.5) else {}
    elif kind == 7:
        request.content = good.decode().encode(r.choice(("utf-16", "utf-32", "utf-8-sig")))
    elif kind == 8:
        request.content = r.randbytes(r.randrange(300))
    elif kind == 9:
        spot = r.randrange(len(good))
        request.content = good[:spot] + r.randbytes(r.randrange(4)) + good[spot + 1 :]
    elif kind == 10:
        request.content = b'{"gaps_mm": [' + b"1," * 100_000 + b'1], "a\\ud800": 1}'
    elif kind == 11:
        request.content = good + b" " * r.choice((10, 1_048_577))
    else:
        request.content = good
        request.headers = {"content-type": r.choice(OTHER_TYPES)} if r.chance(0.8) else {}
    request.json = None
    return request


def random_request(r: Draw) -> Request:
    """A request of any kind: half of them designs, the rest mutations and broken bodies."""
    r.wide = r.choice((0.0, 0.1, 1.0))
    if r.chance(0.0005):
        study = r.choice(list(STUDIES))
        return Request("work-precision", {"calculation": study, "input": STUDIES[study](r)})
    endpoint = r.choice(list(DESIGNS))
    if r.chance(0.02):
        count = r.randrange(100, 300) if r.chance(0.03) else r.randrange(1, 7)
        designs = [DESIGNS[endpoint](r) for _ in range(count)]
        requests = [mutated(r, each) if r.chance(0.3) else each for each in designs]
        calculation = endpoint.split("/")[-1].replace("-", "_")
        return Request("batch", {"calculation": calculation, "requests": requests})
    kind = r.random()
    if kind < 0.55:
        request = Request(endpoint, DESIGNS[endpoint](r))
    else:
        own = [each["input"] for each in EXAMPLES if each["calculation"] == endpoint]
        body = r.choice(own) if own and r.chance(0.5) else DESIGNS[endpoint](r)
        request = Request(endpoint, mutated(r, body) if kind < 0.85 else body)
        if kind >= 0.85:
            request = broken(r, request)
    if r.chance(0.08):
        request.endpoint += "/chart"
        request.query = r.choice(("", "theme=dark", "theme=light", "theme=%ff", "theme=1&a=b"))
    return request
