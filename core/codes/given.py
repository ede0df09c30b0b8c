"""Warnings about unusual or missing inputs."""

from core.codes.code import limit

OF_INPUT = {
    "clearance_unknown": limit(
        "The clearance of pins and holes is not given: the numbers are those of perfect parts, "
        "which every real one misses.",
        title="Clearance not known",
        tests="The clearance of pins and holes is given.",
        why="With clearance fewer pairs carry, and more each: forces and stresses grow, often by "
        "half and more.",
        mend="Give the clearance, or a fit; 0 where perfect parts are meant.",
    ),
    "modification_unknown": limit(
        "The modification of the discs is not given: the numbers are those of perfect parts, which "
        "every real one misses.",
        title="Modification not known",
        tests="The offset of the discs' tool from the ring's pins is given.",
        why="With play and errors fewer pins carry, and more each: of usual parts up to ten times "
        "the ideal force.",
        mend="Give the modification; 0 where perfect parts are meant.",
    ),
    "one_source": limit(
        "Some values of {material} are from one source only: take them for a guide.",
        title="One source",
        tests="Two independent sources have the values of the material.",
        why="Makers and prints differ by a factor of two and more.",
        mend="Enter the values of the data sheet of what you use.",
    ),
    "outer_ring_not_supported": limit(
        "No seat holds the outer rings that roll in the holes: {dynamic:.3g} of the dynamic rating "
        "of the bearing is left, a lower bound.",
        title="Outer rings without a seat",
        tests="The ratings are those of a roller.",
        why="Ratings of bearings hold in a rigid seat; here the two rolling elements next to the "
        "load carry nearly all of it, and the ring bends.",
        mend="Give the ratings of a track roller, or the number of rolling elements.",
    ),
    "perfect_parts": limit(
        "No clearance: the numbers are those of perfect parts, which every real one misses.",
        title="Perfect parts",
        tests="Pins and holes have a clearance.",
        why="With clearance fewer pairs carry, and more each: forces and stresses grow, often by "
        "half and more.",
        mend="Give the clearance that the parts have.",
    ),
    "clearance_like_eccentricity": limit(
        "The clearance is {ratio:.3g} of the eccentricity: such mechanisms move, with very much "
        "play; clearances of working ones are near a hundredth.",
        title="Clearance like the eccentricity",
        tests="The clearance is less than half of the eccentricity.",
        why="Such mechanisms move, with very much play; mostly one of the sizes is a slip.",
        mend="Look at radii and eccentricity; make the hole smaller.",
    ),
    "diameters_as_radii": limit(
        "Are diameters given as radii? With radii of {pin:.6g} and {hole:.6g} mm the parts fit.",
        title="Diameters as radii?",
        tests="Half of the radii would not fit, or the clearance is less than 0.9 of the "
        "eccentricity.",
        why="Drawings say diameters; typed as radii they double every size.",
        mend="If they are diameters, halve both.",
    ),
    "pins_like_crankshafts": limit(
        "So few and so thick pins may be the crankshafts of an RV, which is another mechanism and "
        "is not calculated.",
        title="Crankshafts, not pins?",
        tests="There are more than three pins, or their radius is at most 0.3 of that of their "
        "circle.",
        why="Crankshafts turn in bearings in the disc and drive it; pins are driven by it.",
        mend="For an RV nothing here holds; for pins the warning may be left.",
    ),
    "eccentricity_assumed": limit(
        "The eccentricity is taken as hole less pin radius: clearance or interference would not be "
        "seen.",
        title="Eccentricity assumed",
        tests="The eccentricity is given beside pin and hole.",
        why="The eccentricity is taken as hole radius − pin radius, so that pin and hole fit: "
        "clearance or interference would not be seen.",
        mend="Enter the eccentricity of the cranks.",
    ),
    "eccentricity_doubled": limit(
        "Is the eccentricity given twice as large, as the stroke? With {eccentricity:.6g} mm the "
        "parts fit.",
        title="Eccentricity doubled?",
        tests="The hole has room for the pin with the whole eccentricity.",
        why="The stroke of a crank is twice its eccentricity.",
        mend="If it is the stroke, halve it.",
    ),
    "eccentricity_forgotten": limit(
        "Is the eccentricity left out of the hole? With a radius of {hole:.6g} mm the parts fit.",
        title="Eccentricity left out?",
        tests="The hole's radius is at least that of the pin with the eccentricity added.",
        why="The pin moves in its hole on a circle of the eccentricity: the hole is larger by it.",
        mend="Make the hole larger by the eccentricity.",
    ),
    "endurance_unknown": limit(
        "Fatigue is not checked: no endurance limit is known. The limit of a steel follows from "
        "its tensile strength; else give the limit, and the tensile strength with it.",
        title="Fatigue not checked: no limit",
        tests="The tensile strength and an endurance limit are known.",
        why="The endurance limit of a steel follows from its tensile strength, where this is "
        "known; for bronzes, irons and plastics there is no such rule.",
        mend="Give the endurance limit, and the tensile strength where it is not known.",
    ),
    "hardly_known": limit(
        "Hardly anything is known of the result: its relative error may be {error:.2g}, because "
        "rounding of the input is magnified so much.",
        title="Hardly anything is known",
        tests="The stated relative error is at most 1 %.",
        why="The numbers given are known to some 16 digits only; here a small difference of large "
        "ones decides, of which hardly a digit is left.",
        mend="Move the sizes away from where they nearly cancel: a ratio from cos θ, a limit from "
        "its neighbour, an angle from its pole.",
    ),
    "hole_diameter_as_radius": limit(
        "Is the hole's diameter given as its radius? With {hole:.6g} mm the parts fit.",
        title="Hole: diameter as radius?",
        tests="Half of the hole's radius would be too small for pin and eccentricity.",
        why="Only the hole is then twice as large.",
        mend="If it is the diameter, halve it.",
    ),
    "next_hole": limit(
        "A satellite is turned by more than half the pitch of its holes: it is put on the pins by "
        "the holes next to them.",
        title="Other holes",
        tests="Each satellite goes onto the pins by the holes that its phase says.",
        why="Turned by more than half the pitch of its holes it goes on by the next ones.",
        mend="Nothing, if it is meant so.",
    ),
    "no_ring_force": limit(
        "The ring's force along the crank is left out: with involute teeth bearings carry more, "
        "with a ring of pins less.",
        title="Ring left out",
        tests="The ring's force along the crank is known.",
        why="With involute teeth it adds to the force of the pins, with a ring of pins it opposes "
        "it: the life differs several times.",
        mend="Give the teeth, the circle of the ring's pins, or the ratio of the forces.",
    ),
    "notch_unknown": limit(
        "Fatigue is not checked: neither a notch nor its factor is given, and the edge of a press "
        "fit alone takes half of the strength and more.",
        title="Fatigue not checked: no notch factor",
        tests="A notch or its factor is given.",
        why="The edge of a press fit alone takes half of the strength and more: a part without any "
        "notch is not to be assumed.",
        mend="Give the fatigue notch factor of the seat, the notch itself, or the endurance limit.",
    ),
    "pin_diameter_as_radius": limit(
        "Is the pin's diameter given as its radius? With {pin:.6g} mm the parts fit.",
        title="Pin: diameter as radius?",
        tests="The hole has room for the pin as it is given.",
        why="Only the pin is then twice as thick.",
        mend="If it is the diameter, halve it.",
    ),
    "guide_tolerances": limit(
        "Tolerances that are not given are guides of how the parts are made: sources differ by a "
        "factor of two.",
        title="Guides of a process",
        tests="All tolerances are those of the parts; none is a guide of how such parts are made.",
        why="The sizes of a part depend on the machine, the material and the care: sources differ "
        "by a factor of two.",
        mend="Measure some parts, and enter what they come to.",
    ),
    "root_unknown": limit(
        "The root is beyond the method: its section, fillet or arm of the force is not one of a "
        "usual tooth.",
        title="Root beyond the method",
        tests="The root of the satellite's teeth is one of which a stress is known.",
        why="The stress is that of a tooth whose fillet a rack makes, within the range of its "
        "notch factor.",
        mend="Take a larger tip radius of the hob, or a usual addendum.",
    ),
    "unusual_shortening": limit(
        "The shortening coefficient of the discs is {shortening:.3g}: most drives have 0.35 to "
        "0.9.",
        title="Unusual shortening coefficient",
        tests="The shortening coefficient K1 = e·z_p/R_p lies from 0.35 to 0.9.",
        why="Below, the teeth are low and their forces large; above, flanks bend sharply and the "
        "pins press along the crank.",
        mend="Change the eccentricity, or the circle of the ring's pins.",
    ),
    "ratio_not_whole": limit(
        "The ratio {ratio:.6g} is no whole number: a cycloid disc with one lobe less than the ring "
        "has pins has as many lobes as its ratio says.",
        title="Ratio of a cycloid",
        tests="The ratio of a cycloid disc with one lobe less than the ring has pins is whole.",
        why="Such a disc has as many lobes as its ratio says.",
        mend="Give the teeth, or a whole ratio.",
    ),
    "ratio_sign": limit(
        "The ratio is taken as {ratio:.6g}: its sign says that the pins turn the other way, "
        "which those of every such mechanism do.",
        title="Sign of the ratio",
        tests="The ratio is given without a minus sign.",
        why="The pins of every such mechanism turn against the crank: the sign is known.",
        mend="Nothing, if it is meant so.",
    ),
    "load_factor_below_one": limit(
        "The factor on the load is {factor:.3g}: stresses and pressures are those of less than the "
        "load that is given.",
        title="Factor on the load below 1",
        tests="The factor on the load is at least 1.",
        why="Shocks only add to a load. A factor below 1 is right where a given spectrum of loads "
        "is equivalent to less than the load that is typed.",
        mend="Give at least 1, or the load that acts.",
    ),
    "roller_clearance_unknown": limit(
        "The clearance of the rollers on the pins is not given: the numbers are those of rollers "
        "without, which every real one misses.",
        title="Clearance of the rollers not known",
        tests="The radial clearance of the rollers is given.",
        why="Half of it adds to the clearance of pins and holes: fewer pairs carry, and more each.",
        mend="Give the radial internal clearance: track rollers of the class CN have 0.020 to "
        "0.045 mm, of C2 none to 0.025 mm.",
    ),
    "sand_cast": limit(
        "The bronze is the sand-cast CuSn12-C-GS, whose limit is not known; the centrifugally cast "
        "CuSn12-C-GZ is a material of its own.",
        title="Sand-cast bronze",
        tests="The bronze is the centrifugally cast one, whose limit is known.",
        why="The limit 425 MPa holds for the centrifugally cast bronze only; the sand-cast one "
        "carries less, how much is not known.",
        mend="Take the centrifugally cast bronze, or enter a limit of your own.",
    ),
    "nut_factor": limit(
        "The preload is taken from the tightening torque with a nut factor of 0.2 and a thread "
        "1.25 times its core: {preload:.6g} N; as it is wetted it may be a third less or more.",
        title="Preload by the tightening torque",
        tests="The preload itself is given.",
        why="Friction in thread and head takes nine tenths of the torque and is hardly known.",
        mend="Give the preload where it is known.",
    ),
    "ring_clearance_left_out": limit(
        "The tie ring is taken to be rigid and without clearance on the pins: within a clearance "
        "there it does nothing, and the pins bend as without it.",
        title="Clearance of the tie ring left out",
        tests="The tie ring is not pinned to the pins.",
        why="In a pinned joint with clearance the ring acts only beyond it, and a thin ring bends "
        "itself: the pins then carry more than is said.",
        mend="Fit the ring without clearance, or judge the pins as cantilevers too.",
    ),
    "short_pin": limit(
        "A satellite lies within half a pin diameter of the carrier: shear governs such a short "
        "pin, and its seat gives way more than it bends.",
        title="Short pin",
        tests="Each satellite is at least half a pin diameter from the carrier.",
        why="So close to its seat a pin is sheared more than bent, and the seat gives way.",
        mend="Take the bending for a rough guide and look at the equivalent stress.",
    ),
    "short_roller": limit(
        "The cylinder is shorter than its diameter: a beam that short deforms mostly by shear and "
        "at its clamping, so the stiffness is a rough guide.",
        title="Short roller",
        tests="The roller's cylinder is at least as long as its diameter.",
        why="A shorter beam deforms mostly by shear and at its clamping; its stiffness is a rough "
        "guide.",
        mend="Lengthen the roller, or check its stiffness by finite elements.",
    ),
    "short_shaft": limit(
        "The shaft is short for its diameter: shear, which the formulas leave out, adds more than "
        "5 % to its deflection.",
        title="Short shaft",
        tests="The shaft is at least 3.3 times as long as it is thick.",
        why="Shear, which the formulas leave out, then adds more than 5 % to the deflection.",
        mend="Add the deflection by shear, or take the number as a lower limit.",
    ),
    "sphere_below_roller": limit(
        "The sphere is smaller than the cylinder: the formulas take the sphere for rigid and the "
        "cylinder for the weak section.",
        title="Sphere smaller than the roller",
        tests="The sphere is at least as thick as the cylinder.",
        why="The formulas take the sphere for rigid and the cylinder for the weak section.",
        mend="Enlarge the sphere or take a thinner cylinder.",
    ),
    "sphere_too_wide": limit(
        "The sphere is wider than its diameter: no sphere is.",
        title="Sphere wider than its diameter",
        tests="The width of a sphere is at most its diameter.",
        why="No sphere is wider than its diameter: the sizes contradict each other.",
        mend="Correct the width or the diameter of the sphere.",
    ),
    "thin_without_sleeve": limit(
        "The pin is thinner than what touches the holes, and there is no sleeve on it: losses and "
        "wear are those of a bare pin as thick as the contact.",
        title="Thin pin without a sleeve",
        tests="The pin is as thick as its contact where there is no sleeve.",
        why="Without a sleeve nothing but the pin itself touches the holes: one of the two sizes "
        "is wrong, or there is a sleeve, which slides less.",
        mend="Say that there is a sleeve, or give the pin the diameter of its contact.",
    ),
    "twice_the_eccentricity": limit(
        "Is twice the eccentricity in the radius of the hole? The radius takes it once: {hole:.6g} "
        "mm; twice is meant of diameters.",
        title="Twice the eccentricity?",
        tests="The clearance is less than the eccentricity.",
        why="The diameter of a hole takes twice the eccentricity, its radius takes it once.",
        mend="If so, take the eccentricity off once.",
    ),
}
