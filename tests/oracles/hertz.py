"""Line contact and conformal contact, from their equations."""

from mpmath import mp, mpf


def axis_shear(z: mpf) -> mpf:
    """Principal shear below the middle of a Hertz line contact over p0, depth z over a.

    Johnson, Contact Mechanics, eq. (4.46): sx = -p0*((1 + 2z^2)/sqrt(1 + z^2) - 2z),
    sz = -p0/sqrt(1 + z^2).
    """
    root = mp.sqrt(1 + z * z)
    return ((1 / root) - ((1 + 2 * z * z) / root - 2 * z)) / 2


def exact_tangent(load_parameter: float) -> mpf:
    """Root b of Persson's equation by bisection in mpmath."""

    def excess(b: mpf) -> mpf:
        y = b * b
        return (2 - mp.log(y + 1) - 2 * y * y) - mpf(load_parameter) * mp.pi * y * (y + 1)

    low, high = mpf(0), mpf(1)
    while high - low > mpf(10) ** -38 * high:
        middle = (low + high) / 2
        if excess(middle) > 0:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def exact_mean(b: mpf) -> mpf:
    """Mean pressure over the whole rim, p_0*R/Q, of identical materials."""
    y = b * b
    return (mp.log(1 + y) + 2 * y * y) / (2 * mp.pi * y * (1 + y))


def exact_pressure(y: mpf, b: mpf) -> mpf:
    """p*R/Q at y = tan(angle/2), Ciavarella and Decuzzi 2001 for identical materials."""
    inner, outer = mp.sqrt(b * b - y * y), mp.sqrt(b * b + 1)
    return 2 * inner / (mp.pi * outer * (1 + y * y)) + mp.log((outer + inner) / (outer - inner)) / (
        2 * mp.pi * b * b * (1 + b * b)
    )
