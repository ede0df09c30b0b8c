"""Load sharing of many unilateral contacts in parallel under one displacement.

Contacts of equal stiffness close one after another as the displacement uses up their gaps. An open
contact carries nothing, as a contact cannot pull.
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
    """Forces of contacts in parallel under a load."""

    forces: tuple[Number, ...]  # F_i of each contact, N, in the order of the gaps
    largest_force: Number  # force of the contact with the smallest gap, N
    displacement: Number  # Delta of all contacts, m, counted from the zero of the gaps
    loaded: int | IntArray  # number of contacts that carry a force
    # Bound of the error of each force over the largest force, and of the error of the displacement
    # over the larger of the displacement and the largest gap.
    relative_error: Number


def share_load(*, total: Number, stiffness: Number, gaps: Sequence[Number]) -> LoadSharing:
    """Exact forces of unilateral contacts: ``F_i = c*max(0, Delta - g_i)``, ``sum F_i = total``.

    The contacts are closed in the order of their gaps: to close the next gap, m closed contacts
    move by the difference of the gaps and use up m times as much of the approach ``total/c``. The
    remainder is shared evenly. No iteration is needed, and no large numbers cancel. Source:
    Ovsyannikov et al. 2019, eq. (5), for any gaps instead of ``0, 4*chi, ..., 4*chi``. The total is
    in N, >= 0, the stiffness c of one contact in N/m, > 0, gaps are in m: forces depend on their
    differences only, so that gaps may be negative.

    The first of four rollers is 10 um ahead of the others and carries 1 N/um times 10 um more.

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
    approach = rest + (last - first)  # approach of the contact with the smallest gap
    furthest = larger(abs(first), abs(last))
    forces = tuple([where(gap <= last, stiffness * (rest + (last - gap)), 0.0) for gap in gaps])
    return LoadSharing(
        forces=forces,
        largest_force=stiffness * approach,
        displacement=last + rest,
        loaded=sum([force > 0 for force in forces]),
        # The largest force is a sum of positive terms and at least 1/m of the load; `remaining`
        # carries one rounding of total/c for each contact closed. The gaps are known to rounding,
        # and their differences magnify it.
        relative_error=ROUNDING
        * (3 + closed + 2 * furthest / where(approach > 0, approach, math.inf)),
    )
