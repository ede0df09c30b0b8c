"""Answer about pins and holes at one crank angle."""

from app.calculations.mechanism import PairOut
from app.model import ResponseModel
from core.design.drawings import PinsInHoles, PlacedPair, PlacedPin


class PointOut(ResponseModel, of=PlacedPin):
    """Pin with its centre."""


class PairGeometryOut(PairOut, of=PlacedPair):
    """Hole, contact point and pressure angle of one pair."""


class GeometryOut(ResponseModel, of=PinsInHoles):
    """Pins and holes at a crank angle (Y up through pin 1 at crank angle 0, X right)."""
