"""What every result carries besides its numbers: its accuracy, and the limits it strained."""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

from core.arrays import Number

ROUNDING = 2.0**-52
"""Spacing of the doubles next to 1: the unit in which rounding errors are counted."""

NOTICES = {
    "approximation_exponent": "The approximation is made for linear contacts, exponent 1.",
    "approximation_range": "The approximation is stated for {field} from {low} to {high} only; "
    "here it is {value}.",
    "approximation_spacing": "The approximation is made for two cranks half a turn apart.",
    "clearance": "The hole is larger than pin and eccentricity need, {limit:.9g} mm: no pair "
    "touches until the output has turned through the lost motion, and the load sharing differs.",
    "clearance_like_eccentricity": "The clearance is {ratio:.3g} of the eccentricity: such "
    "mechanisms move, with very much play; clearances of working ones are near a hundredth.",
    "cycloid_difference": "The ring has {difference} pins more than a satellite has lobes: where "
    "the branches of such a curve cross, its tips are cut off, so that fewer pins carry than the "
    "ratio of the ring's forces is made for.",
    "diameters_as_radii": "Are diameters given as radii? With radii of {pin:.6g} and {hole:.6g} mm "
    "the parts fit.",
    "eccentricity_assumed": "The eccentricity is taken as hole less pin radius: clearance or "
    "interference would not be seen.",
    "eccentricity_doubled": "Is the eccentricity given twice as large, as the stroke? With "
    "{eccentricity:.6g} mm the parts fit.",
    "eccentricity_forgotten": "Is the eccentricity left out of the hole? With a radius of "
    "{hole:.6g} mm the parts fit.",
    "fatigue_no_basis": "Fatigue is not checked: no endurance limit is known. That of a steel "
    "follows from its tensile strength; else give the limit, and the tensile strength with it.",
    "fatigue_no_notch": "Fatigue is not checked: neither a notch nor its factor is "
    "given, and the edge of a press fit alone takes half of the strength and more.",
    "hardly_known": "Hardly anything is known of the result: its relative error may be "
    "{error:.2g}, because rounding of the input is magnified so much.",
    "hertz_half_width": "The half-width of the contact is {ratio:.4g} of the pin's radius; Hertz "
    "assumes a narrow contact and is off by more than 1 %: use the conformal pressure, or where "
    "there is none, for very different materials, take it as a rough guide.",
    "hertz_impossible": "The half-width of the contact is {ratio:.4g} of the pin's radius: wider "
    "than the pin, so that Hertz does not apply at all, and for very different materials no "
    "conformal solution is at hand: make the hole larger or the load smaller.",
    "hertz_line_width": "The half-width of the contact is {ratio:.4g} of the roller's radius: "
    "Hertz is off by more than 1 %.",
    "hole_diameter_as_radius": "Is the hole's diameter given as its radius? With {hole:.6g} mm the "
    "parts fit.",
    "holes_overlap": "Neighbouring holes of a satellite overlap: there is no material between "
    "them.",
    "interference": "The hole is smaller than pin radius + eccentricity, {limit:.9g} mm: pin and "
    "satellite interfere and cannot be assembled.",
    "large_deflection": "The most loaded part bends by more than a tenth of its length: the "
    "formulas are those of small deflections.",
    "large_rotation": "The output turns by {share:.2g} of the eccentricity under load: clearance "
    "or compliance is large for such a mechanism.",
    "life_beyond_strength": "The line of finite life is a fit for tensile strengths of {low:.4g} "
    "to {high:.4g} MPa; of {value:.4g} MPa its end is taken.",
    "next_hole": "A satellite is turned by more than half the pitch of its holes: it is put on the "
    "pins by the holes next to them.",
    "no_piece_fits": "None of the pieces fits: more of them would not help; larger clearances or "
    "smaller tolerances do.",
    "no_ring_force": "The ring's force along the crank is left out: with involute teeth bearings "
    "carry more, with a ring of pins less.",
    "notch_beyond_strength": "The factor of the notch is a fit for tensile strengths of {low:.4g} "
    "to {high:.4g} MPa; of {value:.4g} MPa its end is taken.",
    "pin_diameter_as_radius": "Is the pin's diameter given as its radius? With {pin:.6g} mm the "
    "parts fit.",
    "pin_bending_uncoupled": "A pin is loaded by several satellites at once: how each bends it for "
    "the others is left out, 1 to 2 % of the largest force.",
    "low_cycle_fatigue": "The pin stands fewer than 1000 cycles: so few that the line of its life "
    "does not hold.",
    "pins_overlap": "Neighbouring pins overlap: there is no room for them on their circle.",
    "pressed_without_load": "Pins and holes press without load: there is no play, and the "
    "mechanism can be assembled only by force.",
    "ratio_not_whole": "The ratio {ratio:.6g} is no whole number: a cycloid disc with one lobe "
    "less than the ring has pins has as many lobes as its ratio says.",
    "ratio_sign": "The ratio is taken as {ratio:.6g}: its sign says that the output turns the "
    "other way, which that of every such mechanism does.",
    "reference_depth": "The reference depth is {ratio:.3g} times the hole's radius; from {low} to "
    "{high} a half-space stands for a hole.",
    "sand_cast": "The bronze is the sand-cast CuSn12-C-GS, whose limit is not known; the "
    "centrifugally cast CuSn12-C-GZ is a material of its own.",
    "size_beyond_range": "The factor of the size is stated for diameters of {low:.4g} to "
    "{high:.4g} mm; it is {value:.4g} mm.",
    "satellite_idle": "Satellite {satellite} carries nothing over the whole turn, as others touch "
    "before it: its bearing has no life, and that of all together is theirs.",
    "short_pin": "A satellite lies within half a pin diameter of the carrier: shear governs such a "
    "short pin, and its seat gives way more than it bends.",
    "short_roller": "The cylinder is shorter than its diameter: a beam that short deforms mostly "
    "by shear and at its clamping, so the stiffness is a rough guide.",
    "short_shaft": "The shaft is short for its diameter: shear, which the formulas leave out, "
    "adds more than 5 % to its deflection.",
    "small_arm": "A contact line comes close to phi = 0, where the load has no arm: the line load "
    "is concentrated there, more than elastic rollers would let it be.",
    "sphere_below_roller": "The sphere is smaller than the cylinder: the formulas take the sphere "
    "for rigid and the cylinder for the weak section.",
    "sphere_too_wide": "The sphere is wider than its diameter: no sphere is.",
    "strength_beyond_size": "The strengths of the material hold up to {limit:.4g} mm of diameter: "
    "thicker pins are weaker.",
    "steep_mesh": "The operating pressure angle of the teeth is above 55°: the ring presses the "
    "satellites more than it turns them.",
    "thin_without_sleeve": "The pin is thinner than what touches the holes, and there is no sleeve "
    "on it: losses and wear are those of a bare pin as thick as the contact.",
    "too_few_fit": "Percentiles are left out for which {fits} pieces that fit are too few.",
    "twice_the_eccentricity": "Is twice the eccentricity in the radius of the hole? It takes it "
    "once: {hole:.6g} mm; twice is meant of diameters.",
    "unloaded_flank": "The limits of roller {roller} lie on the flank that the torque unloads: the "
    "loaded one is half a turn of phi further, with the same force.",
}
"""Limits of validity in English, by code."""


METHODS = {
    "approximation": "approximation (2018, eq. 5)",
    "bisection": "bisection",
    "bracketing": "sampling, then brackets narrowed to neighbouring numbers",
    "clenshaw_curtis_phi": "Clenshaw-Curtis in phi",
    "clenshaw_curtis_shaft": "Clenshaw-Curtis along the shaft",
    "clenshaw_curtis_z": "Clenshaw-Curtis in z",
    "closed_form": "closed form",
    "closed_form_even": "closed form: evenly spaced pairs",
    "closed_form_gaps": "closed form, contacts closed in the order of their gaps",
    "closed_form_newton": "closed form, Newton's method",
    "equal_sharing": "equal sharing (Zyl)",
    "gauss_legendre_phi": "Gauss-Legendre in phi",
    "gauss_legendre_shaft": "Gauss-Legendre along the shaft",
    "gauss_legendre_z": "Gauss-Legendre in z",
    "golden_section": "sampling, golden section",
    "graded_quadrature": "Gauss-Legendre quadrature along z, panels graded to the known "
    "singularities",
    "graded_z": "graded Gauss-Legendre in z",
    "locus_support": "locus of the moment: sampled by segments, extremes narrowed",
    "mohr": "Mohr's integral in closed form",
    "monte_carlo": "random pieces, percentiles by order statistics",
    "monte_carlo_double": "random pieces, twice the crank angles",
    "monte_carlo_finest": "scatter of the pieces, four times the crank angles",
    "monte_carlo_half": "random pieces, half the crank angles",
    "monte_carlo_quarter": "random pieces, a quarter of the crank angles",
    "multiple_closed_form": "closed form in multiple precision",
    "multiple_peak": "peak refined in multiple precision",
    "multiple_sorting": "sorting in multiple precision",
    "multiple_tanh_sinh": "tanh-sinh quadrature in multiple precision",
    "newton": "Newton",
    "newton_bracket": "Newton's method in a bracket",
    "sampling": "sampling",
    "sampling_dense": "four times as many samples, every summit narrowed by golden section",
    "sampling_zoomed": "sampling, every summit narrowed by golden section",
    "segment_exact": "segment-exact",
    "segments_cubic": "segment-exact, roots of a cubic",
    "segments_equal": "segment-exact, equal sharing: largest at a switching angle",
    "segments_gauss": "segment-exact, Gauss-Legendre quadrature",
    "segments_roots": "segment-exact, bracketed roots",
    "segments_tanh_sinh": "segment-exact, tanh-sinh quadrature",
    "simpson_phi": "Simpson in phi",
    "simpson_shaft": "Simpson along the shaft",
    "simpson_z": "Simpson in z",
    "sorting": "sorting",
    "tanh_sinh_phi": "tanh-sinh in phi",
    "tanh_sinh_shaft": "tanh-sinh along the shaft",
    "tanh_sinh_z": "tanh-sinh in z",
    "trapezoid_phi": "trapezoid in phi",
    "trapezoid_shaft": "trapezoid along the shaft",
    "trapezoid_z": "trapezoid in z",
}
"""Methods of the calculations and of their studies in English, by code."""


class Accuracy(NamedTuple):
    """How a number was got, how wrong it may be, and what it took.

    Attributes
    ----------
    method : str
        How, a key of `METHODS`.
    relative_error : float or array
        Bound or honest estimate of the relative error against the exact value for the input
        as given, dimensionless: rounding, truncation and the input's own condition together.
    evaluations : int
        How many times the function behind the method was evaluated (1 for a formula).
    """

    method: str
    relative_error: Number
    evaluations: int


@dataclass(frozen=True)
class Notice:
    """A limit of validity that the result strains; the number is given all the same.

    Attributes
    ----------
    code : str
        Stable name of the limit, a key of `NOTICES`.
    params : dict of str to object
        What its text names: dimensionless numbers, and names of core parameters.
    """

    code: str
    params: dict[str, Any] = field(default_factory=dict)

    @property
    def detail(self) -> str:
        """What is strained and what it means, in English, with the core's names."""
        return NOTICES[self.code].format(**self.params)


HARDLY_KNOWN = 1e-2
"""Relative error above which a number is no guide."""


def poorly_known(accuracy: Accuracy) -> tuple[Notice, ...]:
    """Notice that hardly anything is known of a result, where its stated error says so.

    Parameters
    ----------
    accuracy : Accuracy
        Of one design.

    Returns
    -------
    tuple of Notice
        One, or none.

    Examples
    --------
    >>> poorly_known(Accuracy("closed_form", 1e-15, 1))
    ()
    >>> [notice.code for notice in poorly_known(Accuracy("closed_form", 0.5, 1))]
    ['hardly_known']
    """
    error = float(accuracy.relative_error)
    return (Notice("hardly_known", {"error": error}),) if error > HARDLY_KNOWN else ()
