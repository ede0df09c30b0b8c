"""Peaks of the linear law of load sharing, v = 1, compiled.

With t = tan(pressure angle of the best placed pair) the cosine of a pair whose phase against that
one is d, over the best one's, is ``u = cos(d) - t*sin(d)``, and the force ratio is
``f = sqrt(1 + t^2)/sum(u^2)``.
"""

import math
from typing import Any

import numpy as np

from core.designs.compiled.compiling import part
from core.designs.compiled.segments import driving, enter, join, position, remainder
from core.designs.room import TURN, ComplexArray, Records
from core.results import ROUNDING


@part
def even_peak(pins: int, phases: Records) -> tuple[float, float, float, int]:
    """Ratio, first place, error and looks of the peak for v = 1 and an even number of pins."""
    first = np.inf
    for k in range(len(phases)):
        first = min(first, position(pins, 0.75 - phases[k].sector))
    return 4 / (len(phases) * pins), first, ROUNDING, 1


@part
def _sums(
    pins: int, best: int, phases: Records, relative: ComplexArray, roots: ComplexArray
) -> tuple[float, float, float]:
    """Number of the driving pairs of a segment, sums of sin(d)^2 and sin(d)*cos(d) over them.

    Of c = (N - 1)/2 or (N + 1)/2 neighbouring pins the cosines of 2*d sum up to
    sin(2*pi*c/N)/sin(2*pi/N) = (N - 2*c)/2/cos(pi/N) times that of their middle.
    """
    number = squares = products = 0.0
    spread = -0.25 / roots[pins // 2].real  # cos(pi - pi/N)
    for k in range(len(phases)):
        first, last = driving(pins, phases[k].nearest)
        turned = remainder(2 * (phases[best].step - phases[k].step) + first + last, pins)
        middle = relative[best, k] * relative[best, k] * roots[int(turned)]
        weight = spread * (pins - 2 * (last - first + 1))
        number += last - first + 1
        squares -= weight * middle.real
        products += weight * middle.imag
    return number, number / 2 + squares, products


@part
def _linear_force(tangent: float, number: float, squares: float, products: float) -> float:
    total = number - squares + tangent * (tangent * squares - 2 * products)
    return math.sqrt(1 + tangent * tangent) / total


@part
def _cubic(tangent: float, number: float, squares: float, products: float) -> float:
    """``P*t^3 + (3*P - n)*t - 2*Q``, which falls and rises as -f does."""
    return tangent * (squares * (tangent * tangent + 3) - number) - 2 * products


@part
def linear_candidates(
    pins: int,
    count: int,
    phases: Records,
    relative: ComplexArray,
    roots: ComplexArray,
    segments: Records,
    candidates: Records,
) -> int:
    """Number of the candidates for v = 1: starts of segments, roots of the cubic inside."""
    for index in range(count):
        best = enter(pins, index, count, phases, segments)
        segment = segments[index]
        number, squares, products = _sums(pins, best, phases, relative, roots)
        segment.number, segment.squares, segment.products = number, squares, products
        candidates[index].force = _linear_force(segment.left, number, squares, products)
        candidates[index].tangent = segment.left
        candidates[index].segment = index
    join(count, segments)
    used = count
    for index in range(count):
        left, right = segments[index].left, segments[index].right
        number, squares = segments[index].number, segments[index].squares
        products = segments[index].products
        if number > 3 * squares * (1 + max(left * left, right * right)):
            continue  # the cubic only falls
        turning = math.sqrt(max(number / (3 * squares) - 1, 0.0))
        for side in range(2):
            start = left if side else max(left, turning)
            stop = min(right, -turning) if side else right
            below = _cubic(start, number, squares, products)
            above = _cubic(stop, number, squares, products)
            if start < stop and below <= 0 <= above:
                root = _root_of_cubic(start, stop, below, above, number, squares, products)
                candidates[used].force = _linear_force(root, number, squares, products)
                candidates[used].tangent = root
                candidates[used].segment = index
                used += 1
    return used


@part
def _root_of_cubic(
    left: float,
    right: float,
    below: float,
    above: float,
    number: float,
    squares: float,
    products: float,
) -> float:
    """Root between two places where the cubic rises: a secant, then Newton's method."""
    root = left + below / (below - above) * (right - left) if below < above else left
    for _ in range(60):
        slope = 3 * squares * (root * root + 1) - number
        step = _cubic(root, number, squares, products) / slope if slope > 0 else 0.0
        root = min(max(root - step, left), right)
        if abs(step) < 1e-6:  # each step squares the error
            break
    return root


@part
def linear_error(candidate: Any, segments: Records, phase_error: float) -> float:
    """Relative error of a force for v = 1, from that of the phases in turns."""
    segment = segments[candidate.segment]
    steep = abs(candidate.tangent)
    stretch = 1 + steep * steep
    total = math.sqrt(stretch) / candidate.force
    # sum |sin*cos| <= sqrt(sum sin^2 * sum cos^2), all over cos^2 of the best placed pair
    slope = steep + 2 * math.sqrt(max(segment.number * stretch / total - 1, 0.0))
    terms = segment.number + steep * (2 * abs(segment.products) + steep * segment.squares)
    error: float = ROUNDING * (4 + 8 * terms / total) + TURN * phase_error * slope
    return error
