"""Satellites that give: elastic crank bearings, an elastic mesh, or given shares of the torque.

First order only. The contact normals of one disc are all parallel to its eccentricity, so what its
crank's bearing gives is taken from every approach alike; what its mesh with the ring gives turns
it back against the output. Either is one more equation for each disc, increasing like that of the
torque, so Newton's method in a bracket solves it inside the other.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

from core.arrays import check_positive
from core.errors import InvalidInput
from core.output.sharing_kernel import (
    EPS,
    NEWTON_ALONE,
    NO_DRIVE,
    NOT_SOLVED,
    SOLVED,
    STEPS,
    TINY,
    Pairs,
    Position,
    Room,
    Setup,
    at,
    balance,
    interference,
    law,
    play,
    shift,
    solve,
    start,
    touch_error,
    wave_torque,
)

SUM_ERROR = 1e-12
"""By how much the sum of the shares may be off 1: what rounding of their decimals does."""


@dataclass(frozen=True, slots=True)
class CrankSupport:
    """Bearing of each satellite on its crank.

    Attributes
    ----------
    stiffness : float
        Radial stiffness k_b of one bearing, N/m; infinite where not given.
    radial_clearance : float
        Radial internal clearance G, m: the inner ring moves by G/2 to either side of its middle.
    """

    stiffness: float = math.inf
    radial_clearance: float = 0.0


@dataclass(frozen=True, slots=True)
class ElasticMesh:
    """Mesh of each satellite with the ring, which lets the disc turn under its torque.

    Attributes
    ----------
    stiffness : float
        Torque over rotation k_D of one disc, N*m/rad.
    """

    stiffness: float


@dataclass(frozen=True, slots=True)
class Shares:
    """Torque that is shared as given, whatever the discs need to turn for it.

    Attributes
    ----------
    shares : tuple of float, K
        Share w_j of each satellite, > 0, of sum 1.
    """

    shares: tuple[float, ...]


SatelliteSupport = CrankSupport | ElasticMesh | Shares


def check_support(*, support: SatelliteSupport | None, satellites: int, exact: bool) -> None:
    """Refuse what a support cannot be.

    Parameters
    ----------
    support : SatelliteSupport or None
        How the satellites are held.
    satellites : int
        Their number K.
    exact : bool
        Whether the geometry is exact.

    Raises
    ------
    InvalidInput
        If a size is out of range, shares are not one each or do not add up to 1, or the geometry is
        exact.
    """
    if support is None:
        return
    if exact:
        raise InvalidInput("exact", exact, "first_order_only", field="support")
    if isinstance(support, Shares):
        given = support.shares
        if len(given) != satellites:
            raise InvalidInput(
                "shares", given, "different_length", expected=satellites, actual=len(given)
            )
        for j, share in enumerate(given):
            check_positive(**{f"shares[{j}]": share})
        if not abs(math.fsum(given) - 1) <= SUM_ERROR:
            raise InvalidInput("shares", given, "sum_not_one", sum=math.fsum(given))
        return
    check_positive(stiffness=support.stiffness)
    if isinstance(support, CrankSupport) and not 0 <= support.radial_clearance < math.inf:
        given_clearance = support.radial_clearance
        raise InvalidInput("radial_clearance", given_clearance, "greater_than_equal", limit=0)


def rigid_limit_torque(
    *, psi: float, limits: Sequence[float], setup: Setup, pairs: Pairs, room: Room
) -> float:
    """Torque under which the first pair of rigid satellites is pressed in by its limit.

    Parameters
    ----------
    psi : float
        Wave angle, rad.
    limits : sequence of float
        Of each pair: its approach at its limit, m; in exact geometry ``2*C*d + d^2``.
    setup : Setup
        The design, with the torque's direction.
    pairs : Pairs
        Constants of the pairs.
    room : Room
        Scratch.

    Returns
    -------
    float
        As `HeldSatellites.limit_torque`.
    """
    at(psi, setup, pairs, room)
    for i, limit in enumerate(limits):
        room.q[i] -= limit
    low, high, *_ = play(setup, room)
    if low > high:
        return 0.0
    at(psi, setup, pairs, room)
    lag = min(high, setup.eccentricity / setup.radius)
    return max(balance(lag, setup, pairs, room)[0], 0.0)


def loosen(*, support: SatelliteSupport | None, pairs: Pairs) -> None:
    """Count the clearance of the crank's bearings to the gaps of the pairs.

    Parameters
    ----------
    support : SatelliteSupport or None
        How the satellites are held.
    pairs : Pairs
        Constants of the pairs, prepared in first order; the gaps grow by G/2.
    """
    if isinstance(support, CrankSupport):
        loose = support.radial_clearance / 2
        for i in range(len(pairs.k0)):
            pairs.k0[i] -= loose
            pairs.size[i] += loose


@dataclass(frozen=True, slots=True)
class HeldSatellites:
    """Positions of a mechanism whose satellites give.

    Attributes
    ----------
    support : SatelliteSupport
        How the satellites are held.
    pairs : Pairs
        Constants of the pairs, loosened.
    """

    support: SatelliteSupport
    pairs: Pairs

    def solve(self, psi: float, torque: float, setup: Setup, room: Room) -> Position:
        """Equilibrium of a position, as `sharing_kernel.solve`; the lags of the satellites are left
        in the room too.

        Parameters
        ----------
        psi : float
            Wave angle, rad.
        torque : float
            Size of the torque, N*m, > 0.
        setup : Setup
            The design in first order, with the torque's direction.
        room : Room
            Takes forces, levers and stiffnesses of the pairs, and the lags of the satellites.

        Returns
        -------
        Position
            With given shares its lag, stiffness and play are those of a linkage that shares the
            torque so: the mean lag of the satellites, weighted by the shares.
        """
        if isinstance(self.support, Shares):
            return self._apart(self.support.shares, psi, torque, setup, room)
        return self._together(psi, torque, setup, room)

    def played(self, psi: float, setup: Setup, room: Room) -> tuple[float, float]:
        """Limits of the play at a wave angle, rad; the first is larger where pairs press.

        Parameters
        ----------
        psi : float
            Wave angle, rad.
        setup : Setup
            The design, with the torque's direction.
        room : Room
            Scratch.

        Returns
        -------
        low, high : float
        """
        if not isinstance(self.support, Shares):
            at(psi, setup, self.pairs, room)
            return play(setup, room)[:2]
        ends = []
        for one, pairs, own in self._each(setup, room):
            at(psi, one, pairs, own)
            ends.append(play(one, own)[:2])
        return _mean_play(self.support.shares, ends)

    def interference(self, psi: float, setup: Setup, room: Room) -> float:
        """Smallest possible worst approach of the unloaded pairs at a wave angle, m; with given
        shares each satellite turns for itself.

        Parameters
        ----------
        psi : float
            Wave angle, rad.
        setup : Setup
            The design.
        room : Room
            Scratch.

        Returns
        -------
        float
        """
        parts = [(setup, self.pairs, room)]
        if isinstance(self.support, Shares):
            parts = self._each(setup, room)
        far, worst = setup.eccentricity / setup.radius, []
        for one, pairs, own in parts:
            at(psi, one, pairs, own)
            worst.append(interference(-far, far, one, pairs, own))
        return max(worst)

    def limit_torque(self, psi: float, limits: list[float], setup: Setup, room: Room) -> float:
        """Torque under which the first pair is pressed in by its limit.

        Parameters
        ----------
        psi : float
            Wave angle, rad.
        limits : list of float
            Approach of each pair at its limit, m.
        setup : Setup
            The design, with the torque's direction.
        room : Room
            Scratch.

        Returns
        -------
        float
            N*m; 0 where a pair is pressed as far without load. Where the output would lag by the
            eccentricity before, the torque that brings it there.
        """
        if isinstance(self.support, Shares):
            found = []
            for j, (one, pairs, own) in enumerate(self._each(setup, room)):
                some = limits[j * setup.pins : (j + 1) * setup.pins]
                torque = rigid_limit_torque(psi=psi, limits=some, setup=one, pairs=pairs, room=own)
                found.append(torque / self.support.shares[j])
            return min(found)
        at(psi, setup, self.pairs, room)
        count, far = setup.satellites, setup.eccentricity / setup.radius
        zero = min(max(play(setup, room)[1], -far), far)
        owns = [0.0 if self._crank else 1.0] * count  # over the lag

        def pressed(lag: float) -> _Balance:
            """By how much the pair that is nearest to its limit, or beyond it, is beyond."""
            discs = [self._disc(lag, owns[j], j, setup, room) for j in range(count)]
            if lag != 0:
                owns[:] = [disc.own / lag for disc in discs]
            beyond, most = [], 0
            for i, limit in enumerate(limits):
                own = discs[i // setup.pins].own
                turned, back = (lag, own) if self._crank else (own, 0.0)
                beyond.append(room.q[i] + turned * room.v[i] + back - limit)
                most = i if beyond[i] > beyond[most] else most
            lever, value = room.v[most], beyond[most]
            slope = discs[most // setup.pins].effective(lever, self._factor(lever))
            size = abs(room.q[most]) + abs(lag * lever) + limits[most]
            return _Balance(value, -value / slope if slope > 0 else math.inf, size, slope, discs)

        if pressed(zero).value >= 0:
            return 0.0
        rigid = [q - limit for q, limit in zip(room.q, limits, strict=True)]
        first = min(max(play(setup, room._replace(q=rigid))[1], zero), far)
        lag, last, _, _ = _root(pressed, first, zero, math.inf)
        discs = last.discs if lag <= far else pressed(far).discs
        return max(math.fsum(disc.torque for disc in discs), 0.0)

    def wave_torque(self, psi: float, setup: Setup, room: Room) -> float:
        """Torque of the forces on the wave, N*m, as `solve` left the room.

        Parameters
        ----------
        psi : float
            Wave angle, rad.
        setup : Setup
            The design, with the torque's direction.
        room : Room
            As `solve` left it.

        Returns
        -------
        float
        """
        each = enumerate(self._each(setup, room))
        return sum(
            wave_torque(psi, room.own_lag[j], one, pairs, own) for j, (one, pairs, own) in each
        )

    def _each(self, setup: Setup, room: Room) -> list[tuple[Setup, Pairs, Room]]:
        """The satellites one by one; the rows are copies."""
        pins, found = setup.pins, []
        one = setup._replace(satellites=1)
        for j in range(setup.satellites):
            pairs = Pairs(
                *[
                    row[j : j + 1] if name in ("arm", "phase") else row[j * pins : (j + 1) * pins]
                    for name, row in zip(Pairs._fields, self.pairs, strict=True)
                ]
            )
            own = Room(*[row[j * pins : (j + 1) * pins] for row in room])
            found.append((one, pairs, own))
        return found

    def _apart(
        self, shares: tuple[float, ...], psi: float, torque: float, setup: Setup, room: Room
    ) -> Position:
        """Every satellite under its share of the torque."""
        found = []
        for j, (one, pairs, own) in enumerate(self._each(setup, room)):
            position = solve(psi, shares[j] * torque, one, pairs, own)
            found.append(position)
            room.own_lag[j] = position.lag
            for i in range(setup.pins):
                for row, values in zip(room[:-1], own[:-1], strict=True):
                    row[j * setup.pins + i] = values[i]
        low, high = _mean_play(
            shares,
            [
                (math.inf, -math.inf) if each.low > each.high + each.play_error else each[2:4]
                for each in found
            ],
        )
        slopes = [each.stiffness for each in found]
        gives = 0.0
        if min(slopes) > 0:
            gives = sum(w * (w / slope) for w, slope in zip(shares, slopes, strict=True))

        def mean(name: str) -> float:
            return math.fsum(w * getattr(each, name) for w, each in zip(shares, found, strict=True))

        return Position(
            lag=mean("lag"),
            stiffness=1 / gives if gives else 0.0,
            low=low,
            high=high,
            play_error=mean("play_error"),
            lag_error=mean("lag_error") + 2 * EPS * max(abs(each.lag) for each in found),
            force_error=max(each.force_error for each in found),
            status=next((each.status for each in found if each.status != SOLVED), SOLVED),
            steps=sum(each.steps for each in found),
        )

    def _together(self, psi: float, torque: float, setup: Setup, room: Room) -> Position:
        """All satellites at one output, each with what holds it."""
        pairs = self.pairs
        at(psi, setup, pairs, room)
        low, high, behind, onset = play(setup, room)
        play_error = max(
            touch_error(low, behind, psi, setup, pairs, room),
            touch_error(high, onset, psi, setup, pairs, room),
        )
        pressed = low > high + play_error
        zero = 0.0 if pressed else high
        first = math.inf
        if zero < math.inf:
            shift(zero, -1 if pressed else onset, setup, pairs, room)
            first = start(torque, setup, pairs, room)
        if first == math.inf:
            return Position(0.0, 0.0, low, high, play_error, 0.0, 0.0, NO_DRIVE, 0)
        power, steps = 1.0 if pressed else 1 / setup.exponent, 0
        rest, far = 0.0 if self._crank else 1.0, setup.eccentricity / setup.radius
        owns = [rest] * setup.satellites  # over the lag: where the next search begins

        def balance(lag: float) -> _Balance:
            nonlocal steps
            discs = [self._disc(lag, owns[j], j, setup, room) for j in range(setup.satellites)]
            if lag != 0:
                owns[:] = [disc.own / lag for disc in discs]
            steps += sum(disc.steps for disc in discs)
            carried = math.fsum(disc.torque for disc in discs)
            slope = math.fsum(disc.slope for disc in discs)
            ratio, change = carried / torque, math.inf
            if slope > 0 and power == 1:
                change = (torque - carried) / slope
            elif slope > 0 and ratio > 0:
                change = torque * (ratio ** (1 - power) - ratio) / (power * slope)
            if pressed:  # as in the kernel: no step beyond what is sought
                change = min(max(change, -far), far)
            size = math.fsum(disc.gross + abs(disc.weight) * disc.size for disc in discs)
            return _Balance(carried - torque, change, size, slope, discs)

        lag, last, _, found = _root(
            balance, 0.0 if pressed else first, -math.inf if pressed else 0.0, math.inf
        )
        if not last.slope > 0:
            return Position(0.0, 0.0, low, high, play_error, 0.0, 0.0, NOT_SOLVED, steps)
        lag_error, force_error = self._errors(psi, torque, last, setup, room)
        for j, disc in enumerate(last.discs):
            room.own_lag[j] = zero + disc.lag
        return Position(
            zero + lag,
            last.slope,
            low,
            high,
            play_error,
            lag_error + (0.0 if pressed else play_error) + EPS * abs(lag),
            force_error,
            SOLVED if found else NOT_SOLVED,
            steps,
        )

    @property
    def _crank(self) -> bool:
        return isinstance(self.support, CrankSupport)

    def _factor(self, lever: float) -> float:
        """What a pair takes part in its disc's own equation with."""
        return 1.0 if self._crank else lever

    def _disc(self, lag: float, own: float, j: int, setup: Setup, room: Room) -> "_Disc":
        """Satellite j at a lag of the output: its forces, with what its bearing or mesh gives,
        sought from a share of the lag.
        """
        crank = self._crank
        gives = 0.0 if isinstance(self.support, Shares) else 1 / self.support.stiffness
        rows = range(j * setup.pins, (j + 1) * setup.pins)
        q, v, force, levers, contact = room.q, room.v, room.force, room.lever, room.stiffness
        a, b, kind, exponent = self.pairs.a, self.pairs.b, setup.law, setup.exponent
        rest = 0.0 if crank else lag

        def own_balance(own: float) -> _Own:
            turned, back = (lag, own) if crank else (own, 0.0)
            held = size = stiff = mixed = 0.0
            for i in rows:
                lever = v[i]
                approach = q[i] + turned * lever + back
                if approach <= TINY:  # below it powers leave the range of numbers
                    force[i] = levers[i] = contact[i] = 0.0
                    continue
                force[i], contact[i] = law(kind, approach, a[i], b[i], exponent, 0.0, 0.0)
                levers[i], factor = lever, 1.0 if crank else lever
                held += force[i] * factor
                stiff += contact[i] * factor * factor
                mixed += contact[i] * factor * lever
                size += (force[i] + contact[i] * (abs(turned * lever) + abs(back))) * abs(factor)
            value, share = own - rest + gives * held, 1 / (1 + gives * stiff)
            size = abs(own) + abs(rest) + gives * size
            return _Own(value, -value * share, size, stiff, mixed, share)

        own, last, steps, _ = _root(own_balance, own * lag, -math.inf, math.inf)
        middle = last.mixed / last.stiff if last.stiff > 0 else 0.0
        spread = math.fsum(
            contact[i] * (levers[i] - middle * self._factor(levers[i])) ** 2 for i in rows
        )
        return _Disc(
            torque=math.fsum(force[i] * levers[i] for i in rows),
            gross=math.fsum(force[i] * abs(levers[i]) for i in rows),
            slope=spread + middle * middle * last.stiff * last.share,
            own=own,
            lag=lag if crank else own,
            back=abs(own) if crank else 0.0,
            off=abs(last.value),
            size=last.size,
            gives=gives,
            middle=middle,
            share=last.share,
            weight=last.mixed * last.share,
            steps=steps,
        )

    def _errors(
        self, psi: float, torque: float, last: "_Balance", setup: Setup, room: Room
    ) -> tuple[float, float]:
        """Bounds of the errors of lag and forces: by the balance, by rounding of terms, levers and
        approaches as in the kernel, and by what the discs' own equations are off.
        """
        rounding = EPS * (4 + 2 * abs(psi))
        off = abs(last.value) + 4 * EPS * (torque + math.fsum(disc.gross for disc in last.discs))
        own_off = []
        for j, disc in enumerate(last.discs):
            own, moved = disc.off + 4 * EPS * disc.size, 0.0
            for i in range(j * setup.pins, (j + 1) * setup.pins):
                lever, stiffness = room.lever[i], room.stiffness[i]
                factor = self._factor(lever)
                near = rounding * (room.unsure[i] + abs(disc.lag) * setup.radius + disc.back)
                rough = rounding * room.force[i] * setup.radius
                room.unsure[i] = near
                off += rough + stiffness * abs(disc.effective(lever, factor)) * near
                own += 0.0 if self._crank else disc.gives * rough
                moved += disc.gives * stiffness * abs(factor) * near
            off += abs(disc.weight) * own
            own_off.append(disc.share * (own + moved))
        lag_error, force_error = off / last.slope, 0.0
        for j, (disc, own) in enumerate(zip(last.discs, own_off, strict=True)):
            for i in range(j * setup.pins, (j + 1) * setup.pins):
                lever = room.lever[i]
                factor = self._factor(lever)
                near = abs(disc.effective(lever, factor)) * lag_error + room.unsure[i]
                near += abs(factor) * own
                error = room.stiffness[i] * near + 8 * EPS * room.force[i]
                force_error = max(force_error, error)
        return lag_error, force_error


class _Own(NamedTuple):
    """A disc's own equation, in how far its bearing goes back or at which lag it stands."""

    value: float
    change: float  # step of Newton
    size: float  # of its terms
    stiff: float  # sums of contact stiffness times factor^2, and factor*lever
    mixed: float
    share: float  # 1 over the slope of the equation


class _Disc(NamedTuple):
    """A disc at a lag of the output."""

    torque: float
    gross: float
    slope: float  # of the torque over the lag of the output
    own: float  # unknown of its own equation
    lag: float  # of the output behind it
    back: float  # by which its bearing has gone back, and the approach of each pair with it
    off: float  # of its own equation, and the size of the terms
    size: float
    gives: float
    middle: float  # mean lever over factor
    share: float
    weight: float  # torque over what its own equation is off
    steps: int

    def effective(self, lever: float, factor: float) -> float:
        """Approach of a pair over the lag of the output."""
        return lever - self.middle * factor + self.middle * factor * self.share


class _Balance(NamedTuple):
    """All discs at a lag of the output."""

    value: float
    change: float
    size: float
    slope: float
    discs: list[_Disc]


Step = TypeVar("Step", _Own, _Balance)


def _root(
    function: Callable[[float], Step], x: float, low: float, high: float
) -> tuple[float, Step, int, bool]:
    """Root of an increasing function by Newton inside a bracket: place, function, steps, whether
    it was found.
    """
    for step in range(1, STEPS):
        here = function(x)
        if abs(here.value) <= EPS * here.size or abs(here.change) <= EPS * abs(x):
            return x, here, step, True
        if here.value > 0:
            high = x
        else:
            low = x
        following = x + here.change
        # Where Newton goes back and forth the stretch is halved every second time.
        if not low < following < high or (
            step > NEWTON_ALONE and step % 2 and math.isfinite(high - low)
        ):
            if high == math.inf:
                following = x + max(abs(x), 1e-9)
            elif low == -math.inf:
                following = x - max(abs(x), 1e-9)
            else:
                following = (low + high) / 2
                if following in (low, high):
                    return x, here, step, True
        x = following
    return x, function(x), STEPS, False


def _mean_play(
    shares: tuple[float, ...], ends: Sequence[tuple[float, float]]
) -> tuple[float, float]:
    """Play of a linkage that shares the torque; none where any satellite is pressed."""
    if any(low > high for low, high in ends):
        return math.inf, -math.inf
    low, high = (
        math.fsum(w * end for w, end in zip(shares, side, strict=True))
        for side in zip(*ends, strict=True)
    )
    return low, high
