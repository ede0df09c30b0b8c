"""The API's documentation works under the page's policy and without another host."""

from playwright.sync_api import expect


def test_docs_show_the_endpoints_and_try_one(page, service):
    page.goto(f"{service}/docs")
    operation = page.locator("#operations-service-health")
    expect(operation).to_be_visible()
    operation.locator("button.opblock-summary-control").click()
    operation.get_by_role("button", name="Try it out").click()
    operation.get_by_role("button", name="Execute").click()
    expect(operation.locator(".live-responses-table .response-col_status").last).to_contain_text(
        "200"
    )
