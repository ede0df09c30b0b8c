"""English words of worked steps, by code."""

NOTES = {
    "working": "A pair drives while the cosine of its pressure angle is positive: half of its "
    "period.",
    "repeats": "m: how many times the phases of the satellites repeat within a sector of the pins.",
    "counted": "Counted between the switching angles.",
    "half": "Every pair drives half of the time.",
    "search": "Between neighbouring switching angles the same pairs drive and every force is "
    "smooth. The ends and the stationary points of every such segment are compared; the largest "
    "force and its first place are these.",
    "pressure_angle": "Satellite {satellite}, pin {pin}, at the crank angle of the peak; k takes "
    "whole turns away.",
    "driving": "Σ cos¹⁺ᵛ of the pressure angles, over the {count} pairs that drive at the crank "
    "angle of the peak.",
    "least_support": "The sum runs over the driving pairs at the switching angle where it is "
    "smallest.",
    "of_shafts": "Two shafts that pins couple turn alike, and the wave with them.",
    "powers_out": "The output power leaves by the members whose torque turns against their speed.",
    "willis": "Every planetary gear obeys n_in + u·n_c = (u + 1)·n_r.",
    "narrow": "Hertz's theory asks for a contact much narrower than the pin.",
    "integral_equation": "By the equation of a disc in a hole, solved for λ, α and β.",
    "edge_tension": "Hoop tension in the rim of the hole at the ends of the contact.",
    "governs_hertz": "Hertz's pressure governs.",
    "governs_conformal": "The conformal pressure governs: Hertz's is more than 1 % too low.",
    "limit": "The limit of its own material ({criterion}): {source}.",
    "limit_given": "The limit of its own material, as given.",
    "turns_over_life": "Turns of a satellite against its crank over the life: in each a place of "
    "pin or hole is loaded once.",
    "life_of_teeth": "A curve for teeth: how the limit falls with the number of loads. Lubricant, "
    "speed and roughness are left out.",
    "in_kpsi": "R_k is a thousand pounds a square inch; the ratio is held to 70 to 200.",
    "smaller": "The smaller of the two. A ratio of pressures: the load reserve is its square as "
    "long as Hertz's pressure governs.",
    "mean_gap": "c·χ/F_m by the tolerance of equal mean gap: χ = Σ(g − g_min)/(4·(n − 1)).",
    "sharing": "The rollers close in the order of their gaps; as many carry as the force needs.",
    "gaps": "(n·F_m/c + Σg)/m: the sum runs over the gaps of the rollers that carry. A tolerance "
    "means one roller ahead of the others by 4χ.",
    "quadrature": "∫ √(1 + (ρ·A·sin φ₁ / (A² + 2·A·z·cos φ₁ + z²))²) dz between its ends. The "
    "integral has no pole; here it is computed numerically. The first roller is shown; the others "
    "go the same way.",
    "others": "The sum over all rollers.",
    "flank": "The first roller; k half-turns lead to the flank that carries.",
    "no_axial": "The normals of the rollers have no part along the axis.",
    "least_arm": "At the end of a line where the arm is smallest.",
    "stretches": "Mohr's integral, summed over the stretches of one diameter.",
    "smallest": "The smallest diameter everywhere.",
    "section": "Forces of all satellites added as vectors in every section and at every crank "
    "angle; the largest is this.",
    "equivalent": "By Mises, of bending and shear at the same point; over the section, the pin and "
    "the turn the largest.",
    "edge": "By the slope of the bent pin in its hole.",
    "shared": "The largest over the turn: of ideal forces with the load shared equally by the "
    "satellites, else of the forces that are solved.",
    "given": "As given.",
    "tabled": "By the reliability asked.",
    "in_stress": "The stress concentration is in the stress already; it counts once.",
    "comes_and_goes": "The stress comes and goes: from nothing to its largest.",
    "most_bent": "Both ends of every stretch are compared; the one that is bent most counts.",
    "worst_section": "Both ends of every stretch are compared; the one that uses most of its "
    "fatigue strength counts.",
    "worst_cycle": "All sections and directions are compared; the one that uses most of the "
    "fatigue strength counts.",
    "criterion": "By the criterion chosen.",
    "finite_life": "By the line from 1000 cycles to a million.",
    "turns_in_radians": "A speed counts in radians a second here: 2·π for each turn.",
    "deflected": "The beam with its shear bends under the forces of all satellites; the value is "
    "that at satellite {satellite}, the largest over the turn.",
    "mean_of_turn": "Mean over the turn of the sum of all contact forces, as a share of T/R.",
    "mean_of_mesh": "Mean over the turn of the ring's mesh, as it is solved.",
    "over_turn": "Over the turn.",
    "couple": "By so much the loss is too large: this share of the torque does no sliding.",
    "bearing_load": "√(W² + (ρ·W + S − F_c)²) over the turn, by W = T_j/(e·u) of the ring and the "
    "sum S of the pins' forces; satellite {satellite}, whose bearing is loaded most, carries the "
    "part T_j of K_α·T.",
    "equivalent_load": "The mean over the turn of the load to the power p, its root; satellite "
    "{satellite}.",
    "reliable": "L₁₀ times the factor of ISO 281 for {percent} %.",
    "together": "The life counts until the first of the bearings fails.",
    "shortened": "ρ = −(2 − (1 − k²)/k·ln((1 + k)/(1 − k)))/(π·k), of many pins that share as "
    "linear contacts do.",
    "reaction": "√(X² + Y²) from the balance of the shaft, the largest over the turn.",
    "equivalent_reaction": "The mean over the turn of the reaction to the power p, its root.",
    "carried": "Each mass counts by the share that {letter} carries, by its place between the "
    "bearings.",
    "peak_torque": "k is the peak torque over the torque of this load.",
    "under_peak": "Solved anew under the peak torque: these forces do not grow in proportion.",
    "opposite": "Opposite to what it balances; counted as the crank angles are.",
    "equilibrium": "Moments about the other bearing where the reaction is largest, of the loads "
    "turned by their cranks.",
    "along_x": "q_C times the sum over the lines of ∫ A/z ds, computed numerically; s is the "
    "length along each line.",
    "along_y": "−q_C times the sum over the lines of ∫ y/(z·sin φ₁) ds, computed numerically; y = "
    "z + A·cos φ₁, s is the length along each line.",
    "about_x": "q_C times the sum over the lines of ∫ y·(z − l)/(z·sin φ₁) ds, computed "
    "numerically; y = z + A·cos φ₁, s is the length along each line.",
    "about_y": "q_C times the sum over the lines of ∫ A·(z − l)/z ds, computed numerically; s is "
    "the length along each line.",
    "own_torque": "The torque itself.",
    "ideal_beside_solved": "The steps are those of the ideal mechanism, without clearance, errors "
    "and bending. The forces that are solved are judged: the real peak force and all that rests on "
    "it.",
    "decades_left": "ln(10⁶/N_L)/ln 1000: at a million cycles nothing is left, and the strength is "
    "the endurance limit.",
    "of_bending": "The bending stress.",
    "solved": "Solved with clearance, deviations and elasticity as they are given.",
    "of_distances": "By the distances of pins and holes, searched over the turn.",
    "simulated": "Counted over random pieces.",
    "root": "Found by narrowing a range until the result is what is wanted.",
    "sharpest": "The sharpest place lies on the flanks or at the tip, by how much the path is "
    "shortened.",
    "many_ring_pins": "The formula holds for perfect parts on many pins, contacts linear.",
    "hardest_pin": "Satellite {satellite}, pin {pin}, where the pressure is largest.",
    "felt": "Less than decimals lose: taken as none.",
    "ring_load": "W·√(1 + ρ²), the largest over the turn, by W = T_j/(e·u); satellite {satellite}.",
    "crank_load": "Satellite {satellite} loads its crank so where the reaction of {letter} is "
    "largest: W = T_j/(e·u) by its part of the torque, along the crank Q = ρ·|W| and the sum of "
    "its pins' forces.",
    "unbalanced": "Reaction to the centrifugal forces of satellites and counterweights.",
    "vectors": "m·e of each satellite and the unbalance of each counterweight, added as vectors by "
    "their angles α.",
    "vectors_couple": "The unbalances as vectors, each times its z from the middle of the bearings "
    "and n_1².",
}
"""What is to be known of a step, and how a number was got in the place of a formula."""

ERRATA = {
    "assembly": "printed with j·α, which would turn the first satellite against itself.",
    "arcsin": "printed with an arcsine whose argument passes 1 by rounding; the pin radius "
    "cancels out of it.",
    "below1": "the remark that f stays below 1 is false for one satellite.",
    "zyl": "the sum is taken where it is smallest; at a dead centre the printed form gives a "
    "number by rounding, here it is refused.",
    "approximation": "holds to 2 % for 3 to 5 pins and 1 or 2 satellites only.",
    "intersection": "the root C₁ of the intersection cancels to zero where pin and hole touch; "
    "the clearance decides instead.",
    "compliance": "in (11) to (13) the number of rollers must multiply the shear term too.",
    "single": "one roller carries all from δ = n/4 on; the printed 1 is that of four rollers.",
    "slope": "the printed slope (5) is a difference that cancels; this is its simplified form.",
    "normal": "(10) must read n₁y = −cos φ, and (24) end with a plus; else the arm depends on the "
    "frame.",
    "reaction": "printed C_x = F_x − B_x; with it the forces do not balance.",
    "mohr": "(33) to (36) exchange the unit loads of B and C; as printed Maxwell's reciprocity "
    "fails.",
}
"""What the print of a source has wrong."""

SOURCES = {
    "yanchevsky2018": "Yanchevsky et al. 2018",
    "yanchevskiy2021": "Yanchevskiy, Niekhoroshykh 2021",
    "zyl": "Zyl",
    "ovsyannikov2019": "Ovsyannikov et al. 2019",
    "khatetovsky2020": "Khatetovsky et al. 2020",
    "johnson": "Johnson, Contact Mechanics, 4.2",
    "persson": "Persson 1964",
    "shigley": "Shigley, Mechanical Engineering Design, 6",
    "archard": "Archard 1953",
    "iso6336": "ISO 6336-2",
    "iso281": "ISO 281",
    "iso76": "ISO 76",
}
"""Where formulas stand."""

VALUES = {
    "ratio": "Ratio",
    "output_torque_Nm": "Output torque",
    "pin_torque_Nm": "Torque on the pins",
    "turning_speed_rpm": "Speed of the crank against the ring",
    "pressure_angle_deg": "Pressure angle of the pair of the peak",
    "support": "Sum over the pairs that drive there",
    "line_load_N_per_mm": "Line load",
    "load_parameter": "Load parameter",
    "loads": "Loads over the life",
    "life_factor": "Life factor",
    "life_cycles": "Cycles over the life",
    "strength_fraction": "Share of the tensile strength at 1000 cycles",
    "shear_modulus_GPa": "Shear modulus",
    "bending_compliance_mm_per_N": "Compliance in bending",
    "shear_compliance_mm_per_N": "Compliance in shear",
    "scale_mm": "Length A of the contact lines",
    "full_arm_load_N_per_mm": "Line load where the arm is R_C",
    "centrifugal_force_N": "Centrifugal force of a satellite",
    "neuber_root": "Root of Neuber's length, in √mm",
    "satellite_torque_Nm": "Torque of the satellite",
    "across_force_N": "Load of the crank across it",
    "along_force_N": "Load of the crank along it",
    "notch_strength_MPa": "Tensile strength within the range of the fit",
    "decades_left": "Part of the decades left to a million cycles",
    "mismatch_alpha": "Dundurs' α",
    "mismatch_beta": "Dundurs' β",
    "shortening": "Shortening of the cycloid",
    "reaction_part_N": "Part of the reaction",
    "tool_circle_radius_mm": "Radius of the tool's circle",
    "tool_radius_mm": "Radius of the tool",
    "tool_shortening": "Shortening coefficient of the tool's path",
    "pin_angle_deg": "Angle from the crank to the pin",
    "path_slope": "Slope of the path over its circle",
    "path_radius_mm": "Radius of curvature of the path",
    "ring_pin_force_N": "Force on the pin of the ring",
    "base_radius_mm": "Base radius of the satellite",
    "eccentricity_without_backlash_mm": "Eccentricity without backlash",
    "normal_backlash_mm": "Backlash along the normal",
    "contact_ratio": "Contact ratio",
    "start_roll_satellite": "Tangent of the satellite's pressure angle at the start of the path",
    "satellite_tip_radius_mm": "Tip radius of the satellite",
    "ring_tip_radius_mm": "Tip radius of the ring",
    "end_roll_satellite": "Tangent of the satellite's pressure angle at the end of the path",
}
"""Values on the way to a result, by the names of their steps, which end in the unit of the API."""

OTHERS = (
    "balance_force_N bearing_position_mm bearing_speed_rpm bolt_radius_mm "
    "counterweight_position_mm deflection_mm fatigue_life_h fatigue_safety_factor fit_exponent "
    "fit_scale full_turn_deg half_turn_deg half_turns life_h limit_MPa mean_MPa pins pitches "
    "polar_angle_deg rating_share repeats safety_hole safety_pin satellite_position_mm sides size "
    "static_rating_safety stiffness_N_per_mm stress_ratio torque_share turns"
)
"""Names with units of other quantities, which no field of the API has, or several with units of
their own."""
