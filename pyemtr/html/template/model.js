// Fills the page of many scans from its payload: the scans, the edges and the models that they make.
"use strict";

const payload = read("payload");
const { scans, edges, models, unit } = payload;
const withUnit = (value, digits) => rounded(value, digits) + (unit && known(value) ? ` ${unit}` : "");
const nameOf = (i) => scans[i].name;
const pairOf = (edge) => `${nameOf(edge.source)} → ${nameOf(edge.target)}`;
for (const members of models)
  members.forEach((scan, index) => { scans[scan].place = { index, count: members.length }; });

function fillHeading() {
  document.title = `${payload.title} · emtr`;
  byId("title").textContent = payload.title;
  const placed = scans.filter((scan) => scan.placed).length;
  const taken = edges.filter((edge) => edge.taken).length;
  const whole = placed === scans.length && models.length === 1;
  byId("subtitle").textContent = [
    `${placed} of ${scans.length} scans placed in ${models.length} model${models.length === 1 ? "" : "s"}`,
    `${taken} of ${edges.length} pairs taken`, `${rounded(payload.seconds, 3)} s`,
  ].join(" · ");
  const verdict = byId("verdict");
  verdict.classList.add(whole ? "good" : "bad");
  verdict.append(whole ? "✓ All scans in one model" : placed ? "✕ Not all scans in one model" : "✕ No model");
}

/// The list of scans, those of the shown model with a box to show them. `show` is called with a
/// scan and whether it is on.
function fillScans(members, show) {
  const line = (i) => {
    const scan = scans[i];
    const parts = [];
    if (members.includes(i)) {
      const box = element("input", { type: "checkbox", id: `scan-${i}` });
      box.checked = true;
      box.addEventListener("change", () => show(i, box.checked));
      const dot = element("i", { class: "dot", style: `background: ${cssColor(colorOfScan(scan.place.index, scan.place.count))}` });
      parts.push(element("label", { for: `scan-${i}` }, box, dot, element("span", {}, scan.name)));
    } else parts.push(element("b", {}, scan.name));
    const overlap = scan.placed ? `, ${percent(scan.overlap)} of it is seen by others too` : "";
    const where = scan.placed && !members.includes(i) ? `model ${scan.model}: ` : scan.placed ? "" : "✕ left out: ";
    parts.push(element("p", { class: "faint" }, where + scan.text + overlap));
    return element("li", {}, ...parts);
  };
  const others = scans.map((_, i) => i).filter((i) => !members.includes(i));
  byId("scans").replaceChildren(...[...members, ...others].map(line));
}

function tellEdge(edge) {
  const chosen = byId("chosen");
  const sure = `probability ${probability(edge.probability)} with the loops, ${probability(edge.confidence)} alone`;
  chosen.replaceChildren(element("b", {}, linked(edge, pairOf(edge))),
    `: ${edge.taken ? "taken" : "not taken"}: ${edge.why}; ${sure}.`);
}

function fillGraph() {
  const size = 440;
  const svg = shape("svg", { viewBox: `0 0 ${size} ${size}`, role: "group", "aria-label": "The pose graph" });
  const order = [...models.flat(), ...scans.map((_, i) => i).filter((i) => !scans[i].placed)];
  const at = new Map(order.map((scan, k) => {
    const angle = (2 * Math.PI * k) / order.length - Math.PI / 2;
    return [scan, [Math.cos(angle), Math.sin(angle)]];
  }));
  const reach = size / 2 - 62;
  const place = (scan, by = reach) => at.get(scan).map((v) => size / 2 + by * v);
  for (const edge of [...edges].sort((a, b) => a.taken - b.taken)) {
    const [[x1, y1], [x2, y2]] = [place(edge.source), place(edge.target)];
    const line = shape("line", {
      x1, y1, x2, y2, tabindex: 0, role: "button", "aria-label": `${pairOf(edge)}, ${edge.taken ? "taken" : "not taken"}`,
      class: edge.taken ? "edge" : "edge refused", "stroke-width": edge.taken ? 1 + 3 * edge.probability : 1.5,
    });
    const choose = () => {
      for (const other of svg.querySelectorAll(".chosen")) other.classList.remove("chosen");
      line.classList.add("chosen");
      tellEdge(edge);
    };
    line.addEventListener("click", choose);
    line.addEventListener("keydown", (event) => { if (event.key === "Enter") choose(); });
    svg.append(line);
  }
  for (const scan of order) {
    const [x, y] = place(scan);
    const { place: own } = scans[scan];
    const fill = own ? cssColor(colorOfScan(own.index, own.count)) : "none";
    svg.append(shape("circle", { cx: x, cy: y, r: 6, style: `fill: ${fill}; stroke: var(--ink)` }));
    const [tx, ty] = place(scan, reach + 14);
    const short = nameOf(scan).length > 12 || order.length > 24 ? String(scan) : nameOf(scan);
    const anchor = Math.abs(tx - size / 2) < 20 ? "middle" : tx > size / 2 ? "start" : "end";
    svg.append(shape("text", { x: tx, y: ty + 4, "text-anchor": anchor }, short));
  }
  byId("graph").append(svg);
}

function fillEdges() {
  const angle = (edge) => (known(edge.degrees) ? `${rounded(edge.degrees, 3)}°` : "");
  const columns = [
    { name: "pair", value: pairOf, words: true, cell: (e) => linked(e, pairOf(e)) },
    { name: "taken", value: (e) => Number(e.taken), cell: (e) => verdictOf(e.taken, "taken", "not taken") },
    { name: "why", value: (e) => e.why, words: true },
    { name: "probability", value: (e) => e.probability, text: (e) => probability(e.probability) },
    { name: "confidence", value: (e) => e.confidence, text: (e) => probability(e.confidence) },
    { name: "loops", value: (e) => e.loops },
    { name: "from the model", value: (e) => e.degrees, text: angle },
    { name: "moved by", value: (e) => e.distance, text: (e) => (known(e.distance) ? withUnit(e.distance, 3) : "") },
  ];
  const { table, fill } = sortedTable(columns, edges, {
    first: columns[3], up: false, shown: (edge) => !byId("only").checked || !edge.taken,
  });
  byId("only").addEventListener("change", fill);
  byId("edges").append(table);
}

function fillPoses(members) {
  byId("poses-text").textContent = `Scan into the frame of ${nameOf(members[0])}, which is the model's: the angle of the rotation, and the translation.`;
  const angle = (m) => (Math.acos(Math.min(1, Math.max(-1, (m[0][0] + m[1][1] + m[2][2] - 1) / 2))) * 180) / Math.PI;
  const columns = [
    { name: "scan", value: (i) => nameOf(i), words: true },
    { name: "edges", value: (i) => scans[i].edges },
    { name: "rotated by", value: (i) => angle(scans[i].pose), text: (i) => `${rounded(angle(scans[i].pose), 4)}°` },
    ...["x", "y", "z"].map((axis, k) => ({ name: axis, value: (i) => scans[i].pose[k][3], text: (i) => withUnit(scans[i].pose[k][3], 5) })),
  ];
  byId("poses").replaceChildren(sortedTable(columns, members, { first: columns[0] }).table);
}

/// Shows a model; `view` is null where the browser has no WebGL.
function showModel(members, view) {
  fillScans(members, (scan, on) => view?.show(scan, on));
  fillPoses(members);
  if (view && view.members !== members) view.choose(members);
}

function makeView() {
  try {
    const view = new ModelView(byId("canvas"), payload.up, scans, models[0]);
    view.unit = unit;
    window.emtrView = view;
    return view;
  } catch (error) { // a browser without WebGL: the rest of the page is of use
    byId("no-view").hidden = false;
    byId("no-view").textContent = `The scans cannot be shown here, because this browser has no WebGL (${error.message}).`;
    return null;
  }
}

function start() {
  fillHeading();
  fillGraph();
  fillEdges();
  byId("footer").textContent = Object.entries(payload.versions).map(([name, version]) => `${name} ${version}`).join(" · ") +
    " · drawn by three.js (MIT license, in the source of this page) · nothing on this page is loaded from elsewhere";
  if (!models.length) {
    byId("no-view").hidden = false;
    byId("no-view").textContent = "No two scans were merged, so there is no model to show.";
    byId("poses-text").textContent = "No scan has a pose.";
    return fillScans([], () => {});
  }
  const view = makeView();
  byId("models").hidden = models.length < 2;
  models.forEach((members, k) => {
    const radio = element("input", { type: "radio", name: "model", id: `model-${k}` });
    radio.checked = k === 0;
    radio.addEventListener("change", () => showModel(members, view));
    byId("models").append(element("label", {}, radio, `Model ${k}, ${members.length} scans`));
  });
  showModel(models[0], view);
  byId("size").addEventListener("input", (event) => { if (view) { view.size = Number(event.target.value); view.draw(); } });
  byId("reset").addEventListener("click", () => view?.look());
  for (const [id, on] of [["all", true], ["none", false]])
    byId(id).addEventListener("click", () => {
      for (const box of byId("scans").querySelectorAll("input")) if (box.checked !== on) box.click();
    });
}

start();
