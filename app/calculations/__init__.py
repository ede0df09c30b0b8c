"""One file a calculation: request, answer, figure, and what `app.registry` lists of it."""
