/** The mechanism as it is made: its numbers, its figure, and why a larger hole changes them. */
import { element, fill, html } from "../lib/html.js";
import { arrow, circle, label, line, paper } from "../lib/svg.js";
import { message } from "../messages/index.js";
import { createView as createLive } from "./live.js";

/** A pin in a hole larger than it needs, not to scale. */
function largerHole() {
  const [pin, e, c] = [46, 34, 16];
  const [centre, hole] = [[150, 140], [150, 140 - e]];
  const foot = (radius, from) => [from[0], from[1] + radius];
  return paper(300, 222, [
    circle(hole, pin + e + c, "hole"), circle(hole, pin + e, "touching"), circle(centre, pin, "pin"),
    line([150, 2], [150, 220], "axis"),
    arrow(hole, [hole[0] + (pin + e + c) * 0.8, hole[1] - (pin + e + c) * 0.6], "size"), label([hole[0] + 62, hole[1] - 24], "r_out"),
    arrow(centre, [centre[0] - pin * 0.8, centre[1] + pin * 0.6], "size"), label([centre[0] - 28, centre[1] + 4], "r_in"),
    circle(hole, 2.5, "dot"), circle(centre, 2.5, "dot"), label([140, (hole[1] + centre[1]) / 2 + 4], "e", { anchor: "end" }),
    line(foot(pin, centre), foot(pin + e + c, hole), "gap"), label([160, 140 + pin + c / 2 + 5], "c", { anchor: "start" }),
  ]);
}

export function createView(parts) {
  const more = element(html`<details class="more"><summary>${message("real.why")}</summary><div class="larger">
    <div class="sketch" role="img" aria-label="${message("real.largerLabel")}"></div>
    <div>${message("real.larger").map((text) => html`<p>${text}</p>`)}</div></div></details>`);
  fill(more.querySelector(".sketch"), largerHole());
  return createLive({ ...parts, more });
}
