"""Checks that calculations without a verdict report as warnings, and the one that refuses."""

from core.codes.code import check

CHECKS = {
    "clearance": check(
        "The hole is larger than pin and eccentricity need, {limit:.9g} mm: no pair touches until "
        "the output has turned through the lost motion, and the load sharing differs.",
        title="Clearance of pin and hole",
        tests="The hole is no larger than pin radius and eccentricity together.",
        why="No pair touches until the output has turned through the lost motion, and fewer pairs "
        "share the load than calculated.",
        mend="Make the hole radius the sum of pin radius and eccentricity, or keep the clearance "
        "small against the elastic approach.",
    ),
    "dead_centre": check(
        "The mechanism cannot transmit torque (RV drives, whose output two or three crankshafts "
        "turn, are not calculated): no pair drives"
    ),
    "interference": check(
        "The hole is smaller than pin radius + eccentricity, {limit:.9g} mm: pin and satellite "
        "interfere and cannot be assembled.",
        title="Hole too small",
        tests="The hole is at least as large as pin radius and eccentricity together.",
        why="Pin and satellite cut into each other: the mechanism cannot be assembled.",
        mend="Enlarge the hole, or take a smaller pin or eccentricity.",
    ),
    "pins_apart": check(
        "Neighbouring pins overlap: there is no room for them on their circle.",
        title="Pins overlap",
        tests="Neighbouring pins keep apart on their circle.",
        why="Two pins cannot stand in one place.",
        mend="Enlarge the pin circle, or take fewer or thinner pins.",
    ),
    "wall_holes": check(
        "Neighbouring holes of a satellite overlap: there is no material between them.",
        title="Holes overlap",
        tests="There is material left between neighbouring holes of a satellite.",
        why="Overlapping holes leave no wall to carry the force.",
        mend="Enlarge the pin circle, or take fewer pins or smaller holes.",
    ),
}
