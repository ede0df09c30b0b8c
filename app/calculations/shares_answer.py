"""Answer about the shares of the torque that satellites carry."""

from typing import Any

from pydantic import Field

from app.model import Maybe, ResponseModel, Values, present, result, warning
from app.units import from_si, shown_unit
from core.checks.check import STATUSES, Check, Status
from core.checks.records import CHECKS
from core.checks.shares import DiscShare, DiscShares, ShareModel, ShareReason


class DiscShareOut(ResponseModel, of=DiscShare):
    """Share of one satellite."""


class EvenOut(ResponseModel):
    """Check with evenly sharing satellites."""

    check: str = Field(description="Code of the check.", json_schema_extra={"enum": [*CHECKS]})
    status: Status = Field(description=f"Result that the check would have: {', '.join(STATUSES)}.")
    value: Maybe[float] = Field(description="Value that the check would compare, in `unit`.")
    unit: str = Field(description="Unit of the value as shown; empty for plain numbers.")


class SharesOut(ResponseModel):
    """Sharing of the torque between the satellites."""

    model: ShareModel = Field(
        description="Origin of the shares: `real` from solved forces, `factor` from "
        "`contact.distribution_factor` on any one of the satellites, `given` from "
        "`satellite_coupling.shares`."
    )
    discs: list[DiscShareOut]
    largest: float = result("Largest share of the torque.")
    reason: ShareReason = Field(description="Main cause of the differences.")
    governs: list[str] = Field(
        description="Checks that decide a part and depend on the shares.",
        json_schema_extra={"items": {"type": "string", "enum": [*CHECKS]}},
    )
    even: Maybe[list[EvenOut]] = Field(
        description="Results of these checks if all satellites carried the same torque, as far as"
        " no other solution of the forces is needed."
    )

    @classmethod
    def of(cls, found: DiscShares) -> Values:
        """Values of the shares."""
        values: Values = {
            "model": found.model,
            "discs": [*map(DiscShareOut.values, found.discs)],
            "largest": found.largest.share,
            "reason": found.reason,
            "governs": [each.check.code for each in found.governs],
        }
        even = [_compared(each.even) for each in found.governs if each.even]
        return values | ({"even": even} if even else {})


def _compared(check: Check) -> Values:
    unit = f"value_{check.kind.unit}"
    value = from_si(unit, check.value)
    values = {"check": check.code, "status": check.status, "unit": shown_unit(unit)}
    return present(values | {"value": value})


def shares_warnings(found: DiscShares) -> list[Values]:
    """Warning of a satellite that carries much more, with the governing number for even shares."""
    said = [warning(each) for each in found.notices]
    for values in said:
        for governed in found.governs[:1]:
            if not governed.even or governed.even.value is None:
                continue
            own, even = _compared(governed.check), _compared(governed.even)
            params: dict[str, Any] = {"check": own["check"], "check_value": own["value"]}
            values["params"] |= params | {"even_value": even["value"], "unit": own["unit"]}
            title, unit = CHECKS[own["check"]].title, own["unit"]
            values["detail"] += f" {title}: {own['value']:.4g} {unit}".rstrip()
            values["detail"] += f", with an even share {even['value']:.4g} {unit}".rstrip() + "."
    return said
