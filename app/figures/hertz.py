"""Pressure across the contact of pin and hole."""

from dataclasses import dataclass

from app.figures.theme import INK, Figure, Theme, axis, curve, layout
from core.arrays import FloatArray


@dataclass(frozen=True, slots=True)
class PressureCurve:
    """One pressure distribution to draw.

    Attributes
    ----------
    name : str
        Whose it is.
    place_mm, pressure_MPa : array
        Places along the arc of the pin and pressure there.
    """

    name: str
    place_mm: FloatArray
    pressure_MPa: FloatArray


def hertz_figure(
    curves: list[PressureCurve], allowable_pressure_MPa: float | None, theme: Theme
) -> Figure:
    """Pressure distributions over the arc of the pin, with the allowable pressure.

    Parameters
    ----------
    curves : list of PressureCurve
        Hertz, and the conformal contact where it applies.
    allowable_pressure_MPa : float or None
        Smaller allowable pressure of the two materials.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    data = [
        curve(
            each.name,
            each.place_mm,
            each.pressure_MPa,
            index,
            theme,
            f"{each.name}<br>%{{y:.5g}} MPa at %{{x:.4g}} mm",
        )
        for index, each in enumerate(curves)
    ]
    highest = max(float(each.pressure_MPa.max()) for each in curves)
    if allowable_pressure_MPa is not None and allowable_pressure_MPa <= 4 * highest:
        widest = max(float(each.place_mm[-1]) for each in curves)
        data.append(
            {
                "type": "scatter",
                "mode": "lines",
                "name": "Allowable",
                "x": [-widest, widest],
                "y": [allowable_pressure_MPa] * 2,
                "line": {"color": INK[theme]["alert"], "dash": "longdash", "width": 1.5},
                "hovertemplate": "allowable %{y:.5g} MPa<extra></extra>",
            }
        )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=300,
            xaxis=axis(theme, "Place along the arc of the pin, mm"),
            yaxis=axis(theme, "Contact pressure, MPa", rangemode="tozero"),
        ),
    }
