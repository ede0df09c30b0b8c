"""Figures and numbers of papers, designs that work and reducers that were built, as ready requests
from `examples.json`.

Papers print no torque and no sizes for figures that show ratios; if a request needs them, the
example has round numbers, and its title names the quantity to look at. A through-hardened satellite
of these sizes does not bear the pressure, therefore the opening example uses case-hardening.
"""

from pathlib import Path
from typing import Any

import orjson

_DATA = orjson.loads(Path(__file__).with_name("examples.json").read_bytes())

EXAMPLES: list[dict[str, Any]] = _DATA["examples"]
"""Ready requests in the order of the page, which opens with the first one of a calculation."""

REQUESTS: dict[str, dict[str, Any]] = _DATA["requests"]
REQUESTS |= {
    f"export/{kind}": {"design": REQUESTS["export/dxf"]["design"]} for kind in ("build123d", "step")
}
REQUESTS["export/report"] = REQUESTS["export/xlsx"] | {"title_block": {"title": "Pin and hole"}}
"""One request for each endpoint, for the API's description; the chart endpoint takes it too."""
