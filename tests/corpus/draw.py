"""Make the corpus anew: `python -m tests.corpus.draw`.

Examples and paper figures, what the API's description shows, the tutorial, what calculations are
held to exact values with, random whole designs, and what is refused.
"""

import json
import random
import re
from pathlib import Path
from typing import Any

from app.examples import EXAMPLES, REQUESTS
from tests.inputs.fuzz_requests import DESIGNS, mutated
from tests.inputs.fuzz_requests import Draw as Wide
from tests.inputs.in_process import Service
from tests.oracles.answers import CALCULATIONS
from tests.oracles.answers.calculation import Draw

HERE = Path(__file__).parent
CORPUS = HERE / "requests.json"
TUTORIAL = HERE.parent.parent / "docs" / "tutorial.md"

COUNT, REFUSED = 400, 35
HELD = 10
"""Requests of each calculation that exact values are known of, one in five of them extreme."""

SLOW = {"work-precision", "batch"}
"""What takes minutes, or is many of the others."""

Asked = dict[str, Any]


def asked(path: str, body: Any) -> Asked:
    return {"path": path, "body": body}


def usual() -> list[Asked]:
    """What is shown to people."""
    found = [asked(each["calculation"], each["input"]) for each in EXAMPLES]
    found += [asked(path, body) for path, body in REQUESTS.items() if path not in SLOW]
    tutorial = re.findall(r"ask (\S+) '(.*?)'\n", TUTORIAL.read_text(encoding="utf-8"), re.DOTALL)
    found += [asked(path, json.loads(body)) for path, body in tutorial]
    whole = [each for each in found if each["path"] == "crank-planetary"]
    every = ["checks", "fixes"]
    return found + [asked("crank-planetary", each["body"] | {"include": every}) for each in whole]


def held() -> list[Asked]:
    """What exact values are known of."""
    return [
        asked(calculation.path, calculation.request(Draw(seed, extreme=seed % 5 == 4)))
        for calculation in CALCULATIONS
        for seed in range(HELD)
    ]


def drawn(count: int, service: Service) -> list[Asked]:
    """Random designs of practical sizes that are answered, whole ones in half."""
    r, found = Wide(20261125), []
    others = [each for each in DESIGNS if each != "crank-planetary"]
    while len(found) < count:
        path = "crank-planetary" if r.chance(0.5) else r.choice(others)
        body = DESIGNS[path](r)
        mechanism = body.get("mechanism", body)
        few = mechanism.get("pins", 1) * mechanism.get("satellites", 1) <= 60
        if few and service.post(path, body)[0] == 200:
            found.append(asked(path, body))
    return found


def refused(good: list[Asked]) -> list[Asked]:
    """What is wrong in one place."""
    r, picks = Wide(7), random.Random(7).sample(good, REFUSED)
    return [asked(each["path"], mutated(r, each["body"])) for each in picks]


def main() -> None:
    """Write the corpus."""
    service = Service()
    good = [each for each in usual() + held() if service.post(each["path"], each["body"])[0] == 200]
    good += drawn(COUNT - REFUSED - len(good), service)
    lines = [json.dumps(each) for each in good + refused(good)]
    CORPUS.write_text("[\n" + ",\n".join(lines) + "\n]\n", encoding="utf-8")
    print(f"{len(lines)} requests in {CORPUS.name}")


if __name__ == "__main__":
    main()
