"""Actions and readings shared by the tests of every calculator's page."""

import re
from io import BytesIO
from pathlib import Path

import httpx
from playwright.sync_api import Locator, Page, Request, expect
from pypdf import PdfReader

CALCULATORS = {"crank-planetary", "rollers", "precession"}


def show(page: Page, service: str, calculator: str, **fields: str) -> None:
    """Open a calculator (with these inputs) and wait until it has computed."""
    version = {"v": "2"} if fields else {}
    page.goto(f"{service}/?{httpx.QueryParams({'calculator': calculator} | version | fields)}")
    settled(page)


def address(page: Page) -> str:
    """The page's address, which is written when typing rests."""
    page.wait_for_function("() => sessionStorage.getItem('khv-calc.address') === '[]'")
    return page.url


def reopen(page: Page) -> None:
    """Open the page's address as a stranger would."""
    link = address(page)
    page.goto("about:blank")
    page.goto(link)
    settled(page)
    assert address(page) == link


def asks_results(request: Request) -> bool:
    """True if a request asks for results; fixes are requested later by the same path."""
    body = request.post_data_json if request.url.endswith("/api/v1/crank-planetary") else None
    return "checks" in (body or {}).get("include", [])


def settled(page: Page, state: str = "fresh") -> None:
    """Wait for the results, and for what is loaded behind them."""
    expect(page.locator("#panel")).to_have_attribute("data-state", state)
    expect(page.locator("#panel .outputs > .rest")).to_be_attached()


def opened(page: Page, calculator: str) -> None:
    """Wait until a calculator's tab and its panel are there."""
    expect(page.locator(f"#tab-{calculator}")).to_have_attribute("aria-selected", "true")
    expect(page.locator(f'#panel .outputs[data-calculator="{calculator}"]')).to_be_attached()
    settled(page)


def tab(page: Page, name: str) -> Locator:
    """A tab under the drawing, by the id of its figure or section."""
    return page.locator(f'.strip [data-tab="{name}"]')


def figures_drawn(page: Page) -> None:
    """Open the tab of each figure until it is drawn, and the first again."""
    figures = page.locator(".panel > .figure")
    names = figures.evaluate_all("all => all.map((one) => one.dataset.figure)")
    for name in [*names, names[0]]:
        tab(page, name).click()
        expect(page.locator(f'[data-figure="{name}"] .main-svg').first).to_be_visible()
        expect(page.locator(f'[data-figure="{name}"]')).to_have_attribute("data-stale", "false")


def box(page: Page, path: str) -> Locator:
    return page.locator(f'[data-path="{path}"] .box')


def cell(page: Page, row: int, column: str) -> Locator:
    """A box of a list of records."""
    return page.get_by_label(f"Row {row}, {column}", exact=True)


def choose(page: Page, choice: str, option: str) -> None:
    page.locator(f'[data-choice="{choice}"] input[value="{option}"]').check(force=True)


def verdict(page: Page, position: int) -> Locator:
    """The number in a cell of the verdict."""
    return page.locator(".summary .numbers .cell").nth(position).locator(".figures")


def saved(page: Page, button: Locator) -> Path:
    """The file that a button gives."""
    with page.expect_download() as download:
        button.click()
    return Path(download.value.path())


def exported(page: Page, what: str) -> Path:
    """A file of the sheet of exports, which is closed again."""
    page.locator('[data-tool="export"]').click()
    path = saved(page, page.locator(f"#export [data-do={what}]"))
    page.keyboard.press("Escape")
    return path


def chosen(page: Page, setting: str, value: str) -> None:
    """Choose a setting and close the sheet."""
    page.get_by_role("button", name="Settings").click()
    page.locator(f"#{setting}").select_option(value)
    page.keyboard.press("Escape")


def begun(page: Page, what: str) -> None:
    """Choose something on the sheet on which designs begin, by its selector."""
    page.locator('[data-tool="new"]').click()
    page.locator(f"#start {what}").click()


def picked(page: Page, example: str) -> None:
    """Open an example by its id."""
    begun(page, f'[data-example="{example}"]')


def emptied(page: Page) -> None:
    """Open an empty form."""
    begun(page, '[data-do="cleared"]')


def open_rows(page: Page, path: str) -> None:
    """Open the grid of a list of records over the centre."""
    page.locator(f'[data-path="{path}"] .open-records').click()


def from_menu(page: Page, path: str, act: str) -> None:
    """Choose what the menu of a field offers."""
    page.locator(f'[data-path="{path}"] .size').click()
    page.get_by_role("menuitem", name=act).click()


def words_at(page: Page, path: str) -> Locator:
    return page.locator(f'[data-path="{path}"] .field-message')


def result(page: Page, name: str) -> float:
    """A number of the results with all the digits that it has for who points at it."""
    return number(
        page.locator(f'.results [data-name="{name}"] .value').get_attribute("title") or ""
    )


def number(text: str) -> float:
    return float(re.sub(r"\s", "", text).replace("\u2212", "-"))


def ask(service: str, path: str, body: dict[str, object]) -> dict[str, object]:
    """The service's own answer."""
    return httpx.post(f"{service}/api/v1{path}", json=body, trust_env=False).json()


def first_example(service: str, calculation: str) -> dict[str, object]:
    examples = httpx.get(f"{service}/api/v1/examples", trust_env=False).json()["examples"]
    return next(one for one in examples if one["calculation"] == calculation)["input"]


def fits_narrow_screens(page: Page, calculator: str) -> None:
    """No sideways scroll at 390 and 360 px, and the open tab in sight."""
    for width in (390, 360):
        page.set_viewport_size({"width": width, "height": 800})
        assert page.evaluate("() => document.documentElement.scrollWidth <= innerWidth"), width
        tab = page.locator(f"#tab-{calculator}").bounding_box()
        assert tab and tab["x"] >= 0 and tab["x"] + tab["width"] <= width


def printed(page: Page) -> PdfReader:
    """The page on paper."""
    return PdfReader(BytesIO(page.pdf(prefer_css_page_size=True)))


def text_of(pdf: PdfReader) -> str:
    """The words on paper; ligatures taken apart."""
    text = " ".join(page.extract_text() for page in pdf.pages)
    for joined, letters in {"ﬂ": "fl", "ﬁ": "fi", "ﬀ": "ff", "ﬃ": "ffi"}.items():
        text = text.replace(joined, letters)
    return re.sub(r"\s+", " ", text)


# What is the same in all languages: names of programs, files, units, keys, standards.
COMMON = re.compile(
    r"\b(KHV Calc|CSV|PNG|SVG|English|Enter|Shift|Ctrl|lbf|psi|PEEK|curl|Python|JSON|tanh-sinh"
    r"|arc(?:sin|cos|tan)|doi|ISO/TR|Johnson(?:, Contact Mechanics)?|PETG"
    r"|Shigley(?:, Mechanical Engineering Design)?"
    r"|Zaretsky|Wang, Luo, Su|KISSsoft|Roloff/Matek"
    r"|[A-Za-z]{1,3}|[A-Z]+\d\S*|\d+Cr\w+|CuS\w+|CuA\w+|CuZ\w+|CuSn\S+)\b"
)
TEXTS = """() => {
  const same = "script, style, pre, var, kbd, cite[lang=en], noscript, dialog";
  const seen = [];
  const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walk.nextNode()) {
    const holder = walk.currentNode.parentElement;
    if (!holder.closest(`${same}, option`))
      seen.push(walk.currentNode.data);
  }
  for (const each of document.querySelectorAll("[aria-label], [title]"))
    seen.push(each.getAttribute("aria-label") ?? "",
      each.matches("[data-label]") ? "" : each.getAttribute("title") ?? "");
  for (const each of document.querySelectorAll("option")) seen.push(each.textContent);
  return seen;
}"""


def foreign(page: Page) -> set[str]:
    """Texts with English words in them."""
    return {
        text.strip()
        for text in page.evaluate(TEXTS)
        if re.search(r"[A-Za-z]{4,}", COMMON.sub(" ", re.sub(r"%\{.*?\}", "", text)))
    }
