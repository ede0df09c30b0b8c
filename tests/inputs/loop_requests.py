"""The largest requests of each calculation that the event loop still answers, drawn by a seed."""

import json
import random
from copy import deepcopy
from itertools import product
from typing import Any

from app.calculations.crank_planetary_sections import SECTIONS
from app.endpoint import LIGHT_BYTES, LIGHT_COST, read_body
from app.examples import EXAMPLES, REQUESTS
from app.model import Calculation
from app.problems import Problem
from app.settings import Settings

Body = dict[str, Any]

SIZES = {
    "pins": 100,
    "satellites": 9,
    "samples": 10_001,
    "revolutions": 1000,
    "rollers_total": 500,
    "force_exponent": 500,
}
"""What a request grows with, and how far."""

OPTIONS = sorted({"curves", "equal_sharing", "approximation", "points", "worked", *SECTIONS})
"""What may be asked besides."""


def cost(calculation: Calculation, body: Body) -> float | None:
    """Cost that a request states; None if it is refused or too long for the loop."""
    content = json.dumps(body).encode()
    try:
        found = read_body(calculation, content, Settings()).cost()
    except Problem:
        return None
    return found if len(content) <= LIGHT_BYTES else None


def in_the_loop(calculation: Calculation, body: Body) -> bool:
    """True if the event loop answers a request."""
    found = cost(calculation, body)
    return found is not None and found <= LIGHT_COST


def largest_in_the_loop(calculation: Calculation, r: random.Random) -> Body | None:
    """An example without what is searched or solved, with all options and then each size as large
    as the loop takes, in an order that is drawn; None where it answers none.
    """
    given = [each["input"] for each in EXAMPLES if each["calculation"] == calculation.name]
    body = deepcopy(r.choice([REQUESTS[calculation.name], *given]))
    body.pop("include", None)
    sections = [name for name, each in body.items() if isinstance(each, dict)]
    for name in r.sample(sections, len(sections)):
        if not in_the_loop(calculation, body):
            section = body.pop(name)
            if cost(calculation, body) is None:
                body[name] = section
    if not in_the_loop(calculation, body):
        return None
    usual = r.random() < 0.2
    for option in () if usual else r.sample(OPTIONS, len(OPTIONS)):
        more = body | {"include": [*body.get("include", ()), option]}
        body = more if in_the_loop(calculation, more) else body
    places = [(), *((name,) for name, each in body.items() if isinstance(each, dict))]
    for path, name in r.sample([*product(places, SIZES)], len(places) * len(SIZES)):
        most, least = int(10 ** r.uniform(-0.5, 0) * SIZES[name]), 2
        while most >= least:
            size = least if least == 2 else (least + most) // 2
            grown = _with(body, path, name, size)
            if in_the_loop(calculation, grown):
                body, least = grown, size + 1
            else:
                most = size - 1
    return body


def _with(body: Body, path: tuple[str, ...], name: str, size: int) -> Body:
    """Request with another size."""
    if path:
        return body | {path[0]: _with(body[path[0]], (), name, size)}
    return body | {name: size}
