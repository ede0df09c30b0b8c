"""Check of the stated errors: requests as people type them, through the service, at 40 digits.

Half of the cases are practical, half extreme; the exact values are those of the decimals in the
request (tests/oracles/answers). `make accuracy` writes docs/accuracy.md: for each calculation the
share of answers all of whose numbers are as good as stated, and the largest errors. The number of
cases may be given, `python -m benchmarks.honesty 1000`, and the rows of the table to renew, `--only
pin-strength --only crankshaft`.
"""

import re
import sys
import time
from collections import Counter
from collections.abc import Collection, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from benchmarks.options import options
from tests.inputs.outcome import NOTHING_KNOWN, Outcome, outcome
from tests.oracles.answers import CALCULATIONS
from tests.oracles.answers.calculation import GIVEN, Calculation, pattern

CASES = 10_000
REPORT = Path(__file__).parent.parent / "docs" / "accuracy.md"
HEAD = """\
# Are the stated errors true?

Made by `make accuracy` (`benchmarks/honesty.py`): random requests, half of them practical, half
extreme, through the service as it is; every number of every answer against 40-digit arithmetic by
another way, on the decimals of the request and not on the doubles that they become; of pins,
bearings and crankshafts the turn is looked through at 64 bits. So the error includes what is lost
by reading the input, which nearly equal radii, angles beside a pole, dead centres or narrow working
lengths magnify. Where exact values take long there are fewer cases. A case holds where no number is
further off than its `relative_error` says, relative to what the calculation documents: its own
size, that of its vector, the largest force, the pin circle, the range shown. From 1 on it says that
nothing is known, and the answer warns of it (`hardly_known`): such cases, none of them practical,
have a column of their own. No practical case states more than the class of its method
(`core/precision.py`).

| calculation | cases | refused | nothing known | holds | practical | extreme | \
largest measured | largest stated |
|---|---|---|---|---|---|---|---|---|
"""

TAIL = """
Errors of a model are no errors of its arithmetic, and `relative_error` does not contain them. The
law of contact of a pin that wraps is a polynomial, whose approach is off by at most 1e-6; largest
pressures of `/tolerance-study` that wrap are off by at most 3e-6, those of `/load-sharing` are of
the contact itself. The stress of the wall about a pin's bore is above plane elasticity by 1.5 %
(bore 0.9 of the pin) to 37 % (0.3). Ratings of a bearing without a seat are a lower bound; makers
of track rollers state more.
"""


def chunk(calculations: Sequence[Calculation], seeds: range) -> list[list[Outcome]]:
    """Outcomes of the calculations for these seeds; cases of one seed share exact values."""
    found: list[list[Outcome]] = [[] for _ in calculations]
    for seed in seeds:
        for own, calculation in zip(found, calculations, strict=True):
            if seed // 2 % calculation.one_in == 0:  # both a practical and an extreme case
                own.append(outcome(calculation, seed))
    return found


@dataclass(frozen=True)
class Verdict:
    """Outcomes of a calculation against the errors that it states."""

    calculation: Calculation
    outcomes: list[Outcome]

    def half(self, extreme: bool) -> list[Outcome]:
        """Answered cases of the extreme or the practical half."""
        return [each for each in self.answered if each.extreme is extreme]

    @property
    def answered(self) -> list[Outcome]:
        """Cases that were not refused."""
        return [each for each in self.outcomes if not each.refused]

    @property
    def honest(self) -> bool:
        """True if every practical case is answered, every number is checked, every stated error is
        true, and none of a practical case exceeds the class of the method.
        """
        answered = not any(
            each.refused or each.stated >= NOTHING_KNOWN
            for each in self.outcomes
            if not each.extreme
        )
        true = not any(each.false or each.unknown for each in self.answered)
        kept = not any(each.beyond for each in self.half(False))
        return answered and true and kept

    def row(self) -> str:
        """Row of the table."""
        cases, halves = self.answered, (self.half(False), self.half(True))
        holds = " | ".join(map(share, (cases, *halves)))
        nothing = sum(each.stated >= NOTHING_KNOWN for each in cases)
        return (
            f"| {self.calculation.name} | {len(self.outcomes)} | {len(self.outcomes) - len(cases)} "
            f"| {nothing} | {holds} | {max(each.measured for each in cases):.1e} | "
            f"{max(each.stated for each in cases):.1e} |\n"
        )

    def faults(self) -> str:
        """False numbers, how many, by how much, with the worst request, in words."""
        wrong = Counter(pattern(place) for each in self.answered for place in each.false)
        text = ""
        for place, count in wrong.most_common():
            factor, worst = max(
                (
                    (error / stated, each)
                    for each in self.answered
                    for pointer, (stated, error) in each.false.items()
                    if pattern(pointer) == place
                ),
                key=lambda item: item[0],
            )
            practical = sum(
                any(pattern(pointer) == place for pointer in each.false)
                for each in self.half(False)
            )
            text += (
                f"FALSE {self.calculation.name} {place}: {count} numbers, {practical} practical "
                f"cases, by up to {factor:.3g}: {worst.body}\n"
            )
        for each in self.half(False):
            if each.beyond:
                text += f"BEYOND ITS CLASS {self.calculation.name}: {each.body}\n"
        unknown = set().union(*(each.unknown for each in self.answered))
        if unknown:
            text += f"NOT CHECKED {self.calculation.name}: {', '.join(sorted(unknown))}\n"
        return text


def share(outcomes: list[Outcome]) -> str:
    """Share of the cases in which all numbers are as good as stated, in words."""
    held = sum(not each.false for each in outcomes) / len(outcomes)
    return "100 %" if held == 1 else f"{100 * held:.2f} %"


def report(verdicts: list[Verdict]) -> str:
    """Text of the report: the table, and numbers for which no error is stated."""
    unbounded = {
        f"- {verdict.calculation.path}: {place[1:]}, {known}\n": None  # once each
        for verdict in verdicts
        for place, known in (verdict.calculation.unbounded or {}).items()
        if known != GIVEN
    }
    return (
        HEAD
        + "".join(verdict.row() for verdict in verdicts)
        + "\nNumbers of the answers that `relative_error` does not speak of:\n\n"
        + "".join(unbounded)
        + TAIL
    )


def renewed(verdicts: list[Verdict], text: str) -> str:
    """Report with the rows of these verdicts in place of older ones."""
    for verdict in verdicts:
        older = rf"^\| {verdict.calculation.name} \|.*\n"
        text = re.sub(older, verdict.row(), text, count=1, flags=re.MULTILINE)
    return text


def main(cases: int, only: Collection[str] | None = None, smallest: bool = False) -> int:
    """Run all calculations, or some paths, and write the report; 1 if a statement is false."""
    start, size = time.perf_counter(), max(2, min(50, cases // 4))
    calculations = [each for each in CALCULATIONS if only is None or each.path in only]
    found: list[list[Outcome]] = [[] for _ in calculations]
    tasks = [range(first, min(first + size, cases)) for first in range(0, cases, size)]
    with ProcessPoolExecutor(2) as pool:
        for outcomes in pool.map(partial(chunk, calculations), tasks):
            for own, new in zip(found, outcomes, strict=True):
                own += new
    verdicts = [Verdict(*each) for each in zip(calculations, found, strict=True)]
    if smallest:
        print(report(verdicts))
    elif only:
        older = REPORT.read_text(encoding="utf-8")
        REPORT.write_text(renewed(verdicts, older), encoding="utf-8")
    else:
        REPORT.write_text(report(verdicts), encoding="utf-8")
    print("".join(verdict.row() + verdict.faults() for verdict in verdicts))
    honest = all(verdict.honest for verdict in verdicts)
    print(f"{time.perf_counter() - start:.0f} s")
    print("honest" if honest else "NOT HONEST")
    return 0 if honest else 1


if __name__ == "__main__":
    asked = options(__doc__, rows={each.path: None for each in CALCULATIONS}, cases=CASES)
    sys.exit(main(2, ["hertz"], smallest=True) if asked.smallest else main(asked.cases, asked.only))
