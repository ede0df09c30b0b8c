// Written by tests/app/test_service_words.py: what the service says in English, by code.
export default {
  "refusals": {
    "at_most": "must be at most {field}, {limit}",
    "below_working": "must be at least {limit}, the torque times its factor",
    "beyond_support": "must be at most {limit}, half a contact length from the end of {field}",
    "different_length": "must have {expected} entries, has {actual}",
    "different_sum": "must have lengths that add up to {field} and {other}, {needed_length_mm}, not {given_length_mm}",
    "exclusive": "and {field} exclude each other",
    "finite_number": "must be a finite number",
    "first_order_only": "must be of first order beside {field}: what satellites give is not known in exact geometry",
    "greater_than": "must be greater than {limit}",
    "greater_than_equal": "must be at least {limit}",
    "in_carrier": "must be at least half of {field}, {limit}: the contact would reach into the carrier",
    "infinite_line": "must not lie at a pole, a multiple of half a turn less {field}: the line is infinitely long there",
    "larger_than": "must be larger than {field}, {limit}",
    "less_than": "must be less than {limit}",
    "less_than_equal": "must be at most {limit}",
    "no_cycloid": "must be larger than the eccentricity times 1 more than {field}, {limit}: there is no such cycloid",
    "no_class": "must be an ISO 286 class of the table, such as m6 or H7",
    "needed": "is needed: this or {field}",
    "no_arm": "must not be a multiple of half a turn: there the contact has no arm",
    "no_conformal_pressure": "must have a conformal pressure",
    "no_mesh": "must be at least {limit}: teeth of this {field} do not mesh any nearer",
    "no_reaction": "must leave the bearings a load: the forces of the satellites cancel",
    "no_sleeve": "must be smaller than twice {field}, {limit}: there is no room for a sleeve",
    "not_in_table": "must be one of {values}",
    "not_single": "must be one number, not an array",
    "not_zero": "must not be 0",
    "other_pitch": "must be {limit} from the place of the first satellite, as on the pins",
    "other_branch": "must lie on the same side of the pole, a multiple of half a turn less {other}, as {field}: the line is infinitely long there",
    "right_angle": "must be smaller than a right angle",
    "roller_without_arm": "puts roller {roller} at a multiple of half a turn: there its contact has no arm",
    "smaller_than": "must be smaller than {field}, {limit}",
    "sum_not_one": "must add up to 1, not to {sum}",
    "too_near": "must be at least {field}, {limit}, from the places of the other satellites",
    "too_few": "needs a larger sample",
    "too_many_pairs": "must be at most {limit}, with {satellites} satellites",
    "too_many_phases": "must be smaller: there would be more than {limit} driving phases",
    "too_short": "must have at least {limit} entries",
    "too_short_range": "must be larger than {limit}: no driving phase is that short",
    "too_thick": "must be at most twice {field}, {limit}: thicker, the pin itself would touch the hole",
    "beyond_first_order": "The output would turn by more than a radian, of which first order says nothing: the contacts are too soft or the position is a dead centre",
    "beyond_hertz": "The contact of satellite {satellite} and pin {pin} would be as wide as the pin: Hertz's law of contact does not reach so far",
    "cannot_assemble": "Pins and holes press: pin {pin} and its hole of satellite {satellite} lack {missing_length_mm} of room; holes of a radius of {needed_length_mm} would do",
    "dead_centre": "The mechanism cannot transmit torque: no pair drives",
    "no_contact_line": "There is no contact line: the cosine of {field} equals {other}",
    "no_lever": "The contact line of roller {roller} cannot carry a torque: it reaches phi = 0, at z = 0, where the load has no arm about the axis; keep both its ends on one side of it",
    "no_mechanism": "Holes of a radius of {given_length_mm} do not hold their pins, which could pass from one into the next: it must be less than {limit_length_mm}",
    "no_room_in_hole": "The hole of satellite {satellite} is not larger than pin {pin}, or a deviation leaves nothing of a radius",
    "not_balanced": "The forces cannot be balanced within the range of numbers",
    "not_stable": "The forces do not hold the output: its torque falls as it turns on",
    "overflow": "The numbers given leave the range of numbers: {names} would not be finite",
    "bool_type": "must be true or false",
    "dict_type": "must be an object",
    "dust": "must be 0 or at least {limit} in size",
    "extra_forbidden": "is not a known field",
    "float_type": "must be a number",
    "hole_disagrees": "must be pin radius + eccentricity + clearance, {expected_mm}, or left out",
    "int_type": "must be a whole number",
    "json_invalid": "is not valid JSON: {error}",
    "list_type": "must be a list",
    "literal_error": "must be one of {expected}",
    "missing": "is needed",
    "multiple_of": "must be a multiple of {limit}",
    "needed_beside": "is needed beside {field}",
    "needed_for": "is needed for {section}",
    "no_class_of_size": "is known for diameters up to {limit_mm} only",
    "not_there": "names no number in {field}",
    "not_valid": "is not valid",
    "of_another_kind": "does not belong to the kind {kind}",
    "only_one": "excludes {field}: give one of them",
    "ratio_below_one": "must be at least {limit}: the crank turns faster than the output, its inverse is {offered}; a coupling without reduction is not calculated yet",
    "ratio_of_teeth": "must be at most {limit}, twice {field}: with more the ratio is below 1",
    "service_limit": "must be at most {limit}: this service takes no more",
    "string_type": "must be a text",
    "string_unicode": "is not valid text",
    "teeth_disagree": "must be {expected}, ring teeth less satellite teeth, or left out",
    "to_be_drawn": "must be at most {limit} to be drawn",
    "too_long": "must have at most {limit} entries",
    "too_nested": "must hold at most {limit} lists and objects",
    "with_real_forces": "must be at most 1 with clearance, deviations or elasticity: forces are solved then, not assumed",
    "with_rollers": "must be at most {limit}, with {rollers} rollers"
  },
  "places": {
    "crank_angle_deg": "crank angle",
    "nutation_angle_deg": "nutation angle",
    "ratio_u12": "ratio u12",
    "roller": "roller",
    "z_mm": "position along the roller, z"
  },
  "notices": {
    "approximation_exponent": "The approximation is made for linear contacts, exponent 1.",
    "approximation_range": "The approximation is stated for {field} from {low} to {high} only; here it is {value}.",
    "approximation_spacing": "The approximation is made for two cranks half a turn apart.",
    "clearance": "The hole is larger than pin and eccentricity need, {limit} mm: no pair touches until the output has turned through the lost motion, and the load sharing differs.",
    "clearance_like_eccentricity": "The clearance is {ratio} of the eccentricity: such mechanisms move, with very much play; clearances of working ones are near a hundredth.",
    "cycloid_difference": "The ring has {difference} pins more than a satellite has lobes: where the branches of such a curve cross, its tips are cut off, so that fewer pins carry than the ratio of the ring's forces is made for.",
    "diameters_as_radii": "Are diameters given as radii? With radii of {pin} and {hole} mm the parts fit.",
    "eccentricity_assumed": "The eccentricity is taken as hole less pin radius: clearance or interference would not be seen.",
    "eccentricity_doubled": "Is the eccentricity given twice as large, as the stroke? With {eccentricity} mm the parts fit.",
    "eccentricity_forgotten": "Is the eccentricity left out of the hole? With a radius of {hole} mm the parts fit.",
    "fatigue_no_basis": "Fatigue is not checked: no endurance limit is known. That of a steel follows from its tensile strength; else give the limit, and the tensile strength with it.",
    "fatigue_no_notch": "Fatigue is not checked: neither a notch nor its factor is given, and the edge of a press fit alone takes half of the strength and more.",
    "hardly_known": "Hardly anything is known of the result: its relative error may be {error}, because rounding of the input is magnified so much.",
    "hertz_half_width": "The half-width of the contact is {ratio} of the pin's radius; Hertz assumes a narrow contact and is off by more than 1 %: use the conformal pressure, or where there is none, for very different materials, take it as a rough guide.",
    "hertz_impossible": "The half-width of the contact is {ratio} of the pin's radius: wider than the pin, so that Hertz does not apply at all, and for very different materials no conformal solution is at hand: make the hole larger or the load smaller.",
    "hertz_line_width": "The half-width of the contact is {ratio} of the roller's radius: Hertz is off by more than 1 %.",
    "hole_diameter_as_radius": "Is the hole's diameter given as its radius? With {hole} mm the parts fit.",
    "holes_overlap": "Neighbouring holes of a satellite overlap: there is no material between them.",
    "interference": "The hole is smaller than pin radius + eccentricity, {limit} mm: pin and satellite interfere and cannot be assembled.",
    "large_deflection": "The most loaded part bends by more than a tenth of its length: the formulas are those of small deflections.",
    "large_rotation": "The output turns by {share} of the eccentricity under load: clearance or compliance is large for such a mechanism.",
    "life_beyond_strength": "The line of finite life is a fit for tensile strengths of {low} to {high} MPa; of {value} MPa its end is taken.",
    "next_hole": "A satellite is turned by more than half the pitch of its holes: it is put on the pins by the holes next to them.",
    "no_piece_fits": "None of the pieces fits: more of them would not help; larger clearances or smaller tolerances do.",
    "no_ring_force": "The ring's force along the crank is left out: with involute teeth bearings carry more, with a ring of pins less.",
    "notch_beyond_strength": "The factor of the notch is a fit for tensile strengths of {low} to {high} MPa; of {value} MPa its end is taken.",
    "pin_diameter_as_radius": "Is the pin's diameter given as its radius? With {pin} mm the parts fit.",
    "pin_bending_uncoupled": "A pin is loaded by several satellites at once: how each bends it for the others is left out, 1 to 2 % of the largest force.",
    "low_cycle_fatigue": "The pin stands fewer than 1000 cycles: so few that the line of its life does not hold.",
    "pins_overlap": "Neighbouring pins overlap: there is no room for them on their circle.",
    "pressed_without_load": "Pins and holes press without load: there is no play, and the mechanism can be assembled only by force.",
    "ratio_not_whole": "The ratio {ratio} is no whole number: a cycloid disc with one lobe less than the ring has pins has as many lobes as its ratio says.",
    "ratio_sign": "The ratio is taken as {ratio}: its sign says that the output turns the other way, which that of every such mechanism does.",
    "reference_depth": "The reference depth is {ratio} times the hole's radius; from {low} to {high} a half-space stands for a hole.",
    "sand_cast": "The bronze is the sand-cast CuSn12-C-GS, whose limit is not known; the centrifugally cast CuSn12-C-GZ is a material of its own.",
    "size_beyond_range": "The factor of the size is stated for diameters of {low} to {high} mm; it is {value} mm.",
    "satellite_idle": "Satellite {satellite} carries nothing over the whole turn, as others touch before it: its bearing has no life, and that of all together is theirs.",
    "short_pin": "A satellite lies within half a pin diameter of the carrier: shear governs such a short pin, and its seat gives way more than it bends.",
    "short_roller": "The cylinder is shorter than its diameter: a beam that short deforms mostly by shear and at its clamping, so the stiffness is a rough guide.",
    "short_shaft": "The shaft is short for its diameter: shear, which the formulas leave out, adds more than 5 % to its deflection.",
    "small_arm": "A contact line comes close to phi = 0, where the load has no arm: the line load is concentrated there, more than elastic rollers would let it be.",
    "sphere_below_roller": "The sphere is smaller than the cylinder: the formulas take the sphere for rigid and the cylinder for the weak section.",
    "sphere_too_wide": "The sphere is wider than its diameter: no sphere is.",
    "strength_beyond_size": "The strengths of the material hold up to {limit} mm of diameter: thicker pins are weaker.",
    "steep_mesh": "The operating pressure angle of the teeth is above 55°: the ring presses the satellites more than it turns them.",
    "thin_without_sleeve": "The pin is thinner than what touches the holes, and there is no sleeve on it: losses and wear are those of a bare pin as thick as the contact.",
    "too_few_fit": "Percentiles are left out for which {fits} pieces that fit are too few.",
    "twice_the_eccentricity": "Is twice the eccentricity in the radius of the hole? It takes it once: {hole} mm; twice is meant of diameters.",
    "unloaded_flank": "The limits of roller {roller} lie on the flank that the torque unloads: the loaded one is half a turn of phi further, with the same force."
  },
  "neglected": {
    "bearing_elasticity": "play and elasticity of the bearings",
    "bodies_rigid": "the deformation of discs, hole walls, carrier and crankshaft",
    "body_strength": "the strength of teeth, discs, carrier and crankshaft",
    "centrifugal_forces": "the centrifugal forces of the satellites on their bearings and those of the crankshaft",
    "clearance": "clearance of pins and holes, and with it lost motion",
    "contact_compliance": "the compliance of the contacts of spheres and holes",
    "deviations": "deviations of the parts from their nominal shape and place",
    "edge_pressure": "the higher pressure at the ends of the contact",
    "elasticity": "the elasticity of the parts besides the contacts",
    "equal_discs": "uneven sharing between the satellites",
    "friction": "friction",
    "friction_on_forces": "what friction changes about the forces themselves",
    "heat": "heat, and what it changes",
    "lubricant_film": "the lubricant's film: the friction coefficient is the same everywhere",
    "misalignment": "misalignment, so that the load is even along the contact",
    "fretting": "fretting at the pin's seat, unless the notch factor covers it",
    "pin_bending": "the bending of the pins",
    "roller_tilt": "the tilt of the rollers against the discs",
    "seat_compliance": "the give of the pin's seats",
    "seals": "losses of seals, bearings and teeth",
    "shaft_bearings": "play and elasticity of the crankshaft's bearings",
    "shear": "the shear of the shaft",
    "tilt": "the tilt of satellites in their bearings, and of pins and holes by errors"
  },
  "figures": {
    "across_crank": "Across the crank",
    "across_first_crank": "Across, from angle 0 of the cranks",
    "along_arc": "Place along the arc of the pin",
    "along_axis": "Along the axis z",
    "along_crank": "Along the crank, to the axis",
    "along_first_crank": "Along angle 0 of the cranks",
    "along_shaft": "Along the shaft from C to the clamp",
    "amount": "{amount}",
    "arc_on_roller": "Arc on the roller x = ρφ",
    "at_angle": "{name}: {value} at {angle}",
    "at_place": "{name}: {value} at {place}",
    "axis": "{title}, {unit}",
    "backlash_max": "Largest backlash",
    "bearing": "Bearing {letter}",
    "bearing_load": "Load of the bearing",
    "bending_moment": "Bending moment",
    "bending_stress": "Bending stress",
    "body_limit": "Limit of the {body}",
    "body_limit_hover": "Limit of the {body}: {pressure}",
    "clamp": "clamp",
    "conformal": "Conformal (Persson)",
    "contact_force": "Contact force",
    "contact_line": "{name}: contact line",
    "contact_pressure": "Contact pressure",
    "crank_angle": "Crank angle",
    "crank_phase": "Crank phase",
    "dead_centre": "dead centre",
    "deflection": "Deflection",
    "design": "This design",
    "design_nonuniformity": "This design: Ψ = {nonuniformity} at δ = {error}",
    "design_stiffness": "This design: c/(b·E) = {stiffness}",
    "design_stress": "This design: {stress}, σ/E = {ratio}",
    "disc_phase": "Disc phase",
    "driving": "Driving",
    "driving_pairs": "Driving pairs",
    "driving_pairs_hover": "Driving pairs: {pairs} at {angle}",
    "eccentricity": "Eccentricity",
    "efficiency": "Efficiency",
    "error_in_time": "{method}, {setting}<br>error {error} in {time}",
    "error_in_time_chosen": "{method}: error {error} in {time}",
    "equivalent_load": "Equivalent load",
    "gaps_times": "Gaps × {factor}",
    "hertz": "Hertz",
    "hole": "hole",
    "hole_diameter": "Hole diameter",
    "hole_position": "Position of the holes",
    "ideal_pair_force": "Satellite {satellite}, pin {pin}, ideal<br>{force} at {angle}",
    "lag": "Lag of the output",
    "length_of_line": "{name}, length {length}<br>x = {x}, z = {z}",
    "length_ratio": "Length over diameter l/d",
    "limit": "limit {value}",
    "line_load": "Line load",
    "line_load_hover": "{name}: {load} at z = {place}",
    "locus_hover": "{name}: {along}, {across}",
    "loss": "Loss",
    "lost_motion": "Lost motion",
    "max_pressure": "Largest pressure",
    "mean_hover": "{name}: {value}",
    "mean_of": "{name}, mean",
    "mean_value": "mean {value}",
    "moment_locus": "Moment over the turn",
    "moment_radial": "Moment by radial forces",
    "moment_tangential": "Moment by tangential forces",
    "nominal": "nominal {value}",
    "nonuniformity": "Non-uniformity Ψ",
    "nonuniformity_hover": "n = {rollers}: Ψ = {nonuniformity} at δ = {error}",
    "one_carries": "one roller carries all",
    "pair_drives": "Satellite {satellite}, pin {pin}<br>drives from {start} to {end}",
    "pair_force": "Satellite {satellite}, pin {pin}<br>{force} at {angle}",
    "peak": "Peak",
    "peak_force": "Peak force",
    "peak_hover": "Peak {force} at {angle}<br>satellite {satellite}, pin {pin}",
    "percentile": "P{percent} = {value}",
    "pieces": "Pieces",
    "pieces_hover": "{pieces} pieces from {low} to {high}",
    "pin": "pin",
    "pin_diameter": "Pin diameter",
    "pin_position": "Position of the pins",
    "plane_xz": "plane xz",
    "plane_yz": "plane yz",
    "play_from": "Play, from",
    "play_to": "Play, to",
    "position_error": "Relative position error δ",
    "pressure_hover": "{name}<br>{pressure} at {place}",
    "reaction": "Reaction",
    "relative_error": "Relative error",
    "reverse_lag": "Lag under reverse torque",
    "roller_angle": "φ₁ = {angle}",
    "roller_circle": "Circle of the roller axes",
    "run_time": "Run time",
    "satellite": "Satellite {satellite}",
    "pair": "S{satellite} P{pin}",
    "pairs_of": "Satellite S, pin P",
    "share_alone": "Alone, S₁",
    "share_in_all": "With others, S_T",
    "share_of_variance": "Share of the variance",
    "shear_force": "Shear force",
    "stiffness": "Stiffness",
    "stiffness_hover": "c/(b·E) = {stiffness} at l/d = {length}",
    "stiffness_min": "Least stiffness",
    "stiffness_ratio": "Stiffness c/(b·E)",
    "stress_hover": "{name}: {stress}, σ/E = {ratio} at l/d = {length}",
    "tolerance": "χ = {tolerance} = {ratio}·d",
    "tolerances": "Tolerances, the largest first",
    "torque": "Torque",
    "torque_at_lag": "{torque} at a lag of {lag}",
    "torque_over_lag": "Torque over lag at {angle}",
    "transmission_error": "Transmission error",
    "used": "Used by the calculator",
    "worst_direction": "Worst direction"
  },
  "methods": {
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
    "graded_quadrature": "Gauss-Legendre quadrature along z, panels graded to the known singularities",
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
    "trapezoid_z": "trapezoid in z"
  },
  "settings": {
    "default": "default",
    "level": "level {value}",
    "pieces": "{value} pieces",
    "positions": "{value} positions",
    "points": "n = {value}",
    "steps": "{value} steps"
  },
  "fields": {
    "allowable_pressure_MPa": [
      "Allowable pressure",
      "Allowable contact pressure: what this body is judged by."
    ],
    "application_factor": [
      "Application factor",
      "Factor on the torque for stresses and pressures, not for losses, wear and the life of bearings; not beside the contact's dynamic factor, which is the same."
    ],
    "backlash_max_arcmin": [
      "Limit of the backlash",
      "Limit whose yield is asked; its quantity is calculated too."
    ],
    "bearing.kind": [
      "Rolling elements",
      "Balls: the life falls with the cube of the load; rollers: with its power 10/3."
    ],
    "bearing.reliability_percent": [
      "Reliability",
      "90, 95, 96, 97, 98 or 99 %: the share of bearings that reach the life."
    ],
    "bearing_distance_mm": [
      "Bearing distance",
      "Distance of the satellite's bearings, from C to B."
    ],
    "bearing_positions_mm": [
      "Places of the bearings",
      "Of both bearings along the shaft, ascending; satellites may lie beyond."
    ],
    "bending_safety": [
      "Safety against bending",
      "Yield strength over bending stress."
    ],
    "bore_radius_mm": [
      "Bore radius",
      "Radius of the satellite's bore."
    ],
    "coefficient": [
      "Friction coefficient",
      "Friction coefficient of the surfaces that slide."
    ],
    "common": [
      "Common to all",
      "Whether all such parts of a piece have the same: one batch, one tool."
    ],
    "contact.eccentricity_mm": [
      "Eccentricity",
      "Eccentricity of the cranks; where it may be left out: hole radius − pin radius."
    ],
    "contact.hole_radius_mm": [
      "Hole radius",
      "Radius of the hole in the satellite: pin radius + eccentricity."
    ],
    "contact.pin_radius_mm": [
      "Pin radius",
      "Radius of the pin, or of its sleeve."
    ],
    "contact_law.kind": [
      "Law of contact",
      "Hertz: line contact with its logarithm; Palmgren: rollers of steel; linear; power."
    ],
    "contact_law.stiffness_N_per_mm": [
      "Contact stiffness",
      "Stiffness of a pair, for the linear law."
    ],
    "contact_length_mm": [
      "Contact length",
      "Length of the contact along the pin: the width of the satellite."
    ],
    "crank_angles": [
      "Crank angles",
      "Even positions of the turn at which each piece is solved."
    ],
    "crank_angles_deg": [
      "Crank angles",
      "Angle of each crank, one for each satellite, instead of an even spacing."
    ],
    "crank_spacing_deg": [
      "Crank spacing",
      "Angle between neighbouring cranks; 360°/K where not given."
    ],
    "crank_support.stiffness_N_per_mm": [
      "Stiffness of a bearing",
      "Radial stiffness of the bearing of one satellite; rigid where not given."
    ],
    "crankshaft.satellite_positions_mm": [
      "Places of the satellites",
      "Middle plane of each satellite along the shaft."
    ],
    "criterion": [
      "Criterion",
      "How the mean stress counts: Goodman, Gerber, Soderberg or Haigh after FKM."
    ],
    "cylinder_length_mm": [
      "Cylinder length",
      "Length of one cylinder, from the middle sphere to the end sphere."
    ],
    "deviations.crank_phase_deg": [
      "Crank phases",
      "Angle of each crank, positive ahead."
    ],
    "deviations.disc_phase_deg": [
      "Disc phases",
      "Angle of each disc's holes against its teeth, positive ahead."
    ],
    "deviations.eccentricity_mm": [
      "Eccentricities",
      "Of each crank."
    ],
    "deviations.hole_radius_mm": [
      "Hole radii",
      "Of each hole's radius."
    ],
    "deviations.pin_radius_mm": [
      "Pin radii",
      "Of each pin's radius."
    ],
    "distribution": [
      "Distribution",
      "Normal, cut off at the limits, three standard deviations off the middle; or uniform."
    ],
    "distribution_factor": [
      "Distribution factor",
      "Factor of uneven load sharing between the pairs."
    ],
    "dynamic_factor": [
      "Dynamic factor",
      "Factor of the dynamic load."
    ],
    "dynamic_rating_N": [
      "Dynamic load rating",
      "Basic dynamic load rating; without it no life is answered."
    ],
    "edition": [
      "Edition",
      "Edition of Shigley whose constants of the surface are taken."
    ],
    "efficiency": [
      "Efficiency",
      "Efficiency of the reducer, needed with the input torque."
    ],
    "endurance_limit_MPa": [
      "Endurance limit",
      "Endurance limit of the part itself, all factors in it."
    ],
    "exponent": [
      "Exponent",
      "Force ∝ approachⁿ, for the power law."
    ],
    "fatigue.life_h": [
      "Life",
      "Time that the pins have to last: for fewer than a million cycles their strength is above the endurance limit; the life of the requirements where not given."
    ],
    "fatigue.reliability_percent": [
      "Reliability",
      "50, 90, 95, 99, 99.9 or 99.99 %; 50 where neither this nor its factor is given."
    ],
    "fatigue_notch_factor": [
      "Fatigue notch factor",
      "Of the seat or any notch where the part bends most; 1 says that there is none."
    ],
    "fatigue_safety": [
      "Safety in fatigue",
      "Factor by which all stresses of a part may grow before it breaks by fatigue."
    ],
    "force_N": [
      "Contact force",
      "Force between pin and hole."
    ],
    "force_exponent": [
      "Force exponent",
      "Force ∝ approach^v: 0 equal sharing, 1 linear, 10/9 and 3/2 the usual contact laws."
    ],
    "friction.life_h": [
      "Life",
      "Time in which it wears."
    ],
    "friction_coefficient": [
      "Friction coefficient",
      "Friction between sphere and hole."
    ],
    "gaps_mm": [
      "Gaps",
      "Gap of each roller before it carries, instead of the worst case of a tolerance."
    ],
    "gear.kind": [
      "Ring",
      "Involute teeth, pins on which a cycloid disc rolls, or none: its force along the crank is left out."
    ],
    "geometry": [
      "Geometry",
      "Exact, or first order in lag and deviations as in the papers."
    ],
    "hole_circle_radius_mm": [
      "Hole circle radius",
      "Radius of the circle of the rollers' holes."
    ],
    "hole_clearance_mm": [
      "Clearance",
      "Radial clearance: hole radius − pin radius − eccentricity; negative is interference."
    ],
    "hole_diameter": [
      "Hole diameter",
      "Class or limits of the diameter of the holes."
    ],
    "hole_diameter.class": [
      "Class",
      "ISO 286 class, as H7 of a hole, instead of limits."
    ],
    "hole_material": [
      "Hole material",
      "A name of the table of materials, or values."
    ],
    "hole_position_mm": [
      "Position of the holes",
      "Diameter of the round zone of each hole's centre."
    ],
    "hole_radial_mm": [
      "Holes outward",
      "Of each hole, outward, a list for each satellite."
    ],
    "hole_tangential_mm": [
      "Holes along the circle",
      "The same in the driving sense."
    ],
    "initial_crank_angle_deg": [
      "Initial wave angle",
      "0° is the sign of Yanchevskiy 2021; 180° that of Yanchevsky 2018, and also what reversing the torque does."
    ],
    "input_speed_rpm": [
      "Input speed",
      "Speed of the crankshaft."
    ],
    "input_torque_Nm": [
      "Input torque",
      "Torque on the crankshaft; T = T₁·u·η."
    ],
    "length_mm": [
      "Length",
      "Length of this stretch of the shaft."
    ],
    "life_curve": [
      "Life curve",
      "How the allowable pressure falls over the life, which a design with a speed has: as that of through- or case-hardened steel, of nitrided steel and cast iron, or of nitrocarburised steel."
    ],
    "load.rollers": [
      "Rollers",
      "Number of rollers."
    ],
    "load.samples": [
      "Samples",
      "Number of points of each curve."
    ],
    "load.torque_direction": [
      "Direction of the torque",
      "Driving: the satellites turn the pins; reverse: the load turns them back; alternating: both are solved, and the worse is given."
    ],
    "load_rotates_with_shaft": [
      "Load turns with the shaft",
      "Whether the mesh turns with the shaft and bends it one way all the time; else its bending is fully reversed."
    ],
    "lost_motion_arcmin": [
      "Limit of the lost motion",
      "Limit whose yield is asked; its quantity is calculated too."
    ],
    "lost_motion_torque_share": [
      "Torque of the lost motion",
      "Share of the torque, in both directions, under which the lost motion is taken."
    ],
    "lower_deg": [
      "From",
      "Lower limit of the deviation."
    ],
    "lower_mm": [
      "From",
      "Lower limit of the deviation."
    ],
    "material": [
      "Material of the pin",
      "A name of the table of materials, or values; that of the contact where it has one."
    ],
    "mating_material": [
      "Material of the satellite",
      "A name of the table of materials, or values."
    ],
    "mating_radius_mm": [
      "Curvature radius of the teeth",
      "Radius of curvature of the satellite's teeth across the contact line: negative, and larger than the roller's, where the roller lies in a hollow."
    ],
    "max_backlash_arcmin": [
      "Largest backlash",
      "Largest play of the unloaded output mechanism over the turn."
    ],
    "max_deflection_mm": [
      "Largest deflection",
      "Largest deflection of the shaft at its bearings, or of the pins in the satellites."
    ],
    "max_lost_motion_arcmin": [
      "Largest lost motion",
      "Largest rotation of the output mechanism between 3 % of the torque in both directions."
    ],
    "max_outer_diameter_mm": [
      "Largest diameter",
      "Largest diameter of the space in which the satellites move."
    ],
    "max_pressure_MPa": [
      "Limit of the pressure",
      "Limit whose yield is asked; its quantity is calculated too."
    ],
    "max_pv_MPa_m_per_s": [
      "Largest pv",
      "Largest pressure on the projected area times sliding speed."
    ],
    "max_sliding_speed_m_per_s": [
      "Largest sliding speed",
      "Largest speed at which pins slide in the holes, or in their sleeves."
    ],
    "max_slope_mrad": [
      "Largest slope",
      "Largest slope of the shaft in its bearings, or of the pins in the satellites."
    ],
    "max_unbalance_N": [
      "Largest unbalanced force",
      "Largest force of the satellites' masses on the crankshaft."
    ],
    "max_unbalance_couple_Nm": [
      "Largest unbalanced couple",
      "Largest couple of the satellites' masses on the crankshaft."
    ],
    "max_wear_mm": [
      "Largest wear",
      "Largest depth of wear of pin or hole at the end of the life."
    ],
    "mechanism.crank_angle_deg": [
      "Crank angle",
      "Crank angle of the section geometry."
    ],
    "min_efficiency": [
      "Least efficiency",
      "Least mean efficiency of the output mechanism alone."
    ],
    "min_wall_mm": [
      "Least wall",
      "Least wall between holes, to the rim and to the bore."
    ],
    "module_mm": [
      "Module",
      "Of the teeth."
    ],
    "nutation_angle_deg": [
      "Nutation angle",
      "Angle between the axes of the central wheel and the satellite."
    ],
    "outer_radius_mm": [
      "Outer radius",
      "Outer radius of the satellite, with its teeth."
    ],
    "output_torque_Nm": [
      "Output torque",
      "Torque on the output link."
    ],
    "overhang_mm": [
      "Overhang",
      "Distance from B to the clamped end of the shaft."
    ],
    "peak_force_N": [
      "Limit of the peak force",
      "Limit whose yield is asked; its quantity is calculated too."
    ],
    "peak_torque_Nm": [
      "Peak torque",
      "Largest torque, for static strength, at least the torque times its factor; that where not given."
    ],
    "percentiles": [
      "Percentiles",
      "Percentages of the percentiles; a rare one needs many samples: 95 % takes 72, 99 % 368."
    ],
    "phi_max_deg": [
      "Contact to",
      "Polar angle on the roller at which contact ends."
    ],
    "phi_min_deg": [
      "Contact from",
      "Polar angle on the roller at which contact starts, instead of a working length."
    ],
    "pin.diameter_mm": [
      "Pin diameter",
      "Diameter of the pin itself, inside its sleeve where it has one."
    ],
    "pin.satellite_positions_mm": [
      "Places of the satellites",
      "Middle plane of each satellite, from the face of the carrier."
    ],
    "pin_circle_radius_mm": [
      "Pin circle radius",
      "Radius of the circle of pin centres."
    ],
    "pin_diameter": [
      "Pin diameter",
      "Class or limits of the diameter that touches the hole."
    ],
    "pin_diameter.class": [
      "Class",
      "ISO 286 class, as m6 of a shaft, instead of limits."
    ],
    "pin_material": [
      "Pin material",
      "A name of the table of materials, or values."
    ],
    "pin_position_mm": [
      "Position of the pins",
      "Diameter of the round zone of each pin's centre."
    ],
    "pin_radial_mm": [
      "Pins outward",
      "Of each pin, outward."
    ],
    "pin_tangential_mm": [
      "Pins along the circle",
      "Of each pin, in the driving sense."
    ],
    "pins": [
      "Pins",
      "Number of pins of the output link, evenly spaced on the pin circle."
    ],
    "pitting_safety": [
      "Safety against pitting",
      "Limit of the contact pressure over the pressure; a ratio of pressures."
    ],
    "poissons_ratio": [
      "Poisson's ratio",
      "Lateral strain over the strain along a tension."
    ],
    "position_angle_deg": [
      "Position angle",
      "Position of the roller on the central wheel; of a wheel's first."
    ],
    "position_tolerance_mm": [
      "Position tolerance",
      "Positional tolerance of the holes; the worst case has one hole ahead in each part."
    ],
    "positions.crank_angle_deg": [
      "Crank angles",
      "Crank angles of the positions; the curve of the lag is taken at the first."
    ],
    "radial_clearance_mm": [
      "Clearance of a bearing",
      "Radial internal clearance, as catalogues give it: half of it to either side."
    ],
    "radial_force_ratio": [
      "Ratio of the ring's forces",
      "Force along the crank over that across it: positive towards the reducer's axis, as with involute teeth, negative outwards, as with a ring of pins."
    ],
    "radius_mm": [
      "Notch radius",
      "Radius of the notch."
    ],
    "ratio": [
      "Ratio",
      "Speed of the crank over speed of the output, u = z₂/(z₃ − z₂), at least 1; a sign is that of the output, which turns the other way."
    ],
    "ratio_u12": [
      "Ratio",
      "Ratio of the mesh with the input shaft held."
    ],
    "reference_approach_mm": [
      "Reference approach",
      "The approach under the reference force."
    ],
    "reference_depth_mm": [
      "Reference depth",
      "Depth to which the approach of the hole is counted; the hole's radius where not given."
    ],
    "reference_force_N": [
      "Reference force",
      "A force whose approach is known, for the power law."
    ],
    "reference_pressure_angle_deg": [
      "Reference pressure angle",
      "Of the teeth; 20° where not given."
    ],
    "reference_z_mm": [
      "Place of C",
      "Place of the bearing C along the axis, from the precession centre."
    ],
    "reliability_factor": [
      "Reliability factor",
      "Its factor instead."
    ],
    "requirements.life_h": [
      "Life",
      "Time that the reducer has to last."
    ],
    "revolutions": [
      "Crank revolutions",
      "Length of the cyclogram, in turns of the crank."
    ],
    "ring_factor": [
      "Factor of the rings",
      "Of the equivalent load: 1.2 is usual where the outer ring turns against the load."
    ],
    "ring_pin_circle_radius_mm": [
      "Circle of the ring's pins",
      "Radius of the circle of the ring's pins, on which a cycloid disc rolls."
    ],
    "ring_pin_radius_mm": [
      "Radius of the ring's pins",
      "With it the roots of a cycloid disc are known, which the holes must not reach."
    ],
    "ring_teeth": [
      "Ring teeth",
      "Number of teeth of the ring, more than the satellite has."
    ],
    "roller.diameter_mm": [
      "Cylinder diameter",
      "Diameter of the cylinders between the spheres."
    ],
    "roller.eccentricity_mm": [
      "Eccentricity",
      "Eccentricity of the crank: judges the length of the rollers."
    ],
    "roller_circle_radius_mm": [
      "Roller circle radius",
      "Radius of the circle of the roller axes."
    ],
    "roller_material": [
      "Material of the rollers",
      "A name of the table of materials, or values."
    ],
    "roller_radius_mm": [
      "Roller radius",
      "Radius of a roller."
    ],
    "roller_rotates": [
      "Roller rotates",
      "Whether the roller spins in its seat: then its bending is fully reversed."
    ],
    "rollers.rollers": [
      "Rollers",
      "The rollers in mesh, one by one."
    ],
    "rollers.samples": [
      "Samples",
      "Number of points of each curve."
    ],
    "rollers_in_mesh": [
      "Rollers in mesh",
      "How many of them touch the satellite, from the first on; all where not given."
    ],
    "rollers_total": [
      "Rollers of the wheel",
      "Number of rollers of the central wheel."
    ],
    "root_radius_mm": [
      "Root radius",
      "Radius at the root of the satellite's teeth."
    ],
    "rotates": [
      "Pin rotates",
      "Whether the pin turns in the carrier: then its bending is fully reversed."
    ],
    "satellite_coupling.kind": [
      "Coupling of the satellites",
      "Rigid: all turn as one; elastic: each gives in its mesh with the ring; shares: each carries a given share."
    ],
    "satellite_mass_kg": [
      "Mass of a satellite",
      "With its bearing; without it no balance is answered."
    ],
    "satellite_teeth": [
      "Satellite teeth",
      "Number of teeth of a satellite; gives the ratio and the assembly angles."
    ],
    "satellites": [
      "Satellites",
      "Number of satellites, each on its own crank."
    ],
    "seed": [
      "Seed",
      "Of the draws: the same seed gives the same pieces, however many there are."
    ],
    "shaft.diameter_mm": [
      "Diameter",
      "Diameter of the shaft there."
    ],
    "shaft_diameter_mm": [
      "Shaft diameter",
      "Diameter of the shaft, the same everywhere."
    ],
    "shaft_sections": [
      "Shaft sections",
      "Stretches of the shaft from C to the clamp, instead of one diameter; their lengths add up to a + b."
    ],
    "shares": [
      "Shares of the torque",
      "Share of each satellite, together 1."
    ],
    "shear_modulus_GPa": [
      "Shear modulus",
      "Shear modulus of the rollers, instead of Poisson's ratio."
    ],
    "sleeve": [
      "Sleeves on the pins",
      "Whether sleeves roll in the holes and slide on the pins; the pin diameter is needed."
    ],
    "span_mm": [
      "Span",
      "Distance of the two supports; not for a cantilever."
    ],
    "sphere_diameter_mm": [
      "Sphere diameter",
      "Diameter of the spherical parts."
    ],
    "sphere_width_mm": [
      "Sphere width",
      "Width of a spherical part along the roller."
    ],
    "static_rating_N": [
      "Static load rating",
      "Basic static load rating, for the static safety."
    ],
    "static_safety": [
      "Static safety of bearings",
      "Static load rating of a bearing over its largest load; 1 for balls, 1.5 for rollers where it is not given."
    ],
    "stiffness_Nm_per_arcmin": [
      "Stiffness of a mesh",
      "Torque of one satellite over what its mesh lets it turn, for elastic coupling."
    ],
    "stiffness_min_Nm_per_arcmin": [
      "Limit of the stiffness",
      "Limit whose yield is asked; its quantity is calculated too."
    ],
    "stress_concentration": [
      "Stress concentration",
      "Stress concentration at the step beside the middle sphere."
    ],
    "study.samples": [
      "Samples",
      "Pieces that are drawn; samples × pairs × crank angles are bounded. Where they are not given as many as fit, up to 4096, or 1024 with contributions."
    ],
    "study.torque_direction": [
      "Direction of the torque",
      "Driving: the satellites turn the pins; reverse: the load turns them back."
    ],
    "support": [
      "Support",
      "Held at one end (cantilever), at both ends free to tilt (supported), or at both ends built in (fixed); the truth of a cage lies between the latter two."
    ],
    "surface": [
      "Surface",
      "How the surface was made; cold-drawn counts as machined."
    ],
    "surface_factor": [
      "Surface factor",
      "Its factor instead."
    ],
    "teeth_difference": [
      "Difference of teeth",
      "Teeth of the ring less those of a satellite; that of the mechanism's teeth where these are given."
    ],
    "tensile_strength_MPa": [
      "Tensile strength",
      "Tensile strength: what fatigue is judged by."
    ],
    "theoretical_factor": [
      "Stress concentration",
      "Elastic stress concentration factor of the notch."
    ],
    "tolerances.crank_phase_deg": [
      "Crank phase",
      "Angle of each crank: plus or minus so much, or limits."
    ],
    "tolerances.disc_phase_deg": [
      "Disc phase",
      "Angle of each disc's holes against its teeth: plus or minus so much, or limits."
    ],
    "tolerances.eccentricity_mm": [
      "Eccentricity",
      "Of each crank: plus or minus so much, or limits."
    ],
    "torque_Nm": [
      "Torque",
      "Torque on the central wheel; its sign chooses the loaded flanks."
    ],
    "torque_sign": [
      "Sign of the torque",
      "Chooses the loaded flank of rollers whose limits are given in z."
    ],
    "torques_Nm": [
      "Torques",
      "Torques of the curve of the lag, negative in reverse; shares of the load where not given."
    ],
    "transmission_error_arcmin": [
      "Limit of the transmission error",
      "Limit whose yield is asked; its quantity is calculated too."
    ],
    "upper_deg": [
      "To",
      "Upper limit of the deviation."
    ],
    "upper_mm": [
      "To",
      "Upper limit of the deviation."
    ],
    "wear_rate_mm3_per_Nm": [
      "Wear coefficient",
      "Worn volume over force and sliding distance (Archard)."
    ],
    "weibull_slope": [
      "Weibull slope",
      "Slope of the distribution of lives, for the life of all bearings together."
    ],
    "wheel": [
      "Wheel",
      "Evenly spaced rollers with one working length, instead of a list."
    ],
    "yield_strength_MPa": [
      "Yield strength",
      "Yield strength: judges bending, or yield below the surface."
    ],
    "youngs_modulus_GPa": [
      "Young's modulus",
      "Modulus of elasticity of the material."
    ],
    "z_max_mm": [
      "Working length to",
      "End of the working length."
    ],
    "z_min_mm": [
      "Working length from",
      "Start of the working length, along the axis from the precession centre."
    ]
  },
  "materials": {
    "steel_structural": "Structural steel (S235JR)",
    "steel_s355": "Structural steel (S355J2)",
    "steel_through_hardened": "Through-hardened alloy steel (42CrMo4, 300 HV)",
    "steel_case_hardened": "Case-hardened steel (18CrNiMo7-6)",
    "steel_bearing": "Bearing steel (100Cr6, hardened)",
    "iron_grey": "Grey cast iron (EN-GJL-250)",
    "iron_nodular": "Nodular cast iron (EN-GJS-400-15)",
    "bronze_tin": "Tin bronze, sand cast (CuSn12-C-GS)",
    "bronze_tin_centrifugal": "Tin bronze, centrifugally cast (CuSn12-C-GZ)",
    "bronze_tin_nickel": "Tin-nickel bronze, centrifugally cast (CuSn12Ni2-C-GZ)",
    "bronze_aluminium": "Aluminium bronze, centrifugally cast (CuAl10Fe5Ni5-C-GZ)",
    "brass": "Brass (CuZn39Pb3)",
    "plastic_pom": "Acetal (POM-C)",
    "plastic_pa66": "Polyamide 66, conditioned",
    "plastic_pa66_gf30": "Polyamide 66, 30 % glass, conditioned",
    "plastic_peek": "PEEK, unfilled"
  },
  "materialGroups": {
    "steel": "Steel",
    "cast_iron": "Cast iron",
    "bronze": "Bronze",
    "brass": "Brass",
    "plastic": "Plastic"
  },
  "criteria": {
    "endurance": "endurance",
    "endurance_mean": "endurance, mean pressure",
    "static": "static",
    "given": "given"
  },
  "verified": {
    "standard": "read in the standard",
    "secondary": "two secondary sources"
  },
  "checks": {
    "dead_centre": [
      "Dead centres",
      "There no pair drives, and no torque is transmitted."
    ],
    "crank_balance": [
      "Static balance of the crank spacing",
      "Otherwise the satellites shake the reducer with every turn of the crank."
    ],
    "assembly": [
      "Satellites that differ",
      "Otherwise they are different parts that can be exchanged by mistake."
    ],
    "contact_pressure_pin": [
      "Contact pressure of the pin",
      "Above it the surface of the pin pits within the life."
    ],
    "contact_shakedown_pin": [
      "Shakedown of the pin",
      "Above it the surface of the pin flows on with every turn."
    ],
    "contact_yield_pin": [
      "First yield of the pin",
      "Above it the pin yields below its surface in the first turns."
    ],
    "contact_pressure_hole": [
      "Contact pressure of the hole",
      "Above it the surface of the hole pits within the life."
    ],
    "contact_shakedown_hole": [
      "Shakedown of the hole",
      "Above it the surface of the hole flows on with every turn."
    ],
    "contact_yield_hole": [
      "First yield of the hole",
      "Above it the hole yields below its surface in the first turns."
    ],
    "contact_conformity": [
      "Width of the contact",
      "Above it the pressure by Hertz is off by more than 1 %."
    ],
    "interference": [
      "Room of the pins in their holes",
      "Otherwise the parts cannot be put together, jam, or press without load."
    ],
    "clearance": [
      "Clearance over eccentricity",
      "Otherwise the play is a large part of what the mechanism moves by."
    ],
    "backlash": [
      "Backlash of the output mechanism",
      "Otherwise the unloaded output turns by more than is asked."
    ],
    "lost_motion": [
      "Lost motion of the output mechanism",
      "Otherwise the output gives way by more than is asked when the torque turns."
    ],
    "wall_holes": [
      "Wall between holes",
      "Otherwise the holes overlap, or the satellite is weak between them."
    ],
    "pins_apart": [
      "Space between pins",
      "Otherwise the pins overlap."
    ],
    "holes_off_centre": [
      "Holes beside the centre",
      "Otherwise the holes reach the axis."
    ],
    "wall_rim": [
      "Wall to the rim",
      "Otherwise the holes break through the rim of the satellite."
    ],
    "wall_bore": [
      "Wall to the bore",
      "Otherwise the holes break into the bore of the satellite."
    ],
    "outer_diameter": [
      "Diameter of the space of the satellites",
      "Otherwise the satellites do not fit into the space that is asked."
    ],
    "pin_static": [
      "Static strength of the pins",
      "Above it the pins bend for good."
    ],
    "pin_fatigue": [
      "Fatigue of the pins",
      "Below it the pins break after some time where they bend most."
    ],
    "pin_deflection": [
      "Deflection of the pins",
      "Above it the satellites share the load unevenly."
    ],
    "pin_slope": [
      "Slope of the pins in the satellites",
      "Above it the contacts carry on their edges."
    ],
    "efficiency": [
      "Efficiency of the output mechanism",
      "Below it more is lost than is asked."
    ],
    "sliding_speed": [
      "Sliding speed",
      "Above it the surfaces get hot."
    ],
    "pv": [
      "Pressure times sliding speed",
      "Above it the surfaces get hot and wear fast."
    ],
    "wear": [
      "Wear of pins and holes",
      "Above it the output has more play than is asked before the end of its life."
    ],
    "pressure_angle": [
      "Operating pressure angle",
      "Above it the ring loads the bearings far more than the torque needs."
    ],
    "gear_room": [
      "Holes within the teeth",
      "Otherwise the holes lie in the teeth of the satellite, or beyond."
    ],
    "bearing_life": [
      "Life of the satellites' bearings",
      "Otherwise a bearing of a satellite fails before the life that is asked."
    ],
    "bearing_static": [
      "Static load of the satellites' bearings",
      "Otherwise rolling elements dent their tracks."
    ],
    "system_life": [
      "Life of all satellites' bearings together",
      "Otherwise one of the bearings fails before the life that is asked."
    ],
    "crank_bearing_life": [
      "Life of the crankshaft's bearings",
      "Otherwise a bearing of the crankshaft fails before the life that is asked."
    ],
    "unbalance_force": [
      "Unbalanced force of the satellites",
      "Above it the satellites shake the reducer more than is asked."
    ],
    "unbalance_couple": [
      "Unbalanced couple of the satellites",
      "Above it the satellites shake the reducer more than is asked."
    ],
    "roller_stress": [
      "Bending stress of the rollers",
      "Above it the rollers bend for good."
    ],
    "roller_fatigue": [
      "Fatigue of the rollers",
      "Below it the rollers break after some time beside the middle sphere."
    ],
    "roller_sharing": [
      "Rollers that carry",
      "Otherwise few rollers carry all of the load."
    ],
    "roller_spacing": [
      "Space between rollers",
      "Otherwise the spheres overlap."
    ],
    "roller_room": [
      "Rollers beside the centre",
      "Otherwise the rollers reach the axis."
    ],
    "roller_tilt": [
      "Length of the rollers",
      "Shorter ones tilt too much against the discs."
    ],
    "line_spacing": [
      "Space between rollers",
      "Otherwise the rollers overlap."
    ],
    "shaft_in_circle": [
      "Shaft within the rollers",
      "Otherwise the shaft reaches the rollers."
    ],
    "shaft_deflection": [
      "Deflection of the shaft",
      "Above it the mesh is off its place."
    ],
    "shaft_slope": [
      "Slope of the shaft in its bearings",
      "Above it the bearings carry on their edges."
    ],
    "shaft_static": [
      "Static strength of the shaft in bending",
      "Above it the shaft bends for good."
    ],
    "shaft_fatigue": [
      "Fatigue of the shaft in bending",
      "Below it the shaft breaks after some time where it bends most."
    ],
    "line_pressure": [
      "Pressure along the contact lines",
      "Above it rollers or teeth pit in the long run."
    ]
  },
  "checkGroups": {
    "mechanism": "Mechanism",
    "contact": "Contact of pin and hole",
    "geometry": "Pins and holes",
    "play": "Play of the output",
    "pin": "Strength of the pins",
    "friction": "Friction and wear",
    "gear": "Ring",
    "bearing": "Bearings of the satellites",
    "crankshaft": "Crankshaft",
    "body": "Satellite",
    "rollers": "Rollers",
    "lines": "Contact lines",
    "shaft": "Bending of the shaft",
    "room": "Room for rollers and shaft"
  },
  "checkReasons": {
    "beyond_size": "The strengths of the material do not hold for so thick a pin: enter those of its size",
    "cannot_assemble": "The parts cannot be put together at any crank angle: pins and holes press by more than they stand",
    "clearance_like_eccentricity": "The clearance is nearly as large as the eccentricity: what moves so is hardly meant",
    "conformal_solution": "The pressure is that of the conformal contact, which asks for no narrow one",
    "cranks_deviate": "The balance is known of cranks without deviations only",
    "dead_centre": "The mechanism has a dead centre: the forces are not bounded",
    "different_parts": "Satellites differ in how their holes lie against their teeth: each needs a drawing of its own",
    "discs_out_of_phase": "Each satellite by itself goes onto the pins, all together do not: the holes of one are turned against those of another",
    "eccentricity_missing": "No eccentricity is given: it is taken as hole radius minus pin radius",
    "endurance_unknown": "No endurance limit is known for this material: enter one, or its tensile strength where it is a steel",
    "fits_by_bearing_clearance": "The parts go together only as far as the clearance of the bearings on the cranks lets the satellites move",
    "finite_life": "The strength is that for the cycles of the life, one a turn of the satellite against its crank",
    "jams": "The parts go together, but jam in a part of the turn",
    "life_of_teeth": "The limit is that for the loads over the life, by the curves of ISO 6336-2, which are meant for teeth",
    "life_without_speed": "No input speed is given: how the limit falls over the life is left out",
    "limit_unknown": "No limit of the pressure is known for this material: enter one",
    "mass_unknown": "No mass of a satellite is given",
    "no_balance": "The forces with clearance and deviations find no balance: the contacts are too soft for the load, or the clearance is too large",
    "no_bush": "The pv is that of a bush: a bare pin touches its wider hole along a narrow strip",
    "no_involute": "It is one of involute teeth",
    "no_life_curve": "How the limit falls over the life is not known for this material: it is left out",
    "no_limit": "No limit was asked",
    "no_pressure": "The contact is wider than the pin: no pressure is known",
    "no_teeth": "No teeth or pins of the ring are given",
    "notch_unknown": "Neither a notch nor its factor is given; 1 says that there is none",
    "one_only": "There is one only",
    "plastic_first": "The first turns yield below the surface; the contact settles after that",
    "pressed_without_load": "With these deviations pins and holes press without load",
    "pressure_error": "The limit lies within the error of the value",
    "rating_unknown": "No load rating of the bearing is given",
    "roots_unknown": "The roots of the satellite's teeth are not known: enter their radius, or the one of the ring's pins",
    "rough_guide": "The contact is too wide for Hertz, and the materials too different for a conformal pressure: the pressure is a rough guide",
    "section_missing": "A part of the design that it needs is not given",
    "size_missing": "A size that it needs is not given",
    "speed_missing": "No input speed is given",
    "steep_mesh": "The ring presses the satellite along the crank far more than it turns it",
    "steady_load": "The load turns with the shaft and bends it one way all the time",
    "tested_limit": "The tested limit of this material counts, not its yield strength",
    "tilted": "Rollers are usually tilted by about 12° at most: the forces take them as parallel to the axis",
    "too_large": "There are more pairs of pin and hole than it is calculated for",
    "too_many_pairs": "The forces with clearance are solved for 100 pairs of pin and hole at most",
    "unbalanced": "The satellites need a counterweight",
    "uneven": "Not every roller carries",
    "unloaded": "The loads cancel: nothing presses the bearings",
    "value_unknown": "Nothing is known of the value: its error is as large as it is, or has no end",
    "wear_unknown": "No wear coefficient is given",
    "yield_unknown": "No yield strength is known: enter one"
  },
  "checkSources": {
    "archard_1953": "Archard 1953, with the wear coefficient that was given",
    "balance": "statics of rotating masses",
    "beam": "beam theory (Mohr)",
    "geometry": "geometry",
    "hertz": "Johnson, Contact Mechanics, 4.2: Hertz asks for a narrow contact",
    "iso_281_life": "ISO 281:2007, with the ratings that were given",
    "iso_76_rating": "ISO 76: the rating is the load that dents by 1e-4 of a rolling element",
    "johnson_yield": "Johnson, Contact Mechanics, 4.2 and 9.1; recomputed: p = 1.79*Re (Mises)",
    "johnson_shakedown": "Melan's theorem, as in Johnson, Contact Mechanics, 9.2; recomputed: p = 2.31*Re (Mises)",
    "load_sharing": "solved over the turn with clearance, deviations and elasticity, as by load sharing",
    "ovsyannikov_2019": "Ovsyannikov et al. 2019",
    "ovsyannikov_2019_length": "Ovsyannikov et al. 2019, before fig. 3: usually rollers are at least ten times as long as the centre distance, tilted by about 12°",
    "pin_beam": "beam theory, the true locus of the moment; yield strength of the material",
    "roots": "geometry; where no root radius is given: of a cycloid disc r_f = R_p − e − r_p, of involute teeth r_f = m·(z₂/2 − 1.25 + x) by the basic rack of ISO 53, with a profile shift taken as 0 ≤ x ≤ 1.25",
    "shigley": "Shigley, Mechanical Engineering Design, 6; or the endurance limit that was given",
    "static_guide": "guide values for running as usual, 1 for balls and 1.5 for rollers: catalogues of SKF and IKO, after ISO 76",
    "steep": "derived: above 55° the ring presses the satellite along the crank far more than it turns it",
    "user": "the limit that was asked",
    "wang_2016": "Wang, Luo, Su 2016, eqs 32, 33, and the wall that was asked",
    "yanchevskiy_2021": "Yanchevskiy, Niekhoroshykh 2021",
    "yanchevsky_2018": "Yanchevsky et al. 2018, eq. 2"
  },
  "notConsidered": {
    "bearing": "bearings of the satellites",
    "clearance": "load sharing with clearance and deviations",
    "contact": "pins and holes",
    "contact_life_hole": "life of the holes under their contact pressure",
    "contact_life_pin": "life of the pins under their contact pressure",
    "crankshaft": "crankshaft and balance of masses",
    "deflection": "deflection of the shaft, of which no limit is asked",
    "fatigue": "fatigue",
    "friction": "friction, wear and efficiency",
    "gear": "teeth of satellite and ring",
    "line_pressure": "pressure along the contact lines",
    "load": "load",
    "pin": "bending of the pins",
    "roller_contact": "contact of spheres and holes",
    "satellite_body": "body of the satellite",
    "shaft_strength": "strength of the shaft",
    "slope": "slope of the shaft, of which no limit is asked"
  },
  "limitSources": {
    "iso_14521": "ISO/TR 14521 (DIN 3996), worm wheel materials: pitting against hardened steel, of the mean pressure, so that the largest one is on the safe side; as in KISSsoft and MITCalc",
    "iso_281": "ISO 281:2007, fatigue load limit; clean and well lubricated; as in Zaretsky 2010 and bearing calculations after ISO/TR 1281-2",
    "iso_6336_5": "ISO 6336-5, pitting, grade MQ; as in KISSsoft and Roloff/Matek",
    "iso_6336_5_normalized": "ISO 6336-5, pitting, normalized steel: HBW + 190; as in a table of ISO 6336-5:2016 and in Roloff/Matek",
    "iso_6336_5_hardness": "ISO 6336-5, pitting, grade ML: 1.313*HV + 188; as in a table of ISO 6336-5:2016 and in Roloff/Matek",
    "iso_6336_5_static": "ISO 6336-5 and ISO 6336-2, 1.6 times the pitting limit for few loads; as in Autodesk Inventor and MITCalc",
    "iso_76": "ISO 76:2006, 3.3, roller bearings: permanent set of 1e-4*D"
  },
  "examples": {
    "opening": "To begin with: 3 pins, 2 satellites, case-hardened",
    "yanchevskiy-2021-fig-6a": "3 pins, 2 satellites at 180°: always 3 pairs (2021, fig. 6 a)",
    "yanchevskiy-2021-fig-6b": "3 pins, 2 satellites at 120°: 2 or 4 pairs (2021, fig. 6 b)",
    "yanchevskiy-2021-fig-6c": "3 pins, 2 satellites at 90°: 2, 3 or 4 pairs (2021, fig. 6 c)",
    "yanchevskiy-2021-fig-6d": "3 pins, 3 satellites at 120°: 3 or 6 pairs (2021, fig. 6 d)",
    "yanchevskiy-2021-fig-6e": "4 pins, 3 satellites at 120°: always 6 pairs (2021, fig. 6 e)",
    "yanchevskiy-2021-fig-6f": "3 pins, 4 satellites at 90°: always 6 pairs (2021, fig. 6 f)",
    "yanchevskiy-2021-fig-7": "Force curve of 3 satellites: complex over the turn (2021, fig. 7)",
    "yanchevsky-2018-fig-4a": "3 pins, 1 satellite: 1 or 2 pairs (2018, fig. 4 a and 6 a)",
    "yanchevsky-2018-fig-4b": "3 pins, 2 satellites: always 3 pairs (2018, fig. 4 b and 6 b)",
    "zyl-6-pins": "Equal sharing, 6 pins: 888.2 N (Zyl)",
    "zyl-4-pins": "Equal sharing, 4 pins: 1538 N (Zyl)",
    "clearance": "0.03 mm of clearance: fewer pins carry, each more",
    "whole": "A whole reducer of 400 N·m: pins, losses, bearings and crankshaft",
    "ovsyannikov-2019-fig-6": "4 rollers, l/d = 2, χ/d = 2·10⁻⁴ (2019, fig. 6)",
    "ovsyannikov-2019-fig-4": "Stiffness over length, G = 78 GPa (2019, fig. 4)",
    "ovsyannikov-2019-fig-5": "Beyond the limit one roller carries all (2019, fig. 5)",
    "khatetovsky-2020-four-rollers": "4 rollers in mesh, shaft of one diameter (2020)",
    "khatetovsky-2020-wheel": "Wheel of 24 rollers, 9 in mesh, stepped shaft (2020)"
  },
  "calculations": {
    "hertz": "Hertz contact of pin and hole",
    "contact-force": "Contact force",
    "roller-strength": "Strength of swinging rollers",
    "cyclogram": "Cyclogram",
    "crank-planetary": "Crank-planetary reducer",
    "output-efficiency": "Efficiency of the output mechanism",
    "load-sharing": "Load sharing with clearance and errors",
    "pin-strength": "Strength of the pins",
    "satellite-bearing": "Bearings of the satellites",
    "crankshaft": "Crankshaft",
    "tolerance-study": "Tolerances and their effect",
    "precession/contact-line": "Contact lines of the precessional gear",
    "precession/meshing-load": "Load of the precessional mesh",
    "precession/shaft-deflection": "Shaft of the precessional gear",
    "solve": "An input solved for a result",
    "work-precision": "Error against run time"
  }
};
