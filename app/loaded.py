"""What processes for calculations have at hand from their start: the compiled loops, if there."""

import logging

from app import compiled

try:
    if compiled.use() == "ready":
        compiled.run_once()
except Exception:  # a cache that is broken must not keep the service from starting
    logging.getLogger("khv.compiled").exception("the compiled load sharing is compiled anew")
    compiled.forget()
