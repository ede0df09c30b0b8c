"""Stiff and extreme cases: actual error, stated error, and error of the papers' literal forms.

`make accuracy` writes docs/numerics.md. The cases (tests/inputs/hard_cases.py) also run with the
tests.
"""

import sys
from pathlib import Path

from benchmarks.options import options
from tests.inputs.hard_cases import Case, Row, cases, run

REPORT = Path(__file__).parent.parent / "docs" / "numerics.md"


HEAD = """\
# Stiff and extreme cases

Made by `make accuracy` (`benchmarks/stability.py`), each case against 40-digit
arithmetic. The literal form is what a paper prints, evaluated as it stands in doubles:
sampling at 361 angles (2021, eq. 11) or the arcsines of 2018, eq. (4) for the peak, C1
of 2021, eq. (2) for the contact point, R*r/(R - r) from radii with three decimals for
Hertz, eq. (12) of 2019 for the rollers, eqs. (4), (5) and (8)-(13) of 2020 by Simpson's
rule for contact line and meshing load, its eq. (33) for the shaft.
"""
TABLE = """
## {}

| case | why it is hard | our error | stated | literal form | run time, us |
|---|---|---|---|---|---|
"""


def line(row: Row) -> str:
    """Row of the table."""
    ours = "refused" if row.error is None else f"{row.error:.1e}"
    stated = "-" if row.stated is None or row.error is None else f"{row.stated:.1e}"
    return (
        f"| {row.case.name} | {row.case.reason} | {ours} | {stated} | {row.literal} | "
        f"{row.run_time_us:.0f} |\n"
    )


def main(smallest: bool) -> int:
    """Run all cases, or the first of each calculation; 1 if one exceeds its stated error."""
    areas: dict[str, list[Case]] = {}
    for case in cases():
        areas.setdefault(case.calculation, []).append(case)
    rows, report = [], HEAD
    for area, hard in areas.items():
        report += TABLE.format(area.capitalize())
        for case in hard[:1] if smallest else hard:
            rows.append(run(case))
            report += line(rows[-1])
    if smallest:
        print(report)
    else:
        REPORT.write_text(report, encoding="utf-8")
    bad = [row for row in rows if not row.good]
    for row in bad:
        print("WRONG", row)
    print(f"{len(rows) - len(bad)} of {len(rows)} cases right to their stated error")
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main(options(__doc__).smallest))
