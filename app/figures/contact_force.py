"""Contact force over the turn for every pair, with the peak marked."""

import numpy as np

from app.figures.theme import Figure, Theme, axis, curve, drawn, layout, marker, note, vertical_line
from app.schemas.base import Values
from core.arrays import FloatArray


def contact_force_figure(answer: Values, switching_deg: FloatArray, theme: Theme) -> Figure:
    """Force of every pair over the turn, switching angles as thin lines, the peak marked.

    Parameters
    ----------
    answer : dict
        The forces with their curves, as `/contact-force` answers.
    switching_deg : array
        Crank angles at which a pair starts or stops driving, degrees.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    curves, peak_pair = answer["curves"], answer["peak_pair"]
    angles, forces = drawn(curves["crank_angle_deg"]), drawn(curves["force_N"])  # all at once
    data = [
        curve(
            f"{pair['satellite']}.{pair['pin']}",
            angles,
            force,
            pair["pin"] - 1,
            theme,
            f"satellite {pair['satellite']}, pin {pair['pin']}<br>%{{y:.5g}} N at %{{x:.2f}}°",
            colour=pair["satellite"] - 1,
        )
        for pair, force in zip(curves["pairs"], forces, strict=True)
    ]
    peak = {"x": answer["peak_crank_angle_deg"], "y": answer["peak_force_N"]}
    data.append(
        marker(
            "Peak",
            peak["x"],
            peak["y"],
            theme,
            f"peak %{{y:.6g}} N at %{{x:.3f}}°<br>satellite {peak_pair['satellite']}, "
            f"pin {peak_pair['pin']}",
        )
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=380,
            xaxis=axis(theme, "Crank angle, °", range=[0, 360], dtick=30),
            yaxis=axis(theme, "Contact force, N", range=[0, 1.15 * answer["peak_force_N"]]),
            shapes=[vertical_line(theme, place) for place in np.round(switching_deg, 4).tolist()],
            annotations=[
                note(
                    theme,
                    f"{answer['peak_force_N']:.5g} N",
                    xref="x",
                    yref="y",
                    **peak,
                    yshift=16,
                    xanchor="left" if peak["x"] < 180 else "right",
                ),
            ],
        ),
    }
