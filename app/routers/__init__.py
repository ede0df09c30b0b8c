"""Endpoints: each calls one calculation and words nothing of its own."""
