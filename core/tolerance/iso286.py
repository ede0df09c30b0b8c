"""Limits of the ISO 286 classes that pins and holes are made to."""

import re
from bisect import bisect_left
from dataclasses import dataclass

from core.arrays import check_positive
from core.errors import InvalidInput

SIZES = (3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500)
"""Upper ends of the ranges of nominal sizes, mm; each range includes its upper end only."""

GRADES = {
    5: (4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27),
    6: (6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40),
    7: (10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63),
    8: (14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97),
    9: (25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155),
    10: (40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250),
    11: (60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400),
}
"""Tolerances IT5 to IT11 for each range of `SIZES`, micrometres."""

NEAREST = {
    "f": (-6, -10, -13, -16, -20, -25, -30, -36, -43, -50, -56, -62, -68),
    "g": (-2, -4, -5, -6, -7, -9, -10, -12, -14, -15, -17, -18, -20),
    "h": (0,) * 13,
    "m": (2, 4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21, 23),
}
"""Fundamental deviations of shafts, micrometres: upper deviations, for m lower ones."""

CLASSES = ("f", "g", "h", "js", "m", "F", "G", "H", "JS")


@dataclass(frozen=True, slots=True)
class Limits:
    """Limit deviations of a size."""

    lower: float  # lower limit deviation of the diameter, m
    upper: float  # upper limit deviation of the diameter, m


def fit_clearance(*, fit: str, hole_diameter: float, pin_diameter: float) -> float:
    """Mean radial clearance of a fit of two nominal diameters, m; negative is interference.

    The clearance is half of the difference of the middles of both tolerances. Diameters are in m,
    at most 0.5; a fit is, for example, ``H7/f7``.

    Hole of 20 mm with 0 to 21 micrometres, pin of 16 mm with -34 to -16 micrometres.

    >>> round(fit_clearance(fit="H7/f7", hole_diameter=0.020, pin_diameter=0.016) * 1e6, 6)
    17.75
    """
    letters = re.fullmatch(r"([A-Z]+\d+)/([a-z]+\d+)", fit)
    if letters is None:
        raise InvalidInput("fit", fit, "no_fit")
    hole = class_limits(size=hole_diameter, tolerance_class=letters[1])
    pin = class_limits(size=pin_diameter, tolerance_class=letters[2])
    return (hole.lower + hole.upper - pin.lower - pin.upper) / 4


def class_limits(*, size: float, tolerance_class: str) -> Limits:
    """Limit deviations of a diameter by its ISO 286 class; js and JS are halves, not rounded.

    ISO 286-1:2010, tables 1 to 5; f and g up to 3 mm and m above 180 mm follow the formulas of ISO
    286-1:1988, A.3. The size is in m, at most 0.5. A class, such as ``m6`` or ``H7``, has letters
    of `CLASSES` and a grade of `GRADES`.

    >>> class_limits(size=0.010, tolerance_class="m6")
    Limits(lower=6e-06, upper=1.5e-05)
    """
    check_positive(size=size)
    if not size <= 0.5:
        raise InvalidInput("size", size, "less_than_equal", limit=0.5)
    found = re.fullmatch(r"([A-Za-z]+)(\d+)", tolerance_class)
    letter, grade = (found[1], int(found[2])) if found else ("", 0)
    if letter not in CLASSES or grade not in GRADES:
        raise InvalidInput("tolerance_class", tolerance_class, "no_class")
    row = bisect_left(SIZES, round(size * 1e3, 9))
    width = GRADES[grade][row]
    match letter:
        case "js" | "JS":
            lower, upper = -width / 2, width / 2
        case "m":
            lower, upper = NEAREST["m"][row], NEAREST["m"][row] + width
        case "f" | "g" | "h":
            lower, upper = NEAREST[letter][row] - width, NEAREST[letter][row]
        case _:
            lower, upper = -NEAREST[letter.lower()][row], width - NEAREST[letter.lower()][row]
    return Limits(lower / 1e6, upper / 1e6)
