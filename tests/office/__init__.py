"""Files of the service, read by the programs of a drawing office; `make office` runs it."""
