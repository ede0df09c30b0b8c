"""Exact answers for the precessional gear, found another way in mpmath.

Nothing here is shared with ``core``. Lengths come from Carlson's symmetric integrals between 0
and each end; loads from quadrature of the paper's own integrals over phi, with the printed
rotation to the wheel's frame. The doubles that a caller gives are taken as exact numbers.
"""

from collections.abc import Callable, Sequence

from flint import acb, arb, ctx
from mpmath import mp, mpf
from mpmath.calculus.quadrature import GaussLegendre

from tests.oracles.balls import from_ball, to_ball


def scale(circle: float, theta: float, u12: float) -> mpf:
    """A = R_C*(cos(theta) - u12)/sin(theta)."""
    return mpf(circle) * (mp.cos(mpf(theta)) - mpf(u12)) / mp.sin(mpf(theta))


def length_from_steepest(y: mpf, width: mpf, radius: mpf) -> mpf:
    """Length from y = 0: integral of sqrt(Q)/(t^2 + w^2), Q = (t^2 + w^2)^2 + (rho*w)^2.

    sqrt(Q)/(t^2 + w^2) = (t^2 + w^2)/sqrt(Q) + (rho*w)^2/((t^2 + w^2)*sqrt(Q)); with x = 1/t^2
    each term is one of Carlson's integrals from x = 1/y^2 to infinity. They cancel where y is
    large or small against w, hence the digits to spare.
    """
    if y == 0:
        return mpf(0)
    if y < 0:
        return -length_from_steepest(-y, width, radius)
    before, ctx.prec = ctx.prec, 400
    w, rho = to_ball(width), to_ball(radius)
    a = acb(w**2, rho * w)
    size = abs(a)
    x, first, second, pole = acb(1 / to_ball(y) ** 2), 1 / a, 1 / a.conjugate(), 1 / w**2
    f = acb.elliptic_rf(x, x + first, x + second) / size
    d = acb.elliptic_rj(x + first, x + second, x, x) / (3 * size)
    j = acb.elliptic_rj(x, x + first, x + second, x + pole) / (3 * size)
    total = (d + w**2 * f + rho**2 * (f - j * pole)).real
    ctx.prec = before
    return from_ball(total)


def length_by_z(curve_scale: mpf, phi_1: float, radius: float, z_min: mpf, z_max: mpf) -> mpf:
    """Length between two z."""
    offset = curve_scale * mp.cos(mpf(phi_1))
    width = abs(curve_scale * mp.sin(mpf(phi_1)))
    ends = [length_from_steepest(mpf(z) + offset, width, mpf(radius)) for z in (z_max, z_min)]
    return ends[0] - ends[1]


def z_of_angle(curve_scale: mpf, phi_1: float, phi: float) -> mpf:
    """Paper eq. (1)."""
    return -curve_scale * mp.sin(mpf(phi)) / mp.sin(mpf(phi) + mpf(phi_1))


def length_by_angle(
    curve_scale: mpf, phi_1: float, radius: float, phi_min: float, phi_max: float
) -> mpf:
    """Length between two polar angles on one branch."""
    ends = sorted(z_of_angle(curve_scale, phi_1, phi) for phi in (phi_min, phi_max))
    return length_by_z(curve_scale, phi_1, radius, *ends)


def load_integrals(
    curve_scale: mpf,
    circle: float,
    radius: float,
    phi_1: float,
    z_min: float,
    z_max: float,
    reference_z: float,
) -> tuple[mpf, mpf, mpf, mpf, mpf]:
    """Paper's integrals (12), (13), (15)-(17) of one roller without M1/sum(s), over z.

    With the outward normal (erratum of (10)) turned by (20), the place of (21), and the slope of
    (5) inverted; panels halved towards the steep part and towards z = 0.
    """
    rho, rc, a, reference = (to_ball(x) for x in (radius, circle, curve_scale, reference_z))
    sine, cosine = to_ball(mpf(phi_1)).sin_cos()
    width, offset = a * sine, a * cosine

    def integrand(z: arb) -> list[arb]:
        phi = arb.atan2(-z * sine, a + z * cosine)
        slope = rho * width / ((z + offset) ** 2 + width**2)
        sin_phi, cos_phi = phi.sin_cos()
        n1 = (sin_phi, -cos_phi)
        r1 = (rho * sin_phi, rc - rho * cos_phi)
        nx, ny = n1[0] * cosine - n1[1] * sine, n1[0] * sine + n1[1] * cosine
        rx, ry = r1[0] * cosine - r1[1] * sine, r1[0] * sine + r1[1] * cosine
        arm = rx * ny - ry * nx
        ds = (1 + slope**2).sqrt() / arm
        z_arm = z - reference
        return [nx * ds, ny * ds, -ny * z_arm * ds, nx * z_arm * ds, arm * ds]

    totals = [arb(0)] * 5
    steepest = -curve_scale * mp.cos(mpf(phi_1))
    height = abs(curve_scale * mp.sin(mpf(phi_1)))
    for left, right in _graded(mpf(z_min), mpf(z_max), steepest, height):
        totals = [t + p for t, p in zip(totals, _gauss(integrand, left, right), strict=True)]
    return tuple(from_ball(total) for total in totals)


def _graded(start: mpf, end: mpf, steepest: mpf, width: mpf) -> list[tuple[mpf, mpf]]:
    """Panels no longer than half their distance to either of the two difficult places."""
    done, waiting = [], [(start, end)]
    while waiting:
        a, b = waiting.pop()
        near = min(abs(a), abs(b))
        steep = mpf(0) if a < steepest < b else min(abs(a - steepest), abs(b - steepest))
        if b - a <= near and b - a <= max(steep, width) * mpf("0.75"):
            done.append((a, b))
        else:
            waiting += [(a, (a + b) / 2), ((a + b) / 2, b)]
    return done


_RULE = [(to_ball(x), to_ball(w)) for x, w in GaussLegendre(mp).calc_nodes(4, mp.prec + 20)]
"""Nodes and weights of the 24-point rule on [-1, 1]."""


def _gauss(function: Callable[[arb], Sequence[arb]], left: mpf, right: mpf) -> list[arb]:
    middle, half = to_ball((left + right) / 2), to_ball((right - left) / 2)
    totals = [arb(0)] * 5
    for x, w in _RULE:
        values = function(middle + half * x)
        totals = [t + w * half * value for t, value in zip(totals, values, strict=True)]
    return totals
