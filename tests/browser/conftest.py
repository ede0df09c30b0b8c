"""The page in a real headless Chromium against a running service; every page is watched."""

import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from playwright import sync_api

from tests.browser.calculator_page import asks_results
from tests.inputs import chromium
from tests.running_service import Service

HERE = Path(__file__).parent


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if HERE in item.path.parents:
            item.add_marker(pytest.mark.browser)


@pytest.fixture(scope="session")
def service(served: Service) -> str:
    """Address of the running service."""
    return served.url


@pytest.fixture(scope="package")  # its loop ends with it, before tests that need their own
def browser() -> Iterator[sync_api.Browser]:
    if not chromium.path():
        reason = "no Chromium on this machine: the page is not tested (tests/tools.sh)"
        if os.environ.get("CI"):
            pytest.fail(reason)
        pytest.skip(reason)
    sync_api.expect.set_options(timeout=60_000)  # a busy machine is slow, not wrong
    with chromium.started(*chromium.BRIEF) as browser:
        yield browser


DESCRIPTION = [
    f"/api/v1/{name}" for name in ("openapi.json", "examples", "materials", "calculations", "words")
]


@dataclass
class Watch:
    """Requests and complaints of a page."""

    requests: list[str] = field(default_factory=list)
    later: list[str] = field(default_factory=list)  # that follow results, whenever they come
    complaints: list[str] = field(default_factory=list)

    def ask(self, request: sync_api.Request) -> None:
        """Take note of a request."""
        of_design = request.url.endswith("/api/v1/crank-planetary")
        later = of_design and not asks_results(request)
        (self.later if later else self.requests).append(request.url)

    def paths(self) -> list[str]:
        """Paths of the requests but for those that follow results, in order."""
        return [urlsplit(url).path for url in self.requests]

    def calculations(self) -> list[str]:
        """Paths of the calculations that were asked for, figures included."""
        return [
            path for path in self.paths() if path.startswith("/api/") and path not in DESCRIPTION
        ]


WATCH_SCRIPT = """
globalThis.watched = { shift: 0, violations: [] };
document.addEventListener("securitypolicyviolation", (event) => {
  watched.violations.push(`${event.violatedDirective} ${event.blockedURI}`);
});
new PerformanceObserver((list) => {
  for (const entry of list.getEntries()) {
    if (!entry.hadRecentInput) watched.shift += entry.value;
  }
}).observe({ type: "layout-shift", buffered: true });
"""


@pytest.fixture
def watch() -> Watch:
    return Watch()


# A visitor who has opened all that folds: what is folded at first is tested in test_layout.py.
UNFOLDED = """
localStorage.folds ??= JSON.stringify({ worked: true, words: true });
localStorage.outline ??= "all";
"""


@pytest.fixture
def context(browser: sync_api.Browser) -> Iterator[sync_api.BrowserContext]:
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    context.add_init_script(
        f"if (/^http/.test(location.protocol)) {{ {UNFOLDED} }}\n{chromium.MET}"
    )
    yield context
    context.close()


@pytest.fixture
def page(context: sync_api.BrowserContext, service: str, watch: Watch) -> Iterator[sync_api.Page]:
    """An empty page, watched: other hosts, console errors, broken policy fail the test at its end.

    A refused request (422) is part of what is tested and no complaint.
    """
    context.add_init_script(WATCH_SCRIPT)
    page = context.new_page()
    page.set_default_timeout(60_000)
    page.on("request", watch.ask)
    page.on("pageerror", lambda error: watch.complaints.append(f"{error} {error.stack}"))
    page.on(
        "console",
        lambda line: (
            watch.complaints.append(line.text)
            if line.type in ("error", "warning") and "status of 422" not in line.text
            else None
        ),
    )
    yield page
    foreign = [
        url
        for url in watch.requests + watch.later
        if urlsplit(url).scheme in ("http", "https") and not url.startswith(service)
    ]
    assert foreign == [], "requests to other hosts"
    assert watch.complaints == [], "errors in the console"
    assert page.evaluate("() => watched.violations") == []
