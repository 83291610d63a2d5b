// SPDX-License-Identifier: MIT Drawing levels of detail along a row of pixels: axes, the permitted
// band, exact, rendered. A point is {x, y, exact, low, high, rendered}, all numbers, possibly NaN
// or infinite; points beyond a panel are shown at its edge.

function svgNode(name, props, ...children) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(props || {})) node.setAttribute(key, value);
  return append(node, children);
}

// The distance of two levels; that of equal infinities is 0.
const levelsApart = (a, b) => (a === b ? 0 : a - b);

// A point less its exact level.
function lessExact({x, y, exact, low, high, rendered}) {
  return {
    x, y, exact: levelsApart(exact, exact), low: levelsApart(low, exact),
    high: levelsApart(high, exact), rendered: levelsApart(rendered, exact),
  };
}

// 1, 2 or 5 times a power of ten, so that a span has about `count` steps.
function niceStep(span, count) {
  const rough = span / count;
  const ten = 10 ** Math.floor(Math.log10(rough));
  return ten * [1, 2, 5, 10].find((n) => n * ten >= rough * 0.999);
}

// From the least to the largest finite number, with some room, at least `least` wide. Exact sets
// the range. The band and the renderer widen it on each side by at most the range or `reach`;
// numbers farther away are ignored.
function rangeOf(points, least, reach) {
  const finite = (keys) => points.flatMap((p) => keys.map((key) => p[key])).filter(Number.isFinite);
  const ends = (list) => list.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)],
    [Infinity, -Infinity]);
  const all = finite(["exact", "low", "high", "rendered"]);
  if (!all.length) return {low: 0, high: least};
  const exact = ends(finite(["exact"]));
  const core = exact[0] > exact[1] ? ends(all) : exact;
  const most = Math.max(reach, core[1] - core[0]);
  const [low, high] = ends(all.filter((v) => v >= core[0] - most && v <= core[1] + most));
  const wide = Math.max(least, 1e-6 * Math.max(Math.abs(low), Math.abs(high)));
  const room = Math.max((wide - (high - low)) / 2, 0.05 * (high - low));
  return {low: low - room, high: high + room};
}

// Maps pixel columns and levels to the panel: {left, top, width, height, columns, low, high}.
function panelScale(panel) {
  const {left, top, width, height, columns, low, high} = panel;
  return {
    column: width / columns,
    x: (x) => left + width * x / columns,
    y: (v) => top + height * (high - Math.min(Math.max(v, low), high)) / (high - low),
  };
}

// Runs of neighbouring columns of which `has` holds.
function runsOf(points, has) {
  const runs = [];
  points.forEach((point, i) => {
    if (!has(point)) return;
    const before = points[i - 1];
    if (runs.length && before && has(before) && before.x + 1 === point.x) runs.at(-1).push(point);
    else runs.push([point]);
  });
  return runs;
}

const at = (x, y) => x.toFixed(2) + " " + y.toFixed(2);

// The band's path; each column is as wide as its pixel.
function bandPath(points, scale) {
  const runs = runsOf(points, (p) => !Number.isNaN(p.low) && !Number.isNaN(p.high));
  const side = (run, key) => run.map((p) => [at(scale.x(p.x), scale.y(p[key])),
    at(scale.x(p.x + 1), scale.y(p[key]))]);
  return runs.map((run) => "M" + side(run, "high").flat().join("L") + "L" +
    side(run, "low").flat().reverse().join("L") + "Z").join("");
}

// A path through the pixels' centres; a single pixel is a dash.
function linePath(points, scale, key) {
  const runs = runsOf(points, (p) => !Number.isNaN(p[key]));
  return runs.map((run) => {
    const {x} = run[0];
    if (run.length === 1)
      return "M" + at(scale.x(x), scale.y(run[0][key])) + "H" + scale.x(x + 1).toFixed(2);
    return "M" + run.map((p) => at(scale.x(p.x + 0.5), scale.y(p[key]))).join("L");
  }).join("");
}

const dotSize = (scale) => Math.min(Math.max(0.3 * scale.column, 1.2), 3);

function dotsPath(points, scale, size) {
  const arc = "a" + size + " " + size + " 0 1 0 ";
  return points.map((p) => "M" + at(scale.x(p.x + 0.5) - size, scale.y(p.rendered)) +
    arc + 2 * size + " 0" + arc + -2 * size + " 0").join("");
}

// Marks for rendered numbers beyond the panel: an arrow at the edge; a cross for NaN.
function edgeMarks(points, scale, panel) {
  const bottom = panel.top + panel.height;
  return points.map(({x, rendered}) => {
    const middle = scale.x(x + 0.5);
    if (Number.isNaN(rendered))
      return "M" + at(middle - 3, bottom - 8) + "l6 6m0 -6l-6 6";
    if (rendered > panel.high) return "M" + at(middle - 4, panel.top + 6) + "h8l-4 -6z";
    if (rendered < panel.low) return "M" + at(middle - 4, bottom - 6) + "h8l-4 6z";
    return "";
  }).join("");
}

function diamondsPath(points, scale) {
  const size = Math.min(Math.max(0.6 * scale.column, 2.5), 5);
  const side = (x, y) => "l" + x * size + " " + y * size;
  return points.map((p) => "M" + at(scale.x(p.x + 0.5), scale.y(p.rendered) - size) +
    side(1, 1) + side(-1, 1) + side(-1, -1) + "z").join("");
}

// Multiples of a nice step: about `count`, and three at least.
function niceTicks(low, high, count) {
  const step = niceStep(high - low, count);
  const ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high; ++i) ticks.push(i * step);
  return ticks.length < 3 ? niceTicks(low, high, 1.5 * count) : {step, ticks};
}

// The ticks of an axis of levels with their lines.
function levelAxis(panel, scale) {
  const {step, ticks} = niceTicks(panel.low, panel.high, panel.height / 24);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return ticks.map((v) => {
    const y = Math.round(scale.y(v)) + 0.5;
    const sign = panel.signed && v > step / 2 ? "+" : "";
    const text = sign + (Math.abs(v) < step / 2 ? "0" : v.toFixed(digits)).replace("-", "\u2212");
    return [svgNode("line", {class: "grid", x1: panel.left, x2: panel.left + panel.width,
      y1: y, y2: y}),
    svgNode("text", {class: "tick", x: panel.left - 6, y: y + 3.5, "text-anchor": "end"}, text)];
  });
}

// Numbers of pixel columns, at the pixels' middles.
function columnAxis(panel, scale) {
  const step = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024].find((n) => n * scale.column >= 34) ||
    2048;
  const bottom = panel.top + panel.height;
  const ticks = [];
  for (let x = 0; x < panel.columns; x += step) {
    const place = scale.x(x + 0.5);
    ticks.push(svgNode("line", {class: "axis", x1: place, x2: place, y1: bottom, y2: bottom + 4}),
      svgNode("text", {class: "tick", x: place, y: bottom + 15, "text-anchor": "middle"}, x));
  }
  return ticks;
}

// One panel: `points` as they are plotted, `outside` those of them that leave the band, `listed`
// the columns with a listed disagreement.
function drawPanel(panel, points, outside, listed) {
  const scale = panelScale(panel);
  const bottom = panel.top + panel.height;
  const shape = (name, d) => (d ? svgNode("path", {class: name, d}) : null);
  const within = (p) => p.rendered >= panel.low && p.rendered <= panel.high;
  return [
    svgNode("text", {class: "what", x: panel.left, y: panel.top - 6}, panel.name),
    svgNode("rect", {class: "ground", x: panel.left, y: panel.top, width: panel.width,
      height: panel.height}),
    levelAxis(panel, scale), shape("band", bandPath(points, scale)),
    shape("line", linePath(points, scale, "rendered")),
    shape("dots", dotsPath(points.filter(within), scale, dotSize(scale))),
    shape("exact", linePath(points, scale, "exact")),
    shape("outside", diamondsPath(outside.filter(within), scale)),
    shape("beyond", edgeMarks(points, scale, panel)),
    shape("beyond alarm", edgeMarks(outside, scale, panel)),
    listed.map((x) => svgNode("line", {class: "listed", x1: scale.x(x + 0.5), x2: scale.x(x + 0.5),
      y1: bottom - 1, y2: bottom + 4})),
  ];
}
