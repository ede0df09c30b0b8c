"""Error against run time, both axes logarithmic, a line for each method."""

from app.figures.theme import DASHES, Figure, Theme, axis, curve, layout, marker
from app.schemas.base import Values

EXACT = 1e-17
"""Where an error of nothing is drawn: below the rounding of any double."""

SYMBOLS = ("circle", "square", "triangle-up")
"""Marks that tell methods apart whose colours and dashes repeat."""


def work_precision_figure(answer: Values, theme: Theme) -> Figure:
    """Every method's errors over its run times, the default marked.

    Parameters
    ----------
    answer : dict
        The study, as `/work-precision` answers.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    methods: dict[str, list[Values]] = {}
    for point in answer["points"]:
        methods.setdefault(point["method"], []).append(point)
    data = []
    for index, (method, points) in enumerate(methods.items()):
        line = curve(
            method,
            [point["run_time_us"] for point in points],
            [max(point["relative_error"], EXACT) for point in points],
            index,
            theme,
            f"{method}, %{{customdata}}<br>error %{{y:.2g}} in %{{x:.3g}} µs",
        )
        line |= {
            "mode": "lines+markers",
            "marker": {"symbol": SYMBOLS[index // len(DASHES) % len(SYMBOLS)], "size": 7},
            "customdata": [point["setting"] for point in points],
        }
        data.append(line)
    chosen = answer["chosen"]
    data.append(
        marker(
            "Used by the calculator",
            chosen["run_time_us"],
            max(chosen["relative_error"], EXACT),
            theme,
            f"{chosen['method']}: error %{{y:.2g}} in %{{x:.3g}} µs",
        )
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=600,
            # All powers of ten alike, 1e-4 as 1e-14, and only digits between them.
            xaxis=axis(theme, "Run time, µs", type="log", exponentformat="e", tickformat=""),
            yaxis=axis(theme, "Relative error", type="log", exponentformat="e", tickformat=""),
            legend={"orientation": "h", "y": -0.18, "yanchor": "top", "x": 0, "font": {"size": 11}},
        ),
    }
