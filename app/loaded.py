"""What processes for calculations have at hand from their start: the compiled loops, if there."""

from app import compiled

if compiled.use() == "ready":
    compiled.run_once()
