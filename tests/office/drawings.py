"""Print the DXF files of the examples with LibreCAD, each as a picture to look at.

A file that LibreCAD does not print, or a picture with little on it, ends it with an error.
"""

import io
import os
import shutil
import sys
import zipfile
from pathlib import Path

from app.examples import EXAMPLES
from app.exports.dxf import DxfRequest, write
from tests.inputs.children import ran
from tests.inputs.drawings import UNEVEN

WHOLE = "cycloid", "involute"
"""Examples of whole reducers with teeth."""

PAPER, DOTS = "420x297", 100
"""A3, mm, and dots per inch of the pictures."""

INK = 2e-3
"""Least share of a picture that is drawn on."""

BLOCK = {
    "title": "Reducer",
    "date": "2026-11-28",
    "author": "make office",
    "revision": "A",
    "link": "http://127.0.0.1:8000/?calculator=crank-planetary",
}


def inked(picture):
    """Share of the dots of a picture, PGM, that are not white."""
    *_, dots = picture.read_bytes().split(b"\n", 3)
    return sum(dot < 200 for dot in dots) / len(dots)


def main(folder):
    """Print all sheets into a folder."""
    missing = [name for name in ("librecad", "pdftoppm") if not shutil.which(name)]
    assert not missing, f"{missing} not found; on Debian: apt-get install librecad poppler-utils"
    env = os.environ | {"QT_QPA_PLATFORM": "offscreen", "XDG_RUNTIME_DIR": str(folder)}
    designs = {each["id"]: each["input"] for each in EXAMPLES if each["id"] in WHOLE}
    for name, design in (designs | {"uneven": UNEVEN}).items():
        body = DxfRequest(design=design, title_block=BLOCK, crank_angle_deg=35.0)
        here = folder / name
        with zipfile.ZipFile(io.BytesIO(write(body).content)) as bundle:
            bundle.extractall(here)
        sheets = sorted(here.glob("*.dxf"))
        printing = ["librecad", "dxf2pdf", "-a", "-p", PAPER, *map(str, sheets)]
        ran(*printing, env=env)
        for sheet in sheets:
            pdf = sheet.with_suffix(".pdf")
            for kind in ("-png", "-gray"):
                command = [
                    "pdftoppm",
                    "-r",
                    str(DOTS),
                    kind,
                    "-singlefile",
                    pdf,
                    pdf.with_suffix(""),
                ]
                ran(*command)
            share = inked(pdf.with_suffix(".pgm"))
            print(f"{pdf.with_suffix('.png')}: {share:.1%} drawn on")
            assert share > INK, sheet


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
