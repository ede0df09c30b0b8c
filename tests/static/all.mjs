/** All tests of the page's modules, in one process: the service is started once for them. */
import { readdirSync } from "node:fs";

for (const file of readdirSync(new URL(".", import.meta.url))) {
  if (file.endsWith(".test.mjs")) await import(`./${file}`);
}
