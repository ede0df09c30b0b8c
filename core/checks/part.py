"""Parts of a reducer, each with a verdict of its own, of which the design's is made."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from core.errors import InvalidInput

Outcome = Literal["pass", "marginal", "fail", "incomplete"]

PartStatus = Literal["pass", "marginal", "fail", "open", "left_out", "not_asked"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """A part of a reducer."""

    code: str  # its name in requests and answers
    title: str  # its name in English
    sections: tuple[str, ...]  # of a design that its checks need
    by_forces: bool = True  # whether these read the pins' forces
    demands: tuple[str, ...] = ()  # without its section or one of these nobody asks for it


PARTS = {
    part.code: part
    for part in (
        Part(code="contact", title="pins in holes", sections=("load", "contact")),
        Part(code="pins", title="pins", sections=("load", "contact", "pin")),
        Part(
            code="teeth",
            title="teeth of satellite and ring",
            sections=("load", "contact", "gear"),
            by_forces=False,
        ),
        Part(
            code="satellite_bearing",
            title="bearings of the satellites",
            sections=("load", "contact", "gear", "bearing"),
        ),
        Part(
            code="crank_bearings",
            title="bearings and balance of the crankshaft",
            sections=("load", "contact", "gear", "crankshaft"),
        ),
        Part(
            code="body",
            title="body of the satellite",
            sections=("load", "contact", "satellite_body"),
            by_forces=False,
        ),
        Part(
            code="losses",
            title="friction, wear and efficiency",
            sections=("load", "contact", "friction"),
            demands=("min_efficiency", "max_sliding_speed", "max_pv", "max_wear"),
        ),
    )
}
"""By code, in the order in which they are shown."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PartVerdict:
    """What a part comes to.

    Attributes
    ----------
    status : PartStatus
        `fail` where one of its checks fails; else `open` where what it needs is not known or
        nothing of it is judged; else `marginal` or `pass`. `left_out` where the design's scope
        leaves it out, `not_asked` where nobody asks for it.
    """

    code: str  # which part, a key of `PARTS`
    status: PartStatus
    governing: str | None = None  # code of the check that decides of it
    reason: str = ""  # why it is open, a key of `core.codes.CODES`
    params: Mapping[str, Any] = field(default_factory=dict)  # what its words name, in SI units
    refusal: InvalidInput | None = None  # the reason as a refusal, where it is one
    missing: tuple[str, ...] = ()  # core names of inputs that would have to be given

    @property
    def judged(self) -> bool:
        """Whether it passes or fails."""
        return self.status in ("pass", "marginal", "fail")


def whole(parts: Iterable[PartVerdict]) -> Outcome:
    """What parts come to together.

    Parameters
    ----------
    parts : iterable of PartVerdict
        The parts.

    Returns
    -------
    Outcome

    Examples
    --------
    >>> whole([PartVerdict(code="pins", status="pass"), PartVerdict(code="body", status="open")])
    'incomplete'
    """
    statuses = {part.status for part in parts}
    if "fail" in statuses:
        return "fail"
    if "open" in statuses or not statuses & {"marginal", "pass"}:
        return "incomplete"
    return "marginal" if "marginal" in statuses else "pass"
