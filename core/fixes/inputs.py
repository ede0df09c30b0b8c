"""Inputs that are whole numbers."""

WHOLE = {"mechanism.pins", "mechanism.satellites", "rollers"}
