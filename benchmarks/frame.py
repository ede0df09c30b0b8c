"""Sight of the page at once, in a real Chromium: for each example and screen whether the page
scrolls, how many words of prose stand on the first screen, and how long the longest label is; then
the processor time of a key and the bytes of a first visit.

Run by `make bench-page`. Prose is each visible sentence of five words and more that is no label,
value or heading. Limits: no scrolling, 60 words, 26 characters, 300 ms.
"""

import sys
from collections.abc import Collection, Sequence

from playwright.sync_api import Browser, Page

from app.examples import EXAMPLES
from benchmarks.load import service as running_service
from benchmarks.options import options
from tests.inputs import chromium

SCREENS = (1280, 720), (1366, 768), (1440, 900), (1920, 1080)
LANGUAGES = "en", "uk", "ru"
PROSE, LABEL, KEY_MS = 60, 26, 300
KEYS = "500", "510", "490", "505", "495"
TYPED = "load.output_torque_Nm"
TYPE = """(box, text) => {
  box.value = text;
  box.dispatchEvent(new InputEvent("input", { bubbles: true }));
}"""

# Height of the page over that of the screen, words of prose in sight, longest label in sight.
SEEN = """() => {
  const apart = "label, h1, h2, h3, button, select, option, dt, dd, th, td, summary, svg, .value, "
    + ".check-title, .check-source, .unseen, .governing b";
  const inSight = (node, start, end) => {
    const range = document.createRange();
    range.setStart(node, start);
    range.setEnd(node, end);
    const { x, y, width, height } = range.getBoundingClientRect();
    const top = document.elementFromPoint(x + width / 2, y + height / 2);
    return width > 1 && node.parentElement.contains(top);
  };
  const texts = new Map();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    if (!node.data.trim() || node.parentElement.closest(apart)) continue;
    const block = node.parentElement.closest("p, li, div, section");
    const words = [...node.data.matchAll(/\\S+/g)]
      .filter(({ 0: word, index }) => inSight(node, index, index + word.length));
    texts.set(block, [texts.get(block) ?? "", ...words].join(" "));
  }
  const sentences = [...texts.values()].flatMap((text) => text.split(/[.!?:;]\\s/))
    .map((text) => text.trim().split(/\\s+/).filter((word) => /\\p{L}/u.test(word)));
  const labels = [...document.querySelectorAll(".outline label, .inputs label, .inputs summary h2")]
    .filter((each) => each.checkVisibility())
    .map(({ innerText }) => innerText.trim().replaceAll("\\u00ad", ""));
  return {
    scrolls: document.documentElement.scrollHeight > innerHeight,
    words: sentences.filter(({ length }) => length >= 5).flat().length,
    label: Math.max(0, ...labels.map(({ length }) => length)),
  };
}"""


def open_page(page: Page, address: str, example: str = "") -> None:
    """Open the page, and an example of it, and wait for the numbers."""
    page.goto(address)
    page.wait_for_selector('#panel[data-state="fresh"] .outputs > .rest')
    if example:
        page.locator('[data-tool="new"]').click()
        page.locator(f'#start [data-example="{example}"]').click()
        page.wait_for_timeout(100)
        page.wait_for_selector('#panel[data-state="fresh"]')


def seen(page: Page, service: str, language: str, example: str) -> dict[str, float]:
    """Numbers of `SEEN` of an example in a language."""
    open_page(page, f"{service}/?calculator=crank-planetary&lang={language}", example)
    found: dict[str, float] = page.evaluate(SEEN)
    return found


def key(page: Page, service: str) -> float:
    """Processor time of a key in the torque of the cycloid example, ms."""
    open_page(page, f"{service}/?calculator=crank-planetary", "cycloid")
    page.wait_for_timeout(3000)  # what is done behind
    measured = page.context.new_cdp_session(page)
    measured.send("Performance.enable")

    def spent() -> float:
        metrics = measured.send("Performance.getMetrics")["metrics"]
        return 1e3 * float(next(each["value"] for each in metrics if each["name"] == "ProcessTime"))

    before = spent()
    for text in KEYS:
        page.locator(f'[data-path="{TYPED}"] .box').evaluate(TYPE, text)
        page.wait_for_timeout(3000)  # to wait for an element would be work for the page
    return (spent() - before) / len(KEYS)


def weight(browser: Browser, service: str) -> float:
    """Bytes that a first visit receives, kB."""
    with browser.new_context() as context:
        page, sizes = context.new_page(), list[int]()
        page.on("requestfinished", lambda one: sizes.append(one.sizes()["responseBodySize"]))
        open_page(page, f"{service}/?calculator=crank-planetary")
        page.wait_for_timeout(2000)
        return sum(sizes) / 1e3


def main(examples: Collection[str], asked_of: Sequence[int] | None = None) -> bool:
    """Measure these examples; True if a limit is exceeded."""
    missed = False
    serving = running_service("app.serve", running=asked_of)
    with serving as running, chromium.started() as browser:
        service = f"http://127.0.0.1:{running.port}"
        context = browser.new_context()
        context.add_init_script(chromium.MET)
        page = context.new_page()
        print("screen       language  scrolls  words  label")
        for width, height in SCREENS[: len(examples)]:
            page.set_viewport_size({"width": width, "height": height})
            for language in LANGUAGES if (width, height) == SCREENS[0] else LANGUAGES[:1]:
                found = [seen(page, service, language, each) for each in examples]
                scrolls = sum(each["scrolls"] for each in found)
                words, label = (max(each[name] for each in found) for name in ("words", "label"))
                missed |= bool(scrolls) or words > PROSE or label > LABEL
                print(f"{width:4} × {height:4}  {language:8}  {scrolls:7}  {words:5}  {label:5}")
        spent = key(page, service)
        missed |= spent > KEY_MS
        print(f"processor of a key {spent:.0f} ms")
        print(f"first visit {weight(browser, service):.0f} kB")
    return missed


if __name__ == "__main__":
    asked = options(__doc__, asks=True)
    whole = [each["id"] for each in EXAMPLES if each["calculation"] == "crank-planetary"]
    missed = main(whole[:1] if asked.smallest else whole, asked.service)
    sys.exit(missed and not asked.smallest)
