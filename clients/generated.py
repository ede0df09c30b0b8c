"""Check of clients that public generators make from the description of the API.

`make clients` makes one in Python (openapi-python-client) and one in TypeScript (openapi-typescript
and openapi-fetch), checks their types, lets both ask a running service, and compares the answers
with those of the project's own client. The package indexes of Python and of Node are needed; CI
does not run this check.
"""

import os
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

import httpx
from khv_calc import Client

from tests.running_service import running_service

PYTHON_PACKAGES = ("openapi-python-client==0.29.1", "mypy==2.4.1", "ruff==0.17.5")
NODE_PACKAGES = ("openapi-typescript@7.13.0", "openapi-fetch@0.17.0", "typescript@5.9.3")

FILES = """
content_type_overrides:
  image/vnd.dxf: application/octet-stream
  application/zip: application/octet-stream
"""
"""Types of files that openapi-python-client does not know; bytes serve for them."""

BODY = {
    "pins": 8,
    "satellite_teeth": 40,
    "ring_teeth": 42,
    "output_torque_Nm": 400.0,
    "pin_circle_radius_mm": 38.0,
    "force_exponent": 1.5,
}

PYTHON = """
import sys
from generated import Client
from generated.api.crank_planetary import contact_force
from generated.models import ContactForceRequest, ContactForceResponse, ProblemOut

def ask(pins: int) -> ContactForceResponse | ProblemOut | None:
    return contact_force.sync(client=Client(sys.argv[1]), body=ContactForceRequest(
        pins=pins, satellite_teeth=40, ring_teeth=42, output_torque_nm=400.0,
        pin_circle_radius_mm=38.0, force_exponent=1.5))

answer, refusal = ask(8), ask(0)
assert isinstance(answer, ContactForceResponse) and isinstance(refusal, ProblemOut)
print(repr(answer.peak_force_n), refusal.errors[0].code.value)
"""

TYPESCRIPT = """
import createClient from "openapi-fetch";
import type { paths } from "./api.js";

const url: string = (globalThis as any).process.argv[2];
const client = createClient<paths>({ baseUrl: url });
const ask = (pins: number) => client.POST("/api/v1/contact-force", {
  body: {
    pins, satellite_teeth: 40, ring_teeth: 42, output_torque_Nm: 400,
    pin_circle_radius_mm: 38, force_exponent: 1.5,
  },
});
const { data } = await ask(8);
const { error } = await ask(0);
if (!data || !error) throw new Error("no answer or no refusal");
console.log(data.peak_force_N, error.errors[0]?.code);
"""


def run(*command: str | Path, cwd: Path) -> str:
    """Output of a command; the program ends with the output if the command fails."""
    path = f"{cwd / 'venv/bin'}:{os.environ['PATH']}"
    done = subprocess.run(
        [*map(str, command)],
        cwd=cwd,
        env=os.environ | {"PATH": path},
        capture_output=True,
        text=True,
    )
    if done.returncode:
        sys.exit(f"{command[0]} failed:\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def python_client(url: str, folder: Path) -> str:
    """Output of the generated Python client: a number and a code of a refusal."""
    venv.create(folder / "venv", with_pip=True)
    command = folder / "venv/bin"
    run(command / "pip", "install", "--quiet", *PYTHON_PACKAGES, cwd=folder)
    (folder / "files.yaml").write_text(FILES)
    given = ("--path", "openapi.json", "--config", "files.yaml")
    generate = ("generate", *given, "--output-path", "generated")
    told = run(command / "openapi-python-client", *generate, "--meta", "none", cwd=folder)
    if "WARNING" in told or "ERROR" in told:
        sys.exit(f"openapi-python-client does not take all of the description:\n{told}")
    (folder / "ask.py").write_text(PYTHON)
    ours = ("ask.py", "generated/api", "generated/models")  # client.py never changes
    run(command / "mypy", "--follow-imports=silent", *ours, cwd=folder)
    return run(command / "python", "ask.py", url, cwd=folder)


def typescript_client(url: str, folder: Path) -> str:
    """Output of the generated TypeScript client: a number and a code of a refusal."""
    (folder / "package.json").write_text('{"type": "module", "private": true}')
    run("npm", "install", "--silent", *NODE_PACKAGES, cwd=folder)
    npx = ("npx", "--no-install")
    optional = "--default-non-nullable=false"  # a field with a default need not be given
    run(*npx, "openapi-typescript", "openapi.json", optional, "-o", "api.ts", cwd=folder)
    (folder / "ask.ts").write_text(TYPESCRIPT)
    run(*npx, "tsc", "--strict", "--module", "nodenext", "--target", "es2022", "ask.ts", cwd=folder)
    return run("node", "ask.js", url, cwd=folder)


def main() -> None:
    """Make both clients and compare their answers; end with status 1 if one is wrong."""
    with running_service() as service, Client(service.url) as client:
        expected = client.ask("contact-force", BODY)["peak_force_N"]
        description = httpx.get(f"{service.url}/openapi.json", trust_env=False).text
        for name, make in {"Python": python_client, "TypeScript": typescript_client}.items():
            with tempfile.TemporaryDirectory() as folder:
                (Path(folder) / "openapi.json").write_text(description)
                number, code = make(service.url, Path(folder)).split()
            right = float(number) == expected and code == "greater_than_equal"
            print(f"{name}: {number} N, refusal {code}: {'right' if right else 'WRONG'}")
            if not right:
                sys.exit(f"expected {expected} N")


if __name__ == "__main__":
    main()
