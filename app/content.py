"""Content of an answer, as it is sent."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import orjson

from core.errors import ImpossibleMechanism


def encoded(values: Any) -> bytes:
    """Values of an answer as JSON, without absent values but in columns named by pointers. Raises
    ImpossibleMechanism if a number is not finite, as the input exceeded the range of doubles.
    """
    content = orjson.dumps(
        values,
        option=orjson.OPT_SERIALIZE_NUMPY,
        default=np.ndarray.tolist,  # for arrays that are not contiguous
    )
    # Only numbers that are not finite are written as null.
    if b"null" in content and (names := dict.fromkeys(_nulls(orjson.loads(content), ""))):
        raise ImpossibleMechanism("overflow", names=", ".join(names))
    return content


def _nulls(values: Any, name: str) -> Iterator[str]:
    """Names of values that are null."""
    if values is None:
        yield name
    elif isinstance(values, dict):
        for inner, value in values.items():
            yield from _nulls(value, inner)
    elif isinstance(values, list) and not name.startswith("/"):
        for value in values:
            yield from _nulls(value, name)
