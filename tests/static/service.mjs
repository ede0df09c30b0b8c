/** What the service says in English, by kind and code: asked of it and taken, as the page does. */
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

import { setEnglish } from "../../static/messages/index.js";
import { englishOf } from "../../static/service_texts.js";

const ROOT = fileURLToPath(new URL("../..", import.meta.url));
const ASK = `
import asyncio, sys, httpx
from app.main import app

async def ask():
    transport = httpx.ASGITransport(app)
    async with httpx.AsyncClient(transport=transport, base_url="http://service/api/v1/") as api:
        answers = [await api.get(path) for path in sys.argv[1:]]
    print("[" + ",".join(each.raise_for_status().text for each in answers) + "]")

asyncio.run(ask())
`;
const PATHS = ["openapi.json", "examples", "materials", "calculations", "words"];

const descriptions = JSON.parse(execFileSync(`${ROOT}.venv/bin/python`, ["-c", ASK, ...PATHS], {
  cwd: ROOT, encoding: "utf8", maxBuffer: 2 ** 24,
}));
export const [openapi, examples] = descriptions;
export const english = englishOf(descriptions);
setEnglish(english);
