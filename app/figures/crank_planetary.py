"""Cyclogram and contact forces over one axis of the crank angle."""

from app.figures.theme import Figure


def over_one_axis(pattern: Figure, forces: Figure) -> Figure:
    """The forces under the cyclogram, both over the same crank angle.

    Parameters
    ----------
    pattern, forces : dict
        Figures of the cyclogram and of the contact force.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    upper, lower = pattern["layout"], forces["layout"]
    total = upper["height"] + lower["height"]
    share = lower["height"] / total

    def raised(axis: Figure) -> Figure:
        low, high = axis["domain"]
        return {**axis, "domain": [share + (1 - share) * low, share + (1 - share) * high]}

    return {
        "data": pattern["data"] + [{**trace, "yaxis": "y3"} for trace in forces["data"]],
        "layout": {
            **upper,
            "height": total,
            "xaxis": {**upper["xaxis"], "anchor": "y3"},
            "yaxis": raised(upper["yaxis"]),
            "yaxis2": raised(upper["yaxis2"]),
            "yaxis3": {**lower["yaxis"], "domain": [0, 0.85 * share]},
            "shapes": lower["shapes"] + upper["shapes"],
            "annotations": upper["annotations"]
            + [{**each, "yref": "y3"} for each in lower["annotations"]],
        },
    }
