/** A request as others write it: a curl line, Python with httpx. No DOM. */

const quoted = (text) => `'${text.replaceAll("'", String.raw`'\''`)}'`;

/** A line for a shell. */
export function curlLine(url, body) {
  return `curl -s ${quoted(url)} -H 'content-type: application/json' -d ${quoted(JSON.stringify(body))}`;
}

function python(value, indent = "") {
  if (value === null) return "None";
  if (typeof value === "boolean") return value ? "True" : "False";
  if (typeof value !== "object") return JSON.stringify(value);
  const deeper = `${indent}    `;
  const [open, close] = Array.isArray(value) ? "[]" : "{}";
  const parts = Array.isArray(value)
    ? value.map((one) => python(one, deeper))
    : Object.entries(value).map(([key, one]) => `${JSON.stringify(key)}: ${python(one, deeper)}`);
  const line = `${open}${parts.join(", ")}${close}`;
  if (line.length + indent.length < 80 && !line.includes("\n")) return line;
  return `${open}\n${parts.map((part) => `${deeper}${part},\n`).join("")}${indent}${close}`;
}

/** A program: the request, and its answer as a dict. */
export function pythonCode(url, body) {
  return `import httpx

answer = httpx.post(
    ${JSON.stringify(url)},
    json=${python(body, "    ")},
)
answer.raise_for_status()
print(answer.json())
`;
}
