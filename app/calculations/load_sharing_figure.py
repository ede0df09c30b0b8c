"""Figure of the load sharing with clearance and errors."""

from dataclasses import dataclass

from app.theme import Amount, Chart, Figure, Theme, drawn, text
from app.units import from_si
from core.arrays import FloatArray
from core.output.real_curves import RealCurves, StiffnessCurve


@dataclass(frozen=True, slots=True)
class Drawn:
    """Values that the figure shows, in SI units."""

    curves: RealCurves  # forces and lags over the crank angle
    ideal: FloatArray  # forces without clearance and deviations, as those of the curves
    pairs: list[tuple[int, int]]  # satellite and pin of each force
    pressure: FloatArray  # the largest at each crank angle
    lag_curve: StiffnessCurve  # lag over torque
    # Ends of the play at its crank angle, through which the lag moves without torque; None where
    # parts are pressed together.
    play: tuple[float, float] | None


def load_sharing_figure(shown: Drawn, theme: Theme) -> Figure:
    """Forces of the pairs with the ideal ones thin behind them; below them lag and play, the
    largest pressure, and the torque over the lag at one crank angle.
    """
    curves, lag_curve, angle = shown.curves, shown.lag_curve, Amount("%{x:.2f}", "°")
    angles = drawn(from_si("angle_deg", curves.crank_angle))
    chart = Chart(theme, height=920)
    chart.axis("x", "crank_angle", "°", range=[0, float(angles[-1])], anchor="y3")
    chart.axis("x2", "lag", "′", anchor="y4")
    chart.axis("y", "contact_force", "N", domain=[0.7, 1], rangemode="tozero")
    chart.axis("y2", "lag", "′", domain=[0.47, 0.66])
    chart.axis("y3", "contact_pressure", "MPa", domain=[0.31, 0.43], rangemode="tozero")
    chart.axis("y4", "torque", "N·m", domain=[0, 0.21], anchor="x2")
    thin: Figure = {"showlegend": False, "opacity": 0.4, "line": {"width": 1}}
    for words, forces, look in (
        ("ideal_pair_force", shown.ideal, thin),
        ("pair_force", curves.force, {}),
    ):
        for (satellite, pin), force in zip(shown.pairs, forces, strict=True):
            said = {"force": Amount("%{y:.5g}", "N"), "angle": angle}
            hovered = text(words, satellite=satellite, pin=pin, **said)
            own: Figure = {"colour": satellite - 1} | look
            chart.curve(f"{satellite}.{pin}", angles, force, pin - 1, hovered, **own)
    lags = {
        "lag": curves.rotation,
        "reverse_lag": curves.reverse_rotation,
        "play_from": curves.play_from,
        "play_to": curves.play_to,
    }
    for index, (name, values) in enumerate(lags.items()):
        row = from_si("lag_arcmin", values)
        chart.curve(name, angles, row, index, axis="y2", colour=index // 2)
    pressures = from_si("pressure_MPa", shown.pressure)
    chart.curve("max_pressure", angles, pressures, axis="y3", colour=2)
    at = Amount(from_si("angle_deg", lag_curve.crank_angle), "°")
    hovered = text("torque_at_lag", torque=Amount("%{y:.5g}", "N·m"), lag=Amount("%{x:.5g}", "′"))
    points = [*zip(lag_curve.torque, lag_curve.rotation, strict=True)]
    points += [(0.0, lag) for lag in shown.play or ()]
    torques, rotations = zip(*sorted(points), strict=True)
    own = {"axis": "y4", "mode": "lines+markers", "colour": 3}
    row = from_si("lag_arcmin", rotations)
    chart.curve(text("torque_over_lag", angle=at), row, torques, 0, hovered, **own)
    return chart.figure
