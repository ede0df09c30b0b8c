"""Error against run time, both axes logarithmic, a line for each method."""

from app.figures.theme import Figure, Theme, axis, curve, layout, marker
from app.schemas.work_precision import WorkPointOut, WorkPrecisionResponse

EXACT = 1e-17
"""Where an error of nothing is drawn: below the rounding of any double."""


def work_precision_figure(answer: WorkPrecisionResponse, theme: Theme) -> Figure:
    """Every method's errors over its run times, the default marked.

    Parameters
    ----------
    answer : WorkPrecisionResponse
        The study.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    methods: dict[str, list[WorkPointOut]] = {}
    for point in answer.points:
        methods.setdefault(point.method, []).append(point)
    data = []
    for index, (method, points) in enumerate(methods.items()):
        line = curve(
            method,
            [point.run_time_us for point in points],
            [max(point.relative_error, EXACT) for point in points],
            index,
            theme,
            f"{method}, %{{customdata}}<br>error %{{y:.2g}} in %{{x:.3g}} µs",
        )
        line |= {"mode": "lines+markers", "customdata": [point.setting for point in points]}
        data.append(line)
    chosen = answer.chosen
    data.append(
        marker(
            "Used by the calculator",
            chosen.run_time_us,
            max(chosen.relative_error, EXACT),
            theme,
            f"{chosen.method}: error %{{y:.2g}} in %{{x:.3g}} µs",
        )
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=460,
            xaxis=axis(theme, "Run time, µs", type="log"),
            yaxis=axis(theme, "Relative error", type="log", exponentformat="power"),
            legend={"orientation": "v", "x": 1.02, "y": 1, "font": {"size": 10}},
        ),
    }
