"""One displacement shared by many unilateral contacts in parallel.

Contacts of one stiffness close one after another as the displacement grows and uses up their
gaps; an open contact carries nothing and cannot pull.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from core.arrays import (
    IntArray,
    Number,
    ascending,
    check_finite,
    check_not_negative,
    check_positive,
    every,
    larger,
    refuse,
    some,
    where,
)
from core.errors import InvalidInput
from core.precision import ROUNDING


@dataclass(frozen=True, slots=True)
class LoadSharing:
    """How contacts in parallel share a load."""

    forces: tuple[Number, ...]  # F_i of each contact, N, in the order of the gaps
    largest_force: Number  # of the contact with the smallest gap, N
    displacement: Number  # Delta, of all contacts, m, from the same zero as the gaps
    loaded: int | IntArray  # number of contacts that carry a force
    # Bound of the error of each force over the largest force, and of the displacement over the
    # larger of it and the largest gap.
    relative_error: Number


def share_load(*, total: Number, stiffness: Number, gaps: Sequence[Number]) -> LoadSharing:
    """Exact forces of unilateral contacts: ``F_i = c*max(0, Delta - g_i)``, ``sum F_i = total``.

    The contacts are closed in the order of their gaps. The approach ``total/c`` is first the
    first contact's alone; to close the next one, m contacts have each to move by the difference
    of the gaps, and use up m times as much of it. What remains when the next gap cannot be
    closed any more is shared evenly. No iteration, and no sum of large numbers that cancel.

    Parameters
    ----------
    total : float or array
        Sum of the forces, N, >= 0.
    stiffness : float or array
        Stiffness c of one contact, N/m, > 0.
    gaps : sequence of float or array
        Gap g_i of each contact, m, at least one. Only differences matter to the forces: gaps
        may be negative.

    Returns
    -------
    LoadSharing

    Raises
    ------
    InvalidInput
        If there is no contact, a gap is no finite number, the load negative or the stiffness
        not positive.

    Notes
    -----
    Source: Ovsyannikov et al. 2019, eq. (5), for any gaps instead of ``0, 4*chi, ..., 4*chi``.

    Examples
    --------
    Four rollers, the first ahead of the others: it carries 1 N/um times 10 um more.

    >>> sharing = share_load(total=70.0, stiffness=1e6, gaps=[0.0, 1e-5, 1e-5, 1e-5])
    >>> [round(force, 9) for force in sharing.forces]
    [25.0, 15.0, 15.0, 15.0]
    >>> share_load(total=9.0, stiffness=1e6, gaps=[0.0, 1e-5, 1e-5, 1e-5]).loaded
    1
    """
    if not gaps:
        raise InvalidInput("gaps", gaps, "too_short", limit=1)
    check_positive(stiffness=stiffness)
    check_not_negative(total=total)
    check_finite(total=total, stiffness=stiffness)
    for index, gap in enumerate(gaps):
        finite = abs(gap) < math.inf
        if finite is not True and not every(finite):
            refuse(f"gaps[{index}]", gap, finite, "finite_number")

    closing = ascending(gaps)
    first = last = closing[0]
    remaining = total / stiffness
    closed, closes = 1, True
    for count, following in enumerate(closing[1:], start=1):
        used = count * (following - last)
        closes = closes & ((used <= 0) | (used < remaining))
        if not some(closes):
            break
        remaining = where(closes, remaining - used, remaining)
        last = where(closes, following, last)
        closed = closed + closes
    rest = remaining / closed
    approach = rest + (last - first)  # of the contact with the smallest gap
    furthest = larger(abs(first), abs(last))
    forces = tuple([where(gap <= last, stiffness * (rest + (last - gap)), 0.0) for gap in gaps])
    return LoadSharing(
        forces=forces,
        largest_force=stiffness * approach,
        displacement=last + rest,
        loaded=sum([force > 0 for force in forces]),
        # The first force is the sum of positive terms, of which `remaining` carries one rounding
        # for each contact closed, relative to total/c; the largest force is at least its m-th. The
        # gaps are known to rounding: their differences magnify that.
        relative_error=ROUNDING
        * (3 + closed + 2 * furthest / where(approach > 0, approach, math.inf)),
    )
