"""The whole OpenAPI description against the service: its examples, the edges of every limit,
random bodies good and bad, wrong methods; each answer is what the description promises.
"""

import schemathesis

from app.main import create_app

CONFIG = schemathesis.Config.from_dict(
    {
        "seed": 1,
        "generation": {"deterministic": True, "max-examples": 10, "database": "none"},
        # A description cannot say which mechanisms exist: fields that are right one by one may
        # be refused together.
        # A study takes a second, and the edges of each of its many limits would take hundreds.
        "operations": [
            {
                "include-path-regex": "/tolerance-study",
                "phases": {"coverage": {"enabled": False}},
            }
        ],
        "checks": {"positive_data_acceptance": {"expected-statuses": ["200", "422"]}},
    }
)
schema = schemathesis.openapi.from_asgi("/openapi.json", create_app(), config=CONFIG)


@schema.parametrize()
def test_the_service_does_what_its_description_says(case):
    case.call_and_validate()
