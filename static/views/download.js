/** Give the user a file made on the page. */

/** `content` is a text, or a data URL where it begins like one. */
export function download(name, content, type = "text/plain") {
  const url = content.startsWith("data:") ? content : URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement("a");
  Object.assign(link, { href: url, download: name });
  link.click();
  if (url !== content) setTimeout(() => URL.revokeObjectURL(url));
}
