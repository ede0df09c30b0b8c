"""Answer of the tolerance study."""

from pydantic import Field

from app.model import AccuracyOut, DocumentResponse, Maybe, ResponseModel, WarningOut, result
from core.tolerance.contributions import Contribution
from core.tolerance.processes import ProcessName
from core.tolerance.quantiles import Estimate


class EstimateOut(ResponseModel, of=Estimate):
    """Number of the sample with its 95 % interval."""


class PercentileOut(EstimateOut):
    """Percentile by order statistics, whose interval holds for any distribution."""

    percent: float = result("Percentage of the pieces with a value below the percentile.")


class YieldOut(EstimateOut):
    """Share of all pieces that keep a limit; pieces that cannot be assembled do not. The interval
    is that of Clopper and Pearson.
    """

    limit: float = result(
        "Limit of the quantity: a lower limit of the stiffness, an upper limit of all other "
        "quantities."
    )


class HistogramOut(ResponseModel):
    """Number of pieces by value."""

    edges: list[float] = result("Edges of the classes, one more than counts.")
    counts: list[int] = result("Number of pieces in each class.")


class ContributionOut(ResponseModel, of=Contribution):
    """Effect of one tolerance on a quantity."""

    BESIDE = ("percentile_without", "fits_without")

    percentile_without: Maybe[PercentileOut] = result(
        "Highest requested percentile with this tolerance at the middle of its limits."
    )
    fits_without: Maybe[EstimateOut] = result(
        "Share of the pieces that fit, with this tolerance at the middle of its limits."
    )


class QuantityOut(ResponseModel):
    """One quantity of the pieces that fit; its name states the unit."""

    nominal: Maybe[float] = result(
        "Value of the piece at the middle of all limits; absent if that piece does not fit."
    )
    mean: Maybe[float] = result("Mean over the pieces that fit; absent if no piece fits.")
    percentiles: list[PercentileOut] = result(
        "Percentiles of the pieces that fit, in the requested order, without those for which "
        "too few pieces fit."
    )
    angle_grid_error: float = result(
        "Relative bias of the value by the finite number of crank angles. It adds to the "
        "sampling error, does not fall with more samples, and is not corrected for. The bias of"
        " the peak force is a mean over the highest peaks, which come out too low; that of "
        "other quantities is measured against four times as many angles."
    )
    kept: Maybe[YieldOut] = Field(
        alias="yield",
        description="Yield: share of all pieces that keep the limit, if one is given.",
    )
    yield_of_fitting: Maybe[YieldOut] = result(
        "Share of the fitting pieces that keep the limit, if one is given."
    )
    histogram: Maybe[HistogramOut] = result("Histogram of the quantity, if requested.")
    contributions: Maybe[list[ContributionOut]] = result(
        "Contribution of each tolerance to the first quantity, the largest first, if requested."
        " Tolerances act together if the totals add up to more than 1."
    )


class QuantitiesOut(ResponseModel):
    """Requested quantities, over the turn of each piece."""

    peak_force_N: Maybe[QuantityOut] = result("Largest force of all pairs.")
    max_pressure_MPa: Maybe[QuantityOut] = result("Largest pressure of the pairs, as it is judged.")
    transmission_error_arcmin: Maybe[QuantityOut] = result(
        "Transmission error: largest less least lag of the output under load."
    )
    backlash_max_arcmin: Maybe[QuantityOut] = result("Largest play of the unloaded output.")
    lost_motion_arcmin: Maybe[QuantityOut] = result(
        "Largest rotation of the output between the two directions of a share of the torque."
    )
    stiffness_min_Nm_per_arcmin: Maybe[QuantityOut] = result("Least torsional stiffness.")
    ring_peak_force_N: Maybe[QuantityOut] = result("Largest force on a pin of the ring.")
    ring_max_pressure_MPa: Maybe[QuantityOut] = result("Largest pressure on a pin of the ring.")


class StudyAccuracyOut(AccuracyOut):
    """Statistical error: the relative error is the sum of the two below, and each number's interval
    tells more.
    """

    sampling_error: float = Field(
        description="Largest relative half width of a percentile's 95 % interval, or that of the "
        "mean if no percentile is requested; it falls with the square root of the "
        "number of samples."
    )
    angle_grid_error: float = Field(
        description="Largest relative bias by the finite number of crank angles; more samples do "
        "not lower it."
    )


class ProcessOut(ResponseModel):
    """Manufacturing processes of the parts and their guide values, as in `GET /processes`."""

    code: ProcessName = result("Process of the holes; process of the pins if only that is stated.")
    source: str = result("Source of the numbers of the process.")
    pin_code: Maybe[ProcessName] = result("Process of the pins, if it differs.")
    pin_source: Maybe[str] = result("Source of the numbers of the process of the pins.")
    filled: list[str] = result(
        "JSON pointers to the fields that the processes fill, as they are not given."
    )
    mean_clearance_mm: float = result(
        "Clearance of pins and holes at the middle of all limits; it differs from the nominal "
        "one if holes come out small or pins large.",
        symbol="c",
    )


class ToleranceStudyResponse(DocumentResponse):
    """Effect of tolerances on the pieces."""

    quantities: QuantitiesOut = result("Quantities that are requested or have a limit.")
    samples: int = result("Number of pieces drawn.")
    fits: int = result("Number of pieces with room at all crank angles over the whole turn.")
    binds_in_turning: int = result(
        "Number of pieces that go together at some crank angles and jam at others."
    )
    does_not_fit: int = result("Number of pieces that go together at no crank angle.")
    cannot_assemble: EstimateOut = result(
        "Share of the pieces that do not fit, with its interval; these pieces are not in the "
        "percentiles and count against the yield."
    )
    cannot_work: int = result(
        "Pieces that fit and cannot work under the torque of what is asked, none of a backlash "
        "alone: they are not in the percentiles, and fail the yield."
    )
    process: Maybe[ProcessOut] = result("Manufacturing processes of the parts, if stated.")
    fit_contributions: Maybe[list[ContributionOut]] = result(
        "Contribution of each tolerance to the share of pieces that fit, the largest first; it "
        "replaces the contributions to a quantity if fewer than 95 % of the pieces fit."
    )
    accuracy: StudyAccuracyOut
    warnings: Maybe[list[WarningOut]] = None
