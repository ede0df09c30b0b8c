"""Refusals of inputs and of mechanisms that cannot exist."""

INVALID = {
    "at_most": "must be at most {field}, {limit:.9g}",
    "below_working": "must be at least {limit:.9g}, the torque times its factor",
    "beyond_support": "must be at most {limit:.9g}, half a contact length from the end of {field}",
    "different_length": "must have {expected} entries, has {actual}",
    "different_sum": "must have lengths that add up to {field} and {other}, {needed_length:g} m, "
    "not {given_length:g} m",
    "drawn_cup": "must be those of a roller, or with an outer diameter: a drawn cup or a cage of "
    "needles has no ring that could roll by itself",
    "finite_number": "must be a finite number",
    "flanks_not_drawn": "must be 0: flanks that are turned against each other say nothing of tips "
    "and roots, so that there is no outline to draw",
    "greater_than": "must be greater than {limit:.15g}",
    "greater_than_equal": "must be at least {limit:.15g}",
    "in_carrier": "must be at least half of {field}, {limit:.9g}: the contact would reach into the "
    "carrier",
    "infinite_line": "must not lie at a pole, a multiple of half a turn less {field}: the line is "
    "infinitely long there",
    "larger_than": "must be larger than {field}, {limit:.9g}",
    "clearance_dust": "must leave a clearance that is 0 or at least {limit:g} in size",
    "hole_disagrees": "must be pin radius + eccentricity + clearance, {limit:.15g}, or left out",
    "less_than": "must be less than {limit:.15g}",
    "less_than_equal": "must be at most {limit:.15g}",
    "more_than_whole": "must be at most {limit:d}, the number of satellites: none carries more "
    "than all of the torque",
    "needed": "is needed: this or {field}",
    "no_arm": "must not be a multiple of half a turn: there the contact has no arm",
    "no_fit": "must be an ISO 286 class of the hole and one of the pin, such as H7/f7: F, G, "
    "H and JS, and f, g, h, js and m, are known",
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
    "with_real_forces": "must be at most 1 with clearance, deviations or elasticity: forces are "
    "solved then, not assumed",
    "discs_disagree": "must be {field}, or left out: holes and teeth are of the same discs",
    "needed_beside": "is needed beside {field}",
    "no_such_bearing": "is none of the bearings by name, such as {near}; sizes and load ratings "
    "may be given instead of it",
    "not_this_mechanism": "must be another: where several crankshafts drive the output, as in an "
    "RV reducer, there are no pins in holes, and this calculation says nothing of it",
    "of_another_kind": "does not belong to the kind {kind}",
    "of_other_output": "does not belong to the output {output}",
    "one_of_coupling": "must be {limit}: a coupling has one disc",
    "ratio_below_one": "must be at least {limit}: the crank turns faster than the output, its "
    "inverse is {offered:.9g}; two shafts that pins couple are the output coupling",
    "ratio_of_teeth": "must be at most {limit}, twice {field}: with more the ratio is below 1",
    "sign_of_ring": "must not be negative: the ring turns with the crank; {offered:.9g} is that of "
    "crank and pins",
    "teeth_disagree": "must be {expected}, ring teeth less satellite teeth, or left out",
}
"""Refusals of one wrong parameter, by code."""


IMPOSSIBLE = {
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
    "not_stable": "The forces do not hold the output: its torque falls as it turns on",
    "no_radius_left": "A deviation leaves nothing of the radius of pin {pin} of the ring, or of "
    "the crank of satellite {satellite}",
    "outside_method": "The mechanism lies outside of what the method is made for: of involute "
    "teeth 1 to 8 more in the ring and a reference pressure angle of 14.5 to 30 degrees, of both "
    "meshes in series cycloid discs on ring pins",
    "overflow": "The numbers given leave the range of numbers: {names} would not be finite",
    "teeth_not_whole": "Flanks are cut away at their roots, or teeth or spaces are pointed: there "
    "is no outline to draw",
    "teeth_interfere": "The teeth run into each other, or touch where they are no involutes",
    "unloaded": "The loads cancel: nothing presses the bearings",
}
"""Refusals of mechanisms that cannot exist, by code."""
