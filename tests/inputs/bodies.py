"""Bodies of requests that differ from another in some fields."""

from copy import deepcopy
from typing import Any

Body = dict[str, Any]


def applied(body: Body, values: dict[str, Any]) -> Body:
    """Copy of a body with other values, by their pointers."""
    body = deepcopy(body)
    for pointer, value in values.items():
        *path, last = pointer.split("/")[1:]
        inner: Any = body
        for part in path:
            inner = inner[int(part)] if isinstance(inner, list) else inner[part]
        inner[last] = value
    return body


def changed(body: Body, /, **changes: Any) -> Body:
    """Copy of a body with other values: `section=` is laid over a section, `section__field=` stands
    in the place of a value. None takes it away.
    """
    body = deepcopy(body)
    for place, value in changes.items():
        *path, last = place.split("__")
        inner = body
        for part in path:
            inner = inner.setdefault(part, {})
        if isinstance(value, dict) and not path:
            whole = inner.get(last, {}) | deepcopy(value)
            inner[last] = {name: each for name, each in whole.items() if each is not None}
        elif value is None:
            inner.pop(last, None)
        else:
            inner[last] = deepcopy(value)
    return body
