"""The web layer of KHV Calc: HTTP, JSON, millimetres and degrees around `core`."""

import os

VERSION = "0.1.0"
"""Version of the service; pyproject.toml reads it from here."""

# Before NumPy is imported: its threads would gain nothing on products as small as those here, and
# take turns with the other processes of the service.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
