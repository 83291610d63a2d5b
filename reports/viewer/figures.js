// SPDX-License-Identifier: MIT
// Drawing over pixels: figures by the role of their marks, markers by kind, grid and axes. All take
// a `plot` of panes.js, which maps window coordinates (y up) to canvas pixels.

const HALO = "rgba(8, 10, 14, 0.72)";
const STROKES = {
  primitive: {color: "#6cc3ff", width: 1.25},
  region: {color: "#ffe14d", width: 1.5, fill: "rgba(255, 225, 77, 0.20)"},
  owned: {color: "#ffe14d", width: 3.5},
  edge: {color: "#ff9e3d", width: 2.25},
  clip: {color: "#ff8ad8", width: 2},
};

function tracePath(plot, mark) {
  const path = new Path2D();
  const points = mark[3];
  for (let i = 0; i < points.length; i += 2) {
    const x = plot.x(points[i]);
    const y = plot.y(points[i + 1]);
    if (i) path.lineTo(x, y);
    else path.moveTo(x, y);
  }
  if (mark[1]) path.closePath();
  return path;
}

// A line in its colour with a dark rim, so that it shows on white and on black.
function strokeRimmed(plot, path, style) {
  const {context, ratio} = plot;
  context.lineJoin = "round";
  context.strokeStyle = HALO;
  context.lineWidth = (style.width + 2) * ratio;
  context.stroke(path);
  context.strokeStyle = style.color;
  context.lineWidth = style.width * ratio;
  context.stroke(path);
}

function drawLine(plot, mark, style) {
  const path = tracePath(plot, mark);
  if (style.fill && mark[1]) {
    plot.context.fillStyle = style.fill;
    plot.context.fill(path);
  }
  strokeRimmed(plot, path, style);
}

function drawDot(plot, x, y, style) {
  const path = new Path2D();
  const size = style.size * plot.ratio;
  if (style.square) path.rect(x - size, y - size, 2 * size, 2 * size);
  else path.arc(x, y, size, 0, 2 * Math.PI);
  if (style.fill) {
    plot.context.fillStyle = style.fill;
    plot.context.fill(path);
  }
  strokeRimmed(plot, path, {color: style.color, width: style.width || 1});
}

function drawCross(plot, x, y) {
  const arm = Math.max(2 * plot.ratio, Math.min(7 * plot.ratio, plot.scale * 0.16));
  const path = new Path2D();
  path.moveTo(x - arm, y);
  path.lineTo(x + arm, y);
  path.moveTo(x, y - arm);
  path.lineTo(x, y + arm);
  strokeRimmed(plot, path, {color: "#ffffff", width: 1.75});
}

const DOTS = {
  vertex: {size: 3, color: "#ffffff", fill: "#ffffff"},
  snapped_vertex: {size: 4, color: "#6cc3ff", width: 1.75, square: true},
  owned: {size: 3.5, color: "#ffe14d", fill: "#ffe14d"},
  primitive: {size: 3, color: "#6cc3ff", fill: "#6cc3ff"},
};
DOTS["snapped-vertex"] = DOTS.snapped_vertex;

function drawMark(plot, mark) {
  const [role, , , points] = mark;
  const line = STROKES[role];
  if (line && points.length > 2) return drawLine(plot, mark, line);
  for (let i = 0; i < points.length; i += 2) {
    const x = plot.x(points[i]);
    const y = plot.y(points[i + 1]);
    if (role === "sample") drawCross(plot, x, y);
    else drawDot(plot, x, y, DOTS[role] || DOTS.primitive);
  }
}

// Small text beside a mark's first position, kept inside the plot and off other labels.
function drawLabels(plot, figure) {
  const {context, ratio} = plot;
  const taken = [];
  context.font = 11 * ratio + "px system-ui, sans-serif";
  context.textBaseline = "middle";
  context.textAlign = "left";
  for (const mark of figure) {
    if (!mark[2] || !mark[3].length) continue;
    const text = visible(mark[2]);
    const width = context.measureText(text).width + 8 * ratio;
    const height = 16 * ratio;
    let x = plot.x(mark[3][0]) + 8 * ratio;
    let y = plot.y(mark[3][1]) - 12 * ratio;
    x = Math.max(plot.left + 2, Math.min(x, plot.left + plot.width - width - 2));
    y = Math.max(plot.top + height / 2, Math.min(y, plot.top + plot.height - height / 2));
    const meets = (t) => Math.abs(t.y - y) < height && x < t.x + t.width && t.x < x + width;
    for (let tries = 0; tries < 8 && taken.some(meets); ++tries) y += height;
    taken.push({x, y, width});
    context.fillStyle = "rgba(8, 10, 14, 0.78)";
    context.fillRect(x, y - height / 2, width, height);
    context.fillStyle = "#ffffff";
    context.fillText(text, x + 4 * ratio, y + 0.5 * ratio);
  }
}

function drawFigure(plot, figure, withLabels) {
  const order = ["region", "primitive", "edge", "owned", "vertex", "snapped-vertex", "sample"];
  const rank = (mark) => order.indexOf(mark[0]);
  for (const mark of [...figure].sort((a, b) => rank(a) - rank(b))) drawMark(plot, mark);
  if (withLabels) drawLabels(plot, figure);
}

// The sides of the clip volume in the window: those of the viewport.
function drawClipVolume(plot, [x, y, width, height]) {
  const sides = new Path2D();
  sides.rect(plot.x(x), plot.y(y + height), width * plot.scale, height * plot.scale);
  plot.context.setLineDash([7 * plot.ratio, 5 * plot.ratio]);
  strokeRimmed(plot, sides, STROKES.clip);
  plot.context.setLineDash([]);
}

// The shape of a kind, centred at a place of the plot.
function drawShape(plot, x, y, size, kind, width) {
  const shape = new Path2D();
  shape.addPath(new Path2D(KINDS[kind].path),
    new DOMMatrix([size / 16, 0, 0, size / 16, x - size / 2, y - size / 2]));
  strokeRimmed(plot, shape, {color: plot.theme["k-" + kind], width});
}

// The outline of a disputed pixel with its kind's shape inside, both in the kind's colour. `style`:
// strong for the chosen one; thin in crowded pictures; bare, without the shape, if a figure is
// drawn instead.
function drawMarker(plot, x, y, kind, style) {
  const {context, ratio, scale} = plot;
  const left = plot.x(x);
  const top = plot.y(y + 1);
  context.fillStyle = context.strokeStyle = plot.theme["k-" + kind];
  if (scale < 5 * ratio) {
    context.fillRect(left, top, Math.max(scale, 2), Math.max(scale, 2));
    return;
  }
  const wide = (style.strong ? 2.5 : style.thin ? 0.75 : 1.5) * ratio;
  const box = new Path2D();
  box.rect(left + wide / 2, top + wide / 2, scale - wide, scale - wide);
  strokeRimmed(plot, box, {color: plot.theme["k-" + kind], width: wide / ratio});
  if (style.bare || scale < 11 * ratio) return;
  const size = Math.min(scale * 0.42, 64 * ratio);
  drawShape(plot, left + scale / 2, top + scale / 2, size, kind, 1.75);
}

const HALO_SIZE = 9;   // CSS pixels of a halo's radius
const HALO_APART = 14;  // and how far apart they are at least

// Rings around disputed pixels that are too small to be seen, one for several close together.
function drawHalos(plot, disagreements) {
  const taken = new Set();
  const apart = HALO_APART * plot.ratio;
  for (const d of disagreements) {
    const x = plot.x(d.x + 0.5);
    const y = plot.y(d.y + 0.5);
    const cell = Math.floor(x / apart) + "," + Math.floor(y / apart);
    if (taken.has(cell)) continue;
    taken.add(cell);
    strokeRimmed(plot, discPath(x, y, HALO_SIZE * plot.ratio),
      {color: plot.theme["k-" + d.kind], width: 1.75});
  }
}

// The vertex of a figure within `reach` pixels of a place, or null.
function vertexNear(figure, place, reach) {
  for (const [role, , label, at] of figure) {
    if (!role.endsWith("vertex")) continue;
    for (let i = 0; i < at.length; i += 2)
      if (Math.hypot(at[i] - place.x, at[i + 1] - place.y) < reach)
        return {role, label, x: at[i], y: at[i + 1]};
  }
  return null;
}

// Pixels, and the squares of 2 by 2 from which derivatives are taken.
function drawGrids(plot, columns, rows) {
  if (Layers.grid) drawGrid(plot, columns, rows, 1, "rgba(128, 132, 140, 0.38)");
  if (Layers.quads) drawGrid(plot, columns, rows, 2, plot.theme.muted);
}

function drawGrid(plot, columns, rows, step, color) {
  const {context, scale} = plot;
  if (scale * step < 6 * plot.ratio) return;
  context.fillStyle = color;
  const bottom = plot.y(0);
  const height = rows * scale;
  for (let i = 0; i <= columns; i += step) context.fillRect(plot.x(i), bottom - height, 1, height);
  for (let j = 0; j <= rows; j += step) context.fillRect(plot.x(0), plot.y(j), columns * scale, 1);
}

// Numbers of pixel columns (below) and rows (left, y up), at pixel centres, beside the visible part
// of the image.
function drawAxes(plot, columns, rows) {
  const {context, ratio, scale} = plot;
  context.fillStyle = plot.theme.muted;
  context.font = 10 * ratio + "px system-ui, sans-serif";
  const step = (least) => [1, 2, 4, 5, 8, 10, 16, 20, 32, 64, 128, 256, 512, 1024]
    .find((n) => n * scale >= least) || 2048;
  context.textAlign = "center";
  context.textBaseline = "top";
  const across = step(Math.max(20 * ratio, context.measureText(String(columns - 1)).width + 8 * ratio));
  for (let i = 0; i < columns; i += across) {
    const x = plot.x(i + 0.5);
    if (x < plot.left || x > plot.left + plot.width) continue;
    context.fillText(String(i), x, Math.min(plot.top + plot.height, plot.y(0)) + 5 * ratio);
  }
  context.textAlign = "right";
  context.textBaseline = "middle";
  const up = step(13 * ratio);
  for (let j = 0; j < rows; j += up) {
    const y = plot.y(j + 0.5);
    if (y < plot.top || y > plot.top + plot.height) continue;
    context.fillText(String(j), Math.max(plot.left, plot.x(0)) - 5 * ratio, y);
  }
}
