"""Have LibreOffice calculate the spreadsheets of the service: its cells are the service's numbers.

The files lose all calculated values first, so that what is read is LibreOffice's own. A formula
that it does not know, or a number that is not the service's, ends it with an error.
"""

import io
import os
import shutil
import tempfile
from pathlib import Path

import openpyxl

from app import compiled
from app.examples import EXAMPLES, REQUESTS
from app.exports.xlsx import SheetRequest, write
from tests.inputs.children import ran

WHOLE = "cycloid", "involute"
"""Examples of whole reducers with teeth."""

FORMULAS = {"Worked steps": "E", "Checks": "G"}
"""Columns of formulas by their sheets."""

CLOSE = 1e-12
"""Relative difference of a number that is calculated in another order."""


def calculated(content):
    """Formulas of a spreadsheet, and its values by the service and by LibreOffice."""
    formulas = openpyxl.load_workbook(io.BytesIO(content))
    theirs = openpyxl.load_workbook(io.BytesIO(content), data_only=True)
    with tempfile.TemporaryDirectory() as folder:
        source, found = Path(folder, "formulas.xlsx"), Path(folder, "found")
        formulas.save(source)  # openpyxl writes no values of formulas
        env = os.environ | {"HOME": folder}
        ran("soffice", "--headless", "--convert-to", "xlsx", "--outdir", found, source, env=env)
        return formulas, theirs, openpyxl.load_workbook(found / source.name, data_only=True)


def check(name, calculation, body):
    """Compare all formulas of a spreadsheet."""
    content = write(SheetRequest(calculation=calculation, input=body)).content
    formulas, theirs, ours = calculated(content)
    for sheet, column in FORMULAS.items():
        if sheet not in formulas.sheetnames:
            continue
        rows = range(2, formulas[sheet].max_row + 1)
        live = [
            f"{column}{row}" for row in rows if formulas[sheet][f"{column}{row}"].data_type == "f"
        ]
        values = [(ours[sheet][cell].value, theirs[sheet][cell].value) for cell in live]
        most = max(abs(one - other) / abs(other or 1) for one, other in values)
        print(f"{name}: {len(live)} formulas of {sheet}, {most:.1e} from the service")
        assert len(live) > 4 and most <= CLOSE


def main():
    """Check a calculation of a contact and all example reducers with teeth."""
    missing = "soffice not found; on Debian: apt-get install libreoffice-calc-nogui"
    assert shutil.which("soffice"), missing
    compiled.load()
    check("hertz", "hertz", REQUESTS["hertz"])
    for each in EXAMPLES:
        if each["id"] in WHOLE:
            check(each["id"], "crank-planetary", each["input"])


if __name__ == "__main__":
    main()
