"""One displacement shared by many unilateral contacts in parallel.

Contacts of one stiffness close one after another as the displacement grows and uses up their
gaps; an open contact carries nothing and cannot pull.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from core.errors import InvalidInput
from core.results import ROUNDING


@dataclass(frozen=True, slots=True)
class LoadSharing:
    """How contacts in parallel share a load.

    Attributes
    ----------
    forces : tuple of float
        Force F_i of each contact, N, in the order of the gaps.
    displacement : float
        Common displacement Delta, m, from the same zero as the gaps.
    loaded : int
        Number of contacts that carry a force.
    relative_error : float
        Bound of the error of each force over the largest force, by rounding, dimensionless.
    """

    forces: tuple[float, ...]
    displacement: float
    loaded: int
    relative_error: float


def share_load(*, total: float, stiffness: float, gaps: Sequence[float]) -> LoadSharing:
    """Exact forces of unilateral contacts: ``F_i = c*max(0, Delta - g_i)``, ``sum F_i = total``.

    The contacts are closed in the order of their gaps. The approach ``total/c`` is first the
    first contact's alone; to close the next one, m contacts have each to move by the difference
    of the gaps, and use up m times as much of it. What remains when the next gap cannot be
    closed any more is shared evenly. No iteration, and no sum of large numbers that cancel.

    Parameters
    ----------
    total : float
        Sum of the forces, N, >= 0.
    stiffness : float
        Stiffness c of one contact, N/m, > 0.
    gaps : sequence of float
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
    if not 0 <= total < math.inf:
        raise InvalidInput("total", total, "must be finite and not negative")
    if not 0 < stiffness < math.inf:
        raise InvalidInput("stiffness", stiffness, "must be finite and larger than 0")
    if not gaps:
        raise InvalidInput("gaps", gaps, "must name at least one contact")
    for index, gap in enumerate(gaps):
        if not math.isfinite(gap):
            raise InvalidInput(f"gaps[{index}]", gap, "must be a finite number")

    closing = sorted(gaps)
    remaining = total / stiffness
    closed = 1
    for gap, following in pairwise(closing):
        used = closed * (following - gap)
        if used > 0 and used >= remaining:
            break
        remaining -= used
        closed += 1
    last = closing[closed - 1]
    rest = remaining / closed
    forces = tuple(stiffness * (rest + (last - gap)) if gap <= last else 0.0 for gap in gaps)
    return LoadSharing(
        forces=forces,
        displacement=last + rest,
        loaded=sum(force > 0 for force in forces),
        # The first force is the sum of positive terms, of which `remaining` carries one rounding
        # for each contact closed, relative to total/c; the largest force is at least its m-th.
        relative_error=ROUNDING * (3 + closed),
    )
