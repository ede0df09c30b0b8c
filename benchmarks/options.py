"""What every benchmark takes: its own numbers, and `--smallest`, the form that the tests run."""

import argparse


def options(about: str | None, **numbers: int | None) -> argparse.Namespace:
    """Arguments of a benchmark: its numbers in order, with their defaults, and `smallest`."""
    parser = argparse.ArgumentParser(description=about)
    for name, usual in numbers.items():
        parser.add_argument(name, type=int, nargs="?", default=usual)
    parser.add_argument(
        "--smallest",
        action="store_true",
        help="a run of seconds that writes no file and judges no times: does it still work?",
    )
    return parser.parse_args()
