"""Warnings about results that strain a limit of their method, or designs that strain their own."""

from core.codes.code import limit

_APPROXIMATION = {
    "tests": "The mechanism is one for which the approximate peak is stated: 3 to 5 pins, 1 or 2 "
    "satellites evenly spaced, linear contact.",
    "why": "Outside it drifts: by 10 % at 6 pins and by 40 % at 12.",
    "mend": "Use the exact peak force; the approximation is only shown beside it.",
}

OF_RESULTS = {
    "approximation_exponent": limit(
        "The approximation is made for linear contacts, exponent 1.",
        title="Approximation for other contacts",
        **_APPROXIMATION,
    ),
    "approximation_range": limit(
        "The approximation is stated for {field} from {low} to {high} only; here it is {value}.",
        title="Approximation outside its range",
        **_APPROXIMATION,
    ),
    "approximation_spacing": limit(
        "The approximation is made for two cranks half a turn apart.",
        title="Approximation for other cranks",
        **_APPROXIMATION,
    ),
    "beyond_size": limit(
        "The strengths of the material hold up to {limit:.4g} mm of diameter: thicker pins are "
        "weaker.",
        title="Strength beyond its size",
        tests="The pin is no thicker than the strengths of its material hold for.",
        why="Thicker steel hardens less deep: it is weaker than the table says.",
        mend="Give the strengths of the material at this size.",
    ),
    "uneven_sharing": limit(
        "Satellite {satellite} carries {share:.3g} of the torque, an even share is {even:.3g} "
        "({reason}).",
        title="Uneven sharing",
        tests="Every satellite carries at most 1.1 times an even share of the torque.",
        why="The pins and the bearing of such a satellite, and the crankshaft's bearings, carry as "
        "much more: lives fall by the third power.",
        mend="Hold the pins at both ends, make them thicker or closer errors; see what `shares` "
        "says of the reason.",
    ),
    "contact_wraps": limit(
        "The contact would wrap around more than half of the pin: so far nothing is known of its "
        "pressure. Make the hole larger or the load smaller.",
        title="No theory for this contact",
        tests="The contact stays within a quarter of a turn to each side.",
        why="Beyond it the pin would have to fill its hole; the pressure is not known.",
        mend="Enlarge the hole, lower the load or take a stiffer material.",
    ),
    "cycloid_difference": limit(
        "The ring has {difference} pins more than a satellite has lobes: where the branches of "
        "such a curve cross, its tips are cut off, so that fewer pins carry than the ratio of the "
        "ring's forces is made for.",
        title="Lobes cut off",
        tests="The ring has one pin more than a satellite has lobes.",
        why="With a larger difference the branches of the cycloid cross and its tips are cut off: "
        "fewer pins carry, and the ratio of the ring's forces is another.",
        mend="Choose a difference of 1, or give the ratio of the forces.",
    ),
    "disc_ovals": limit(
        "From the axis of a hole to the nearest edge of the satellite there are {distance:.3g} "
        "radii of the hole: less than 2, and the wall ovals around the pin, which is not "
        "calculated.",
        title="Wall too thin for this contact",
        tests="A wall at least as thick as the hole's radius stands around a contact that wraps.",
        why="The pressure is that of a hole in a wide plane; a thin wall bends around the pin, "
        "the contact is wider, and the wall carries bending that is not calculated here.",
        mend="Move the holes away from the edge, or make them smaller.",
    ),
    "hole_outside_disc": limit(
        "The holes reach {beyond:.4g} mm beyond the nearest edge of the satellite: its bore, or "
        "the roots of its teeth.",
        title="Holes outside the satellite",
        tests="The holes lie within the satellite.",
        why="There is no wall that a pin could press on.",
        mend="Move the holes, make them smaller, or check the sizes of bore and teeth.",
    ),
    "finite_disc": limit(
        "From the axis of a hole to the nearest edge of the satellite there are {distance:.3g} "
        "radii of the hole: the pressure, that of a wide plane, may be off by {error:.2g} of it.",
        title="Edge of the satellite near the hole",
        tests="The satellite reaches five radii of the hole around it, where the contact wraps "
        "around its pin.",
        why="A wall that is free bends around the pin, and the pressure is lower; one that is held "
        "gives less, and it is higher.",
        mend="Keep the pressure below its limit by so much, or move the holes away from the edge.",
    ),
    "finite_strain": limit(
        "The largest pressure is {strain:.2g} of E*: the strains are no longer small, and the "
        "pressure is a guide.",
        title="Large strains",
        tests="The largest pressure is at most 2 % of E*.",
        why="Theories of contact add small displacements of shapes that stay; metals have yielded "
        "long before.",
        mend="Lower the pressure: a hole closer to its pin, a longer contact, a smaller load.",
    ),
    "hertz_line_width": limit(
        "The half-width of the contact is {ratio:.4g} of the roller's radius: Hertz is off by more "
        "than 1 %.",
        title="Wide contact of the roller",
        tests="The contact is narrow beside the roller's radius.",
        why="Hertz assumes a narrow contact.",
        mend="Enlarge the radius of the teeth or the roller, or lower the load.",
    ),
    "large_deflection": limit(
        "The most loaded part bends by more than a tenth of its length: the formulas are those of "
        "small deflections.",
        title="Large deflection",
        tests="The deflection is at most a tenth of the length.",
        why="The formulas are those of small deflections; beyond that they are off by more than "
        "about 1 %.",
        mend="Lower the load, shorten the part or make it thicker.",
    ),
    "large_rotation": limit(
        "The output turns by {share:.2g} of the eccentricity under load: clearance or compliance "
        "is large for such a mechanism.",
        title="Large rotation under load",
        tests="The output turns by at most a tenth of the eccentricity under load.",
        why="Clearance or compliance is large for such a mechanism: pins leave the places at which "
        "the parts are meant to bear.",
        mend="Lower the clearance or the load, or stiffen the contacts.",
    ),
    "life_beyond_strength": limit(
        "The line of finite life is a fit for tensile strengths of {low:.4g} to {high:.4g} MPa; of "
        "{value:.4g} MPa its end is taken.",
        title="Life beyond its range",
        tests="The tensile strength is one that the line of finite life is a fit for.",
        why="Below and above, the strength at a thousand cycles is that of the nearest end of the "
        "fit: life and finite strength are a rough guide.",
        mend="Give a strength within the range, or judge by the endurance limit alone.",
    ),
    "low_cycle_fatigue": limit(
        "The pin stands fewer than 1000 cycles: so few that the line of its life does not hold.",
        title="Few cycles",
        tests="The pin stands at least 1000 cycles.",
        why="The line of finite life holds from 1000 to a million cycles; below it the pin yields "
        "in every turn.",
        mend="Thicken the pin or lower the load.",
    ),
    "cluster_lost": limit(
        "The cluster was lost on the way: this service has calculated what was left, to the same "
        "numbers.",
        title="Cluster lost",
        tests="The cluster that this service has for studies gave all their pieces.",
        why="Without it a study takes longer, and others wait for it.",
        mend="Tell who runs the service; ask for the end of such studies if they take too long.",
    ),
    "no_piece_fits": limit(
        "None of the pieces fits: more of them would not help; larger clearances or smaller "
        "tolerances do.",
        title="No piece fits",
        tests="At least one of the pieces goes together at all crank angles.",
        why="Percentiles of what cannot be put together say nothing.",
        mend="Enlarge the clearance, or tighten what does most to the fit.",
    ),
    "notch_beyond_strength": limit(
        "The factor of the notch is a fit for tensile strengths of {low:.4g} to {high:.4g} MPa; of "
        "{value:.4g} MPa its end is taken.",
        title="Notch beyond its range",
        tests="The tensile strength is one that the notch's fit is made for.",
        why="Below and above, the sensitivity to the notch is that of the nearest end of the fit.",
        mend="Give the fatigue notch factor itself.",
    ),
    "seat_rigid": limit(
        "The seats of the ring's pins are taken as rigid: what they give makes the mesh softer.",
        title="Rigid seats of the ring's pins",
        tests="The stiffness of the seats of the ring's pins is known.",
        why="A pin in half a bore is a second contact in series with that on the satellite, and so "
        "is the ring that holds it.",
        mend="Give the stiffness of a seat, measured or calculated.",
    ),
    "path_short": limit(
        "The contact ratio is {contact_ratio:.3g}: before one pair of teeth is out of contact no "
        "other is in it, and the motion is not handed on.",
        title="Too short a path of contact",
        tests="A pair of teeth is in contact before another is out of it.",
        why="Below 1 there are positions in which no flanks touch.",
        mend="Make the addenda larger.",
    ),
    "off_involutes": limit(
        "The teeth run into each other, or touch where they are no involutes: the numbers are "
        "those of teeth that would not.",
        title="Teeth that interfere",
        tests="Tips pass each other, and flanks touch only where they are involutes.",
        why="Material in the way is cut off by force: such teeth do not turn.",
        mend="Make the addenda smaller, or the profile shift of the ring larger.",
    ),
    "teeth_press": limit(
        "The teeth are thicker than their spaces at this eccentricity: they press on both flanks.",
        title="Teeth without backlash",
        tests="The spaces of the ring have room for the satellite's teeth.",
        why="The eccentricity is larger than that at which teeth fill their spaces.",
        mend="Make the eccentricity smaller, or the profile shift of the ring larger.",
    ),
    "flanks_turned": limit(
        "The flanks of the lobes are turned against each other, which adds to the gaps where pins "
        "press; tips and roots are left out.",
        title="Flanks that are turned",
        tests="The whole outline of the lobes is known: no flank is turned.",
        why="A turned flank says nothing of the tips and roots between two flanks.",
        mend="Use equidistant and pin circle offsets, whose outline is known.",
    ),
    "meshes_apart": limit(
        "The mesh with the ring and that with the pins are solved each by itself: in series they "
        "have {forces:d} forces over the turns, more than {limit:d}.",
        title="Meshes solved apart",
        tests="Both meshes have few enough pairs and turns to be solved together.",
        why="In series discs find their place between both meshes: there is more play, and the "
        "ring relieves the bearings on the cranks less.",
        mend="Take pins of the ring without listed deviations, which repeat sooner, or ask "
        "load-sharing at single crank angles.",
    ),
    "pressed_without_load": limit(
        "Pins press without load, in their holes or on the teeth: there is no play, and the parts "
        "go together only by force.",
        title="Pressed without load",
        tests="No pin presses without load.",
        why="Errors or interference use up the clearance: there is no play, and assembly needs "
        "force.",
        mend="Enlarge the clearance, or tighten the tolerances of place.",
    ),
    "reference_depth": limit(
        "The reference depth is {ratio:.3g} times the hole's radius; from {low} to {high} a "
        "half-space stands for a hole.",
        title="Reference depth out of range",
        tests="The depth to which the hole's approach is counted is near the hole's radius.",
        why="A half-space stands for the hole only there; the stiffness is off elsewhere.",
        mend="Take a depth of half to one and a half hole radii, or leave it out.",
    ),
    "satellite_idle": limit(
        "Satellite {satellite} carries nothing over the whole turn, as others touch before it: its "
        "bearing has no life, and that of all together is theirs.",
        title="A satellite that carries nothing",
        tests="Every satellite carries somewhere over the turn.",
        why="Other satellites touch before it all the way round: they take its share, and its "
        "bearing has no life.",
        mend="Tighten the tolerances of place, turn the disc to the others, or let the satellites "
        "give way.",
    ),
    "bolt_alone": limit(
        "The bolt alone is taken to be the pin, the spacer only what touches the hole: no preload "
        "is given, or the spacer opens or slips at the carrier.",
        title="The bolt bends alone",
        tests="The preload holds the spacer to the carrier.",
        why="A spacer that gapes or slips carries no bending: the bolt bends by itself.",
        mend="Give the preload, raise it, or take a wider spacer.",
    ),
    "size_beyond_range": limit(
        "The factor of the size is stated for diameters of {low:.4g} to {high:.4g} mm; it is "
        "{value:.4g} mm.",
        title="Size beyond its range",
        tests="The diameter is one that the factor of the size is stated for.",
        why="Outside, the factor is extended, not tested: thick parts may be weaker.",
        mend="Give the endurance limit of the part itself.",
    ),
    "small_arm": limit(
        "A contact line comes close to phi = 0, where the load has no arm: the line load is "
        "concentrated there, more than elastic rollers would let it be.",
        title="Small arm of the load",
        tests="Every contact line stays away from φ = 0.",
        why="There the load has hardly an arm about the axis: the line load grows steeply, more "
        "than elastic rollers would let it.",
        mend="Move the end of the line away from the precession centre.",
    ),
    "steep_mesh": limit(
        "The operating pressure angle of the teeth is above 55°: the ring presses the satellites "
        "more than it turns them.",
        title="Steep teeth",
        tests="The operating pressure angle of the teeth is at most 55°.",
        why="Few teeth of difference need a large angle; then the ring presses the satellites "
        "apart more than it turns them.",
        mend="Make the eccentricity smaller or the module larger.",
    ),
    "too_few_fit": limit(
        "Percentiles are left out for which {fits} pieces that fit are too few.",
        title="Too few fit",
        tests="Enough pieces fit for every percentile.",
        why="A rare percentile needs many pieces.",
        mend="Draw more pieces, or make more of them fit.",
    ),
    "unloaded_flank": limit(
        "The limits of roller {roller} lie on the flank that the torque unloads: the loaded one is "
        "half a turn of phi further, with the same force.",
        title="Limits on the unloaded flank",
        tests="The given limits of φ lie on the flank that the torque loads.",
        why="The loaded flank is half a turn further; the force is the same, its place is not.",
        mend="Add or take away 180° at both limits, or reverse the torque.",
    ),
}
