"""The papers' figures and numbers as ready requests, and a design that works to begin with: what
`examples.json` has.

The papers print no torque and no sizes for the figures that show ratios; where a request needs
them, the example takes round numbers and its title says what to look at. With these sizes a
through-hardened satellite does not stand the pressure; the opening example case-hardens it.
"""

from pathlib import Path
from typing import Any

import orjson

_DATA = orjson.loads(Path(__file__).with_name("examples.json").read_bytes())

EXAMPLES: list[dict[str, Any]] = _DATA["examples"]
"""Ready requests in the order of the page, which opens with the first of a calculation."""

REQUESTS: dict[str, dict[str, Any]] = _DATA["requests"]
"""One request for each endpoint, for the API's description; its chart takes the same."""
