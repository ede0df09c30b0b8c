"""What every benchmark takes: its own numbers, and `--smallest`, the form that the tests run."""

import argparse
from collections.abc import Collection


def options(
    about: str | None, rows: Collection[str] = (), **numbers: int | None
) -> argparse.Namespace:
    """Arguments of a benchmark: its numbers in order, with their defaults, `smallest`, and which
    of its rows only, if it can do with some.
    """
    parser = argparse.ArgumentParser(description=about)
    for name, usual in numbers.items():
        parser.add_argument(name, type=int, nargs="?", default=usual)
    parser.add_argument(
        "--smallest",
        action="store_true",
        help="a run of seconds that writes no file and judges no times: does it still work?",
    )
    if rows:
        parser.add_argument(
            "--only", choices=rows, action="append", help="a row to make anew; may be repeated"
        )
    return parser.parse_args()
