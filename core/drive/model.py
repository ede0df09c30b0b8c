"""Drive as the engine takes it: contacts of one piece or of many, and the bodies that they move."""

import itertools
from typing import Any, NamedTuple

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray
from core.drive import engine
from core.drive.engine import Drive, Work

FLOATS = engine.RATIO + 1, engine.WIDER + 1
"""Numbers of floats of a group and of a contact."""


class Contacts(NamedTuple):
    """Contacts of one kind, of all K discs with N contacts each, in S pieces."""

    kind: int  # JOURNAL, PIN or LOBE of the engine
    law: int  # LINEAR, POWER, HERTZ or CONFORMAL of the engine
    exact: bool  # false: geometry in first order of lag and deviations
    gf: FloatArray  # engine's floats of the group of each disc, shape (S, K, 16)
    cf: FloatArray  # engine's floats of each contact, shape (S, K, N, 13)

    @property
    def straddle(self) -> bool:
        """True if a pin may press both flanks of a valley: its radius exceeds the tool's by more
        than the valley's radius of curvature on the path.
        """
        hollow = self.gf[..., engine.HOLLOW][..., None]
        return self.exact and bool((self.cf[..., engine.GAP] * hollow > 1).any())


class Bending(NamedTuple):
    """Stiffness of pins that bend between their discs."""

    stiffness: FloatArray  # stiffness of one pin between its K places, N/m, shape (K, K)
    end: float = 0.0  # stiffness of the end of one pin, if a ring joins the ends, N/m
    to_end: FloatArray | None = None  # stiffness between an end and the places, N/m, shape (K,)


class Springs(NamedTuple):
    """Stiffness of parts besides the contacts."""

    # Radial stiffness of a disc's bearing on its crank, N/m; 0 is rigid. With one mesh only the
    # shift along the crank counts, with ring and output pins the shift across it too.
    bearing: float = 0.0
    mesh: float = 0.0  # torsional stiffness of a disc in its ring, N*m/rad; 0 is rigid
    bending: Bending | None = None  # bending of the output pins


RIGID = Springs()


class Pieces(NamedTuple):
    """Drives of S pieces that differ in their sizes only, as `engine.Drive`."""

    gi: IntArray  # integers of the groups, shape (G, 10)
    gf: FloatArray  # floats of the groups, shape (S, G, 16)
    ci: IntArray  # integers of the contacts, shape (n, 3)
    cf: FloatArray  # floats of the contacts, shape (S, n, 13)
    table: FloatArray  # constants of the conformal law, see `engine.over_width`
    kgg: FloatArray  # stiffness between bodies, shape (bodies, bodies)
    kbb: FloatArray  # stiffness of a pin that bends, shape (2*K, 2*K) or empty
    kbg: FloatArray  # stiffness between bent pins and bodies, shape (pins, 2*K, bodies)
    share: FloatArray  # share of the torque on each body
    weight: FloatArray  # weights of squared displacements: squared radius, m^2, or 1

    @property
    def sound(self) -> BoolArray:
        """True for pieces whose pins, holes and cranks have positive sizes, shape (S,)."""
        gf, cf = self.gf[:, self.gi[:, engine.KIND] > engine.JOURNAL], self.cf
        least = np.minimum(gf[..., engine.ECC].min(axis=1), cf[..., engine.RAD].min(axis=1))
        wide = gf[..., engine.BASE_E].min(axis=1) + cf[..., engine.WIDER].min(axis=1)
        found: BoolArray = np.minimum(least, wide) > 0
        return found

    def drive(self, piece: int = 0) -> Drive:
        """Drive of one piece."""
        fields = self._asdict()
        fields |= {"gf": self.gf[piece], "cf": self.cf[piece]}
        return Drive(**{name: fields[name] for name in Drive._fields})


def pieces_of(
    *,
    lobes: Contacts | None = None,
    pins: Contacts | None = None,
    shares: tuple[float, ...] = (),
    springs: Springs = RIGID,
    journals: Contacts | None = None,
    table: FloatArray,
) -> Pieces:
    """Drives of discs on output pins, of a ring on its discs, or of both in series.

    With both kinds of pins each disc has a lag of its own between them. ``shares`` of the torque in
    one mesh let each disc turn for itself; by default all discs have one lag.

    Parameters
    ----------
    lobes, pins : Contacts, optional, of ring pins and of output pins
    shares : tuple of float
    springs : Springs
    journals : Contacts, optional, of cranks in discs that float between lobes and pins
    table : array, constants of the conformal law, see `engine.over_width`
    """
    kinds = [each for each in (pins, journals, lobes) if each]
    discs = kinds[0].gf.shape[1]
    if lobes and lobes.straddle:
        kinds.append(lobes._replace(kind=engine.FLANK))
    count = discs if shares else 1
    numbers = itertools.count(count)

    def bodies_if(moving: object) -> list[int]:
        """Numbers of further bodies, one for each disc; -1 if the discs do not move so."""
        return [next(numbers) if moving else -1 for _ in range(discs)]

    none, turn = bodies_if(False), [j if shares else 0 for j in range(discs)]
    own = bodies_if(lobes or springs.mesh) if pins else turn
    turned = max(count, own[-1] + 1)  # first body that moves straight
    along = bodies_if(springs.bearing or journals)
    across = bodies_if(along[0] >= 0 and lobes and pins)
    ring = next(numbers)
    bodies = ring + 3 * bool(springs.bending and springs.bending.end)
    gi: list[list[int]] = []
    contacts = 0
    for each in kinds:
        turns = turn if each.kind == engine.PIN else none
        owns = own if each.kind != engine.JOURNAL else none
        for j in range(discs):
            stop = contacts + each.cf.shape[2]
            moves = [turns[j], owns[j], along[j], across[j]]
            first = len(gi) - discs if each.kind == engine.FLANK else -1
            gi.append([each.kind, each.law, contacts, stop, *moves, int(each.exact), first])
            contacts = stop
    radius = np.ones(bodies)
    radius[:turned] = kinds[-1].gf[0, 0, engine.CIRCLE]
    radius[:count] = kinds[0].gf[0, 0, engine.CIRCLE]
    kgg = np.zeros((bodies, bodies))
    if springs.mesh and not lobes:
        kgg[own, own] = springs.mesh
    if not journals:
        kgg[range(turned, ring), range(turned, ring)] = springs.bearing
    share = np.zeros(bodies)
    share[:count] = shares or 1.0
    kgg, kbb, kbg = bent_springs(bending=springs.bending, pins=pins, kgg=kgg, ring=ring)
    cf = [each.cf.reshape(len(each.cf), -1, FLOATS[1]) for each in kinds]
    return Pieces(
        gi=np.array(gi, np.int64),
        gf=np.ascontiguousarray(np.concatenate([each.gf for each in kinds], axis=1)),
        ci=links(gi=gi, contacts=contacts, blocks=len(kbg)),
        cf=np.ascontiguousarray(np.concatenate(cf, axis=1)),
        table=table,
        kgg=kgg,
        kbb=kbb,
        kbg=kbg,
        share=share,
        weight=radius**2,
    )


def links(*, gi: list[list[int]], contacts: int, blocks: int) -> IntArray:
    """Engine's integers of the contacts, shape (n, 3): block and plane of a bent pin, contact of
    the first foot of a second one.

    Parameters
    ----------
    gi : list of list of int, integers of the groups
    contacts, blocks : int, numbers of contacts, and of pins that bend
    """
    ci = np.full((contacts, engine.FIRST + 1), -1)
    for j, row in enumerate(gi):
        own = slice(row[engine.START], row[engine.STOP])
        if row[engine.KIND] == engine.FLANK:
            first = gi[row[engine.OF]]
            ci[own, engine.FIRST] = np.arange(first[engine.START], first[engine.STOP])
        if row[engine.KIND] == engine.PIN and blocks:
            ci[own, engine.BLOCK], ci[own, engine.PLANE] = np.arange(blocks), j
    return ci


def bent_springs(
    *, bending: Bending | None, pins: Contacts | None, kgg: FloatArray, ring: int
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Stiffness matrices kgg, kbb and kbg of `Pieces`, with the bending of the output pins.

    Parameters
    ----------
    bending : Bending, optional
    pins : Contacts, optional
    kgg : array, shape (bodies, bodies), stiffness without bending
    ring : int, index of the displacements of a tie ring: two of its middle, one along the circle
    """
    if bending is None or pins is None:
        return kgg, np.zeros((0, 0)), np.zeros((0, 0, len(kgg)))
    count, kbb = pins.cf.shape[2], np.asarray(np.kron(bending.stiffness, np.eye(2)), float)
    kbg = np.zeros((count, len(kbb), len(kgg)))
    if bending.to_end is not None:
        kgg = kgg.copy()
        for i in range(count):
            c, s = pins.cf[0, 0, i, [engine.CB, engine.SB]]
            # Shift of the end in the directions of its pin, outward and as the output turns.
            moves = np.array([[-s, c, 0.0], [-c, -s, 1.0]])
            kbg[i, :, ring:] = np.kron(bending.to_end[:, None], moves)
            kgg[ring:, ring:] += bending.end * moves.T @ moves
    return kgg, kbb, kbg


def work_for(drive: Drive) -> Work:
    """Empty arrays for one position of a drive."""
    bodies, contacts, groups = len(drive.share), len(drive.ci), len(drive.gi)
    blocks, nb = drive.kbg.shape[:2]
    shapes: dict[str, Any] = {
        "q": bodies,
        "b": (blocks, nb),
        "w": (contacts, engine.END + 1),
        "grad": (contacts, 6),
        "side": 6,
        "hgg": (bodies, bodies),
        "hbb": (blocks, nb, nb),
        "low": (blocks, nb, nb),
        "used": blocks,
        "hbg": (blocks, nb, bodies),
        "rg": bodies,
        "rb": (blocks, nb),
        "sol": (blocks, bodies + 1, nb),
        "red": (bodies, bodies),
        "p": bodies,
        "pb": (blocks, nb),
        "kept": bodies,
        "first": bodies,
        "bends": (blocks, nb),
        "last": (blocks, nb),
        "older": (blocks, nb),
        "sides": (2, bodies),
        "play": (bodies, 2),
        "wrench": (groups, 3),
    }
    return Work(**{name: np.zeros(shape) for name, shape in shapes.items()})
