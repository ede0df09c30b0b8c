"""Access to values of a document by JSON pointers (RFC 6901)."""

from collections.abc import Mapping
from copy import copy
from typing import Any


def keys(pointer: str) -> list[str]:
    """Keys of a JSON pointer."""
    return [part.replace("~1", "/").replace("~0", "~") for part in pointer[1:].split("/")]


def inner(document: Any, key: str) -> Any:
    """Value at a key of an object, or at an index or code of a list; None if there is none."""
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
    """Object or list that holds the last key of a path; None if there is none."""
    for key in path[:-1]:
        document = inner(document, key)
    return document


def with_values(document: dict[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """Document with other values, by JSON pointers; it shares the rest with the given one."""
    found = copy(document)
    for pointer, value in values.items():
        *path, last = keys(pointer)
        place: Any = found
        for key in path:
            at = int(key) if isinstance(place, list) else key
            place[at] = copy(place[at])
            place = place[at]
        place[int(last) if isinstance(place, list) else last] = value
    return found


def has_number(schema: dict[str, Any], path: list[str]) -> bool:
    """True if a document of a pydantic JSON schema may have a number at a path."""

    def found(part: Any, path: list[str]) -> bool:
        if "$ref" in part:
            part = schema["$defs"][part["$ref"].rpartition("/")[2]]
        if "anyOf" in part:
            return any(found(each, path) for each in part["anyOf"])
        if not path:
            return part.get("type") in ("number", "integer")
        key, *rest = path
        if part.get("type") == "array":
            of = part["items"] if "items" in part else {"anyOf": part["prefixItems"]}
            return (key.isdecimal() or found_code(of, key)) and found(of, rest)
        of = part.get("properties", {}).get(key) or part.get("additionalProperties")
        return isinstance(of, dict) and found(of, rest)

    def found_code(part: Any, code: str) -> bool:
        named = schema["$defs"][part["$ref"].rpartition("/")[2]] if "$ref" in part else part
        return code in named.get("properties", {}).get("code", {}).get("enum", ())

    return found(schema, path)
