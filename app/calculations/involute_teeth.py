"""Involute teeth of satellite and ring: tooth data of a request, sizes and stresses answered."""

from typing import Any

from app.model import (
    Maybe,
    ResponseModel,
    Values,
    result,
)
from core.ring.involute import InvolutePair
from core.ring.involute_load import InvoluteLoad, RootStress


class InvoluteGeometryOut(ResponseModel, of=InvolutePair):
    """Mesh of involute teeth of satellite and ring."""

    tip_interference_G: Maybe[float] = result(
        "Tip interference value G, in radians times teeth, which has to be at least 0; absent "
        "if the tip circles do not cross.",
        symbol="G",
    )

    @classmethod
    def values(cls, result: InvolutePair, run_time_us: float | None = None, **given: Any) -> Values:
        """Values of a pair."""
        given["tip_interference_G"] = result.tip_interference
        return super().values(result, run_time_us, **given)


class RootStressOut(ResponseModel, of=RootStress):
    """Root of the satellite's teeth under the force at the tip of one tooth."""


class InvoluteStressesOut(ResponseModel, of=InvoluteLoad):
    """Stresses of involute teeth by the torque of a satellite, with one pair carrying all."""

    root: Maybe[RootStressOut] = None
