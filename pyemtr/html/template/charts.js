// Small charts as SVG. All text goes in as text, never as markup.
"use strict";

const byId = (id) => document.getElementById(id);
const read = (id) => JSON.parse(byId(id).textContent);

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

function shape(name, attributes = {}, text = "") {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return made;
}

/// A number in at most `digits` significant digits, as people write it.
function rounded(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "unknown";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e7 || size < 1e-4) return value.toExponential(digits - 1).replace(/\.?0+e/, "e");
  return String(Number(value.toPrecision(Math.max(digits, Math.ceil(Math.log10(size))))));
}

/// 1, 2 or 5 times a power of ten: the largest that is not above `value`.
function roundStep(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const share = value / power;
  return (share >= 5 ? 5 : share >= 2 ? 2 : 1) * power;
}

const percent = (share) => (share === null || !Number.isFinite(share) ? "unknown" : `${rounded(100 * share, 3)} %`);

/// A probability: what is not quite sure is not rounded to certainty.
const probability = (share) => (share > 0.999 && share <= 1 ? "above 99.9 %" : percent(share));

/// An empty chart of 460 by `height`, its plot area and the maps from values to it.
function chart(height, label, xs, ys) {
  const box = { left: 46, right: 452, top: 8, bottom: height - 32 };
  const svg = shape("svg", { viewBox: `0 0 460 ${height}`, role: "img", "aria-label": label });
  const span = ([low, high]) => (high > low ? high - low : 1);
  const x = (v) => box.left + ((v - xs[0]) / span(xs)) * (box.right - box.left);
  const y = (v) => box.bottom - ((v - ys[0]) / span(ys)) * (box.bottom - box.top);
  const line = (x1, y1, x2, y2, kind) => svg.append(shape("line", { x1, y1, x2, y2, class: kind }));
  const text = (at, down, words, anchor = "middle") =>
    svg.append(shape("text", { x: at, y: down, "text-anchor": anchor }, words));
  for (const [range, write] of [
    [xs, (v, words) => text(x(v), box.bottom + 15, words)],
    [ys, (v, words) => { line(box.left, y(v), box.right, y(v), "axis"); text(box.left - 6, y(v) + 4, words, "end"); }],
  ]) {
    const step = roundStep(span(range) / 3.5);
    for (let v = Math.ceil(range[0] / step - 1e-9) * step; v <= range[1] + 1e-9 * step; v += step)
      write(v, rounded(v, Math.max(3, Math.ceil(Math.log10(Math.abs(v) / step + 1)) + 1)));
  }
  return { svg, box, x, y, line, text };
}

function histogram(values, limit, unit) {
  const bins = 40;
  const counts = new Array(bins).fill(0);
  let beyond = 0;
  for (const value of values) {
    if (value > limit) beyond += 1;
    else counts[Math.min(bins - 1, Math.floor((value / limit) * bins))] += 1;
  }
  const most = Math.max(...counts, 1);
  const c = chart(200, "Histogram of the distances", [0, limit], [0, (100 * most) / values.length]);
  counts.forEach((count, i) => {
    const [left, right] = [c.x((i * limit) / bins), c.x(((i + 1) * limit) / bins)];
    const top = c.y((100 * count) / values.length);
    c.svg.append(shape("rect", { x: left + 0.5, y: top, width: right - left - 1, height: c.box.bottom - top, class: "bar" }));
  });
  c.text((c.box.left + c.box.right) / 2, 198, `distance to the nearest target point${unit ? `, ${unit}` : ""}; height in % of the points`);
  return { svg: c.svg, beyond: beyond / values.length };
}

/// One history, with the iteration of the switch marked, if there is one.
function history(values, label, switchAt, ink) {
  const low = Math.min(...values);
  const high = Math.max(...values);
  const room = (high - low || Math.abs(high) || 1) * 0.06;
  const c = chart(170, label, [0, values.length], [low - room, high + room]);
  if (switchAt > 0 && switchAt < values.length) {
    c.line(c.x(switchAt), c.box.top, c.x(switchAt), c.box.bottom, "mark");
    c.text(c.x(switchAt) - 5, c.box.bottom - 6, "sparse", "end");
    c.text(c.x(switchAt) + 5, c.box.bottom - 6, "dense", "start");
  }
  const parts = switchAt > 0 ? [[0, switchAt], [switchAt, values.length]] : [[0, values.length]];
  for (const [from, to] of parts) {
    const points = values.slice(from, to).map((v, i) => `${c.x(from + i + 1).toFixed(1)},${c.y(v).toFixed(1)}`);
    c.svg.append(shape("polyline", { points: points.join(" "), class: "line", style: `stroke: var(${ink})` }));
  }
  c.text((c.box.left + c.box.right) / 2, 168, "iteration");
  return c.svg;
}

function bars(entries, write) {
  const most = Math.max(...entries.map(([, value]) => value), 1e-12);
  const made = element("div", { class: "bars" });
  for (const [name, value] of entries)
    made.append(element("span", {}, name), element("i", { style: `width:${(100 * value) / most}%` }), element("span", {}, write(value)));
  return made;
}

function pairs(entries) {
  const made = element("div", { class: "pairs" });
  for (const [name, value] of entries)
    made.append(element("div", {}, element("span", {}, name), element("b", {}, value)));
  return made;
}
