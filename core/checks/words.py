"""English words of checks by code: groups, sources of formulas, subjects that a verdict leaves out.

Title and reason of a single check are stated in its own record.
"""

from core.checks.crank_planetary import PARTS

GROUPS = {
    "mechanism": "Mechanism",
    "contact": "Contact of pin and hole",
    "geometry": "Pins and holes",
    "play": "Play of the output",
    "pin": "Strength of the pins",
    "pin_rollers": "Rollers on the pins",
    "plastic": "Plastic of pins and holes",
    "friction": "Friction and wear",
    "gear": "Ring",
    "bearing": "Bearings of the satellites",
    "crankshaft": "Crankshaft",
    "body": "Satellite",
    "build": "Housing and carrier",
    "rollers": "Rollers",
    "lines": "Contact lines",
    "shaft": "Bending of the shaft",
    "room": "Room for rollers and shaft",
}
"""Subjects of checks, in English, by code."""

CHECK_SOURCES = {
    "archard_1953": "Archard 1953, with the wear coefficient that was given",
    "balance": "statics of rotating masses",
    "balance_guide": "guide value: G 16 of ISO 21940-11, crankshaft drives that are balanced in "
    "themselves and stand rigidly; nobody asked for it",
    "beam": "beam theory (Mohr)",
    "geometry": "geometry",
    "guide": "guide value: walls of 0.03 of the ring's pin circle diameter (Wang, Luo, Su 2016), "
    "1.2 tooth heights below involute roots, sleeves of 0.1 of their pin, 0.1 of their diameter "
    "between the pins of a ring, bends of their path of 1.1 of their radius, of involute teeth "
    "contact ratios of 1.05, tips that pass by 0.05 of G, are 0.15 modules off the roots and 0.25 "
    "modules thick; nobody asked for it",
    "envelope": "derived: rolling elements that fill the gap, by the formulas of ISO 281 and "
    "ISO 76",
    "hertz": "Johnson, Contact Mechanics, 4.2: Hertz asks for a narrow contact",
    "iso_281_life": "ISO 281:2007, with the ratings that were given",
    "iso_76_rating": "ISO 76: the rating is the load that dents by 1e-4 of a rolling element",
    "build": "geometry; rules of thumb for the sizes of housing and carrier that are not given",
    "first_yield": "calculated: largest equivalent stress (Mises) below a sliding line contact, by "
    "McEwen's stresses in Johnson, Contact Mechanics, 4.2 and 7.1; the least strength of its "
    "sources, or the one that was given",
    "heat_deflection": "heat deflection temperature under 1.8 MPa of the material's sources, or "
    "where it softens by these",
    "involute_mesh": "geometry of the line of action; interference of the tips as in SDP/SI, "
    "Elements of Gear Technology, 5-6 and 5-7",
    "iso_6336_root": "method B of ISO 6336-3 as it is commonly printed, the force at the tip, with "
    "the strength that was given",
    "johnson_yield": "Johnson, Contact Mechanics, 4.2, 7.1 and 9.1; recomputed (Mises) for "
    "Poisson's ratio and friction: p = 1.79*Re for 0.3 and 0",
    "johnson_shakedown": "Melan's theorem, as in Johnson, Contact Mechanics, 9.2; recomputed: "
    "p = 2.31*Re (Mises) without friction; 2.06*Re for a friction of 0.1 (Johnson 1985)",
    "long_term": "the factor that was given: strength in the long run over that of a short test",
    "load_sharing": "solved over the turn with clearance, deviations and elasticity, as by "
    "load sharing",
    "no_source": "no source was found",
    "ovsyannikov_2019": "Ovsyannikov et al. 2019",
    "ovsyannikov_2019_length": "Ovsyannikov et al. 2019, before fig. 3: usually rollers are at "
    "least ten times as long as the centre distance, tilted by about 12°",
    "pin_wall": "derived: a ring bent by the force and held by the shear of the pin, as a curved "
    "beam: 1.5 to 37 % above plane elasticity",
    "pin_beam": "beam theory, the true locus of the moment; yield strength of the material",
    "ring_mesh": "solved over the turn with modification, deviations and elasticity of the teeth, "
    "as by the mesh of the ring",
    "roller_rating": "ISO 281:2007 and ISO 76, with the ratings that were given; of bearings whose "
    "outer ring nothing supports, what the two elements next to the load carry",
    "roots": "geometry; where no root radius is given: of a cycloid disc r_f = R_m − e − r_m, of "
    "involute teeth r_f = m·(z₂/2 − 1.25 + x) by the basic rack of ISO 53, with a profile shift "
    "taken as 0 ≤ x ≤ 1.25",
    "shigley": "Shigley, Mechanical Engineering Design, 6; or the endurance limit that was given",
    "slip": "catalogues of SKF: 0.01 of the dynamic rating for balls, 0.02 for rollers",
    "solid_depth": "calculated: at a depth of 3 half-widths the stress has fallen to 0.32 of the "
    "pressure, and the largest one lies at 0.75",
    "static_guide": "guide values: for running as usual 1 for balls and 1.5 for rollers, at the "
    "peak of a start 1.5, of an emergency stop 1: catalogues of SKF and IKO, after ISO 76",
    "static_pressure": "the static limit of the material, as its source has it: ISO 6336-5 or "
    "ISO 76; where none is known, what it bears for many loads it bears once",
    "steep": "derived: above 55° the ring presses the satellite along the crank far more than it "
    "turns it",
    "teeth_tried": "calculated: the largest contact ratio of all usual teeth of the rack of ISO 53 "
    "without backlash, with shifts of the satellite from −0.5 to 1 and addenda from 0.25 to 1.25 "
    "modules, whose tips pass each other by a margin and which touch on involutes only; unusual "
    "ones are tried from −1 to 2 and from 0.1 to 1.5",
    "tilt_guide": "Tribology Handbook, A22: a slope for which the formula of the life holds",
    "track_rollers": "catalogue of SKF: 0.0167 of the static rating of track rollers",
    "user": "the limit that was asked",
    "wang_2016": "Wang, Luo, Su 2016, eqs 32, 33, and the wall that was asked",
    "yanchevskiy_2021": "Yanchevskiy, Niekhoroshykh 2021",
    "yanchevsky_2018": "Yanchevsky et al. 2018, eq. 2",
}
"""Sources of the formulas of checks, in English, by code."""

NOT_CONSIDERED = {
    **{part.code: part.title for part in PARTS.values()},
    "bearing": "bearings",
    "contact_life_hole": "life of the holes under their contact pressure",
    "contact_life_pin": "life of the pins under their contact pressure",
    "crankshaft": "strength and deflection of the crankshaft",
    "deflection": "deflection of the shaft, of which no limit is asked",
    "dynamics": "vibration, shock and inertia",
    "fatigue": "fatigue",
    "friction": "friction, wear and efficiency",
    "housing": "housing and carrier",
    "ligament_strength": "strength of the walls of the satellite",
    "line_pressure": "pressure along the contact lines",
    "lubrication": "lubrication and heat",
    "output_bearing": "bearings of the output",
    "roller_contact": "contact of spheres and holes",
    "shaft_strength": "strength of the shaft",
    "slope": "slope of the shaft, of which no limit is asked",
}
"""Subjects that a verdict does not consider, in English, by code; they include unjudged parts."""
