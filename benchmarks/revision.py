"""Another revision of the program, in a folder of its own."""

import subprocess
from pathlib import Path

ROOT = Path(__file__).parent.parent


def extract(revision: str, folder: Path) -> None:
    """Write the committed files of a revision into a folder, over those that are there."""
    folder.mkdir(parents=True, exist_ok=True)
    archive = ["git", "archive", revision]
    packed = subprocess.run(archive, cwd=ROOT, stdout=subprocess.PIPE, check=True)
    subprocess.run(["tar", "-x", "-C", folder], input=packed.stdout, check=True)
