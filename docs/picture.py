"""Takes the README's picture, the page with a cycloid reducer, to `docs/page.webp`."""

import base64
from pathlib import Path

from tests.inputs import chromium
from tests.running_service import running_service

PICTURE = Path(__file__).parent / "page.webp"
SHOWN = {"x": 0, "y": 0, "width": 1280, "height": 900, "scale": 1}


def main() -> None:
    """Take the picture and say how large it is."""
    with running_service() as service, chromium.started() as browser:
        page = browser.new_page(viewport={"width": 1280, "height": 900}, locale="en-GB")
        page.goto(service.url)
        page.locator("#start [data-example=cycloid]").click()
        page.locator(".panel .js-plotly-plot").first.wait_for()
        page.wait_for_load_state("networkidle")
        taken = page.context.new_cdp_session(page).send(
            "Page.captureScreenshot", {"format": "webp", "quality": 85, "clip": SHOWN}
        )
    PICTURE.write_bytes(base64.b64decode(taken["data"]))
    print(f"{PICTURE.name}: {PICTURE.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
