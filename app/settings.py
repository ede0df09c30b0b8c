"""What an operator may set, by environment variables that start with ``KHV_``."""

import os
from dataclasses import dataclass, fields
from typing import Self


@dataclass(frozen=True, slots=True)
class Settings:
    """Limits of the service.

    Attributes
    ----------
    max_body_bytes : int
        Largest request body, bytes.
    """

    max_body_bytes: int = 1_048_576

    @classmethod
    def from_environment(cls) -> Self:
        """Settings with what the environment overrides."""
        given = {
            field.name: int(os.environ[f"KHV_{field.name.upper()}"])
            for field in fields(cls)
            if f"KHV_{field.name.upper()}" in os.environ
        }
        return cls(**given)
