"""Have WeasyPrint print the reports of the service: ``python -m tests.office.reports FOLDER``.

Pictures of the pages are for the eye; a report with more pages than an engineer wants, a request
for a file from outside, or a letter that no font has ends it with an error.
"""

import sys
from pathlib import Path

from app import compiled
from app.examples import EXAMPLES, REQUESTS
from app.exports.report import EXPORT, ReportRequest
from tests.inputs.children import ran

PAGES = {
    "cycloid": (("en", "uk", "ru"), 4),
    "involute": (("en",), 4),
    "opening": (("uk",), 2),
    "hertz": (("ru",), 1),
    "ovsyannikov-2019-fig-6": (("en",), 2),
    "khatetovsky-2020-wheel": (("en",), 2),
}
"""Languages of the reports of examples and requests, and largest numbers of their pages."""


def main(folder):
    """Print reports into a folder, and count their pages."""
    compiled.load()
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    examples = {each["id"]: (each["calculation"], each["input"]) for each in EXAMPLES}
    for name, (languages, most) in PAGES.items():
        calculation, body = examples.get(name) or (name, REQUESTS[name])
        for language in languages:
            asked = ReportRequest(calculation=calculation, input=body, language=language)
            file = folder / f"report_{name}_{language}.pdf"
            file.write_bytes(EXPORT.file(asked, converted=True).content)
            ran("pdftoppm", "-r", "80", "-png", file, file.with_suffix(""))
            pages = len([*folder.glob(f"{file.stem}-*.png")])
            print(f"{file.name}: {pages} pages")
            assert pages <= most, file


if __name__ == "__main__":
    main(*sys.argv[1:])
