"""Contact force over the turn for every pair, with the peak marked."""

from app.figures.theme import INK, Figure, Theme, axis, layout, note, series_style, vertical_line
from app.schemas.contact_force import ContactForceResponse


def contact_force_figure(
    answer: ContactForceResponse, switching_deg: list[float], theme: Theme
) -> Figure:
    """Force of every pair over the turn, switching angles as thin lines, the peak marked.

    Parameters
    ----------
    answer : ContactForceResponse
        The forces with their curves, in newtons and degrees.
    switching_deg : list of float
        Crank angles at which a pair starts or stops driving, degrees.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    curves = answer.curves
    assert curves is not None
    ink = INK[theme]
    angles = [round(angle, 4) for angle in curves.crank_angle_deg]
    data = []
    for pair, force in zip(curves.pairs, curves.force_N, strict=True):
        colour, _, _ = series_style(pair.satellite - 1, theme)
        _, dash, _ = series_style(pair.pin - 1, theme)
        data.append(
            {
                "type": "scatter",
                "mode": "lines",
                "name": f"{pair.satellite}.{pair.pin}",
                "x": angles,
                "y": [float(f"{value:.6g}") for value in force],
                "line": {"color": colour, "dash": dash, "width": 2},
                "hovertemplate": f"satellite {pair.satellite}, pin {pair.pin}<br>"
                "%{y:.5g} N at %{x:.2f}°<extra></extra>",
            }
        )
    peak = {"x": answer.peak_crank_angle_deg, "y": answer.peak_force_N}
    data.append(
        {
            "type": "scatter",
            "mode": "markers",
            "name": "Peak",
            "x": [peak["x"]],
            "y": [peak["y"]],
            "marker": {
                "symbol": "diamond-open",
                "size": 12,
                "color": ink["alert"],
                "line": {"width": 2},
            },
            "hovertemplate": f"peak %{{y:.6g}} N at %{{x:.3f}}°<br>satellite "
            f"{answer.peak_pair.satellite}, pin {answer.peak_pair.pin}<extra></extra>",
        }
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=380,
            xaxis=axis(theme, "Crank angle, °", range=[0, 360], dtick=30),
            yaxis=axis(theme, "Contact force, N", range=[0, 1.15 * answer.peak_force_N]),
            shapes=[vertical_line(theme, round(place, 4)) for place in switching_deg],
            annotations=[
                note(
                    theme,
                    f"{answer.peak_force_N:.5g} N",
                    xref="x",
                    yref="y",
                    **peak,
                    yshift=16,
                    xanchor="left" if peak["x"] < 180 else "right",
                ),
            ],
        ),
    }
