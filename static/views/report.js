/** The report of the service on paper, in place of the page: its own style sheet holds for it alone, its pages for the print. */
const ALONE = "@media screen { .paper { display: none; } } @media print { body > :not(.paper) { display: none !important; } }";

function sheetOf(text) {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(text);
  return sheet;
}

/** `content` is the file, a blob of HTML. */
export async function printReport(content) {
  const [before, style, after] = (await content.text()).split(/<\/?style>/); // which the page's policy would not have in a document
  const report = new DOMParser().parseFromString(before + after, "text/html");
  const paper = Object.assign(document.createElement("div"), { className: "paper" });
  const root = paper.attachShadow({ mode: "open" });
  root.adoptedStyleSheets = [sheetOf(style)];
  root.append(document.adoptNode(report.querySelector(".report")));
  const pages = sheetOf(`${ALONE} ${/@page \{.*/.exec(style)[0]}`);
  document.adoptedStyleSheets.push(pages);
  document.body.append(paper);
  addEventListener("afterprint", () => {
    paper.remove();
    document.adoptedStyleSheets = document.adoptedStyleSheets.filter((sheet) => sheet !== pages);
  }, { once: true });
  globalThis.print();
}
