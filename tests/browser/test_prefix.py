"""The page and the API's description below a path prefix, as a proxy shows them."""

from tests.running_service import running_service


def test_all_that_is_asked_for_is_below_the_prefix(browser):
    with running_service(root_path="/reducers") as service:
        page, outside = browser.new_page(), []
        page.on(
            "response",
            lambda answer: (
                outside.append(answer.url)
                if answer.status >= 400 or "/reducers/" not in answer.url
                else None
            ),
        )
        page.goto(f"{service.url}/reducers/")
        page.wait_for_selector('[data-stale="false"]', state="attached")
        page.goto(f"{service.url}/reducers/docs")
        page.wait_for_selector(".opblock")
        page.close()
    assert outside == []
