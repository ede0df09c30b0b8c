"""A drive as the engine takes it: contacts of a piece or of many, and bodies that they move."""

from typing import Any, NamedTuple

import numpy as np

from core.arrays import BoolArray, FloatArray, IntArray
from core.drive import engine
from core.drive.engine import Drive, Work

FLOATS = engine.RATIO + 1, engine.WIDER + 1
"""Floats of a group and of a contact."""


class Contacts(NamedTuple):
    """Contacts of one kind of all discs, of many pieces."""

    kind: int  # PIN or LOBE of the engine
    law: int  # as `core.output.loop_rows` numbers it
    exact: bool  # geometry; else first order
    gf: FloatArray  # floats of the engine of each disc, shape (S, K, 16)
    cf: FloatArray  # and of each contact, shape (S, K, N, 13)

    @property
    def straddle(self) -> bool:
        """True where a pin may press both flanks of a valley: it is wider than the tool by more
        than the path is round there.
        """
        own = engine.LOBES, engine.SHORT, engine.TOOL_R
        pins, k, tool = (self.gf[..., each][..., None] for each in own)
        wide = self.cf[..., engine.GAP] * (pins * k - 1) > tool * (1 - k) ** 2
        return self.exact and bool(wide.any())


class Pieces(NamedTuple):
    """Drives that differ in their sizes alone, as `engine.Drive`."""

    gi: IntArray  # integers of the groups, shape (G, 10)
    gf: FloatArray  # floats of the groups, shape (S, G, 16)
    ci: IntArray  # integers of the contacts, shape (n, 3)
    cf: FloatArray  # floats of the contacts, shape (S, n, 13)
    table: FloatArray  # of the conformal law
    share: FloatArray  # of the torque that bodies carry
    weight: FloatArray  # squares of the lengths by which displacements count, m^2

    @property
    def sound(self) -> BoolArray:
        """Which pieces have pins, holes and cranks of a size, shape (S,)."""
        gf, cf = self.gf, self.cf
        least = np.minimum(gf[..., engine.ECC].min(axis=1), cf[..., engine.RAD].min(axis=1))
        wide = gf[..., engine.BASE_E].min(axis=1) + cf[..., engine.WIDER].min(axis=1)
        found: BoolArray = np.minimum(least, wide) > 0
        return found

    def drive(self, piece: int = 0) -> Drive:
        """One of them.

        Parameters
        ----------
        piece : int
            Which.

        Returns
        -------
        Drive
        """
        bodies = len(self.share)
        return Drive(
            gi=self.gi,
            gf=self.gf[piece],
            ci=self.ci,
            cf=self.cf[piece],
            table=self.table,
            kgg=np.zeros((bodies, bodies)),
            kbb=np.zeros((0, 0)),
            kbg=np.zeros((0, 0, bodies)),
            share=self.share,
            weight=self.weight,
        )


def pieces_of(
    *,
    lobes: Contacts,
    pins: Contacts | None = None,
    shares: tuple[float, ...] = (),
    table: FloatArray,
) -> Pieces:
    """Drives of a ring on its discs, alone or in series with output pins.

    Parameters
    ----------
    lobes : Contacts
        Of the discs on the ring's pins.
    pins : Contacts, optional
        Of the output pins; each disc then has a lag of its own between both.
    shares : tuple of float, optional
        Of the torque, where a ring alone shares it so: each disc turns for itself. Else all discs
        have one lag.
    table : array
        Constants of the conformal law, see `engine.over_width`.

    Returns
    -------
    Pieces
    """
    discs = lobes.gf.shape[1]
    own = [1 + j if pins else j if shares else 0 for j in range(discs)]
    kinds = [pins] if pins else []
    kinds += [lobes, lobes._replace(kind=engine.FLANK)] if lobes.straddle else [lobes]
    gi: list[list[int]] = []
    count = 0
    for each in kinds:
        turn = 0 if each.kind == engine.PIN else -1
        of = len(gi) - discs if each.kind == engine.FLANK else -1
        for j in range(discs):
            stop = count + each.cf.shape[2]
            fixed = [each.kind, each.law, count, stop, turn, own[j], -1, -1, int(each.exact)]
            gi.append([*fixed, of + j if of >= 0 else -1])
            count = stop
    ci = np.full((count, 3), -1)
    for row in gi:
        if row[engine.KIND] == engine.FLANK:
            first = gi[row[engine.OF]]
            there = np.arange(first[engine.START], first[engine.STOP])
            ci[row[engine.START] : row[engine.STOP], engine.FIRST] = there
    share = np.array([1.0] + [0.0] * discs if pins else shares or [1.0], float)
    radius = np.full(len(share), lobes.gf[0, 0, engine.CIRCLE])
    radius[0] = kinds[0].gf[0, 0, engine.CIRCLE]
    cf = [each.cf.reshape(len(each.cf), -1, FLOATS[1]) for each in kinds]
    return Pieces(
        gi=np.array(gi, np.int64),
        gf=np.ascontiguousarray(np.concatenate([each.gf for each in kinds], axis=1)),
        ci=ci,
        cf=np.ascontiguousarray(np.concatenate(cf, axis=1)),
        table=table,
        share=share,
        weight=radius**2,
    )


def work_for(drive: Drive) -> Work:
    """Room for a position of a drive.

    Parameters
    ----------
    drive : Drive
        The drive.

    Returns
    -------
    Work
    """
    bodies, contacts, groups = len(drive.share), len(drive.ci), len(drive.gi)
    blocks, nb = drive.kbg.shape[:2]
    shapes: dict[str, Any] = {
        "q": bodies,
        "b": (blocks, nb),
        "w": (contacts, engine.UY + 1),
        "grad": (contacts, 6),
        "side": 6,
        "hgg": (bodies, bodies),
        "hbb": (blocks, nb, nb),
        "hbg": (blocks, nb, bodies),
        "rg": bodies,
        "rb": (blocks, nb),
        "sol": (blocks, nb, bodies + 1),
        "red": (bodies, bodies),
        "p": (bodies, 1),
        "pb": (blocks, nb),
        "kept": bodies,
        "sides": (2, bodies),
        "play": (bodies, 2),
        "wrench": (groups, 3),
    }
    return Work(**{name: np.zeros(shape) for name, shape in shapes.items()})
