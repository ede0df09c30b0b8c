"""Swinging rollers: stiffness and stress over length, non-uniformity over position error."""

from app.figures.theme import Figure, Theme, axis, curve, layout, marker, note, vertical_line
from app.units import from_si
from core.rollers.roller_curves import RollerCurves


def roller_figure(curves: RollerCurves, theme: Theme) -> Figure:
    """Three panels, each with the user's own design marked.

    Parameters
    ----------
    curves : RollerCurves
        The curves, in SI units.
    theme : {"light", "dark"}
        Look of the figure.

    Returns
    -------
    dict
        ``{data, layout}``.
    """
    design = curves.design
    lengths, errors = curves.length_ratio, curves.position_error
    stress = from_si("bending_stress_MPa", design.bending_stress)
    data = [
        curve(
            "Stiffness",
            lengths,
            curves.relative_stiffness,
            0,
            theme,
            "c/(b·E) = %{y:.4g} at l/d = %{x:.3g}",
            showlegend=False,
        ),
        marker(
            "This design",
            design.length_ratio,
            design.relative_stiffness,
            theme,
            "this design: c/(b·E) = %{y:.5g}",
        ),
    ]
    data += [
        curve(
            f"n = {rollers}",
            errors,
            values,
            index,
            theme,
            f"n = {rollers}: Ψ = %{{y:.4g}} at δ = %{{x:.4g}}",
            xaxis="x2",
            yaxis="y2",
        )
        for index, (rollers, values) in enumerate(curves.nonuniformity.items())
    ]
    data.append(
        marker(
            "This design",
            design.relative_position_error,
            design.load_nonuniformity,
            theme,
            "this design: Ψ = %{y:.5g} at δ = %{x:.4g}",
            xaxis="x2",
            yaxis="y2",
            showlegend=False,
        )
    )
    for index, (tolerance, values) in enumerate(curves.stress.items()):
        name = f"χ = {from_si('tolerance_mm', tolerance):.3g} mm"
        data.append(
            curve(
                name,
                lengths,
                from_si("stress_MPa", values),
                index,
                theme,
                f"{name}: %{{y:.4g}} MPa at l/d = %{{x:.3g}}",
                xaxis="x3",
                yaxis="y3",
                legend="legend2",
            )
        )
    data.append(
        marker(
            "This design",
            design.length_ratio,
            stress,
            theme,
            "this design: %{y:.5g} MPa",
            xaxis="x3",
            yaxis="y3",
            showlegend=False,
        )
    )
    return {
        "data": data,
        "layout": layout(
            theme,
            height=920,
            xaxis=axis(theme, "Length over diameter l/d", anchor="y"),
            yaxis=axis(theme, "Stiffness c/(b·E)", domain=[0.79, 1], type="log"),
            xaxis2=axis(theme, "Relative position error δ", anchor="y2"),
            yaxis2=axis(theme, "Non-uniformity Ψ", domain=[0.4, 0.61], rangemode="tozero"),
            xaxis3=axis(theme, "Length over diameter l/d", anchor="y3"),
            yaxis3=axis(theme, "Bending stress, MPa", domain=[0, 0.22], rangemode="tozero"),
            shapes=[
                vertical_line(
                    theme, curves.limit, ink="muted", xref="x2", yref="y2 domain", layer="above"
                ),
            ],
            annotations=[
                note(
                    theme,
                    "one roller carries all",
                    x=curves.limit,
                    y=1,
                    xref="x2",
                    yref="y2 domain",
                    xanchor="left",
                    yanchor="top",
                    xshift=4,
                )
            ],
            legend={"orientation": "h", "y": 0.62, "yanchor": "bottom", "x": 0},
            legend2={"orientation": "h", "y": 0.23, "yanchor": "bottom", "x": 0},
        ),
    }
