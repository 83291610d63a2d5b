// SPDX-License-Identifier: MIT
// Pixels drawn as their samples: a disc where a fragment was written, else a ring, in the sample's
// colour and at its place; in the difference, the shape of its kind where a sample differs.

const LEAST_DOT = 2;   // CSS pixels of radius: below, pixels are drawn whole
const NUMBERED = 7.5;  // from here on, dots hold their sample's number
const RING = 0.72;     // of a disc's size

// Radius in pixels of the image that keeps a pixel's dots apart.
function dotRadius(positions) {
  let nearest = 1;
  positions.forEach(([x, y], i) => positions.slice(0, i).forEach(([u, v]) => {
    const apart = Math.hypot(x - u, y - v);
    if (apart > 0) nearest = Math.min(nearest, apart);
  }));
  return Math.min(0.14, Math.max(0.06, 0.45 * nearest));
}

// The places of the samples of `image`, or else those of `other`.
const placesOf = (image, other) => image?.positions || other?.positions || null;

// Are pixels large enough to be drawn as samples at these places?
function samplesFit(plot, places) {
  return places !== null && dotRadius(places) * plot.scale >= LEAST_DOT * plot.ratio;
}

// Calls draw(x, y, s, plotX, plotY) for every visible sample.
function eachSample(plot, one, places, draw) {
  const left = Math.max(0, Math.floor(plot.column(plot.left)));
  const right = Math.min(one.width, Math.ceil(plot.column(plot.left + plot.width)));
  const bottom = Math.max(0, Math.floor(plot.row(plot.top + plot.height)));
  const top = Math.min(one.height, Math.ceil(plot.row(plot.top)));
  for (let y = bottom; y < top; ++y)
    for (let x = left; x < right; ++x)
      places.forEach(([u, v], s) => draw(x, y, s, plot.x(x + u), plot.y(y + v)));
}

function discPath(x, y, radius) {
  const path = new Path2D();
  path.arc(x, y, radius, 0, 2 * Math.PI);
  return path;
}

function drawNumber(plot, x, y, radius, number, color) {
  const {context, ratio} = plot;
  if (radius < NUMBERED * ratio) return;
  context.font = "600 " + Math.min(1.15 * radius, 15 * ratio) + "px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = color;
  context.fillText(String(number), x, y + 0.06 * radius);
}

// A disc or a ring, with thin lines on both sides that contrast with every background.
function drawDotOf(plot, x, y, radius, color, filled) {
  const {context, ratio, theme} = plot;
  const wide = filled ? 0 : Math.max(1.25 * ratio, radius * 0.3);
  context.lineWidth = Math.max(1, 0.9 * ratio);
  context.strokeStyle = filled ? theme.ink : theme.muted;
  if (filled) {
    context.fillStyle = color;
    context.fill(discPath(x, y, radius));
  } else {
    context.lineWidth = wide + 2 * Math.max(0.75, 0.6 * ratio);
    context.stroke(discPath(x, y, radius - wide / 2));
    context.lineWidth = wide;
    context.strokeStyle = color;
  }
  context.stroke(discPath(x, y, radius - wide / 2));
}

function drawSamples(plot, one, image, places) {
  const radius = dotRadius(places) * plot.scale;
  eachSample(plot, one, places, (x, y, s, atX, atY) => {
    const {color, filled} = sampleAt(image, x, y, s);
    const [r, g, b] = color || [128, 128, 128];
    const size = filled ? radius : RING * radius;
    drawDotOf(plot, atX, atY, size, "rgb(" + r + " " + g + " " + b + ")", filled);
    const dark = 0.3 * r + 0.59 * g + 0.11 * b < 140;
    const onDisc = dark ? "#ffffff" : "#000000";
    drawNumber(plot, atX, atY, size, s, filled ? onDisc : plot.theme.ink);
  });
}

// The disagreements that name a sample: "x,y,sample" to kind.
function listedSamples(disagreements) {
  return new Map(disagreements.filter((d) => d.sample !== undefined)
    .map((d) => [d.x + "," + d.y + "," + d.sample, d.kind]));
}

// `places` are exact's. Samples that differ but are not listed are within the permitted range.
function drawSampleDifference(plot, one, exact, rendered, places, listed) {
  const {context, theme} = plot;
  const radius = dotRadius(places) * plot.scale;
  eachSample(plot, one, places, (x, y, s, atX, atY) => {
    const before = sampleAt(exact, x, y, s);
    const listedKind = listed.get(x + "," + y + "," + s);
    const kind = listedKind || kindBetween(before, sampleAt(rendered, x, y, s));
    if (listedKind)
      return drawShape(plot, atX, atY, Math.max(2.6 * radius, 7 * plot.ratio), kind, 1.75);
    const size = before.filled || kind ? radius : RING * radius;
    context.globalAlpha = kind ? 0.75 : 0.35;
    drawDotOf(plot, atX, atY, size, kind ? theme["k-" + kind] : theme.muted,
      before.filled || kind !== "");
    context.globalAlpha = 1;
    drawNumber(plot, atX, atY, size, s, kind ? "#ffffff" : theme.ink);
  });
}
