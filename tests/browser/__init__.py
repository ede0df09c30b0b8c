"""The page in a browser: a package, so that the browser ends before tests that need their own
loop.
"""
