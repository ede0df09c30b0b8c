"""What the notices say: the limit that a result strains, why it matters and how to mend it."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class NoticeKind:
    """What a notice of one code says, in English.

    Attributes
    ----------
    text : str
        What is strained and what it means; what a notice names stands in braces.
    title : str
        Its name.
    tests : str
        What is looked at.
    why : str
        Why it matters.
    mend : str
        What to do about it.
    """

    text: str
    title: str
    tests: str
    why: str
    mend: str


_APPROXIMATION = {
    "tests": "Whether the approximate peak is asked for where it is stated: 3 to 5 pins, 1 or 2 "
    "satellites evenly spaced, linear contact.",
    "why": "Outside it drifts: by 10 % at 6 pins and by 40 % at 12.",
    "mend": "Use the exact peak force; the approximation is only shown beside it.",
}

NOTICES = {
    "approximation_exponent": NoticeKind(
        "The approximation is made for linear contacts, exponent 1.",
        title="Approximation for other contacts",
        **_APPROXIMATION,
    ),
    "approximation_range": NoticeKind(
        "The approximation is stated for {field} from {low} to {high} only; here it is {value}.",
        title="Approximation outside its range",
        **_APPROXIMATION,
    ),
    "approximation_spacing": NoticeKind(
        "The approximation is made for two cranks half a turn apart.",
        title="Approximation for other cranks",
        **_APPROXIMATION,
    ),
    "clearance": NoticeKind(
        "The hole is larger than pin and eccentricity need, {limit:.9g} mm: no pair touches until "
        "the output has turned through the lost motion, and the load sharing differs.",
        title="Clearance of pin and hole",
        tests="Whether the hole is larger than pin radius and eccentricity together.",
        why="No pair touches until the output has turned through the lost motion, and fewer pairs "
        "share the load than calculated.",
        mend="Make the hole radius the sum of pin radius and eccentricity, or keep the clearance "
        "small against the elastic approach.",
    ),
    "clearance_like_eccentricity": NoticeKind(
        "The clearance is {ratio:.3g} of the eccentricity: such mechanisms move, with very much "
        "play; clearances of working ones are near a hundredth.",
        title="Clearance like the eccentricity",
        tests="Whether the clearance is less than half of the eccentricity.",
        why="Such mechanisms move, with very much play; mostly one of the sizes is a slip.",
        mend="Look at radii and eccentricity; make the hole smaller.",
    ),
    "cycloid_difference": NoticeKind(
        "The ring has {difference} pins more than a satellite has lobes: where the branches of "
        "such a curve cross, its tips are cut off, so that fewer pins carry than the ratio of the "
        "ring's forces is made for.",
        title="Lobes cut off",
        tests="Whether the ring has one pin more than a satellite has lobes.",
        why="With a larger difference the branches of the cycloid cross and its tips are cut off: "
        "fewer pins carry, and the ratio of the ring's forces is another.",
        mend="Choose a difference of 1, or give the ratio of the forces.",
    ),
    "diameters_as_radii": NoticeKind(
        "Are diameters given as radii? With radii of {pin:.6g} and {hole:.6g} mm the parts fit.",
        title="Diameters as radii?",
        tests="Whether half of the radii would fit where these leave a clearance like the "
        "eccentricity.",
        why="Drawings say diameters; typed as radii they double every size.",
        mend="If they are diameters, halve both.",
    ),
    "eccentricity_assumed": NoticeKind(
        "The eccentricity is taken as hole less pin radius: clearance or interference would not be "
        "seen.",
        title="Eccentricity assumed",
        tests="Whether the eccentricity is given beside pin and hole.",
        why="It is taken as hole radius − pin radius, so that pin and hole fit: clearance or "
        "interference would not be seen.",
        mend="Enter the eccentricity of the cranks.",
    ),
    "eccentricity_doubled": NoticeKind(
        "Is the eccentricity given twice as large, as the stroke? With {eccentricity:.6g} mm the "
        "parts fit.",
        title="Eccentricity doubled?",
        tests="Whether half of the eccentricity would fit.",
        why="The stroke of a crank is twice its eccentricity.",
        mend="If it is the stroke, halve it.",
    ),
    "eccentricity_forgotten": NoticeKind(
        "Is the eccentricity left out of the hole? With a radius of {hole:.6g} mm the parts fit.",
        title="Eccentricity left out?",
        tests="Whether the hole's radius with the eccentricity would fit.",
        why="The pin moves in its hole on a circle of the eccentricity: the hole is larger by it.",
        mend="Make the hole larger by the eccentricity.",
    ),
    "fatigue_no_basis": NoticeKind(
        "Fatigue is not checked: no endurance limit is known. That of a steel follows from its "
        "tensile strength; else give the limit, and the tensile strength with it.",
        title="Fatigue not checked: no limit",
        tests="Whether an endurance limit is known.",
        why="That of a steel follows from its tensile strength, where this is known; for bronzes, "
        "irons and plastics there is no such rule.",
        mend="Give the endurance limit, and the tensile strength where it is not known.",
    ),
    "fatigue_no_notch": NoticeKind(
        "Fatigue is not checked: neither a notch nor its factor is given, and the edge of a press "
        "fit alone takes half of the strength and more.",
        title="Fatigue not checked: no notch factor",
        tests="Whether a notch or its factor is given.",
        why="The edge of a press fit alone takes half of the strength and more: a part without any "
        "notch is not to be assumed.",
        mend="Give the fatigue notch factor of the seat, the notch itself, or the endurance limit.",
    ),
    "hardly_known": NoticeKind(
        "Hardly anything is known of the result: its relative error may be {error:.2g}, because "
        "rounding of the input is magnified so much.",
        title="Hardly anything is known",
        tests="Whether the stated relative error stays below 1 %.",
        why="The numbers given are known to some 16 digits only; here a small difference of large "
        "ones decides, of which hardly a digit is left.",
        mend="Move the sizes away from where they nearly cancel: a ratio from cos θ, a limit from "
        "its neighbour, an angle from its pole.",
    ),
    "hertz_half_width": NoticeKind(
        "The half-width of the contact is {ratio:.4g} of the pin's radius; Hertz assumes a narrow "
        "contact and is off by more than 1 %: use the conformal pressure, or where there is none, "
        "for very different materials, take it as a rough guide.",
        title="Contact too wide for Hertz",
        tests="Whether the half-width of the contact stays small against the pin radius.",
        why="Hertz's theory assumes a narrow contact; here its pressure is off by more than 1 %.",
        mend="Use the pressure of the conformal contact where it is given; else take the number as "
        "a guide, enlarge the hole or lower the load.",
    ),
    "hertz_impossible": NoticeKind(
        "The half-width of the contact is {ratio:.4g} of the pin's radius: wider than the pin, so "
        "that Hertz does not apply at all, and for very different materials no conformal solution "
        "is at hand: make the hole larger or the load smaller.",
        title="No theory for this contact",
        tests="Whether the calculated contact is wider than the pin.",
        why="There Hertz's theory does not apply, and for different materials no conformal "
        "solution is known; the pressure means nothing.",
        mend="Enlarge the hole, lower the load or use one material for both.",
    ),
    "hertz_line_width": NoticeKind(
        "The half-width of the contact is {ratio:.4g} of the roller's radius: Hertz is off by more "
        "than 1 %.",
        title="Wide contact of the roller",
        tests="Whether the contact is narrow beside the roller's radius.",
        why="Hertz assumes a narrow contact.",
        mend="Enlarge the radius of the teeth or the roller, or lower the load.",
    ),
    "hole_diameter_as_radius": NoticeKind(
        "Is the hole's diameter given as its radius? With {hole:.6g} mm the parts fit.",
        title="Hole: diameter as radius?",
        tests="Whether half of the hole's radius would fit.",
        why="Only the hole is then twice as large.",
        mend="If it is the diameter, halve it.",
    ),
    "holes_overlap": NoticeKind(
        "Neighbouring holes of a satellite overlap: there is no material between them.",
        title="Holes overlap",
        tests="Whether there is material left between neighbouring holes of a satellite.",
        why="Overlapping holes leave no wall to carry the force.",
        mend="Enlarge the pin circle, or take fewer pins or smaller holes.",
    ),
    "interference": NoticeKind(
        "The hole is smaller than pin radius + eccentricity, {limit:.9g} mm: pin and satellite "
        "interfere and cannot be assembled.",
        title="Hole too small",
        tests="Whether the hole is smaller than pin radius and eccentricity together.",
        why="Pin and satellite cut into each other: the mechanism cannot be assembled.",
        mend="Enlarge the hole, or take a smaller pin or eccentricity.",
    ),
    "large_deflection": NoticeKind(
        "The most loaded part bends by more than a tenth of its length: the formulas are those of "
        "small deflections.",
        title="Large deflection",
        tests="Whether the deflection stays below a tenth of the length.",
        why="The formulas are those of small deflections; beyond that they are off by more than "
        "about 1 %.",
        mend="Lower the load, shorten the part or make it thicker.",
    ),
    "large_rotation": NoticeKind(
        "The output turns by {share:.2g} of the eccentricity under load: clearance or compliance "
        "is large for such a mechanism.",
        title="Large rotation under load",
        tests="Whether the output turns by little of the eccentricity under load.",
        why="Clearance or compliance is large for such a mechanism: pins leave the places at which "
        "the parts are meant to bear.",
        mend="Lower the clearance or the load, or stiffen the contacts.",
    ),
    "life_beyond_strength": NoticeKind(
        "The line of finite life is a fit for tensile strengths of {low:.4g} to {high:.4g} MPa; of "
        "{value:.4g} MPa its end is taken.",
        title="Life beyond its range",
        tests="Whether the tensile strength is one that the line of finite life is a fit for.",
        why="Below and above, the strength at a thousand cycles is that of the nearest end of the "
        "fit: life and finite strength are a rough guide.",
        mend="Give a strength within the range, or judge by the endurance limit alone.",
    ),
    "next_hole": NoticeKind(
        "A satellite is turned by more than half the pitch of its holes: it is put on the pins by "
        "the holes next to them.",
        title="Other holes",
        tests="Whether each satellite goes onto the pins by the holes that its phase says.",
        why="Turned by more than half the pitch of its holes it goes on by the next ones.",
        mend="Nothing, if it is meant so.",
    ),
    "no_piece_fits": NoticeKind(
        "None of the pieces fits: more of them would not help; larger clearances or smaller "
        "tolerances do.",
        title="No piece fits",
        tests="Whether any of the pieces goes together at all crank angles.",
        why="Percentiles of what cannot be put together say nothing.",
        mend="Enlarge the clearance, or tighten what does most to the fit.",
    ),
    "no_ring_force": NoticeKind(
        "The ring's force along the crank is left out: with involute teeth bearings carry more, "
        "with a ring of pins less.",
        title="Ring left out",
        tests="Whether the ring's force along the crank is known.",
        why="With involute teeth it adds to the force of the pins, with a ring of pins it opposes "
        "it: the life differs several times.",
        mend="Give the teeth, the circle of the ring's pins, or the ratio of the forces.",
    ),
    "notch_beyond_strength": NoticeKind(
        "The factor of the notch is a fit for tensile strengths of {low:.4g} to {high:.4g} MPa; of "
        "{value:.4g} MPa its end is taken.",
        title="Notch beyond its range",
        tests="Whether the tensile strength is one that the notch's fit is made for.",
        why="Below and above, the sensitivity to the notch is that of the nearest end of the fit.",
        mend="Give the fatigue notch factor itself.",
    ),
    "pin_diameter_as_radius": NoticeKind(
        "Is the pin's diameter given as its radius? With {pin:.6g} mm the parts fit.",
        title="Pin: diameter as radius?",
        tests="Whether half of the pin's radius would fit.",
        why="Only the pin is then twice as thick.",
        mend="If it is the diameter, halve it.",
    ),
    "pin_bending_uncoupled": NoticeKind(
        "A pin is loaded by several satellites at once: how each bends it for the others is left "
        "out, 1 to 2 % of the largest force.",
        title="Pin bent by several satellites",
        tests="Whether each loaded pin is loaded by one satellite only.",
        why="How the force of one satellite bends the pin for the others is left out: 1 to 2 % of "
        "the largest force.",
        mend="Keep the difference in mind, or stiffen the pins.",
    ),
    "low_cycle_fatigue": NoticeKind(
        "The pin stands fewer than 1000 cycles: so few that the line of its life does not hold.",
        title="Few cycles",
        tests="Whether the pin stands 1000 cycles.",
        why="The line of finite life holds from 1000 to a million cycles; below it the pin yields "
        "in every turn.",
        mend="Thicken the pin or lower the load.",
    ),
    "pins_overlap": NoticeKind(
        "Neighbouring pins overlap: there is no room for them on their circle.",
        title="Pins overlap",
        tests="Whether neighbouring pins keep apart on their circle.",
        why="Two pins cannot stand in one place.",
        mend="Enlarge the pin circle, or take fewer or thinner pins.",
    ),
    "pressed_without_load": NoticeKind(
        "Pins and holes press without load: there is no play, and the mechanism can be assembled "
        "only by force.",
        title="Pressed without load",
        tests="Whether pins and holes are free of each other without load.",
        why="Errors or interference use up the clearance: there is no play, and assembly needs "
        "force.",
        mend="Enlarge the clearance, or tighten the tolerances of place.",
    ),
    "ratio_not_whole": NoticeKind(
        "The ratio {ratio:.6g} is no whole number: a cycloid disc with one lobe less than the ring "
        "has pins has as many lobes as its ratio says.",
        title="Ratio of a cycloid",
        tests="Whether the ratio of a cycloid disc with one lobe less than the ring has pins is "
        "whole.",
        why="Such a disc has as many lobes as its ratio says.",
        mend="Give the teeth, or a whole ratio.",
    ),
    "ratio_sign": NoticeKind(
        "The ratio is taken as {ratio:.6g}: its sign says that the output turns the other way, "
        "which that of every such mechanism does.",
        title="Sign of the ratio",
        tests="Whether the ratio is given without a sign.",
        why="The output of every such mechanism turns against the crank: the sign is known.",
        mend="Nothing, if it is meant so.",
    ),
    "reference_depth": NoticeKind(
        "The reference depth is {ratio:.3g} times the hole's radius; from {low} to {high} a "
        "half-space stands for a hole.",
        title="Reference depth out of range",
        tests="Whether the depth to which the hole's approach is counted is near the hole's "
        "radius.",
        why="A half-space stands for the hole only there; the stiffness is off elsewhere.",
        mend="Take a depth of half to one and a half hole radii, or leave it out.",
    ),
    "sand_cast": NoticeKind(
        "The bronze is the sand-cast CuSn12-C-GS, whose limit is not known; the centrifugally cast "
        "CuSn12-C-GZ is a material of its own.",
        title="Sand-cast bronze",
        tests="Whether the bronze is the centrifugally cast one, whose limit is known.",
        why="The limit 425 MPa holds for the centrifugally cast bronze only; the sand-cast one "
        "carries less, how much is not known.",
        mend="Take the centrifugally cast bronze, or enter a limit of your own.",
    ),
    "size_beyond_range": NoticeKind(
        "The factor of the size is stated for diameters of {low:.4g} to {high:.4g} mm; it is "
        "{value:.4g} mm.",
        title="Size beyond its range",
        tests="Whether the diameter is one that the factor of the size is stated for.",
        why="Outside, the factor is extended, not tested: thick parts may be weaker.",
        mend="Give the endurance limit of the part itself.",
    ),
    "satellite_idle": NoticeKind(
        "Satellite {satellite} carries nothing over the whole turn, as others touch before it: its "
        "bearing has no life, and that of all together is theirs.",
        title="A satellite that carries nothing",
        tests="Whether every satellite carries somewhere over the turn.",
        why="Other satellites touch before it all the way round: they take its share, and its "
        "bearing has no life.",
        mend="Tighten the tolerances of place, turn the disc to the others, or let the satellites "
        "give way.",
    ),
    "short_pin": NoticeKind(
        "A satellite lies within half a pin diameter of the carrier: shear governs such a short "
        "pin, and its seat gives way more than it bends.",
        title="Short pin",
        tests="Whether each satellite is at least half a pin diameter from the carrier.",
        why="So close to its seat a pin is sheared more than bent, and the seat gives way.",
        mend="Take the bending for a rough guide and look at the equivalent stress.",
    ),
    "short_roller": NoticeKind(
        "The cylinder is shorter than its diameter: a beam that short deforms mostly by shear and "
        "at its clamping, so the stiffness is a rough guide.",
        title="Short roller",
        tests="Whether the roller's cylinder is at least as long as its diameter.",
        why="A shorter beam deforms mostly by shear and at its clamping; its stiffness is a rough "
        "guide.",
        mend="Lengthen the roller, or check its stiffness by finite elements.",
    ),
    "short_shaft": NoticeKind(
        "The shaft is short for its diameter: shear, which the formulas leave out, adds more than "
        "5 % to its deflection.",
        title="Short shaft",
        tests="Whether the shaft is at least 3.3 times as long as it is thick.",
        why="Shear, which the formulas leave out, then adds more than 5 % to the deflection.",
        mend="Add the deflection by shear, or take the number as a lower limit.",
    ),
    "small_arm": NoticeKind(
        "A contact line comes close to phi = 0, where the load has no arm: the line load is "
        "concentrated there, more than elastic rollers would let it be.",
        title="Small arm of the load",
        tests="Whether a contact line comes close to φ = 0.",
        why="There the load has hardly an arm about the axis: the line load grows steeply, more "
        "than elastic rollers would let it.",
        mend="Move the end of the line away from the precession centre.",
    ),
    "sphere_below_roller": NoticeKind(
        "The sphere is smaller than the cylinder: the formulas take the sphere for rigid and the "
        "cylinder for the weak section.",
        title="Sphere smaller than the roller",
        tests="Whether the sphere is at least as thick as the cylinder.",
        why="The formulas take the sphere for rigid and the cylinder for the weak section.",
        mend="Enlarge the sphere or take a thinner cylinder.",
    ),
    "sphere_too_wide": NoticeKind(
        "The sphere is wider than its diameter: no sphere is.",
        title="Sphere wider than its diameter",
        tests="Whether the width of a sphere stays below its diameter.",
        why="No sphere is wider than its diameter: the sizes contradict each other.",
        mend="Correct the width or the diameter of the sphere.",
    ),
    "strength_beyond_size": NoticeKind(
        "The strengths of the material hold up to {limit:.4g} mm of diameter: thicker pins are "
        "weaker.",
        title="Strength beyond its size",
        tests="Whether the pin is as thin as the strengths of its material hold for.",
        why="Thicker steel hardens less deep: it is weaker than the table says.",
        mend="Give the strengths of the material at this size.",
    ),
    "steep_mesh": NoticeKind(
        "The operating pressure angle of the teeth is above 55°: the ring presses the satellites "
        "more than it turns them.",
        title="Steep teeth",
        tests="Whether the operating pressure angle of the teeth is at most 55°.",
        why="Few teeth of difference need a large angle; then the ring presses the satellites "
        "apart more than it turns them.",
        mend="Make the eccentricity smaller or the module larger.",
    ),
    "thin_without_sleeve": NoticeKind(
        "The pin is thinner than what touches the holes, and there is no sleeve on it: losses and "
        "wear are those of a bare pin as thick as the contact.",
        title="Thin pin without a sleeve",
        tests="Whether the pin is as thick as its contact where there is no sleeve.",
        why="Without a sleeve nothing but the pin itself touches the holes: one of the two sizes "
        "is wrong, or there is a sleeve, which slides less.",
        mend="Say that there is a sleeve, or give the pin the diameter of its contact.",
    ),
    "too_few_fit": NoticeKind(
        "Percentiles are left out for which {fits} pieces that fit are too few.",
        title="Too few fit",
        tests="Whether enough pieces fit for every percentile.",
        why="A rare percentile needs many pieces.",
        mend="Draw more pieces, or make more of them fit.",
    ),
    "twice_the_eccentricity": NoticeKind(
        "Is twice the eccentricity in the radius of the hole? It takes it once: {hole:.6g} mm; "
        "twice is meant of diameters.",
        title="Twice the eccentricity?",
        tests="Whether the hole's radius less once the eccentricity would fit.",
        why="The diameter of a hole takes twice the eccentricity, its radius takes it once.",
        mend="If so, take the eccentricity off once.",
    ),
    "unloaded_flank": NoticeKind(
        "The limits of roller {roller} lie on the flank that the torque unloads: the loaded one is "
        "half a turn of phi further, with the same force.",
        title="Limits on the unloaded flank",
        tests="Whether the given limits of φ lie on the flank that the torque loads.",
        why="The loaded flank is half a turn further; the force is the same, its place is not.",
        mend="Add or take away 180° at both limits, or reverse the torque.",
    ),
}
"""Limits of validity, by code."""
