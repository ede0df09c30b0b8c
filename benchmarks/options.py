"""Arguments of every benchmark: numbers of its own, and `--smallest`, the form that tests run."""

import argparse
from collections.abc import Collection


def add_service(parser: argparse.ArgumentParser) -> None:
    """Add an option to ask a service that runs already."""
    parser.add_argument(
        "--service",
        nargs=2,
        type=int,
        metavar=("PID", "PORT"),
        help="process and port of a service that runs already: it is asked, and none is started; "
        "its settings and its number of workers are what it was started with",
    )


def options(
    about: str | None,
    rows: Collection[str] = (),
    *,
    asks: bool = False,
    **numbers: int | None,
) -> argparse.Namespace:
    """Arguments of a benchmark: its numbers in order with their defaults, `smallest`, `only` for
    some of its rows, and `service` if it asks one.
    """
    parser = argparse.ArgumentParser(description=about)
    for name, usual in numbers.items():
        parser.add_argument(name, type=int, nargs="?", default=usual)
    parser.add_argument(
        "--smallest",
        action="store_true",
        help="a run of seconds that writes no file and judges no times: does it still work?",
    )
    if asks:
        add_service(parser)
    if rows:
        parser.add_argument(
            "--only", choices=rows, action="append", help="a row to make anew; may be repeated"
        )
    return parser.parse_args()
