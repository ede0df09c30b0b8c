"""What pairs of pins and discs share a torque by one lag: what the loops over pairs solve."""

import math
from array import array
from collections.abc import Iterable, Sequence
from typing import Any, TypeVar

from core.errors import ImpossibleMechanism
from core.output.loop_rows import NO_DRIVE, NOT_SOLVED, NOT_STABLE, TOO_FAR, TOO_WIDE, Position
from core.output.mechanism import Mechanism
from core.output.sharing_kernel import too_wide

REFUSALS = {
    NO_DRIVE: "dead_centre",
    NOT_STABLE: "not_stable",
    NOT_SOLVED: "not_balanced",
    TOO_WIDE: "beyond_hertz",
    TOO_FAR: "beyond_first_order",
}
"""What a position is refused as that cannot be."""


Sizes = TypeVar("Sizes")


def in_floats(setup: Sizes) -> Sizes:
    """A setup whose sizes are floats, which the loops are compiled for: a whole number would have
    them compiled once more.

    Parameters
    ----------
    setup : named tuple
        Sizes as they are given.

    Returns
    -------
    named tuple
    """
    own: Any = setup
    kinds = type(setup).__annotations__
    sizes = (name for name, kind in kinds.items() if kind is float)
    found: Sizes = own._replace(**{name: float(getattr(setup, name)) for name in sizes})
    return found


OF_SATELLITES = {"arm", "phase", "share", "own", "off", "eta", "own_lag", "own_moves", "own_error"}
"""Rows of pairs and rooms with one number for each satellite."""


def blank_rows(
    kind: Any, *, pins: int, satellites: int, shares: Sequence[float] = (), **sizes: int
) -> Any:
    """Rows of zeros as the loops take them.

    Parameters
    ----------
    kind : type
        Named tuple of rows.
    pins, satellites : int
        Numbers N and K.
    shares : sequence of float
        Of the torque, where they are given: then parts of rows are rows too.
    **sizes : int
        Lengths of rows that have neither K nor K*N numbers.

    Returns
    -------
    named tuple
    """
    own = dict.fromkeys(kind._fields, pins * satellites) | dict.fromkeys(OF_SATELLITES, satellites)
    rows = {name: [0.0] * sizes.get(name, own[name]) for name in kind._fields}
    if not shares:
        return kind(**rows)
    if "share" in rows:
        rows["share"] = [*shares]
    return kind(**{name: divisible(row) for name, row in rows.items()})


def divisible(row: Iterable[float]) -> memoryview:
    """A row of which parts are rows too.

    Parameters
    ----------
    row : iterable of float
        Its numbers.

    Returns
    -------
    memoryview
    """
    return memoryview(array("d", row))


class Stage:
    """Output pins in the holes of satellites, or a ring on the teeth of satellites."""

    mechanism: Mechanism  # pins and cranks; of a ring the wave turns with the crank
    support: Any  # what of the satellites gives, or their given shares; None where they are rigid

    @property
    def pairs(self) -> Any:
        """Constants of the pairs, as the loops take them."""
        raise NotImplementedError

    @property
    def phases(self) -> Sequence[float]:
        """Angles of the cranks with their errors, rad."""
        phases: Sequence[float] = self.pairs.phase[: self.mechanism.satellites]
        return phases

    @property
    def pins_alike(self) -> bool:
        """Whether all pins are alike, and all that they touch of a satellite."""
        raise NotImplementedError

    @property
    def dead_angles(self) -> tuple[float, ...]:
        """Angles from the crank at which a pin takes up or leaves, rad."""
        return 0.0, math.pi

    @property
    def loops(self) -> Any:
        """The functions of `core.output.sharing_kernel`, interpreted."""
        raise NotImplementedError

    @property
    def loops_of_turns(self) -> Any:
        """The same, compiled where they can be."""
        raise NotImplementedError

    def setup(self, direction: float) -> Any:
        """The design as the kernel takes it.

        Parameters
        ----------
        direction : float
            Of the torque: 1, or -1 in reverse.

        Returns
        -------
        named tuple
        """
        raise NotImplementedError

    def room(self) -> Any:
        """Room for the results of one position."""
        raise NotImplementedError

    def forces(self, room: Any) -> list[float]:
        """Forces of the pairs as a position left them, N.

        Parameters
        ----------
        room : named tuple
            Of the position.
        """
        return [*room.force]

    def wave(self, crank_angle: float) -> float:
        """Wave angle of a crank angle, rad, within half a turn around 0.

        Parameters
        ----------
        crank_angle : float
            Crank angle, rad.
        """
        return math.remainder(self.mechanism.wave_angle(crank_angle), 2 * math.pi)

    def solved(self, psi: float, torque: float, setup: Any, room: Any) -> Position:
        """Equilibrium at a wave angle; what cannot be is refused.

        Parameters
        ----------
        psi : float
            Wave angle, rad.
        torque : float
            Size of the torque, N*m, > 0.
        setup : named tuple
            The design, with the torque's direction.
        room : named tuple
            Takes forces and levers.

        Returns
        -------
        Position

        Raises
        ------
        ImpossibleMechanism
            If no pair can drive, forces would not balance or not be stable, or a contact would be
            as wide as its pin.
        """
        position: Position = self.loops.solve(psi, torque, setup, self.pairs, room)
        status = self.loops.judged(position, setup, self.pairs, room)
        if status in REFUSALS:
            params = self.beyond_law(room) if status == TOO_WIDE else {}
            place = {"crank_angle": self.crank_angle(psi)}
            raise ImpossibleMechanism(REFUSALS[status], place, **params)
        return position

    def input_torque(self, psi: float, torque: float, lag: float, setup: Any, room: Any) -> float:
        """Torque that turns the crank without friction, N*m, as `solved` left the room.

        Parameters
        ----------
        psi, torque : float
            As they were solved.
        lag : float
            As it was found, rad.
        setup, room : named tuple
            As `solved` takes them.

        Returns
        -------
        float
        """
        found: float = self.loops.input_torque(psi, torque, lag, setup, self.pairs, room)
        return found

    def crank_angle(self, psi: float) -> float:
        """First crank angle >= 0 of a wave angle, rad.

        Parameters
        ----------
        psi : float
            Wave angle, rad.
        """
        off = psi - self.mechanism.initial_crank_angle
        return off % (2 * math.pi) / self.mechanism.waves_per_turn

    def beyond_law(self, room: Any) -> dict[str, Any]:
        """The pair whose force is beyond its law: numbers of satellite and pin.

        Parameters
        ----------
        room : named tuple
            A position in which one is.
        """
        j, n = divmod(too_wide(self.pairs, room), self.mechanism.pins)
        return {"satellite": j + 1, "pin": n + 1}

    def rows(self, values: Sequence[float]) -> tuple[tuple[float, ...], ...]:
        """Values of the pairs, satellite by satellite.

        Parameters
        ----------
        values : sequence of float, K*N
            Values in the kernel's order.

        Returns
        -------
        tuple of tuple of float, K x N
        """
        pins = self.mechanism.pins
        return tuple(tuple(values[i : i + pins]) for i in range(0, len(values), pins))
