// Fills the page from its payload: the report of a registration, and the points to look at.
"use strict";

const payload = read("payload");
const advice = read("advice");
const { report, unit } = payload;
const alternatives = report.alternatives ?? [];
const isPose = (matrix) => matrix.flat().every((v) => v !== null);
const poses = [report.transformation, ...alternatives.map((pose) => pose.transformation)]
  .map((matrix) => (isPose(matrix) ? matrix : null));
const withUnit = (value, digits) =>
  rounded(value, digits) + (unit && value !== null && value !== undefined ? ` ${unit}` : "");
const plain = (name) => name.replaceAll("_", " ");

/// Text whose parts in backticks are code.
function worded(text, name = "p") {
  const made = element(name);
  text.split("`").forEach((part, i) => made.append(i % 2 ? element("code", {}, part) : part));
  return made;
}

function fillHeading() {
  const title = payload.title || `${report.files.source} → ${report.files.target}`;
  document.title = `${title} · emtr`;
  byId("title").textContent = title;
  const { counts } = report;
  byId("subtitle").textContent = [
    payload.title && `${report.files.source} → ${report.files.target}`,
    `${counts.points_source.toLocaleString("en")} to ${counts.points_target.toLocaleString("en")} points`,
    report.preset && `preset ${report.preset}`,
    `seed ${report.seed}`,
  ].filter(Boolean).join(" · ");
  const verdict = byId("verdict");
  verdict.classList.add(report.registered ? "good" : "bad");
  verdict.append(report.registered ? "✓ Registered" : "✕ Not registered");
  if (report.confidence !== null)
    verdict.append(element("b", {}, `confidence ${probability(report.confidence)}`));
}

function fillAnswer() {
  const reasons = byId("reasons");
  const told = advice[report.reason] ?? { meaning: [], try: [] };
  const cause = report.reason_text;
  reasons.append(element("p", { class: "lead" }, report.registered
    ? "The clouds are registered."
    : `Not registered: ${cause}.`));
  if (report.confidence !== null)
    reasons.append(element("p", {}, `The estimated probability that this pose is right is ${probability(report.confidence)}.`));
  for (const text of told.meaning) reasons.append(worded(text));
  if (report.unit_hint) reasons.append(element("p", {}, `Look at the units: ${report.unit_hint.text}`));
  if (told.try.length) {
    const actions = element("ul", {}, ...told.try.map((text) => worded(text, "li")));
    if (report.registered) reasons.append(element("details", {}, element("summary", {}, "If you know that it is wrong"), actions));
    else reasons.append(element("h3", {}, "What to try"), actions);
  }
  const { quality, symmetry } = report;
  const numbers = [
    ["overlap, source", percent(quality.overlap_source)], ["overlap, target", percent(quality.overlap_target)],
    ["rmse to points", withUnit(quality.inlier_rmse)], ["rmse to planes", withUnit(quality.inlier_rmse_plane)],
    ["evidence, points", rounded(quality.evidence)], ["score", rounded(quality.score)],
    ["gap to the next pose", rounded(quality.score_gap)], ["surface fit", rounded(quality.surface_fit)],
  ];
  if (symmetry.symmetry !== "none" && symmetry.symmetry !== "unknown")
    numbers.push(["symmetry", symmetry.symmetry + (symmetry.symmetry_order ? ` of order ${symmetry.symmetry_order}` : "")]);
  if (report.refinement?.unconstrained_directions)
    numbers.push(["unconstrained directions", String(report.refinement.unconstrained_directions)]);
  if (quality.scale_factor !== 1 && quality.scale_factor !== null)
    numbers.push(["scale factor", rounded(quality.scale_factor)]);
  for (const [name, value] of numbers)
    byId("numbers").append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
}

function matrixText(matrix) {
  if (!matrix) return "no pose is known";
  const cells = matrix.map((row) => row.map((v) => (Math.abs(v) < 1e5 ? v.toFixed(6) : v.toFixed(3))));
  const width = Math.max(...cells.flat().map((cell) => cell.length));
  return cells.map((row) => row.map((cell) => cell.padStart(width)).join(" ")).join("\n");
}

/// Degrees of the rotation between two poses, and how far apart they put the source's center.
function difference(a, b) {
  let trace = 0;
  for (let i = 0; i < 3; ++i) for (let j = 0; j < 3; ++j) trace += a[i][j] * b[i][j];
  const center = report.normalization.center_source;
  const moved = (m, i) => m[i][0] * center[0] + m[i][1] * center[1] + m[i][2] * center[2] + m[i][3];
  const angle = (Math.acos(Math.min(1, Math.max(-1, (trace - 1) / 2))) * 180) / Math.PI;
  return [angle, Math.hypot(...[0, 1, 2].map((i) => moved(a, i) - moved(b, i)))];
}

function fillPoses(choose) {
  const rows = [{ ...report.quality, transformation: report.transformation }, ...alternatives];
  byId("poses-text").textContent = alternatives.length
    ? "The answer, and the clearly different poses that were ranked behind it. Choose one to see it above."
    : "The answer. No clearly different pose was ranked.";
  const heads = ["pose", "score", "evidence", "surface fit", "violation", "rotated by", "moved by"];
  const table = element("table", {}, element("thead", {}, element("tr", {}, ...heads.map((h) => element("th", { scope: "col" }, h)))));
  const body = element("tbody");
  rows.forEach((row, i) => {
    const radio = element("input", { type: "radio", name: "pose", value: i, id: `pose-${i}` });
    radio.checked = i === 0;
    const away = i && poses[0] && poses[i] ? difference(poses[0], poses[i]) : null;
    const line = element("tr", i ? {} : { class: "chosen" },
      element("td", {}, element("label", {}, radio, i ? `alternative ${i}` : "answer")),
      ...[row.score, row.evidence, row.surface_fit, row.violation].map((v) => element("td", {}, rounded(v))),
      element("td", {}, away ? `${rounded(away[0], 3)}°` : ""),
      element("td", {}, away ? withUnit(away[1], 3) : ""));
    radio.addEventListener("change", () => {
      for (const other of body.children) other.classList.toggle("chosen", other === line);
      choose(i);
    });
    body.append(line);
  });
  table.append(body);
  byId("poses").append(table);
}

/// The distances of the shown source points under a pose.
function distances(index) {
  const entry = payload.residuals[index];
  return entry ? Array.from(unpacked(entry.values), (v) => (v / 65535) * entry.maximum) : [];
}

/// Twice the leaf of the fine clouds: what is nearer has a counterpart. Without one, the median.
function usualLimit() {
  const leaf = report.normalization.leaf_fine * report.normalization.normalization_scale;
  if (Number.isFinite(leaf) && leaf > 0) return 2 * leaf;
  const sorted = distances(0).sort((a, b) => a - b);
  return 2 * sorted[Math.floor(sorted.length / 2)] || 1;
}

function fillResiduals(index, limit) {
  const box = byId("residuals");
  box.replaceChildren();
  const values = distances(index);
  if (!values.length) return box.append(element("p", { class: "faint" }, "No pose, no residuals."));
  const sorted = [...values].sort((a, b) => a - b);
  const at = (share) => sorted[Math.floor(share * (sorted.length - 1))];
  const { svg, beyond } = histogram(values, limit, unit);
  box.append(svg, element("p", { class: "faint" },
    `${percent(beyond)} of the points are farther than ${withUnit(limit, 3)} from the target: they have no counterpart there. ` +
    `Median ${withUnit(at(0.5), 3)}, nine in ten below ${withUnit(at(0.9), 3)}. Measured at the ` +
    `${values.length.toLocaleString("en")} points that are shown, to all points of the target.`));
}

function fillConvergence() {
  const box = byId("convergence");
  const { history: past, settings, counts } = report;
  if (!past.alpha.length) return box.append(element("p", { class: "faint" }, "The evolution was not run."));
  const planned = settings.iterations;
  const switchAt = settings.sparse_to_dense ? Math.ceil(settings.switch_fraction * planned - 1e-9) : 0;
  // Alpha's fitness is a sum over points, of which the dense stage has more.
  const dense = counts.dense_source + counts.dense_target;
  const alpha = past.alpha.map((v, i) => v / (i < switchAt ? counts.sparse_source : dense));
  const beta = past.beta.map((v) => (counts.tims ? v / counts.tims : v));
  box.append(element("h3", {}, "Task alpha, poses: distance between the clouds, 0 best to 1"),
    history(alpha, "Best fitness of task alpha by iteration", switchAt, "--source"),
    element("h3", {}, "Task beta, rotations: cost of a pair of matches, in tau"),
    history(beta, "Best fitness of task beta by iteration", 0, "--target"));
  const transfer = settings.transfer
    ? `In each iteration the tasks exchange what they know with a chance of ${percent(settings.transfer_probability)}.`
    : "The tasks exchanged nothing.";
  const change = switchAt && past.alpha.length > switchAt ? ` Task alpha goes from the sparse to the dense clouds after iteration ${switchAt}.` : "";
  const ended = past.alpha.length < planned ? ` It ended after ${past.alpha.length} of ${planned} iterations.` : "";
  box.append(element("p", { class: "faint" }, transfer + change + ended));
}

function fillTables() {
  const { seconds, counts, queries, settings } = report;
  const stages = Object.entries(seconds).filter(([name, value]) => name !== "total" && value > 0);
  const time = (s) => (s >= 1 ? `${rounded(s, 3)} s` : `${rounded(1000 * s, 3)} ms`);
  byId("timings").append(bars(stages.map(([name, value]) => [plain(name), value]), time),
    element("p", { class: "faint" }, `${time(seconds.total)} for the registration, ${report.threads} threads, ${report.kernel}.`));
  const number = (value) => (Number.isInteger(value) ? value.toLocaleString("en") : rounded(value));
  byId("counts").append(pairs([...Object.entries(counts), ...Object.entries(queries).map(([k, v]) => [`queries, ${k}`, v])]
    .map(([name, value]) => [plain(name), number(value)])));
  const written = (value) => (typeof value === "boolean" ? (value ? "on" : "off") : String(value));
  const known = [["guess", report.guess], ["viewpoint of the source", report.viewpoints?.source],
    ["viewpoint of the target", report.viewpoints?.target], ["axis", report.axis],
    ["translation bounds", report.translation_bounds]].filter(([, value]) => value);
  byId("settings").append(pairs([...known.map(([name, value]) => [name, JSON.stringify(value)]),
    ...Object.entries(settings).map(([name, value]) => [name, written(value)])]));
  byId("footer").textContent = Object.entries(report.versions).map(([name, version]) => `${name} ${version}`).join(" · ") +
    " · drawn by three.js (MIT license, in the source of this page) · nothing on this page is loaded from elsewhere";
}

function fillLegend() {
  const lines = [["target", "show-target", "--target"], ["source as given", "show-before", "--before"], ["source", "show-aligned", "--source"]];
  byId("legend").replaceChildren(...lines.filter(([, box]) => byId(box).checked)
    .filter(([name]) => name !== "source" || !byId("show-error").checked)
    .map(([name, , color]) => element("span", { style: `color: var(${color})` }, name)));
}

function connect(view) {
  const usual = usualLimit();
  const limit = () => usual * 2 ** Number(byId("limit").value);
  const showLimit = () => {
    view.limit = limit();
    byId("ramp").hidden = !byId("show-error").checked;
    byId("ramp-end").textContent = withUnit(view.limit, 3);
    view.draw();
    fillResiduals(view.pose, view.limit);
  };
  byId("ramp-bar").style.background = `linear-gradient(90deg, ${RAMP.join(", ")})`;
  for (const name of ["target", "before", "aligned"])
    byId(`show-${name}`).addEventListener("change", (event) => {
      view.show(name, event.target.checked);
      fillLegend();
    });
  byId("show-error").addEventListener("change", (event) => {
    view.errors = event.target.checked;
    showLimit();
    fillLegend();
  });
  byId("size").addEventListener("input", (event) => { view.size = Number(event.target.value); view.draw(); });
  byId("limit").addEventListener("input", showLimit);
  byId("progress").addEventListener("input", (event) => view.move(Number(event.target.value)));
  byId("reset").addEventListener("click", () => view.look());
  byId("play").addEventListener("click", () => play(view));
  view.unit = unit;
  showLimit();
  fillLegend();
  return (index) => {
    view.choose(index);
    byId("matrix").textContent = matrixText(poses[index]);
    fillResiduals(index, view.limit);
  };
}

/// Moves the source from before to after, in two seconds; at once where motion is not wanted.
function play(view) {
  const handle = byId("progress");
  const set = (share) => { handle.value = share; view.move(share); };
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return set(handle.value < 1 ? 1 : 0);
  const begin = performance.now();
  const step = (now) => {
    const time = Math.min(1, (now - begin) / 2000);
    set(time * time * (3 - 2 * time));
    if (time < 1) requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

function start() {
  fillHeading();
  fillAnswer();
  fillConvergence();
  fillTables();
  byId("matrix").textContent = matrixText(poses[0]);
  byId("copy").addEventListener("click", () => {
    const range = document.createRange();
    range.selectNodeContents(byId("matrix"));
    getSelection().removeAllRanges();
    getSelection().addRange(range);
    byId("copy").textContent = document.execCommand("copy") ? "Copied" : "Selected";
  });
  let choose;
  try {
    const view = new PairView(byId("canvas"), payload, poses);
    choose = connect(view);
    window.emtrView = view;
  } catch (error) { // a browser without WebGL: the rest of the page is of use
    byId("no-view").hidden = false;
    byId("no-view").textContent = `The clouds cannot be shown here, because this browser has no WebGL (${error.message}).`;
    fillResiduals(0, usualLimit());
    choose = (index) => {
      byId("matrix").textContent = matrixText(poses[index]);
      fillResiduals(index, usualLimit());
    };
  }
  fillPoses(choose);
}

start();
