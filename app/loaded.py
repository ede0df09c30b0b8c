"""What processes for calculations have from their start: the compiled loops, read or made."""

from app.compiled import load

load()
