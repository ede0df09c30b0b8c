"""The page's drawings have the colours of the figures."""

import re
from pathlib import Path

from app.theme import SERIES

STYLES = Path(__file__).parents[2] / "static/styles/drawing.css"


def test_satellites_have_the_same_colours_in_drawings_and_figures() -> None:
    rules = re.findall(r"--series-(\d): light-dark\((#\w+), (#\w+)\)", STYLES.read_text())
    assert [int(number) for number, _, _ in rules] == list(range(1, len(rules) + 1))
    assert tuple(light for _, light, _ in rules) == SERIES["light"]
    assert tuple(dark for _, _, dark in rules) == SERIES["dark"]
