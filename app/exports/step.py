"""A whole reducer as a STEP file, by the script of `app.exports.build123d`."""

import os
import subprocess
import sys
import tempfile

from app.exports import build123d
from app.exports.build123d import SolidsRequest
from app.model import Export, File

STEP = "model/step"

MEMORY = 3 * 2**30
"""Largest memory that a script may reserve, bytes; it needs half of this."""

RUN = """
import resource, sys
resource.setrlimit(resource.RLIMIT_AS, (int(sys.argv[2]),) * 2)
exec(compile(sys.stdin.read(), "reducer.py", "exec"))
"""


def write(body: SolidsRequest) -> File:
    """STEP file of the solids of a design, made by the script of `/export/build123d` as it is.

    Needs the extra `cad` of the service; without it the answer is 501 `not_installed`.
    """
    script = build123d.write(body).content
    # A file without a name, which the script opens by its number: nothing is left if it is ended.
    with tempfile.TemporaryFile() as step:
        subprocess.run(
            [sys.executable, "-c", RUN, f"/dev/fd/{step.fileno()}", str(MEMORY)],
            input=script,
            pass_fds=[step.fileno()],
            check=True,
            stdout=subprocess.DEVNULL,
            env=os.environ | {"PYTHONPATH": os.pathsep.join(sys.path), "OPENBLAS_NUM_THREADS": "1"},
        )
        step.seek(0)
        return File("reducer.step", STEP, step.read())


EXPORT = Export(
    name="export/step",
    title="Solids of the reducer as a STEP file",
    request=SolidsRequest,
    write=write,
    media_types=(STEP,),
    extra="cad",
    module="build123d",
    instead=build123d.EXPORT.name,
)
