"""Models of answers made of dataclasses: names, types, words, values that are not known."""

from dataclasses import dataclass

import numpy as np

from app.model import Maybe, ResponseModel, result
from core.arrays import FloatArray
from core.errors import Accuracy, Notice, NotKnown
from core.fields import answer, answered


@dataclass(frozen=True, kw_only=True)
class Turn:
    """A turn."""

    angle: FloatArray = answer("deg", "φ")
    """Angles of
    the turn."""
    force: FloatArray = answer("N", "F", "2021, eq. 10", depth=2)
    """Forces of the turn."""
    inner: int = 0


@dataclass(frozen=True, kw_only=True)
class Pin:
    """A pin."""

    radius: float = answer("mm", "r")
    """Radius of the pin."""
    cycles: float | None = answer(default=None)
    """Cycles of the pin."""
    turns: tuple[Turn, ...] = answer()
    """Turns of the pin."""
    accuracy: Accuracy = answer()
    notices: tuple[Notice, ...] = answer(default=())

    @property
    @answered("h", optional=True)
    def life(self) -> float:
        """Life of the pin; absent
        if it is not known.
        """
        raise NotKnown("life_unknown")


class TurnOut(ResponseModel, of=Turn):
    """A turn of the answer."""


class PinOut(ResponseModel, of=Pin):
    """A pin of the answer."""

    BESIDE = ("place_mm",)

    radius_mm: float = result("Radius as it is judged.")
    place_mm: Maybe[float] = result("Place of the pin.")


class LifeOut(ResponseModel, of=Pin, only=("life",)):
    """Life of the answer."""


MADE = Pin(
    radius=0.002,
    turns=(Turn(angle=np.array([0.0, np.pi]), force=np.array([[1.0]])),),
    accuracy=Accuracy("sampling", 0.0, 1),
)


def test_the_schema_says_what_the_dataclass_says() -> None:
    schema = PinOut.model_json_schema()
    assert [*schema["properties"]] == [
        *("radius_mm", "cycles", "turns", "life_h", "place_mm", "accuracy", "warnings")
    ]
    assert schema["required"] == ["radius_mm", "turns", "accuracy"]
    assert schema["properties"]["radius_mm"]["description"] == "Radius as it is judged."
    assert schema["properties"]["turns"]["items"] == {"$ref": "#/$defs/TurnOut"}
    life = schema["properties"]["life_h"]
    assert life["description"] == "Life of the pin; absent if it is not known."
    assert (life["type"], life["x-unit"]) == ("number", "h")
    turn = schema["$defs"]["TurnOut"]["properties"]
    assert [*turn] == ["angle_deg", "force_N"]
    assert (turn["angle_deg"]["items"], turn["angle_deg"]["x-symbol"]) == ({"type": "number"}, "φ")
    assert turn["force_N"]["items"] == {"type": "array", "items": {"type": "number"}}
    assert turn["force_N"]["x-equation"] == "2021, eq. 10"
    assert [*LifeOut.model_json_schema()["properties"]] == ["life_h"]


def test_values_are_those_of_the_dataclass_without_what_is_not_known() -> None:
    values = PinOut.values(MADE)
    (turn,) = values.pop("turns")
    assert turn["angle_deg"].tolist() == [0.0, 180.0]
    assert turn["force_N"].tolist() == [[1.0]]
    assert values.pop("accuracy")["method_code"] == "sampling"
    assert values == {"radius_mm": 2.0}
    assert LifeOut.values(MADE) == {}
