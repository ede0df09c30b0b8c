"""Requests and answers of the precessional gear, one module for each calculation."""
