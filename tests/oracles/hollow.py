"""A bored pin by other ways: its wall as a frame, its shear by Saint-Venant, its section by scan.

Nothing is shared with ``core``.
"""

import math

import numpy as np


def frame_ring(*, radius: float, rigidity: float, elements: int) -> tuple[float, float, float]:
    """A ring of straight beams under a unit force, held by the shear flow ``sin(a)/(pi*R)``.

    Moment under the force and opposite to it, and twice the energy: what gives under the force.
    The ring is symmetric about the force: half of it, its ends guided.
    """
    nodes = elements // 2 + 1
    angle = np.linspace(0.0, math.pi, nodes)
    place = radius * np.array([np.sin(angle), np.cos(angle)]).T
    stiff = 1e8 * rigidity / radius**2  # hardly longer or shorter
    size, load = 3 * nodes, np.zeros(3 * nodes)
    matrix = np.zeros((size, size))
    for i in range(nodes - 1):
        (dx, dy), own = place[i + 1] - place[i], slice(3 * i, 3 * i + 6)
        length = math.hypot(dx, dy)
        c, s = dx / length, dy / length
        turn = np.kron(np.eye(2), np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]))
        a, b = stiff / length, rigidity / length**3
        bent = b * np.array([[12, 6 * length], [6 * length, 4 * length**2]])
        far = b * np.array([[-12, 6 * length], [-6 * length, 2 * length**2]])
        end = b * np.array([[12, -6 * length], [-6 * length, 4 * length**2]])
        local = np.zeros((6, 6))
        local[0, 0] = local[3, 3] = a
        local[0, 3] = local[3, 0] = -a
        local[1:3, 1:3], local[4:6, 4:6], local[1:3, 4:6], local[4:6, 1:3] = bent, end, far, far.T
        matrix[own, own] += turn.T @ local @ turn
        # shear flow along the beam, upwards: it holds the force that presses down
        middle = (angle[i] + angle[i + 1]) / 2
        flow = math.sin(middle) / (math.pi * radius) * length
        load[own] += np.tile([-flow * c / 2, -flow * s / 2, 0.0], 2)
    load[1] -= 0.5  # half of the force
    load[1::3] -= load[1::3].sum() / nodes  # what rounding of the polygon leaves
    free = [k for k in range(size) if k not in {0, 2, size - 3, size - 1, size - 2}]
    moved = np.zeros(size)
    moved[free] = np.linalg.solve(matrix[np.ix_(free, free)], load[free])
    inside = matrix @ moved - load
    return float(inside[2]), float(inside[size - 1]), 2 * float(load @ moved)


def cowper(*, bore: float, poissons_ratio: float, points: int = 64) -> float:
    """Cowper's coefficient of a tube of outer radius 1, by the flexure function, in quadrature.

    The function is harmonic; its slope across both edges is given, and its waves are found from
    those of the edges.
    """
    v, inner = poissons_ratio, bore
    angle = 2 * math.pi * np.arange(points) / points
    waves = {1: (1, -1), 3: (3, -3)}

    def slope(radius: float) -> np.ndarray:
        x, y = radius * np.cos(angle), radius * np.sin(angle)
        n_x, n_y = np.cos(angle), np.sin(angle)
        return -((v * x * x / 2 + (1 - v / 2) * y * y) * n_x + (2 + v) * x * y * n_y)

    parts = {}
    for order, powers in waves.items():
        given = [2 * np.mean(slope(r) * np.cos(order * angle)) for r in (1.0, inner)]
        rows = [[p * r ** (p - 1) for p in powers] for r in (1.0, inner)]
        parts[order] = np.linalg.solve(rows, given)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    radii = (1 + inner) / 2 + (1 - inner) / 2 * nodes
    summed = 0.0
    for radius, weight in zip(radii, weights * (1 - inner) / 2, strict=True):
        x, y = radius * np.cos(angle), radius * np.sin(angle)
        chi = sum(
            amount * radius**power * np.cos(order * angle)
            for order, powers in waves.items()
            for amount, power in zip(parts[order], powers, strict=True)
        )
        summed += weight * 2 * math.pi * radius * float(np.mean(x * (chi + x * y * y)))
    area, inertia = math.pi * (1 - inner**2), math.pi * (1 - inner**4) / 4
    return -2 * (1 + v) * inertia / (area / inertia * summed)


def scanned(*, diameter: float, bore: float, moment: float, shear: float) -> float:
    """Largest equivalent stress of a section over its height, by Jourawski's shear stress."""
    outer, inner = diameter / 2, bore / 2
    y = np.linspace(0.0, outer, 20_001)[:-1]
    inertia = math.pi * (outer**4 - inner**4) / 4
    cut = np.maximum(inner**2 - y * y, 0.0)
    width = 2 * (np.sqrt(outer**2 - y * y) - np.sqrt(cut))
    static = 2 / 3 * ((outer**2 - y * y) ** 1.5 - cut**1.5)
    sheared = shear * static / (inertia * width)
    found = np.sqrt((moment * y / inertia) ** 2 + 3 * sheared**2)
    return max(float(found.max()), moment * outer / inertia)
