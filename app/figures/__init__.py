"""Core results as Plotly figures: plain dictionaries ``{data, layout}``, one theme."""
