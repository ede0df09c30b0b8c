"""What JSON pointers (RFC 6901) point to in a document."""

from collections.abc import Mapping
from copy import deepcopy
from typing import Any


def keys(pointer: str) -> list[str]:
    """Keys of a JSON pointer."""
    return [part.replace("~1", "/").replace("~0", "~") for part in pointer[1:].split("/")]


def inner(document: Any, key: str) -> Any:
    """What a key holds: of an object, of a list by index or by code; None where nothing does."""
    if isinstance(document, dict):
        return document.get(key)
    if isinstance(document, list):
        if key.isdecimal():
            return document[int(key)] if int(key) < len(document) else None
        return next(
            (each for each in document if isinstance(each, dict) and each.get("code") == key), None
        )
    return None


def holder(document: Any, path: list[str]) -> Any:
    """What holds the last key of a path, None where there is no such thing."""
    for key in path[:-1]:
        document = inner(document, key)
    return document


def with_values(document: dict[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """A document with other values, by JSON pointers to what it has room for."""
    found = deepcopy(document)
    for pointer, value in values.items():
        path = keys(pointer)
        place = holder(found, path)
        place[int(path[-1]) if isinstance(place, list) else path[-1]] = value
    return found
