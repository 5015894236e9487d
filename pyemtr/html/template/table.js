// A table that is sorted by the column whose head is pressed.
"use strict";

const known = (value) => value !== null && value !== undefined;

/// A table of the entries that `shown` admits. A column has a name, the value that it is sorted by,
/// and perhaps its text, or what makes the content of a cell. `first` is the column that it is
/// sorted by at first, and `up` whether the least is on top then. The method fill() of what is
/// returned makes the rows again.
function sortedTable(columns, entries, { first, up = true, shown = () => true }) {
  let order = { column: first, up };
  const body = element("tbody");

  const compare = (a, b) => {
    const [x, y] = [a, b].map(order.column.value);
    if (!known(x) || !known(y)) return known(x) - known(y) ? known(y) - known(x) : 0; // unknown last
    const sign = typeof x === "string" ? x.localeCompare(y, "en", { numeric: true }) : x - y;
    return order.up ? sign : -sign;
  };
  const cell = (column, entry) => {
    const content = column.cell ? column.cell(entry) : column.text ? column.text(entry) : String(column.value(entry) ?? "");
    return element("td", column.words ? { class: "words" } : {}, content);
  };
  const fill = () => body.replaceChildren(...entries.filter(shown).sort(compare)
    .map((entry) => element("tr", {}, ...columns.map((column) => cell(column, entry)))));

  const heads = columns.map((column) => {
    if (!column.value) return element("th", { scope: "col" }, column.name);
    const button = element("button", { type: "button" }, column.name);
    const head = element("th", column.words ? { scope: "col", class: "words" } : { scope: "col" }, button);
    button.addEventListener("click", () => {
      order = { column, up: order.column === column ? !order.up : true };
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", order.up ? "ascending" : "descending");
      fill();
    });
    return head;
  });
  heads[columns.indexOf(first)].setAttribute("aria-sort", up ? "ascending" : "descending");
  const table = element("table", { class: "sorted" }, element("thead", {}, element("tr", {}, ...heads)), body);
  fill();
  return { table, fill };
}

/// The name of an entry, as a link to its page if it has one.
const linked = (entry, name) => (entry.page ? element("a", { href: entry.page }, name) : name);

const verdictOf = (good, yes, no) =>
  element("span", { class: `verdict ${good ? "good" : "bad"}` }, good ? `✓ ${yes}` : `✕ ${no}`);
