"""Reasons for the status of a check that the numbers do not show."""

UNKNOWN = {
    "above_any": "The value is above all that the material may bear: by what is known of it, or by "
    "the strongest of its kind",
    "bearing_overloaded": "The load is beyond what the formula of the life is made for",
    "cannot_be": "The parts cannot be put together, or cannot move: no force is known",
    "bearing_slips": "The bearing carries too little for its rolling elements to roll",
    "envelope_unknown": "The sizes of the bearing are not given",
    "no_peak_torque": "No peak torque is given",
    "no_sourced_limit": "Nobody asked for a limit, and no source gives one for such parts",
    "range_decides": "The check fails at one end of the range of what is not given here, and holds "
    "at the other: enter it",
    "rating_high": "The rating is higher than that of any known bearing of these sizes",
    "rating_low": "The rating is less than a twentieth of what fits: is it given in kN?",
    "thin_wall": "The wall or space is thinner than usual",
    "pin_stands_out": "A piece whose ring pin stands out does not hold: the tolerance study says "
    "how many do",
    "pins_placed": "The places of the ring's pins are given, and judged themselves",
    "near_undercut": "The outline is close to where the pins of the ring cut off a part of the "
    "flanks: errors of the parts may take what is left",
    "less_than_usual": "The value is less than usual: errors of the parts may take what is left",
    "unusual_teeth": "Only unusual teeth mesh, if any: very low ones, with large profile shifts, "
    "or with hardly any room between the tips",
    "internal_root": "The roots of the ring's teeth are not calculated",
    "no_crossing": "The circles of the tips do not cross",
    "ring_flank_unknown": "The check holds for the satellite's flanks; the ring's flanks depend on "
    "its cutter, which is not given",
    "ring_root_assumed": "The check holds for a ring whose roots are as deep as the hob makes "
    "those of the satellite: the ring's cutter is not given",
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
    "bearing_unnamed": "Only bearings of the table have a mass: enter the bearing's name",
    "counterweight_unknown": "Of counterweights the unbalance is given, not the mass",
    "cranks_deviate": "The balance is known of cranks without deviations only",
    "default_decides": "The check fails by a value that is assumed, and holds at the mild end of "
    "what is usual: enter it",
    "direction_unknown": "Across its layers no strength of this material is known: say that they "
    "lie flat, enter that strength, or take pins of metal",
    "density_unknown": "No density of the material is known: name one of the table",
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
    "life_without_speed": "No input speed is given: the limit is that for 1e10 loads",
    "limit_unknown": "No limit of the pressure is known for this material: enter one. The pitting "
    "limit of tables of gears or worm wheels will do, that of its maker for such a contact, or of "
    "a test of this pair",
    "losses_left_out": "Bearings of the satellites and of the crankshaft, and seals, lose besides: "
    "their losses are not in it",
    "mass_unknown": "No mass of a satellite is given",
    "necessary_only": "The condition holds, which is necessary and not enough: once, cold, dry, of "
    "solid material",
    "no_plastic_fatigue": "No source says how many turns such a plastic bears: run the pair under "
    "its load for as long as it is to last",
    "not_printed": "Only printed parts have infill behind their walls",
    "plastic_limit_unknown": "No source gives a pressure that such a plastic bears for long: enter "
    "one of a test of this pin in this hole, printed and loaded as it will be",
    "plastic_rules": "A plastic creeps instead of settling: it is judged by rules of its own",
    "shakedown_unknown": "Up to first yield it holds for certain; from there to the limit nothing "
    "is known with so much friction",
    "static_limit_unknown": "The pressure is above what the surface bears for ever, and no source "
    "says what it bears once",
    "softening_unknown": "At which temperature this plastic goes soft is not known",
    "solid_wall_unknown": "How thick the solid wall of the holes is, is not given: perimeters "
    "times line width",
    "temperature_unknown": "The temperature of the part is not given",
    "both_meshes": "Each disc finds its place between both meshes: forces, play and stiffness are "
    "those of both, on bearings of the cranks that give where these are stated, else on rigid ones",
    "no_bush": "The pv is that of a bush: a bare pin touches its wider hole along a narrow strip",
    "members_locked": "The members turn as one: nothing rolls or slides",
    "no_involute": "No involute teeth are given",
    "no_ring_pins": "No cycloid discs on the pins of a ring are given",
    "no_life_curve": "How the limit falls over the life is not known for this material: it is left "
    "out",
    "no_limit": "No limit was asked",
    "no_teeth": "No teeth or pins of the ring are given",
    "one_only": "There is one only",
    "plastic_first": "The first turns yield; the contact settles after that",
    "pressure_error": "The limit lies within the error of the value",
    "pins_in_seats": "The pins of the ring lie in half bores, where they do not bend",
    "ring_alone": "The value is that of each disc by itself in its ring: in series with the pins "
    "discs find places of their own",
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
"""Reasons for the status of a check, by code."""
