"""All codes that the service says, one for each fact, with one kind and its words in English.

Where a refusal, a warning and the reason of a check are the same fact, they have the same code and
the same words. A code comes with parameters, so that whoever shows it can say it in another
language and with other names; here it has the core's names and SI units (in warnings, mm). The
parameters `field` and `other` are names of core parameters. What a check is called and why it is
made stands at the check (`core.checks`).
"""

from dataclasses import dataclass
from functools import partial
from typing import Literal

Kind = Literal["invalid", "impossible", "limit", "unknown", "check"]


@dataclass(frozen=True, slots=True)
class Code:
    """What is said under one code, in English.

    Attributes
    ----------
    kind : Kind
        `invalid`: one parameter is wrong. `impossible`: all are allowed, and yet there is no such
        mechanism. `limit`: a result strains a limit of validity, or lacks what it is judged by; it
        is given all the same. `unknown`: why a check stands as it does, where numbers do not say
        it. `check`: a check of designs, of which calculations that have no checks warn or refuse.
    text : str
        Of what is invalid the rest of a sentence that starts with the parameter's name; of what is
        impossible or unknown a sentence without its full stop. What a text names stands in braces.
    title, tests, why, mend : str
        Of a warning its name, what is looked at, why it matters, and what to do about it.
    """

    kind: Kind
    text: str
    title: str = ""
    tests: str = ""
    why: str = ""
    mend: str = ""


_limit, _check = partial(Code, "limit"), partial(Code, "check")

_INVALID = {
    "at_most": "must be at most {field}, {limit:.9g}",
    "below_working": "must be at least {limit:.9g}, the torque times its factor",
    "beyond_support": "must be at most {limit:.9g}, half a contact length from the end of {field}",
    "different_length": "must have {expected} entries, has {actual}",
    "different_sum": "must have lengths that add up to {field} and {other}, {needed_length:g} m, "
    "not {given_length:g} m",
    "drawn_cup": "must be those of a roller, or with an outer diameter: a drawn cup or a cage of "
    "needles has no ring that could roll by itself",
    "finite_number": "must be a finite number",
    "first_order_only": "must be of first order beside {field}: what satellites give is not known "
    "in exact geometry",
    "flanks_first_order": "must be of first order beside {field}: flanks that are turned against "
    "each other say nothing of tips and roots",
    "flanks_not_drawn": "must be 0: flanks that are turned against each other say nothing of tips "
    "and roots, so that there is no outline to draw",
    "greater_than": "must be greater than {limit:.15g}",
    "greater_than_equal": "must be at least {limit:.15g}",
    "in_carrier": "must be at least half of {field}, {limit:.9g}: the contact would reach into the "
    "carrier",
    "infinite_line": "must not lie at a pole, a multiple of half a turn less {field}: the line is "
    "infinitely long there",
    "larger_than": "must be larger than {field}, {limit:.9g}",
    "less_than": "must be less than {limit:.15g}",
    "less_than_equal": "must be at most {limit:.15g}",
    "more_than_whole": "must be at most {limit:d}, the number of satellites: none carries more "
    "than all of the torque",
    "needed": "is needed: this or {field}",
    "no_arm": "must not be a multiple of half a turn: there the contact has no arm",
    "no_fit": "must be an ISO 286 class of the hole and one of the pin, such as H7/f7",
    "no_class": "must be an ISO 286 class of the table, such as m6 or H7",
    "no_conformal_pressure": "must have a conformal pressure",
    "no_cycloid": "must be larger than the eccentricity times 1 more than {field}, {limit:.9g}: "
    "there is no such cycloid",
    "no_mesh": "must be at least {limit:.9g}: teeth of this {field} do not mesh any nearer",
    "no_sleeve": "must be smaller than twice {field}, {limit:.9g}: there is no room for a sleeve",
    "no_tooth_form": "must be cycloid or involute: of other teeth no form is known here, and none "
    "is drawn",
    "not_in_table": "must be one of {values}",
    "not_sourced": "is needed beside the name: no source has that of {material}",
    "not_single": "must be one number, not an array",
    "not_zero": "must not be 0",
    "only_one": "excludes {field}: give one of them",
    "other_branch": "must lie on the same side of the pole, a multiple of half a turn less "
    "{other}, as {field}: the line is infinitely long there",
    "odd_ring_pins": "is of an even number of pins, and the ring has {pins:d}",
    "other_pitch": "must be {limit:.9g} from the place of the first satellite, as on the pins",
    "right_angle": "must be smaller than a right angle",
    "roller_without_arm": "puts roller {roller} at a multiple of half a turn: there its "
    "contact has no arm",
    "smaller_than": "must be smaller than {field}, {limit:.9g}",
    "stages_differ": "must be {other:.9g}, as in the output mechanism",
    "sum_not_one": "must add up to 1, not to {sum:.15g}",
    "too_few": "needs a sample of at least {limit:d}",
    "too_many_pairs": "must be at most {limit:d}, with {satellites} satellites",
    "too_many_phases": "must be smaller: there would be more than {limit:d} driving phases",
    "too_near": "must be at least {field}, {limit:.9g}, from the places of the other satellites",
    "too_short": "must have at least {limit} entries",
    "too_short_range": "must be larger than {limit:.3g}: no driving phase is that short",
    "undercut": "must be smaller than {limit:.9g}: the tool would cut off a part of its own flanks",
    "too_thick": "must be at most twice {field}, {limit:.9g}: thicker, the pin itself would touch "
    "the hole",
}
"""What is wrong with one parameter."""

_IMPOSSIBLE = {
    "beyond_first_order": "The output would turn by more than a radian, of which first order says "
    "nothing: the contacts are too soft or the position is a dead centre",
    "beyond_hertz": "The contact of satellite {satellite} and pin {pin} would be as wide as the "
    "pin: no law of contact reaches so far",
    "cannot_assemble": "Pins and holes press: pin {pin} does not fit into its hole of satellite "
    "{satellite}, and no force of the contacts makes it",
    "no_contact_line": "There is no contact line: the cosine of {field} equals {other}",
    "no_lever": "The contact line of roller {roller} cannot carry a torque: it reaches phi = 0, "
    "at z = 0, where the load has no arm about the axis; keep both its ends on one side of it",
    "no_mechanism": "The holes do not hold their pins, which could pass from one into the next: "
    "they are too large",
    "no_room_in_hole": "The hole of satellite {satellite} is not larger than pin {pin}, or a "
    "deviation leaves nothing of a radius",
    "not_balanced": "The forces cannot be balanced within the range of numbers",
    "not_stable": "The forces do not hold the output: its torque falls as it turns on",
    "no_radius_left": "A deviation leaves nothing of the radius of pin {pin} of the ring, or of "
    "the crank of satellite {satellite}",
    "outside_method": "It lies outside of what the method is made for: of involute teeth 1 to 8 "
    "more in the ring and a reference pressure angle of 14.5 to 30 degrees, of both meshes in "
    "series cycloid discs on ring pins",
    "overflow": "The numbers given leave the range of numbers: {names} would not be finite",
    "ring_jams": "Pin {pin} of the ring stands {depth:.3g} mm within satellite {satellite}, "
    "whichever way that turns: the ring does not let it in",
    "teeth_not_whole": "Flanks are cut away at their roots, or teeth or spaces are pointed: there "
    "is no outline to draw",
    "teeth_interfere": "The teeth run into each other, or touch where they are no involutes",
    "unloaded": "The loads cancel: nothing presses the bearings",
    "valley_lost": "In a valley of the satellite's teeth a pin of the ring is {share:.3g} times as "
    "far off as its path is round there, {radius:.3g} mm: which point it touches cannot be said",
}
"""What cannot be."""

_UNKNOWN = {
    "bearing_overloaded": "The load is beyond what the formula of the life is made for",
    "bearing_slips": "The bearing carries too little for its rolling elements to roll",
    "envelope_unknown": "The sizes of the bearing are not given",
    "no_peak_torque": "No peak torque is given",
    "no_sourced_limit": "Nobody asked for a limit, and no source gives one for such parts",
    "rating_high": "The rating is higher than that of any known bearing of these sizes",
    "rating_low": "The rating is less than a twentieth of what fits: is it given in kN?",
    "thin_wall": "It is thinner than usual",
    "near_undercut": "It is close to where the pins of the ring cut off a part of the flanks: "
    "errors of the parts may take what is left",
    "less_than_usual": "It is less than usual: errors of the parts may take what is left",
    "unusual_teeth": "Only unusual teeth mesh, if any: very low ones, with large profile shifts, "
    "or with hardly any room between the tips",
    "internal_root": "The roots of the ring's teeth are not calculated",
    "no_crossing": "The circles of the tips do not cross",
    "ring_flank_unknown": "It holds of the satellite's flanks; those of the ring hang on its "
    "cutter, which is not given",
    "ring_root_assumed": "It holds of a ring whose roots are as deep as the hob makes those of "
    "the satellite: the ring's cutter is not given",
    "root_strength_unknown": "No strength of the roots is given",
    "teeth_given": "The teeth are given, and judged themselves",
    "tips_overlap": "The tips overlap all round: no tooth can pass another",
    "tooth_errors_unknown": "Involute teeth without errors turn evenly, and of these no errors are "
    "known",
    "wider_than_satellite": "The bearing is wider than the satellite",
    "without_sleeve": "The pins have no sleeves",
    "nothing_judged": "Nothing of it is judged",
    "too_many_ring_pairs": "The ring has {pairs:d} pairs of pins and satellites: it is solved of "
    "up to {limit:d}",
    "teeth_not_judged": "The contact and the strength of the teeth are not calculated",
    "conformal_solution": "Wide contacts have a pressure of their own, which asks for no narrow "
    "one",
    "creep_unknown": "How much of the strength lasts is not known: by one paper printed PETG "
    "creeps in step with the load up to half of it, which is a quarter of the torque; of PLA it "
    "says nothing. Enter the factor that a test of a day under load gives",
    "cranks_deviate": "The balance is known of cranks without deviations only",
    "direction_unknown": "Across its layers no strength of this material is known: say that they "
    "lie flat, enter that strength, or take pins of metal",
    "different_parts": "Satellites differ in how their holes lie against their teeth: each needs a "
    "drawing of its own",
    "discs_out_of_phase": "Each satellite by itself goes onto the pins, all together do not: the "
    "holes of one are turned against those of another",
    "finite_life": "The strength is that for the cycles of the life, one a turn of the satellite "
    "against its crank",
    "friction_unknown": "No friction coefficient of this plastic is known: enter one; friction "
    "lowers the load at which it yields by much",
    "fits_by_bearing_clearance": "The parts go together only as far as the clearance of the "
    "bearings on the cranks lets the satellites move",
    "jams": "The parts go together, but jam in a part of the turn",
    "life_of_teeth": "The limit is that for the loads over the life, by the curves of ISO 6336-2, "
    "which are meant for teeth",
    "life_without_speed": "No input speed is given: how the limit falls over the life is left out",
    "limit_unknown": "No limit of the pressure is known for this material: enter one. The pitting "
    "limit of tables of gears or worm wheels will do, that of its maker for such a contact, or of "
    "a test of this pair",
    "mass_unknown": "No mass of a satellite is given",
    "necessary_only": "It holds, which is necessary and not enough: once, cold, dry, of solid "
    "material",
    "no_plastic_fatigue": "No source says how many turns such a plastic bears: run the pair under "
    "its load for as long as it is to last",
    "not_printed": "Only printed parts have infill behind their walls",
    "plastic_limit_unknown": "No source gives a pressure that such a plastic bears for long: enter "
    "one of a test of this pin in this hole, printed and loaded as it will be",
    "plastic_rules": "A plastic creeps instead of settling: it is judged by rules of its own",
    "shakedown_unknown": "Up to first yield it holds for certain; from there to the limit nothing "
    "is known with so much friction",
    "softening_unknown": "At which temperature this plastic goes soft is not known",
    "solid_wall_unknown": "How thick the solid wall of the holes is, is not given: perimeters "
    "times line width",
    "temperature_unknown": "The temperature of the part is not given",
    "no_bush": "The pv is that of a bush: a bare pin touches its wider hole along a narrow strip",
    "members_locked": "The members turn as one: nothing rolls or slides",
    "no_involute": "It is one of involute teeth",
    "no_ring_pins": "It is one of cycloid discs on the pins of a ring",
    "no_life_curve": "How the limit falls over the life is not known for this material: it is left "
    "out",
    "no_limit": "No limit was asked",
    "no_teeth": "No teeth or pins of the ring are given",
    "one_only": "There is one only",
    "plastic_first": "The first turns yield; the contact settles after that",
    "pressure_error": "The limit lies within the error of the value",
    "pins_in_seats": "The pins of the ring lie in half bores, where they do not bend",
    "ring_alone": "Of each disc by itself in its ring: in series with the pins discs find places "
    "of their own",
    "pins_bend": "The pins of the ring are held at both ends, and bend",
    "no_tool": "No tool of the discs is given",
    "no_valley": "The discs are nowhere concave",
    "every_second_pin": "The forces of a ring of which every second pin is left out are not "
    "calculated",
    "ring_friction_unknown": "The friction on the pins of the ring is not given",
    "rating_unknown": "No load rating of the bearing is given",
    "roots_unknown": "The roots of the satellite's teeth are not known: enter their radius, or the "
    "one of the ring's pins",
    "roller_tilted": "The pins slope more than the formula of the life is made for",
    "rollers_roll": "Rollers roll in the holes: nothing slides or wears there",
    "section_missing": "A part of the design that it needs is not given",
    "size_missing": "A size that it needs is not given",
    "solid_pin": "The pins are solid, or their bores too small to matter",
    "speed_missing": "No input speed is given",
    "steady_load": "The load turns with the shaft and bends it one way all the time",
    "tested_limit": "The tested limit of this material counts, not its yield strength",
    "tilted": "Rollers are usually tilted by about 12° at most: the forces take them as parallel "
    "to the axis",
    "unbalanced": "The satellites need a counterweight",
    "uneven": "Not every roller carries",
    "value_unknown": "Nothing is known of the value: its error is as large as it is, or has no end",
    "wear_unknown": "No wear coefficient is given",
    "yield_unknown": "No yield strength is known: enter one",
}
"""Why a check stands as it does."""

_APPROXIMATION = {
    "tests": "Whether the approximate peak is asked for where it is stated: 3 to 5 pins, 1 or 2 "
    "satellites evenly spaced, linear contact.",
    "why": "Outside it drifts: by 10 % at 6 pins and by 40 % at 12.",
    "mend": "Use the exact peak force; the approximation is only shown beside it.",
}

_LIMITS = {
    "clearance_unknown": _limit(
        "The clearance of pins and holes is not given: the numbers are those of perfect parts, "
        "which every real one misses.",
        title="Clearance not known",
        tests="Whether the clearance of pins and holes is given.",
        why="With clearance fewer pairs carry, and more each: forces and stresses grow, often by "
        "half and more.",
        mend="Give the clearance, or a fit; 0 where perfect parts are meant.",
    ),
    "modification_unknown": _limit(
        "The modification of the discs is not given: the numbers are those of perfect parts, which "
        "every real one misses.",
        title="Modification not known",
        tests="Whether it is given by what the tool of the discs is set off from the ring's pins.",
        why="With play and errors fewer pins carry, and more each: of usual parts up to ten times "
        "the ideal force.",
        mend="Give the modification; 0 where perfect parts are meant.",
    ),
    "one_source": _limit(
        "Some values of {material} are from one source only: take them for a guide.",
        title="One source",
        tests="Whether two independent sources have the stiffness of a material.",
        why="Makers and prints differ by a factor of two and more.",
        mend="Enter the values of the data sheet of what you use.",
    ),
    "outer_ring_not_supported": _limit(
        "No seat holds the outer rings that roll in the holes: {dynamic:.3g} of the dynamic rating "
        "of the bearing is left, a lower bound.",
        title="Outer rings without a seat",
        tests="Whether the ratings are those of a roller.",
        why="Ratings of bearings hold in a rigid seat; here the two rolling elements next to the "
        "load carry nearly all of it, and the ring bends.",
        mend="Give the ratings of a track roller, or the number of rolling elements.",
    ),
    "perfect_parts": _limit(
        "No clearance: the numbers are those of perfect parts, which every real one misses.",
        title="Perfect parts",
        tests="Whether pins and holes have a clearance.",
        why="With clearance fewer pairs carry, and more each: forces and stresses grow, often by "
        "half and more.",
        mend="Give the clearance that the parts have.",
    ),
    "approximation_exponent": _limit(
        "The approximation is made for linear contacts, exponent 1.",
        title="Approximation for other contacts",
        **_APPROXIMATION,
    ),
    "approximation_range": _limit(
        "The approximation is stated for {field} from {low} to {high} only; here it is {value}.",
        title="Approximation outside its range",
        **_APPROXIMATION,
    ),
    "approximation_spacing": _limit(
        "The approximation is made for two cranks half a turn apart.",
        title="Approximation for other cranks",
        **_APPROXIMATION,
    ),
    "beyond_size": _limit(
        "The strengths of the material hold up to {limit:.4g} mm of diameter: thicker pins are "
        "weaker.",
        title="Strength beyond its size",
        tests="Whether the pin is as thin as the strengths of its material hold for.",
        why="Thicker steel hardens less deep: it is weaker than the table says.",
        mend="Give the strengths of the material at this size.",
    ),
    "uneven_sharing": _limit(
        "Satellite {satellite} carries {share:.3g} of the torque, an even share is {even:.3g} "
        "({reason}).",
        title="Uneven sharing",
        tests="Whether a satellite carries more than 1.1 times an even share of the torque.",
        why="Its pins, its bearing and the crankshaft's bearings carry as much more: lives fall by "
        "the third power.",
        mend="Hold the pins at both ends, make them thicker or closer errors; see what `shares` "
        "says of the reason.",
    ),
    "clearance_like_eccentricity": _limit(
        "The clearance is {ratio:.3g} of the eccentricity: such mechanisms move, with very much "
        "play; clearances of working ones are near a hundredth.",
        title="Clearance like the eccentricity",
        tests="Whether the clearance is less than half of the eccentricity.",
        why="Such mechanisms move, with very much play; mostly one of the sizes is a slip.",
        mend="Look at radii and eccentricity; make the hole smaller.",
    ),
    "contact_wraps": _limit(
        "The contact would wrap around more than half of the pin: so far nothing is known of its "
        "pressure. Make the hole larger or the load smaller.",
        title="No theory for this contact",
        tests="Whether the contact stays within a quarter of a turn to each side.",
        why="Beyond it the pin would have to fill its hole; the pressure is not known.",
        mend="Enlarge the hole, lower the load or take a stiffer material.",
    ),
    "cycloid_difference": _limit(
        "The ring has {difference} pins more than a satellite has lobes: where the branches of "
        "such a curve cross, its tips are cut off, so that fewer pins carry than the ratio of the "
        "ring's forces is made for.",
        title="Lobes cut off",
        tests="Whether the ring has one pin more than a satellite has lobes.",
        why="With a larger difference the branches of the cycloid cross and its tips are cut off: "
        "fewer pins carry, and the ratio of the ring's forces is another.",
        mend="Choose a difference of 1, or give the ratio of the forces.",
    ),
    "diameters_as_radii": _limit(
        "Are diameters given as radii? With radii of {pin:.6g} and {hole:.6g} mm the parts fit.",
        title="Diameters as radii?",
        tests="Whether half of the radii would fit where these leave a clearance like the "
        "eccentricity.",
        why="Drawings say diameters; typed as radii they double every size.",
        mend="If they are diameters, halve both.",
    ),
    "disc_ovals": _limit(
        "From the axis of a hole to the nearest edge of the satellite there are {distance:.3g} "
        "radii of the hole: less than 2, and the wall ovals around the pin, which is not "
        "calculated.",
        title="Wall too thin for this contact",
        tests="Whether a wall as thick as the hole's radius stands around a contact that wraps.",
        why="The pressure is that of a hole in a wide plane; a thin wall bends around the pin, "
        "the contact is wider, and the wall carries bending that is not calculated here.",
        mend="Move the holes away from the edge, or make them smaller.",
    ),
    "eccentricity_assumed": _limit(
        "The eccentricity is taken as hole less pin radius: clearance or interference would not be "
        "seen.",
        title="Eccentricity assumed",
        tests="Whether the eccentricity is given beside pin and hole.",
        why="It is taken as hole radius − pin radius, so that pin and hole fit: clearance or "
        "interference would not be seen.",
        mend="Enter the eccentricity of the cranks.",
    ),
    "eccentricity_doubled": _limit(
        "Is the eccentricity given twice as large, as the stroke? With {eccentricity:.6g} mm the "
        "parts fit.",
        title="Eccentricity doubled?",
        tests="Whether half of the eccentricity would fit.",
        why="The stroke of a crank is twice its eccentricity.",
        mend="If it is the stroke, halve it.",
    ),
    "eccentricity_forgotten": _limit(
        "Is the eccentricity left out of the hole? With a radius of {hole:.6g} mm the parts fit.",
        title="Eccentricity left out?",
        tests="Whether the hole's radius with the eccentricity would fit.",
        why="The pin moves in its hole on a circle of the eccentricity: the hole is larger by it.",
        mend="Make the hole larger by the eccentricity.",
    ),
    "endurance_unknown": _limit(
        "Fatigue is not checked: no endurance limit is known. That of a steel follows from its "
        "tensile strength; else give the limit, and the tensile strength with it.",
        title="Fatigue not checked: no limit",
        tests="Whether an endurance limit is known.",
        why="That of a steel follows from its tensile strength, where this is known; for bronzes, "
        "irons and plastics there is no such rule.",
        mend="Give the endurance limit, and the tensile strength where it is not known.",
    ),
    "finite_disc": _limit(
        "From the axis of a hole to the nearest edge of the satellite there are {distance:.3g} "
        "radii of the hole: the pressure, that of a wide plane, may be off by {error:.2g} of it.",
        title="Edge of the satellite near the hole",
        tests="Whether the satellite reaches five radii of the hole around it, where the contact "
        "wraps around its pin.",
        why="A wall that is free bends around the pin, and the pressure is lower; one that is held "
        "gives less, and it is higher.",
        mend="Keep the pressure below its limit by so much, or move the holes away from the edge.",
    ),
    "finite_strain": _limit(
        "The largest pressure is {strain:.2g} of E*: the strains are no longer small, and the "
        "pressure is a guide.",
        title="Large strains",
        tests="Whether the largest pressure stays below 2 % of E*.",
        why="Theories of contact add small displacements of shapes that stay; metals have yielded "
        "long before.",
        mend="Lower the pressure: a hole closer to its pin, a longer contact, a smaller load.",
    ),
    "hardly_known": _limit(
        "Hardly anything is known of the result: its relative error may be {error:.2g}, because "
        "rounding of the input is magnified so much.",
        title="Hardly anything is known",
        tests="Whether the stated relative error stays below 1 %.",
        why="The numbers given are known to some 16 digits only; here a small difference of large "
        "ones decides, of which hardly a digit is left.",
        mend="Move the sizes away from where they nearly cancel: a ratio from cos θ, a limit from "
        "its neighbour, an angle from its pole.",
    ),
    "hertz_line_width": _limit(
        "The half-width of the contact is {ratio:.4g} of the roller's radius: Hertz is off by more "
        "than 1 %.",
        title="Wide contact of the roller",
        tests="Whether the contact is narrow beside the roller's radius.",
        why="Hertz assumes a narrow contact.",
        mend="Enlarge the radius of the teeth or the roller, or lower the load.",
    ),
    "hole_diameter_as_radius": _limit(
        "Is the hole's diameter given as its radius? With {hole:.6g} mm the parts fit.",
        title="Hole: diameter as radius?",
        tests="Whether half of the hole's radius would fit.",
        why="Only the hole is then twice as large.",
        mend="If it is the diameter, halve it.",
    ),
    "large_deflection": _limit(
        "The most loaded part bends by more than a tenth of its length: the formulas are those of "
        "small deflections.",
        title="Large deflection",
        tests="Whether the deflection stays below a tenth of the length.",
        why="The formulas are those of small deflections; beyond that they are off by more than "
        "about 1 %.",
        mend="Lower the load, shorten the part or make it thicker.",
    ),
    "large_rotation": _limit(
        "The output turns by {share:.2g} of the eccentricity under load: clearance or compliance "
        "is large for such a mechanism.",
        title="Large rotation under load",
        tests="Whether the output turns by little of the eccentricity under load.",
        why="Clearance or compliance is large for such a mechanism: pins leave the places at which "
        "the parts are meant to bear.",
        mend="Lower the clearance or the load, or stiffen the contacts.",
    ),
    "life_beyond_strength": _limit(
        "The line of finite life is a fit for tensile strengths of {low:.4g} to {high:.4g} MPa; of "
        "{value:.4g} MPa its end is taken.",
        title="Life beyond its range",
        tests="Whether the tensile strength is one that the line of finite life is a fit for.",
        why="Below and above, the strength at a thousand cycles is that of the nearest end of the "
        "fit: life and finite strength are a rough guide.",
        mend="Give a strength within the range, or judge by the endurance limit alone.",
    ),
    "low_cycle_fatigue": _limit(
        "The pin stands fewer than 1000 cycles: so few that the line of its life does not hold.",
        title="Few cycles",
        tests="Whether the pin stands 1000 cycles.",
        why="The line of finite life holds from 1000 to a million cycles; below it the pin yields "
        "in every turn.",
        mend="Thicken the pin or lower the load.",
    ),
    "next_hole": _limit(
        "A satellite is turned by more than half the pitch of its holes: it is put on the pins by "
        "the holes next to them.",
        title="Other holes",
        tests="Whether each satellite goes onto the pins by the holes that its phase says.",
        why="Turned by more than half the pitch of its holes it goes on by the next ones.",
        mend="Nothing, if it is meant so.",
    ),
    "cluster_lost": _limit(
        "The cluster was lost on the way: this service has calculated what was left, to the same "
        "numbers.",
        title="Cluster lost",
        tests="Whether the cluster that this service has for studies gave all their pieces.",
        why="Without it a study takes longer, and others wait for it.",
        mend="Tell who runs the service; ask for the end of such studies if they take too long.",
    ),
    "no_piece_fits": _limit(
        "None of the pieces fits: more of them would not help; larger clearances or smaller "
        "tolerances do.",
        title="No piece fits",
        tests="Whether any of the pieces goes together at all crank angles.",
        why="Percentiles of what cannot be put together say nothing.",
        mend="Enlarge the clearance, or tighten what does most to the fit.",
    ),
    "no_ring_force": _limit(
        "The ring's force along the crank is left out: with involute teeth bearings carry more, "
        "with a ring of pins less.",
        title="Ring left out",
        tests="Whether the ring's force along the crank is known.",
        why="With involute teeth it adds to the force of the pins, with a ring of pins it opposes "
        "it: the life differs several times.",
        mend="Give the teeth, the circle of the ring's pins, or the ratio of the forces.",
    ),
    "notch_beyond_strength": _limit(
        "The factor of the notch is a fit for tensile strengths of {low:.4g} to {high:.4g} MPa; of "
        "{value:.4g} MPa its end is taken.",
        title="Notch beyond its range",
        tests="Whether the tensile strength is one that the notch's fit is made for.",
        why="Below and above, the sensitivity to the notch is that of the nearest end of the fit.",
        mend="Give the fatigue notch factor itself.",
    ),
    "notch_unknown": _limit(
        "Fatigue is not checked: neither a notch nor its factor is given, and the edge of a press "
        "fit alone takes half of the strength and more.",
        title="Fatigue not checked: no notch factor",
        tests="Whether a notch or its factor is given.",
        why="The edge of a press fit alone takes half of the strength and more: a part without any "
        "notch is not to be assumed.",
        mend="Give the fatigue notch factor of the seat, the notch itself, or the endurance limit.",
    ),
    "pin_bending_uncoupled": _limit(
        "A pin is loaded by several satellites at once: how each bends it for the others is left "
        "out, 1 to 2 % of the largest force.",
        title="Pin bent by several satellites",
        tests="Whether each loaded pin is loaded by one satellite only.",
        why="How the force of one satellite bends the pin for the others is left out: 1 to 2 % of "
        "the largest force.",
        mend="Keep the difference in mind, or stiffen the pins.",
    ),
    "pin_diameter_as_radius": _limit(
        "Is the pin's diameter given as its radius? With {pin:.6g} mm the parts fit.",
        title="Pin: diameter as radius?",
        tests="Whether half of the pin's radius would fit.",
        why="Only the pin is then twice as thick.",
        mend="If it is the diameter, halve it.",
    ),
    "guide_tolerances": _limit(
        "Tolerances that are not given are guides of how the parts are made: sources differ by a "
        "factor of two.",
        title="Guides of a process",
        tests="Whether tolerances are those of the parts, or guides of how such parts are made.",
        why="What comes out depends on the machine, the material and the care: sources differ by a "
        "factor of two.",
        mend="Measure some parts, and enter what they come to.",
    ),
    "seat_rigid": _limit(
        "The seats of the ring's pins are taken as rigid: what they give makes the mesh softer.",
        title="Rigid seats of the ring's pins",
        tests="Whether it is known what the seats of the ring's pins give.",
        why="A pin in half a bore is a second contact in series with that on the satellite, and so "
        "is the ring that holds it.",
        mend="Give the stiffness of a seat, measured or calculated.",
    ),
    "path_short": _limit(
        "The contact ratio is {contact_ratio:.3g}: before one pair of teeth is out of contact no "
        "other is in it, and the motion is not handed on.",
        title="Too short a path of contact",
        tests="Whether a pair of teeth is in contact before another is out of it.",
        why="Below 1 there are positions in which no flanks touch.",
        mend="Make the addenda larger.",
    ),
    "off_involutes": _limit(
        "The teeth run into each other, or touch where they are no involutes: the numbers are "
        "those of teeth that would not.",
        title="Teeth that interfere",
        tests="Whether tips pass each other, and flanks touch only where they are involutes.",
        why="What lies in the way is cut off by force: such teeth do not turn.",
        mend="Make the addenda smaller, or the profile shift of the ring larger.",
    ),
    "teeth_press": _limit(
        "The teeth are thicker than their spaces at this eccentricity: they press on both flanks.",
        title="Teeth without backlash",
        tests="Whether the spaces of the ring have room for the satellite's teeth.",
        why="The eccentricity is larger than that at which teeth fill their spaces.",
        mend="Make the eccentricity smaller, or the profile shift of the ring larger.",
    ),
    "root_unknown": _limit(
        "The root is beyond the method: its section, fillet or arm of the force is not one of a "
        "usual tooth.",
        title="Root beyond the method",
        tests="Whether the root of the satellite's teeth is one of which a stress is known.",
        why="The stress is that of a tooth whose fillet a rack makes, within the range of its "
        "notch factor.",
        mend="Take a larger tip radius of the hob, or a usual addendum.",
    ),
    "valley": _limit(
        "In a valley of the satellite's teeth a pin of the ring is {share:.3g} times as far off as "
        "its path is round there: which point it touches is hardly known.",
        title="Gap in the valleys",
        tests="Whether gaps are small beside the radius of the pins' path in the valleys.",
        why="From half that radius on, the nearest point of the path is hardly the only one.",
        mend="Make the modification smaller, or the shortening coefficient.",
    ),
    "both_meshes": _limit(
        "The mesh with the ring and that with the pins are in series: each disc finds its place "
        "between both, and forces, play and stiffness are those of both. Clearance and elasticity "
        "of the bearings on the cranks are not in them.",
        title="Both meshes in series",
        tests="Whether both meshes are solved together.",
        why="A disc turns in its ring until the pins take as much of it as the teeth give: neither "
        "mesh holds the other's half of it still.",
        mend="State another coupling of the satellites to see either mesh by itself.",
    ),
    "meshes_apart": _limit(
        "The mesh with the ring and that with the pins are solved each by itself: in series they "
        "have {forces:d} forces over the turns, more than {limit:d}.",
        title="Meshes solved apart",
        tests="Whether both meshes are few enough pairs and turns to be solved together.",
        why="In series discs find their place between both meshes: there is more play, and the "
        "ring relieves the bearings on the cranks less.",
        mend="Take pins of the ring without listed deviations, which repeat sooner, or ask "
        "load-sharing at single crank angles.",
    ),
    "unusual_shortening": _limit(
        "The shortening coefficient of the discs is {shortening:.3g}: most drives have 0.35 to "
        "0.9.",
        title="Unusual shortening coefficient",
        tests="Whether the shortening coefficient K1 = e·z_p/R_p lies from 0.35 to 0.9.",
        why="Below, the teeth are low and their forces large; above, flanks bend sharply and the "
        "pins press along the crank.",
        mend="Change the eccentricity, or the circle of the ring's pins.",
    ),
    "ring_deviations_unknown": _limit(
        "Nothing is said of where the ring's pins really stand: a few hundredths of a millimetre "
        "may make the largest force several times as large.",
        title="Deviations of the ring's pins not known",
        tests="Whether deviations of the pins of the ring are given.",
        why="Pins that stand off their places carry earlier, or not at all, than the others: the "
        "forces are those of a ring without errors.",
        mend="Give the deviations of the pins, measured or drawn by their tolerances.",
    ),
    "pressed_without_load": _limit(
        "Pins and holes press without load: there is no play, and the mechanism can be assembled "
        "only by force.",
        title="Pressed without load",
        tests="Whether pins and holes are free of each other without load.",
        why="Errors or interference use up the clearance: there is no play, and assembly needs "
        "force.",
        mend="Enlarge the clearance, or tighten the tolerances of place.",
    ),
    "ratio_not_whole": _limit(
        "The ratio {ratio:.6g} is no whole number: a cycloid disc with one lobe less than the ring "
        "has pins has as many lobes as its ratio says.",
        title="Ratio of a cycloid",
        tests="Whether the ratio of a cycloid disc with one lobe less than the ring has pins is "
        "whole.",
        why="Such a disc has as many lobes as its ratio says.",
        mend="Give the teeth, or a whole ratio.",
    ),
    "ratio_sign": _limit(
        "The ratio is taken as {ratio:.6g}: its sign says that the pins turn the other way, "
        "which those of every such mechanism do.",
        title="Sign of the ratio",
        tests="Whether the ratio is given without a sign.",
        why="The pins of every such mechanism turn against the crank: the sign is known.",
        mend="Nothing, if it is meant so.",
    ),
    "reference_depth": _limit(
        "The reference depth is {ratio:.3g} times the hole's radius; from {low} to {high} a "
        "half-space stands for a hole.",
        title="Reference depth out of range",
        tests="Whether the depth to which the hole's approach is counted is near the hole's "
        "radius.",
        why="A half-space stands for the hole only there; the stiffness is off elsewhere.",
        mend="Take a depth of half to one and a half hole radii, or leave it out.",
    ),
    "roller_clearance_unknown": _limit(
        "The clearance of the rollers on the pins is not given: the numbers are those of rollers "
        "without, which every real one misses.",
        title="Clearance of the rollers not known",
        tests="Whether the radial clearance of the rollers is given.",
        why="Half of it adds to the clearance of pins and holes: fewer pairs carry, and more each.",
        mend="Give the radial internal clearance: track rollers of the class CN have 0.020 to "
        "0.045 mm, of C2 none to 0.025 mm.",
    ),
    "sand_cast": _limit(
        "The bronze is the sand-cast CuSn12-C-GS, whose limit is not known; the centrifugally cast "
        "CuSn12-C-GZ is a material of its own.",
        title="Sand-cast bronze",
        tests="Whether the bronze is the centrifugally cast one, whose limit is known.",
        why="The limit 425 MPa holds for the centrifugally cast bronze only; the sand-cast one "
        "carries less, how much is not known.",
        mend="Take the centrifugally cast bronze, or enter a limit of your own.",
    ),
    "satellite_idle": _limit(
        "Satellite {satellite} carries nothing over the whole turn, as others touch before it: its "
        "bearing has no life, and that of all together is theirs.",
        title="A satellite that carries nothing",
        tests="Whether every satellite carries somewhere over the turn.",
        why="Other satellites touch before it all the way round: they take its share, and its "
        "bearing has no life.",
        mend="Tighten the tolerances of place, turn the disc to the others, or let the satellites "
        "give way.",
    ),
    "bolt_alone": _limit(
        "The bolt alone is taken to be the pin, the spacer only what touches the hole: no preload "
        "is given, or the spacer opens or slips at the carrier.",
        title="The bolt bends alone",
        tests="Whether the preload holds the spacer to the carrier.",
        why="A spacer that gapes or slips carries no bending: the bolt bends by itself.",
        mend="Give the preload, raise it, or take a wider spacer.",
    ),
    "nut_factor": _limit(
        "The preload is taken from the tightening torque with a nut factor of 0.2 and a thread "
        "1.25 times its core: {preload:.6g} N; as it is wetted it may be a third less or more.",
        title="Preload by the tightening torque",
        tests="Whether the preload itself is given.",
        why="Friction in thread and head takes nine tenths of the torque and is hardly known.",
        mend="Give the preload where it is known.",
    ),
    "ring_clearance_left_out": _limit(
        "The tie ring is taken to be rigid and without clearance on the pins: within a clearance "
        "there it does nothing, and the pins bend as without it.",
        title="Clearance of the tie ring left out",
        tests="Whether the tie ring is pinned to the pins.",
        why="In a pinned joint with clearance the ring acts only beyond it, and a thin ring bends "
        "itself: the pins then carry more than is said.",
        mend="Fit the ring without clearance, or judge the pins as cantilevers too.",
    ),
    "short_pin": _limit(
        "A satellite lies within half a pin diameter of the carrier: shear governs such a short "
        "pin, and its seat gives way more than it bends.",
        title="Short pin",
        tests="Whether each satellite is at least half a pin diameter from the carrier.",
        why="So close to its seat a pin is sheared more than bent, and the seat gives way.",
        mend="Take the bending for a rough guide and look at the equivalent stress.",
    ),
    "short_roller": _limit(
        "The cylinder is shorter than its diameter: a beam that short deforms mostly by shear and "
        "at its clamping, so the stiffness is a rough guide.",
        title="Short roller",
        tests="Whether the roller's cylinder is at least as long as its diameter.",
        why="A shorter beam deforms mostly by shear and at its clamping; its stiffness is a rough "
        "guide.",
        mend="Lengthen the roller, or check its stiffness by finite elements.",
    ),
    "short_shaft": _limit(
        "The shaft is short for its diameter: shear, which the formulas leave out, adds more than "
        "5 % to its deflection.",
        title="Short shaft",
        tests="Whether the shaft is at least 3.3 times as long as it is thick.",
        why="Shear, which the formulas leave out, then adds more than 5 % to the deflection.",
        mend="Add the deflection by shear, or take the number as a lower limit.",
    ),
    "size_beyond_range": _limit(
        "The factor of the size is stated for diameters of {low:.4g} to {high:.4g} mm; it is "
        "{value:.4g} mm.",
        title="Size beyond its range",
        tests="Whether the diameter is one that the factor of the size is stated for.",
        why="Outside, the factor is extended, not tested: thick parts may be weaker.",
        mend="Give the endurance limit of the part itself.",
    ),
    "small_arm": _limit(
        "A contact line comes close to phi = 0, where the load has no arm: the line load is "
        "concentrated there, more than elastic rollers would let it be.",
        title="Small arm of the load",
        tests="Whether a contact line comes close to φ = 0.",
        why="There the load has hardly an arm about the axis: the line load grows steeply, more "
        "than elastic rollers would let it.",
        mend="Move the end of the line away from the precession centre.",
    ),
    "sphere_below_roller": _limit(
        "The sphere is smaller than the cylinder: the formulas take the sphere for rigid and the "
        "cylinder for the weak section.",
        title="Sphere smaller than the roller",
        tests="Whether the sphere is at least as thick as the cylinder.",
        why="The formulas take the sphere for rigid and the cylinder for the weak section.",
        mend="Enlarge the sphere or take a thinner cylinder.",
    ),
    "sphere_too_wide": _limit(
        "The sphere is wider than its diameter: no sphere is.",
        title="Sphere wider than its diameter",
        tests="Whether the width of a sphere stays below its diameter.",
        why="No sphere is wider than its diameter: the sizes contradict each other.",
        mend="Correct the width or the diameter of the sphere.",
    ),
    "steep_mesh": _limit(
        "The operating pressure angle of the teeth is above 55°: the ring presses the satellites "
        "more than it turns them.",
        title="Steep teeth",
        tests="Whether the operating pressure angle of the teeth is at most 55°.",
        why="Few teeth of difference need a large angle; then the ring presses the satellites "
        "apart more than it turns them.",
        mend="Make the eccentricity smaller or the module larger.",
    ),
    "thin_without_sleeve": _limit(
        "The pin is thinner than what touches the holes, and there is no sleeve on it: losses and "
        "wear are those of a bare pin as thick as the contact.",
        title="Thin pin without a sleeve",
        tests="Whether the pin is as thick as its contact where there is no sleeve.",
        why="Without a sleeve nothing but the pin itself touches the holes: one of the two sizes "
        "is wrong, or there is a sleeve, which slides less.",
        mend="Say that there is a sleeve, or give the pin the diameter of its contact.",
    ),
    "too_few_fit": _limit(
        "Percentiles are left out for which {fits} pieces that fit are too few.",
        title="Too few fit",
        tests="Whether enough pieces fit for every percentile.",
        why="A rare percentile needs many pieces.",
        mend="Draw more pieces, or make more of them fit.",
    ),
    "twice_the_eccentricity": _limit(
        "Is twice the eccentricity in the radius of the hole? It takes it once: {hole:.6g} mm; "
        "twice is meant of diameters.",
        title="Twice the eccentricity?",
        tests="Whether the hole's radius less once the eccentricity would fit.",
        why="The diameter of a hole takes twice the eccentricity, its radius takes it once.",
        mend="If so, take the eccentricity off once.",
    ),
    "unloaded_flank": _limit(
        "The limits of roller {roller} lie on the flank that the torque unloads: the loaded one is "
        "half a turn of phi further, with the same force.",
        title="Limits on the unloaded flank",
        tests="Whether the given limits of φ lie on the flank that the torque loads.",
        why="The loaded flank is half a turn further; the force is the same, its place is not.",
        mend="Add or take away 180° at both limits, or reverse the torque.",
    ),
}
"""Limits of validity that results strain."""

_CHECKS = {
    "clearance": _check(
        "The hole is larger than pin and eccentricity need, {limit:.9g} mm: no pair touches until "
        "the output has turned through the lost motion, and the load sharing differs.",
        title="Clearance of pin and hole",
        tests="Whether the hole is larger than pin radius and eccentricity together.",
        why="No pair touches until the output has turned through the lost motion, and fewer pairs "
        "share the load than calculated.",
        mend="Make the hole radius the sum of pin radius and eccentricity, or keep the clearance "
        "small against the elastic approach.",
    ),
    "dead_centre": _check(
        "The mechanism cannot transmit torque (RV drives, whose output two or three crankshafts "
        "turn, are not calculated): no pair drives"
    ),
    "interference": _check(
        "The hole is smaller than pin radius + eccentricity, {limit:.9g} mm: pin and satellite "
        "interfere and cannot be assembled.",
        title="Hole too small",
        tests="Whether the hole is smaller than pin radius and eccentricity together.",
        why="Pin and satellite cut into each other: the mechanism cannot be assembled.",
        mend="Enlarge the hole, or take a smaller pin or eccentricity.",
    ),
    "pins_apart": _check(
        "Neighbouring pins overlap: there is no room for them on their circle.",
        title="Pins overlap",
        tests="Whether neighbouring pins keep apart on their circle.",
        why="Two pins cannot stand in one place.",
        mend="Enlarge the pin circle, or take fewer or thinner pins.",
    ),
    "wall_holes": _check(
        "Neighbouring holes of a satellite overlap: there is no material between them.",
        title="Holes overlap",
        tests="Whether there is material left between neighbouring holes of a satellite.",
        why="Overlapping holes leave no wall to carry the force.",
        mend="Enlarge the pin circle, or take fewer pins or smaller holes.",
    ),
}
"""Checks of which calculations without checks warn, and the one by which they refuse."""

CODES: dict[str, Code] = {
    **{code: Code("invalid", text) for code, text in _INVALID.items()},
    **{code: Code("impossible", text) for code, text in _IMPOSSIBLE.items()},
    **{code: Code("unknown", text) for code, text in _UNKNOWN.items()},
    **_LIMITS,
    **_CHECKS,
}
"""Every code, but for checks that are said by their design alone."""

WARNINGS = {code: each for code, each in CODES.items() if each.title}
"""Of these, what warnings say."""

REFUSALS = {
    code: each for code, each in CODES.items() if each.kind != "unknown" and code not in WARNINGS
}
"""And what refusals say."""

WAS = {
    "errors": {
        "only_one": "exclusive",
        "unloaded": "no_reaction",
    },
    "warnings": {
        "beyond_size": "strength_beyond_size",
        "contact_wraps": "hertz_impossible",
        "endurance_unknown": "fatigue_no_basis",
        "notch_unknown": "fatigue_no_notch",
        "pins_apart": "pins_overlap",
        "wall_holes": "holes_overlap",
    },
    "checks": {
        "unbalance_force": "crank_balance",
    },
    "reasons": {
        "beyond_first_order": "no_balance",
        "beyond_hertz": "no_pressure",
        "eccentricity_assumed": "eccentricity_missing",
        "contact_wraps": "hertz_impossible",
        "no_mechanism": "no_balance",
        "no_room_in_hole": "no_balance",
        "not_balanced": "no_balance",
        "not_stable": "no_balance",
        "overflow": "no_balance",
        "smaller_than": "no_balance",
        "too_many_pairs": "too_large",
    },
}
"""Which code of refusals, of warnings, of checks and of their reasons a code replaces; for one
release."""
