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


def hertz_figure(curves: list[PressureCurve], limits_MPa: dict[str, float], theme: Theme) -> Figure:
    """Pressure distributions over the arc of the pin, with the limits of the two bodies.

    Parameters
    ----------
    curves : list of PressureCurve
        Hertz, and the conformal contact where it applies.
    limits_MPa : dict of str to float
        Limit of the pressure by the name of the body, where it is known.
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
    widest = max(float(each.place_mm[-1]) for each in curves)
    data += [
        {
            "type": "scatter",
            "mode": "lines",
            "name": f"Limit of the {body}",
            "x": [-widest, widest],
            "y": [limit] * 2,
            "line": {"color": INK[theme]["alert"], "dash": dash, "width": 1.5},
            "hovertemplate": f"limit of the {body} %{{y:.5g}} MPa<extra></extra>",
        }
        for (body, limit), dash in zip(limits_MPa.items(), ("longdash", "dot"), strict=False)
        if limit <= 4 * highest
    ]
    return {
        "data": data,
        "layout": layout(
            theme,
            height=300,
            xaxis=axis(theme, "Place along the arc of the pin, mm"),
            yaxis=axis(theme, "Contact pressure, MPa", rangemode="tozero"),
        ),
    }
