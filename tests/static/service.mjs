/** What the service says, by kind and code: asked of it and taken, as the page does. */
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

import { CALCULATORS } from "../../static/calculators/index.js";
import { LANGUAGES, setWords, useLanguage as useTexts } from "../../static/messages/index.js";
import { namedIn } from "../../static/service_texts.js";

const ROOT = fileURLToPath(new URL("../..", import.meta.url));
const ASK = `
import asyncio, json, sys, httpx
from app.main import app

async def ask():
    transport = httpx.ASGITransport(app)
    async with httpx.AsyncClient(transport=transport, base_url="http://service/api/v1/") as api:
        answers = [await api.get(path) for path in sys.argv[1:]]
    print(json.dumps([each.raise_for_status().text for each in answers]))

asyncio.run(ask())
`;
const PAGES = [...CALCULATORS, "another", ""];
const PATHS = ["openapi.json", "examples", "materials", "calculations"];
const WORDS = Object.keys(LANGUAGES).map((language) => `words?language=${language}`);

const asked = [...PAGES.map((id) => `http://service/?calculator=${id}`), ...PATHS, ...WORDS];
const texts = JSON.parse(execFileSync(`${ROOT}.venv/bin/python`, ["-c", ASK, ...asked], { cwd: ROOT, encoding: "utf8", maxBuffer: 2 ** 24 }));
/** The page as it is served with a calculator in its address. */
export const pages = Object.fromEntries(PAGES.map((id) => [id, texts.shift()]));
const answers = texts.map((text) => JSON.parse(text));
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
