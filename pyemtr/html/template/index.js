// Fills the table of registrations.
"use strict";

const { title, entries } = read("payload");
const VERDICTS = { good: "registered", bad: "not registered", error: "error" };
const COLUMNS = [
  { name: "picture", cell: (e) => (e.thumbnail ? element("img", { src: e.thumbnail, alt: `The clouds of ${e.name}, aligned`, width: 112, height: 84 }) : "") },
  { name: "pair", value: (e) => e.name, words: true, cell: (e) => linked(e, e.name) },
  { name: "verdict", value: (e) => Number(e.registered) - Number(e.reason === "error"),
    cell: (e) => verdictOf(e.registered, VERDICTS.good, e.reason === "error" ? VERDICTS.error : VERDICTS.bad) },
  { name: "confidence", value: (e) => e.confidence, text: (e) => probability(e.confidence) },
  { name: "reason", value: (e) => e.reason, words: true, text: (e) => e.reason_text ?? "" },
  { name: "overlap, source", value: (e) => e.overlap_source, text: (e) => percent(e.overlap_source) },
  { name: "rmse to planes", value: (e) => e.inlier_rmse_plane, text: (e) => rounded(e.inlier_rmse_plane) },
  { name: "seconds", value: (e) => e.seconds, text: (e) => rounded(e.seconds, 3) },
];

document.title = `${title} · emtr`;
byId("title").textContent = title;
byId("subtitle").textContent = `${entries.filter((e) => e.registered).length} of ${entries.length} registered`;
const { table, fill } = sortedTable(COLUMNS, entries, {
  first: COLUMNS[3], // the doubtful ones first
  shown: (entry) => !byId("only").checked || !entry.registered,
});
byId("only").addEventListener("change", fill);
byId("table").append(table);
