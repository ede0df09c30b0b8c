"""Worked steps of a pin as a beam under a unit force, and of ideal forces on it."""

import math

from core.design.results import Results
from core.output.pin_beam import PinBeam, Support
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
    """
    pin = results.bent_pin
    return PinBeam.round(
        support=pin.support,
        diameter=pin.diameter,
        bore_diameter=pin.bore_diameter,
        contact_length=results.design.pin_length,
        youngs_modulus=pin.material.youngs_modulus,
        poissons_ratio=pin.material.poissons_ratio,
        span=math.inf if pin.support == "cantilever" else pin.span,
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
    pin = results.bent_pin
    sheet.take("E", "youngs_modulus", float(pin.material.youngs_modulus))
    sheet.take("nu", "poissons_ratio", float(pin.material.poissons_ratio))
    sheet.take("d", "diameter", pin.diameter)
    sheet.take("d_i", "bore_diameter", pin.bore_diameter or None)
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
    pin, beam = results.bent_pin, beam_of(results)
    x, z = pin.satellite_positions[at], pin.satellite_positions[by]
    sheet.take(f"z_{at + 1}", "satellite_position", x)
    sheet.take(f"z_{by + 1}", "satellite_position", z)
    shear, moment = beam.reactions(z)
    marks = f"{at + 1}_{by + 1}"

    def placed(formula: str) -> str:
        own = formula.replace("V", f"V_{by + 1}").replace("M_u", f"M_{by + 1}")
        return own.replace("x", f"z_{at + 1}").replace("#", f"z_{by + 1}")

    area, inertia, k, square = "d^2", "d^4", "10/9", "d^2"
    if pin.bore_diameter:
        area, inertia, k, square = "(d^2-d_i^2)", "(d^4-d_i^4)", "k_s", "(d^2+d_i^2)"
        around = "((7+6*nu)*(1+(d_i/d)^2)^2)"
        coefficient = pin.section.shear_coefficient(float(pin.material.poissons_ratio))
        formula = f"10/9*(1+(20+12*nu)*(d_i/d)^2/{around})"
        sheet.work("shear_coefficient", k, coefficient, formula)
    for symbol, formula in HELD[pin.support].items():
        formula = formula.replace("10/9*(1+nu)*d^2", f"{k}*(1+nu)*{square}")
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
        f"64*({bent})/(pi*E*{inertia})+{k}*8*(1+nu)*({sheared})/(pi*E*{area})",
        **said,
    )
    slope = f"64*({turned})/(pi*E*{inertia})"
    sheet.work("unit_slope", f"s_{marks}", beam.slope(x, z), slope)
    return f"c_{marks}", f"s_{marks}"


def ideal_turn(sheet: Sheet, *, results: Results) -> IdealTurn | None:
    """The turn of the ideal forces; None where forces are solved, or there are too many pairs.

    Parameters
    ----------
    sheet : Sheet
        Gets the exponent of the force.
    results : Results
        Results of the design.
    """
    design = results.design
    if results.solved or design.pairs > MOST_PAIRS:
        return None
    sheet.take("v", "force_exponent", design.load.force_exponent)
    return IdealTurn(design.built, design.load.force_exponent)


class Shares:
    """How the forces of a satellite's pairs are written at a position that was found.

    Parameters
    ----------
    sheet : Sheet
        Gets the pressure angles of the pairs.
    turn : IdealTurn
        The turn.
    at : Position
        The position.
    """

    def __init__(self, sheet: Sheet, turn: IdealTurn, at: Position) -> None:
        self.at = at
        own = zip(at.satellite.tolist(), at.pin.tolist(), at.angle[0].tolist(), strict=True)
        self.pairs = [(int(j), int(n), angle) for j, n, angle in own]
        for j, n, angle in self.pairs:
            sheet.take(f"gamma_{j + 1}_{n + 1}", "pressure_angle", angle)
        self.once = {0.0: "", 1.0: "*cos(gamma_#)"}.get(turn.exponent, "*cos(gamma_#)^v")
        self.twice = {0.0: "*cos(gamma_#)", 1.0: "*cos(gamma_#)^2"}.get(
            turn.exponent, "*cos(gamma_#)^(1+v)"
        )

    def _terms(self, form: str, pairs: list[tuple[int, int, float]]) -> str:
        """A sum over pairs."""
        if not pairs:
            return "0"
        terms = ["1" + form.replace("#", f"{j + 1}_{n + 1}") for j, n, _ in pairs]
        return total("#", marks=[each.removeprefix("1*") for each in terms])

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
