"""Worked steps of a pin as a beam under a unit force, and of how bent pins share an ideal load."""

import math
from dataclasses import dataclass

from core.design.results import Results
from core.output.mechanism import Mechanism
from core.output.pin_beam import PinBeam, Support
from core.worked.hertz import take_materials
from core.worked.step import Sheet, total
from core.worked.turn import IdealTurn, Position

MOST_PAIRS = 100
"""Most pairs whose turn is worked."""

BENT: dict[Support, tuple[str, str, str]] = {
    "cantilever": ("#*x^2/2-x^3/6", "#*x-x^2/2", "x"),
    "supported": (
        "(V*L^2/6-(L-#)*((L-#)^2+b^2/4)/(6*L))*x-V*x^3/6",
        "V*L^2/6-(L-#)*((L-#)^2+b^2/4)/(6*L)-V*x^2/2",
        "V*x",
    ),
    "fixed": ("M_u*x^2/2-V*x^3/6", "M_u*x-V*x^2/2", "V*x"),
}
"""E*I times deflection and slope at x by what holds the pin, and the force sheared there."""

LOAD: dict[str, tuple[str, str, str]] = {
    "before": ("", "", ""),
    "own": ("+b^3/384", "+b^2/48", "-b/8"),
    "within": ("+(x-#+b/2)^4/(24*b)", "+(x-#+b/2)^3/(6*b)", "-(x-#+b/2)^2/(2*b)"),
    "beyond": ("+(x-#)*((x-#)^2+b^2/4)/6", "+(x-#)^2/2+b^2/24", "-(x-#)"),
}
"""What the load before x adds to them."""

HELD: dict[Support, dict[str, str]] = {
    "cantilever": {},
    "supported": {"V": "(L-#)/L"},
    "fixed": {
        "V": "(((L-#)^2/2+b^2/24)*L/2-(L-#)*((L-#)^2+b^2/4)/6+10/9*(1+nu)*d^2/8*(L-#))"
        "/(L^3/12+10/9*(1+nu)*d^2/8*L)",
        "M_u": "V*L/2-((L-#)^2/2+b^2/24)/L",
    },
}
"""Shear force and moment at the carrier under a unit force at #."""


def beam_of(results: Results) -> PinBeam:
    """The pin of a design as a beam.

    Parameters
    ----------
    results : Results
        Results of a design with a pin.

    Returns
    -------
    PinBeam
    """
    pin = results.design.pin
    return PinBeam.round(
        support=pin.support,
        diameter=pin.diameter,
        contact_length=results.design.pin_length,
        youngs_modulus=pin.material.youngs_modulus,
        poissons_ratio=pin.material.poissons_ratio,
        span=None if pin.support == "cantilever" else pin.span,
    )


def take_beam(sheet: Sheet, *, results: Results) -> None:
    """Let the sizes and the material of the pin be known.

    Parameters
    ----------
    sheet : Sheet
        Where.
    results : Results
        Results of a design with a pin.
    """
    pin = results.design.pin
    sheet.take("E", "youngs_modulus", float(pin.material.youngs_modulus))
    sheet.take("nu", "poissons_ratio", float(pin.material.poissons_ratio))
    sheet.take("d", "diameter", pin.diameter)
    sheet.take("b", "contact_length", results.design.pin_length)
    sheet.take("L", "span", None if pin.support == "cantilever" else pin.span)


def unit_steps(sheet: Sheet, *, results: Results, at: int, by: int) -> tuple[str, str]:
    """Steps of deflection and slope at a satellite by a unit force at one.

    Parameters
    ----------
    sheet : Sheet
        With the beam.
    results : Results
        Results of a design with a pin.
    at, by : int
        Satellites, from 0.

    Returns
    -------
    tuple of str
        Symbols of both.
    """
    pin, beam = results.design.pin, beam_of(results)
    assert pin is not None
    x, z = pin.satellite_positions[at], pin.satellite_positions[by]
    sheet.take(f"z_{at + 1}", "satellite_position", x)
    sheet.take(f"z_{by + 1}", "satellite_position", z)
    shear, moment = beam.reactions(z)
    marks = f"{at + 1}_{by + 1}"

    def placed(formula: str) -> str:
        own = formula.replace("V", f"V_{by + 1}").replace("M_u", f"M_{by + 1}")
        return own.replace("x", f"z_{at + 1}").replace("#", f"z_{by + 1}")

    for symbol, formula in HELD[pin.support].items():
        code, value = ("unit_shear", shear) if symbol == "V" else ("unit_moment", moment)
        sheet.work(code, placed(symbol), value, placed(formula))
    beyond = x - z
    place = "before" if beyond < 0 else "beyond"
    if abs(beyond) < sheet.known["b"].value / 2:
        place = "own" if at == by else "within"
    bent, turned, sheared = (
        placed(one + other) for one, other in zip(BENT[pin.support], LOAD[place], strict=True)
    )
    said = {"note": "unit_force", "params": {"at": at + 1, "from": by + 1}}
    sheet.work(
        "unit_deflection",
        f"c_{marks}",
        beam.deflection(x, z),
        f"64*({bent})/(pi*E*d^4)+10/9*8*(1+nu)*({sheared})/(pi*E*d^2)",
        **said,
    )
    slope = f"64*({turned})/(pi*E*d^4)"
    sheet.work("unit_slope", f"s_{marks}", beam.slope(x, z), slope)
    return f"c_{marks}", f"s_{marks}"


@dataclass(frozen=True, slots=True)
class Sharing:
    """How the satellites may share an ideal load: alike, and by the stiffness of bent pins.

    Attributes
    ----------
    mechanism : Mechanism
        The mechanism.
    exponent : float
        Exponent v of the force over the approach.
    turns : tuple of IdealTurn
        The turns.
    """

    mechanism: Mechanism
    exponent: float
    turns: tuple[IdealTurn, ...]


def sharing_steps(sheet: Sheet, *, results: Results) -> Sharing | None:
    """Steps of the stiffness of the pairs, where satellites share by it.

    Parameters
    ----------
    sheet : Sheet
        Where.
    results : Results
        Results of the design.

    Returns
    -------
    Sharing or None
        None where the forces are solved, or there are too many pairs.
    """
    design = results.design
    if design.as_made or design.mechanism.pairs > MOST_PAIRS:
        return None
    mechanism, exponent = design.mechanism.built, design.load.force_exponent
    sheet.take("v", "force_exponent", exponent)
    alike = IdealTurn(mechanism, exponent)
    if results.pair_stiffness is None:
        return Sharing(mechanism, exponent, (alike,))
    _contact(sheet, results)
    take_beam(sheet, results=results)
    for j, stiffness in enumerate(results.pair_stiffness):
        deflection, _ = unit_steps(sheet, results=results, at=j, by=j)
        sheet.work("pair_stiffness", f"k_{j + 1}", stiffness, f"1/(c_c+{deflection})")
    weighed = IdealTurn(mechanism, exponent, results.pair_stiffness)
    return Sharing(mechanism, exponent, (alike, weighed))


def _contact(sheet: Sheet, results: Results) -> None:
    """Approach of the contact over its force, by Hertz's law."""
    contact, factor = results.design.contact, results.design.load_factor
    first, second = contact.pin_material, contact.hole_material
    assert first is not None and second is not None
    length, radius, hole = contact.pair
    force = results.contact_force.peak_force * factor
    compliance = float(results.compliance(force))
    sheet.take("F", "peak_force", results.contact_force.peak_force)
    sheet.take("K_A", "dynamic_factor", factor)
    sheet.take("b", "contact_length", length)
    sheet.take("r_in", "pin_radius", radius)
    sheet.take("r_out", "hole_radius", hole)
    take_materials(sheet, first=first, second=second)
    parts = [float((1 - each.poissons_ratio**2) / each.youngs_modulus) for each in (first, second)]
    reduced = hole * radius / (hole - radius)
    width = math.sqrt(4 * force / (math.pi * length) * reduced * sum(parts))
    sheet.work(
        "contact_width",
        "a_c",
        width,
        "sqrt(4*K_A*F/(pi*b)*r_out*r_in/(r_out-r_in)*((1-nu_1^2)/E_1+(1-nu_2^2)/E_2))",
        source="johnson",
        note="level",
    )
    for symbol, ratio, code in (
        ("l_1", 4 * radius / width, "logarithm_of_pin"),
        ("l_2", 2 * hole / width, "logarithm_of_hole"),
    ):
        sheet.state("logarithm", symbol, math.log(ratio), code, source="johnson")
    said = {"source": "johnson"}
    pin = parts[0] * (2 * math.log(4 * radius / width) - 1)
    ratio = float(second.poissons_ratio / (1 - second.poissons_ratio))
    by_law = (pin + parts[1] * (2 * math.log(2 * hole / width) - ratio)) / (math.pi * length)
    if not math.isclose(by_law, compliance, rel_tol=1e-9):
        sheet.state("contact_compliance", "c_c", compliance, "law_end", **said)
        return
    formula = "((1-nu_1^2)/E_1*(2*l_1-1)+(1-nu_2^2)/E_2*(2*l_2-nu_2/(1-nu_2)))/(pi*b)"
    sheet.work("contact_compliance", "c_c", compliance, formula, **said)


class Shares:
    """How the forces of a satellite's pairs are written at a position that was found.

    Parameters
    ----------
    sheet : Sheet
        Gets the pressure angles of the pairs.
    turn : IdealTurn
        How the satellites share.
    at : Position
        The position.

    Attributes
    ----------
    said : dict
        Note of the steps.
    """

    def __init__(self, sheet: Sheet, turn: IdealTurn, at: Position) -> None:
        self.at, self.weighed = at, turn.stiffness is not None
        own = zip(at.satellite.tolist(), at.pin.tolist(), at.angle[0].tolist(), strict=True)
        self.pairs = [(int(j), int(n), angle) for j, n, angle in own]
        for j, n, angle in self.pairs:
            sheet.take(f"gamma_{j + 1}_{n + 1}", "pressure_angle", angle)
        self.once = {0.0: "", 1.0: "*cos(gamma_#)"}.get(turn.exponent, "*cos(gamma_#)^v")
        self.twice = {0.0: "*cos(gamma_#)", 1.0: "*cos(gamma_#)^2"}.get(
            turn.exponent, "*cos(gamma_#)^(1+v)"
        )
        self.said = {"note": "by_stiffness" if self.weighed else "alike"}

    def _terms(self, form: str, pairs: list[tuple[int, int, float]]) -> str:
        """A sum over pairs, each with the stiffness of its satellite."""
        if not pairs:
            return "0"
        parts = []
        for j, n, _ in pairs:
            term = (f"k_{j + 1}" if self.weighed else "1") + form.replace("#", f"{j + 1}_{n + 1}")
            parts.append(term.removeprefix("1*"))
        return total("#", marks=parts)

    @property
    def support(self) -> str:
        """The sum over all pairs that the force of one is divided by."""
        return self._terms(self.twice, self.pairs)

    def share(self, satellite: int) -> str:
        """Part of the torque that a satellite carries."""
        own = [each for each in self.pairs if each[0] == satellite]
        return f"{self._terms(self.twice, own)}/{self.support}"

    def pins(self, satellite: int) -> str:
        """Sum of the forces of its pins over T/R."""
        own = [each for each in self.pairs if each[0] == satellite]
        return f"{self._terms(self.once, own)}/{self.support}"

    def one(self, pair: tuple[int, int, float]) -> str:
        """The force of one pair over T/R."""
        return f"{self._terms(self.once, [pair])}/{self.support}"
