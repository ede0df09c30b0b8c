"""A real headless Chromium, as the tests, the benchmarks and the README's picture start it."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager

from playwright import sync_api

NAMES = "chromium-headless-shell", "chromium", "chromium-browser"
"""What it is called; the first is the same engine without windows, at half the processor time."""

MET = 'if (/^http/.test(location.protocol)) localStorage["khv-calc.met"] ??= "yes";'
"""Script for pages that have shown the sheet on which designs begin."""

BRIEF = "--disable-gpu", "--js-flags=--no-turbofan"
"""For pages that are soon closed: no process that draws for others, and nothing of their scripts
optimised for a long time; a page takes a sixth less of the processor so.
"""


def path() -> str | None:
    """The one of this machine, if it has one."""
    return next(filter(None, map(shutil.which, NAMES)), None)


@contextmanager
def started(*more: str) -> Iterator[sync_api.Browser]:
    """A browser with more switches, until it is left; its event loop ends with it."""
    with sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=path(), args=["--no-proxy-server", "--no-sandbox", *more]
        )
        yield browser
        browser.close()
