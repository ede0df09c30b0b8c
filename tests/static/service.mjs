/** What the service says, by kind and code: asked of it and taken, as the page does. */
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

import { LANGUAGES, setWords, useLanguage as useTexts } from "../../static/messages/index.js";
import { namedIn } from "../../static/service_texts.js";

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
const PATHS = ["openapi.json", "examples", "materials", "calculations"];
const WORDS = Object.keys(LANGUAGES).map((language) => `words?language=${language}`);

const answers = JSON.parse(execFileSync(`${ROOT}.venv/bin/python`, ["-c", ASK, ...PATHS, ...WORDS], {
  cwd: ROOT, encoding: "utf8", maxBuffer: 2 ** 24,
}));
export const [openapi, examples] = answers;
const named = namedIn(answers);
const words = Object.fromEntries(Object.keys(LANGUAGES).map((language, i) => [language, answers[PATHS.length + i]]));
const { was, ...own } = words.en;
export const english = { ...own, ...named };
setWords(words.en, named);

/** Page and service speak a language. */
export async function useLanguage(language) {
  await useTexts(language);
  setWords(words[language], named);
}
