"""Answer of the tolerance study."""

from pydantic import Field

from app.model import AccuracyOut, AssumingResponse, Maybe, ResponseModel, WarningOut, result
from core.tolerance.processes import ProcessName


class EstimateOut(ResponseModel):
    """Number of the sample with its 95 % interval."""

    value: float = result("The number.")
    low: float = result("Lower end of its 95 % interval.")
    high: float = result("Upper end of its 95 % interval.")


class PercentileOut(EstimateOut):
    """Percentile by order statistics, whose interval holds for any distribution."""

    percent: float = result("Share of the pieces below it, percent.")


class YieldOut(EstimateOut):
    """Share of all pieces that keep a limit; pieces that cannot be assembled do not. The interval
    is that of Clopper and Pearson.
    """

    limit: float = result("The limit: a lower one of the stiffness, an upper one of all else.")


class HistogramOut(ResponseModel):
    """Number of pieces by value."""

    edges: list[float] = result("Ends of the classes, one more than counts.")
    counts: list[int] = result("Pieces in each.")


class ContributionOut(ResponseModel):
    """Effect of one tolerance on a quantity."""

    source: str = result("The tolerance: its name in the request.")
    total: float = result(
        "Share of the variance that hangs on it, alone or together with others.", symbol="S_T"
    )
    total_error: float = result("Standard error of the same.")
    first: float = result("Share of the variance that it explains alone.", symbol="S_1")
    first_error: float = result("Standard error of the same.")
    percentile_without: Maybe[PercentileOut] = result(
        "The highest percentile asked, with this tolerance at the middle of its limits."
    )
    fits_without: Maybe[EstimateOut] = result(
        "Share of the pieces that fit, with this tolerance at the middle of its limits."
    )


class QuantityOut(ResponseModel):
    """One quantity of the pieces that fit; its name states the unit."""

    nominal: Maybe[float] = result(
        "Of the piece at the middle of all limits; absent where that does not fit."
    )
    mean: Maybe[float] = result("Mean; absent where no piece fits.")
    percentiles: list[PercentileOut] = result(
        "Percentiles of the pieces that fit, in the order asked; without those for which too few "
        "fit."
    )
    angle_grid_error: float = result(
        "How much the crank angles miss of it, relative: a bias beside the sampling error, which "
        "more samples do not lower; the numbers are not corrected for it. Of the peak force a mean "
        "over the highest peaks, which come out too low; of the others against four times as many "
        "angles."
    )
    kept: Maybe[YieldOut] = Field(alias="yield", description="Yield, where a limit is given.")
    yield_of_fitting: Maybe[YieldOut] = result("The same of the pieces that fit.")
    histogram: Maybe[HistogramOut] = result("Histogram, where asked.")
    contributions: Maybe[list[ContributionOut]] = result(
        "What each tolerance does, the largest first, where asked: of the first quantity. Where "
        "the totals add up to more than 1, tolerances act together."
    )


class QuantitiesOut(ResponseModel):
    """Requested quantities, over the turn of each piece."""

    peak_force_N: Maybe[QuantityOut] = result("Largest force of all pairs.")
    max_pressure_MPa: Maybe[QuantityOut] = result("Largest pressure, as it is judged.")
    transmission_error_arcmin: Maybe[QuantityOut] = result("Largest less least lag under load.")
    backlash_max_arcmin: Maybe[QuantityOut] = result("Largest play of the unloaded output.")
    lost_motion_arcmin: Maybe[QuantityOut] = result(
        "Largest rotation between the two directions of a share of the torque."
    )
    stiffness_min_Nm_per_arcmin: Maybe[QuantityOut] = result("Least stiffness.")
    ring_peak_force_N: Maybe[QuantityOut] = result("Largest force on a pin of the ring.")
    ring_max_pressure_MPa: Maybe[QuantityOut] = result("Largest pressure on a pin of the ring.")


class StudyAccuracyOut(AccuracyOut):
    """Statistical error: the relative error is the sum of the two below, and each number's interval
    tells more.
    """

    sampling_error: float = Field(
        description="Largest half width of a percentile's 95 % interval, relative; of the mean "
        "where no percentile is asked. It falls with the root of the samples."
    )
    angle_grid_error: float = Field(
        description="Largest bias of the crank angles, relative; more samples do not lower it."
    )


class ProcessOut(ResponseModel):
    """Manufacturing processes of the parts and their guide values, as in `GET /processes`."""

    code: ProcessName = result(
        "Process of the holes; where only that of the pins is said, of these."
    )
    source: str = result("Where its numbers come from.")
    pin_code: Maybe[ProcessName] = result("Process of the pins, where that is another.")
    pin_source: Maybe[str] = result("Where the numbers of that come from.")
    filled: list[str] = result("Pointers to the fields that it fills: those that are not given.")
    mean_clearance_mm: float = result(
        "Clearance of pins and holes at the middle of all limits: beside the nominal one where "
        "holes come out small, or pins large.",
        symbol="c",
    )


class ToleranceStudyResponse(AssumingResponse):
    """Effect of tolerances on the pieces."""

    quantities: QuantitiesOut = result("Each quantity asked, or with a limit.")
    samples: int = result("Pieces drawn.")
    fits: int = result("Pieces that have room at all crank angles, over the whole turn.")
    binds_in_turning: int = result(
        "Pieces that go together at some crank angles, and jam at others."
    )
    does_not_fit: int = result("Pieces that go together at no crank angle.")
    cannot_assemble: EstimateOut = result(
        "Share of the pieces that do not fit, with its interval: they are not in the percentiles, "
        "and fail the yield."
    )
    cannot_work: int = result(
        "Pieces that fit and cannot work under the torque of what is asked, none of a backlash "
        "alone: they are not in the percentiles, and fail the yield."
    )
    process: Maybe[ProcessOut] = result("How the parts are made, where that is said.")
    fit_contributions: Maybe[list[ContributionOut]] = result(
        "What each tolerance does to whether the pieces fit, the largest first: in the place of "
        "the contributions to a quantity, where fewer than 95 % of the pieces fit."
    )
    accuracy: StudyAccuracyOut
    warnings: Maybe[list[WarningOut]] = None
