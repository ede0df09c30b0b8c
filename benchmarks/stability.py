"""Stiff and extreme cases: our error, the stated one, and that of the papers' literal forms.

Writes docs/numerics.md; run by `make accuracy`. The cases (tests/oracles/hard_cases.py) also run
with the tests.
"""

import sys
from pathlib import Path

from tests.oracles.hard_cases import cases, run

REPORT = Path(__file__).parent.parent / "docs" / "numerics.md"


def main() -> int:
    """Run all, write the report, and return 1 if a case is not right to its stated error."""
    rows = [run(case) for case in cases()]
    lines = [
        "# Stiff and extreme cases",
        "",
        "Made by `make accuracy` (`benchmarks/stability.py`), each case against 40-digit",
        "arithmetic. The literal form is what a paper prints, evaluated as it stands in doubles:",
        "sampling at 361 angles (2021, eq. 11) or the arcsines of 2018, eq. (4) for the peak, C1",
        "of 2021, eq. (2) for the contact point, R*r/(R - r) from radii with three decimals for",
        "Hertz, eq. (12) of 2019 for the rollers, eqs. (4), (5) and (8)-(13) of 2020 by Simpson's",
        "rule for contact line and meshing load, its eq. (33) for the shaft.",
    ]
    for calculation in dict.fromkeys(row.case.calculation for row in rows):
        lines += [
            "",
            f"## {calculation.capitalize()}",
            "",
            "| case | why it is hard | our error | stated | literal form | run time, us |",
            "|---|---|---|---|---|---|",
        ]
        for row in rows:
            if row.case.calculation == calculation:
                ours = "refused" if row.error is None else f"{row.error:.1e}"
                stated = "-" if row.stated is None or row.error is None else f"{row.stated:.1e}"
                lines.append(
                    f"| {row.case.name} | {row.case.reason} | {ours} | {stated} | {row.literal} | "
                    f"{row.run_time_us:.0f} |"
                )
    REPORT.write_text("\n".join([*lines, ""]), encoding="utf-8")
    bad = [row for row in rows if not row.good]
    for row in bad:
        print("WRONG", row)
    print(f"{len(rows) - len(bad)} of {len(rows)} cases right to their stated error")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
