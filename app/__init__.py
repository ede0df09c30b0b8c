"""The web layer of KHV Calc: HTTP, JSON, millimetres and degrees around `core`."""

VERSION = "0.1.0"
"""Version of the service; pyproject.toml reads it from here."""
