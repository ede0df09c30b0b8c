"""The engine of a drive as its source is, beside the one that is compiled."""

import importlib.util

from core.drive import engine

_spec = importlib.util.spec_from_file_location("plain_engine", engine.__file__)
assert _spec and _spec.loader
plain = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(plain)
