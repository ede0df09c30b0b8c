"""Values and JSON pointers that no request should have."""

from typing import Any

HOSTILE: tuple[Any, ...] = (
    0,
    -1,
    2,
    3.5,
    1e-320,
    1e308,
    -1e12,
    1e12,
    10**30,
    "NaN",
    "1e999",
    None,
    [],
    {},
    True,
)
POINTERS: tuple[Any, ...] = (
    "/",
    "//",
    "/~2",
    "/contact",
    "/contact/",
    "/contact/pin_radius_mm/0",
    "",
    7,
    "x" * 300,
)
