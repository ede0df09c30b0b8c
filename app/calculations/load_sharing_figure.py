"""Figure of the load sharing with clearance and errors."""

from dataclasses import dataclass

from app.theme import Amount, Figure, Theme, axis, curve, drawn, layout, text
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
    curves, angle = shown.curves, Amount("%{x:.2f}", "°")
    angles = drawn(from_si("angle_deg", curves.crank_angle))
    end = float(angles[-1])
    data = []
    for words, forces, look in (
        ("ideal_pair_force", shown.ideal, {"showlegend": False, "opacity": 0.4}),
        ("pair_force", curves.force, {}),
    ):
        for (satellite, pin), force in zip(shown.pairs, forces, strict=True):
            hovered = text(
                words, satellite=satellite, pin=pin, force=Amount("%{y:.5g}", "N"), angle=angle
            )
            trace = curve(
                f"{satellite}.{pin}", angles, force, pin - 1, theme, hovered,
                colour=satellite - 1, **look,
            )  # fmt: skip
            if look:
                trace["line"] |= {"width": 1}
            data.append(trace)
    for index, (name, values) in enumerate(
        (
            ("lag", curves.rotation),
            ("reverse_lag", curves.reverse_rotation),
            ("play_from", curves.play_from),
            ("play_to", curves.play_to),
        )
    ):
        shown_value = Amount("%{y:.5g}", "′")
        hovered = text("at_angle", name=text(name), value=shown_value, angle=angle)
        lags = from_si("lag_arcmin", values)
        colour = index // 2
        data.append(
            curve(text(name), angles, lags, index, theme, hovered, colour=colour, yaxis="y2")
        )
    name = text("max_pressure")
    hovered = text("at_angle", name=name, value=Amount("%{y:.5g}", "MPa"), angle=angle)
    pressures = from_si("pressure_MPa", shown.pressure)
    data.append(curve(name, angles, pressures, 0, theme, hovered, colour=2, yaxis="y3"))
    lag_curve = shown.lag_curve
    place = from_si("angle_deg", lag_curve.crank_angle)
    name = text("torque_over_lag", angle=Amount(place, "°"))
    hovered = text("torque_at_lag", torque=Amount("%{y:.5g}", "N·m"), lag=Amount("%{x:.5g}", "′"))
    points = [*zip(lag_curve.torque, lag_curve.rotation, strict=True)]
    points += [(0.0, lag) for lag in shown.play or ()]
    torques, lags = zip(*sorted(points), strict=True)
    rotation = from_si("lag_arcmin", lags)
    own = {"xaxis": "x2", "yaxis": "y4", "mode": "lines+markers"}
    data.append(curve(name, rotation, torques, 0, theme, hovered, colour=3) | own)
    return {
        "data": data,
        "layout": layout(
            theme,
            height=920,
            xaxis=axis(theme, text("crank_angle"), "°", range=[0, end], anchor="y3"),
            xaxis2=axis(theme, text("lag"), "′", anchor="y4"),
            yaxis=axis(theme, text("contact_force"), "N", domain=[0.7, 1], rangemode="tozero"),
            yaxis2=axis(theme, text("lag"), "′", domain=[0.47, 0.66]),
            yaxis3=axis(
                theme, text("contact_pressure"), "MPa", domain=[0.31, 0.43], rangemode="tozero"
            ),
            yaxis4=axis(theme, text("torque"), "N·m", domain=[0, 0.21], anchor="x2"),
        ),
    }
