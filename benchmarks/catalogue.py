"""Rated torque of real reducers over the largest torque that the service allows.

The reducers of `tests/inputs/catalogue.json` come from catalogues, data sheets and papers. `make
catalogue` writes docs/catalogue.md.
"""

from contextlib import closing
from copy import deepcopy
from pathlib import Path
from typing import Any

import orjson

from benchmarks.options import options
from tests.inputs.in_process import Service

ROOT = Path(__file__).parent.parent
REPORT = ROOT / "docs" / "catalogue.md"
REDUCERS = ROOT / "tests" / "inputs" / "catalogue.json"
ASSUMED = "assumed: "
HEAD = """\
# Real reducers

Made by `make catalogue` (`benchmarks/catalogue.py`): reducers by catalogues, data sheets, papers.
Each number of a design has its document and where it stands there, or why it is assumed, in
`tests/inputs/catalogue.json`; *assumed* counts these of all numbers. The clearance is hardly ever
published: where it is not, the design is judged with the usual one, marked with *. The verdict is
at the torque of the document; the largest torque is the least over the parts that are judged, which
the next column names, and is left out where it is not known, as of plastics, whose limits are not,
and of metals of which a document gives an allowable pressure and no yield strength, or where no
smaller torque would do: teeth and what a document does not give are open. Where the rating is far
off it, the numbers assumed are as likely wrong as the design: these are no proofs of either.

| reducer | kind | rating, N·m | assumed | clearance, mm | verdict | governing check | \
largest torque, N·m | of | rating over it |
|---|---|---|---|---|---|---|---|---|---|
"""

Answer = dict[str, Any]


def judged(service: Service, body: Answer) -> tuple[Answer, str]:
    """Answer for a design, with the usual clearance if none is known, and the clearance used."""
    status, answer = service.post(
        "crank-planetary", body | {"include": ["checks", "largest_torque", "usual_fit"]}
    )
    assert status == 200, answer
    contact = body["contact"]
    open_by = {part.get("reason") for part in answer["parts"]}
    if "usual_fit" not in answer or "clearance_unknown" not in open_by:
        return answer, f"{contact.get('hole_clearance_mm', 0):.4g}"
    body = deepcopy(body)
    clearance = answer["usual_fit"]["hole_clearance_mm"]
    body["contact"]["hole_clearance_mm"] = clearance
    body["contact"].pop("distribution_factor", None)  # how uneven the sharing is, is solved then
    if "eccentricity_mm" in contact:
        body["contact"].pop("hole_radius_mm", None)
    status, answer = service.post(
        "crank-planetary", body | {"include": ["checks", "largest_torque"]}
    )
    assert status == 200, answer
    return answer, f"{clearance:.4g} *"


def row(service: Service, reducer: Answer) -> tuple[str, float | None]:
    """Row of the table, and rating over largest torque."""
    answer, clearance = judged(service, reducer["body"])
    titles = {check["code"]: check["title"] for check in answer["checks"]}
    largest = answer.get("largest_torque_Nm")
    over = reducer["rating_Nm"] / largest if largest else None
    words = reducer["numbers"].values()
    cells = [
        reducer["name"],
        reducer["kind"],
        f"{reducer['rating_Nm']:g}",
        f"{sum(word.startswith(ASSUMED) for word in words)} of {len(words)}",
        clearance,
        answer["verdict"],
        titles.get(answer.get("governing"), ""),
        "" if largest is None else f"{largest:.4g}",
        ", ".join(answer.get("largest_torque_of", [])),
        "" if over is None else f"{over:.2f}",
    ]
    return f"| {' | '.join(cells)} |", over


def main(smallest: bool) -> None:
    """Judge all reducers and write the report; in the smallest form, only judge the first."""
    reducers = orjson.loads(REDUCERS.read_bytes())
    with closing(Service()) as service:
        rows = [row(service, reducer) for reducer in reducers[: 1 if smallest else None]]
    if not smallest:
        REPORT.write_text(HEAD + "\n".join(line for line, _ in rows) + "\n", encoding="utf-8")
    known = sorted(over for _, over in rows if over is not None)
    print(f"{len(rows)} reducers, {len(known)} with a largest torque; rating over it:")
    print(" ".join(f"{over:.2f}" for over in known))


if __name__ == "__main__":
    main(options(__doc__).smallest)
