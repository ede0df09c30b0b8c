"""Answers of another program, held against those of the service."""

from typing import Any

import pytest


def close(found: Any, expected: Any, path: str = "") -> None:
    """Every number of the expected answer, to nine digits of the largest beside it."""
    if isinstance(expected, dict):
        for name, value in expected.items():
            close(found[name], value, f"{path}/{name}")
    elif isinstance(expected, list) and expected and not isinstance(expected[0], (int, float)):
        assert len(found) == len(expected), path
        for i, (one, other) in enumerate(zip(found, expected, strict=True)):
            close(one, other, f"{path}/{i}")
    elif isinstance(expected, (bool, str)):
        assert found == expected, path
    else:
        rows = expected if isinstance(expected, list) else [expected]
        size = max(map(abs, rows)) or 1.0
        assert found == pytest.approx(expected, rel=0, abs=1e-9 * size), path
