"""Preloaded module of processes for calculations: the engine, read or compiled."""

import logging
import sys

from app.compiled import LOG, load
from app.observability import JsonLines

OUT = logging.StreamHandler(sys.stdout)  # the service's own logging is not set up here
OUT.setFormatter(JsonLines())
LOG.addHandler(OUT)
LOG.propagate = False
load()
