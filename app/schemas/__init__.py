"""Requests and answers of the API: names, units, limits and texts of every field."""
