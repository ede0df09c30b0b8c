"""The page and the API's description below a path prefix, as a proxy shows them."""


def test_all_that_is_asked_for_is_below_the_prefix(browser, service):
    page, outside = browser.new_page(), []
    page.on(
        "response",
        lambda answer: (
            outside.append(answer.url)
            if answer.status >= 400 or "/reducers/" not in answer.url
            else None
        ),
    )
    page.goto(f"{service}/reducers/")
    page.wait_for_selector('[data-stale="false"]', state="attached")
    page.goto(f"{service}/reducers/docs")
    page.wait_for_selector(".opblock")
    page.close()
    assert outside == []
