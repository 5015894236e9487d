// Fills the table of registrations, and sorts it by the column whose head is pressed.
"use strict";

const byId = (id) => document.getElementById(id);
const { title, entries } = JSON.parse(byId("payload").textContent);
const known = (value) => value !== null && value !== undefined;
const COLUMNS = [
  { name: "pair", value: (e) => e.name, words: true },
  { name: "verdict", value: (e) => Number(e.registered) },
  { name: "confidence", value: (e) => e.confidence, text: (e) => probability(e.confidence) },
  { name: "reason", value: (e) => e.reason, words: true, text: (e) => e.reason_text },
  { name: "overlap, source", value: (e) => e.overlap_source, text: (e) => percent(e.overlap_source) },
  { name: "rmse to planes", value: (e) => e.inlier_rmse_plane, text: (e) => rounded(e.inlier_rmse_plane) },
  { name: "seconds", value: (e) => e.seconds, text: (e) => rounded(e.seconds, 3) },
];
let order = { column: COLUMNS[2], up: true }; // the doubtful ones first

function cell(column, entry) {
  const made = element("td", column.words ? { class: "words" } : {});
  if (column.name === "verdict")
    made.append(element("span", { class: `verdict ${entry.registered ? "good" : "bad"}` }, entry.registered ? "✓ registered" : "✕ not registered"));
  else if (column.name === "pair" && entry.page) made.append(element("a", { href: entry.page }, entry.name));
  else made.append(column.text ? column.text(entry) : String(column.value(entry) ?? ""));
  return made;
}

function compare(a, b) {
  const [x, y] = [a, b].map(order.column.value);
  if (!known(x) || !known(y)) return known(x) - known(y) ? known(y) - known(x) : 0; // unknown last
  const sign = typeof x === "string" ? x.localeCompare(y, "en", { numeric: true }) : x - y;
  return order.up ? sign : -sign;
}

function fill(body) {
  const shown = entries.filter((e) => !byId("only").checked || !e.registered).sort(compare);
  body.replaceChildren(...shown.map((entry) => element("tr", {},
    element("td", {}, entry.thumbnail ? element("img", { src: entry.thumbnail, alt: `The clouds of ${entry.name}, aligned`, width: 112, height: 84 }) : ""),
    ...COLUMNS.map((column) => cell(column, entry)))));
}

function start() {
  document.title = `${title} · emtr`;
  byId("title").textContent = title;
  const right = entries.filter((e) => e.registered).length;
  byId("subtitle").textContent = `${right} of ${entries.length} registered`;
  const body = element("tbody");
  const heads = COLUMNS.map((column) => {
    const button = element("button", { type: "button" }, column.name);
    const head = element("th", column.words ? { scope: "col", class: "words" } : { scope: "col" }, button);
    const mark = () => {
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", order.up ? "ascending" : "descending");
    };
    button.addEventListener("click", () => {
      order = { column, up: order.column === column ? !order.up : true };
      mark();
      fill(body);
    });
    return head;
  });
  heads[COLUMNS.indexOf(order.column)].setAttribute("aria-sort", "ascending");
  byId("only").addEventListener("change", () => fill(body));
  byId("table").append(element("table", {},
    element("thead", {}, element("tr", {}, element("th", { scope: "col" }, "picture"), ...heads)), body));
  fill(body);
}

start();
