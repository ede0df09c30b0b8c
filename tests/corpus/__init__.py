"""The corpus of `make compare`: requests only, never answers of ours."""
