/** Where a design begins, one sheet: what it has to do, a reducer that is known, a paper's figure, a file or a link, or nothing. */
import { html } from "../lib/html.js";
import { message, said } from "../messages/index.js";
import { createDialog } from "./parts.js";

const way = (id, content) => html`<section data-way="${id}"><h3>${message(`start.${id}`)}</h3>${content}</section>`;

/**
 * `examples` of which the one that is `at` hand is marked; `pictureOf(input)` draws those that are whole reducers, `proposals` find others:
 * both only where the calculator has them. `on.picked(example)`, `on.cleared()`, and `on.brought(text)`, which says whether it was a design.
 */
export function openStart({ examples, at, pictureOf, proposals, on }) {
  const isWhole = ({ input }) => Boolean(pictureOf && (input.besides ?? input).requirements);
  const button = ({ id, source, input }, whole) => html`<li><button type="button" class="${whole ? "known" : "link"}" data-example="${id}" title="${message("start.source", { source })}"
    ${id === at && html`aria-current="true"`}>${whole && pictureOf(input)}<span>${said("examples", id)}</span></button></li>`;
  const known = examples.filter(isWhole);
  const dialog = createDialog({
    id: "start",
    title: message("start.title"),
    content: html`${proposals && way("need", html`<div class="of-need"></div>`)}
      ${known.length > 0 && way("known", html`<ul class="pictures">${known.map((one) => button(one, true))}</ul>`)}
      ${way("paper", html`<ul class="papers">${examples.filter((one) => !isWhole(one)).map((one) => button(one, false))}</ul>
        <div class="brought"><label class="toggle file">${message("start.file")}<input type="file" accept="application/json,.json" class="unseen"></label>
          <input class="box free-text" autocomplete="off" placeholder="${message("start.paste")}" aria-label="${message("start.paste")}">
          <button type="button" class="toggle" data-do="cleared">${message("start.empty")}</button></div>
        <p class="refused" role="alert"></p>`)}`,
  });
  dialog.querySelector(".of-need")?.append(proposals.root);

  function end(act, ...values) {
    dialog.close();
    act(...values);
  }
  function bring(text) {
    if (on.brought(text)) dialog.close();
    else dialog.querySelector(".refused").textContent = message("start.notOurs");
  }
  const [file, pasted] = dialog.querySelectorAll(".brought input");
  file.addEventListener("change", async () => bring(await file.files[0].text()));
  pasted.addEventListener("change", () => pasted.value.trim() && bring(pasted.value.trim()));
  dialog.addEventListener("click", ({ target }) => {
    const example = examples.find(({ id }) => id === target.closest("[data-example]")?.dataset.example);
    if (example) end(on.picked, example);
    else if (target.closest("[data-do=cleared]")) end(on.cleared);
  });
  dialog.addEventListener("close", () => {
    proposals?.close();
    dialog.remove();
  });
  dialog.showModal();
  return () => dialog.close();
}
