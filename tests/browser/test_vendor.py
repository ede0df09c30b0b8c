"""The vendored Plotly and its style sheet belong together."""

from pathlib import Path

VENDOR = Path(__file__).parent.parent.parent / "static" / "vendor" / "plotly"
INJECTED = """() => [...document.getElementById("plotly.js-style-global").sheet.cssRules]
  .map((rule) => rule.cssText)"""
PARSED = """(text) => {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(text);
  return [...sheet.cssRules].map((rule) => rule.cssText);
}"""


def test_the_linked_style_sheet_is_what_plotly_would_inject(browser, tmp_path):
    """The page's policy forbids the injection, so the page links the same rules as a file."""
    page = browser.new_page()
    page.goto("about:blank")
    page.add_script_tag(path=VENDOR / "plotly-basic.min.js")
    injected = page.evaluate(INJECTED)
    linked = page.evaluate(PARSED, (VENDOR / "plotly-global.css").read_text())
    page.close()
    found = tmp_path / "plotly-global.css"
    found.write_text("\n".join(injected) + "\n")
    assert linked == injected, f"put {found} into {VENDOR}"
